// Inputs for orbits that are larger than those of the families of fuzz/inputs/families.h, and too large for the
// oracle's search for stationary points: its orbits cost one scan a segment, so they are fine.
//
// Guarantees: as families.h, but for the number of points, which does not depend on the size.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::property {

// Points of a lattice, of a dome (a grid-rounded half sphere over its rim: long cascades), of a lattice in a
// tilted plane, and in general position; a few hundred each.
std::vector<fuzz::Family> larger_families();

}  // namespace flowcert::property
