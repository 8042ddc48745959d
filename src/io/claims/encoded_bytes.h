// Binary data in a VTP file: raw or base64, taken from the front piece by piece, and zlib streams within.
//
// Guarantees: what is not there throws InvalidInput. Memory is bounded by what is taken and really there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/line_reader.h"

namespace flowcert::io {

class EncodedBytes {
 public:
  // The text must outlive this.
  EncodedBytes(std::string_view text, bool is_base64, const LinePlace& place)
      : rest_(text), size_(text.size()), is_base64_(is_base64), place_(place) {}

  // The next `count` bytes. In base64, padding ends four characters, not the data.
  [[nodiscard]] std::string take(std::uint64_t count);
  // Throws InvalidInput unless nothing but blanks is left of the text.
  void expect_end() const;
  // How much of the text that took so far.
  [[nodiscard]] std::size_t taken() const { return size_ - rest_.size(); }

 private:
  void decode_four();

  std::string_view rest_;
  std::size_t size_;
  bool is_base64_;
  LinePlace place_;
  std::string decoded_;  // and not yet taken: at most two bytes between calls
};

// Appends what a zlib stream, all of `bytes`, holds: `size` bytes, no more and no fewer.
void append_inflated(std::string_view bytes, std::uint64_t size, std::string& output, const LinePlace& place);

}  // namespace flowcert::io
