// A file that appears whole or not at all. It is written under a temporary name in the same directory, and renamed
// when it is complete.
//
// Guarantees: until commit() has returned, the target is what it was. The temporary file goes away with the object,
// also on Ctrl-C, SIGTERM, a closed pipe, abort() and a limit of processor time, whichever thread is given the signal.
// Every failed write throws OutputError, also on a full disk and at a limit of files' sizes.
// A target that this process has read is refused (input_bytes.h). Symbolic links are followed. A file that is replaced
// keeps its mode and its owner; a warning says it where the owner cannot be kept.
#pragma once

#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include "io/layer.h"

namespace flowcert::io {

// One line that names the file and why it cannot be written.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Removes the temporary files of all outputs that are not complete, and lets none be made: for the end of a process.
// It takes no memory, and a signal handler may call it.
void remove_temporaries();

class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }
  // Call once, when all is written.
  void commit();

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;    // for messages
  std::string target_;  // where its links lead to
  std::string temporary_;
  std::ofstream stream_;
};

// Makes the file of what `write` puts into its stream.
void write_whole_file(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace flowcert::io
