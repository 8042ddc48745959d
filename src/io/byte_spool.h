// Bytes that are kept until a file takes them: the first ones in memory, more of them on disk.
//
// Guarantees: it takes O(1) memory. The file that it makes in the folder has no name, so that nothing is left of it
// however the program ends. Every failed write or read throws OutputError.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "io/layer.h"
#include "io/number_text.h"

namespace flowcert::io {

class ByteSpool {
 public:
  // The folder must exist when there are many bytes.
  explicit ByteSpool(std::string folder) : folder_(std::move(folder)) {}
  ~ByteSpool();
  ByteSpool(const ByteSpool&) = delete;
  ByteSpool& operator=(const ByteSpool&) = delete;

  template <class Number>
  void append(Number number) {
    append_little_endian(latest_, number);
    if (latest_.size() >= kPiece) store();
  }
  [[nodiscard]] std::uint64_t size() const { return stored_ + latest_.size(); }
  void copy_to(std::ostream& out) const;

 private:
  static constexpr std::size_t kPiece = 1 << 18;

  void store();
  [[noreturn]] void fail() const;

  std::string folder_;
  std::string latest_;
  int file_ = -1;
  std::uint64_t stored_ = 0;
};

}  // namespace flowcert::io
