// What came of a campaign, for people and for programs, on standard output.
#pragma once

#include <optional>

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

struct FuzzRun {
  const fuzz::Campaign& campaign;
  // Of this run: none where nothing was run, as of merged parts.
  std::optional<double> seconds;
  std::size_t cases = 0;
  unsigned jobs = 1;
  bool is_interrupted = false;
};

void print_fuzz(const FuzzRun& run, bool json);

// Of one case alone, which is done; the exit status.
[[nodiscard]] int print_case(const fuzz::Campaign& campaign, const fuzz::OneCase& one, bool json);

// The exit status: whether a case failed.
[[nodiscard]] int verdict_of(const fuzz::Campaign& campaign);

}  // namespace flowcert::commands
