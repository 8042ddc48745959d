// What `flowcert compute` prints: a table, or the summary of src/cli/manual/summary.md. The paper's tables of
// statistics are added if they are asked for.
#pragma once

#include <string>

#include "cli/command.h"
#include "cli/compute_run.h"
#include "cli/table.h"
#include "flowcert/flow_statistics.h"
#include "io/json_fields.h"

namespace flowcert::cli {

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

// count, mean, max, stddev, mode, median, histogram (src/cli/manual/summary.md).
[[nodiscard]] Json distribution_field(const Distribution& distribution);

// A table with a row for each distribution: name, count, mean, max, stddev, mode, median.
[[nodiscard]] Table distribution_table();
void add_distribution(Table& table, const char* name, const Distribution& distribution);

void print_compute_table(const Input& input, const Measured& measured, const U2Choice& choice);
[[nodiscard]] Json compute_summary(const Input& input, const Measured& measured, const U2Choice& choice);
void print_compute_summary(const Input& input, const Measured& measured, const U2Choice& choice);

}  // namespace flowcert::cli
