// Groups of families that measured_families.cpp defines and families.cpp puts into its table.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::fuzz {

std::vector<Family> scan_families();
std::vector<Family> rounding_families();
std::vector<Family> magnitude_families();

}  // namespace flowcert::fuzz
