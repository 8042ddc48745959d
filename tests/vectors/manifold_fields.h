// Stable and unstable sets, what connects stationary points, and persistence pairs in JSON, with the keys of
// spec/formats/vectors.md.
//
// Guarantees: exact; keys in the order of the format.
#pragma once

#include <vector>

#include "oracle/connections.h"
#include "oracle/persistence.h"
#include "oracle/program/answer_fields.h"
#include "oracle/stable_set.h"
#include "oracle/unstable_surface.h"

namespace oracle::vectors {

// segments, has_vertex, has_interval, boundary, walk. z must be critical of index 2 or regular stationary.
Json stable_field(const PointSet& set, const StationaryPoint& z, const StableSet& stable);
// segments, intervals, sectors.
Json skeleton_field(const PointSet& set, const StableSet& stable);
// directions, arcs. `list` is the λ-list of y.
Json lambda_field(const PointSet& set, const StationaryPoint& y, const std::vector<UnstableEntry>& list);
// An array of to, orbits, families, of those connections that lead from y.
Json connections_field(const StationaryPoint& y, const std::vector<Connection>& all);
// vertices, traces, runs, sheets, segments.
Json unstable_surface_field(const UnstableSurface& surface);
// An array of pairs: a sample, and its share, if that is not 0. `shares` has one for each point of the set.
Json shares_field(const PointSet& set, const std::vector<Rational>& shares);
// An array of dimension, birth, death.
Json persistence_field(const std::vector<PersistencePair>& pairs);

}  // namespace oracle::vectors
