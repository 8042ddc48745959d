// SHA-256: the examples of FIPS 180, all lengths up to five blocks, and bytes that come in parts.
#include "io/sha256.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace flowcert::sha256_test {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

std::string sha256(std::string_view text) {
  io::Sha256 digest;
  digest.add(bytes_of(text));
  return digest.hexadecimal();
}

TEST(Sha256, ExamplesOfTheStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrs"
                   "mnopqrstnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// As Python has it: hashlib.sha256("".join(hashlib.sha256(bytes(k % 251 for k in range(n))).hexdigest()
//                                          for n in range(321)).encode()).hexdigest()
TEST(Sha256, EveryLength) {
  std::string text, digests;
  for (std::size_t size = 0; size <= 320; ++size) {
    digests += sha256(text);
    text += static_cast<char>(size % 251);
  }
  EXPECT_EQ(sha256(digests), "f17509e92c13840a60e16512f1b89fa045835a0224d03744bca35e47dead08f2");
}

TEST(Sha256, BytesInParts) {
  const std::string text(200, 'x');
  for (std::size_t first = 0; first <= text.size(); ++first) {
    io::Sha256 digest;
    digest.add(bytes_of(text).first(first));
    digest.add({});
    digest.add(bytes_of(text).subspan(first));
    EXPECT_EQ(digest.hexadecimal(), sha256(text)) << first;
  }
}

}  // namespace
}  // namespace flowcert::sha256_test
