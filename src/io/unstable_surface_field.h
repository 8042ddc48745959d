// The unstable set of a stationary point, written: the object `u1` (spec/formats/stationary_points.md).
//
// Guarantees: all numbers are exact, and all lists are in the order of UnstableSurface.
#pragma once

#include "flowcert/unstable_surfaces.h"
#include "io/json_fields.h"

namespace flowcert::io {

[[nodiscard]] Json unstable_surface_field(const UnstableSurface& surface);

}  // namespace flowcert::io
