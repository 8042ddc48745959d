// `flowcert fuzz`: campaigns of degenerate inputs. Our two implementations are compared, or another one with ours.
// Exit status 0 if no case failed, 1 if one did.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>

#include "certify/programs/limited_program.h"
#include "cli/progress.h"
#include "fuzz/campaign/worker_processes.h"
#include "fuzz/commands/commands.h"
#include "fuzz/commands/finding_pages.h"
#include "fuzz/commands/finding_printer.h"
#include "fuzz/commands/fuzz_options.h"
#include "fuzz/commands/fuzz_progress.h"
#include "fuzz/commands/fuzz_report.h"
#include "fuzz/commands/known_findings.h"

namespace flowcert::commands {

namespace {

constexpr std::size_t kNoBudget = std::numeric_limits<std::size_t>::max();

struct FuzzCommandOptions : FuzzOptions {
  std::vector<std::string> replay;
  std::vector<std::string> merged;
};

bool is_time_up(const FuzzOptions& options, const FuzzProgress& progress) {
  return options.seconds && progress.seconds_so_far() >= *options.seconds;
}

// `source` is the campaign, or a part of it.
void work_on(fuzz::BatchSource& source, const fuzz::Campaign& campaign, const FuzzOptions& options,
             FuzzProgress& progress, const std::function<bool()>& is_over) {
  auto properties = properties_of(campaign.plan());
  for (property::Property& property : properties) {
    if (options.stops_at_first) property.shrinking_budget = property.slow_shrinking_budget = kNoBudget;
  }
  fuzz::WorkOptions work;
  work.jobs = options.jobs;
  work.hang_seconds = hang_seconds(campaign.plan(), options);
  work.is_stopped = [&] { return Interruption::signal() != 0 || is_over(); };
  work.progress = [&](std::size_t under_way) { progress(under_way); };
  fuzz::work_on(source, properties, work);
  progress.hide();
}

int run_case(fuzz::Campaign& campaign, const FuzzOptions& options) {
  fuzz::OneCase one(campaign, *options.only);
  FuzzProgress progress(campaign, options.seconds);
  work_on(one, campaign, options, progress, [&] { return is_time_up(options, progress); });
  if (!one.is_done()) throw InvalidInput(fmt::format("case {} was stopped before it was done", *options.only));
  write_finding_pages(campaign);
  return print_case(campaign, one, options.json);
}

KnownFindings known_of(const FuzzOptions& options) {
  const ProgressLine progress("reading findings");
  return KnownFindings(options.known);
}

fuzz::Campaign campaign_begun(const FuzzOptions& options) {
  const ProgressLine progress("reading the campaign");
  return campaign_of(options);
}

int run_campaign(const FuzzOptions& options) {
  const Interruption interruption;
  const KnownFindings known = known_of(options);
  fuzz::Campaign campaign = campaign_begun(options);
  if (options.only) return run_case(campaign, options);
  const std::size_t before = campaign.tally().cases;
  FuzzProgress progress(campaign, options.seconds);
  FindingPrinter printer(campaign, known, progress,
                         {.prints = !options.json, .stops_at_first = options.stops_at_first});
  work_on(printer, campaign, options, progress,
          [&] { return printer.has_first() || (is_time_up(options, progress) && !printer.makes_first_small()); });
  // A case that was under way when the time ended may have become the first finding. It is tried again.
  const auto lacks_first = [&] { return printer.makes_first_small() && !printer.has_first(); };
  if (lacks_first() && Interruption::signal() == 0) {
    work_on(printer, campaign, options, progress, [&] { return !lacks_first(); });
  }
  printer.end();
  FuzzRun run{campaign, known, progress.seconds_so_far(), campaign.tally().cases - before, options.jobs};
  run.is_interrupted = Interruption::signal() != 0;
  run.is_time_up = is_time_up(options, progress);
  run.printed = &printer.printed();
  write_finding_pages(campaign);
  print_fuzz(run, options.json);
  return verdict_of(run);
}

// ---- Again

auto disagreement_of(const property::Property& property, const property::Trial& trial) {
  const ProgressLine progress(property.name);
  return property::disagreement(property, trial);
}

// If the file names no property, all are tried.
bool is_right_on(const fuzz::Counterexample& counterexample, const std::vector<property::Property>& properties,
                 bool is_for_peer, const std::string& path) {
  bool is_right = true;
  for (const property::Property& property : properties) {
    const bool is_asked = is_for_peer || counterexample.property.empty() || counterexample.property == property.name;
    if (!is_asked) continue;
    const auto found = disagreement_of(property, counterexample.trial);
    is_right = is_right && !found;
    fmt::print("{}: {}: {}\n", path, property.name,
               found ? fmt::format("{} [{}]: {}", found->kind, found->clause, found->complaint) : "holds");
    if (!found) continue;
    for (const auto& [name, text] :
         {std::pair(found->first_name, found->first), std::pair(found->second_name, found->second)}) {
      if (!name.empty()) fmt::print("{}:\n{}\n", name, text);
    }
  }
  return is_right;
}

int replay(const FuzzCommandOptions& options) {
  const fuzz::CampaignPlan plan = plan_of(options);
  require_startable(plan);
  const auto properties = properties_of(plan);
  int status = kRight;
  for (const std::string& path : options.replay) {
    const fuzz::Counterexample counterexample = read_counterexample(path);
    const bool is_chosen = !plan.against.empty() || !plan.properties.empty();
    if (!is_right_on(counterexample, properties, is_chosen, path)) status = kNegativeVerdict;
  }
  return status;
}

// ---- Parts

fuzz::Campaign whole_of(const FuzzCommandOptions& options) {
  ProgressLine progress("merging");
  std::vector<fuzz::Campaign> parts;
  for (const std::string& folder : options.merged) {
    parts.push_back(fuzz::Campaign::read(folder));
    progress(parts.size(), 2 * options.merged.size());
  }
  fuzz::CampaignPlan plan = parts.front().plan();
  plan.shard = {};
  const auto total = parts.front().total_cases();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].total_cases() != total) {
      throw InvalidInput(options.merged[k] + ": another number of cases than " + options.merged.front());
    }
  }
  if (!options.out.empty()) require_new_folder(options.out);
  fuzz::Campaign whole = options.out.empty() ? fuzz::Campaign(plan, total, std::filesystem::path())
                                             : fuzz::Campaign::begun(plan, total, options.out);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    try {
      whole.absorb(parts[k]);
    } catch (const std::invalid_argument& error) {
      throw InvalidInput(fmt::format("{}: {} than {}", options.merged[k], error.what(), options.merged.front()));
    }
    progress(parts.size() + k + 1, 2 * parts.size());
  }
  return whole;
}

