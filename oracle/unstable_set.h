// Which ways lead out of a stationary point y, and where they end, from the definitions alone (FC-UNST-01 to 03).
//
// Directions from y form a circle, an arc, two directions, one, or none. The limit of one is found by the orbit of a
// point just beyond y. Limits can change only at some directions, which break the arc. To find these, a family of rays
// is followed through Voronoi facets. All of its places are linear functions of one parameter, and one scan over all
// points finds where the rays leave a facet. Exact, for any finite point set of any dimension.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/pieces.h"
#include "oracle/stationary_points.h"

namespace oracle {

// One direction, or an open arc of them that turns counterclockwise, seen from the sample with the greater name. If
// the arc is the whole circle, it has no ends.
struct UnstableEntry {
  bool is_arc = false;
  std::optional<Direction> from, to;     // the same for one direction
  std::optional<StationaryPoint> limit;  // nothing: infinity

  friend bool operator==(const UnstableEntry&, const UnstableEntry&) = default;
};

// The points of C(y) on the face of conv C(y) that has y in its relative interior: F of FC-UNST-01.
Places face_of(const PointSet& set, const StationaryPoint& y);

// The edge at which a polygon is obtuse (FC-SIGN-01), by places. Throws std::logic_error if there is none.
std::array<std::size_t, 2> obtuse_edge(const PointSet& set, const Places& polygon);

// The λ-list of y (FC-UNST-02). Arcs and single directions take turns. A list of index 1 goes around the circle, and
// begins with its least direction, in lexicographic order. For an index-2 point it has side 0 and then side 1. It is
// empty for index 3. Throws std::invalid_argument for index 0, from which all directions lead.
std::vector<UnstableEntry> lambda_list(const PointSet& set, const StationaryPoint& y);

}  // namespace oracle
