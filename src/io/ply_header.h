// What is before the numbers in a PLY file of a surface of triangles.
#pragma once

#include <fmt/format.h>

#include <string>

#include "io/layer.h"

namespace flowcert::io {

// comment: one line.
[[nodiscard]] inline std::string ply_header(const std::string& comment, std::size_t vertices, std::size_t triangles) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      comment, vertices, triangles);
}

}  // namespace flowcert::io
