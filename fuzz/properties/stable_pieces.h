// The pieces of a stable set, segments, intervals and sectors, as either implementation has them, in one
// form.
//
// Guarantees: exact. Two sets are the same iff their pieces compare equal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "oracle/stable_set.h"

namespace flowcert::property {

using Ids = std::vector<std::size_t>;
using SegmentKey = std::tuple<Ids, RationalPoint, RationalPoint, Ids, Ids, std::string>;
using IntervalKey = std::tuple<Ids, RationalPoint, RationalPoint, bool>;
using SectorKey = std::tuple<Ids, std::vector<RationalPoint>>;

// A stable set as either implementation has it.
struct Pieces {
  std::vector<SegmentKey> segments;
  std::vector<IntervalKey> intervals;
  std::vector<SectorKey> sectors;

  void sort() {
    std::sort(segments.begin(), segments.end());
    std::sort(intervals.begin(), intervals.end());
    std::sort(sectors.begin(), sectors.end());
  }
  friend bool operator==(const Pieces&, const Pieces&) = default;
};

Ids ids(const auto& names) { return Ids(names.begin(), names.end()); }

Pieces pieces_of(const StableSet& set);
// The oracle also lists intervals that sectors come through. They are left out, since the sectors' corners tell them.
Pieces pieces_of(const oracle::PointSet& points, const oracle::StableSet& set);

// Sample pairs with an odd number of critical backs (FC-STAB-07). Returns nothing if a tie leaves the boundary open:
// a regular back, or a Voronoi vertex, which the pieces need not show.
std::optional<std::vector<Ids>> boundary_of(const Pieces& pieces, bool has_vertex);

std::string text_of(const RationalPoint& x);
std::string text_of(const Ids& names);
// A line for each piece.
std::string text_of(const Pieces& pieces);

}  // namespace flowcert::property
