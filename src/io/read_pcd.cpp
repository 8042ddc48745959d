// PCD, the format of the Point Cloud Library, in ascii and binary: the fields x, y and z.
//
// Our own reader, because PCL is 300 packages for 200 lines; and PCL takes NaN, and a file that is cut short, without a
// word. Compressed binary is refused. Source: PCL's description of version 0.7.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

namespace {

constexpr auto kPcdKeywords = std::to_array<std::string_view>(
    {"VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"});

// Where a coordinate is in a row.
struct PcdPlace {
  std::size_t value = 0;   // in ascii, among the row's values
  std::size_t offset = 0;  // in binary, in bytes
  StoredType type;
};

struct PcdHeader {
  std::array<PcdPlace, 3> places;
  std::size_t values = 0;  // of a row
  std::size_t bytes = 0;   // of a row
  std::uint64_t points = 0;
  bool is_binary = false;
};

class PcdHeaderReader {
 public:
  PcdHeaderReader(LineReader& lines, PointRows& rows) : lines_(lines), rows_(rows) {}

  PcdHeader read() {
    std::string_view line;
    do {
      if (!lines_.next_uncommented(line)) reject_file(lines_.file(), "cut short: no line DATA in the PCD header");
      std::vector<std::string_view> words = words_of(line);
      const std::string_view keyword = words[0];
      if (!is_pcd_keyword(keyword)) reject("not a line of a PCD header: " + in_quotes(keyword));
      words.erase(words.begin());
      if (words.empty()) reject("nothing after " + std::string(keyword));
      if (!entries_.emplace(keyword, Entry{words, lines_.place()}).second)
        reject("a second line " + std::string(keyword));
    } while (!entries_.contains("DATA"));
    return header();
  }

 private:
  struct Entry {
    std::vector<std::string_view> words;
    LinePlace place;
  };

  [[noreturn]] void reject(const std::string& reason) const { lines_.place().reject(reason); }

  const Entry& entry(const char* keyword) const {
    const auto found = entries_.find(keyword);
    if (found == entries_.end()) reject(fmt::format("no line {} in the PCD header", keyword));
    return found->second;
  }
  [[nodiscard]] std::uint64_t count(const Entry& of, std::size_t k) const {
    return written_count(of.words[k], of.place);
  }

  [[nodiscard]] PcdHeader header() const {
    PcdHeader header;
    const std::string_view data = entry("DATA").words[0];
    if (data == "binary_compressed") reject("compressed binary PCD is not read: write it as ascii or binary");
    if (data != "ascii" && data != "binary") reject("not a kind of PCD data: " + in_quotes(data));
    header.is_binary = data == "binary";
    header.points = points();
    see_fields(header);
    if (entries_.contains("VIEWPOINT") && !is_identity(entry("VIEWPOINT").words)) {
      rows_.note(entry("VIEWPOINT").place.line, "the viewpoint is ignored; the points are as the file has them");
    }
    return header;
  }

  [[nodiscard]] std::uint64_t points() const {
    const std::uint64_t width = count(entry("WIDTH"), 0);
    const std::uint64_t height = entries_.contains("HEIGHT") ? count(entry("HEIGHT"), 0) : 1;
    const bool overflows = height != 0 && width > std::numeric_limits<std::uint64_t>::max() / height;
    const std::uint64_t points = entries_.contains("POINTS") ? count(entry("POINTS"), 0) : width * height;
    if (overflows || points != width * height) reject("POINTS is not WIDTH times HEIGHT");
    return points;
  }

