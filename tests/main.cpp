// Runs GoogleTest's tests, all or those of one source file:
//
//   PROGRAM [--file NAME.cpp] [GoogleTest's options]
//
// Guarantees: exit status 0 only where all tests that were asked for pass; 2 where there is no test of that
// file. One program a folder is linked instead of one a file, and ctest still runs, and reports, file by
// file.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace {

// GoogleTest's filter for the tests of a file; empty if there are none. Names have no ':', '*' or '?'.
std::string filter_of_file(const std::string& name) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string filter;
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& test = *suite.GetTestInfo(t);
      if (std::filesystem::path(test.file()).filename() != name) continue;
      filter += filter.empty() ? "" : ":";
      filter += std::string(suite.name()) + '.' + test.name();
    }
  }
  return filter;
}

int complain(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);  // takes its own options out
  if (argc > 1) {
    if (argc != 3 || std::string(argv[1]) != "--file") return complain("options: --file NAME.cpp, and GoogleTest's");
    if (GTEST_FLAG_GET(filter) != "*") return complain("--file and --gtest_filter exclude each other");
    const std::string filter = filter_of_file(argv[2]);
    if (filter.empty()) return complain("no test is in " + std::string(argv[2]));
    GTEST_FLAG_SET(filter, filter);
  }
  return RUN_ALL_TESTS();
}
