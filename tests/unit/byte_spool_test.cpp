// Bytes that wait on disk come back in their order, and leave no file.
#include "io/byte_spool.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>

#include "io/output_file.h"

namespace flowcert::io::byte_spool_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMany = 300'000;  // more than memory keeps

TEST(ByteSpool, GivesBackWhatItTook) {
  std::string folder = (fs::temp_directory_path() / "byte_spool_test.XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  for (const std::uint32_t count : {0U, 5U, kMany}) {
    ByteSpool spool(folder);
    std::string expected;
    for (std::uint32_t k = 0; k < count; ++k) {
      spool.append(k);
      append_little_endian(expected, k);
    }
    EXPECT_EQ(spool.size(), 4 * std::uint64_t{count});
    for (int time = 0; time < 2; ++time) {
      std::ostringstream out;
      spool.copy_to(out);
      EXPECT_TRUE(out.str() == expected) << count;
    }
    EXPECT_TRUE(fs::is_empty(folder));
  }
  fs::remove_all(folder);
}

TEST(ByteSpool, SaysThatTheFolderCannotBeWritten) {
  ByteSpool spool("/nonexistent/folder");
  const auto fill = [&] {
    for (std::uint32_t k = 0; k < kMany; ++k) spool.append(k);
  };
  EXPECT_THROW(fill(), OutputError);
}

}  // namespace
}  // namespace flowcert::io::byte_spool_test
