// Reports what a campaign has found, for people and for programs, on standard output.
#pragma once

#include <optional>

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/known_findings.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

struct FuzzRun {
  const fuzz::Campaign& campaign;
  const KnownFindings& known;
  // The seconds of this run. None if nothing was run, as when parts are merged.
  std::optional<double> seconds;
  std::size_t cases = 0;
  unsigned jobs = 1;
  bool is_interrupted = false;
};

void print_fuzz(const FuzzRun& run, bool json);

// Reports one case, which is done, and returns the exit status.
[[nodiscard]] int print_case(const fuzz::Campaign& campaign, const fuzz::OneCase& one, bool json);

// The exit status, which says whether there is a finding that the known ones do not explain.
[[nodiscard]] int verdict_of(const FuzzRun& run);

}  // namespace flowcert::commands
