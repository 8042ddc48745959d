// Point files of one format: refused in one line, or read; then XYZ keeps the rows, and the oracle's reader agrees.
#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) { return complaint_about_points(bytes, "a." FLOWCERT_FORMAT); }

}  // namespace flowcert::fuzz
