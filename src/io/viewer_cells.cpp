// Lists of limits come in the order of the stationary points, as the page's records do.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "flowcert/connections.h"
#include "flowcert/unstable_surfaces.h"
#include "geometry/parallel_for.h"
#include "geometry/rational_point.h"
#include "io/cell_faces.h"
#include "io/clip_box.h"
#include "io/viewer_parts.h"

namespace flowcert::io {

// ---- Unstable sets ----

namespace {

using Kind = RoundedUnstableSurface::Kind;
using FloatPosition = std::array<float, 3>;

// One set, in floats of the frame. Positions that are equal there are one vertex.
struct DrawnSurface {
  std::vector<FloatPosition> vertices;
  std::vector<std::vector<std::uint32_t>> sheets, lines;
};

// A coordinate in the frame's box does not overflow.
float nearest_float(const Rational& x) { return static_cast<float>(nearest_double(x).value()); }

class SurfaceDrawer {
 public:
  explicit SurfaceDrawer(const ViewerFrame& frame) : frame_(frame) {}

  [[nodiscard]] DrawnSurface drawn(const RoundedUnstableSurface& surface) const {
    DrawnSurface drawn;
    std::map<FloatPosition, std::uint32_t> numbers;
    for (const RoundedUnstableSurface::Part& part : surface.parts) {
      if (part.kind == Kind::kTrace) continue;  // where sheets meet, or an end of a line
      std::vector<std::uint32_t> corners;
      for (const FloatPosition& at : cut(surface, part)) {
        const auto [found, is_new] = numbers.try_emplace(at, static_cast<std::uint32_t>(drawn.vertices.size()));
        if (is_new) drawn.vertices.push_back(at);
        if (corners.empty() || corners.back() != found->second) corners.push_back(found->second);
      }
      const bool is_sheet = part.kind == Kind::kSheet;
      if (corners.size() >= (is_sheet ? 3 : 2)) (is_sheet ? drawn.sheets : drawn.lines).push_back(std::move(corners));
    }
    return drawn;
  }

 private:
  // What the frame's box has of it.
  [[nodiscard]] std::vector<FloatPosition> cut(const RoundedUnstableSurface& surface,
                                               const RoundedUnstableSurface::Part& part) const {
    std::vector<ProjectiveCorner> corners;
    for (const std::uint32_t number : part.corners) {
      const RoundedUnstableSurface::Corner& corner = surface.corners[number];
      if (corner.at_infinity) {
        corners.push_back(corner_at_infinity(geometry::exact_position(corner.position), number));
        continue;
      }
      const auto [x, y, z] = frame_.placed(corner.position);
      corners.push_back(finite_corner({Rational(x), Rational(y), Rational(z)}, number));
    }
    const Outline outline = part.kind == Kind::kSheet ? Outline::kClosed : Outline::kOpen;
    std::vector<FloatPosition> positions;
    for (const ProjectiveCorner& corner : clipped(std::move(corners), outline, sides_)) {
      positions.push_back({nearest_float(corner.x[0]), nearest_float(corner.x[1]), nearest_float(corner.x[2])});
    }
    return positions;
  }

  const ViewerFrame& frame_;
  static constexpr double kClip = ViewerFrame::kClip;
  std::vector<HalfSpace> sides_ = half_spaces({-kClip, -kClip, -kClip}, {kClip, kClip, kClip});
};

// By place in the list of sets.
std::vector<std::size_t> sets_of(const UnstableSurfaces& surfaces, const std::vector<std::size_t>& records) {
  std::vector<std::size_t> sets;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (std::ranges::binary_search(records, surfaces.record(i))) sets.push_back(i);
  }
  return sets;
}

}  // namespace

Json viewer_surfaces_field(const FlowComplex& complex, const ViewerFrame& frame, const ViewerSelection& selection) {
  const UnstableSurfaces surfaces(complex.diagram(), complex.stationary());
  const std::vector<std::size_t> sets = sets_of(surfaces, selection.surfaces);
  const SurfaceDrawer drawer(frame);
  std::vector<DrawnSurface> drawn(sets.size());
  geometry::parallel_for(sets.size(), complex.threads(),
                         [&](std::size_t k) { drawn[k] = drawer.drawn(surfaces.rounded_set(sets[k])); });
  std::vector<std::uint32_t> records, sheet_offsets = {0}, corner_offsets = {0}, corners, line_offsets = {0}, lines;
  std::vector<float> vertices;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const auto first = static_cast<std::uint32_t>(vertices.size() / 3);
    for (const FloatPosition& at : drawn[k].vertices) vertices.insert(vertices.end(), at.begin(), at.end());
    for (const std::vector<std::uint32_t>& sheet : drawn[k].sheets) {
      for (const std::uint32_t corner : sheet) corners.push_back(first + corner);
      corner_offsets.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    for (const std::vector<std::uint32_t>& line : drawn[k].lines) {
      for (const std::uint32_t corner : line) lines.push_back(first + corner);
    }
    records.push_back(selection.place[surfaces.record(sets[k])]);
    sheet_offsets.push_back(static_cast<std::uint32_t>(corner_offsets.size() - 1));
    line_offsets.push_back(static_cast<std::uint32_t>(lines.size() / 2));
  }
  return {{"of", selection.all_surfaces},
          {"record", viewer_blob(records)},
          {"sheet_offsets", viewer_blob(sheet_offsets)},
          {"corner_offsets", viewer_blob(corner_offsets)},
          {"corners", viewer_blob(corners)},
          {"line_offsets", viewer_blob(line_offsets)},
          {"lines", viewer_blob(lines)},
          {"vertices", viewer_blob(vertices)}};
}

// ---- Cells ----

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
