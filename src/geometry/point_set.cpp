#include "flowcert/point_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"

namespace flowcert {

namespace {

std::tuple<double, double, double> key(const Point& p) { return {p.x, p.y, p.z}; }

// Adding 0.0 turns -0.0 into 0.0 and leaves every other number as it is.
Point normalized(const Point& p, std::size_t row) {
  if (!p.is_finite()) {
    throw InvalidInput("point " + std::to_string(row) + " has a coordinate that is not a finite number");
  }
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
}

}  // namespace

PointSet::PointSet(std::span<const Point> rows, std::vector<std::size_t> left_out)
    : class_of_row_(rows.size()), left_out_(std::move(left_out)) {
  const geometry::IeeeDoubles ieee;
  if (rows.size() > 0x7ffffffeu) throw InvalidInput("more than 2147483646 points");
  std::vector<Point> normal(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) normal[i] = normalized(rows[i], i);

  std::vector<PointId> order(rows.size());
  std::iota(order.begin(), order.end(), PointId{0});
  std::sort(order.begin(), order.end(), [&normal](PointId i, PointId j) {
    const auto ki = key(normal[i]), kj = key(normal[j]);
    return ki < kj || (ki == kj && i < j);
  });

  // The first row of each run of equal points names the run.
  std::vector<PointId> name_of_row(rows.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeats = k > 0 && normal[order[k]] == normal[order[k - 1]];
    name_of_row[order[k]] = repeats ? name_of_row[order[k - 1]] : order[k];
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const PointId name = name_of_row[row];
    if (name == row) {
      class_of_row_[row] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(normal[row]);
      names_.push_back(name);
    } else {
      class_of_row_[row] = class_of_row_[name];
    }
  }
}

std::vector<std::vector<PointId>> PointSet::repeated_classes() const {
  if (merged_duplicates() == 0) return {};
  std::vector<std::vector<PointId>> rows_of(size());
  for (PointId row = 0; row < row_count(); ++row) rows_of[class_of_row_[row]].push_back(row);
  std::erase_if(rows_of, [](const std::vector<PointId>& rows) { return rows.size() < 2; });
  return rows_of;
}

std::vector<PointId> class_names(const PointSet& points, std::span<const PointId> rows) {
  std::vector<PointId> names;
  names.reserve(rows.size());
  for (const PointId row : rows) names.push_back(points.name(points.ordinal_of_row(row)));
  geometry::keep_unique(names);
  return names;
}

}  // namespace flowcert
