// What GMP does where memory ends. By itself it prints a line and aborts the process.
//
// Guarantees: after let_gmp_fail_as_new_does(), GMP calls the new-handler, or throws std::bad_alloc where there is
// none. Numbers stay as they were. Debian builds GMP with tables for unwinding, so that exceptions pass through it;
// what GMP had for itself at that moment is not given back. Functions that somebody else has set stay. Programs and the
// Python module call it once, at their start. The C++ library leaves this choice to the program that it is part of.
#pragma once

namespace flowcert::geometry {

void let_gmp_fail_as_new_does();

}  // namespace flowcert::geometry
