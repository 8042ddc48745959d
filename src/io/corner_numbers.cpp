#include "io/corner_numbers.h"

#include <utility>

#include "io/number_text.h"

namespace flowcert::io {

CornerNumbers::CornerNumbers(const FlowComplex& complex, StableRegions& regions)
    : complex_(complex), regions_(regions) {
  const StationaryPoints& stationary = complex.stationary();
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    if (index.is_critical() || index.face_dimension != 1) continue;
    regular_.emplace(complex.rounded_sphere(record).center.coordinates(), Regular{record, kNone});
  }
}

std::int64_t CornerNumbers::of(const StableRegion& region, const RegionCorner& corner) {
  std::int64_t& number = known(region, corner);
  if (number == kNone) number = number_of_new(region, corner);
  return number;
}

std::int64_t CornerNumbers::of_sample(PointId name) {
  const auto [found, is_new] = samples_.try_emplace(name, kNone);
  if (is_new) found->second = append(complex_.points().at_row(name));
  return found->second;
}

std::int64_t CornerNumbers::of_cut(const Point& position) {
  const auto [found, is_new] = cuts_.try_emplace(position.coordinates(), kNone);
  if (is_new) found->second = append(position);
  return found->second;
}

// The regions of a facet come one after the other, so that one midpoint is enough.
std::int64_t& CornerNumbers::known(const StableRegion& region, const RegionCorner& corner) {
  if (corner.kind == RegionCorner::Kind::kVertex) return vertices_.try_emplace(corner.number, kNone).first->second;
  if (corner.kind == RegionCorner::Kind::kDivision) return divisions_.try_emplace(corner.number, kNone).first->second;
  if (samples_of_midpoint_ != region.samples) midpoint_ = kNone;
  samples_of_midpoint_ = region.samples;
  return midpoint_;
}

std::int64_t CornerNumbers::number_of_new(const StableRegion& region, const RegionCorner& corner) {
  const Point position = regions_.rounded(region, corner);
  const auto [from, to] = regular_.equal_range(position.coordinates());
  for (auto each = from; each != to; ++each) {
    Regular& regular = each->second;
    if (complex_.sphere(regular.record).center != regions_.exact(region, corner)) continue;
    if (regular.number == kNone) regular.number = append(position);
    return regular.number;
  }
  return append(position);
}

std::vector<Point> CornerNumbers::take_points() {
  for (Point& point : points_) point = finite(point);
  return std::move(points_);
}

std::int64_t CornerNumbers::append(const Point& position) {
  points_.push_back(position);
  return static_cast<std::int64_t>(points_.size()) - 1;
}

}  // namespace flowcert::io
