// The two ways in which `flowcert compute` prints its result: a table, and the summary of spec/formats.md,
// section 3.
#pragma once

#include "cli/command.h"
#include "cli/compute_run.h"
#include "cli/u2_report.h"

namespace flowcert::cli {

// name: of the input, as a person calls it.
void print_compute_table(const std::string& name, const Input& input, const Measured& measured,
                         const U2Choice& choice);

void print_compute_summary(const Input& input, const Measured& measured, const U2Choice& choice);

}  // namespace flowcert::cli
