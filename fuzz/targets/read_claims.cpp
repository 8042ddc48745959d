// Claims in one format: refused in one line, or read and judged.
#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) { return complaint_about_claim(bytes, FLOWCERT_FORMAT); }

}  // namespace flowcert::fuzz
