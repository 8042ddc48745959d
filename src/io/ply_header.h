// PLY files of surfaces of triangles: binary, little endian, with double coordinates.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "flowcert/point_set.h"
#include "io/byte_spool.h"
#include "io/layer.h"

namespace flowcert::io {

// What is before the numbers. comment: one line.
[[nodiscard]] inline std::string ply_header(const std::string& comment, std::size_t vertices, std::size_t triangles) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      comment, vertices, triangles);
}

inline void write_ply(std::ostream& out, const std::vector<Point>& vertices,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::string& comment) {
  out << ply_header(comment, vertices.size(), triangles.size());
  ByteWriter bytes(out);
  for (const Point& point : vertices) {
    for (const double coordinate : point.coordinates()) bytes.append(coordinate);
  }
  for (const auto& triangle : triangles) {
    bytes.append(std::uint8_t{3});
    for (const std::uint32_t vertex : triangle) bytes.append(vertex);
  }
}

}  // namespace flowcert::io
