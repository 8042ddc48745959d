// Expat reads the document. Base64 is decoded here, and zlib decompresses. VTK itself would be 190 MB of packages for
// two arrays.
#include "certify/claims/vtp_file.h"

#include <expat.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "io/input_bytes.h"
#include "io/number_text.h"

namespace flowcert::certify {

// ---- Where the parser is ----

namespace {

// Expat 2.9 has functions of 64 bits, and warns of those that older versions have.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
std::size_t line_of(XML_Parser parser) { return static_cast<std::size_t>(XML_GetCurrentLineNumber64(parser)); }
std::size_t byte_after_event(XML_Parser parser) {
  return static_cast<std::size_t>(XML_GetCurrentByteIndex64(parser)) + XML_GetCurrentByteCount64(parser);
}
#else
std::size_t line_of(XML_Parser parser) { return XML_GetCurrentLineNumber(parser); }
std::size_t byte_after_event(XML_Parser parser) {
  return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser) + XML_GetCurrentByteCount(parser));
}
#endif

}  // namespace

// ---- Encoded bytes ----

namespace {

constexpr int kPadding = 64;

// The six bits of a base64 character. kPadding for '=', and -1 for any other character.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return c == '=' ? kPadding : -1;
}

}  // namespace

void EncodedBytes::decode_four() {
  std::uint32_t bits = 0;
  std::size_t digits = 0;
  for (std::size_t found = 0; found < 4;) {
    if (rest_.empty()) place_.reject("cut short in the binary data");
    const char c = rest_.front();
    rest_.remove_prefix(1);
    if (is_blank(c)) continue;
    const int digit = base64_digit(c);
    const bool is_padding = digit == kPadding;
    if (digit < 0 || (is_padding && found < 2) || (!is_padding && digits < found))
      place_.reject("not base64: " + in_quotes({&c, 1}));
    ++found;
    bits = bits << 6 | (is_padding ? 0U : static_cast<std::uint32_t>(digit));
    digits += is_padding ? 0 : 1;
  }
  for (std::size_t k = 0; k + 1 < digits; ++k)
    decoded_ += static_cast<char>(static_cast<unsigned char>(bits >> (16 - 8 * k) & 0xff));
}

std::string EncodedBytes::take(std::uint64_t count) {
  if (!is_base64_) {
    if (count > rest_.size()) place_.reject("cut short in the binary data");
    std::string bytes(rest_.substr(0, count));
    rest_.remove_prefix(count);
    return bytes;
  }
  while (decoded_.size() < count) decode_four();
  std::string left = decoded_.substr(count);
  std::string bytes = std::move(decoded_);
  bytes.resize(count);
  decoded_ = std::move(left);
  return bytes;
}

void EncodedBytes::expect_end() const {
  if (!decoded_.empty() || !std::all_of(rest_.begin(), rest_.end(), is_blank))
    place_.reject("more binary data than announced");
}

void append_inflated(std::string_view bytes, std::uint64_t size, std::string& output, const LinePlace& place) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) place.reject("a compressed block of 4 GB or more");
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end_of_scope(&stream, inflateEnd);
  // zlib does not write through next_in; its type lacks the const for the sake of old compilers.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::array<char, std::size_t{1} << 14> block{};
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    const std::size_t count = block.size() - stream.avail_out;
    if (count > size) place.reject("a compressed block is longer than announced");
    output.append(block.data(), count);
    size -= count;
  }
  if (status != Z_STREAM_END || size != 0 || stream.avail_in != 0) place.reject("a compressed block is damaged");
}

// ---- The document ----
// Expat reports the document element by element. It reads in place, does not recurse, and can be stopped at the
// appended data. Those are not XML if they are raw.
namespace {

// PolyData nests seven deep at most, with the information keys of an array.
constexpr std::size_t kDeepest = 32;
constexpr std::size_t kMostComponents = 1000;

// The attributes of an element: names and values in turn, then null.
class Attributes {
 public:
  explicit Attributes(const char** list) : list_(list) {}

  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const {
    for (const char** entry = list_; *entry != nullptr; entry += 2) {
      if (name == entry[0]) return entry[1];
    }
    return std::nullopt;
  }
  [[nodiscard]] std::string_view get(std::string_view name, const LinePlace& place) const {
    const auto value = find(name);
    if (!value) place.reject("no attribute " + in_quotes(name));
    return *value;
  }

