// Values that several cells share are rounded once.
#include "io/vtk_exports.h"

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "flowcert/sphere.h"
#include "geometry/bounded_sphere.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "io/number_text.h"
#include "io/vtk_document.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert {

using namespace io;

namespace {

using Flags = std::vector<std::int8_t>;
using Ids = std::vector<std::int64_t>;
using Values = std::vector<double>;

// TTK's SeparatrixType: descending 1-separatrices are 0, saddle connectors are 1. Ascending 1-separatrices and
// descending surfaces are 2.
constexpr std::int8_t kSeparatrixType = 2;
constexpr std::int64_t kInfinity = -1;
// TTK's CriticalType of points that are not critical.
constexpr std::int8_t kRegularType = 5;

void append_cell(VtpCells& cells, std::int64_t first, std::int64_t count) {
  for (std::int64_t k = 0; k < count; ++k) cells.connectivity.push_back(first + k);
  cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
}

// The cell data that lines and surfaces share.
struct SeparatrixData {
  Ids source_ids, separatrix_ids;
  Flags types;
  Values maxima, minima, differences;

  void append(std::int64_t source, std::int64_t separatrix, double minimum, double maximum, double difference) {
    source_ids.push_back(source);
    separatrix_ids.push_back(separatrix);
    types.push_back(kSeparatrixType);
    minima.push_back(minimum);
    maxima.push_back(maximum);
    differences.push_back(difference);
  }

  [[nodiscard]] std::vector<VtpArray> arrays() && {
    std::vector<VtpArray> arrays;
    arrays.push_back({"SourceId", std::move(source_ids)});
    arrays.push_back({"SeparatrixId", std::move(separatrix_ids)});
    arrays.push_back({"SeparatrixType", std::move(types)});
    arrays.push_back({"SeparatrixFunctionMaximum", std::move(maxima)});
    arrays.push_back({"SeparatrixFunctionMinimum", std::move(minima)});
    arrays.push_back({"SeparatrixFunctionDifference", std::move(differences)});
    return arrays;
  }
};

// Orbits to infinity, cut where they leave a box.
//
// Guarantees: what lies before the cut is as it was. An orbit leaves the box once, because outside of a convex set that
// has all samples the flow goes away from that set. The cut lies where the straight line between the doubles on both
// sides of it leaves the box, in the nearest doubles (ClipBox::exit). Its squared distance is that of these doubles to
// their nearest samples, in the nearest double.
class ClippedOrbits {
 public:
  // Both must outlive it.
  ClippedOrbits(const FlowComplex& complex, const ClipBox& box)
      : complex_(complex), box_(box), faces_(complex.diagram()) {}

  // The points are those of UnstableManifolds::rounded_orbit(i, side), which goes to infinity. Afterwards the last one
  // is where the orbit leaves the box: no new one, if the orbit leaves it at a point that it has.
  void clip(std::size_t i, std::size_t side, std::vector<RoundedSphere>& points) {
    const auto outside =
        std::ranges::find_if(points, [&](const RoundedSphere& point) { return !box_.contains(point.center); });
    const auto count = static_cast<std::size_t>(outside - points.begin());
    FLOWCERT_REQUIRES(count > 0);  // the critical point is in the box
    const Point from = points[count - 1].center;
    RoundedSphere end;
    if (outside == points.end()) {
      const Point direction = complex_.unstable().direction_to_infinity(i, side).value();
      end = known_cut({from.x, from.y, from.z, direction.x, direction.y, direction.z, 0});
    } else if (const Point to = outside->center; to.is_finite()) {
      end = known_cut({from.x, from.y, from.z, to.x, to.y, to.z, 1});
    } else {
      // The next point is beyond the doubles, so its exact position is made.
      const Orbit orbit = complex_.unstable().orbit(i, side);
      end = cut(from, *orbit.segments[count - 1].end - exact_position(from));
    }
    points.resize(count);
    if (end.center != from) points.push_back(end);
  }

 private:
  // A position, then either the direction from there and 0, or the next position and 1.
  using Key = std::array<double, 7>;

  RoundedSphere cut(const Point& from, const RationalPoint& direction) {
    const Point end = box_.exit(from, direction);
    const RationalPoint exact_end = exact_position(end);
    const auto nearest = faces_.diagram().contact(faces_.locate(exact_end));
    const Rational squared = geometry::squared_distance(exact_end, faces_.diagram().point(nearest.front()));
    return {end, nearest_or_infinity(squared)};
  }

  RoundedSphere known_cut(const Key& key) {
    const auto [known, is_new] = cuts_.try_emplace(key);
    if (!is_new) return known->second;
    const Point from{key[0], key[1], key[2]}, ahead{key[3], key[4], key[5]};
    const RationalPoint direction = exact_position(ahead);
    const bool is_position = key[6] == 1;
    return known->second = cut(from, is_position ? direction - exact_position(from) : direction);
  }

