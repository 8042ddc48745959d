// Numbers as the bytes that binary files hold.
//
// Guarantees: little endian, whatever the machine.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>

#include "io/layer.h"

namespace flowcert::io {

template <std::unsigned_integral Bits>
void append_little_endian(std::string& bytes, Bits bits) {
  for (std::size_t k = 0; k < sizeof(Bits); ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xffU);
}
inline void append_little_endian(std::string& bytes, double value) {
  append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}
template <std::signed_integral Number>
void append_little_endian(std::string& bytes, Number value) {
  append_little_endian(bytes, static_cast<std::make_unsigned_t<Number>>(value));
}

}  // namespace flowcert::io
