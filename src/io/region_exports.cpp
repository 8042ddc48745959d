// Corners tell by their names which of them are equal, with one exception: the midpoint of a facet may lie on the
// facet's boundary. It is a regular stationary point then, and a corner of other facets by another name.
#include "flowcert/region_exports.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>

#include "flowcert/stable_regions.h"
#include "io/number_text.h"

namespace flowcert {

using namespace io;

namespace {

using Samples = std::array<PointId, 2>;

// Stationary points with a face of dimension 1, by the samples of the face.
std::map<Samples, std::size_t> records_of_facets(const FlowComplex& complex) {
  const StationaryPoints& stationary = complex.stationary();
  const PointSet& points = complex.points();
  const auto is_between = [&](const Samples& samples, const RationalPoint& center) {
    const Point &p = points[points.ordinal_of_row(samples[0])], &q = points[points.ordinal_of_row(samples[1])];
    return Rational(p.x) + Rational(q.x) == 2 * center[0] && Rational(p.y) + Rational(q.y) == 2 * center[1] &&
           Rational(p.z) + Rational(q.z) == 2 * center[2];
  };
  std::map<Samples, std::size_t> records;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    if (stationary.index(record).face_dimension != 1) continue;
    const auto contact = stationary.contact(record);
    if (contact.size() == 2) {
      records.emplace(Samples{contact[0], contact[1]}, record);
      continue;
    }
    const RationalPoint center = complex.sphere(record).center;
    for (const PointId p : contact) {
      for (const PointId q : contact) {
        if (p < q && is_between({p, q}, center)) records.emplace(Samples{p, q}, record);
      }
    }
  }
  return records;
}

std::array<double, 3> coordinates(const Point& point) { return {point.x, point.y, point.z}; }

// The points of a file. Each gets a number when it is first met.
class CornerNumbers {
 public:
  CornerNumbers(const FlowComplex& complex, StableRegions& regions) : complex_(complex), regions_(regions) {
    const StationaryPoints& stationary = complex.stationary();
    for (std::size_t record = 0; record < stationary.size(); ++record) {
      const StationaryIndex index = stationary.index(record);
      if (index.is_critical() || index.face_dimension != 1) continue;
      regular_.emplace(coordinates(complex.rounded_sphere(record).center), Regular{record, kNone});
    }
  }

  [[nodiscard]] std::int64_t of(const StableRegion& region, const RegionCorner& corner) {
    std::int64_t& number = known(region, corner);
    if (number == kNone) number = number_of_new(region, corner);
    return number;
  }
  [[nodiscard]] std::int64_t of_sample(PointId name) {
    const auto [found, is_new] = samples_.try_emplace(name, kNone);
    if (is_new) found->second = append(complex_.points()[complex_.points().ordinal_of_row(name)]);
    return found->second;
  }
  [[nodiscard]] std::vector<Point> take_points() { return std::move(points_); }

 private:
  static constexpr std::int64_t kNone = -1;
  struct Regular {
    std::size_t record;
    std::int64_t number;
  };

  // The regions of a facet come one after the other, so that one midpoint is enough.
  std::int64_t& known(const StableRegion& region, const RegionCorner& corner) {
    if (corner.kind == RegionCorner::Kind::kVertex) return vertices_.try_emplace(corner.number, kNone).first->second;
    if (corner.kind == RegionCorner::Kind::kDivision) return divisions_.try_emplace(corner.number, kNone).first->second;
    if (samples_of_midpoint_ != region.samples) midpoint_ = kNone;
    samples_of_midpoint_ = region.samples;
    return midpoint_;
  }

  std::int64_t number_of_new(const StableRegion& region, const RegionCorner& corner) {
    const Point position = finite(regions_.rounded(region, corner));
    const auto [from, to] = regular_.equal_range(coordinates(position));
    for (auto each = from; each != to; ++each) {
      Regular& regular = each->second;
      if (complex_.sphere(regular.record).center != regions_.exact(region, corner)) continue;
      if (regular.number == kNone) regular.number = append(position);
      return regular.number;
    }
    return append(position);
  }

  std::int64_t append(const Point& position) {
    points_.push_back(position);
    return static_cast<std::int64_t>(points_.size()) - 1;
  }

