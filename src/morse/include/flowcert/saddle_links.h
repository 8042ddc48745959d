// What lies below and above each critical point of index 2, as far as persistence asks for it.
//
// Guarantees: exact, on every input. Below is the boundary in the chain complex. Above, at each of the two sides, is
// one of the maxima in the component of {d^2 > s} there, where s is the point's value, or infinity. Pairs need no more
// than that component, and so not U2: paths over Voronoi edges find it (spec clauses FC-TREE-03 and 04).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/chain_complex.h"

namespace flowcert {

class SaddleLinks {
 public:
  static constexpr std::uint32_t kInfinity = ChainComplex::kInfinity;

  // All arguments are of one diagram; nothing of them is kept. O(Delaunay cells, and all boundaries). It is the same
  // for any number of threads.
  SaddleLinks(const VoronoiDiagram& diagram, const StationaryPoints& stationary, const StableManifolds& stable,
              unsigned threads = 1);
  // The maxima are those at which U2 ends, as the chain complex has them. O(cells of the complex).
  SaddleLinks(const StationaryPoints& stationary, const ChainComplex& complex);

  // Critical points of index 2, in the order of the list.
  [[nodiscard]] std::size_t size() const { return upper_.size(); }
  // Records of index 1, mod 2, ascending.
  [[nodiscard]] std::span<const std::uint32_t> lower(std::size_t i) const {
    return std::span(cells_).subspan(first_[i], first_[i + 1] - first_[i]);
  }
  // Each is the record of a maximum, or kInfinity.
  [[nodiscard]] const std::array<std::uint32_t, 2>& upper(std::size_t i) const { return upper_[i]; }
  // Prefetches where lower(i) is, for those who go through points in another order.
  [[gnu::always_inline]] void prefetch_lower(std::size_t i) const { __builtin_prefetch(&first_[i]); }

 private:
  void copy_boundaries(const auto& boundary_of, unsigned threads);

  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::array<std::uint32_t, 2>> upper_;
};

}  // namespace flowcert
