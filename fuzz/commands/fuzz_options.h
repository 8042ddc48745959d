// The options of a fuzzing campaign. They give a campaign to begin or to go on with, and the properties that its
// cases are held to.
//
// Guarantees: what cannot be used is refused before anything is run or written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/counterexample.h"
#include "fuzz/commands/layer.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::commands {

struct FuzzOptions {
  std::string families;  // "list", or NAME[:WEIGHT],...
  std::string points;    // "4-8"
  std::vector<std::string> properties;
  std::string against;              // a command
  std::string through;              // one that is asked case after case
  std::string persistence_against;  // one that is asked for persistence pairs
  std::vector<std::string> ignored;
  std::vector<std::string> known;  // paths
  std::optional<double> time_limit;
  std::optional<std::size_t> memory_limit;
  std::uint64_t seed = 1;
  std::size_t searched_percent = 30;
  std::string corpus;  // a folder
  std::string shard;   // "2/5"
  bool shrinks_all = false;
  std::optional<std::size_t> count;
  std::optional<double> seconds;
  bool stops_at_first = false;
  unsigned jobs = 1;
  std::string out, resume;          // folders
  std::optional<std::size_t> only;  // one case
  double hang_seconds = 120;
  bool json = false;
};

// Adds all options but --jobs and --first, which only one of the programs has.
void add_fuzz_options(CLI::App& command, FuzzOptions& options);

// The plan of a new campaign. Throws InvalidInput for a corpus that cannot be read.
[[nodiscard]] fuzz::CampaignPlan plan_of(const FuzzOptions& options);
// A new or a resumed campaign. Throws InvalidInput, also if the command cannot be started, or fuzz::UnusableFolder.
[[nodiscard]] fuzz::Campaign campaign_of(const FuzzOptions& options);

// Throws InvalidInput if a new campaign cannot have this folder, and names one that is free.
void require_new_folder(const std::string& folder);

// The properties of the plan.
[[nodiscard]] std::vector<property::Property> properties_of(const fuzz::CampaignPlan& plan);
// The option that gives the plan's command.
[[nodiscard]] std::string against_option(const fuzz::CampaignPlan& plan);
// Runs the plan's command once, if it has one, and throws InvalidInput if it cannot be started.
void require_startable(const fuzz::CampaignPlan& plan);
// Seconds after which a property is taken to hang. A command that is late is a finding of another kind.
[[nodiscard]] double hang_seconds(const fuzz::CampaignPlan& plan, const FuzzOptions& options);

void print_families();

// The file of a counterexample, or any other XYZ file, as a case to be tried. Throws InvalidInput, "FILE:LINE: reason"
// or "FILE: reason".
[[nodiscard]] fuzz::Counterexample read_counterexample(const std::filesystem::path& path);

// ---- Values of options ----
// As those of cli/checked_words.h.

// A seed must be a number of 64 bits. CLI11 would turn a larger one into the largest one.
[[nodiscard]] std::string complaint_about_seed(const std::string& word);

}  // namespace flowcert::commands
