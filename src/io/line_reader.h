// Lines and fields of a text in memory, with line numbers for messages. All readers of text use them.
//
// Guarantees: nothing is copied. A line ends with LF, CR LF or a lone CR. Without the lone CR, a file of CRs would be
// one long line, and only its first three numbers would be read. The last line needs no end. Takes time linear in the
// text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "flowcert/point_set.h"
#include "flowcert/read_points.h"
#include "io/layer.h"

namespace flowcert::io {

// Throws InvalidInput "FILE: reason".
[[noreturn]] void reject_file(std::string_view file, const std::string& reason);

// Where a line is, for messages.
struct LinePlace {
  std::string_view file;
  std::size_t line = 0;

  // Throws InvalidInput "FILE:LINE: reason".
  [[noreturn]] void reject(const std::string& reason) const;
};

class LineReader {
 public:
  LineReader(std::string_view text, std::string_view file);

  // The next line, without its end; false after the last.
  bool next(std::string_view& line);
  // The next line with anything but blanks.
  bool next_filled(std::string_view& line);
  // The next line with anything but blanks before a '#'. Gives the part before the '#'.
  bool next_uncommented(std::string_view& line);

  // Where the line given last is.
  [[nodiscard]] LinePlace place() const { return {.file = file_, .line = number_}; }
  [[nodiscard]] std::string_view file() const { return file_; }
  // What follows the line given last.
  [[nodiscard]] std::string_view rest() const { return text_.substr(offset_); }

 private:
  std::string_view text_;
  std::string_view file_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
  // The first LF at or after offset_, or the text's size. It is kept, so that lone CRs do not lead to repeated
  // searches.
  std::size_t line_feed_ = 0;
};

// What may stand between the fields of a line. A comma closes a field, so there is an empty field between two commas
// in a row.
enum class Separators { kBlanks, kBlanksAndCommas };

// The fields of a line, one by one.
class Fields {
 public:
  Fields(std::string_view line, Separators separators);

  bool next(std::string_view& field);

 private:
  void skip_blanks();

  std::string_view rest_;
  bool commas_;
};

// The next field as a coordinate.
[[nodiscard]] double coordinate(std::string_view field, const LinePlace& place);

// A point from the next three fields. Any further fields are not looked at.
[[nodiscard]] Point first_three(Fields& fields, const LinePlace& place);

[[nodiscard]] inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// ---- Formats ----
// The readers of the formats; read_points.cpp chooses between them.
//
// Each takes the whole file, decompressed and without a byte order mark. The file is not blank. Each reader
// guarantees what flowcert/read_points.h promises, and leaves PointFile::format to the caller.
[[nodiscard]] PointFile read_xyz(std::string_view text, std::string_view file);
[[nodiscard]] PointFile read_off(std::string_view text, std::string_view file);
[[nodiscard]] PointFile read_ply(std::string_view bytes, std::string_view file);
[[nodiscard]] PointFile read_obj(std::string_view text, std::string_view file);
// Only the atoms of these chains; of all if none is named.
[[nodiscard]] PointFile read_pdb(std::string_view text, std::string_view file, const std::vector<std::string>& chains);
[[nodiscard]] PointFile read_mmcif(std::string_view text, std::string_view file,
                                   const std::vector<std::string>& chains);

// Whether `word` is one of the keywords that an OFF file can begin with.
[[nodiscard]] bool is_off_keyword(std::string_view word);
// Whether `word` can begin a PDB file.
[[nodiscard]] bool is_pdb_record(std::string_view word);
// Whether `word` can begin a line of an OBJ file.
[[nodiscard]] bool is_obj_keyword(std::string_view word);

}  // namespace flowcert::io
