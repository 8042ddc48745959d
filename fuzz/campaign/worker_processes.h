// Batches of a campaign by several processes on this machine.
//
// Guarantees: a case that ends its process, by a signal or by taking too long, becomes a counterexample, and the
// campaign goes on without it. A case that crashes is shrunk; each smaller one is tried in a process of its own. The
// first SIGKILL during a case is not the case's fault, and the batch is done again. No process is left when the call
// returns, or when this process is killed.
//
// Processes are used, not threads, because a case can end one, and because the lazy kernel's shared values make
// threads wait for each other.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/campaign/batch.h"

namespace flowcert::fuzz {

struct WorkOptions {
  unsigned jobs = 1;
  // A property that takes longer on one input hangs.
  double hang_seconds = 120;
  // Asked several times a second. When it is true, cases under way have a moment to be finished, and no others are
  // begun. If a case takes longer than that moment, its batch counts as not begun.
  std::function<bool()> is_stopped;
  // Told several times a second how many cases are done in the batches under way.
  std::function<void(std::size_t under_way)> progress;
};

// Works until no batch is left, or is_stopped. Throws what the source throws, std::system_error if no process can be
// started, and property::MachineFailure if a property does. No other thread may be running. While a source waits for
// its next batch, all workers wait; so such a source is for one job.
void work_on(BatchSource& source, const std::vector<property::Property>& properties, const WorkOptions& options);

}  // namespace flowcert::fuzz
