// Boundaries of index-2 points (FC-CHAIN-01, 02), and the index-2 points above an index-1 point.
//
// Boundaries are found against the flow, and what is above an edge with the flow, from the definitions alone, by scans
// over all points. The list of all stationary points is not needed, so that a set may be large. Exact, for any finite
// point set of any dimension.
#pragma once

#include <set>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

// A critical point by its contact set: class names, ascending.
using Contact = std::vector<std::size_t>;
// A sum mod 2 of critical points of index 1.
using Chain = std::set<Contact>;
Chain sum(Chain a, const Chain& b);

// The boundary of a critical point of index 2, by one choice of FC-CHAIN-02, and what ties below can add: each choice
// is this chain with some of these cycles added to it. Such a sum need not be a choice, but it is homologous to them
// below the point.
struct Boundary {
  Chain chain;
  std::vector<Chain> ties;
};
Boundary boundary(const PointSet& set, const StationaryPoint& x);

// Whether a sum of some of the cycles is this chain.
bool is_sum_of(Chain chain, const std::vector<Chain>& cycles);

// Critical points of index 2 of values less than `death`, each once. All whose boundary can have one of these index-1
// points are among them.
std::vector<StationaryPoint> saddles_above(const PointSet& set, const std::vector<StationaryPoint>& edges,
                                           const Rational& death);

}  // namespace oracle
