// See finding_file.h.
#include "fuzz/commands/finding_file.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "flowcert/point_set.h"

namespace flowcert::commands {

fuzz::Finding read_finding(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code ignored;
  if (!file || !std::filesystem::is_regular_file(path, ignored)) {
    throw InvalidInput(path.string() + ": cannot be read");
  }
  std::ostringstream content;
  content << file.rdbuf();
  try {
    return fuzz::finding_of(content.str());
  } catch (const std::invalid_argument& error) {
    throw InvalidInput(path.string() + ":" + error.what());
  }
}

}  // namespace flowcert::commands
