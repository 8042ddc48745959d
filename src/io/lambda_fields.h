// What records of the whole complex say of where their directions lead (spec/formats/stationary_points.md): the object
// `lambda` and the array `connections`.
//
// Guarantees: rationals are exact, and doubles are the nearest ones.
#pragma once

#include <vector>

#include "flowcert/connections.h"
#include "io/json_fields.h"

namespace flowcert::io {

// With exact positions, and the doubles beside them.
[[nodiscard]] Json lambda_field(const StationaryPoints& stationary, const LambdaList& list);
// With doubles alone, or without positions.
[[nodiscard]] Json lambda_field(const StationaryPoints& stationary, const RoundedLambdaList& list, bool has_positions);

// The connections of one point.
[[nodiscard]] Json connections_field(const StationaryPoints& stationary, const std::vector<Connection>& connections);

}  // namespace flowcert::io
