// Persistent homology of the squared distance function, over Z/2, from the chain complex of the flow complex.
//
// Guarantees: pairs and values are exact; equal to the persistence of the alpha complex without its pairs of
// length zero (spec clauses FC-PERS). Pairs (0,1) by union-find over the index-1 points, pairs (2,3) by the
// dual union-find over the maxima and infinity, pairs (1,2) by reducing the boundaries of the index-2 points
// that are left.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "flowcert/chain_complex.h"

namespace flowcert {

struct PersistencePair {
  int dimension = 0;                 // of the homology class, 0 to 2
  std::size_t birth = 0;             // critical points, by their places in the list
  std::optional<std::size_t> death;  // none: the class lasts
};

class Persistence {
 public:
  // Sorting all critical points by their exact values, and a reduction, in the worst case cubic in the number
  // of index-2 points that no maximum is paired with.
  Persistence(const PointSet& points, const StationaryPoints& stationary, const ChainComplex& complex);

  // By dimension, then birth. None has length zero.
  [[nodiscard]] const std::vector<PersistencePair>& pairs() const { return pairs_; }
  // Exact, of a critical point.
  [[nodiscard]] const Rational& squared_value(std::size_t record) const { return values_[record]; }

 private:
  std::vector<Rational> values_;  // by record, critical ones
  std::vector<PersistencePair> pairs_;
};

}  // namespace flowcert