  const FlowComplex& complex_;
  const ClipBox& box_;
  VoronoiFaces faces_;  // remembers where it last looked for a position
  // Many orbits go the same way.
  std::unordered_map<Key, RoundedSphere, boost::hash<Key>> cuts_;
};

// The finite part of an orbit: `count` points from `first` on.
struct Line {
  std::size_t saddle = 0;
  std::int8_t side = 0;
  std::optional<std::size_t> limit;
  std::int64_t first = 0, count = 0;
};

struct LineSet {
  std::vector<Line> lines;
  std::vector<Point> positions;
  Values squared_distances;
  Flags is_clipped;

  // has_clipped_end: the orbit's last point is where it leaves the box.
  void append(std::size_t saddle, std::int8_t side, std::optional<std::size_t> limit,
              const std::vector<RoundedSphere>& orbit, bool has_clipped_end) {
    lines.push_back({.saddle = saddle,
                     .side = side,
                     .limit = limit,
                     .first = static_cast<std::int64_t>(positions.size()),
                     .count = static_cast<std::int64_t>(orbit.size())});
    for (const RoundedSphere& point : orbit) {
      const bool is_cut = has_clipped_end && &point == &orbit.back();
      positions.push_back(finite(point.center));
      squared_distances.push_back(is_cut ? point.squared_radius : finite(point.squared_radius));
      is_clipped.push_back(is_cut ? 1 : 0);
    }
  }
};

// The squared distance at one stationary point less that at another one.
double rounded_difference(const FlowComplex& complex, std::size_t low, std::size_t high) {
  const StationaryPoints& stationary = complex.stationary();
  const auto squared_radius = [&](std::size_t record) {
    const std::size_t dimension = stationary.index(record).hull_dimension;
    return bounded_sphere(complex.points(), stationary.contact(record), dimension).squared_radius;
  };
  if (const auto nearest = decided_double(squared_radius(high) - squared_radius(low))) return *nearest;
  return rounded(complex.sphere(high).squared_radius - complex.sphere(low).squared_radius);
}

}  // namespace

// ---- Data sets ----

PolyData critical_point_data(const FlowComplex& complex, const Progress& progress) {
  const geometry::IeeeDoubles ieee;
  const StationaryPoints& stationary = complex.stationary();
  PolyData data;
  Flags dimensions, face_dimensions, are_regular, types;
  Ids ids;
  Values squared_distances;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    const RoundedSphere sphere = complex.rounded_sphere(record);
    const auto id = static_cast<std::int64_t>(record);
    data.points.push_back(finite(sphere.center));
    append_cell(data.vertices, id, 1);
    ids.push_back(id);
    dimensions.push_back(static_cast<std::int8_t>(index.hull_dimension));
    face_dimensions.push_back(static_cast<std::int8_t>(index.face_dimension));
    are_regular.push_back(index.is_critical() ? 0 : 1);
    types.push_back(index.is_critical() ? static_cast<std::int8_t>(index.face_dimension) : kRegularType);
    squared_distances.push_back(finite(sphere.squared_radius));
    if (progress) progress(record + 1, stationary.size());
  }
  data.point_data.push_back({"CellDimension", std::move(dimensions)});
  data.point_data.push_back({"CellId", std::move(ids)});
  data.point_data.push_back({"CriticalType", std::move(types)});
  data.point_data.push_back({"FaceDimension", std::move(face_dimensions)});
  data.point_data.push_back({"IsRegular", std::move(are_regular)});
  data.point_data.push_back({"SquaredDistance", std::move(squared_distances)});
  return data;
}

namespace {

// All orbits of U2, cut at the box if there is one.
LineSet lines_of(const FlowComplex& complex, const std::optional<ClipBox>& box, const Progress& progress,
                 const std::vector<std::size_t>* records) {
  const UnstableManifolds& u2 = complex.unstable();
  std::optional<ClippedOrbits> clipped;
  if (box) clipped.emplace(complex, *box);
  LineSet set;
  for (std::size_t i = 0; i < u2.size(); ++i) {
    if (records && !std::ranges::binary_search(*records, u2.saddle(i))) continue;
    for (const std::size_t side : {0U, 1U}) {
      const std::optional<std::size_t> limit = u2.limit(i, side);
      std::vector<RoundedSphere> orbit = u2.rounded_orbit(i, side);
      const bool is_clipped = clipped && !limit;
      if (is_clipped) clipped->clip(i, side, orbit);
      set.append(u2.saddle(i), static_cast<std::int8_t>(side), limit, orbit, is_clipped);
    }
    if (progress) progress(i + 1, u2.size());
  }
  // Lines of one point come first, because the format has vertices before lines.
  std::stable_partition(set.lines.begin(), set.lines.end(), [](const Line& line) { return line.count == 1; });
  return set;
}

}  // namespace

