// Lines and fields. The header states the guarantees.
#include "io/line_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "flowcert/point_set.h"

namespace flowcert::io {

void reject_file(std::string_view file, const std::string& reason) {
  throw InvalidInput(std::string(file) + ": " + reason);
}

void reject_missing(std::string_view file, std::uint64_t announced, std::string_view what, std::uint64_t found) {
  reject_file(file, fmt::format("{} {} announced, {} found", announced, what, found));
}

void LinePlace::reject(const std::string& reason) const {
  throw InvalidInput(std::string(file) + ":" + std::to_string(line) + ": " + reason);
}

LineReader::LineReader(std::string_view text, std::string_view file)
    : text_(text), file_(file), line_feed_(std::min(text.find('\n'), text.size())) {}

bool LineReader::next(std::string_view& line) {
  if (offset_ == text_.size()) return false;
  if (line_feed_ < offset_) line_feed_ = std::min(text_.find('\n', offset_), text_.size());
  const std::string_view up_to_line_feed = text_.substr(offset_, line_feed_ - offset_);
  line = up_to_line_feed.substr(0, up_to_line_feed.find('\r'));
  const std::size_t end = offset_ + line.size();
  // The line ends with the text, an LF, a CR LF or a lone CR.
  const bool carriage_return_and_line_feed = end + 1 == line_feed_ && line_feed_ < text_.size();
  offset_ = std::min(carriage_return_and_line_feed ? end + 2 : end + 1, text_.size());
  ++number_;
  return true;
}

bool LineReader::next_filled(std::string_view& line) {
  while (next(line)) {
    if (!is_all_blank(line)) return true;
  }
  return false;
}

bool LineReader::next_uncommented(std::string_view& line) {
  while (next(line)) {
    line = without_comment(line);
    if (!is_all_blank(line)) return true;
  }
  return false;
}

Fields::Fields(std::string_view line, Separators separators) : rest_(line), separators_(separators) { skip_blanks(); }

void Fields::skip_blanks() {
  std::size_t k = 0;
  while (k < rest_.size() && is_blank(rest_[k])) ++k;
  rest_.remove_prefix(k);
}

bool Fields::ends_field(char c) const {
  if (separators_ == Separators::kSemicolons) return c == ';';
  return is_blank(c) || (separators_ == Separators::kBlanksAndCommas && c == ',');
}

bool Fields::next(std::string_view& field) {
  if (rest_.empty()) return false;
  std::size_t k = 0;
  while (k < rest_.size() && !ends_field(rest_[k])) ++k;
  field = trimmed(rest_.substr(0, k));
  rest_.remove_prefix(k);
  skip_blanks();
  if (separators_ != Separators::kBlanks && !rest_.empty() && ends_field(rest_.front())) {
    rest_.remove_prefix(1);
    skip_blanks();
  }
  return true;
}

bool is_all_blank(std::string_view text) { return std::ranges::all_of(text, is_blank); }

std::string_view without_comment(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != std::string_view::npos && at > 0 && line[at - 1] == '.') at = line.find('#', at + 1);
  return line.substr(0, at);
}

bool is_integer(std::string_view text) {
  // Claims have long integers, and the library unrolls this one, not that of std::ranges.
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

std::vector<std::string_view> fields_of(std::string_view line, Separators separators) {
  std::vector<std::string_view> found;
  Fields fields(line, separators);
  for (std::string_view field; fields.next(field);) found.push_back(field);
  return found;
}

std::vector<std::string_view> words_of(std::string_view line) { return fields_of(line, Separators::kBlanks); }

std::vector<std::string_view> split_at(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(mark, start), text.size());
    parts.push_back(trimmed(text.substr(start, end - start)));
    start = end + 1;
  }
  return parts;
}

}  // namespace flowcert::io
