// Every input that ever failed, and the classic traps, replayed: the fast implementation against the oracle.
//
// Guarantees: all files of fuzz/regressions/ are run; a directory that cannot be read, or a file without
// points, fails.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "fuzz/input.h"
#include "fuzz/properties/stationary_comparison.h"
#include "tests/cites.h"

namespace flowcert::property {
namespace {

// Read here, not with the library's reader: it is under test elsewhere. Hexadecimal floats need strtod.
fuzz::Input read_xyz(const std::filesystem::path& path) {
  fuzz::Input input;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string x;
    std::string y;
    std::string z;
    if (words >> x >> y >> z) {
      input.rows.push_back({std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr),
                            std::strtod(z.c_str(), nullptr)});
    }
  }
  return input;
}

std::set<std::filesystem::path> regression_files() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(FLOWCERT_REGRESSIONS)) {
    if (entry.path().extension() == ".xyz") {
      files.insert(entry.path());
    }
  }
  return files;
}

TEST(Regressions, FastAnswerIsTheOracles) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-INV-01", "FC-OUT-02");
  const auto files = regression_files();
  EXPECT_GE(files.size(), 3U);
  for (const std::filesystem::path& path : files) {
    const fuzz::Input input = read_xyz(path);
    EXPECT_FALSE(input.rows.empty()) << path;
    EXPECT_EQ(compare(input).complaint, "") << path;
  }
}

}  // namespace
}  // namespace flowcert::property
