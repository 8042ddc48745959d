// Where the conformance vectors are if nobody says.
#pragma once

#include <string>

#include "fuzz/judge/layer.h"

namespace flowcert::judge {

// The folder beside an installed program, or else in the tree that the program was built from.
[[nodiscard]] std::string usual_vectors_folder();

}  // namespace flowcert::judge
