#include "io/clipped_orbits.h"

#include <algorithm>
#include <cmath>

#include "flowcert/sphere.h"
#include "geometry/contract.h"
#include "geometry/rational_point.h"

namespace flowcert::io {

RoundedSphere ClippedOrbits::cut(const Point& from, const RationalPoint& direction) {
  const Point end = box_.exit(from, direction);
  const RationalPoint exact_end = exact_position(end);
  const auto nearest = faces_.diagram().contact(faces_.locate(exact_end));
  const Rational squared = geometry::squared_distance(exact_end, faces_.diagram().point(nearest.front()));
  return {end, nearest_or_infinity(squared)};
}

RoundedSphere ClippedOrbits::known_cut(const Key& key) {
  const auto [known, is_new] = cuts_.try_emplace(key);
  if (!is_new) return known->second;
  const Point from{key[0], key[1], key[2]}, ahead{key[3], key[4], key[5]};
  const RationalPoint direction = exact_position(ahead);
  const bool is_position = key[6] == 1;
  return known->second = cut(from, is_position ? direction - exact_position(from) : direction);
}

void ClippedOrbits::clip(std::size_t i, std::size_t side, std::vector<RoundedSphere>& points) {
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

}  // namespace flowcert::io
