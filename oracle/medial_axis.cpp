// With two contacts p and q of z, |p - q|^2 = 2 d^2 (1 - cos). So the farthest pair has the largest angle.
#include "oracle/medial_axis.h"

#include <algorithm>

#include "oracle/orbit.h"
#include "oracle/unstable_surface.h"

namespace oracle {

namespace {

// Whether x is on the segment, ends included. If the driver is the start, the segment lies on the Voronoi edge of an
// index-2 point. Without an end it has no direction then, and in_u2() has asked for the edge.
bool is_on(const FlowSegment& segment, const Point& x) {
  const Point to_x = minus(x, segment.start);
  const Point direction = minus(segment.end.value_or(segment.start), segment.end ? segment.start : segment.driver);
  if (cross(to_x, direction) != Point{0, 0, 0} || direction == Point{0, 0, 0}) return false;
  const Rational along = dot(to_x, direction);
  return along >= 0 && (!segment.end || along <= dot(direction, direction));
}

// All of the Voronoi edge belongs to U2.
bool in_u2(const PointSet& set, const StationaryPoint& z, const Point& x) {
  if (contact_set(set, x) == z.contact) return true;
  const std::array<Orbit, 2> orbits = unstable_orbits(set, z);
  return std::any_of(orbits.begin(), orbits.end(), [&](const Orbit& orbit) {
    return std::any_of(orbit.segments.begin(), orbit.segments.end(),
                       [&](const FlowSegment& segment) { return is_on(segment, x); });
  });
}

}  // namespace

Rational contact_cosine(const PointSet& set, const StationaryPoint& z) {
  Rational farthest = 0;
  for (const Point& p : select(set.points, places_of(set, z.contact))) {
    for (const Point& q : select(set.points, places_of(set, z.contact))) {
      farthest = std::max(farthest, squared_distance(p, q));
    }
  }
  return 1 - farthest / (2 * z.squared_distance);
}

std::vector<std::size_t> above_angle(const PointSet& set, const std::vector<StationaryPoint>& all,
                                     const Rational& cosine) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_saddle = all[k].is_critical() && (all[k].hull_dimension == 1 || all[k].hull_dimension == 2);
    if (is_saddle && contact_cosine(set, all[k]) < cosine) chosen.push_back(k);
  }
  return chosen;
}

std::size_t count_above_persistence(const std::vector<PersistencePair>& pairs, int index, const Rational& value,
                                    const Rational& squared_persistence) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const PersistencePair& pair) {
    if (!pair.death) return false;
    const bool is_birth = pair.dimension == index && pair.birth == value;
    const bool is_death = pair.dimension == index - 1 && *pair.death == value;
    return (is_birth || is_death) && !is_root_difference_up_to(*pair.death, pair.birth, squared_persistence);
  }));
}

bool in_medial_axis(const PointSet& set, const std::vector<StationaryPoint>& chosen, const Point& x) {
  return std::any_of(chosen.begin(), chosen.end(), [&](const StationaryPoint& z) {
    return z.hull_dimension == 1 ? contains(set, unstable_surface(set, z), x) : in_u2(set, z, x);
  });
}

}  // namespace oracle
