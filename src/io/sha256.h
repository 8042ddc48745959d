// SHA-256, as FIPS 180-4 has it. Debian 12 and 13 have no library of headers alone for it, and a browser has no OpenSSL.
// To load OpenSSL takes as long as this takes for 40,000 points; for three million it is 0.3 s slower.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace flowcert::io {

class Sha256 {
 public:
  void add(std::span<const std::byte> bytes);
  // The digest of all bytes so far, as 64 hexadecimal digits. Nothing can be added after it.
  [[nodiscard]] std::string hexadecimal();

 private:
  static constexpr std::size_t kBlock = 64;

  void take_blocks(const std::byte* bytes, std::size_t blocks);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::uint64_t size_ = 0;
  std::array<std::byte, kBlock> begun_{};  // size_ % kBlock bytes of it
};

}  // namespace flowcert::io
