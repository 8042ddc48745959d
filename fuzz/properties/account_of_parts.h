// The parts of a flow complex that several threads make, with all that is counted on the way, as one text.
//
// Guarantees: two complexes of the same points and options have the same text exactly where all of these parts and
// counts are equal. Asking for it makes all parts.
#pragma once

#include <string>

#include "flowcert/flow_complex.h"

namespace flowcert::property {

[[nodiscard]] std::string account_of_parts(const FlowComplex& complex);

}  // namespace flowcert::property
