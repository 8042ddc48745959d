// PLY. Reads the properties x, y, z of the element `vertex`, in any order and wherever the element is.
//
// CGAL's reader is not used: it does not report a file that is cut short, takes binary NaN, and sets a missing z to
// zero. (Debian has no rply.) Here all elements are read, also the ignored ones, because a file that ends before all
// that its header announces was cut short. In ascii a row is a line.
//
// Guarantees: an accepted header is enough to read the rest of the file. It has known types, valid counts, and one
// element `vertex` with exactly one scalar property for each of x, y, z. Anything else throws InvalidInput with the
// line. Counts are as announced, and may be absurd.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

// ---- The header ----

namespace {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyProperty {
  std::string name;
  // None: a name of a type that is not known. In ascii, where every value is a field, that does no harm.
  std::optional<StoredType> type;
  // A list is a count of type `count_type`, then that many values of type `type`.
  bool is_list = false;
  std::optional<StoredType> count_type;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The size of a binary row in bytes. Lists count as empty.
  [[nodiscard]] std::size_t smallest_row() const {
    std::size_t size = 0;
    for (const PlyProperty& property : properties) {
      size += (property.is_list ? *property.count_type : *property.type).size;
    }
    return size;
  }
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  // Where the element `vertex` is among the elements, and x, y, z among its properties.
  std::size_t vertex = 0;
  std::array<std::size_t, 3> coordinates{};
};

// Both sets of type names are in use: the original one (char, …, double) and the one with sizes (int8, …, float64), and
// with the latter those of 64 bits. With u in front they have no sign.
std::optional<StoredType> type_of_name(std::string_view name) {
  static constexpr std::array<std::string_view, 4> kOriginal = {"char", "short", "int", "long"},
                                                   kWithSizes = {"int8", "int16", "int32", "int64"};
  if (name == "float" || name == "float32") return kFloat;
  if (name == "double" || name == "float64") return StoredType{'f', 8};
  const char kind = name.starts_with('u') ? 'u' : 'i';
  if (kind == 'u') name.remove_prefix(1);
  for (std::size_t k = 0; k < 4; ++k) {
    if (name == kOriginal[k] || name == kWithSizes[k]) return StoredType{kind, std::size_t{1} << k};
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

  std::uint64_t count() { return written_count(word("count"), place_); }

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

PlyProperty read_property(HeaderLine& line, PlyEncoding encoding) {
  PlyProperty property;
  std::string_view type = line.word("type");
  const auto type_named = [&](std::string_view name) {
    const std::optional<StoredType> known = type_of_name(name);
    if (!known && encoding != PlyEncoding::kAscii) line.reject("not a PLY type: " + in_quotes(name));
    return known;
  };
  property.is_list = type == "list";
  if (property.is_list) {
    property.count_type = type_named(line.word("type of the list's length"));
    if (property.count_type && property.count_type->kind == 'f') line.reject("the length of a list is not an integer");
    type = line.word("type of the list's values");
  }
  property.type = type_named(type);
  property.name = line.word("name");
  return property;
}

// Where the only one of this name is. owner: to whom it belongs.
std::size_t place_of(const auto& all, const std::string& name, std::string_view owner, std::string_view what,
                     std::string_view file) {
  const auto has_name = [&](const auto& one) { return one.name == name; };
  const auto found = std::ranges::count_if(all, has_name);
  if (found != 1)
    reject_file(file, fmt::format("{}{} {} '{}'", owner, found == 0 ? "no" : "more than one", what, name));
  return static_cast<std::size_t>(std::ranges::find_if(all, has_name) - all.begin());
}

// Finds the vertices, and x, y and z in them.
void locate_coordinates(PlyHeader& header, std::string_view file) {
  header.vertex = place_of(header.elements, "vertex", "", "element", file);
  const std::vector<PlyProperty>& properties = header.elements[header.vertex].properties;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    header.coordinates[axis] = place_of(properties, name, "the vertices have ", "property", file);
    if (properties[header.coordinates[axis]].is_list) {
      reject_file(file, "the property '" + name + "' of the vertices is a list");
    }
  }
}

// Returns false at the header's end.
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
    if (!format_seen) line.reject("no format in the PLY header");
    header.elements.back().properties.push_back(read_property(line, header.encoding));
  } else if (keyword == "end_header") {
    if (!format_seen) line.reject("no format in the PLY header");
    return false;
  } else {
    line.reject("not a line of a PLY header: " + in_quotes(keyword));
  }
  return true;
}

// Leaves `lines` at the first byte after the header.
PlyHeader read_ply_header(LineReader& lines) {
  std::string_view line;
  if (!lines.next(line) || line.substr(0, line.find_last_not_of(" \t") + 1) != "ply") {
    lines.place().reject("not a PLY file: does not begin with 'ply'");
  }
  PlyHeader header;
  bool format_seen = false;
  do {
    if (!lines.next_filled(line)) reject_file(lines.file(), "cut short: no end_header");
  } while (read_header_line(line, lines.place(), header, format_seen));
  locate_coordinates(header, lines.file());
  return header;
}

// ---- Rows ----

[[noreturn]] void reject_missing_rows(const PlyElement& element, std::uint64_t found, std::string_view file) {
  const std::string what = element.name == "vertex" ? "vertices" : "rows of " + in_quotes(element.name);
  reject_missing(file, element.count, what, found);
}

// Which of x, y and z a property is, if any.
std::optional<std::size_t> axis_of(std::size_t property, const PlyHeader& header, const PlyElement& element) {
  if (&element != &header.elements[header.vertex]) return std::nullopt;
  const auto found = std::ranges::find(header.coordinates, property);
  if (found == header.coordinates.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.coordinates.begin());
}

