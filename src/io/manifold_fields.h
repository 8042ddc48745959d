// What records say of where the flow goes to and comes from (spec/formats/stationary_points.md): the pieces of stable
// and unstable sets, the object `lambda` and the array `connections`.
//
// Guarantees: rationals are exact, and doubles are the nearest ones.
#pragma once

#include <ostream>
#include <vector>

#include "flowcert/connections.h"
#include "flowcert/pieces.h"
#include "io/json_fields.h"

namespace flowcert::io {

// The object `skeleton` of a stationary point.
[[nodiscard]] Json skeleton_field(const StableSet<>& set);
// Writes the object `skeleton` of infinity, piece by piece: they are long.
void write_skeleton_of_infinity(std::ostream& out, const StableSet<>& set);
// The object `u1`.
[[nodiscard]] Json unstable_surface_field(const UnstableSurface<>& surface);

// With exact positions, and the doubles beside them.
[[nodiscard]] Json lambda_field(const StationaryPoints& stationary, const LambdaList& list);
// With doubles alone, or without positions.
[[nodiscard]] Json lambda_field(const StationaryPoints& stationary, const RoundedLambdaList& list, bool has_positions);

// The connections of one point.
[[nodiscard]] Json connections_field(const StationaryPoints& stationary, const std::vector<Connection>& connections);

}  // namespace flowcert::io
