// CLI11 reads the options. This file checks what they mean together.
#include "fuzz/commands/fuzz_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "certify/programs/command_run.h"
#include "certify/programs/limited_program.h"
#include "cli/checked_words.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/point_set.h"
#include "fuzz/inputs/large_family.h"
#include "fuzz/judge/peer_property.h"
#include "io/diagnostic.h"
#include "io/foreign_text.h"
#include "io/number_text.h"

namespace flowcert::commands {

// ---- Files of counterexamples ----

fuzz::Counterexample read_counterexample(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code ignored;
  if (!file || !std::filesystem::is_regular_file(path, ignored)) {
    throw InvalidInput(path.string() + ": cannot be read");
  }
  std::ostringstream content;
  content << file.rdbuf();
  try {
    return fuzz::counterexample_of(content.str());
  } catch (const std::invalid_argument& error) {
    throw InvalidInput(path.string() + ":" + error.what());
  }
}

// ---- Checks of values ----

std::string complaint_about_seed(const std::string& word) {
  std::uint64_t seed = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), seed);
  const bool is_one = result.ec == std::errc() && result.ptr == word.data() + word.size();
  return is_one ? "" : in_quotes(word) + " is no number from 0 to 18446744073709551615";
}

namespace {

namespace fs = std::filesystem;

constexpr double kLongestSeconds = 366.0 * 86400;
constexpr std::size_t kMostMebibytes = std::size_t{1} << 24;
constexpr std::size_t kMostShards = 1'000'000;
// Each case of a command takes a process, so a batch of a thousand cases would take long. A large case takes longer.
constexpr std::size_t kCasesOfPeerBatch = 100;
constexpr std::size_t kCasesOfLargeBatch = 20;
// At most so many inputs of a corpus folder are used, the first ones by name.
constexpr std::size_t kMostOfCorpus = 2000;

// "4-8", "2/5": two numbers.
std::optional<std::pair<std::size_t, std::size_t>> two_numbers(const std::string& text, char separator) {
  std::pair<std::size_t, std::size_t> numbers;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, numbers.first);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != separator) return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, numbers.second);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return numbers;
}

// Validators return what is wrong.
std::string complaint_about_families(const std::string& list) {
  if (list == "list") return "";
  try {
    return fuzz::families_of(list).empty() ? "no family is named" : "";
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()) + "; --families list prints them";
  }
}
std::string complaint_about_row_range(const std::string& text) {
  const auto range = two_numbers(text, '-');
  const bool is_one = range && range->first <= range->second && range->second <= fuzz::kMostRowsOfTrial;
  return is_one ? "" : fmt::format("{} is no range like 4-8, of 0 to {}", in_quotes(text), fuzz::kMostRowsOfTrial);
}
std::string complaint_about_shard(const std::string& text) {
  const auto shard = two_numbers(text, '/');
  const bool is_one = shard && 1 <= shard->first && shard->first <= shard->second && shard->second <= kMostShards;
  return is_one ? "" : in_quotes(text) + " is no part i/n, i from 1 to n";
}
std::string complaint_about_property(const std::string& name) {
  if (property::property_named(name) != nullptr) return "";
  std::string names;
  for (const auto& one : property::properties()) names += (names.empty() ? "" : ", ") + one.name;
  return fmt::format("no property is called {}; there are: {}", in_quotes(name), names);
}
std::string no_command_for_self(std::string& command) {
  if (command != "self") return complaint_about_missing_in(command);
  command.clear();
  return "";
}
std::string complaint_about_reason(const std::string& name) {
  const std::vector<std::string> kinds = peer_kinds();
  if (std::ranges::find(kinds, name) != kinds.end()) return "";
  return fmt::format("no reason is called {}; there are: {}", in_quotes(name), fmt::join(kinds, ", "));
}
std::string complaint_about_time(const std::string& word) {
  return complaint_about_seconds(word, kLongestSeconds, "a year");
}

// ---- Corpus

// The point files of a folder, by name. Those with too many points for a case are left out.
std::vector<fuzz::Input> corpus_of(const std::string& folder) {
  std::set<fs::path> paths;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    if (entry.path().extension() == ".xyz") paths.insert(entry.path());
  }
  if (failure) throw InvalidInput(folder + ": " + failure.message());
  std::vector<fuzz::Input> corpus;
  for (const fs::path& path : paths) {
    fuzz::Input input = read_counterexample(path).trial.input;
    const std::size_t rows = input.rows.size();
    if (0 < rows && rows <= fuzz::kMostRowsOfTrial) corpus.push_back(std::move(input));
    if (corpus.size() == kMostOfCorpus) break;
  }
  return corpus;
}

