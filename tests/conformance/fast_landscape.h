// What the fast implementation says of locations, merge trees, pockets, the medial axis, infinity, statistics and
// claims of cycles, in the form of the conformance vectors.
//
// Guarantees: what is asked of it, positions, persistences, probes, angles and claims, is read from what a case expects,
// and nothing else is.
#pragma once

#include "flowcert/flow_complex.h"
#include "tests/conformance/vector_files.h"

namespace flowcert::conformance {

// Adds the keys that `expected` has of these: merge_trees, pockets, medial_axes, infinity, statistics, cycles, locations.
void add_fast_landscape(const FlowComplex& complex, const Json& expected, Json& answer);

}  // namespace flowcert::conformance
