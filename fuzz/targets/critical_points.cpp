// Stationary points of up to 12 points: the fast answer is the oracle's, and breaks no clause by itself.
#include "fuzz/properties/property.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) {
  return complaint_of({"critical-points"}, {input_of_bytes(bytes, 12), property::StartChoice{}});
}

}  // namespace flowcert::fuzz
