// Persistent homology of the sublevel sets of d^2, over Z/2, by the Čech filtration (FC-PERS-05): no flow, no
// critical point, no triangulation, and so nothing that a degenerate position could disturb.
//
// All sets of at most four samples are listed, each with the squared radius of its smallest enclosing ball,
// and the boundary matrix is reduced column by column. Exact. Takes time n^4 for the list, and in the worst
// case the cube of that for the reduction: meant for 20 points at most.
#pragma once

#include <optional>
#include <vector>

#include "oracle/stationary_points.h"

namespace oracle {

struct PersistencePair {
  int dimension = 0;  // of the homology class, 0 to 2
  Rational birth;
  std::optional<Rational> death;  // nothing: the class lasts

  friend bool operator==(const PersistencePair&, const PersistencePair&) = default;
};

// By dimension, birth, death; what lasts comes last.
bool operator<(const PersistencePair& a, const PersistencePair& b);

// Those of positive length, ascending; each as often as it occurs.
std::vector<PersistencePair> persistence_pairs(const PointSet& set);

}  // namespace oracle
