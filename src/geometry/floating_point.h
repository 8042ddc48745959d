// Whether this thread computes with doubles as the filters' proofs assume: rounding to nearest, with subnormals, and
// with no fused multiply-add. Libraries that set "flush to zero", as some do for speed, take effect in every thread
// that loads them.
#pragma once

namespace flowcert::geometry {

// Throws std::runtime_error, one line that says what is wrong. Some ten operations: it is asked whenever a flow
// complex or a worker is made, and wherever they flow.
void require_ieee_doubles();

}  // namespace flowcert::geometry
