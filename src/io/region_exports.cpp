#include "io/region_exports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "geometry/ring.h"
#include "io/clip_box.h"
#include "io/corner_numbers.h"
#include "io/number_text.h"
#include "morse/stable_regions.h"

namespace flowcert {

using namespace io;

namespace {

using Samples = std::array<PointId, 2>;

bool is_end(const RegionCorner& corner) { return corner.kind == RegionCorner::Kind::kEnd; }

// Stationary points with a face of dimension 1, by the samples of the face.
std::map<Samples, std::size_t> records_of_facets(const FlowComplex& complex) {
  const StationaryPoints& stationary = complex.stationary();
  std::map<Samples, std::size_t> records;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    if (stationary.index(record).face_dimension == 1) records.emplace(complex.samples_of(record), record);
  }
  return records;
}

// By stationary point: the numbers of the cells that have its stable set, ascending.
using NumbersOf = std::vector<std::vector<std::int64_t>>;

NumbersOf numbers_of_records(const FlowComplex& complex, const std::vector<std::span<const std::uint32_t>>& cells) {
  NumbersOf numbers_of(complex.stationary().size());
  for (std::size_t number = 0; number < cells.size(); ++number) {
    for (const std::uint32_t record : cells[number]) numbers_of[record].push_back(static_cast<std::int64_t>(number));
  }
  return numbers_of;
}

template <typename Numbers>
CellGrid pyramids(const FlowComplex& complex, const Numbers& numbers_of) {
  StableRegions regions(complex.diagram(), complex.limits());
  CornerNumbers numbers(complex, regions);
  PyramidSet cells;
  CellGrid made;
  std::vector<std::int64_t> corners, samples;
  regions.visit([&](const StableRegion& region) {
    if (!region.limit || std::ranges::empty(numbers_of(*region.limit))) return;
    corners.clear();
    for (const RegionCorner& corner : region.corners) corners.push_back(numbers.of(region, corner));
    for (const std::int64_t number : numbers_of(*region.limit)) {
      for (const std::size_t side : {1U, 0U}) {
        const PointId sample = region.samples[side];
        const std::size_t count = cells.append(corners, numbers.of_sample(sample));
        made.limits.insert(made.limits.end(), count, static_cast<std::int64_t>(*region.limit));
        made.numbers.insert(made.numbers.end(), count, number);
        samples.insert(samples.end(), count, static_cast<std::int64_t>(sample));
        std::ranges::reverse(corners);
      }
    }
  });
  made.grid = cells.take();
  made.grid.points = numbers.take_points();
  made.grid.cell_data.push_back({"maximum", made.limits});
  made.grid.cell_data.push_back({"sample", std::move(samples)});
  return made;
}

}  // namespace

UnstructuredGrid stable_cell_data(const FlowComplex& complex) {
  const geometry::IeeeDoubles ieee;
  CellGrid made = pyramids(complex, [](std::size_t) { return std::array{std::int64_t{0}}; });
  std::vector<double> volumes;
  volumes.reserve(made.limits.size());
  for (const std::int64_t limit : made.limits) {
    volumes.push_back(finite(complex.volumes().nearest(static_cast<std::size_t>(limit))));
  }
  made.grid.cell_data.push_back({"volume", std::move(volumes)});
  return std::move(made.grid);
}

CellGrid cell_grid(const FlowComplex& complex, const std::vector<std::span<const std::uint32_t>>& cells) {
  const geometry::IeeeDoubles ieee;
  const NumbersOf numbers_of = numbers_of_records(complex, cells);
  return pyramids(complex, [&](std::size_t limit) -> const auto& { return numbers_of[limit]; });
}

VtpArray array_by_number(const std::string& name, const std::vector<std::int64_t>& numbers,
                         const std::vector<double>& value_of) {
  std::vector<double> values;
  values.reserve(numbers.size());
  for (const std::int64_t number : numbers) values.push_back(value_of[static_cast<std::size_t>(number)]);
  return {name, std::move(values)};
}

UnstructuredGrid pocket_cell_data(const FlowComplex& complex, const Pockets& pockets) {
  const geometry::IeeeDoubles ieee;
  CellGrid made = cell_grid(complex, pockets.cells());
  std::vector<double> volumes, depths;
  for (std::size_t number = 0; number < pockets.size(); ++number) {
    volumes.push_back(finite(complex.volumes().nearest_sum(pockets[number].cell)));
    depths.push_back(finite(pockets.depth(pockets[number])));
  }
  made.grid.cell_data.push_back({"pocket", made.numbers});
  made.grid.cell_data.push_back(array_by_number("volume", made.numbers, volumes));
  made.grid.cell_data.push_back(array_by_number("depth", made.numbers, depths));
  return std::move(made.grid);
}

