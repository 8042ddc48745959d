// Distributions and filter failures, in JSON and in tables: what the reports of U2 and S2 share.
#pragma once

#include <string>
#include <vector>

#include "flowcert/flow_statistics.h"
#include "io/json_fields.h"

namespace flowcert {

// count, mean, max, stddev, mode, median, histogram (spec/formats.md, section 3).
[[nodiscard]] Json distribution_field(const Distribution& distribution);
// By name: calls, failures.
[[nodiscard]] Json primitives_field(const KernelTally& tally);

// A row for print_columns(): name, count, mean, max, stddev, mode, median.
[[nodiscard]] std::vector<std::string> distribution_cells(const std::string& name,
                                                          const Distribution& distribution);
// The paper's Table 4.
void print_primitives(const KernelTally& tally);

}  // namespace flowcert
