// See vtp_values.h. Binary data is a header and the bytes: without compression the header is their number,
// with it the number of blocks, the sizes of all blocks and of the last before compression (0: the same), and
// the size of each after it. In base64, header and bytes may be padded together or each alone.
#include "io/claims/vtp_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "io/claims/claim_numbers.h"
#include "io/claims/encoded_bytes.h"
#include "io/number_text.h"

namespace flowcert::io {
namespace {

constexpr std::array<std::pair<const char*, std::size_t>, 10> kTypes = {{{"Int8", 1},
                                                                         {"UInt8", 1},
                                                                         {"Int16", 2},
                                                                         {"UInt16", 2},
                                                                         {"Int32", 4},
                                                                         {"UInt32", 4},
                                                                         {"Int64", 8},
                                                                         {"UInt64", 8},
                                                                         {"Float32", 4},
                                                                         {"Float64", 8}}};

VtpType type_of(const EncodedVtpArray& array) {
  for (std::size_t k = 0; k < kTypes.size(); ++k) {
    if (array.type == kTypes[k].first) return static_cast<VtpType>(k);
  }
  array.place.reject("not a type of numbers: " + in_quotes(array.type));
}

std::size_t size_of(VtpType type) { return kTypes[static_cast<std::size_t>(type)].second; }

template <class Number>
Number load(const char* bytes, bool big_endian) {
  std::array<char, sizeof(Number)> parts{};
  std::memcpy(parts.data(), bytes, sizeof(Number));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(parts.begin(), parts.end());
  return std::bit_cast<Number>(parts);
}

std::uint64_t next_header_number(EncodedBytes& encoded, const VtpDocument& document) {
  const std::string bytes = encoded.take(document.header_size);
  if (document.header_size == 8) return load<std::uint64_t>(bytes.data(), document.big_endian);
  return load<std::uint32_t>(bytes.data(), document.big_endian);
}

void expect_size(std::uint64_t announced, std::uint64_t needed, const LinePlace& place) {
  if (announced == needed) return;
  place.reject("an array of " + std::to_string(announced) + " bytes where the number of points asks for " +
               std::to_string(needed));
}

std::string decompressed(EncodedBytes& encoded, const VtpDocument& document, std::uint64_t needed,
                         const LinePlace& place) {
  const std::uint64_t blocks = next_header_number(encoded, document);
  const std::uint64_t block_size = next_header_number(encoded, document);
  const std::uint64_t last_size = next_header_number(encoded, document);
  std::vector<std::uint64_t> compressed_sizes;  // grows with what is there
  for (std::uint64_t k = 0; k < blocks; ++k)
    compressed_sizes.push_back(next_header_number(encoded, document));
  std::string bytes;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    const std::uint64_t size = k + 1 == blocks && last_size != 0 ? last_size : block_size;
    if (size > needed - bytes.size()) place.reject("more compressed data than the number of points asks for");
    append_inflated(encoded.take(compressed_sizes[k]), size, bytes, place);
  }
  expect_size(bytes.size(), needed, place);
  return bytes;
}

std::string binary_bytes(EncodedBytes& encoded, const VtpDocument& document, std::uint64_t needed,
                         const LinePlace& place) {
  if (document.compressor == "vtkZLibDataCompressor") return decompressed(encoded, document, needed, place);
  if (!document.compressor.empty())
    place.reject("compressed by " + in_quotes(document.compressor) + ", not by vtkZLibDataCompressor");
  expect_size(next_header_number(encoded, document), needed, place);
  return encoded.take(needed);
}

}  // namespace

VtpValues VtpDecoder::decode(const EncodedVtpArray& array, std::uint64_t tuples) {
  constexpr std::uint64_t kMostTuples = std::uint64_t{1} << 48;
  if (tuples > kMostTuples) array.place.reject("more points than any file holds: " + std::to_string(tuples));
  VtpValues values;
  values.place_ = array.place;
  values.type_ = type_of(array);
  values.big_endian_ = document_.big_endian;
  const std::uint64_t count = tuples * array.components;
  if (array.placement == VtpPlacement::kAscii) {
    Fields fields(array.text, Separators::kBlanks);
    std::string_view field;
    while (fields.next(field)) values.fields_.push_back(field);
    if (values.fields_.size() != count) {
      array.place.reject("an array of " + std::to_string(values.fields_.size()) +
                         " numbers where the number of points asks for " + std::to_string(count));
    }
    return values;
  }
  const std::uint64_t needed = count * size_of(values.type_);
  if (array.placement == VtpPlacement::kInlineBase64) {
    EncodedBytes encoded(array.text, true, array.place);
    values.bytes_ = binary_bytes(encoded, document_, needed, array.place);
    encoded.expect_end();
    return values;
  }
  if (array.offset > document_.appended.size()) array.place.reject("an offset beyond the appended data");
  EncodedBytes encoded(document_.appended.substr(array.offset), !document_.appended_is_raw, array.place);
  values.bytes_ = binary_bytes(encoded, document_, needed, array.place);
  // Many arrays at one offset would decode to more than the file.
  if (encoded.taken() > appended_left_) array.place.reject("arrays that share appended data");
  appended_left_ -= encoded.taken();
  return values;
}

ClaimedNumber VtpValues::operator[](std::size_t k) const {
  if (bytes_.empty()) {
    ClaimedNumber number = claimed_number(fields_[k], PlainInteger::kDecimal, place_);
    number.is_exact = false;
    return number;
  }
  const char* const bytes = bytes_.data() + k * size_of(type_);
  const auto real = [&](double value) -> ClaimedNumber {
    if (!std::isfinite(value)) place_.reject("not a finite number: value " + std::to_string(k));
    return {.value = Rational(value), .is_exact = false};
  };
  const auto integer = [](auto value) -> ClaimedNumber {
    return {.value = Rational(value), .is_exact = false};
  };
  switch (type_) {
    case VtpType::kInt8:
      return integer(int{load<std::int8_t>(bytes, big_endian_)});
    case VtpType::kUint8:
      return integer(int{load<std::uint8_t>(bytes, big_endian_)});
    case VtpType::kInt16:
      return integer(int{load<std::int16_t>(bytes, big_endian_)});
    case VtpType::kUint16:
      return integer(int{load<std::uint16_t>(bytes, big_endian_)});
    case VtpType::kInt32:
      return integer(load<std::int32_t>(bytes, big_endian_));
    case VtpType::kUint32:
      return integer(load<std::uint32_t>(bytes, big_endian_));
    case VtpType::kInt64:
      return integer(load<std::int64_t>(bytes, big_endian_));
    case VtpType::kUint64:
      return integer(load<std::uint64_t>(bytes, big_endian_));
    case VtpType::kFloat32:
      return real(double{load<float>(bytes, big_endian_)});
    case VtpType::kFloat64:
      break;
  }
  return real(load<double>(bytes, big_endian_));
}

}  // namespace flowcert::io
