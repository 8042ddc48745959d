// The answers of a program to the cases of `flowcert generate`, one by one from a stream (spec/formats.md,
// "Cases and answers").
//
// Guarantees: memory is bounded by the largest answer. What an answer says is not looked at, only where it
// begins and ends; a stream in which that is not clear throws InvalidInput, "standard input:LINE: reason".
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "fuzz/judge/layer.h"
#include "io/line_reader.h"

namespace flowcert::judge {

struct Answer {
  LinePlace place;  // of its first line
  std::string id;
  bool is_refusal = false;
  // A claim, line by line as it came; of a refusal, the reason, which may be empty.
  std::string text;
};

class AnswerReader {
 public:
  explicit AnswerReader(std::istream& in) : in_(in) {}

  // The next answer; false at the end of the stream.
  bool next(Answer& answer);

 private:
  bool next_line();
  void read_head(Answer& answer) const;
  void read_claim_lines(Answer& answer);
  [[nodiscard]] LinePlace place() const;

  std::istream& in_;
  std::string line_;  // the last one read, without its LF; a CR is a blank to all who look at it
  std::size_t number_ = 0;
};

}  // namespace flowcert::judge
