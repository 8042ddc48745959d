// The header of a PLY file: which elements follow, and what a row of each consists of.
//
// Guarantees: a header that is returned is one that the rest of the file can be read by: known types, counts
// that are counts, one element `vertex` with exactly one scalar property for each of x, y, z. Anything else
// throws InvalidInput with the line. Counts are as announced, and may be absurd.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/line_reader.h"

namespace flowcert::io {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

// In bytes.
[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kInt8;
  // A list is a number of type `count_type`, and as many values of type `type`.
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The bytes of a binary row; of one with lists, those of a row whose lists are all empty.
  [[nodiscard]] std::size_t smallest_row() const;
  [[nodiscard]] bool has_lists() const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  // Where the element `vertex` is among the elements, and x, y, z among its properties.
  std::size_t vertex = 0;
  std::array<std::size_t, 3> coordinates{};
};

// Leaves `lines` at the first byte after the header.
[[nodiscard]] PlyHeader read_ply_header(LineReader& lines);

}  // namespace flowcert::io
