// The text formats OBJ and OFF, a section for each.
//
// CGAL's readers are not used; each section says why.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

// ---- OBJ ----
// The points are the lines `v x y z`, in order. Further numbers in such a line (weight, colour) and all other
// lines are ignored. A line that ends with `\` goes on in the next.
//
// CGAL has no reader of points for OBJ, and its polygon-soup reader refuses files without faces.
namespace {

// The keywords of all lines that an OBJ file can have.
constexpr auto kKeywords = std::to_array<std::string_view>(
    {"v",        "vt",   "vn",     "vp",     "cstype",     "deg",       "bmat",  "step",  "p",
     "l",        "f",    "curv",   "curv2",  "surf",       "parm",      "trim",  "hole",  "scrv",
     "sp",       "end",  "con",    "g",      "s",          "mg",        "o",     "bevel", "c_interp",
     "d_interp", "lod",  "usemtl", "mtllib", "shadow_obj", "trace_obj", "ctech", "stech", "usemap",
     "maplib",   "call", "csh",    "res",    "bsp",        "bzp",       "cdc",   "cdp",   "fo"});

// The line that goes on after those that end with `\`. A comment does not go on. joined: a place for it.
std::string_view whole_line(std::string_view line, LineReader& lines, std::string& joined) {
  if (!line.ends_with('\\') || line.find('#') != std::string_view::npos) return line;
  joined.clear();
  do {
    joined.append(line.substr(0, line.size() - 1)).append(1, ' ');
    if (!lines.next(line)) lines.place().reject("the last line ends with \\");
  } while (line.ends_with('\\') && line.find('#') == std::string_view::npos);
  return joined.append(line);
}

}  // namespace

void read_obj(std::string_view text, PointRows& rows) {
  LineReader lines(text, rows.file());
  std::string joined;
  bool is_known = true;
  for (std::string_view line; lines.next(line);) {
    const LinePlace start = lines.place();
    line = whole_line(line, lines, joined);
    Fields fields(without_comment(line), Separators::kBlanks);
    std::string_view keyword;
    if (!fields.next(keyword)) continue;
    if (keyword == "v") add_first_three(fields, start, rows);
    is_known = is_known && is_obj_keyword(keyword);
  }
  if (rows.count() == 0 && !is_known) reject_file(rows.file(), "no line begins with v");
}

bool is_obj_keyword(std::string_view word) { return std::ranges::find(kKeywords, word) != kKeywords.end(); }

// ---- OFF ----
// OFF: a keyword, the counts of vertices, faces and edges on its line or the next, then a line for each vertex and each
// face. '#' starts a comment. The count of edges may be missing, and the first one glued to the keyword.
//
// CGAL's reader is not used. If a file is cut short, or has a short row or NaN, it drops rows and reports success.
// Here all announced vertices and faces must be there, and nothing else: a file with too few faces was cut short, and
// after a count that is too small rows are left.
namespace {

struct OffHeader {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
};

OffHeader read_off_header(LineReader& lines) {
  std::string_view line;
  if (!lines.next_uncommented(line)) reject_file(lines.file(), "not an OFF file: no keyword OFF");
  line = trimmed(line);
  const std::string_view keyword = off_keyword(line);
  if (keyword.empty()) {
    lines.place().reject("not an OFF file: begins with " + in_quotes(words_of(line).front()) + ", not OFF");
  }
  if (keyword.find('4') != std::string_view::npos) lines.place().reject("points of four dimensions: 4OFF");
  std::vector<std::string_view> words = words_of(line.substr(keyword.size()));
  if (!words.empty() && words[0] == "BINARY") lines.place().reject("binary OFF is not supported");
  std::size_t at = 0;
  const auto next_count = [&] {
    if (at == words.size()) {
      if (!lines.next_uncommented(line))
        reject_file(lines.file(), fmt::format("cut short: no counts after {}", keyword));
      words = words_of(line);
      at = 0;
    }
    return written_count(words[at++], lines.place());
  };
  if (keyword.find('n') != std::string_view::npos) {
    if (const std::uint64_t dimension = next_count(); dimension != 3) {
      lines.place().reject(fmt::format("points of {} dimensions, not of 3", dimension));
    }
  }
  OffHeader header{.vertices = next_count()};
  if (at < words.size()) header.faces = next_count();
  if (at < words.size()) (void)next_count();
  return header;
}

}  // namespace

void read_off(std::string_view text, PointRows& rows) {
  LineReader lines(text, rows.file());
  const OffHeader header = read_off_header(lines);
  rows.reserve(header.vertices, lines.rest().size(), 6);
  std::string_view line;
  for (std::uint64_t row = 0; row < header.vertices; ++row) {
    if (!lines.next_uncommented(line)) reject_missing(rows.file(), header.vertices, "vertices", row);
    Fields fields(line, Separators::kBlanks);
    add_first_three(fields, lines.place(), rows);
  }
  for (std::uint64_t face = 0; face < header.faces; ++face) {
    if (!lines.next_uncommented(line)) reject_missing(rows.file(), header.faces, "faces", face);
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() <= written_count(words[0], lines.place())) lines.place().reject("a face lacks vertices");
  }
  if (lines.next_uncommented(line) && is_row_of_numbers(line)) {
    lines.place().reject(fmt::format("a row after the {} vertices and {} faces that the header announces",
                                     header.vertices, header.faces));
  }
}

std::string_view off_keyword(std::string_view word) {
  // Geomview's prefixes, in any order: texture, colours, normals, four dimensions, any dimension.
  std::size_t size = 0;
  for (int prefixes = 0; prefixes < 5; ++prefixes) {
    for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
      if (word.substr(size).starts_with(prefix)) size += prefix.size();
    }
  }
  const std::string_view rest = word.substr(size);
  if (!rest.starts_with("OFF") && (size > 0 || !rest.starts_with("off"))) return {};
  size += 3;
  const bool ends = size == word.size() || is_blank(word[size]) || is_digit(word[size]) || word[size] == '#';
  return ends ? word.substr(0, size) : std::string_view();
}

}  // namespace flowcert::io
