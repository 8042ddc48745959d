// PLY: the element `vertex`, wherever it is among the elements; of it, the properties x, y, z, in any order.
//
// CGAL's reader is not used: it says nothing about a file that is cut short, takes binary NaN, and makes z
// zero where there is none. (Debian has no rply.) Here all elements are walked through, the ignored ones too:
// a file that ends before all that its header announces was cut short. In ascii a row is a line; values
// beyond a row's are ignored.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "io/line_reader.h"
#include "io/number_text.h"
#include "io/ply_header.h"
#include "io/point_formats.h"

namespace flowcert::io {
namespace {

[[noreturn]] void reject_missing_rows(const PlyElement& element, std::uint64_t found, std::string_view file) {
  const std::string what = element.name == "vertex" ? "vertices" : "rows of " + in_quotes(element.name);
  reject_file(file,
              std::to_string(element.count) + " " + what + " announced, " + std::to_string(found) + " found");
}

// A row's values are handed to a sink, with the ordinal of the property; lists are stepped over.
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

// The values of one line of an ascii element. `sink` may be null.
void read_ascii_row(const PlyElement& element, std::string_view line, const LinePlace& place,
                    CoordinateSink* sink) {
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
      // Ends with the line's fields at the latest, however long the list claims to be.
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
    // Rows of nothing take no line.
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
    value = static_cast<Unsigned>(value | static_cast<Unsigned>(static_cast<unsigned char>(bytes[k]))
                                              << (8 * place));
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

  // Row number `row` of the element. `sink` may be null.
  void read_row(const PlyElement& element, std::uint64_t row, CoordinateSink* sink) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.is_list) {
        const double length = take(property.count_type, element, row);
        if (length < 0)
          reject_file(file_, "a list of negative length in row " + std::to_string(row) + " of " +
                                 in_quotes(element.name));
        const std::uint64_t bytes = static_cast<std::uint64_t>(length) * size_of(property.type);
        if (rest_.size() < bytes) reject_missing_rows(element, row, file_);
        rest_.remove_prefix(bytes);
        continue;
      }
      const double value = take(property.type, element, row);
      if (sink == nullptr || !sink->wants(k)) continue;
      if (!std::isfinite(value)) {
        reject_file(file_, "vertex " + std::to_string(row) + ": not a finite number: property " +
                               in_quotes(property.name));
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
    if (is_vertex)
      points.rows.reserve(std::min<std::uint64_t>(element.count, rows.size() / element.smallest_row()));
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
    // The type of an ascii property is only a hint: what counts is the text, read as the nearest double.
    points.declares_single_precision = has_float;
    read_ascii(header, lines, points);
    return points;
  }
  points.single_precision = has_float;
  read_binary(header, lines, points);
  return points;
}

}  // namespace flowcert::io
