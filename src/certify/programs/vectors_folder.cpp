#include "certify/programs/vectors_folder.h"

#include <filesystem>
#include <system_error>

namespace flowcert::certify {

std::string usual_vectors_folder() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / FLOWCERT_INSTALLED_VECTORS;
  return fs::is_directory(installed, ignored) ? installed.string() : FLOWCERT_SOURCE_VECTORS;
}

}  // namespace flowcert::certify