// ---- Campaigns

// "campaign-2" for "campaign", and "campaign-3" for "campaign-2", unless there is one.
std::string next_free_name(const std::string& folder) {
  std::string name = fs::path(folder).lexically_normal().string();
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  std::size_t number = 2;
  const std::size_t dash = name.rfind('-');
  const char* const end = name.data() + name.size();
  if (dash != std::string::npos && dash + 1 < name.size()) {
    std::size_t last = 0;
    const auto result = std::from_chars(name.data() + dash + 1, end, last);
    if (result.ec == std::errc() && result.ptr == end && last < kMostShards) {
      number = last + 1;
      name.resize(dash);
    }
  }
  const auto numbered = [&] { return fmt::format("{}-{}", name, number); };
  while (fs::exists(numbered())) ++number;
  return numbered();
}

bool says_yes() {
  std::string answer;
  return std::getline(std::cin, answer) && (answer == "y" || answer == "yes");
}

// The command that is said by the option which the plan's command came by.
const std::string& said_command(const FuzzOptions& options, const fuzz::CampaignPlan& plan) {
  if (plan.is_dialogue) return options.through;
  return plan.judges_pairs ? options.persistence_against : options.against;
}

// A folder may be somebody else's, and its plan has a command. It runs if the user says it again, or says yes to it.
void require_consent(const FuzzOptions& options, const fuzz::CampaignPlan& plan) {
  const std::string option = against_option(plan);
  const std::string& said = said_command(options, plan);
  const bool is_other = !options.against.empty() || !options.through.empty() || !options.persistence_against.empty();
  if (plan.against == said && (!said.empty() || !is_other)) return;
  const std::string runs = plan.against.empty()
                               ? options.resume + ": its campaign runs no command"
                               : fmt::format("{}: its campaign runs the command {}", options.resume, plan.against);
  if (!said.empty() || (is_other && plan.against.empty())) {
    throw InvalidInput(fmt::format("{}, and {} says another one", runs, option));
  }
  if (is_other) throw InvalidInput(fmt::format("{}, not another one; it runs if {} says it again", runs, option));
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) {
    throw InvalidInput(fmt::format("{}; it runs if {} says it again", runs, option));
  }
  io::tell(fmt::format("{}\nShall it run? [y/N] ", io::on_one_line(runs)));
  if (!says_yes()) throw InvalidInput(options.resume + ": its command does not run");
}

fuzz::Campaign resumed_campaign(const FuzzOptions& options) {
  fuzz::Campaign campaign = fuzz::Campaign::resumed(options.resume, options.count);
  if (!campaign.total_cases() && !options.seconds && !options.stops_at_first && !options.only) {
    throw InvalidInput(options.resume + ": it has no number of cases: one of --count and --time is required");
  }
  require_consent(options, campaign.plan());
  require_startable(campaign.plan());
  return campaign;
}

bool draws_large(const fuzz::CampaignPlan& plan) {
  return std::ranges::any_of(plan.families, [](const auto& family) { return fuzz::is_large(family.name); });
}
void require_property_for_large(const fuzz::CampaignPlan& plan) {
  const auto takes = [](const auto& property) { return property.most_rows >= fuzz::kMostRowsOfLarge; };
  const bool is_taken = plan.against.empty() && std::ranges::any_of(fuzz::own_properties(plan), takes);
  if (draws_large(plan) && !is_taken) {
    throw InvalidInput("--families large: only the property certificate takes so many points");
  }
}

fuzz::Campaign new_campaign(const FuzzOptions& options) {
  if (!options.count && !options.seconds && !options.stops_at_first && !options.only) {
    throw InvalidInput("one of --count and --time is required: when is it enough?");
  }
  const fuzz::CampaignPlan plan = plan_of(options);
  const std::string complaint = plan.is_dialogue ? "" : complaint_about_relative_path(plan.against);
  if (!complaint.empty()) throw InvalidInput(against_option(plan) + ": " + complaint);
  if (plan.against.empty() && !plan.ignored.empty()) {
    throw InvalidInput("--ignore needs --against, --through or --persistence-against");
  }
  require_property_for_large(plan);
  const std::string findings = fmt::format("flowcert-fuzz-{}", options.seed);
  if (!options.out.empty()) {
    require_new_folder(options.out);
  } else if (fs::exists(findings) && !options.only) {
    throw InvalidInput(fmt::format("{}: there are findings of an earlier campaign; --out {} begins another", findings,
                                   shell_word(next_free_name(findings + "-1"))));
  }
  require_startable(plan);
  if (!options.out.empty()) return fuzz::Campaign::begun(plan, options.count, options.out);
  return {plan, options.count, findings};
}

