// The pieces of stable and unstable sets: from the oracle's form to the fast implementation's, shape by shape, and in
// words.
//
// Guarantees: exact. Lists keep their order. Two sets are the same iff they compare equal in one form.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/pieces.h"
#include "oracle/stable_set.h"
#include "oracle/unstable_surface.h"

namespace flowcert::property {

using Ids = std::vector<std::size_t>;

Ids ids(const auto& names) { return Ids(names.begin(), names.end()); }

Corner<> to_fast(const oracle::Corner& corner);
EdgePart<> to_fast(const oracle::EdgePart& part);
Crossing<> to_fast(const oracle::Crossing& crossing);
Region<> to_fast(const oracle::Region& region);
BackwardSegment<> to_fast(const oracle::BackwardSegment& segment);
// Without the intervals that sectors begin at, since the sectors' corners give them.
StableSet<> to_fast(const oracle::PointSet& points, const oracle::StableSet& set);
UnstableSurface<> to_fast(const oracle::UnstableSurface& set);

// Sample pairs with an odd number of critical backs (FC-STAB-07). Returns nothing if a tie leaves the boundary open:
// a regular back, or a Voronoi vertex, which the pieces need not show.
std::optional<std::vector<Ids>> boundary_of(const StableSet<>& set, bool has_vertex);

std::string text_of(const RationalPoint& x);
std::string text_of(const Corner<>& corner);
std::string text_of(const Ids& names);
// A line for each piece.
std::string text_of(const StableSet<>& set);
std::string text_of(const UnstableSurface<>& set);

}  // namespace flowcert::property
