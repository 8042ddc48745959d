// Lists of limits come in the order of the stationary points, as the page's records do.
#include <cstdint>
#include <vector>

#include "flowcert/connections.h"
#include "io/cell_faces.h"
#include "io/viewer_parts.h"

namespace flowcert::io {

namespace {

// The faces of the cells that are drawn, each once.
Json faces_field(const FlowComplex& complex, const ViewerFrame& frame, const std::vector<std::size_t>& cells) {
  std::vector<bool> is_drawn(complex.stationary().size());
  for (const std::size_t record : cells) is_drawn[record] = true;
  const CellFaces made = cell_faces(complex, is_drawn);
  std::vector<std::uint32_t> between, offsets = {0}, triangles;
  std::vector<float> vertices;
  static_assert(CellFace::kInfinity == ViewerSelection::kNone);
  for (const CellFace& face : made.faces) {
    between.insert(between.end(), face.limits.begin(), face.limits.end());
    for (const auto& triangle : face.triangles) triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    offsets.push_back(static_cast<std::uint32_t>(triangles.size() / 3));
  }
  for (const Point& corner : made.corners) frame.append(vertices, corner);
  return {{"between", viewer_blob(between)},
          {"triangle_offsets", viewer_blob(offsets)},
          {"triangles", viewer_blob(triangles)},
          {"vertices", viewer_blob(vertices)}};
}

}  // namespace

Json viewer_cells_field(const FlowComplex& complex, const ViewerFrame& frame, const ViewerSelection& selection) {
  const FlowLimits& limits = complex.limits();
  const StableVolumes& all_volumes = complex.volumes();
  std::vector<double> volumes;
  std::vector<std::uint32_t> offsets = {0}, to, orbits, families;
  std::vector<std::uint32_t> drawn;
  drawn.reserve(selection.cells.size());
  for (const std::size_t record : selection.cells) drawn.push_back(selection.place[record]);
  std::size_t list = 0;
  for (const std::size_t record : selection.records) {
    volumes.push_back(all_volumes.nearest(record));
    while (list < limits.size() && limits.record(list) < record) ++list;
    if (list < limits.size() && limits.record(list) == record) {
      for (const Connection& connection : connections_of(limits, list)) {
        static_assert(Connection::kInfinity == ViewerSelection::kNone);
        to.push_back(connection.to);
        orbits.push_back(connection.orbits);
        families.push_back(connection.families);
      }
    }
    offsets.push_back(static_cast<std::uint32_t>(to.size()));
  }
  return {{"volumes", viewer_blob(volumes)},
          {"offsets", viewer_blob(offsets)},
          {"to", viewer_blob(to)},
          {"orbits", viewer_blob(orbits)},
          {"families", viewer_blob(families)},
          {"of", selection.all_cells},
          {"drawn", viewer_blob(drawn)},
          {"faces", faces_field(complex, frame, selection.cells)},
          {"u1", viewer_surfaces_field(complex, frame, selection)}};
}

}  // namespace flowcert::io
