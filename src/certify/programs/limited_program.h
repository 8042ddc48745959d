// A shell command under limits: of time, of memory, of the size of the files that it writes.
//
// Guarantees: whatever the command does, the call returns soon after the time limit or a cancellation. The command
// has a process group of its own. When the call returns, or soon after this process is killed, no process that it
// started is left, not even one that has left the group by setsid. (Two things escape: what another program starts for
// it, such as a daemon that was there before, and what a command starts that kills our process above it, by SIGKILL.)
// By run_limited, the command reads nothing, and writes to files, so that nobody blocks on a pipe. It gets no other
// descriptors, and signals at their defaults. No core is dumped.
//
// This is our own code over POSIX, since Debian's Boost.Process knows neither resource limits nor whether a group has
// come to its end. posix_spawn has no resource limits either.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "certify/layer.h"

namespace flowcert::certify {

// An open file, closed with the object.
class Descriptor {
 public:
  // None for a negative number.
  explicit Descriptor(int number) : number_(number) {}
  // Throws std::system_error.
  Descriptor(const std::string& path, int flags);
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  void close();

 private:
  int number_;
};

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
  // The exit status or the signal. A shell that exits with 128 + n, for n from 1 to 64, says that signal n ended its
  // program: that is taken as the signal (FC-FILE-29).
  int number = 0;
  double seconds = 0;
};

// Runs it by /bin/sh -c. is_cancelled is asked every few milliseconds. Throws std::system_error if no process can be
// started. May be called from several threads at once.
[[nodiscard]] ProgramEnd run_limited(const std::string& command, const ProgramPlaces& places,
                                     const ProgramLimits& limits, const std::function<bool()>& is_cancelled);

// ---- One that goes on ----
// A command that runs while this object lives, under the same limits but of time, and with the same guarantees.
class RunningCommand {
 public:
  // It gets these as its standard descriptors; they stay the caller's. Throws std::system_error.
  RunningCommand(const std::string& command, const std::string& directory, const std::array<int, 3>& standard,
                 const ProgramLimits& limits);
  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  // Whether it has ended by itself, and nothing that it started is left.
  [[nodiscard]] bool has_ended() const;
  // Ends it if it still runs, and says how it ended. Called once.
  ProgramEnd end();
  // A forked copy of this object lets the command be, which is its original's.
  void forget();

 private:
  struct Guarded;
  std::unique_ptr<Guarded> guarded_;  // none after its end
};

// "SIGSEGV"
[[nodiscard]] std::string signal_text(int number);

// ---- Signals ----
// A note of Ctrl-C, SIGTERM or SIGHUP that the program can ask for, while it has files to put away first.
//
// Guarantees: as long as an object lives, the first of these signals only leaves a note, and the next one ends the
// program; a signal that is ignored (nohup, a shell's background job) stays so. One object at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // The first signal that came; 0 if none has.
  [[nodiscard]] static int signal();
};

// Thrown when the work has stopped because of a signal.
struct Interrupted {
  int signal = 0;
};

}  // namespace flowcert::certify