// Reads one line of an ascii element; its coordinates are those of vertices alone.
std::array<std::string_view, 3> read_ascii_row(const PlyHeader& header, const PlyElement& element,
                                               std::string_view line, const LinePlace& place) {
  std::array<std::string_view, 3> row;
  Fields fields(line, Separators::kBlanks);
  const auto next_field = [&](const PlyProperty& property) {
    std::string_view field;
    if (!fields.next(field)) place.reject("too few values: none for property " + in_quotes(property.name));
    return field;
  };
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const std::string_view field = next_field(property);
    if (property.is_list) {
      const NumberText length = parse_number(field);
      if (length.fault != nullptr || length.value < 0 || length.value != std::floor(length.value)) {
        place.reject("not the length of a list: " + in_quotes(field));
      }
      // The loop ends with the line's fields at the latest, however long the list claims to be.
      const auto items = static_cast<std::uint64_t>(std::min(length.value, 0x1p53));
      for (std::uint64_t item = 0; item < items; ++item) next_field(property);
    } else if (const auto axis = axis_of(k, header, element)) {
      row[*axis] = field;
    }
  }
  std::string_view further;
  if (fields.next(further)) {
    place.reject("more values than properties: " + in_quotes(further));
  }
  return row;
}

void read_ascii(const PlyHeader& header, LineReader& lines, PointRows& rows) {
  for (const PlyElement& element : header.elements) {
    // A row without properties takes no line.
    if (element.properties.empty()) continue;
    const bool is_vertex = &element == &header.elements[header.vertex];
    if (is_vertex) rows.reserve(element.count, lines.rest().size(), 6);
    std::string_view line;
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (!lines.next_filled(line)) reject_missing_rows(element, row, lines.file());
      const std::array<std::string_view, 3> fields = read_ascii_row(header, element, line, lines.place());
      if (is_vertex) rows.add(fields, lines.place());
    }
  }
  if (std::string_view line; lines.next_filled(line)) lines.place().reject("a line after all rows announced");
}

class BinaryRows {
 public:
  BinaryRows(std::string_view bytes, bool big_endian, std::string_view file)
      : rest_(bytes), big_endian_(big_endian), file_(file) {}

  [[nodiscard]] std::string_view rest() const { return rest_; }

  // Reads row number `row` of the element; its coordinates are those of vertices alone.
  Point read_row(const PlyHeader& header, const PlyElement& element, std::uint64_t row) {
    std::array<double, 3> position{};
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.is_list) {
        skip_list(element, property, row);
        continue;
      }
      if (const auto axis = axis_of(k, header, element)) {
        position[*axis] = take(*property.type, element, row);
      } else {
        skip(property.type->size, element, row);
      }
    }
    return {position[0], position[1], position[2]};
  }

 private:
  void skip_list(const PlyElement& element, const PlyProperty& property, std::uint64_t row) {
    const double length = take(*property.count_type, element, row);
    if (length < 0) {
      reject_file(file_, fmt::format("a list of negative length in row {} of {}", row, in_quotes(element.name)));
    }
    if (length > static_cast<double>(rest_.size())) reject_missing_rows(element, row, file_);
    skip(static_cast<std::size_t>(length) * property.type->size, element, row);
  }
  // Steps over bytes, and returns where they begin.
  const char* skip(std::size_t size, const PlyElement& element, std::uint64_t row) {
    if (rest_.size() < size) reject_missing_rows(element, row, file_);
    const char* const bytes = rest_.data();
    rest_.remove_prefix(size);
    return bytes;
  }
  double take(StoredType type, const PlyElement& element, std::uint64_t row) {
    const std::optional<double> value = stored_number(skip(type.size, element, row), type, big_endian_);
    if (!value) reject_file(file_, fmt::format("row {} of {}: not exactly a double", row, in_quotes(element.name)));
    return *value;
  }

  std::string_view rest_;
  bool big_endian_;
  std::string_view file_;
};

void read_binary(const PlyHeader& header, const LineReader& lines, PointRows& points) {
  BinaryRows rows(lines.rest(), header.encoding == PlyEncoding::kBigEndian, lines.file());
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = &element == &header.elements[header.vertex];
    if (element.properties.empty()) continue;
    if (is_vertex) points.reserve(element.count, rows.rest().size(), element.smallest_row());
    // Every row takes at least a byte, so that an absurd count ends with the file.
    for (std::uint64_t row = 0; row < element.count; ++row) {
      const Point position = rows.read_row(header, element, row);
      if (is_vertex) points.add(position);
    }
  }
  reject_further_bytes(rows.rest(), lines.file());
}

}  // namespace

void read_ply(std::string_view bytes, PointRows& rows) {
  LineReader lines(bytes, rows.file());
  const PlyHeader header = read_ply_header(lines);
  const std::vector<PlyProperty>& properties = header.elements[header.vertex].properties;
  const bool has_float = std::any_of(header.coordinates.begin(), header.coordinates.end(),
                                     [&](std::size_t k) { return properties[k].type == kFloat; });
  if (header.encoding == PlyEncoding::kAscii) {
    // The type of an ascii property is only a hint. The text counts, and is read as the nearest double.
    const char* const taken = rows.balls() == nullptr ? "the nearest doubles" : "they are written";
    if (has_float) rows.note(0, fmt::format("declared as float, but decimals: taken as {}, not floats", taken));
    read_ascii(header, lines, rows);
  } else {
    if (has_float) rows.note(0, std::string(kSinglePrecisionNote));
    read_binary(header, lines, rows);
  }
}

}  // namespace flowcert::io
