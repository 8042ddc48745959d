// VTP (VTK's XML PolyData) as TTK's ScalarFieldCriticalPoints exports it. It has positions, and CriticalType in the
// point data: 0 minimum, 1 and 2 saddles, 3 maximum.
//
// A position is kept exactly as it is stored, but it stands for any position near it. TTK's other types (4
// degenerate, 5 regular) name no index, and are refused.
//
// Guarantees: anything missing or malformed throws InvalidInput. Memory is bounded by what is really in the file. Expat
// reads the document. Base64 is decoded here, and zlib decompresses. VTK itself would be 190 MB of packages for two
// arrays.
#include <expat.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/claims/claim_formats.h"
#include "io/input_bytes.h"
#include "io/number_text.h"

namespace flowcert::certify {

namespace {

constexpr const char* kTypeArray = "CriticalType";

// ---- Where the parser is ----

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

// ---- Encoded bytes ----
// Binary data is raw or base64, and may hold zlib streams. It is taken from the front, piece by piece.

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
    const auto size = static_cast<std::size_t>(count);
    std::string bytes(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return bytes;
  }
  while (decoded_.size() < count) decode_four();
  const auto size = static_cast<std::size_t>(count);
  std::string left = decoded_.substr(size);
  std::string bytes = std::move(decoded_);
  bytes.resize(size);
  decoded_ = std::move(left);
  return bytes;
}

void EncodedBytes::expect_end() const {
  if (!decoded_.empty() || !std::all_of(rest_.begin(), rest_.end(), is_blank))
    place_.reject("more binary data than announced");
}

// Appends the contents of a zlib stream. The stream is all of `bytes`, and must hold exactly `size` bytes.
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
// Where the points and one array of point data are. Both are still encoded. The file must be PolyData, well-formed XML
// up to the appended data, not nested too deeply, and without a document type (which could declare entities). Counts
// and offsets are as announced, and may be absurd.
//
// Expat reports the document element by element. It reads in place, does not recurse, and can be stopped at the
// appended data. Those are not XML if they are raw.

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
  VtpParser(std::string_view bytes, std::string_view file)
      : bytes_(bytes), file_(file), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
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
    if (path_ == "/VTKFile/PolyData/Piece/PointData/DataArray" && attributes.find("Name") == kTypeArray)
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
    array.components = written_size(attributes.find("NumberOfComponents").value_or("1"), place());
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

// ---- Values ----
// Binary data is a header and the bytes. Without compression, the header is the number of bytes. With compression,
// the header has the number of blocks, their uncompressed size, the uncompressed size of the last one (0: the same),
// and the compressed size of each. In base64, header and bytes may be padded together or each alone.
//
// An array has exactly as many values as announced. Memory is bounded by what is really there, not by what is
// announced. All arrays together never decode more than the size of the appended data.

constexpr auto kTypes = std::to_array<std::pair<std::string_view, StoredType>>({{"Int8", {'i', 1}},
                                                                                {"UInt8", {'u', 1}},
                                                                                {"Int16", {'i', 2}},
                                                                                {"UInt16", {'u', 2}},
                                                                                {"Int32", {'i', 4}},
                                                                                {"UInt32", {'u', 4}},
                                                                                {"Int64", {'i', 8}},
                                                                                {"UInt64", {'u', 8}},
                                                                                {"Float32", {'f', 4}},
                                                                                {"Float64", {'f', 8}}});

StoredType type_of(const EncodedVtpArray& array) {
  const auto found = std::ranges::find(kTypes, array.type, &std::pair<std::string_view, StoredType>::first);
  if (found == kTypes.end()) array.place.reject("not a type of numbers: " + in_quotes(array.type));
  return found->second;
}

std::uint64_t next_header_number(EncodedBytes& encoded, const VtpDocument& document) {
  const std::string bytes = encoded.take(document.header_size);
  return stored_bits(bytes.data(), document.header_size, document.big_endian);
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
  for (std::size_t k = 0; k < compressed_sizes.size(); ++k) {
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
  StoredType type_;
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
  const std::uint64_t needed = count * values.type_.size;
  if (array.placement == VtpPlacement::kInlineBase64) {
    EncodedBytes encoded(array.text, true, array.place);
    values.bytes_ = binary_bytes(encoded, document_, needed, array.place);
    encoded.expect_end();
    return values;
  }
  if (array.offset > document_.appended.size()) array.place.reject("an offset beyond the appended data");
  const auto offset = static_cast<std::size_t>(array.offset);
  EncodedBytes encoded(document_.appended.substr(offset), !document_.appended_is_raw, array.place);
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
  const char* const bytes = bytes_.data() + k * type_.size;
  if (type_.kind == 'f') {
    const double value = *stored_number(bytes, type_, big_endian_);
    if (!std::isfinite(value)) place_.reject("not a finite number: value " + std::to_string(k));
    return {.value = Rational(value), .is_exact = false};
  }
  const std::uint64_t bits = stored_bits(bytes, type_.size, big_endian_);
  const std::size_t unused = 64 - 8 * type_.size;
  const auto with_sign = static_cast<std::int64_t>(bits << unused) >> unused;
  return {.value = type_.kind == 'i' ? Rational(with_sign) : Rational(bits), .is_exact = false};
}

// ---- The claim ----

void add_points(const VtpPiece& piece, VtpDecoder& decoder, Claim& claim) {
  if (piece.point_count == 0) return;
  if (!piece.points) piece.place.reject("a piece without the positions of its points");
  if (!piece.data) piece.place.reject(std::string("no array '") + kTypeArray + "' in the point data");
  if (piece.points->components != 3) piece.points->place.reject("positions are not of 3 components");
  if (piece.data->components != 1)
    piece.data->place.reject(std::string("the array '") + kTypeArray + "' is not of 1 component");
  const VtpValues positions = decoder.decode(*piece.points, piece.point_count);
  const VtpValues types = decoder.decode(*piece.data, piece.point_count);
  for (std::size_t k = 0; k < piece.point_count; ++k) {
    const Rational type = types[k].value;
    int index = 0;
    while (index < 4 && type != index) ++index;
    if (index == 4) {
      piece.data->place.reject("point " + std::to_string(k) + " of the piece: its " + kTypeArray +
                               " is none of 0 to 3");
    }
    ClaimedPoint& point = claim.points.emplace_back();
    point.line = claim.points.size();
    point.index = index;
    point.center = {positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]};
  }
}

bool recognises_vtp(std::string_view bytes) { return trimmed(bytes).starts_with('<'); }

Claim read_vtp(std::string_view bytes, std::string_view file, bool is_unlimited) {
  Claim claim;
  VtpDocument document = VtpParser(bytes, file).parse();
  document.most_bytes = most_content(bytes.size(), is_unlimited);
  VtpDecoder decoder(document);
  for (const VtpPiece& piece : document.pieces) add_points(piece, decoder, claim);
  return claim;
}

}  // namespace

const ClaimFormat kVtpClaims = {.name = "vtp", .recognises = recognises_vtp, .read = read_vtp};

}  // namespace flowcert::certify
