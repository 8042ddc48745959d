// Version, commit and CGAL's version come from CMake.
#include "flowcert/reproducibility.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "geometry/floating_point.h"
#include "io/layer.h"
#include "io/sha256.h"

namespace flowcert {

using namespace io;

Reproducibility reproducibility() {
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "gcc " __VERSION__;
#endif
  return {FLOWCERT_VERSION, FLOWCERT_COMMIT, "double filter, exact integers", compiler, FLOWCERT_CGAL_VERSION};
}

std::string coordinates_sha256(const PointSet& points) {
  const geometry::IeeeDoubles ieee;
  static_assert(std::endian::native == std::endian::little, "the digest is of little-endian doubles");
  Sha256 digest;
  for (std::size_t row = 0; row < points.row_count(); ++row) {
    const std::array<double, 3> coordinates = points.at_row(static_cast<PointId>(row)).coordinates();
    digest.add(std::as_bytes(std::span(coordinates)));
  }
  return digest.hexadecimal();
}

std::string made_by_text(const char* format, int format_version, const PointSet& points) {
  const Reproducibility made_by = reproducibility();
  const std::size_t left_out = points.left_out().size();
  return fmt::format("{} {}, by flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {}), input_sha256 {}{}", format,
                     format_version, made_by.version, made_by.commit, made_by.kernel, made_by.compiler, made_by.cgal,
                     coordinates_sha256(points), left_out > 0 ? fmt::format(", rows left out: {}", left_out) : "");
}

}  // namespace flowcert
