// A VTP file (VTK's XML PolyData) as far as a claim needs it: where its points are and an array of its point
// data, still encoded.
//
// Guarantees: what is no well-formed XML up to the appended data, no PolyData, nests absurdly or declares a
// document type (and with it entities) throws InvalidInput. Counts and offsets are as announced, and may be
// absurd.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/line_reader.h"

namespace flowcert::io {

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
  std::size_t header_size = 4;  // of the numbers before binary data, in bytes
  std::string compressor;       // empty: none
  std::vector<VtpPiece> pieces;
  bool appended_is_raw = false;
  std::string_view appended;  // after its underscore
};

// `data_name`: of the array of point data. The document refers to `bytes` and `file`.
[[nodiscard]] VtpDocument parse_vtp(std::string_view bytes, std::string_view file,
                                    const std::string& data_name);

}  // namespace flowcert::io
