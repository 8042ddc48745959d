// Cycles as text for other programs (spec/formats/cycles.md).
//
// Guarantees: rationals are exact, doubles are the nearest ones, but for lengths of loops (FC-FILE-52). The text depends
// on the points and what is asked for alone.
#pragma once

#include <ostream>
#include <vector>

#include "flowcert/flow_complex.h"
#include "io/cycles.h"

namespace flowcert {

struct CyclesToWrite {
  const FlowComplex& complex;
  int dimension = 1;
  const std::vector<Cycle>& cycles;
  bool has_witness = false;  // for dimension 1: each cycle with its witness (FC-CYC-08)
};

// One JSON object, written cycle by cycle. Makes volumes for dimension 2.
void write_cycles(std::ostream& out, const CyclesToWrite& what);

}  // namespace flowcert
