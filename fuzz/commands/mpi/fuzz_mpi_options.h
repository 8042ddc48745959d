// The options of `flowcert-fuzz-mpi`: those of `flowcert fuzz`, and how long a rank may be silent.
#pragma once

#include <algorithm>

#include "fuzz/commands/fuzz_options.h"

namespace flowcert::commands {

struct FuzzMpiOptions : FuzzOptions {
  // Each rank says every second that it is there, whatever it is working on.
  double silence_seconds = 30;

  [[nodiscard]] double heartbeat_seconds() const { return std::min(1.0, silence_seconds / 5); }
};

}  // namespace flowcert::commands
