// The words of a CIF file, between blanks. Words in quotes and text between lines that begin with ';' are one word
// each. '#' starts a comment.
//
// Guarantees: nothing is copied. Throws InvalidInput for a quote or a text that does not end.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert::io {

struct CifWord {
  std::string_view text;
  bool is_quoted = false;
};

class CifWords {
 public:
  CifWords(std::string_view text, std::string_view file) : lines_(text, file) {}

  std::optional<CifWord> next() {
    for (;;) {
      while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
      if (!rest_.empty() && rest_.front() != '#') return word_of_line();
      if (!lines_.next(rest_)) return std::nullopt;
      if (rest_.starts_with(';')) return text_field();
    }
  }
  [[nodiscard]] LinePlace place() const { return lines_.place(); }

 private:
  CifWord word_of_line() {
    const char first = rest_.front();
    if (first != '\'' && first != '"') {
      const auto end = std::ranges::find_if(rest_, is_blank);
      const auto size = static_cast<std::size_t>(end - rest_.begin());
      return {std::exchange(rest_, rest_.substr(size)).substr(0, size)};
    }
    // A quote ends where a blank follows it.
    for (std::size_t k = 1; k < rest_.size(); ++k) {
      if (rest_[k] != first || (k + 1 < rest_.size() && !is_blank(rest_[k + 1]))) continue;
      return {std::exchange(rest_, rest_.substr(k + 1)).substr(1, k - 1), true};
    }
    place().reject("a quote that does not end in its line");
  }
  CifWord text_field() {
    const LinePlace start = place();
    do {
      if (!lines_.next(rest_)) start.reject("a text field that does not end");
    } while (!rest_.starts_with(';'));
    rest_.remove_prefix(1);
    return {"text", true};  // no text is of interest
  }

  LineReader lines_;
  std::string_view rest_;
};

}  // namespace flowcert::io
