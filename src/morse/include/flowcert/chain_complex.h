// The chain complex of the flow complex over Z/2: a cell for each critical point, its boundary the critical
// points of one index less that its stable manifold ends at.
//
// Guarantees: where no tie has to be broken the boundary operators are determined, and boundary of boundary
// is zero. Otherwise ties are broken as clause FC-CHAIN-02 allows; whatever the choice, boundaries of index-2
// points are cycles, and persistence is the alpha complex's. Source: spec section 11 (clauses
// FC-CHAIN).
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
  // All of one triangulation and one list. O(cells), with the orbits that ties make flow on. seed: of the
  // choices where the limits of U2 have ties; 0 takes the first way always.
  ChainComplex(const PointSet& points, const StationaryPoints& stationary, const UnstableManifolds& unstable,
               const StableManifolds& stable, std::uint64_t seed = 0);

  // Of a critical point, by its place in the list: the records of its boundary, ascending. Empty for index 0.
  [[nodiscard]] std::span<const std::uint32_t> boundary(std::size_t record) const {
    return std::span(cells_).subspan(first_[record], first_[record + 1] - first_[record]);
  }
  // Of an index-2 point, by its number in UnstableManifolds: where its two orbits end, ties broken: maxima,
  // or kInfinity.
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
