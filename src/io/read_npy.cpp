// NPY, NumPy's file of one array: of shape (n,3), or (n,2) where the user gives z.
//
// Our own reader: Debian has no library of C++ for NPY, and this is a header of one line and the numbers. Arrays of
// Python objects are refused, and so is every type but plain numbers. Source: NEP 1, versions 1 to 3 of the format.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

namespace {

struct NpyHeader {
  std::string_view type;   // as "<f8"
  std::string_view shape;  // as "(5, 3)"
  bool is_fortran = false;
  std::string_view data;
};

// The text after 'key': in the header, a dictionary as Python writes it, up to `end`.
std::string_view value_of(std::string_view dictionary, std::string_view key, std::string_view end,
                          std::string_view file) {
  const std::size_t at = dictionary.find(fmt::format("'{}':", key));
  if (at == std::string_view::npos) reject_file(file, fmt::format("the NPY header has no '{}'", key));
  const std::string_view value = dictionary.substr(at + key.size() + 3);
  const std::size_t size = value.find_first_of(end);
  if (size == std::string_view::npos) reject_file(file, fmt::format("the NPY header's '{}' does not end", key));
  return trimmed(value.substr(0, size));
}

NpyHeader header_of(std::string_view bytes, std::string_view file) {
  const auto byte = [&](std::size_t k) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[k])); };
  const bool is_first_version = bytes.size() > 6 && byte(6) == 1;
  const std::size_t start = is_first_version ? 10 : 12;
  if (!bytes.starts_with("\x93NUMPY") || bytes.size() < start)
    reject_file(file, "cut short: the NPY header is not all there");
  std::size_t size = byte(8) + 256 * byte(9);
  if (!is_first_version) size += 65536 * (byte(10) + 256 * byte(11));
  if (byte(6) < 1 || byte(6) > 3) reject_file(file, fmt::format("not a known version of NPY: {}", byte(6)));
  if (bytes.size() < start + size) reject_file(file, "cut short: the NPY header is not all there");
  const std::string_view dictionary = bytes.substr(start, size);
  NpyHeader header;
  header.type = value_of(dictionary, "descr", ",}", file);
  header.shape = value_of(dictionary, "shape", ")}", file);
  const std::string_view order = value_of(dictionary, "fortran_order", ",}", file);
  if (order != "True" && order != "False")
    reject_file(file, "the NPY header's 'fortran_order' is neither True nor False");
  header.is_fortran = order == "True";
  header.data = bytes.substr(start + size);
  return header;
}

struct NumberType {
  StoredType type;
  bool is_big_endian = false;
};

// "'<f8'"
NumberType type_of(std::string_view text, std::string_view file) {
  const bool is_quoted = text.size() > 2 && text.front() == '\'' && text.back() == '\'';
  if (is_quoted && text.size() == 5 && std::string_view("<>|").find(text[1]) != std::string_view::npos) {
    const std::optional<StoredType> type = stored_type(text[2], static_cast<std::uint64_t>(text[3] - '0'));
    if (type) return {*type, text[1] == '>'};
  }
  reject_file(file, fmt::format("an array of type {}; f4, f8 and integers are read",
                                in_quotes(is_quoted ? text.substr(1, text.size() - 2) : text)));
}

// "(5, 3" as rows and columns.
std::array<std::uint64_t, 2> shape_of(std::string_view text, std::size_t columns, std::string_view file) {
  std::array<std::uint64_t, 2> shape{};
  const std::vector<std::string_view> parts = split_at(text.substr(text.starts_with('(') ? 1 : 0), ',');
  bool is_right = text.starts_with('(') && parts.size() == 2;
  for (std::size_t k = 0; k < 2 && is_right; ++k) {
    const auto result = std::from_chars(parts[k].data(), parts[k].data() + parts[k].size(), shape[k]);
    is_right = result.ec == std::errc() && result.ptr == parts[k].data() + parts[k].size();
  }
  if (is_right && shape[1] == 2 && columns == 3) {
    reject_file(file, "points of two coordinates: --z 0 makes their z 0");
  }
  if (!is_right || shape[1] != columns) {
    reject_file(file, fmt::format("an array of shape {}; points have the shape (n, {})",
                                  in_quotes(std::string(text) + ')'), columns));
  }
  return shape;
}

}  // namespace

void read_npy(std::string_view bytes, PointRows& rows) {
  const NpyHeader header = header_of(bytes, rows.file());
  const std::optional<double> z = rows.options().z;
  const std::size_t columns = z ? 2 : 3;
  const auto [count, width] = shape_of(header.shape, columns, rows.file());
  const NumberType type = type_of(header.type, rows.file());
  const std::size_t size = type.type.size;
  const std::uint64_t available = header.data.size() / (size * columns);
  if (available < count) reject_missing(rows.file(), count, "points", available);
  if (header.data.size() > count * columns * size) reject_file(rows.file(), "more bytes than the array announced has");
  if (type.type == kFloat) rows.note(0, std::string(kSinglePrecisionNote));
  rows.reserve(count, header.data.size(), size * columns);
  for (std::uint64_t row = 0; row < count; ++row) {
    std::array<double, 3> position = {0, 0, z.value_or(0)};
    for (std::size_t axis = 0; axis < columns; ++axis) {
      const std::uint64_t at = header.is_fortran ? axis * count + row : row * columns + axis;
      const std::optional<double> value = stored_number(header.data.data() + at * size, type.type, type.is_big_endian);
      if (!value) reject_file(rows.file(), fmt::format("row {}: not exactly a double", row));
      position[axis] = *value;
    }
    rows.add(Point{position[0], position[1], position[2]});
  }
}

}  // namespace flowcert::io
