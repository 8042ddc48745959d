#include "morse/division_positions.h"

#include <algorithm>
#include <vector>

#include "flowcert/sphere.h"
#include "geometry/rational_point.h"

namespace flowcert::morse {

namespace {

// So many exact parameters are kept. A long one takes about a kilobyte.
constexpr std::size_t kMostKept = 100'000;

}  // namespace

RationalPoint DivisionPositions::exact(PointOfDivision point) {
  if (exact_.kept() > kMostKept) exact_.drop();
  return exact_.position(point);
}

BoundedDivisions& DivisionPositions::bounded() {
  if (!bounded_) bounded_.emplace(diagram_, partition_);
  return *bounded_;
}

Point DivisionPositions::rounded(PointOfDivision point) {
  const DivisionPoint& place = partition_.point(point);
  if (place.kind != DivisionPoint::Kind::kCrossing) return rounded_face(place);
  const auto decided = bounded().rounded(point);
  return decided ? *decided : rounded_point(exact(point));
}

Point DivisionPositions::rounded_face(const DivisionPoint& point) {
  if (point.kind != DivisionPoint::Kind::kEnd) {
    const auto decided = bounded().rounded_face(point);
    return decided ? *decided : rounded_point(exact_face(point));
  }
  return rounded_point(as_direction(exact_face(point)));
}

// Rounding keeps the order of numbers, or makes them equal.
std::size_t DivisionPositions::least(std::span<const PointOfDivision> points) {
  std::vector<double> x;
  for (const PointOfDivision point : points) x.push_back(rounded(point).x);
  const double least_x = *std::ranges::min_element(x);
  std::size_t best = points.size();
  RationalPoint position;
  const bool is_only = std::ranges::count(x, least_x) == 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (x[i] != least_x) continue;
    if (is_only) return i;
    RationalPoint other = exact(points[i]);
    if (best < points.size() && !(other < position)) continue;
    best = i;
    position = std::move(other);
  }
  return best;
}

}  // namespace flowcert::morse
