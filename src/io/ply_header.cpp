// Line by line, by the first word of each. Both sets of type names are in use: the original one (char, …,
// double) and the one with sizes (int8, …, float64).
#include "io/ply_header.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "io/number_text.h"

namespace flowcert::io {
namespace {

constexpr auto kTypeNames =
    std::to_array<std::pair<std::string_view, PlyType>>({{"char", PlyType::kInt8},
                                                         {"int8", PlyType::kInt8},
                                                         {"uchar", PlyType::kUint8},
                                                         {"uint8", PlyType::kUint8},
                                                         {"short", PlyType::kInt16},
                                                         {"int16", PlyType::kInt16},
                                                         {"ushort", PlyType::kUint16},
                                                         {"uint16", PlyType::kUint16},
                                                         {"int", PlyType::kInt32},
                                                         {"int32", PlyType::kInt32},
                                                         {"uint", PlyType::kUint32},
                                                         {"uint32", PlyType::kUint32},
                                                         {"float", PlyType::kFloat},
                                                         {"float32", PlyType::kFloat},
                                                         {"double", PlyType::kDouble},
                                                         {"float64", PlyType::kDouble}});

std::optional<PlyType> type_of_name(std::string_view name) {
  for (const auto& [known, type] : kTypeNames) {
    if (name == known) return type;
  }
  return std::nullopt;
}

// One line of the header, field by field.
class HeaderLine {
 public:
  HeaderLine(std::string_view line, LinePlace place) : fields_(line, Separators::kBlanks), place_(place) {}

  std::string_view word(const char* what) {
    std::string_view field;
    if (!fields_.next(field)) reject(std::string("incomplete PLY header: no ") + what);
    return field;
  }

  PlyType type_named(std::string_view name) {
    const std::optional<PlyType> type = type_of_name(name);
    if (!type) reject("not a PLY type: " + in_quotes(name));
    return *type;
  }

  std::uint64_t count() {
    const std::string_view text = word("count");
    std::uint64_t value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
      reject("not a count: " + in_quotes(text));
    }
    return value;
  }

  [[noreturn]] void reject(const std::string& reason) const { place_.reject(reason); }

 private:
  Fields fields_;
  LinePlace place_;
};

PlyEncoding read_format(HeaderLine& line) {
  const std::string_view encoding = line.word("format");
  const std::string_view version = line.word("version");
  if (version != "1.0") line.reject("not a known version of PLY: " + in_quotes(version));
  if (encoding == "ascii") return PlyEncoding::kAscii;
  if (encoding == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (encoding == "binary_big_endian") return PlyEncoding::kBigEndian;
  line.reject("not a PLY format: " + in_quotes(encoding));
}

PlyProperty read_property(HeaderLine& line) {
  PlyProperty property;
  const std::string_view type = line.word("type");
  property.is_list = type == "list";
  if (property.is_list) {
    property.count_type = line.type_named(line.word("type of the list's length"));
    if (property.count_type == PlyType::kFloat || property.count_type == PlyType::kDouble) {
      line.reject("the length of a list is not an integer");
    }
    property.type = line.type_named(line.word("type of the list's values"));
  } else {
    property.type = line.type_named(type);
  }
  property.name = line.word("name");
  return property;
}

// Finds the vertices, and x, y and z in them.
void locate_coordinates(PlyHeader& header, std::string_view file) {
  const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
  if (vertex == header.elements.end()) reject_file(file, "no element 'vertex'");
  if (std::find_if(vertex + 1, header.elements.end(), is_vertex) != header.elements.end()) {
    reject_file(file, "more than one element 'vertex'");
  }
  header.vertex = static_cast<std::size_t>(vertex - header.elements.begin());
  const std::vector<PlyProperty>& properties = vertex->properties;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto is_axis = [&](const PlyProperty& property) { return property.name == name; };
    const auto found = std::find_if(properties.begin(), properties.end(), is_axis);
    if (found == properties.end()) reject_file(file, "the vertices have no property '" + name + "'");
    if (found->is_list) reject_file(file, "the property '" + name + "' of the vertices is a list");
    if (std::find_if(found + 1, properties.end(), is_axis) != properties.end()) {
      reject_file(file, "the vertices have more than one property '" + name + "'");
    }
    header.coordinates[axis] = static_cast<std::size_t>(found - properties.begin());
  }
}

// False at the header's end.
bool read_header_line(std::string_view text, LinePlace place, PlyHeader& header, bool& format_seen) {
  HeaderLine line(text, place);
  const std::string_view keyword = line.word("keyword");
  if (keyword == "comment" || keyword == "obj_info") return true;
  if (keyword == "format") {
    if (format_seen) line.reject("a second format");
    header.encoding = read_format(line);
    format_seen = true;
  } else if (keyword == "element") {
    PlyElement element;
    element.name = line.word("name");
    element.count = line.count();
    header.elements.push_back(std::move(element));
  } else if (keyword == "property") {
    if (header.elements.empty()) line.reject("a property before the first element");
    header.elements.back().properties.push_back(read_property(line));
  } else if (keyword == "end_header") {
    if (!format_seen) line.reject("no format in the PLY header");
    return false;
  } else {
    line.reject("not a line of a PLY header: " + in_quotes(keyword));
  }
  return true;
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat:
      return 4;
    case PlyType::kDouble:
      return 8;
  }
  return 0;
}

std::size_t PlyElement::smallest_row() const {
  std::size_t size = 0;
  for (const PlyProperty& property : properties) {
    size += size_of(property.is_list ? property.count_type : property.type);
  }
  return size;
}

bool PlyElement::has_lists() const { return std::ranges::any_of(properties, &PlyProperty::is_list); }

PlyHeader read_ply_header(LineReader& lines) {
  std::string_view line;
  if (!lines.next(line) || line.substr(0, line.find_last_not_of(" \t") + 1) != "ply") {
    lines.place().reject("not a PLY file: does not begin with 'ply'");
  }
  PlyHeader header;
  bool format_seen = false;
  while (true) {
    if (!lines.next_filled(line)) reject_file(lines.file(), "cut short: no end_header");
    if (!read_header_line(line, lines.place(), header, format_seen)) break;
  }
  locate_coordinates(header, lines.file());
  return header;
}

}  // namespace flowcert::io
