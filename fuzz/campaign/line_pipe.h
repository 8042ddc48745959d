// Lines of text between two processes of one machine.
//
// Guarantees: a line arrives whole or not at all; both ends learn when the other one is gone, if SIGPIPE is
// ignored. A program that is started gets none of the descriptors.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace flowcert::fuzz {

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

// False if the other end is gone.
[[nodiscard]] bool write_line(int descriptor, const std::string& line);

class LineReader {
 public:
  explicit LineReader(int descriptor) : descriptor_(descriptor) {}

  // Takes what is there, and waits if nothing is. False at the end.
  [[nodiscard]] bool read_more();
  // Of what has been taken.
  [[nodiscard]] std::optional<std::string> next_line();

 private:
  int descriptor_;
  std::string text_;
};

}  // namespace flowcert::fuzz
