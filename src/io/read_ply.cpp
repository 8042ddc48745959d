// PLY. Reads the properties x, y, z of the element `vertex`, in any order and wherever the element is.
//
// CGAL's reader is not used: it does not report a file that is cut short, takes binary NaN, and sets a missing z to
// zero. (Debian has no rply.) Here all elements are read, also the ignored ones, because a file that ends before all
// that its header announces was cut short. In ascii a row is a line, and further values in the line are ignored.
//
// Guarantees: an accepted header is enough to read the rest of the file. It has known types, valid counts, and one
// element `vertex` with exactly one scalar property for each of x, y, z. Anything else throws InvalidInput with the
// line. Counts are as announced, and may be absurd.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

// ---- The header ----

namespace {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

// In bytes.
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

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kInt8;
  // A list is a count of type `count_type`, then that many values of type `type`.
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The size of a binary row in bytes. Lists count as empty.
  [[nodiscard]] std::size_t smallest_row() const {
    std::size_t size = 0;
    for (const PlyProperty& property : properties) {
      size += size_of(property.is_list ? property.count_type : property.type);
    }
    return size;
  }
  [[nodiscard]] bool has_lists() const { return std::ranges::any_of(properties, &PlyProperty::is_list); }
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  // Where the element `vertex` is among the elements, and x, y, z among its properties.
  std::size_t vertex = 0;
  std::array<std::size_t, 3> coordinates{};
};

// Both sets of type names are in use: the original one (char, …, double) and the one with sizes (int8, …, float64).
constexpr auto kTypeNames = std::to_array<std::pair<std::string_view, PlyType>>({{"char", PlyType::kInt8},
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
    header.elements.back().properties.push_back(read_property(line));
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
  while (true) {
    if (!lines.next_filled(line)) reject_file(lines.file(), "cut short: no end_header");
    if (!read_header_line(line, lines.place(), header, format_seen)) break;
  }
  locate_coordinates(header, lines.file());
  return header;
}

// ---- Rows ----

[[noreturn]] void reject_missing_rows(const PlyElement& element, std::uint64_t found, std::string_view file) {
  const std::string what = element.name == "vertex" ? "vertices" : "rows of " + in_quotes(element.name);
  reject_file(file, std::to_string(element.count) + " " + what + " announced, " + std::to_string(found) + " found");
}

// Receives a row's values with the ordinals of their properties. Lists are skipped.
struct CoordinateSink {
  const std::array<std::size_t, 3>& ordinals;
  Point point;

  [[nodiscard]] bool wants(std::size_t property) const {
    return property == ordinals[0] || property == ordinals[1] || property == ordinals[2];
  }
  void take(std::size_t property, double value) {
    if (property == ordinals[0]) point.x = value;
    if (property == ordinals[1]) point.y = value;
    if (property == ordinals[2]) point.z = value;
  }
};

// Reads the values of one line of an ascii element. `sink` may be null.
void read_ascii_row(const PlyElement& element, std::string_view line, const LinePlace& place, CoordinateSink* sink) {
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
    } else if (sink != nullptr && sink->wants(k)) {
      sink->take(k, coordinate(field, place));
    }
  }
}

void read_ascii(const PlyHeader& header, LineReader& lines, PointFile& points) {
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    // A row without properties takes no line.
    if (element.properties.empty()) continue;
    const bool is_vertex = e == header.vertex;
    if (is_vertex) points.rows.reserve(std::min<std::uint64_t>(element.count, lines.rest().size() / 6 + 1));
    std::string_view line;
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (!lines.next_filled(line)) reject_missing_rows(element, row, lines.file());
      CoordinateSink sink{.ordinals = header.coordinates, .point = {}};
      read_ascii_row(element, line, lines.place(), is_vertex ? &sink : nullptr);
      if (is_vertex) points.rows.push_back(sink.point);
    }
  }
}

template <class Unsigned>
Unsigned load(const char* bytes, bool swap) {
  Unsigned value = 0;
  for (std::size_t k = 0; k < sizeof(Unsigned); ++k) {
    const std::size_t place = swap ? sizeof(Unsigned) - 1 - k : k;
    value = static_cast<Unsigned>(value | static_cast<Unsigned>(static_cast<unsigned char>(bytes[k])) << (8 * place));
  }
  return value;
}

