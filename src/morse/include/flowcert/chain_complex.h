// The chain complex of the flow complex over Z/2. It has a cell for each critical point. The boundary of the cell is
// the critical points of one index less at which its stable manifold ends.
//
// Guarantees: where no tie has to be broken, the boundary operators are determined, and, if nothing is regular
// stationary, the boundary of a boundary is zero. Otherwise ties are broken as clause FC-CHAIN-02 allows. Whatever the
// choice, boundaries of index-2 points are cycles, and persistence is the alpha complex's. Source: spec section 10
// (clauses FC-CHAIN).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"

namespace flowcert {

class ChainComplex {
 public:
  // All arguments are of one triangulation and one list. O(cells), and the orbits that ties make flow on. The seed is
  // for the choices where the limits of U2 have ties; 0 always takes the first way.
  ChainComplex(const PointSet& points, const StationaryPoints& stationary, const UnstableManifolds& unstable,
               const StableManifolds& stable, std::uint64_t seed = 0);

  // The boundary of a critical point, given by its place in the list: records, ascending. It is empty for index 0.
  [[nodiscard]] std::span<const std::uint32_t> boundary(std::size_t record) const {
    return std::span(cells_).subspan(first_[record], first_[record + 1] - first_[record]);
  }
  // Prefetches where the boundary is, for those who go through points in another order.
  [[gnu::always_inline]] void prefetch(std::size_t record) const { __builtin_prefetch(&first_[record]); }
  // For each index-2 point, by its number in UnstableManifolds: where its two orbits end after ties are broken. Each
  // end is a maximum or kInfinity.
  static constexpr std::uint32_t kInfinity = 0xffffffffu;
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 2>>& limits() const { return limits_; }
  // How often an orbit of U2 came to a stationary point other than a maximum, and had to be let go on.
  [[nodiscard]] std::size_t broken_ties() const { return broken_ties_; }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::array<std::uint32_t, 2>> limits_;
  std::size_t broken_ties_ = 0;
};

}  // namespace flowcert