 private:
  const char** list_;
};

class VtpParser {
 public:
  VtpParser(std::string_view bytes, std::string_view file, const std::string& data_name)
      : bytes_(bytes), file_(file), data_name_(data_name), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
  }

  VtpDocument parse() {
    // Expat copies nothing if it gets the document in one part. Its int allows only parts of this size.
    constexpr std::size_t kLargestPart = std::size_t{1} << 30;
    std::size_t given = 0;
    XML_Status status = XML_STATUS_OK;
    while (status == XML_STATUS_OK && given < bytes_.size()) {
      const std::size_t size = std::min(kLargestPart, bytes_.size() - given);
      const bool is_last = given + size == bytes_.size();
      status = XML_Parse(parser_.get(), bytes_.data() + given, static_cast<int>(size), is_last ? 1 : 0);
      given += size;
    }
    if (failure_ != nullptr) std::rethrow_exception(failure_);
    if (appended_from_) {
      take_appended();
    } else if (status != XML_STATUS_OK) {
      place().reject(std::string("not XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())));
    }
    return std::move(document_);
  }

 private:
  // Expat is C code, so an exception is kept until it has returned.
  template <class Action>
  static void guarded(void* self, Action action) {
    auto* const parser = static_cast<VtpParser*>(self);
    if (parser->is_stopped_) return;
    try {
      action(*parser);
    } catch (...) {
      parser->failure_ = std::current_exception();
      parser->stop();
    }
  }
  static void on_start(void* self, const char* name, const char** attributes) {
    guarded(self, [&](VtpParser& parser) { parser.start(name, Attributes(attributes)); });
  }
  static void on_end(void* self, const char* name) {
    guarded(self, [&](VtpParser& parser) { parser.end(name); });
  }
  static void on_text(void* self, const char* text, int size) {
    guarded(self, [&](VtpParser& parser) {
      // VTK puts InformationKey elements, with text of their own, into the element of an array.
      const bool is_of_array = parser.array_ != nullptr && parser.depth_ == parser.array_depth_;
      if (is_of_array) parser.array_->text.append(text, static_cast<std::size_t>(size));
    });
  }
  static void on_doctype(void* self, const char* /*name*/, const char* /*system_id*/, const char* /*public_id*/,
                         int /*has_internal_subset*/) {
    guarded(self, [](VtpParser& parser) { parser.place().reject("a VTP file has no document type"); });
  }

  void stop() {
    is_stopped_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }
  [[nodiscard]] LinePlace place() const { return {.file = file_, .line = line_of(parser_.get())}; }

  void start(std::string_view name, const Attributes& attributes) {
    if (++depth_ > kDeepest) place().reject("nested deeper than " + std::to_string(kDeepest) + " levels");
    path_ += '/';
    path_ += name;
    if (depth_ == 1) return start_file(name, attributes);
    if (path_ == "/VTKFile/PolyData/Piece") return start_piece(attributes);
    if (path_ == "/VTKFile/PolyData/Piece/Points/DataArray")
      return start_array(document_.pieces.back().points, attributes);
    if (path_ == "/VTKFile/PolyData/Piece/PointData/DataArray" && attributes.find("Name") == data_name_)
      return start_array(document_.pieces.back().data, attributes);
    if (path_ == "/VTKFile/AppendedData") start_appended(attributes);
  }

  void end(std::string_view name) {
    --depth_;
    path_.resize(path_.size() - name.size() - 1);
    if (name == "DataArray") array_ = nullptr;
  }

  void start_file(std::string_view name, const Attributes& attributes) {
    if (name != "VTKFile") place().reject("not a VTP file: it begins with " + in_quotes(name));
    const std::string_view type = attributes.get("type", place());
    if (type != "PolyData") place().reject("not a VTP file: its type is " + in_quotes(type));
    const std::string_view order = attributes.find("byte_order").value_or("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian") place().reject("not a byte order: " + in_quotes(order));
    document_.big_endian = order == "BigEndian";
    const std::string_view header = attributes.find("header_type").value_or("UInt32");
    if (header != "UInt32" && header != "UInt64") place().reject("not a header type: " + in_quotes(header));
    document_.header_size = header == "UInt64" ? 8 : 4;
    document_.compressor = attributes.find("compressor").value_or("");
  }

  void start_piece(const Attributes& attributes) {
    VtpPiece& piece = document_.pieces.emplace_back();
    piece.place = place();
    piece.point_count = written_count(attributes.get("NumberOfPoints", place()), place());
  }

  void start_array(std::optional<EncodedVtpArray>& slot, const Attributes& attributes) {
    if (slot) place().reject("a second array of the same kind in one piece");
    EncodedVtpArray& array = slot.emplace();
    array.place = place();
    array.type = attributes.get("type", place());
    array.components = written_count(attributes.find("NumberOfComponents").value_or("1"), place());
    if (array.components == 0 || array.components > kMostComponents)
      place().reject("not a number of components: " + std::to_string(array.components));
    const std::string_view format = attributes.find("format").value_or("ascii");
    if (format == "appended") {
      array.placement = VtpPlacement::kAppended;
      array.offset = written_count(attributes.get("offset", place()), place());
    } else if (format == "binary") {
      array.placement = VtpPlacement::kInlineBase64;
    } else if (format != "ascii") {
      place().reject("not a format of an array: " + in_quotes(format));
    }
    array_ = &array;
    array_depth_ = depth_;
  }

  void start_appended(const Attributes& attributes) {
    const std::string_view encoding = attributes.find("encoding").value_or("base64");
    if (encoding != "raw" && encoding != "base64")
      place().reject("not an encoding of appended data: " + in_quotes(encoding));
    document_.appended_is_raw = encoding == "raw";
    appended_from_ = byte_after_event(parser_.get());
    stop();
  }

  // Takes the data from the underscore to the closing tags. Nothing may follow those.
  void take_appended() {
    const auto cut_short = [&] { reject_file(file_, "cut short in the appended data"); };
    std::string_view data = bytes_.substr(std::min(*appended_from_, bytes_.size()));
    const std::size_t end = data.rfind("</AppendedData");
    const std::size_t mark = std::min(data.find_first_not_of(" \t\r\n"), data.size());
    if (end == std::string_view::npos || mark >= end) cut_short();
    if (data[mark] != '_') reject_file(file_, "appended data without its underscore");
    std::string closing(data.substr(end));
    closing.erase(std::remove_if(closing.begin(), closing.end(), is_blank), closing.end());
    if (closing != "</AppendedData></VTKFile>") cut_short();
    document_.appended = data.substr(mark + 1, end - mark - 1);
  }

  std::string_view bytes_;
  std::string_view file_;
  const std::string& data_name_;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser_;
  VtpDocument document_;
  std::string path_;  // of the open elements
  std::size_t depth_ = 0;
  EncodedVtpArray* array_ = nullptr;  // the open array if it is wanted; pieces do not grow meanwhile
  std::size_t array_depth_ = 0;
  std::optional<std::size_t> appended_from_;
  bool is_stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace

VtpDocument parse_vtp(std::string_view bytes, std::string_view file, const std::string& data_name) {
  return VtpParser(bytes, file, data_name).parse();
}

// ---- Values ----
// Binary data is a header and the bytes. Without compression, the header is the number of bytes. With compression,
// the header has the number of blocks, their uncompressed size, the uncompressed size of the last one (0: the same),
// and the compressed size of each. In base64, header and bytes may be padded together or each alone.
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
  std::vector<std::uint64_t> compressed_sizes;  // grows only as long as the file has numbers
  // NOLINTNEXTLINE(performance-inefficient-vector-operation)
  for (std::uint64_t k = 0; k < blocks; ++k) compressed_sizes.push_back(next_header_number(encoded, document));
  std::string bytes;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    const std::uint64_t size = k + 1 == blocks && last_size != 0 ? last_size : block_size;
    if (size > needed - bytes.size()) place.reject("more compressed data than the number of points asks for");
    if (bytes.size() + size > document.most_bytes) place.reject(complaint_about_growth("compressed data"));
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
  // Otherwise many arrays at one offset could together decode to far more than the file holds.
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
  const auto integer = [](auto value) -> ClaimedNumber { return {.value = Rational(value), .is_exact = false}; };
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

}  // namespace flowcert::certify
