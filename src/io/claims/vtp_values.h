// The values of a VTP file's arrays: decoded, decompressed, and exactly as many as announced.
//
// Guarantees: anything else throws InvalidInput. Memory is bounded by what is really there, not by what is
// announced; no part of the appended data is decoded twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/claim.h"
#include "io/claims/vtp_document.h"

namespace flowcert::io {

enum class VtpType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kInt64, kUint64, kFloat32, kFloat64 };

class VtpValues {
 public:
  // The k-th value; never graded exact, because it was rounded or will be taken for rounded. Throws
  // InvalidInput for what is not a finite number.
  [[nodiscard]] ClaimedNumber operator[](std::size_t k) const;

 private:
  friend class VtpDecoder;
  LinePlace place_;
  std::vector<std::string_view> fields_;  // of an ascii array
  std::string bytes_;                     // of any other, in the order of the file
  VtpType type_ = VtpType::kInt8;
  bool big_endian_ = false;
};

class VtpDecoder {
 public:
  // The document must outlive this and the values.
  explicit VtpDecoder(const VtpDocument& document)
      : document_(document), appended_left_(document.appended.size()) {}

  // The values of an array of `tuples` times its components.
  [[nodiscard]] VtpValues decode(const EncodedVtpArray& array, std::uint64_t tuples);

 private:
  const VtpDocument& document_;
  std::size_t appended_left_;  // how much of the appended data is not yet decoded
};

}  // namespace flowcert::io
