// A VTP file (VTK's XML PolyData) as far as a claim needs it: its encoded bytes, its document, the values of its
// arrays.
//
// Guarantees: anything missing or malformed throws InvalidInput. Memory is bounded by what is really in the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/layer.h"
#include "flowcert/claim.h"
#include "io/line_reader.h"

namespace flowcert::certify {

// ---- Encoded bytes ----
// Binary data is raw or base64, and may hold zlib streams. It is taken from the front, piece by piece.

class EncodedBytes {
 public:
  // The text must outlive this.
  EncodedBytes(std::string_view text, bool is_base64, const LinePlace& place)
      : rest_(text), size_(text.size()), is_base64_(is_base64), place_(place) {}

  // The next `count` bytes. In base64, padding ends four characters, not the data.
  [[nodiscard]] std::string take(std::uint64_t count);
  // Throws InvalidInput unless nothing but blanks is left of the text.
  void expect_end() const;
  // How many characters of the text are taken so far.
  [[nodiscard]] std::size_t taken() const { return size_ - rest_.size(); }

 private:
  void decode_four();

  std::string_view rest_;
  std::size_t size_;
  bool is_base64_;
  LinePlace place_;
  std::string decoded_;  // bytes that are not yet taken, at most two between calls
};

// Appends the contents of a zlib stream. The stream is all of `bytes`, and must hold exactly `size` bytes.
void append_inflated(std::string_view bytes, std::uint64_t size, std::string& output, const LinePlace& place);

// ---- The document ----
// Where the points and one array of point data are. Both are still encoded.
//
// Guarantees: the file must be PolyData, well-formed XML up to the appended data, not nested too deeply, and without
// a document type (which could declare entities). Anything else throws InvalidInput. Counts and offsets are as
// announced, and may be absurd.
enum class VtpPlacement { kAscii, kInlineBase64, kAppended };

// A DataArray element.
struct EncodedVtpArray {
  LinePlace place;
  std::string type;  // "Float32", "Int8", ...
  std::size_t components = 1;
  VtpPlacement placement = VtpPlacement::kAscii;
  std::string text;          // what the element contains
  std::uint64_t offset = 0;  // in the appended data
};

struct VtpPiece {
  LinePlace place;
  std::uint64_t point_count = 0;
  std::optional<EncodedVtpArray> points;
  std::optional<EncodedVtpArray> data;
};

struct VtpDocument {
  bool big_endian = false;
  std::size_t header_size = 4;   // of the numbers before binary data, in bytes
  std::string compressor;        // empty: none
  std::uint64_t most_bytes = 0;  // that an array may grow to where it is compressed
  std::vector<VtpPiece> pieces;
  bool appended_is_raw = false;
  std::string_view appended;  // after its underscore
};

// `data_name` names the array of point data. The document refers to `bytes` and `file`.
[[nodiscard]] VtpDocument parse_vtp(std::string_view bytes, std::string_view file, const std::string& data_name);

// ---- Values ----
// The values of a VTP file's arrays, decoded and decompressed.
//
// Guarantees: an array has exactly as many values as announced, or InvalidInput is thrown. Memory is bounded by what
// is really there, not by what is announced. All arrays together never decode more than the size of the appended
// data.
enum class VtpType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kInt64, kUint64, kFloat32, kFloat64 };

class VtpValues {
 public:
  // The k-th value. It is never graded exact, because it may have been rounded. Throws InvalidInput if it is not a
  // finite number.
  [[nodiscard]] ClaimedNumber operator[](std::size_t k) const;

 private:
  friend class VtpDecoder;
  LinePlace place_;
  std::vector<std::string_view> fields_;  // of an ascii array
  std::string bytes_;                     // of any other array, in the file's byte order
  VtpType type_ = VtpType::kInt8;
  bool big_endian_ = false;
};

class VtpDecoder {
 public:
  // The document must outlive this and the values.
  explicit VtpDecoder(const VtpDocument& document) : document_(document), appended_left_(document.appended.size()) {}

  // The values of an array, `tuples` times its number of components.
  [[nodiscard]] VtpValues decode(const EncodedVtpArray& array, std::uint64_t tuples);

 private:
  const VtpDocument& document_;
  std::size_t appended_left_;  // how much of the appended data is not yet decoded
};

}  // namespace flowcert::certify
