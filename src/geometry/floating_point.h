// Checks that this thread computes with doubles as the filters' proofs assume: it rounds to nearest, keeps
// subnormals, and fuses no multiply-add. Some libraries set "flush to zero" for speed, which takes effect in every
// thread that loads them.
#pragma once

namespace flowcert::geometry {

// Throws std::runtime_error, with one line that says what is wrong. It costs some ten operations, and is called
// whenever a flow complex or a worker is made, and wherever they flow.
void require_ieee_doubles();

}  // namespace flowcert::geometry