PolyData unstable_fan_data(const FlowComplex& complex) {
  const geometry::IeeeDoubles ieee;
  StableRegions regions(complex.diagram(), complex.limits());
  CornerNumbers numbers(complex, regions);
  const std::map<Samples, std::size_t> records = records_of_facets(complex);
  PolyData data;
  std::vector<std::int64_t> limits, samples, sources;
  regions.visit([&](const StableRegion& region) {
    const auto source = records.find(region.samples);
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

// ---- What flows to infinity ----
// In the Voronoi cell of a sample, it is the pyramids over the regions of its facets with that limit, and the cone of
// points that never leave the cell (FC-STAB-08). The sample is in the box. So what the box leaves of a pyramid or a
// cone are pyramids again: over what it leaves of the base, and over parts of its own sides.

namespace {

// The sides of a box as polygons, counterclockwise seen from inside, in the order of half_spaces().
std::vector<std::vector<ProjectiveCorner>> sides_of(const ClipBox& box) {
  const std::array<RationalPoint, 2> ends = {exact_position(box.low()), exact_position(box.high())};
  std::vector<std::vector<ProjectiveCorner>> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::size_t end : {0U, 1U}) {
      std::vector<ProjectiveCorner> side;
      for (const auto& [u, v] : {std::pair(0U, 0U), std::pair(1U, 0U), std::pair(1U, 1U), std::pair(0U, 1U)}) {
        RationalPoint corner;
        corner[axis] = ends[end][axis];
        corner[(axis + 1) % 3] = ends[u][(axis + 1) % 3];
        corner[(axis + 2) % 3] = ends[v][(axis + 2) % 3];
        side.push_back(finite_corner(corner, ProjectiveCorner::kNone));
      }
      // The upper side is seen from below.
      if (end == 1) std::ranges::reverse(side);
      sides.push_back(std::move(side));
    }
  }
  return sides;
}

// <x, normal> >= <p, normal>
HalfSpace half_space_through(const RationalPoint& p, const RationalPoint& normal) { return {normal, dot(p, normal)}; }

class InfinityCells {
 public:
  InfinityCells(const FlowComplex& complex, const std::optional<ClipBox>& box)
      : complex_(complex), box_(box), regions_(complex.diagram(), complex.limits()), numbers_(complex, regions_) {
    if (!box) return;
    sides_ = sides_of(*box);
    half_spaces_ = half_spaces(box->low(), box->high());
  }

  [[nodiscard]] UnstructuredGrid make() && {
    if (complex_.dimension() == 3) {
      regions_.visit([this](const StableRegion& region) { add(region); });
      for (const auto& [sample, beyond] : unbounded_) add_cone(sample, beyond);
    }
    UnstructuredGrid grid = cells_.take();
    grid.points = numbers_.take_points();
    const std::size_t count = samples_.size();
    if (box_) grid.cell_data.push_back({"IsClipped", std::move(are_clipped_)});
    grid.cell_data.push_back({"maximum", std::vector<std::int64_t>(count, -1)});
    grid.cell_data.push_back({"sample", std::move(samples_)});
    grid.cell_data.push_back({"volume", std::vector<double>(count, std::numeric_limits<double>::infinity())});
    return grid;
  }

 private:
  using Corners = std::vector<ProjectiveCorner>;

  [[nodiscard]] RationalPoint position(PointId name) const { return exact_position(complex_.points().at_row(name)); }

  void add(const StableRegion& region) {
    const bool is_unbounded = std::ranges::any_of(region.corners, is_end);
    const auto& [p, q] = region.samples;
    if (is_unbounded && box_) unbounded_[p].insert(q), unbounded_[q].insert(p);
    if (region.limit) return;
    const bool is_whole = std::ranges::all_of(region.corners, [&](const RegionCorner& corner) {
      return !is_end(corner) && (!box_ || box_->contains(regions_.rounded(region, corner)));
    });
    if (is_whole) {
      std::vector<std::int64_t> corners;
      corners.reserve(region.corners.size());
      for (const RegionCorner& corner : region.corners) corners.push_back(numbers_.of(region, corner));
      append(corners, q, false);
      std::ranges::reverse(corners);
      append(corners, p, false);
    } else if (box_) {
      add_cut(region);
    }
  }

  // The doubles of the corners, which other cells have as well.
  [[nodiscard]] Corners base_of(const StableRegion& region) {
    Corners base;
    for (std::size_t k = 0; k < region.corners.size(); ++k) {
      const auto number = static_cast<std::uint32_t>(k);
      const Point x = regions_.rounded(region, region.corners[k]);
      const RationalPoint exact = x.is_finite() ? exact_position(x) : regions_.exact(region, region.corners[k]);
      base.push_back(is_end(region.corners[k]) ? corner_at_infinity(exact, number) : finite_corner(exact, number));
    }
    return base;
  }

  void add_cut(const StableRegion& region) {
    Corners base = base_of(region);
    std::vector<std::int64_t> left;
    for (const ProjectiveCorner& corner : clipped(base, Outline::kClosed, *box_)) {
      left.push_back(corner.number == ProjectiveCorner::kNone ? numbers_.of_cut(rounded(corner.x))
                                                              : numbers_.of(region, region.corners[corner.number]));
    }
    for (const std::size_t side : {1U, 0U}) {
      append(left, region.samples[side], false);
      std::ranges::reverse(left);
      const RationalPoint p = position(region.samples[side]), q = position(region.samples[1 - side]);
      std::vector<HalfSpace> walls = {half_space_through(Rational(1, 2) * (p + q), p - q)};
      const auto from_apex = [&](const ProjectiveCorner& c) { return c.x - c.w * p; };
      for (std::size_t k = 0; k < base.size(); ++k) {
        const RationalPoint here = from_apex(base[k]), next = from_apex(base[(k + 1) % base.size()]);
        walls.push_back(half_space_through(p, cross(next, here)));
      }
      append_on_sides(region.samples[side], walls);
      std::ranges::reverse(base);
    }
  }

  // <x - p, q - p> <= 0 for all samples q.
  void add_cone(PointId sample, const std::set<PointId>& beyond) {
    std::vector<HalfSpace> walls;
    walls.reserve(beyond.size());
    const RationalPoint p = position(sample);
    for (const PointId other : beyond) {
      walls.push_back(half_space_through(p, p - position(other)));
    }
    append_on_sides(sample, walls);
  }

  // Pyramids over what is between the walls on the sides of the box.
  void append_on_sides(PointId sample, const std::vector<HalfSpace>& walls) {
    const RationalPoint p = position(sample);
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const auto& [normal, offset] = half_spaces_[k];
      if (dot(normal, p) == offset) continue;
      Corners polygon = sides_[k];
      for (const HalfSpace& wall : walls) {
        if (polygon.empty()) break;
        polygon = cut(polygon, Outline::kClosed, wall);
      }
      std::vector<std::int64_t> corners;
      for (const ProjectiveCorner& corner : polygon) {
        corners.push_back(numbers_.of_cut(rounded(Rational(1 / corner.w) * corner.x)));
      }
      append(corners, sample, true);
    }
  }

  // The corners counterclockwise, seen from the sample.
  void append(std::vector<std::int64_t> corners, PointId sample, bool is_clipped) {
    merge_repeated(corners);
    if (corners.size() < 3) return;
    const std::size_t count = cells_.append(std::move(corners), numbers_.of_sample(sample));
    samples_.insert(samples_.end(), count, static_cast<std::int64_t>(sample));
    are_clipped_.insert(are_clipped_.end(), count, is_clipped ? 1 : 0);
  }

  const FlowComplex& complex_;
  const std::optional<ClipBox>& box_;
  StableRegions regions_;
  CornerNumbers numbers_;
  PyramidSet cells_;
  std::vector<std::int64_t> samples_;
  std::vector<std::int8_t> are_clipped_;
  std::vector<std::vector<ProjectiveCorner>> sides_;
  std::vector<HalfSpace> half_spaces_;
  std::map<PointId, std::set<PointId>> unbounded_;  // by sample: the others of its unbounded facets
};

}  // namespace

UnstructuredGrid infinity_cell_data(const FlowComplex& complex, const std::optional<ClipBox>& box) {
  const geometry::IeeeDoubles ieee;
  return InfinityCells(complex, box).make();
}

}  // namespace flowcert
