// Numbers written to a stream as little-endian bytes, in pieces, so that a large file is not held in memory.
#pragma once

#include <ostream>
#include <string>

#include "io/layer.h"
#include "io/number_text.h"

namespace flowcert::io {

class ByteWriter {
 public:
  // The stream must outlive it.
  explicit ByteWriter(std::ostream& out) : out_(out) {}
  ~ByteWriter() { flush(); }
  ByteWriter(const ByteWriter&) = delete;
  ByteWriter& operator=(const ByteWriter&) = delete;

  template <typename Number>
  void append(Number number) {
    append_little_endian(bytes_, number);
    if (bytes_.size() >= kPiece) flush();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 16;

  void flush() {
    out_ << bytes_;
    bytes_.clear();
  }

  std::ostream& out_;
  std::string bytes_;
};

}  // namespace flowcert::io
