// `new` asks the system for huge pages for all that is large, and fails as ever.
#include "cli/huge_pages.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

// What the system has noted of the pages at an address: "rd wr mr mw me ac sd hg", where hg stands for huge pages.
std::string flags_at(const void* address) {
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  bool is_here = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream words(line);
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (words >> std::hex >> begin >> dash >> end && dash == '-') is_here = begin <= wanted && wanted < end;
    if (is_here && line.starts_with("VmFlags:")) return line + " ";
  }
  return "";
}

bool is_huge(const void* address) { return flags_at(address).find(" hg ") != std::string::npos; }

struct alignas(64) Row {
  std::byte bytes[64];
};

int handled = 0;

}  // namespace

TEST(HugePages, AreAskedForOnceTheProgramHasBegun) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer allocates";
#endif
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) GTEST_SKIP() << "this system has none";
  flowcert::cli::prepare_for_huge_pages();
  const std::vector<std::byte> large(std::size_t{40} << 20);
  EXPECT_TRUE(is_huge(&large[large.size() / 2])) << flags_at(&large.front());
  const std::vector<Row> aligned(std::size_t{1} << 17);
  EXPECT_TRUE(is_huge(&aligned[aligned.size() / 2])) << flags_at(&aligned.front());
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(aligned.data()) % alignof(Row), 0U);
  // More than the heap grows by, twice.
  std::vector<std::unique_ptr<std::vector<std::byte>>> small;
  for (std::size_t i = 0; i < 80; ++i) small.push_back(std::make_unique<std::vector<std::byte>>(std::size_t{1} << 20));
  for (const auto& block : small) EXPECT_TRUE(is_huge(&(*block)[block->size() / 2])) << flags_at(block->data());
  // A thread has another heap.
  std::thread([&] { small.push_back(std::make_unique<std::vector<std::byte>>(std::size_t{3} << 20)); }).join();
  EXPECT_TRUE(is_huge(&small.back()->back())) << flags_at(small.back()->data());
}

TEST(HugePages, NewAsksTheHandlerAndThrows) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer allocates";
#endif
  const std::new_handler before = std::set_new_handler([] {
    if (++handled == 2) std::set_new_handler(nullptr);
  });
  volatile std::size_t size = SIZE_MAX / 4;
  EXPECT_THROW(::operator delete(::operator new(size)), std::bad_alloc);
  EXPECT_EQ(handled, 2);
  EXPECT_THROW(::operator delete(::operator new(size, std::align_val_t{64}), std::align_val_t{64}), std::bad_alloc);
  EXPECT_EQ(::operator new(size, std::nothrow), nullptr);
  std::set_new_handler(before);
}
