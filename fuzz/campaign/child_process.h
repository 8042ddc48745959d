// Processes that are forked to work for this one, and lines of text between two processes of one machine.
#pragma once

#include <sys/types.h>

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace flowcert::fuzz {

// ---- Lines ----
// Guarantees: a line arrives whole or not at all; both ends learn when the other one is gone, if SIGPIPE is
// ignored. A program that is started gets none of the descriptors.

class Pipe {
 public:
  // Throws std::system_error.
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }
  void close_reading() { close_end(ends_[0]); }
  void close_writing() { close_end(ends_[1]); }

 private:
  static void close_end(int& end);

  std::array<int, 2> ends_{-1, -1};
};

// False if it cannot be written, as where the other end is gone.
[[nodiscard]] bool write_line(int descriptor, const std::string& line);

class LineReader {
 public:
  explicit LineReader(int descriptor) : descriptor_(descriptor) {}

  // Takes what is there, and waits if nothing is. False at the end.
  [[nodiscard]] bool read_more();
  // The next whole line of what has been taken.
  [[nodiscard]] std::optional<std::string> next_line();

 private:
  int descriptor_;
  std::string text_;
};

// ---- Processes ----
// Guarantees: a child ends when its parent does, for whatever reason, and leaves Ctrl-C, SIGTERM and SIGHUP to the
// parent. An exception in its work ends it as a crash does, so no destructor undoes there what the parent has done.
// Does the work in a new process, which then ends with 0. Throws std::system_error.
[[nodiscard]] pid_t start_child(const std::function<void()>& work);

// Waits for the end of the child, and returns its status as waitpid gives it.
int wait_for_end(pid_t child);

}  // namespace flowcert::fuzz
