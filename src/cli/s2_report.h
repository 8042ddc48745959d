// What `flowcert compute --manifolds s2` reports: rows of the table, the paper's statistics, and the object
// `s2` of the summary (spec/formats.md, section 3).
#pragma once

#include "cli/u2_report.h"
#include "flowcert/stable_manifolds.h"

namespace flowcert::cli {

void print_s2_rows(const StationaryPoints& stationary, const StableManifolds& s2);

// The paper's Tables 3 and 4.
void print_s2_statistics(const StableStatistics& statistics);

[[nodiscard]] Json s2_field(const U2Choice& choice, const StationaryPoints& stationary,
                            const StableManifolds& s2);

}  // namespace flowcert::cli
