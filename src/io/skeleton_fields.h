// Stable sets in JSON (spec/formats.md, section 2).
#pragma once

#include "flowcert/stable_manifolds.h"
#include "io/json_fields.h"

namespace flowcert::io {

// The object `stable`: what is known of the i-th set without its geometry.
[[nodiscard]] Json stable_field(const StationaryPoints& stationary, const StableManifolds& s2, std::size_t i);

// The object `skeleton`.
[[nodiscard]] Json skeleton_field(const StableSet& set);

}  // namespace flowcert::io
