// Batches of a campaign by several processes on this machine.
//
// Guarantees: a process that a case ends, by a signal or by taking too long, is a counterexample, which names the
// case; the campaign goes on without it. What such a case has come down to is found by trying each smaller
// one in a process of its own. SIGKILL is no case's doing the first time: the batch is done again. No process
// is left when the call comes back, or when this process is killed.
//
// Processes, not threads: so that a case can end one, and because the lazy kernel's shared values make
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
  // Asked several times a second; when true, cases under way are finished and nothing more, and not even
  // those that take longer than a moment: their batches count as not begun.
  std::function<bool()> is_stopped;
  // Told several times a second: the cases of batches under way.
  std::function<void(std::size_t under_way)> progress;
};

// Until no batch is left, or is_stopped. Throws what the source throws, std::system_error if no process can
// be started, and property::MachineFailure where a property does. No other thread may be running. A source
// that waits for its next batch holds up all jobs: it is for one job.
void work_on(BatchSource& source, const std::vector<property::Property>& properties,
             const WorkOptions& options);

}  // namespace flowcert::fuzz
