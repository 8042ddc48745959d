// Numbers as little-endian bytes on their way to a file, of which few are in memory.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "io/layer.h"
#include "io/number_text.h"

namespace flowcert::io {

// Writes to a stream in pieces.
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

// Keeps bytes until a file takes them: the first ones in memory, more of them on disk.
//
// Guarantees: it takes O(1) memory. The file that it makes in the folder has no name, so that nothing is left of it
// however the program ends. Every failed write or read throws OutputError.
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