PolyData unstable_line_data(const FlowComplex& complex, const std::optional<ClipBox>& box, const Progress& progress,
                            const std::vector<std::size_t>* records) {
  const geometry::IeeeDoubles ieee;
  LineSet set = lines_of(complex, box, progress, records);
  PolyData data;
  SeparatrixData separatrices;
  Ids destinations;
  Flags sides, to_infinity;
  // Many orbits end at one maximum.
  constexpr double kUnknown = -1;
  Values squared_values(complex.stationary().size(), kUnknown);
  const auto squared_value = [&](std::size_t record) {
    double& value = squared_values[record];
    if (value == kUnknown) value = complex.rounded_sphere(record).squared_radius;
    return finite(value);
  };
  const std::size_t first_saddle = complex.unstable().size() > 0 ? complex.unstable().saddle(0) : 0;
  for (const Line& line : set.lines) {
    append_cell(line.count == 1 ? data.vertices : data.lines, line.first, line.count);
    constexpr double kUnbounded = std::numeric_limits<double>::infinity();
    // The critical points of index 2 are consecutive records.
    separatrices.append(static_cast<std::int64_t>(line.saddle),
                        static_cast<std::int64_t>(2 * (line.saddle - first_saddle)) + line.side,
                        squared_value(line.saddle), line.limit ? squared_value(*line.limit) : kUnbounded,
                        line.limit ? rounded_difference(complex, line.saddle, *line.limit) : kUnbounded);
    destinations.push_back(line.limit ? static_cast<std::int64_t>(*line.limit) : kInfinity);
    sides.push_back(line.side);
    to_infinity.push_back(line.limit ? 0 : 1);
  }
  data.points = std::move(set.positions);
  if (box) data.point_data.push_back({"IsClipped", std::move(set.is_clipped)});
  data.point_data.push_back({"SquaredDistance", std::move(set.squared_distances)});
  data.cell_data = std::move(separatrices).arrays();
  data.cell_data.push_back({"DestinationId", std::move(destinations)});
  data.cell_data.push_back({"Side", std::move(sides)});
  data.cell_data.push_back({"ToInfinity", std::move(to_infinity)});
  return data;
}

PolyData stable_surface_data(const FlowComplex& complex, SurfaceMesh mesh) {
  const geometry::IeeeDoubles ieee;
  const StableManifolds& s2 = complex.stable();
  PolyData data;
  data.points = std::move(mesh.vertices);
  for (const Triangle& triangle : mesh.triangles) {
    auto& connectivity = data.polygons.connectivity;
    connectivity.insert(connectivity.end(), triangle.begin(), triangle.end());
    data.polygons.offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  mesh.triangles = {};
  Values squared_distances;
  for (const std::optional<double>& value : mesh.squared_distances) {
    if (!value) throw BeyondDoubles();
    squared_distances.push_back(*value);
  }
  SeparatrixData separatrices;
  Flags have_interval;
  std::optional<std::size_t> latest;
  double maximum = 0;
  for (const std::size_t set : mesh.set_of_triangle) {
    const std::size_t record = s2.record(set);
    if (latest != set) maximum = finite(complex.rounded_sphere(record).squared_radius);
    latest = set;
    // The minimum is 0, because every S2 reaches to its samples.
    separatrices.append(static_cast<std::int64_t>(record), static_cast<std::int64_t>(set), 0, maximum, maximum);
    have_interval.push_back(s2.has_interval(set) ? 1 : 0);
  }
  data.point_data.push_back({"SquaredDistance", std::move(squared_distances)});
  data.cell_data = std::move(separatrices).arrays();
  data.cell_data.push_back({"HasInterval", std::move(have_interval)});
  return data;
}

// ---- Writing ----

void write_vtp(std::ostream& out, const PolyData& data, const std::string& comment) {
  const geometry::IeeeDoubles ieee;
  VtkDocument document(out, "PolyData", comment);
  document.piece({.points = data.points.size(),
                  .vertices = data.vertices.offsets.size(),
                  .lines = data.lines.offsets.size(),
                  .polygons = data.polygons.offsets.size()});
  document.section("PointData", data.point_data);
  document.section("CellData", data.cell_data);
  document.points(data.points);
  document.cells("Verts", data.vertices);
  document.cells("Lines", data.lines);
  document.cells("Polys", data.polygons);
  document.end();
}

void write_vtu(std::ostream& out, const UnstructuredGrid& data, const std::string& comment) {
  const geometry::IeeeDoubles ieee;
  VtkDocument document(out, "UnstructuredGrid", comment);
  document.piece(data.points.size(), data.shapes.size());
  document.section("CellData", data.cell_data);
  document.points(data.points);
  document.cells("Cells", data.cells, &data.shapes);
  document.end();
}

}  // namespace flowcert
