// What `flowcert compute --manifolds u2` reports: rows of the table, the paper's tables of statistics, and
// the object `u2` of the summary (spec/formats.md, section 3).
#pragma once

#include "cli/flow_options.h"
#include "flowcert/flow_statistics.h"
#include "io/json_fields.h"

namespace flowcert::cli {

struct U2Choice {
  FlowChoice flow;
  bool alone = false;
  bool with_statistics = false;
};

// Where the orbits end.
void print_u2_rows(const FlowStatistics& statistics);

// The paper's Tables 1, 3, 4 and 5, and Figure 12.
void print_u2_statistics(const FlowStatistics& statistics);

[[nodiscard]] Json u2_field(const U2Choice& choice, const FlowStatistics& statistics);

}  // namespace flowcert::cli
