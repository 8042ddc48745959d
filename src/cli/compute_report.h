// What `flowcert compute` prints: a table, or the summary of src/cli/manual/summary.md. The paper's tables of
// statistics are added if they are asked for.
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/compute_run.h"
#include "cli/table.h"
#include "flowcert/flow_statistics.h"
#include "flowcert/stable_manifolds.h"
#include "io/json_fields.h"

namespace flowcert::cli {

// ---- U2 ----
// Rows of the table, the paper's tables of statistics, and the object `u2` of the summary.

struct U2Choice {
  FlowChoice flow;
  bool alone = false;
  bool with_statistics = false;

  [[nodiscard]] FlowOptions options() const {
    FlowOptions options = flow.options();
    options.share = !alone;
    return options;
  }
};

// Prints where the orbits end.
void print_u2_rows(const FlowStatistics& statistics);

// The paper's Tables 1, 3, 4 and 5, and Figure 12.
void print_u2_statistics(const FlowStatistics& statistics);

[[nodiscard]] Json u2_field(const U2Choice& choice, const FlowStatistics& statistics);

// ---- S2 ----
// Rows of the table, the paper's statistics, and the object `s2` of the summary.
void print_s2_rows(const StationaryPoints& stationary, const StableManifolds& s2);

// The paper's Tables 3 and 4.
void print_s2_statistics(const StableStatistics& statistics);

[[nodiscard]] Json s2_field(const U2Choice& choice, const StationaryPoints& stationary, const StableManifolds& s2);

// ---- What both share ----
// The reports of U2 and S2 share distributions and filter failures, in JSON and in tables.

// count, mean, max, stddev, mode, median, histogram (src/cli/manual/summary.md).
[[nodiscard]] Json distribution_field(const Distribution& distribution);
// Calls and failures of each primitive, by its name.
[[nodiscard]] Json primitives_field(const KernelTally& tally);

// A table with a row for each distribution: name, count, mean, max, stddev, mode, median.
[[nodiscard]] Table distribution_table();
void add_distribution(Table& table, const char* name, const Distribution& distribution);
// The paper's Table 4.
void print_primitives(const KernelTally& tally);

// ---- The whole ----
// name: the display_name() of the input.
void print_compute_table(const std::string& name, const Input& input, const Measured& measured, const U2Choice& choice);

[[nodiscard]] Json compute_summary(const Input& input, const Measured& measured, const U2Choice& choice);
void print_compute_summary(const Input& input, const Measured& measured, const U2Choice& choice);

}  // namespace flowcert::cli
