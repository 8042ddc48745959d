// Inputs for orbits, larger than those of the families of fuzz/inputs/families.h. They are too large for the
// oracle's search for stationary points, but not for its orbits, which cost one scan a segment.
//
// Guarantees: those of families.h, except that the number of points does not depend on the size.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::property {

// Inputs of a few hundred points each: of a lattice, of a dome (a grid-rounded half sphere over its rim, with
// long cascades), of a lattice in a tilted plane, and in general position.
std::vector<fuzz::Family> larger_families();

}  // namespace flowcert::property
