// OBJ: the lines `v x y z`, in order; further numbers of such a line (weight, colour) and all other lines are
// ignored.
//
// CGAL has no reader of points for OBJ, and its polygon-soup reader refuses files without faces.
#include <algorithm>
#include <array>

#include "io/line_reader.h"
#include "io/point_formats.h"

namespace flowcert::io {
namespace {

// Of all the lines that an OBJ file can have.
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

}  // namespace flowcert::io
