// A file that appears whole or not at all. It is written under a temporary name in the same directory, and renamed
// when it is complete.
//
// Guarantees: until commit() has returned, the target is what it was. The temporary file goes away with the object,
// also on Ctrl-C, SIGTERM and a closed pipe, whichever thread is given the signal. Every failed write throws
// OutputError, also on a full disk.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include "io/layer.h"

namespace flowcert::io {

// One line that names the file and why it cannot be written.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

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

  std::string path_;
  std::string temporary_;
  std::ofstream stream_;
};

}  // namespace flowcert::io
