// Values that several cells share are rounded once.
#include "io/vtk_exports.h"

#include <algorithm>
#include <limits>

#include "geometry/bounded_sphere.h"
#include "geometry/floating_point.h"
#include "io/clipped_orbits.h"
#include "io/number_text.h"
#include "io/vtk_document.h"

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

// The finite part of an orbit: `count` points from `first` on.
struct Line {
  std::size_t saddle = 0;
  std::int8_t side = 0;
  std::optional<std::size_t> limit;
  std::int64_t first = 0, count = 0;
};

class LineSet {
 public:
  // has_clipped_end: the orbit's last point is where it leaves the box.
  void append(std::size_t saddle, std::int8_t side, std::optional<std::size_t> limit,
              const std::vector<RoundedSphere>& orbit, bool has_clipped_end) {
    const auto count = static_cast<std::int64_t>(orbit.size());
    lines_.push_back({.saddle = saddle, .side = side, .limit = limit, .first = size(), .count = count});
    for (const RoundedSphere& point : orbit) {
      const bool is_clipped = has_clipped_end && &point == &orbit.back();
      positions_.push_back(finite(point.center));
      squared_distances_.push_back(is_clipped ? point.squared_radius : finite(point.squared_radius));
      is_clipped_.push_back(is_clipped ? 1 : 0);
    }
  }

  // Lines of one point come first, because the format has vertices before lines.
  [[nodiscard]] std::vector<Line> take_lines() {
    std::stable_partition(lines_.begin(), lines_.end(), [](const Line& line) { return line.count == 1; });
    return std::move(lines_);
  }
  [[nodiscard]] std::vector<Point> take_positions() { return std::move(positions_); }
  [[nodiscard]] Values take_squared_distances() { return std::move(squared_distances_); }
  [[nodiscard]] Flags take_is_clipped() { return std::move(is_clipped_); }

 private:
  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(positions_.size()); }

  std::vector<Line> lines_;
  std::vector<Point> positions_;
  Values squared_distances_;
  Flags is_clipped_;
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
  for (const Line& line : set.take_lines()) {
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
  data.points = set.take_positions();
  if (box) data.point_data.push_back({"IsClipped", set.take_is_clipped()});
  data.point_data.push_back({"SquaredDistance", set.take_squared_distances()});
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
