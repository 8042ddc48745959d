// XYZ files: refused in one line, or read; the oracle's own reader has the same rows or refuses too.
#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) {
  const std::string complaint = complaint_about_points(bytes, "a.xyz");
  return complaint.empty() ? complaint_against_oracle(bytes, "a.xyz") : complaint;
}

}  // namespace flowcert::fuzz
