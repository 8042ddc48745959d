// Where the conformance vectors are if nobody says.
#pragma once

#include <string>

#include "certify/layer.h"

namespace flowcert::certify {

// The folder beside an installed program, or else in the tree that the program was built from.
[[nodiscard]] std::string usual_vectors_folder();

}  // namespace flowcert::certify
