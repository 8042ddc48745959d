#include "cli/wrapped_text.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>

namespace flowcert::cli {

namespace {

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

// How many bytes of the text its first `columns` columns have.
std::size_t bytes_of(std::string_view text, std::size_t columns) {
  std::size_t at = 0;
  while (at < text.size() && (columns > 0 || continues_character(text[at]))) {
    if (!continues_character(text[at])) --columns;
    ++at;
  }
  return at;
}

// Where to break a line of which only the first `room` bytes fit. `first` is where its first word begins.
std::size_t break_of(std::string_view line, std::size_t first, std::size_t room) {
  const std::size_t blank = line.rfind(' ', room);
  if (blank != std::string_view::npos && blank > first) return blank;
  const std::size_t mark = line.find_last_of(",;/", room - 1);
  return mark != std::string_view::npos && mark > first ? mark + 1 : room;
}

void append_line(std::string& lines, std::string_view line, const std::string& indent, std::size_t width) {
  std::size_t room = width;
  while (columns_of(line) > room) {
    const std::size_t first = line.find_first_not_of(' ');
    const std::size_t at = first == std::string_view::npos ? 0 : break_of(line, first, bytes_of(line, room));
    const std::string_view head = line.substr(0, at);
    lines += head.substr(0, head.find_last_not_of(' ') + 1);
    const std::size_t next = line.find_first_not_of(' ', at);
    if (next == std::string_view::npos) return;
    lines += '\n' + indent;
    line.remove_prefix(next);
    room = width - indent.size();
  }
  lines += line;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues_character));
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  const std::string blanks(std::min(indent, width / 4 * 3), ' ');
  std::string lines;
  while (true) {
    const std::size_t end = text.find('\n');
    append_line(lines, text.substr(0, end), blanks, width);
    if (end == std::string_view::npos) break;
    lines += '\n';
    text.remove_prefix(end + 1);
  }
  std::ranges::replace(lines, kFixedBlank, ' ');
  return lines;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  boost::algorithm::split(lines, text, [](char c) { return c == '\n'; });
  return lines;
}

}  // namespace flowcert::cli
