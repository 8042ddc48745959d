#include "io/clip_box.h"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/contract.h"
#include "geometry/floating_point.h"

namespace flowcert {

namespace {

constexpr std::array<double Point::*, 3> kAxes = {&Point::x, &Point::y, &Point::z};

// The nearest double, also of numbers beyond the largest one.
double clamped(const Rational& value) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  if (const auto nearest = nearest_double(value)) return *nearest;
  return value < 0 ? -kLargest : kLargest;
}

}  // namespace

ClipBox::ClipBox(const PointSet& points, const Rational& factor) {
  const geometry::IeeeDoubles ieee;
  FLOWCERT_REQUIRES(!points.empty());
  if (factor < 1) throw InvalidInput("the box of --clip is less than that of the input");
  Point low = points[0], high = points[0];
  for (const Point& point : points.points()) {
    for (const auto axis : kAxes) {
      low.*axis = std::min(low.*axis, point.*axis);
      high.*axis = std::max(high.*axis, point.*axis);
    }
  }
  const auto length = [&](double Point::* axis) { return Rational(high.*axis) - Rational(low.*axis); };
  const Rational longest = std::max({length(&Point::x), length(&Point::y), length(&Point::z)});
  for (const auto axis : kAxes) {
    const Rational center = (Rational(low.*axis) + Rational(high.*axis)) / 2;
    const Rational half = factor * (length(axis) > 0 ? length(axis) : longest) / 2;
    low_.*axis = clamped(center - half);
    high_.*axis = clamped(center + half);
  }
}

bool ClipBox::contains(const Point& position) const {
  const geometry::IeeeDoubles ieee;
  return std::ranges::all_of(
      kAxes, [&](const auto axis) { return position.*axis >= low_.*axis && position.*axis <= high_.*axis; });
}

Point ClipBox::exit(const Point& from, const RationalPoint& direction) const {
  const geometry::IeeeDoubles ieee;
  // In multiples of the direction.
  std::optional<Rational> way;
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    if (direction[k] == 0) continue;
    const auto axis = kAxes[k];
    const Rational to_side = Rational(direction[k] > 0 ? high_.*axis : low_.*axis) - Rational(from.*axis);
    const Rational along = to_side / direction[k];
    if (!way || along < *way) way = along;
  }
  FLOWCERT_REQUIRES(way && *way >= 0);
  Point end;
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    const auto axis = kAxes[k];
    end.*axis = clamped(Rational(from.*axis) + *way * direction[k]) + 0.0;
  }
  return end;
}

}  // namespace flowcert
