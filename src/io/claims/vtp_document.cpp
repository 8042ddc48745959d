// Expat, told element by element: it reads in place, does not recurse, and can be stopped at the appended
// data, which in its raw encoding is not XML. VTK itself would be 190 MB of packages for two arrays.
#include "io/claims/vtp_document.h"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <memory>

#include "io/claims/claim_numbers.h"
#include "io/number_text.h"

namespace flowcert::io {
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
      : bytes_(bytes),
        file_(file),
        data_name_(data_name),
        parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
  }

  VtpDocument parse() {
    // In as few parts as expat's int allows: in one, it copies nothing.
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
  // Expat is C: an exception waits until it has returned.
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
  static void on_doctype(void* self, const char* /*name*/, const char* /*system_id*/,
                         const char* /*public_id*/, int /*has_internal_subset*/) {
    guarded(self, [](VtpParser& parser) { parser.place().reject("a VTP file has no document type"); });
  }

  void stop() {
    is_stopped_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }
  [[nodiscard]] LinePlace place() const {
    return {.file = file_, .line = XML_GetCurrentLineNumber(parser_.get())};
  }

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
    if (order != "LittleEndian" && order != "BigEndian")
      place().reject("not a byte order: " + in_quotes(order));
    document_.big_endian = order == "BigEndian";
    const std::string_view header = attributes.find("header_type").value_or("UInt32");
    if (header != "UInt32" && header != "UInt64") place().reject("not a header type: " + in_quotes(header));
    document_.header_size = header == "UInt64" ? 8 : 4;
    document_.compressor = attributes.find("compressor").value_or("");
  }

  void start_piece(const Attributes& attributes) {
    VtpPiece& piece = document_.pieces.emplace_back();
    piece.place = place();
    piece.point_count = claimed_count(attributes.get("NumberOfPoints", place()), place());
  }

  void start_array(std::optional<EncodedVtpArray>& slot, const Attributes& attributes) {
    if (slot) place().reject("a second array of the same kind in one piece");
    EncodedVtpArray& array = slot.emplace();
    array.place = place();
    array.type = attributes.get("type", place());
    array.components = claimed_count(attributes.find("NumberOfComponents").value_or("1"), place());
    if (array.components == 0 || array.components > kMostComponents)
      place().reject("not a number of components: " + std::to_string(array.components));
    const std::string_view format = attributes.find("format").value_or("ascii");
    if (format == "appended") {
      array.placement = VtpPlacement::kAppended;
      array.offset = claimed_count(attributes.get("offset", place()), place());
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
    appended_from_ = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get()) +
                                              XML_GetCurrentByteCount(parser_.get()));
    stop();
  }

  // From the underscore to the closing tags, which must be the end of the file.
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
  EncodedVtpArray* array_ = nullptr;  // the open one, if it is wanted; the pieces do not grow meanwhile
  std::size_t array_depth_ = 0;
  std::optional<std::size_t> appended_from_;
  bool is_stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace

VtpDocument parse_vtp(std::string_view bytes, std::string_view file, const std::string& data_name) {
  return VtpParser(bytes, file, data_name).parse();
}

}  // namespace flowcert::io