int merge(const FuzzCommandOptions& options) {
  const KnownFindings known = known_of(options);
  fuzz::Campaign whole = whole_of(options);
  write_finding_pages(whole);
  const FuzzRun run{whole, known, std::nullopt};
  print_fuzz(run, options.json);
  return verdict_of(run);
}

int fuzz_or_list(const FuzzCommandOptions& options) {
  if (options.families == "list") {
    print_families();
    return kRight;
  }
  return options.replay.empty() ? run_campaign(options) : replay(options);
}

// It has --out and --json of its own, because CLI11 looks for the options of a subcommand only there.
void add_merge_command(CLI::App& command, const std::shared_ptr<FuzzCommandOptions>& options, int& status) {
  CLI::App* merge_command = command.add_subcommand("merge", "Put the parts of a campaign together");
  merge_command->group("Subcommands");  // as CLI11 calls it by itself, but not in every version
  merge_command->add_option("DIR", options->merged, "Folders of campaigns that differ in --shard alone")->required();
  merge_command->add_option("--out", options->out, "A new folder for the whole, to go on with or to look at");
  merge_command->add_option("--known", options->known, "Findings that are known, as for fuzz itself")
      ->type_name("FINDINGS");
  merge_command->add_flag("--json", options->json, "Print one JSON object");
  merge_command->footer(
      "Examples:\n  flowcert fuzz merge part-1 part-2\n  flowcert fuzz merge part-1 part-2 --out whole");
  merge_command->callback([options, &status] { status = merge(*options); });
}

}  // namespace

void add_fuzz_command(CLI::App& app, int& status) {
  auto options = std::make_shared<FuzzCommandOptions>();
  CLI::App* command = app.add_subcommand("fuzz", cli::kFuzzPurpose);
  add_fuzz_options(*command, *options);
  command->add_option("--jobs", options->jobs, "Processes that work at a time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag("--first", options->stops_at_first,
                    "Stop at the first finding that is not known, and make it as small as it gets, whatever time that "
                    "takes; Ctrl-C ends it");
  auto* replay_option =
      command->add_option("--replay", options->replay, "Try the case of a finding's file, or of any point file, again")
          ->type_name("FILE");
  for (const char* name :
       {"--count", "--time", "--out", "--resume", "--shard", "--corpus", "--json", "--known", "--first"}) {
    replay_option->excludes(command->get_option(name));
  }
  auto* only = command->add_option(
      "--case", options->only,
      "Only this case of the campaign, once more: what fails is made small. After a crash or a hang in "
      "its batch, with --resume alone it is the same case");
  for (const char* name : {"--count", "--time", "--out", "--shard", "--jobs", "--replay", "--known", "--first"}) {
    only->excludes(command->get_option(name));
  }
  add_merge_command(*command, options, status);
  command->footer(
      "The same seed has the same cases and findings on any machine, however many jobs and interruptions "
      "there are. Ctrl-C stops after the cases under way, or after two seconds; --resume goes on, after a "
      "kill as well. Each finding is printed when it is small. Where time is up before, the report says that it "
      "is not fully shrunk.\n\n"
      "Examples:\n  flowcert fuzz --time 60 --jobs 2\n"
      "  flowcert fuzz --count 1000000 --property critical-points --property orbit \\\n"
      "    --out campaign\n"
      "  flowcert fuzz --resume campaign --jobs 2\n"
      "  flowcert fuzz --resume campaign --case 4711\n"
      "  flowcert fuzz --time 60 --against \"$PWD/my-flow {in} {out}\" \\\n"
      "    --families box-corners:3,integer-sphere\n"
      "  flowcert fuzz --time 60 --against \"$PWD/my-flow {in} {out}\" \\\n"
      "    --known findings --ignore refusal\n"
      "  flowcert fuzz --time 60 --first --through ./your-program\n"
      "  flowcert fuzz --count 100000 --shard 1/4 --out part-1");
  command->callback([options, command, &status] {
    if (command->get_subcommands().empty()) status = fuzz_or_list(*options);
  });
}

}  // namespace flowcert::commands
