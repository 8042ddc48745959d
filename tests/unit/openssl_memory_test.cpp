// Where OpenSSL finds no memory, that is the machine's failure: there is no digest, and no property is violated.
#include <gtest/gtest.h>
#include <openssl/crypto.h>

#include <cstdlib>
#include <new>

#include "fuzz/properties/property.h"

namespace flowcert::openssl_memory_test {
namespace {

int left = 0;  // how many more times OpenSSL gets memory

void* take(std::size_t bytes, const char*, int) { return left-- > 0 ? std::malloc(bytes) : nullptr; }
void* take_more(void* memory, std::size_t bytes, const char*, int) {
  return left-- > 0 ? std::realloc(memory, bytes) : nullptr;
}
void give_back(void* memory, const char*, int) { std::free(memory); }

enum class Ending { kHolds, kViolated, kFailure };

Ending ending_with(int enough) {
  left = enough;
  if (CRYPTO_set_mem_functions(take, take_more, give_back) != 1) return Ending::kViolated;
  const property::Trial trial{fuzz::Input{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, property::StartChoice{}};
  try {
    const auto found = property::disagreement(*property::property_named("certificate"), trial);
    return found ? Ending::kViolated : Ending::kHolds;
  } catch (const std::bad_alloc&) {
    return Ending::kFailure;
  } catch (const property::MachineFailure&) {
    return Ending::kFailure;
  }
}

// OpenSSL keeps what it loaded, so each amount has a process of its own.
void expect_ending(int enough, Ending ending) {
  EXPECT_EXIT(std::_Exit(static_cast<int>(ending_with(enough))), testing::ExitedWithCode(static_cast<int>(ending)), "")
      << enough;
}

TEST(OpensslMemory, IsNoVerdict) {
  // OpenSSL 3.5 itself waits for ever where its first two wishes fail.
  for (int enough = 2; enough < 20; ++enough) expect_ending(enough, Ending::kFailure);
  expect_ending(1'000'000, Ending::kHolds);
}

}  // namespace
}  // namespace flowcert::openssl_memory_test
