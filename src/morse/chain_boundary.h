// The boundary of an index-2 cell in the chain complex, where ties have to be broken.
//
// Guarantees: with every tie broken as spec clause FC-CHAIN-02 allows, the boundary is a chain of index-1
// points, and persistence is that of the alpha complex, whatever the choice; the choice is reproducible.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "morse/backward_walk.h"
#include "morse/tie_breaking.h"

namespace flowcert::morse {

// Records of index 1, some of them several times. root: the centre of the polygon with these samples.
[[nodiscard]] std::vector<std::uint32_t> tie_broken_boundary(const VoronoiFaces& faces, BackwardWalk& walk,
                                                             FrontNumber root,
                                                             std::span<const VertexIndex> samples,
                                                             TieBreaking& ties);

// Appends what is there an odd number of times, ascending. Sorts `chain`.
void add_mod_2(std::vector<std::uint32_t>& chain, std::vector<std::uint32_t>& sum);

}  // namespace flowcert::morse