PeerOptions peer_of(const fuzz::CampaignPlan& plan) {
  PeerOptions peer;
  peer.command = plan.against;
  peer.is_dialogue = plan.is_dialogue;
  peer.judges_pairs = plan.judges_pairs;
  peer.ignored = plan.ignored;
  peer.limits.seconds = plan.time_limit_seconds;
  peer.limits.memory_bytes = std::uint64_t{plan.memory_limit_mebibytes} << 20;
  return peer;
}

// ---- Options

void add_case_options(CLI::App& command, FuzzOptions& options) {
  command
      .add_option("--families", options.families,
                  "Draw from these, NAME or NAME:WEIGHT, with commas between; 'list' prints them")
      ->check(complaint_about_families);
  command.add_option("--points", options.points, "So many points, LEAST-MOST; mostly 4 to 8 of up to 12")
      ->check(complaint_about_row_range);
  command
      .add_option("--mutants", options.searched_percent,
                  "Percentage of the cases that are mutants of inputs which showed something new")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  command
      .add_option("--corpus", options.corpus,
                  "Also begin with the point files of this folder, NAME.xyz, as inputs to mutate")
      ->type_name("DIR");
  command.add_option("--seed", options.seed, "Another seed, other cases")
      ->check(complaint_about_seed)
      ->capture_default_str();
}

void add_property_options(CLI::App& command, FuzzOptions& options) {
  auto* property = command
                       .add_option("--property", options.properties,
                                   "Hold every case to this; may be given again. Without it: to all, each on its share")
                       ->check(complaint_about_property)
                       ->allow_extra_args(false);
  command
      .add_option("--against", options.against,
                  "Another implementation's command instead: {in} stands for a file of points, {out} for the "
                  "file to write its claim to; without {out}, standard output is the claim; 'self': Flowcert, as "
                  "without this")
      ->transform(CLI::Validator(no_command_for_self, ""))
      ->excludes(property);
  command
      .add_option("--through", options.through,
                  "The same for a program that is started once: it reads case after case from standard input, as "
                  "generate writes them, and answers each as verify reads it. It has to flush each answer (in Python "
                  "by print(..., flush=True)). It is started again if it dies or hangs")
      ->type_name("COMMAND")
      ->excludes(property)
      ->excludes(command.get_option("--against"));
  command
      .add_option("--persistence-against", options.persistence_against,
                  "The same for a command whose answer is persistence pairs, as persistence --json or GUDHI's tools "
                  "write them")
      ->check(complaint_about_missing_in)
      ->excludes(property)
      ->excludes(command.get_option("--against"))
      ->excludes(command.get_option("--through"));
  command
      .add_option("--ignore", options.ignored,
                  "Of --against and --through: what is wrong for this reason (missed-by-cluster, refusal, ...) does "
                  "not count; may be given again")
      ->check(complaint_about_reason)
      ->type_name("REASON")
      ->allow_extra_args(false);
  command
      .add_option("--known", options.known,
                  "Findings that are known: files of findings, or folders of them. What they explain, being of the "
                  "same kind on points that are degenerate in the same way, is listed last and is no failure")
      ->type_name("FINDINGS");
  command
      .add_option("--time-limit", options.time_limit,
                  "Seconds that it may take for a case, after which it is killed; without this 10")
      ->check(complaint_about_time);
  command
      .add_option("--memory-limit", options.memory_limit,
                  "MiB of address space that it may have, 0: no limit; without this 4096")
      ->check(CLI::Range(std::size_t{0}, kMostMebibytes));
}

void add_run_options(CLI::App& command, FuzzOptions& options) {
  command.add_option("--count", options.count, "So many cases in all")
      ->check(CLI::Range(std::size_t{1}, fuzz::kMostCasesOfCampaign));
  command.add_option("--time", options.seconds, "Stop after so many seconds")->check(complaint_about_time);
  command
      .add_option("--shard", options.shard,
                  "Only this part of the campaign, i/n: all n parts together are the campaign")
      ->check(complaint_about_shard);
  auto* out = command.add_option("--out", options.out,
                                 "Keep the campaign in this new folder: findings, signatures, and what to go on with");
  auto* resume =
      command
          .add_option(
              "--resume", options.resume,
              "Go on with the campaign in this folder; a command of its plan runs if --against, or what it came by, "
              "says it again")
          ->excludes(out);
  // The campaign's folder says all of this.
  for (const char* name : {"--families", "--points", "--mutants", "--corpus", "--seed", "--property", "--ignore",
                           "--shard", "--time-limit", "--memory-limit"}) {
    resume->excludes(command.get_option(name));
  }
  command.add_flag("--shrink-all", options.shrinks_all,
                   "Make every failing case small; without it, the first of its kind in each batch");
  resume->excludes("--shrink-all");
  command.add_option("--hang", options.hang_seconds, "Seconds after which a property is taken to hang")
      ->check(complaint_about_time)
      ->capture_default_str();
  command.add_flag("--json", options.json, "Print one JSON object");
}

}  // namespace

