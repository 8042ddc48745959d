// Lines, fields and rows of three numbers. The header states the guarantees.
#include "io/line_reader.h"

#include <algorithm>
#include <array>

#include "io/number_text.h"

namespace flowcert::io {

void reject_file(std::string_view file, const std::string& reason) {
  throw InvalidInput(std::string(file) + ": " + reason);
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
    if (!std::all_of(line.begin(), line.end(), is_blank)) return true;
  }
  return false;
}

bool LineReader::next_uncommented(std::string_view& line) {
  while (next(line)) {
    line = line.substr(0, line.find('#'));
    if (!std::all_of(line.begin(), line.end(), is_blank)) return true;
  }
  return false;
}

Fields::Fields(std::string_view line, Separators separators)
    : rest_(line), commas_(separators == Separators::kBlanksAndCommas) {
  skip_blanks();
}

void Fields::skip_blanks() {
  std::size_t k = 0;
  while (k < rest_.size() && is_blank(rest_[k])) ++k;
  rest_.remove_prefix(k);
}

bool Fields::next(std::string_view& field) {
  if (rest_.empty()) return false;
  std::size_t k = 0;
  while (k < rest_.size() && !is_blank(rest_[k]) && !(commas_ && rest_[k] == ',')) ++k;
  field = rest_.substr(0, k);
  rest_.remove_prefix(k);
  skip_blanks();
  if (commas_ && rest_.starts_with(',')) {
    rest_.remove_prefix(1);
    skip_blanks();
  }
  return true;
}

double coordinate(std::string_view field, const LinePlace& place) {
  const NumberText number = parse_number(field);
  if (number.fault != nullptr) place.reject(number.fault + (": " + in_quotes(field)));
  return number.value;
}

Point first_three(Fields& fields, const LinePlace& place) {
  std::array<double, 3> numbers{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::string_view field;
    if (!fields.next(field)) place.reject("too few numbers: " + std::to_string(k) + " of 3");
    numbers[k] = coordinate(field, place);
  }
  return {.x = numbers[0], .y = numbers[1], .z = numbers[2]};
}

}  // namespace flowcert::io
