// `flowcert conformance`: what any program's answers to the conformance vectors are worth. Exit status 0 if
// all is right or perturbed, 1 if something is not; with --strict, 1 if something is perturbed, too.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "certify/programs/command_run.h"
#include "certify/programs/limited_program.h"
#include "cli/check_command.h"
#include "cli/check_report.h"
#include "cli/checked_words.h"
#include "cli/command_line.h"
#include "cli/conformance_page.h"
#include "cli/conformance_report.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "io/diagnostic.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMebibytesOfRun = std::size_t{1} << 24;
constexpr double kLongestRunSeconds = 86400;
// A shell exits with this plus n if signal n has ended its program.
constexpr int kShellSignal = 128;

using Names = std::vector<std::string>;

struct ConformanceCommandOptions {
  ConformanceOptions run;
  std::string folder;  // of the vectors
  Names groups, flags, cases;
  std::string in_format = "xyz";
  std::size_t memory_mebibytes = 4096;
  std::string junit;
  std::string report;
  std::size_t most = 10;
  bool json = false;
  bool list = false;
  bool is_strict = false;
};

// ---- Which vectors

bool has(const Names& names, const std::string& name) { return std::ranges::find(names, name) != names.end(); }

// Every name that is asked for has to be one of the known ones. Otherwise these are listed, the nearest first.
void require_known(const char* what, const Names& asked, Names known) {
  constexpr std::size_t kMostNames = 30;
  for (const std::string& name : asked) {
    if (has(known, name)) continue;
    std::ranges::stable_sort(known, {}, [&](const std::string& one) { return edits_between(name, one); });
    const bool are_all = known.size() <= kMostNames;
    known.resize(std::min(known.size(), kMostNames));
    throw InvalidInput(fmt::format("there is no {} {}; there are: {}{}", what, in_quotes(name), fmt::join(known, ", "),
                                   are_all ? "" : ", and others, which --list shows"));
  }
}

// If no name is asked for, all cases are chosen.
bool is_chosen(const VectorCase& one, const ConformanceCommandOptions& options) {
  const auto has_asked_flag = [&](const std::string& flag) { return has(options.flags, flag); };
  return (options.groups.empty() || has(options.groups, one.group)) &&
         (options.cases.empty() || has(options.cases, one.id)) &&
         (options.flags.empty() || std::ranges::any_of(one.flags, has_asked_flag));
}

std::vector<const VectorCase*> chosen_cases(const Vectors& vectors, const ConformanceCommandOptions& options) {
  Names flags, ids;
  for (const VectorFlag& flag : vectors.flags) flags.push_back(flag.name);
  for (const VectorCase& one : vectors.cases) ids.push_back(one.id);
  require_known("group", options.groups, vectors.groups);
  require_known("flag", options.flags, flags);
  require_known("case", options.cases, ids);
  std::vector<const VectorCase*> chosen;
  for (const VectorCase& one : vectors.cases) {
    if (is_chosen(one, options)) chosen.push_back(&one);
  }
  if (chosen.empty()) throw InvalidInput("no case is in all of --group, --flag and --case");
  return chosen;
}

// A case begins two blanks from the left. What goes on is indented more.
void print_list(const std::vector<const VectorCase*>& cases) {
  constexpr std::size_t kIndent = 6;
  for (const VectorCase* one : cases) {
    print_wrapped(fmt::format("  {}  {}", one->id, one->comment), kIndent);
    std::string flags;
    for (const std::string& flag : one->flags) flags += ' ' + flag;
    if (!flags.empty()) print_wrapped(fmt::format("     {}", flags), kIndent);
  }
}

// ---- Running

// Runs a command once, on two points. A command that does not exist is better refused now than for every case.
void require_runnable(const char* option, const std::string& command, const ConformanceOptions& options) {
  if (command.empty()) return;
  const std::string complaint = complaint_about_relative_path(command);
  if (!complaint.empty()) throw InvalidInput(fmt::format("{}: {}", option, complaint));
  const ProgressLine progress("trying the command");
  const ScratchFolder scratch;
  const std::string points = options.points.format == PointFileFormat::kOff ? "OFF\n2 0 0\n" : "";
  const CommandOrder order = {
      command, point_file_name(options.points), points + "0 0 0\n2 0 0\n", options.out_name, {{"{start}", "1,0,0"}}};
  const auto is_cancelled = [] { return Interruption::signal() != 0; };
  const CommandRun run = run_command(order, scratch.path() / "once", options.limits, is_cancelled);
  if (was_not_started(run.end)) {
    throw InvalidInput(fmt::format("{}: the command was not started: {}", option, status_text(run)));
  }
}

