// PLY files, ascii and binary: refused in one line, or read; then rows are finite and survive XYZ.
#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

std::string complaint_of(Bytes bytes) { return complaint_about_points(bytes, "a.ply"); }

}  // namespace flowcert::fuzz
