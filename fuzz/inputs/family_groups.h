// The groups that the table of families is put together from, one source file each.
//
// Guarantees: none beyond families.h; only families.cpp and the sources of the groups include this.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::fuzz {

std::vector<Family> lattice_families();
std::vector<Family> spherical_families();
std::vector<Family> flat_families();
std::vector<Family> right_angle_families();
std::vector<Family> scan_families();
std::vector<Family> orbit_families();
std::vector<Family> rounding_families();
std::vector<Family> magnitude_families();

}  // namespace flowcert::fuzz