void require_answerable(const std::vector<CaseOutcome>& outcomes) {
  const bool is_any_run =
      std::ranges::any_of(outcomes, [](const CaseOutcome& outcome) { return outcome.outcome != RunOutcome::kSkipped; });
  if (is_any_run) return;
  const CaseOutcome& first = outcomes.front();
  throw InvalidInput(fmt::format("there is nothing to run: {} {}", first.of->id, first.message));
}

// Links in the page are relative to its folder, so that both folders can be moved together.
ConformancePageContext page_context(const ConformanceCommandOptions& options) {
  if (options.run.keep.empty()) return {};
  const fs::path folder = fs::absolute(options.report).lexically_normal().parent_path();
  const fs::path keep = fs::path(options.run.keep).lexically_normal();
  return {.kept_folder = keep.lexically_relative(folder).generic_string(),
          .is_kept = [keep](const std::string& name) { return fs::exists(keep / name); }};
}

int run_cases(const ConformanceCommandOptions& options, const Vectors& vectors,
              const std::vector<const VectorCase*>& cases) {
  require_runnable("--against", options.run.command, options.run);
  require_runnable("--orbits-against", options.run.orbit_command, options.run);
  require_runnable("--persistence-against", options.run.persistence_command, options.run);
  // A file that cannot be written is better reported before the run.
  std::optional<OutputFile> junit;
  if (!options.junit.empty()) junit.emplace(options.junit);
  std::optional<OutputFile> page;
  if (!options.report.empty()) page.emplace(options.report);
  if (!options.run.keep.empty()) fs::create_directories(options.run.keep);
  const auto since = std::chrono::steady_clock::now();
  std::vector<CaseOutcome> outcomes;
  {
    ProgressLine progress("cases");
    outcomes = run_conformance(cases, options.run, std::ref(progress));
  }
  require_answerable(outcomes);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  const ConformanceReport report{vectors, options.run, outcomes, seconds};
  if (junit) {
    write_conformance_junit(junit->stream(), report);
    junit->commit();
  }
  if (page) {
    write_conformance_page(page->stream(), conformance_json(report), page_context(options));
    page->commit();
  }
  if (options.json) {
    print_conformance_json(report);
  } else {
    print_conformance_text(report, options.most);
  }
  return status_of(report.verdict(), options.is_strict);
}

int conformance(ConformanceCommandOptions& options) {
  const Interruption interruption;
  options.run.limits.memory_bytes = std::uint64_t{options.memory_mebibytes} << 20;
  options.run.points.format = options.in_format == "off" ? PointFileFormat::kOff : PointFileFormat::kXyz;
  if (!options.run.keep.empty()) options.run.keep = fs::absolute(options.run.keep).string();
  const Vectors vectors = with_progress("reading the vectors", [&] {
    return read_vectors(options.folder.empty() ? usual_vectors_folder() : options.folder);
  });
  const std::vector<const VectorCase*> cases = chosen_cases(vectors, options);
  if (options.list) {
    print_list(cases);
    return kRight;
  }
  if (options.run.command.empty()) throw InvalidInput("--against is required");
  try {
    return run_cases(options, vectors, cases);
  } catch (const Interrupted& interrupted) {
    io::tell("flowcert: interrupted\n");
    return kShellSignal + interrupted.signal;
  }
}

// ---- Options

// Validators return what is wrong.
std::string complaint_about_missing_places(const std::string& command) {
  return has_place(command, "{start}") ? complaint_about_missing_in(command) : "there is no {start} in the command";
}
std::string complaint_about_file_name(const std::string& name) {
  constexpr std::string_view kTaken[] = {"",       ".",      "..",        "points.xyz", "points.off",
                                         "stdout", "stderr", "case.json", kPageName};
  const bool is_free = name.find('/') == std::string::npos && std::ranges::count(kTaken, name) == 0;
  return is_free ? "" : in_quotes(name) + " is no file name that is free";
}
std::string complaint_about_run_time(const std::string& word) {
  return complaint_about_seconds(word, kLongestRunSeconds, "a day");
}

