// What `flowcert compute --manifolds all` says of λ-lists, connections and volumes, and whether the input is
// Morse-Smale.
#pragma once

#include "cli/layer.h"
#include "flowcert/flow_complex.h"
#include "io/json_fields.h"

namespace flowcert::cli {

void print_whole_complex_rows(const FlowComplex& complex);

// The object `whole_complex` of the summary (src/cli/manual/summary.md).
[[nodiscard]] Json whole_complex_field(const FlowComplex& complex);

}  // namespace flowcert::cli
