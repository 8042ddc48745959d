// OFF files: refused in one line, or read; then the rows are finite and the same when written and read again.
#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) { return complaint_about_points(bytes, "a.off"); }

}  // namespace flowcert::fuzz
