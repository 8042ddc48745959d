// Reads the witnesses in the JSON of `flowcert cycles --witness --json` (FC-FILE-52).
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "oracle/witness.h"

namespace oracle {

// In the order of the file. `name` is for messages only. Throws UnusableInput for other text, and where a cycle has no
// witness.
std::vector<Witness> read_witnesses(std::istream& in, const std::string& name);

}  // namespace oracle