  void see_fields(PcdHeader& header) const {
    const Entry &fields = entry("FIELDS"), &sizes = entry("SIZE"), &types = entry("TYPE");
    const std::size_t size = fields.words.size();
    const bool has_counts = entries_.contains("COUNT");
    if (sizes.words.size() != size || types.words.size() != size ||
        (has_counts && entry("COUNT").words.size() != size)) {
      reject("FIELDS, SIZE, TYPE and COUNT have different lengths");
    }
    std::array<bool, 3> is_found{};
    for (std::size_t k = 0; k < size; ++k) {
      const std::uint64_t bytes = count(sizes, k), repeats = has_counts ? count(entry("COUNT"), k) : 1;
      if (bytes == 0 || bytes > 8 || repeats > 1000000)
        reject("a field of no size, or too large: " + in_quotes(fields.words[k]));
      const std::size_t axis = std::string_view("xyz").find(fields.words[k]);
      if (fields.words[k].size() == 1 && axis < 3) {
        const std::optional<StoredType> type = stored_type(kind_of(types.words[k]), bytes);
        if (!type || repeats != 1)
          reject("the field " + in_quotes(fields.words[k]) + " is not one number of a known type");
        if (std::exchange(is_found[axis], true)) reject("a second field " + in_quotes(fields.words[k]));
        header.places[axis] = {header.values, header.bytes, *type};
      }
      header.values += repeats;
      header.bytes += bytes * repeats;
    }
    if (!is_found[0] || !is_found[1] || !is_found[2]) reject("the fields x, y and z are not all there");
  }

  static char kind_of(std::string_view letter) {
    return letter == "F" ? 'f' : letter == "I" ? 'i' : letter == "U" ? 'u' : ' ';
  }
  static bool is_identity(const std::vector<std::string_view>& words) {
    static constexpr std::array<double, 7> kIdentity = {0, 0, 0, 1, 0, 0, 0};
    return std::ranges::equal(words, kIdentity, [](std::string_view word, double value) {
      const NumberText number = parse_number(word);
      return number.fault == nullptr && number.value == value;
    });
  }

  LineReader& lines_;
  PointRows& rows_;
  std::map<std::string_view, Entry> entries_;
};

void read_ascii(const PcdHeader& header, LineReader& lines, PointRows& rows) {
  rows.reserve(header.points, lines.rest().size(), 2 * header.values);
  std::string_view line;
  for (std::uint64_t point = 0; point < header.points; ++point) {
    if (!lines.next_filled(line)) reject_missing(lines.file(), header.points, "points", point);
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() != header.values) {
      lines.place().reject(fmt::format("{} values, and the header announces {}", words.size(), header.values));
    }
    rows.add({words[header.places[0].value], words[header.places[1].value], words[header.places[2].value]},
             lines.place());
  }
  if (lines.next_filled(line)) lines.place().reject(fmt::format("a line after the {} points announced", header.points));
}

void read_binary(const PcdHeader& header, std::string_view bytes, PointRows& rows) {
  const std::uint64_t available = bytes.size() / header.bytes;
  if (available < header.points) reject_missing(rows.file(), header.points, "points", available);
  rows.reserve(header.points, bytes.size(), header.bytes);
  for (std::uint64_t point = 0; point < header.points; ++point) {
    std::array<double, 3> position{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const PcdPlace& place = header.places[axis];
      const char* const at = bytes.data() + point * header.bytes + place.offset;
      const std::optional<double> value = stored_number(at, place.type, false);
      if (!value) reject_file(rows.file(), fmt::format("point {}: not exactly a double", point));
      position[axis] = *value;
    }
    rows.add(Point{position[0], position[1], position[2]});
  }
  reject_further_bytes(bytes.substr(static_cast<std::size_t>(header.points * header.bytes)), rows.file());
}

}  // namespace

void read_pcd(std::string_view bytes, PointRows& rows) {
  LineReader lines(bytes, rows.file());
  const PcdHeader header = PcdHeaderReader(lines, rows).read();
  if (!header.is_binary) {
    read_ascii(header, lines, rows);
    return;
  }
  const bool has_float = std::ranges::any_of(header.places, [](const PcdPlace& place) { return place.type == kFloat; });
  if (has_float) rows.note(0, std::string(kSinglePrecisionNote));
  read_binary(header, lines.rest(), rows);
}

bool is_pcd_keyword(std::string_view word) { return std::ranges::find(kPcdKeywords, word) != kPcdKeywords.end(); }

}  // namespace flowcert::io
