// Families made for stable sets: an input of most others has none with the parts that these nearly always
// have.
//
// Guarantees: as families.h. They are a list of their own, not members of families(): the numbered cases of
// case_stream.h take turns over that list, and an id names its input for good.
#pragma once

#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::fuzz {

const std::vector<Family>& stable_families();

// families(), and then these.
std::vector<Family> families_and_stable_ones();

}  // namespace flowcert::fuzz
