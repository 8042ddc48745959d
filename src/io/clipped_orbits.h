// Orbits to infinity, cut where they leave a box.
//
// Guarantees: what lies before the cut is as it was. An orbit leaves the box once, because outside of a convex set that
// has all samples the flow goes away from that set. The cut lies where the straight line between the doubles on both
// sides of it leaves the box, in the nearest doubles (ClipBox::exit). Its squared distance is that of these doubles to
// their nearest samples, in the nearest double.
#pragma once

#include <array>
#include <boost/container_hash/hash.hpp>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "flowcert/flow_complex.h"
#include "io/clip_box.h"
#include "io/layer.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::io {

class ClippedOrbits {
 public:
  // Both must outlive it.
  ClippedOrbits(const FlowComplex& complex, const ClipBox& box)
      : complex_(complex), box_(box), faces_(complex.diagram()) {}

  // The points are those of UnstableManifolds::rounded_orbit(i, side), which goes to infinity. Afterwards the last one
  // is where the orbit leaves the box: no new one, if the orbit leaves it at a point that it has.
  void clip(std::size_t i, std::size_t side, std::vector<RoundedSphere>& points);

 private:
  // A position, then either the direction from there and 0, or the next position and 1.
  using Key = std::array<double, 7>;

  [[nodiscard]] RoundedSphere cut(const Point& from, const RationalPoint& direction);
  [[nodiscard]] RoundedSphere known_cut(const Key& key);

  const FlowComplex& complex_;
  const ClipBox& box_;
  VoronoiFaces faces_;  // remembers where it last looked for a position
  // Many orbits go the same way.
  std::unordered_map<Key, RoundedSphere, boost::hash<Key>> cuts_;
};

}  // namespace flowcert::io
