// See answer_reader.h. No claim format has a line that begins with one of the three words.
#include "fuzz/judge/answer_reader.h"

#include <algorithm>
#include <istream>

#include "io/number_text.h"

namespace flowcert::judge {

namespace {

constexpr std::string_view kStream = "standard input";
constexpr std::string_view kAnswer = "answer";
constexpr std::string_view kRefused = "refused";
constexpr std::string_view kEnd = "end";

std::string_view first_word(std::string_view line) {
  std::string_view word;
  Fields(line, Separators::kBlanks).next(word);
  return word;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

LinePlace AnswerReader::place() const { return {.file = kStream, .line = number_}; }

bool AnswerReader::next_line() {
  if (!std::getline(in_, line_)) {
    if (in_.bad()) reject_file(kStream, "cannot be read");
    return false;
  }
  ++number_;
  return true;
}

void AnswerReader::read_head(Answer& answer) const {
  const std::string_view word = first_word(line_);
  if (word != kAnswer && word != kRefused) {
    place().reject("neither 'answer ID' nor 'refused ID': " + in_quotes(line_));
  }
  std::string_view rest = without_blanks(line_);
  rest = without_blanks(rest.substr(word.size()));
  const std::string_view id = first_word(rest);
  if (id.empty()) place().reject("no id of a case after " + in_quotes(word));
  rest = without_blanks(rest.substr(id.size()));
  answer = {.place = place(), .id = std::string(id), .is_refusal = word == kRefused, .text = {}};
  if (answer.is_refusal) {
    answer.text = rest;
  } else if (!rest.empty()) {
    place().reject("more than an id after 'answer': " + in_quotes(rest));
  }
}

void AnswerReader::read_claim_lines(Answer& answer) {
  while (next_line()) {
    const std::string_view word = first_word(line_);
    if (word == kEnd && without_blanks(line_) == kEnd) return;
    if (word == kAnswer || word == kRefused) {
      place().reject(in_quotes(word) + " before the 'end' of the answer of line " +
                     std::to_string(answer.place.line));
    }
    answer.text += line_;
    answer.text += '\n';
  }
  answer.place.reject("an answer without 'end': " + in_quotes(answer.id));
}

bool AnswerReader::next(Answer& answer) {
  std::string_view word;
  do {
    if (!next_line()) return false;
    word = first_word(line_);
  } while (word.empty() || word.starts_with('#'));
  read_head(answer);
  if (!answer.is_refusal) read_claim_lines(answer);
  return true;
}

}  // namespace flowcert::judge
