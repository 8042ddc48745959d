// Stationary points of up to 12 points: the fast answer is the oracle's, and breaks no clause by itself.
#include "fuzz/properties/stationary_comparison.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) { return property::compare(input_of_bytes(bytes, 12)).complaint; }

}  // namespace flowcert::fuzz
