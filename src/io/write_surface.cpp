// See write_surface.h. Our own writers: CGAL's are templates over its own meshes, which this layer does not
// have.
#include "io/write_surface.h"

#include <fmt/format.h>

#include "io/little_endian.h"

namespace flowcert::io {

void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment) {
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      comment, mesh.vertices.size(), mesh.triangles.size());
  std::string bytes;
  for (const Point& point : mesh.vertices) {
    for (const double coordinate : {point.x, point.y, point.z}) append_little_endian(bytes, coordinate);
  }
  for (const auto& triangle : mesh.triangles) {
    append_little_endian(bytes, std::uint8_t{3});
    for (const std::uint32_t vertex : triangle) append_little_endian(bytes, vertex);
  }
  out << bytes;
}

void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment) {
  out << fmt::format("OFF\n# {}\n{} {} 0\n", comment, mesh.vertices.size(), mesh.triangles.size());
  for (const Point& point : mesh.vertices) out << fmt::format("{} {} {}\n", point.x, point.y, point.z);
  for (const auto& [a, b, c] : mesh.triangles) out << fmt::format("3 {} {} {}\n", a, b, c);
}

}  // namespace flowcert::io
