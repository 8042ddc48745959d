// Distributions and filter failures, in JSON and in tables: what the reports of U2 and S2 share.
#pragma once

#include <string>

#include "cli/table.h"
#include "flowcert/flow_statistics.h"
#include "io/json_fields.h"

namespace flowcert::cli {

// count, mean, max, stddev, mode, median, histogram (spec/formats.md, section 3).
[[nodiscard]] Json distribution_field(const Distribution& distribution);
// By name: calls, failures.
[[nodiscard]] Json primitives_field(const KernelTally& tally);

// A table of distributions, a row each: name, count, mean, max, stddev, mode, median.
[[nodiscard]] Table distribution_table();
void add_distribution(Table& table, const char* name, const Distribution& distribution);
// The paper's Table 4.
void print_primitives(const KernelTally& tally);

}  // namespace flowcert::cli
