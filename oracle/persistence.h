// Persistent homology of the sublevel sets of d^2, over Z/2, by the Čech filtration (FC-PERS-05). It uses no flow, no
// critical point and no triangulation, so a degenerate position can disturb nothing.
//
// All sets of at most four samples are listed, each with the squared radius of its smallest enclosing ball. The
// boundary matrix is then reduced column by column. Exact. The list takes time n^4, and the reduction in the worst
// case the cube of that. So this is meant for 20 points at most.
#pragma once

#include <cstddef>
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

// A sum mod 2 of what is told by places, ascending.
using Column = std::vector<std::size_t>;
Column sum_mod_2(const Column& a, const Column& b);

// Whether sqrt(a) - sqrt(b) is at most sqrt(c), by squaring. None of them is negative. So lengths are compared with a
// number, exactly (FC-PERS-06).
bool is_root_difference_up_to(const Rational& a, const Rational& b, const Rational& c);

// The order by dimension, birth and death. A class that lasts comes last.
bool operator<(const PersistencePair& a, const PersistencePair& b);

// The pairs of positive length, ascending, each as often as it occurs.
std::vector<PersistencePair> persistence_pairs(const PointSet& set);

}  // namespace oracle
