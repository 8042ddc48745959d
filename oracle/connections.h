// Which stationary points lead to which, from the λ-lists alone (FC-CONN-01 to 03).
//
// The orbits that leave a stationary point y end at stationary points or at infinity. The graph counts in how many ways
// they end at each of these. Exact, for any finite point set of any dimension.
#pragma once

#include <cstddef>
#include <optional>
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
// `from`, then by `to`, and infinity is last. The second function is for callers that know the stationary points: `all`
// has them in the order of FC-OUT-02.
std::vector<Connection> connections(const PointSet& set);
std::vector<Connection> connections(const PointSet& set, const std::vector<StationaryPoint>& all);

// FC-CONN-03.
bool is_morse_smale(const PointSet& set);
bool is_morse_smale(const PointSet& set, const std::vector<StationaryPoint>& all);

}  // namespace oracle
