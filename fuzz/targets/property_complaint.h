// The properties of campaigns, for targets.
#pragma once

#include <initializer_list>
#include <string>

#include "fuzz/properties/property.h"

namespace flowcert::fuzz {

// The complaint of the first of the named properties that does not hold, with the input as rows of a point file.
// Empty if all hold. The names must exist.
[[nodiscard]] std::string complaint_of(std::initializer_list<const char*> properties, const property::Trial& trial);

}  // namespace flowcert::fuzz