  const FlowComplex& complex_;
  StableRegions& regions_;
  std::vector<Point> points_;
  std::unordered_map<PointId, std::int64_t> samples_;
  std::unordered_map<std::uint32_t, std::int64_t> vertices_, divisions_;
  Samples samples_of_midpoint_{};
  std::int64_t midpoint_ = kNone;
  std::multimap<std::array<double, 3>, Regular> regular_;
};

class CellSet {
 public:
  // The corners counterclockwise, seen from the apex.
  void append_pyramid(std::vector<std::int64_t> corners, std::int64_t apex, std::int64_t limit, std::int64_t sample) {
    const auto append = [&](const std::vector<std::int64_t>& points, UnstructuredGrid::Shape shape) {
      auto& connectivity = grid_.cells.connectivity;
      connectivity.insert(connectivity.end(), points.begin(), points.end());
      grid_.cells.offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      grid_.shapes.push_back(shape);
      limits_.push_back(limit);
      samples_.push_back(sample);
    };
    if (corners.size() == 4) {
      corners.push_back(apex);
      return append(corners, UnstructuredGrid::Shape::kPyramid);
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      append({corners[0], corners[i], corners[i + 1], apex}, UnstructuredGrid::Shape::kTetrahedron);
    }
  }

  [[nodiscard]] UnstructuredGrid grid(const StableVolumes& all, std::vector<Point> points) && {
    std::vector<double> volumes;
    for (const std::int64_t limit : limits_) volumes.push_back(finite(all.nearest(static_cast<std::size_t>(limit))));
    grid_.points = std::move(points);
    grid_.cell_data.push_back({"maximum", std::move(limits_)});
    grid_.cell_data.push_back({"sample", std::move(samples_)});
    grid_.cell_data.push_back({"volume", std::move(volumes)});
    return std::move(grid_);
  }

 private:
  UnstructuredGrid grid_;
  std::vector<std::int64_t> limits_, samples_;
};

}  // namespace

UnstructuredGrid stable_cell_data(const FlowComplex& complex) {
  StableRegions regions(complex.diagram(), complex.stationary(), complex.limits());
  CornerNumbers numbers(complex, regions);
  CellSet cells;
  std::vector<std::int64_t> corners;
  regions.visit([&](const StableRegion& region) {
    if (!region.limit) return;
    corners.clear();
    for (const RegionCorner& corner : region.corners) corners.push_back(numbers.of(region, corner));
    const auto limit = static_cast<std::int64_t>(*region.limit);
    for (const std::size_t side : {1U, 0U}) {
      const PointId sample = region.samples[side];
      cells.append_pyramid(corners, numbers.of_sample(sample), limit, static_cast<std::int64_t>(sample));
      std::ranges::reverse(corners);
    }
  });
  return std::move(cells).grid(complex.volumes(), numbers.take_points());
}

PolyData unstable_fan_data(const FlowComplex& complex) {
  StableRegions regions(complex.diagram(), complex.stationary(), complex.limits());
  CornerNumbers numbers(complex, regions);
  const std::map<Samples, std::size_t> records = records_of_facets(complex);
  PolyData data;
  std::vector<std::int64_t> limits, samples, sources;
  regions.visit([&](const StableRegion& region) {
    const auto source = records.find(region.samples);
    const auto is_end = [](const RegionCorner& corner) { return corner.kind == RegionCorner::Kind::kEnd; };
    if (source == records.end() || region.corners.empty() || std::ranges::any_of(region.corners, is_end)) return;
    auto& connectivity = data.polygons.connectivity;
    for (const RegionCorner& corner : region.corners) connectivity.push_back(numbers.of(region, corner));
    data.polygons.offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    limits.push_back(region.limit ? static_cast<std::int64_t>(*region.limit) : -1);
    for (const PointId sample : region.samples) samples.push_back(static_cast<std::int64_t>(sample));
    sources.push_back(static_cast<std::int64_t>(source->second));
  });
  data.points = numbers.take_points();
  data.cell_data.push_back({"limit", std::move(limits)});
  data.cell_data.push_back({"samples", std::move(samples), 2});
  data.cell_data.push_back({"source", std::move(sources)});
  return data;
}

}  // namespace flowcert