// Exact: a double holds every value of every type.
double load_number(const char* bytes, PlyType type, bool big_endian) {
  switch (type) {
    case PlyType::kInt8:
      return static_cast<std::int8_t>(load<std::uint8_t>(bytes, big_endian));
    case PlyType::kUint8:
      return load<std::uint8_t>(bytes, big_endian);
    case PlyType::kInt16:
      return static_cast<std::int16_t>(load<std::uint16_t>(bytes, big_endian));
    case PlyType::kUint16:
      return load<std::uint16_t>(bytes, big_endian);
    case PlyType::kInt32:
      return static_cast<std::int32_t>(load<std::uint32_t>(bytes, big_endian));
    case PlyType::kUint32:
      return load<std::uint32_t>(bytes, big_endian);
    case PlyType::kFloat:
      return static_cast<double>(std::bit_cast<float>(load<std::uint32_t>(bytes, big_endian)));
    case PlyType::kDouble:
      return std::bit_cast<double>(load<std::uint64_t>(bytes, big_endian));
  }
  return 0;
}

class BinaryRows {
 public:
  BinaryRows(std::string_view bytes, bool big_endian, std::string_view file)
      : rest_(bytes), big_endian_(big_endian), file_(file) {}

  [[nodiscard]] std::size_t size() const { return rest_.size(); }

  // Steps over `count` rows of a fixed size.
  void skip_rows(const PlyElement& element) {
    const std::size_t size = element.smallest_row();
    if (size == 0) return;
    const std::uint64_t available = rest_.size() / size;
    if (available < element.count) reject_missing_rows(element, available, file_);
    rest_.remove_prefix(size * element.count);
  }

  // Reads row number `row` of the element. `sink` may be null.
  void read_row(const PlyElement& element, std::uint64_t row, CoordinateSink* sink) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.is_list) {
        const double length = take(property.count_type, element, row);
        if (length < 0)
          reject_file(file_,
                      "a list of negative length in row " + std::to_string(row) + " of " + in_quotes(element.name));
        const std::uint64_t bytes = static_cast<std::uint64_t>(length) * size_of(property.type);
        if (rest_.size() < bytes) reject_missing_rows(element, row, file_);
        rest_.remove_prefix(bytes);
        continue;
      }
      const double value = take(property.type, element, row);
      if (sink == nullptr || !sink->wants(k)) continue;
      if (!std::isfinite(value)) {
        reject_file(file_,
                    "vertex " + std::to_string(row) + ": not a finite number: property " + in_quotes(property.name));
      }
      sink->take(k, value);
    }
  }

 private:
  double take(PlyType type, const PlyElement& element, std::uint64_t row) {
    const std::size_t size = size_of(type);
    if (rest_.size() < size) reject_missing_rows(element, row, file_);
    const double value = load_number(rest_.data(), type, big_endian_);
    rest_.remove_prefix(size);
    return value;
  }

  std::string_view rest_;
  bool big_endian_;
  std::string_view file_;
};

void read_binary(const PlyHeader& header, const LineReader& lines, PointFile& points) {
  BinaryRows rows(lines.rest(), header.encoding == PlyEncoding::kBigEndian, lines.file());
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    const bool is_vertex = e == header.vertex;
    if (!is_vertex && !element.has_lists()) {
      rows.skip_rows(element);
      continue;
    }
    if (is_vertex) points.rows.reserve(std::min<std::uint64_t>(element.count, rows.size() / element.smallest_row()));
    // Every row takes at least a byte, so that an absurd count ends with the file.
    for (std::uint64_t row = 0; row < element.count; ++row) {
      CoordinateSink sink{.ordinals = header.coordinates, .point = {}};
      rows.read_row(element, row, is_vertex ? &sink : nullptr);
      if (is_vertex) points.rows.push_back(sink.point);
    }
  }
}

}  // namespace

PointFile read_ply(std::string_view bytes, std::string_view file) {
  PointFile points;
  LineReader lines(bytes, file);
  const PlyHeader header = read_ply_header(lines);
  const std::vector<PlyProperty>& properties = header.elements[header.vertex].properties;
  const bool has_float = std::any_of(header.coordinates.begin(), header.coordinates.end(),
                                     [&](std::size_t k) { return properties[k].type == PlyType::kFloat; });
  if (header.encoding == PlyEncoding::kAscii) {
    // The type of an ascii property is only a hint. The text counts, and is read as the nearest double.
    points.declares_single_precision = has_float;
    read_ascii(header, lines, points);
    return points;
  }
  points.single_precision = has_float;
  read_binary(header, lines, points);
  return points;
}

}  // namespace flowcert::io
