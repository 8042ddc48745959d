// The text formats XYZ, OBJ and OFF, a section for each.
//
// CGAL's readers are not used; each section says why.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <utility>

#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

// ---- XYZ ----
// XYZ and other text. A point is the first three fields of a line. Blanks, tabs or commas separate the fields. '#'
// starts a comment.
//
// CGAL's reader takes no commas, no hexadecimal floats and no fourth column, and silently skips a leading count. Here
// a line without three numbers is an error, and so is a leading count. Only the names x, y, z may stand above.
namespace {

// "x,y,z", in any case. Further names of columns may follow.
bool names_columns(std::string_view line) {
  Fields fields(line, Separators::kBlanksAndCommas);
  std::string_view field;
  for (const char axis : {'x', 'y', 'z'}) {
    if (!fields.next(field) || field.size() != 1 || (field[0] | 0x20) != axis) return false;
  }
  return true;
}

// Whether some numbers have a comma between them, and others blanks alone.
bool mixes_separators(std::string_view line) {
  if (line.find(',') == std::string_view::npos) return false;
  Fields by_commas(line, Separators::kBlanksAndCommas);
  std::string_view field;
  std::size_t count = 0;
  while (by_commas.next(field)) ++count;
  return count > static_cast<std::size_t>(std::ranges::count(line, ',')) + 1;
}

}  // namespace

PointFile read_xyz(std::string_view text, std::string_view file) {
  PointFile points;
  LineReader lines(text, file);
  std::string_view line;
  bool is_first = true;
  while (lines.next_uncommented(line)) {
    if (std::exchange(is_first, false) && names_columns(line)) continue;
    Fields fields(line, Separators::kBlanksAndCommas);
    points.rows.push_back(first_three(fields, lines.place()));
    std::string_view further;
    if (points.line_of_further_columns == 0 && fields.next(further)) {
      points.line_of_further_columns = lines.place().line;
    }
    if (points.line_of_mixed_separators == 0 && mixes_separators(line)) {
      points.line_of_mixed_separators = lines.place().line;
    }
  }
  return points;
}

// ---- OBJ ----
// OBJ. The points are the lines `v x y z`, in order. Further numbers in such a line (weight, colour) and all other
// lines are ignored.
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

}  // namespace

PointFile read_obj(std::string_view text, std::string_view file) {
  PointFile points;
  LineReader lines(text, file);
  std::string_view line;
  while (lines.next_uncommented(line)) {
    Fields fields(line, Separators::kBlanks);
    std::string_view keyword;
    if (fields.next(keyword) && keyword == "v") points.rows.push_back(first_three(fields, lines.place()));
  }
  return points;
}

bool is_obj_keyword(std::string_view word) {
  return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

// ---- OFF ----
// OFF: a keyword, the three counts on its line or the next, then a line for each vertex and each face. '#' starts a
// comment.
//
// CGAL's reader is not used. If a file is cut short, or has a short row or NaN, it drops rows and reports success.
// Here all announced vertices must be there. Faces are not read, but they are counted. A file with too few faces was
// cut short, and then its last vertex cannot be trusted either.
namespace {

struct OffCounts {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
};

OffCounts parse_counts(Fields& fields, const LinePlace& place) {
  std::array<std::uint64_t, 3> counts{};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    std::string_view field;
    if (!fields.next(field)) place.reject("too few counts: " + std::to_string(k) + " of 3");
    const char* const end = field.data() + field.size();
    const auto result = std::from_chars(field.data(), end, counts[k]);
    if (result.ec != std::errc() || result.ptr != end) place.reject("not a count: " + in_quotes(field));
  }
  return {.vertices = counts[0], .faces = counts[1]};
}

OffCounts read_header(LineReader& lines) {
  std::string_view line;
  if (!lines.next_uncommented(line)) reject_file(lines.file(), "not an OFF file: no keyword OFF");
  Fields fields(line, Separators::kBlanks);
  std::string_view keyword;
  fields.next(keyword);
  if (!is_off_keyword(keyword)) {
    lines.place().reject("not an OFF file: begins with " + in_quotes(keyword) + ", not OFF, COFF, NOFF or CNOFF");
  }
  Fields after_keyword = fields;
  std::string_view field;
  if (after_keyword.next(field)) {
    if (field == "BINARY") lines.place().reject("binary OFF is not supported");
    return parse_counts(fields, lines.place());
  }
  if (!lines.next_uncommented(line)) reject_file(lines.file(), "cut short: no counts after " + std::string(keyword));
  Fields counts(line, Separators::kBlanks);
  return parse_counts(counts, lines.place());
}

}  // namespace

PointFile read_off(std::string_view text, std::string_view file) {
  PointFile points;
  LineReader lines(text, file);
  const OffCounts counts = read_header(lines);
  // A row takes at least six bytes ("0 0 0" and its line's end), whatever the header announces.
  points.rows.reserve(std::min<std::uint64_t>(counts.vertices, lines.rest().size() / 6 + 1));
  std::string_view line;
  while (points.rows.size() < counts.vertices) {
    if (!lines.next_uncommented(line)) {
      reject_file(file, std::to_string(counts.vertices) + " vertices announced, " + std::to_string(points.rows.size()) +
                            " found");
    }
    Fields fields(line, Separators::kBlanks);
    points.rows.push_back(first_three(fields, lines.place()));
  }
  for (std::uint64_t face = 0; face < counts.faces; ++face) {
    if (!lines.next_uncommented(line)) {
      reject_file(file, std::to_string(counts.faces) + " faces announced, " + std::to_string(face) + " found");
    }
  }
  return points;
}

bool is_off_keyword(std::string_view word) {
  return word == "OFF" || word == "COFF" || word == "NOFF" || word == "CNOFF";
}

}  // namespace flowcert::io
