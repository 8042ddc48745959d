// Which stationary points lead to which, from the λ-lists alone (FC-CONN-01 to 03), and to which maxima (FC-POCK-01).
//
// The orbits that leave a stationary point y end at stationary points or at infinity. The graph counts in how many ways
// they end at each of these. `all` has all stationary points in the order of FC-OUT-02. Exact, for any finite point set
// of any dimension.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "oracle/unstable_set.h"

namespace oracle {

// All that leads from one stationary point to another one, or to infinity. One of the two numbers is positive.
struct Connection {
  StationaryPoint from;
  std::optional<StationaryPoint> to;  // nothing: infinity
  std::size_t directions = 0;         // those beside no arc of their own limit: single orbits
  std::size_t arcs = 0;               // families of orbits

  friend bool operator==(const Connection&, const Connection&) = default;
};

// All connections from stationary points that are not samples (FC-CONN-01, 02). They are in the order of FC-OUT-02 by
// `from`, then by `to`, and infinity is last.
std::vector<Connection> connections(const PointSet& set, const std::vector<StationaryPoint>& all);

// FC-CONN-03.
bool is_morse_smale(const PointSet& set, const std::vector<StationaryPoint>& all);

// The place of a limit in `all`. Infinity comes behind all of them.
std::size_t place_of(const std::vector<StationaryPoint>& all, const std::optional<StationaryPoint>& limit);

// Maxima by their ordinal among the maxima, infinity behind all of them: the leaves of superlevel_tree().
using Peaks = std::set<std::size_t>;

// The maxima to which the flow can go on. Infinity counts as one.
struct PeaksAbove {
  // By place_of(). For samples, above which there is all that is beside them, nothing is listed.
  std::vector<Peaks> of;
  // For critical points of index 2, those above the limit of side 0 and of side 1; else empty.
  std::vector<std::array<Peaks, 2>> of_sides;
};
PeaksAbove peaks_above(const PointSet& set, const std::vector<StationaryPoint>& all);

}  // namespace oracle
