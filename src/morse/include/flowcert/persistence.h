// Persistent homology of the squared distance function, over Z/2, from what lies below and above its critical
// points.
//
// Guarantees: pairs and values are exact, and equal to the persistence of the alpha complex without its pairs of
// length zero (spec clauses FC-PERS). Union-find over the index-1 points makes pairs (0,1). The dual union-find over
// the maxima and infinity makes pairs (2,3). Reducing the boundaries of the index-2 points that are left makes pairs
// (1,2).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flowcert/saddle_links.h"
#include "flowcert/squared_distances.h"

namespace flowcert {

struct PersistencePair {
  int dimension = 0;                   // of the homology class, 0 to 2
  std::uint32_t birth = 0;             // critical points, by their places in the list
  std::optional<std::uint32_t> death;  // none: the class lasts

  friend bool operator==(const PersistencePair&, const PersistencePair&) = default;
};

// The reduced column of one point of index 2 was added to that of another. Both are places in the list.
struct ColumnAddition {
  std::uint32_t to = 0, from = 0;
};

class Persistence {
 public:
  // Sorts all critical points by their exact values, and makes a reduction. This is cubic at worst in the number of
  // index-2 points that no maximum is paired with. Points and list must outlive this. It is the same for any number of
  // threads, which is at least 1.
  Persistence(const PointSet& points, const StationaryPoints& stationary, const SaddleLinks& links,
              unsigned threads = 1);
  // From the chain complex, which has the limits of U2. The pairs are the same.
  Persistence(const PointSet& points, const StationaryPoints& stationary, const ChainComplex& complex,
              unsigned threads = 1);

  // Sorted by dimension, then birth. No pair has length zero.
  [[nodiscard]] const std::vector<PersistencePair>& pairs() const { return pairs_; }
  // The other point of a critical point's pair.
  static constexpr std::uint32_t kNone = 0xffffffffu;
  [[nodiscard]] std::uint32_t partner(std::size_t record) const { return partner_[record]; }
  // How the boundaries of points of index 2 were reduced to those that close a tunnel each, without index-1 points that
  // join components. Additions to one column follow one another, and columns ascend by the values of their points. The
  // values descend at which the tunnels of what is added are born.
  [[nodiscard]] const std::vector<ColumnAddition>& additions() const { return additions_; }
  // The exact value of a stationary point, computed anew each time.
  [[nodiscard]] Rational squared_value(std::size_t record) const { return distances_.exact(record); }
  [[nodiscard]] const SquaredDistances& squared_distances() const { return distances_; }

 private:
  SquaredDistances distances_;
  std::vector<std::uint32_t> partner_;  // of critical points
  std::vector<ColumnAddition> additions_;
  std::vector<PersistencePair> pairs_;
};

}  // namespace flowcert
