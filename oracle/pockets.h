// Pockets: the stable sets of maxima, merged by persistence, with what leads out of them (FC-POCK-01 to 08).
//
// Infinity counts as a maximum without end, and its pocket is the outside. Values are squared distances. A point is
// named by its place in the list of all stationary points, which is in the order of FC-OUT-02. Exact, for any finite
// point set of any dimension.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// A widest path to infinity.
struct WidestPath {
  Rational value;                  // the least d^2 on it
  std::vector<std::size_t> gates;  // FC-POCK-07: where such paths come to the outside; ascending

  friend bool operator==(const WidestPath&, const WidestPath&) = default;
};

struct Pocket {
  std::vector<std::size_t> maxima;      // ascending, here and below
  std::vector<std::size_t> peaks;       // the highest of them
  std::vector<std::size_t> cell;        // the stationary points whose stable sets make the pocket (FC-POCK-03)
  std::vector<std::size_t> mouths;      // FC-POCK-04
  std::vector<std::size_t> neighbours;  // pockets, by their numbers; the outside has the number of pockets
  Rational height;                      // the value of the peaks
  Rational highest_mouth;               // the greatest value of a mouth
  Rational volume;
  WidestPath to_infinity;

  friend bool operator==(const Pocket&, const Pocket&) = default;
};

struct Pockets {
  std::vector<Pocket> pockets;       // by their first maximum
  std::vector<std::size_t> outside;  // the maxima that belong to the outside

  friend bool operator==(const Pockets&, const Pockets&) = default;
};

// The pockets at the persistence X, whose square is given, as it can be rational where X is not. The pairs that are
// longer than X keep pockets apart.
Pockets pockets(const PointSet& set, const std::vector<StationaryPoint>& all, const Rational& squared_persistence);

// The numbers of the pockets above a point that flows to `limit`, ascending (FC-POCK-03). It is in the pocket if there
// is one alone. The outside has the number of pockets. `limit` is no sample, and nothing for infinity.
std::vector<std::size_t> pockets_above(const PointSet& set, const std::vector<StationaryPoint>& all,
                                       const Pockets& pockets, const std::optional<StationaryPoint>& limit);

// FC-POCK-06: what a pocket is for a probe.
enum class Passage { kCavity, kPocket, kChannel };
Passage passage(const std::vector<StationaryPoint>& all, const Pocket& pocket, const Rational& squared_radius);

// FC-POCK-07, of the whole. Nothing iff there is no pocket.
std::optional<WidestPath> widest_path(const Pockets& pockets);
// FC-POCK-08: the peaks of the greatest value. Empty iff there is no pocket.
std::vector<std::size_t> largest_balls(const std::vector<StationaryPoint>& all, const Pockets& pockets);

}  // namespace oracle
