// XYZ and other text: one point a line, its first three fields; blanks, tabs or commas between, '#' starts a
// comment.
//
// CGAL's reader is not used: it takes no commas, no hexadecimal floats and no fourth column, and skips a
// leading count without a word. Here a line that is not three numbers is an error, so a leading count and a
// table's headings are.
#include "io/line_reader.h"
#include "io/point_formats.h"

namespace flowcert::io {

PointFile read_xyz(std::string_view text, std::string_view file) {
  PointFile points;
  LineReader lines(text, file);
  std::string_view line;
  while (lines.next_uncommented(line)) {
    Fields fields(line, Separators::kBlanksAndCommas);
    points.rows.push_back(first_three(fields, lines.place()));
  }
  return points;
}

}  // namespace flowcert::io
