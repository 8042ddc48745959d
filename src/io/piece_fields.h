// The pieces of stable and unstable sets in JSON (spec/formats/stationary_points.md).
//
// Guarantees: positions are written exactly.
#pragma once

#include <ostream>

#include "flowcert/pieces.h"
#include "io/json_fields.h"

namespace flowcert::io {

// The object `skeleton` of a stationary point.
[[nodiscard]] Json skeleton_field(const StableSet<>& set);
// Writes the object `skeleton` of infinity, piece by piece: they are long.
void write_skeleton_of_infinity(std::ostream& out, const StableSet<>& set);
// The object `u1`.
[[nodiscard]] Json unstable_surface_field(const UnstableSurface<>& surface);

}  // namespace flowcert::io
