// What all command lines have in common: help within 80 columns, and one line that says what is wrong with one and what
// to write instead.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "cli/layer.h"

namespace CLI {
class App;
class FormatterBase;
class ParseError;
}  // namespace CLI

namespace flowcert::cli {

// CLI11's help, broken at 80 columns, with two examples before the options (described_command.h). A program gives it to
// its App before it adds commands, which then have it too.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

// The group of commands that no overview has.
inline constexpr char kSetUpGroup[] = "Set up a shell";

// What the program can do, when it is asked for nothing: groups of commands with a line each, and what to begin with.
// At most 24 lines of 80 columns.
[[nodiscard]] std::string overview(const CLI::App& app);

// What is wrong with a command line that `app` has refused, with the nearest command or option and whose help to see.
// `words` are all of its words but the program's name.
[[nodiscard]] std::string complaint_about(const CLI::App& app, const CLI::ParseError& error,
                                          std::span<const std::string> words);

// How many letters have to be put in, left out or replaced to make one word of the other.
[[nodiscard]] std::size_t edits_between(std::string_view one, std::string_view other);

}  // namespace flowcert::cli
