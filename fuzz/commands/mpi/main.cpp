// The program `flowcert-fuzz-mpi`: a campaign of `flowcert fuzz`, shared out over the ranks of an MPI job.
//
// Rank 0 turns every failure into one line on standard error, and has the exit status of `flowcert fuzz`; the
// other ranks end with 0.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "certify/programs/command_run.h"
#include "certify/programs/limited_program.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "fuzz/commands/fuzz_report.h"
#include "fuzz/commands/known_findings.h"
#include "fuzz/commands/mpi/ranks.h"
#include "io/diagnostic.h"
#include "io/out_of_memory.h"

namespace {

using namespace flowcert;
using namespace flowcert::commands;

// A rank that has not ended by then has been killed since it was last heard of.
constexpr double kSecondsToEnd = 5;
constexpr std::chrono::milliseconds kBeforeLeaving{700};

constexpr const char* kFooter =
    "Rank 0 hands out batches and gathers findings; the others work. The account is that of flowcert fuzz "
    "with the same options, whatever the number of ranks.\n\n"
    "A rank that is killed: mpirun ends the others as well, and --resume goes on with the folder --out, here "
    "or in flowcert fuzz. With mpirun --enable-recovery the campaign goes on without the rank; mpirun's own "
    "exit status is 0 then, whatever was found, and flowcert fuzz --resume DIR tells the campaign's.\n\n"
    "Examples:\n  mpirun -n 5 --oversubscribe flowcert-fuzz-mpi --count 1000000 --out campaign\n"
    "  mpirun --hostfile hosts --enable-recovery flowcert-fuzz-mpi --time 36000 --out campaign\n"
    "  mpirun -n 5 --oversubscribe flowcert-fuzz-mpi --resume campaign";

// What the command line has: options, or something to say and the status to say it with.
struct CommandLine {
  FuzzMpiOptions options;
  std::string text;
  std::optional<int> status;
};

void parse(int argc, char** argv, CommandLine& line) {
  CLI::App app{"A fuzzing campaign, shared out over the ranks of an MPI job."};
  app.name("flowcert-fuzz-mpi");
  app.formatter(help_formatter());
  add_fuzz_options(app, line.options);
  app.add_option("--silence", line.options.silence_seconds,
                 "Seconds after which a rank that is not heard of is given up; all say every second that "
                 "they are there")
      ->check(CLI::Range(0.5, 1e6))
      ->capture_default_str();
  app.footer(kFooter);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    const bool is_help = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (is_help) app.exit(error, out, out);
    const std::vector<std::string> words(argv + 1, argv + std::max(argc, 1));
    line.text = is_help ? out.str() : complaint_about(app, error, words);
    line.status = is_help ? kRight : kUnusable;
  }
}

int complain(const std::string& what) {
  io::tell(fmt::format("flowcert-fuzz-mpi: {}\n", one_line(what)));
  return kUnusable;
}

// ---- Rank 0

int report(const FuzzRun& run, const LedCampaign& led, bool json) {
  print_fuzz(run, json);
  const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!is_written) return complain("standard output cannot be written");
  if (led.is_deserted) return complain("no rank is left; what was kept by --out goes on by --resume");
  return verdict_of(run);
}

// Returns the exit status. `ranks` counts the other ranks that can be expected to end.
int lead_campaign(RankLines& lines, const FuzzMpiOptions& options, int& ranks) {
  if (options.families == "list") {
    print_families();
    return kRight;
  }
  const KnownFindings known(options.known);
  fuzz::Campaign campaign = campaign_of(options);
  const std::size_t before = campaign.tally().cases;
  const Interruption interruption;
  LedCampaign led;
  double seconds = 0;
  {
    FuzzProgress progress(campaign, options.seconds);
    led = lead(campaign, lines, options, progress);
    seconds = progress.seconds_so_far();
  }
  ranks -= led.silent_ranks;
  const auto workers = static_cast<unsigned>(lines.size() - 1);
  return report({campaign, known, seconds, campaign.tally().cases - before, workers, Interruption::signal() != 0}, led,
                options.json);
}

int be_rank_0(RankLines& lines, const CommandLine& line) {
  int ranks = lines.size() - 1;
  int status = kRight;
  if (line.status) {
    if (*line.status == kRight) fmt::print("{}", line.text);
    status = *line.status == kRight ? kRight : complain(line.text);
  } else if (lines.size() < 2) {
    status = complain("needs at least 2 ranks: the first one hands out what the others do (mpirun -n 3 ...)");
  } else {
    try {
      status = lead_campaign(lines, line.options, ranks);
    } catch (const std::exception& error) {
      status = complain(error.what());
    }
  }
  std::fflush(stdout);
  for (int rank = 1; !line.status && rank < lines.size(); ++rank) lines.send(rank, "end");
  const bool are_all_there = lines.have_said("ended", ranks, kSecondsToEnd) && ranks == lines.size() - 1;
  // MPI_Finalize would wait for ranks that are dead.
  for (int rank = 1; rank < lines.size(); ++rank) lines.send(rank, are_all_there ? "finalize" : "leave");
  if (!are_all_there) MPI_Abort(MPI_COMM_WORLD, status);
  return status;
}

// ---- The others

void be_another_rank(RankLines& lines, std::unique_ptr<BatchProcess> process, const CommandLine& line) {
  if (process) work_for_rank_0(lines, *process, line.options);
  process.reset();
  lines.send(0, "ended");
  if (lines.have_said("finalize", 1, 2 * kSecondsToEnd, "leave")) return;
  // Rank 0 aborts with its status, and must be first. With --enable-recovery its abort ends no other rank.
  std::this_thread::sleep_for(kBeforeLeaving);
  std::_Exit(kRight);
}

}  // namespace

int main(int argc, char** argv) {
  flowcert::io::prepare_for_out_of_memory("flowcert-fuzz-mpi");
  CommandLine line;
  std::unique_ptr<BatchProcess> process;
  try {
    parse(argc, argv, line);
    // The process must exist before MPI does. It is not known yet which rank this is.
    if (!line.status) process = std::make_unique<BatchProcess>(line.options);
  } catch (const std::exception& error) {
    line.text = error.what();
    line.status = kUnusable;
  }
  MPI_Init(&argc, &argv);
  int status = kRight;
  {
    RankLines lines;
    if (lines.rank() == 0) {
      process.reset();
      status = be_rank_0(lines, line);
    } else {
      be_another_rank(lines, std::move(process), line);
    }
  }
  MPI_Finalize();
  return status;
}
