// The names of FIPS 180-4: a to h are the working variables, w is the message schedule.
#include "io/sha256.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

namespace flowcert::io {

namespace {

constexpr std::array<std::uint32_t, 64> kRounds = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

std::uint32_t word_at(const std::byte* bytes) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k) word = word << 8 | std::to_integer<std::uint32_t>(bytes[k]);
  return word;
}

}  // namespace

void Sha256::take_blocks(const std::byte* bytes, std::size_t blocks) {
  for (; blocks > 0; --blocks, bytes += kBlock) {
    std::array<std::uint32_t, 64> w;
    for (std::size_t t = 0; t < 16; ++t) w[t] = word_at(bytes + 4 * t);
    for (std::size_t t = 16; t < 64; ++t) {
      const std::uint32_t s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3;
      const std::uint32_t s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10;
      w[t] = w[t - 16] + s0 + w[t - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (std::size_t t = 0; t < 64; ++t) {
      const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
      const std::uint32_t first = h + s1 + (g ^ (e & (f ^ g))) + kRounds[t] + w[t];
      const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
      h = g, g = f, f = e, e = d + first;
      d = c, c = b, b = a, a = first + s0 + ((b & c) | (d & (b | c)));
    }
    const std::array<std::uint32_t, 8> made = {a, b, c, d, e, f, g, h};
    for (std::size_t k = 0; k < state_.size(); ++k) state_[k] += made[k];
  }
}

void Sha256::add(std::span<const std::byte> bytes) {
  const std::size_t there = size_ % kBlock;
  size_ += bytes.size();
  if (there > 0) {
    const auto front = bytes.first(std::min(bytes.size(), kBlock - there));
    std::ranges::copy(front, begun_.begin() + static_cast<std::ptrdiff_t>(there));
    if (there + front.size() < kBlock) return;
    take_blocks(begun_.data(), 1);
    bytes = bytes.subspan(front.size());
  }
  take_blocks(bytes.data(), bytes.size() / kBlock);
  std::ranges::copy(bytes.last(bytes.size() % kBlock), begun_.begin());
}

std::string Sha256::hexadecimal() {
  const std::uint64_t bits = 8 * size_;
  // A one, zeros, and the number of bits, to the end of a block.
  std::array<std::byte, kBlock + 9> padding{std::byte{0x80}};
  const std::size_t zeros = (2 * kBlock - 9 - size_ % kBlock) % kBlock;
  for (std::size_t k = 0; k < 8; ++k) padding[1 + zeros + k] = static_cast<std::byte>(bits >> (56 - 8 * k));
  add(std::span(padding).first(zeros + 9));
  return fmt::format("{:08x}", fmt::join(state_, ""));
}

}  // namespace flowcert::io
