// See position_grid.h.
#include "certify/position_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/value_match.h"

namespace flowcert::certify {

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

double clamped_double(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? *nearest : value > 0 ? kLargest : -kLargest;
}

std::array<double, 3> rounded(const RationalPoint& x) {
  return {clamped_double(x[0]), clamped_double(x[1]), clamped_double(x[2])};
}

}  // namespace

std::size_t PositionGrid::Hash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t part : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

PositionGrid::PositionGrid(Truth& truth, double tolerance) {
  // The largest of radius and coordinates is at least what the tolerance refers to; the positions that are
  // compared are rounded by less than 2^-51 of it, each.
  const double part = 2 * std::max(tolerance, 2 * kRoundingPart);
  double low = kLargest, high = -kLargest, reach = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    spheres_.push_back(truth.sphere(i));
    reaches_.push_back({rounded(spheres_.back().center), part * rounding_length(spheres_.back())});
    for (const double x : reaches_.back().center) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
    reach = std::max(reach, reaches_.back().length);
  }
  if (spheres_.empty()) return;
  const double even = (high / 2 - low / 2) / std::cbrt(static_cast<double>(spheres_.size()));
  cell_size_ = std::min(std::max({even, reach, std::numeric_limits<double>::min()}), kLargest);
  for (std::size_t i = 0; i < reaches_.size(); ++i) cells_[cell_of(reaches_[i].center)].push_back(i);
}

PositionGrid::Cell PositionGrid::cell_of(const std::array<double, 3>& position) const {
  // Where that is far beyond, all is one cell.
  constexpr double kFar = 0x1p60;
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cell[axis] = static_cast<std::int64_t>(std::clamp(std::floor(position[axis] / cell_size_), -kFar, kFar));
  }
  return cell;
}

std::vector<std::size_t> PositionGrid::near(const ClaimedPosition& position) const {
  const std::array<double, 3> at = rounded(values_of(position));
  const Cell middle = cell_of(at);
  std::vector<std::size_t> found;
  for (int k = 0; k < 27; ++k) {
    const auto cell = cells_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
    if (cell == cells_.end()) continue;
    for (const std::size_t record : cell->second) {
      const Reach& reach = reaches_[record];
      bool is_near = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        is_near = is_near && std::abs(at[axis] - reach.center[axis]) <= reach.length;
      }
      if (is_near) found.push_back(record);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace flowcert::certify