void add_fuzz_options(CLI::App& command, FuzzOptions& options) {
  add_case_options(command, options);
  add_property_options(command, options);
  add_run_options(command, options);
}

fuzz::CampaignPlan plan_of(const FuzzOptions& options) {
  fuzz::CampaignPlan plan;
  plan.seed = options.seed;
  plan.families = fuzz::families_of(options.families);
  plan.searched_percent = options.searched_percent;
  for (const std::string& name : options.properties) {
    const bool is_new = std::ranges::find(plan.properties, name) == plan.properties.end();
    if (is_new) plan.properties.push_back(name);
  }
  plan.judges_pairs = !options.persistence_against.empty();
  plan.is_dialogue = !options.through.empty();
  plan.against = said_command(options, plan);
  plan.ignored = options.ignored;
  plan.shrinks_all = options.shrinks_all;
  plan.time_limit_seconds = options.time_limit.value_or(plan.time_limit_seconds);
  plan.memory_limit_mebibytes = options.memory_limit.value_or(plan.memory_limit_mebibytes);
  if (!plan.against.empty()) {
    plan.batch_cases = kCasesOfPeerBatch;
    plan.fewest_rows = 1;
  }
  if (draws_large(plan)) plan.batch_cases = kCasesOfLargeBatch;
  if (const auto range = two_numbers(options.points, '-')) {
    plan.fewest_rows = range->first;
    plan.most_rows = range->second;
  }
  if (const auto shard = two_numbers(options.shard, '/')) plan.shard = {shard->first - 1, shard->second};
  if (!options.corpus.empty()) plan.corpus = corpus_of(options.corpus);
  return plan;
}

void require_new_folder(const std::string& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return;
  const std::string again = shell_word(folder), other = shell_word(next_free_name(folder));
  if (fs::exists(fs::path(folder) / fuzz::kPlanName, ignored)) {
    throw InvalidInput(fmt::format(
        "{}: there is a campaign already; --resume {} goes on with it, --out {} begins another", folder, again, other));
  }
  if (fs::is_directory(folder, ignored) && fs::is_empty(folder, ignored)) return;
  throw InvalidInput(fmt::format("{}: it is no empty folder; --out {} begins a campaign", folder, other));
}

fuzz::Campaign campaign_of(const FuzzOptions& options) {
  return options.resume.empty() ? new_campaign(options) : resumed_campaign(options);
}

std::vector<property::Property> properties_of(const fuzz::CampaignPlan& plan) {
  if (plan.against.empty()) return fuzz::own_properties(plan);
  return {peer_property(peer_of(plan))};
}

std::string against_option(const fuzz::CampaignPlan& plan) {
  if (plan.is_dialogue) return "--through";
  return plan.judges_pairs ? "--persistence-against" : "--against";
}

void require_startable(const fuzz::CampaignPlan& plan) {
  if (plan.against.empty()) return;
  const ProgressLine progress("trying the command");
  PeerOptions peer = peer_of(plan);
  peer.ignored.clear();
  peer.is_cancelled = [] { return Interruption::signal() != 0; };
  const auto found = peer_property(peer).check({{{{0, 0, 0}, {2, 0, 0}}}, property::StartChoice{}});
  if (found && found->kind == "not-started") {
    throw InvalidInput(against_option(plan) + ": the command was not started: " + found->complaint);
  }
}

double hang_seconds(const fuzz::CampaignPlan& plan, const FuzzOptions& options) {
  // One that is asked case after case may be asked one case three times.
  const double limits = plan.is_dialogue ? 4 : 2;
  return plan.against.empty() ? options.hang_seconds : std::max(options.hang_seconds, limits * plan.time_limit_seconds);
}

void print_families() {
  std::vector<std::vector<std::string>> rows;
  for (const fuzz::Family& family : fuzz::named_families()) {
    rows.push_back({family.name, family.description});
  }
  print_columns(rows, "ll");
}

}  // namespace flowcert::commands
