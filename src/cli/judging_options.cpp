// See judging_options.h.
#include "cli/judging_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "io/number_text.h"

namespace flowcert::cli {

namespace {

// With a larger one there is hardly a claim that is not ambiguous.
constexpr double kLargestTolerance = 1e-3;

// CLI11's own range takes nan for a number in it. Returns what is wrong.
std::string is_small_tolerance(const std::string& word) {
  const NumberText number = parse_number(word);
  const bool is_small = number.fault == nullptr && 0 <= number.value && number.value <= kLargestTolerance;
  return is_small ? "" : fmt::format("{} is no number from 0 to {}", in_quotes(word), kLargestTolerance);
}

}  // namespace

void add_judging_options(CLI::App& command, CheckOptions& options) {
  command
      .add_option("--tolerance", options.tolerance,
                  "Positions and radii claimed in decimals match within this part of the radius")
      ->check(is_small_tolerance)
      ->capture_default_str();
  command.add_option("--levels", options.highest_level, "Check levels 1 to this one")
      ->check(CLI::Range(1, kLevels))
      ->capture_default_str();
}

}  // namespace flowcert::cli
