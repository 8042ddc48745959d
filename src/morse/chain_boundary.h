// The boundary of an index-2 cell in the chain complex, where ties have to be broken, and the choices that a tie
// leaves open.
//
// Guarantees: every tie is broken as spec clause FC-CHAIN-02 allows. The boundary is then a chain of index-1 points,
// and persistence is the alpha complex's, whatever the choices are. The choices are reproducible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mixed_bits.h"
#include "morse/backward_walk.h"
#include "morse/layer.h"

namespace flowcert::morse {

// Chooses always the first way, or at random but reproducibly.
class TieBreaking {
 public:
  enum class Of : std::uint8_t { kUnstable, kStable };

  // With seed 0 it always chooses the first way. The choices for U2 and for S2 with one seed are independent.
  TieBreaking(std::uint64_t seed, Of which)
      : state_(which == Of::kUnstable ? seed : seed ^ 0xd1342543de82ef95u), is_random_(seed != 0) {}

  // One of 0 to count - 1. SplitMix64, so that the choices are the same with every standard library.
  [[nodiscard]] std::size_t choose(std::size_t count) {
    if (!is_random_ || count < 2) return 0;
    const std::uint64_t dice = geometry::mixed_bits(state_);
    state_ += geometry::kSplitMixStep;
    return static_cast<std::size_t>(dice % count);
  }

 private:
  std::uint64_t state_;
  bool is_random_;
};

// Returns the steps of the walk, each after that which leads to its front. Those that end at index-1 points are the
// boundary, where one may come twice, from two sides. root is the centre of the polygon with these samples.
[[nodiscard]] std::vector<BackwardWalk::Step> tie_broken_walk(const VoronoiDiagram& diagram, BackwardWalk& walk,
                                                              FrontNumber root, std::span<const VertexIndex> samples,
                                                              TieBreaking& ties);

// Sorts `chain` and appends to `sum`, ascending, what is in `chain` an odd number of times.
void add_mod_2(std::vector<std::uint32_t>& chain, std::vector<std::uint32_t>& sum);

}  // namespace flowcert::morse