void add_choice_options(CLI::App& command, ConformanceCommandOptions& options) {
  command.add_option("--vectors", options.folder,
                     "Folder of the vectors; without this, those that came with the program");
  command
      .add_option("--group", options.groups,
                  "Only the cases of this group; may be given several times. An unknown one lists them")
      ->allow_extra_args(false);
  command.add_option("--flag", options.flags, "Only the cases with this flag; may be given several times")
      ->allow_extra_args(false);
  command.add_option("--case", options.cases, "Only this case; may be given several times")->allow_extra_args(false);
  command.add_flag("--list", options.list, "Run nothing; print id, comment and flags of the cases");
}

void add_command_options(CLI::App& command, ConformanceCommandOptions& options) {
  ConformanceOptions& run = options.run;
  command
      .add_option("--against", run.command,
                  "The command: {in} stands for a file of points, {out} for the file to write the claim to; "
                  "without {out}, standard output is the claim")
      ->check(complaint_about_missing_in);
  command
      .add_option("--orbits-against", run.orbit_command,
                  "A command for orbits: {start} stands for where to start, X,Y,Z; its answer is JSON as of "
                  "orbit --json")
      ->check(complaint_about_missing_places);
  command
      .add_option("--persistence-against", run.persistence_command,
                  "A command for persistence pairs; its answer is JSON as of persistence --json, or a .pers file")
      ->check(complaint_about_missing_in);
  command.add_option("--in-format", options.in_format, "Format of the points: xyz or off")
      ->check(CLI::IsMember({"xyz", "off"}))
      ->capture_default_str();
  command.add_flag("--hex", run.points.hexadecimal,
                   "Points as hexadecimal floats, not as the shortest decimals that read back to them");
  command.add_option("--out-name", run.out_name, "Name of the file {out}")
      ->check(complaint_about_file_name)
      ->capture_default_str();
  command
      .add_option("--time-limit", run.limits.seconds, "Seconds after which a run is killed, with all that it started")
      ->check(complaint_about_run_time)
      ->capture_default_str();
  command
      .add_option("--memory-limit", options.memory_mebibytes,
                  "MiB of address space that each process may have; 0: no limit")
      ->check(CLI::Range(std::size_t{0}, kMostMebibytesOfRun))
      ->capture_default_str();
  command.add_option("--jobs", run.jobs, "Cases that run at a time")->check(CLI::Range(1, 256))->capture_default_str();
  add_judging_options(command, run.check, options.is_strict);
}

void add_report_options(CLI::App& command, ConformanceCommandOptions& options) {
  command.add_option("--keep", options.run.keep,
                     "For each negative case, leave points, claim, what the command said, the case, and a page "
                     "that shows it, in a folder of its name here");
  command.add_option("--report", options.report, "Write a page with tables, flags and findings to this file, .html")
      ->check(complaint_about_path);
  command.add_option("--most", options.most, "Show so many negative cases")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_flag("--json", options.json, "Print one JSON object");
  command.add_option("--junit", options.junit,
                     "Write a JUnit report to this file, a test suite a group, a test case a case");
}

}  // namespace

void add_conformance_command(CLI::App& app, int& status, const OtherTruth& oracle) {
  auto options = std::make_shared<ConformanceCommandOptions>();
  options->run.truth = oracle;
  CLI::App* command = app.add_subcommand("conformance", kConformancePurpose);
  add_command_options(*command, *options);
  add_choice_options(*command, *options);
  add_report_options(*command, *options);
  command->footer(
      "The command runs by /bin/sh in a folder of its own for each case, and is killed with all that it started "
      "when it is done, or late. It has to exit with 0 and leave a right claim (formats: see flowcert "
      "check); "
      "of an invalid case, with another status.\n\n"
      "Examples:\n  flowcert conformance --against \"$PWD/my-flow {in} {out}\"\n"
      "  flowcert conformance --jobs 2 \\\n"
      "    --against 'flowcert compute {in} -o {out} --manifolds u2' \\\n"
      "    --orbits-against 'flowcert orbit {in} --from {start} --json'\n"
      "  flowcert conformance --against 'flowcert compute {in} -o {out}' \\\n"
      "    --persistence-against 'flowcert persistence {in} -o {out}' \\\n"
      "    --group persistence\n"
      "  flowcert conformance --list --flag kind-1-3");
  command->callback([options, &status] { status = conformance(*options); });
}

}  // namespace flowcert::cli
