// The process of a rank that does its batches, and the options of `flowcert-fuzz-mpi`.
#pragma once

#include <sys/types.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/campaign/child_process.h"
#include "fuzz/commands/fuzz_options.h"

namespace flowcert::commands {

// The options of `flowcert fuzz`, and how long a rank may be silent.
struct FuzzMpiOptions : FuzzOptions {
  // Each rank says every second that it is there, whatever it is working on.
  double silence_seconds = 30;

  [[nodiscard]] double heartbeat_seconds() const { return std::min(1.0, silence_seconds / 5); }
};

// The process of a rank that does its batches.
//
// Guarantees: it is started before MPI is, and does not use MPI, so it may fork as it likes. A case that ends a
// process ends a child of this one, and never a rank. It ends with its rank.
//
// Lines to it: "plan PLAN" first, then "order ORDER" (batch.h), one at a time. "stop", or the end of its lines, ends
// it after the case under way. Lines from it: "ready VERSION", "cases N" of the batch under way, "gone WHY" if it
// cannot go on, and the messages of batch.h.
class BatchProcess {
 public:
  // Throws std::system_error.
  explicit BatchProcess(const FuzzOptions& options);
  ~BatchProcess();
  BatchProcess(const BatchProcess&) = delete;
  BatchProcess& operator=(const BatchProcess&) = delete;

  void give(const std::string& line);
  // The lines that are there, or come within so many milliseconds.
  [[nodiscard]] std::vector<std::string> lines(int milliseconds);
  [[nodiscard]] bool has_ended() const { return has_ended_; }

 private:
  fuzz::Pipe to_it_, from_it_;
  fuzz::LineReader reader_{-1};
  pid_t process_ = -1;
  bool has_ended_ = false;
};

}  // namespace flowcert::commands
