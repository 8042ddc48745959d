// Lines and fields of a text in memory, with line numbers for messages. All readers of text use them.
//
// Guarantees: nothing is copied. A line ends with LF, CR LF or a lone CR. Without the lone CR, a file of CRs would be
// one long line, and only its first three numbers would be read. The last line needs no end. Takes time linear in the
// text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/layer.h"

namespace flowcert::io {

// Throws InvalidInput "FILE: reason".
[[noreturn]] void reject_file(std::string_view file, const std::string& reason);
// The reason: fewer rows than a header announces. what: as "points".
[[noreturn]] void reject_missing(std::string_view file, std::uint64_t announced, std::string_view what,
                                 std::uint64_t found);

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
  // The next line with anything but blanks before a comment. Gives the part before the comment.
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

// What may stand between the fields of a line. A comma or semicolon closes a field, so there is an empty field between
// two in a row. Where semicolons separate, blanks do not.
enum class Separators { kBlanks, kBlanksAndCommas, kSemicolons };

// The fields of a line, one by one.
class Fields {
 public:
  Fields(std::string_view line, Separators separators);

  bool next(std::string_view& field);

 private:
  void skip_blanks();

  [[nodiscard]] bool ends_field(char c) const;

  std::string_view rest_;
  Separators separators_;
};

[[nodiscard]] inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
[[nodiscard]] bool is_all_blank(std::string_view text);
// Without what follows a '#'. In Microsoft's "1.#INF" there is no comment.
[[nodiscard]] std::string_view without_comment(std::string_view line);
// Digits alone, and one at least.
[[nodiscard]] bool is_integer(std::string_view text);
// Without blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
// ASCII letters alone; the locale has no influence.
[[nodiscard]] std::string lower_case(std::string_view text);
[[nodiscard]] std::vector<std::string_view> fields_of(std::string_view line, Separators separators);
// The fields between blanks.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);
// The parts between marks, trimmed; one more than there are marks.
[[nodiscard]] std::vector<std::string_view> split_at(std::string_view text, char mark);

}  // namespace flowcert::io
