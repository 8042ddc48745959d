// Text that is not our own, for a terminal, a report or a log: names of files and programs, what a file or a claim
// says, what a program under test writes.
//
// Guarantees: the result is one line and valid UTF-8. It has no control character, none that changes the direction of
// text or is not seen, and no byte that is no UTF-8; these stand there as \n, \x1b, \u202e. All other characters stay.
// What is in this form stays in it. All such text goes through here.
#pragma once

#include <string>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

[[nodiscard]] std::string on_one_line(std::string_view text);

// JSON whose strings have other people's text: the same value, with such characters as \u202e. Line ends stay.
[[nodiscard]] std::string json_with_escapes(std::string_view json);

// The front of the text, cut between characters: `most` bytes at most.
[[nodiscard]] std::string_view front_of(std::string_view text, std::size_t most);

}  // namespace flowcert::io
