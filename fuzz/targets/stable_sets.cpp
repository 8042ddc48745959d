// Stable sets, index-2 and regular, of up to 8 points: both kernels give the oracle's, piece by piece.
#include "fuzz/properties/property.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) {
  return complaint_of({"stable-sets", "stable-kernels"}, {input_of_bytes(bytes, 8), property::StartChoice{}});
}

}  // namespace flowcert::fuzz
