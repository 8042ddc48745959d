#include "io/stored_number.h"

#include <algorithm>
#include <bit>

#include "io/line_reader.h"

namespace flowcert::io {

std::optional<StoredType> stored_type(char kind, std::uint64_t size) {
  const bool is_small = size == 1 || size == 2;
  if ((kind != 'f' && kind != 'i' && kind != 'u') || (size != 4 && size != 8 && !is_small)) return std::nullopt;
  if (kind == 'f' && is_small) return std::nullopt;
  return StoredType{kind, static_cast<std::size_t>(size)};
}

std::optional<double> stored_number(const char* bytes, StoredType type, bool is_big_endian) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < type.size; ++k) {
    const std::size_t place = is_big_endian ? type.size - 1 - k : k;
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * place);
  }
  if (type == kFloat) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (type.kind == 'f') return std::bit_cast<double>(bits);
  const bool is_negative = type.kind == 'i' && (bits >> (8 * type.size - 1)) != 0;
  const std::size_t unused = 64 - 8 * type.size;
  const std::uint64_t magnitude = is_negative ? (0 - bits) << unused >> unused : bits;
  const auto value = static_cast<double>(magnitude);
  if (value >= 0x1p64 || static_cast<std::uint64_t>(value) != magnitude) return std::nullopt;
  return is_negative ? -value : value;
}

void reject_further_bytes(std::string_view bytes, std::string_view file) {
  const auto is_padding = [](char c) { return c == '\0' || is_blank(c); };
  if (!std::ranges::all_of(bytes, is_padding)) reject_file(file, "there are more bytes than rows announced");
}

}  // namespace flowcert::io
