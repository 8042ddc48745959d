// Numbers as binary point files store them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

// Of kind 'f', an IEEE float of 4 or 8 bytes, or an integer of 1, 2, 4 or 8: 'i' with a sign, 'u' without.
struct StoredType {
  char kind = 'f';
  std::size_t size = 8;

  friend bool operator==(const StoredType&, const StoredType&) = default;
};
inline constexpr StoredType kFloat = {'f', 4};

// Nothing where there is no such type.
[[nodiscard]] std::optional<StoredType> stored_type(char kind, std::uint64_t size);

// The number at `bytes`, exactly. Nothing where no double has the value, which only large 64-bit integers lack.
[[nodiscard]] std::optional<double> stored_number(const char* bytes, StoredType type, bool is_big_endian);

// Throws InvalidInput for anything but blanks and zero bytes behind the last row.
void reject_further_bytes(std::string_view bytes, std::string_view file);

}  // namespace flowcert::io
