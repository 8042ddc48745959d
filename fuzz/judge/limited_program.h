// A shell command under limits: of time, of memory, of the size of the files that it writes.
//
// Guarantees: whatever the command does, the call comes back: soon after the time limit, or after a
// cancellation. The command is a process group of its own, and when the call comes back no process of that
// group is left, the command's background children included. (A process that leaves the group, by setsid, is
// not found again.) They end as well when this process is killed. The command reads nothing, and writes to
// files, so that nobody blocks on a pipe; it gets no descriptors but these, and signals at their defaults. No
// core is dumped.
//
// Our own over POSIX: Boost.Process, which Debian has, knows neither resource limits nor whether a group has
// come to its end. posix_spawn has no resource limits either.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "fuzz/judge/layer.h"

namespace flowcert::judge {

struct ProgramLimits {
  double seconds = 10;
  std::uint64_t memory_bytes = 0;  // of address space, for each process; 0: no limit
  std::uint64_t file_bytes = std::uint64_t{64} << 20;
};

struct ProgramPlaces {
  std::string directory;  // in which it runs
  std::string standard_output;
  std::string standard_error;
};

enum class ProgramEnding { kExited, kSignalled, kTimedOut, kCancelled };

struct ProgramEnd {
  ProgramEnding ending = ProgramEnding::kExited;
  // The exit status or the signal. A shell that exits with 128 + n says that signal n ended its program: that
  // is taken as the signal.
  int number = 0;
  double seconds = 0;
};

// By /bin/sh -c. is_cancelled is asked every few milliseconds. Throws std::system_error if no process can be
// started. May be called from several threads at once.
[[nodiscard]] ProgramEnd run_limited(const std::string& command, const ProgramPlaces& places,
                                     const ProgramLimits& limits, const std::function<bool()>& is_cancelled);

// "SIGSEGV"
[[nodiscard]] std::string signal_text(int number);

// ---- Signals ----
// Ctrl-C, SIGTERM and SIGHUP as something to ask for, while there is something to put away first.
//
// Guarantees: as long as an object lives, these signals only leave a note; a signal that is ignored (nohup, a
// shell's background job) stays so. One object at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // The first signal that came; 0 if none has.
  [[nodiscard]] static int signal();
};

// Thrown where the work has stopped because of it.
struct Interrupted {
  int signal = 0;
};

}  // namespace flowcert::judge
