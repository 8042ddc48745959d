#include "fuzz/commands/run_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "fuzz/commands/fuzz_options.h"
#include "fuzz/inputs/case_stream.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/large_family.h"
#include "fuzz/judge/drawn_cases.h"

namespace flowcert::commands {

namespace {

// No case has as many.
constexpr std::size_t kMostPointsOfCase = 1'000'000;

// Returns what is wrong.
std::string complaint_about_family(const std::string& name) {
  try {
    (void)fuzz::chosen_families({name});
    return "";
  } catch (const std::invalid_argument& error) {
    return fmt::format("{}; there are: {}", error.what(), fmt::join(fuzz::family_names({}), ", "));
  }
}

}  // namespace

void add_run_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("--level", options.level,
                  "1: 500 cases, most of up to 8 points; 2: 5,000, most of up to 10; 3: 20,000 of up to 12, "
                  "and some of hundreds")
      ->check(CLI::Range(1, fuzz::kCaseLevels))
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Another seed, other cases")
      ->check(complaint_about_seed)
      ->capture_default_str();
  command.add_option("--cases", options.cases, "So many cases, instead of those of the level")
      ->check(CLI::Range(std::size_t{1}, fuzz::kMostCases));
  command
      .add_option("--family", options.families,
                  fmt::format("Cases of this family of degeneracy; may be given again. All of them, without this: {} "
                              "of the {} families that flowcert fuzz --families list prints",
                              fuzz::families().size(), fuzz::named_families().size()))
      ->check(complaint_about_family)
      ->allow_extra_args(false)
      ->type_name("NAME");
  CLI::Option* vectors =
      command
          .add_option("--vectors", options.vectors,
                      "Instead of drawn cases the conformance vectors, without invalid ones: those in this folder, or "
                      "those that came with the program")
          ->expected(0, 1)
          ->check(CLI::ExistingDirectory)
          ->type_name("[FOLDER]");
  for (const char* other : {"--level", "--seed", "--cases", "--family"}) vectors->excludes(command.get_option(other));
  command
      .add_option("--most-points", options.most_points,
                  "Leave out the cases of more points, for programs that are slow on them")
      ->check(CLI::Range(std::size_t{0}, kMostPointsOfCase))
      ->type_name("N");
  command.parse_complete_callback([&command, &options] {
    options.asks_vectors = command.count("--vectors") > 0;
    options.is_given = options.asks_vectors;
    for (const char* other : {"--level", "--seed", "--cases", "--family", "--most-points"}) {
      options.is_given |= command.count(other) > 0;
    }
  });
}

std::unique_ptr<AskedCases> cases_of(const RunOptions& options) {
  if (options.asks_vectors) return vectors_to_ask(options.vectors, drawn_cases_of, options.most_points);
  fuzz::CaseRun run;
  run.level = options.level;
  run.seed = options.seed;
  run.cases = options.cases.value_or(fuzz::usual_cases(options.level));
  run.chosen = fuzz::chosen_families(options.families);
  run.most_points = options.most_points;
  return drawn_cases(run);
}

}  // namespace flowcert::commands
