// `flowcert check`: whether a claimed flow complex is right. Exit status 0 if it conforms or is perturbed, 1 if it
// fails; with --strict, 1 if it is perturbed, too.
#include "cli/check_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>
#include <variant>

#include "certify/any_claim.h"
#include "cli/ball_input.h"
#include "cli/check_pairs.h"
#include "cli/check_report.h"
#include "cli/progress.h"
#include "flowcert/claim.h"
#include "flowcert/flow_complex.h"
#include "io/input_bytes.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

struct CheckCommandOptions : BallOptions {
  CheckedFiles files;
  std::string claim_format;  // "pers", "pores", or empty: the content and the ending say it
  bool has_tolerance = false;
  std::string junit;
  std::size_t most = std::numeric_limits<std::size_t>::max();
  bool json = false;
  bool is_strict = false;
};

// A line for each level, one after the other.
class LevelProgress {
 public:
  void operator()(int level, std::size_t done, std::size_t total) {
    if (level_ != level) {
      line_.reset();
      line_.emplace(fmt::format("checking level {}", level));
      level_ = level;
    }
    (*line_)(done, total);
  }

 private:
  int level_ = 0;
  std::optional<ProgressLine> line_;
};

AnyClaim claim_of(const std::string& path, const std::string& format, bool unlimited) {
  const ProgressLine progress("reading the claim");
  return any_claim_in(io::read_bytes(path), path, format, unlimited);
}

CheckReport report_of(const CheckCommandOptions& options, const OtherTruth& oracle, const Input& input, Claim given) {
  const ProgressLine progress("checking");
  const Claim claim = std::move(given);  // a large one takes seconds to free, and is freed before the line
  const FlowComplex complex(input.points, complex_options(input), part_progress());
  const std::unique_ptr<Truth> truth = options.files.by_oracle ? oracle.of(input.file.rows) : fast_truth(complex);
  LevelProgress levels;
  CheckOptions how = options.files.check;
  how.progress = std::ref(levels);
  return check(input.points, claim, *truth, how);
}

// Tells of either kind of claim, in all ways that are asked for. Returns the exit status.
template <typename Report>
int told(const CheckCommandOptions& options, const CheckedFiles& files, const Report& report, const PointSet& points) {
  if (!options.junit.empty()) {
    io::write_whole_file(options.junit, [&](std::ostream& out) { write_check_junit(out, files, report); });
  }
  if (options.json) {
    print_report_json(check_json(files, report, points));
  } else {
    print_check_text(files, report, options.most);
  }
  return status_of(report.verdict, options.is_strict);
}

int check_complex(const CheckCommandOptions& options, const OtherTruth& oracle, const Input& input, Claim claim) {
  CheckedFiles files = options.files;
  require_rows(claim, input.points, files.claim);
  files.claim_format = claim.format;
  const CheckReport report = report_of(options, oracle, input, std::move(claim));
  return told(options, files, report, input.points);
}

std::vector<ListedPair> true_pairs(const CheckCommandOptions& options, const OtherTruth& oracle, const Input& input) {
  const ProgressLine progress("pairing");
  if (options.files.by_oracle) return oracle.pairs_of(input.file.rows);
  return listed_pairs(FlowComplex(input.points, complex_options(input), part_progress()));
}

int check_diagram(const CheckCommandOptions& options, const OtherTruth& oracle, const Input& input,
                  const std::vector<ClaimedPair>& claimed) {
  refuse_levels(options.files.check, "a persistence diagram");
  CheckedFiles files = options.files;
  files.claim_format = "persistence";
  const PairReport report = report_of_pairs(claimed, true_pairs(options, oracle, input), options.files.check.tolerance);
  return told(options, files, report, input.points);
}

int check_cycles(const CheckCommandOptions& options, const Input& input, const CycleClaim& claim) {
  refuse_levels(options.files.check, "of cycles");
  if (options.files.by_oracle) throw InvalidInput("--oracle judges no cycles");
  require_rows(claim, input.points, options.files.claim);
  CheckedFiles files = options.files;
  files.claim_format = "cycles";
  const PairReport report = [&] {
    const ProgressLine progress("judging cycles");
    return report_of_cycles(claim, FlowComplex(input.points, complex_options(input), part_progress()),
                            options.files.check.tolerance);
  }();
  return told(options, files, report, input.points);
}

int check_pores(CheckCommandOptions options, const PoreClaim& claim) {
  refuse_levels(options.files.check, "of pores");
  if (options.files.by_oracle) throw InvalidInput("--oracle judges no pores");
  require_radii(true, !options.radii.empty());
  if (!options.has_tolerance) options.files.check.tolerance = kPoreTolerance;
  const BallInput input = read_ball_input(options);
  CheckedFiles files = options.files;
  files.points = input.name;
  files.claim = display_name(files.claim);
  files.claim_format = "pores";
  const PairReport report = [&] {
    const ProgressLine progress("judging pores");
    const Pores pores(input.balls, claim.depth, input.threads);
    return report_of_pores(claim, pores, files.check.tolerance, files.claim);
  }();
  return told(options, files, report, PointSet(input.file.file.rows));
}

int check_claim(CheckCommandOptions options, const OtherTruth& oracle) {
  CheckedFiles& files = options.files;
  if (options.input == kStandardStream && files.claim == kStandardStream) {
    throw InvalidInput("POINTS and CLAIM cannot both be standard input");
  }
  AnyClaim claim = claim_of(files.claim, options.claim_format, options.reading.unlimited);
  if (const auto* pores = std::get_if<PoreClaim>(&claim)) return check_pores(options, *pores);
  require_radii(false, !options.radii.empty());
  const Input input = read_input(options);
  if (!input.file.atoms.empty()) files.atoms = &input.file.atoms;
  files.points = input.name;
  files.claim = display_name(files.claim);
  if (auto* complex = std::get_if<Claim>(&claim)) return check_complex(options, oracle, input, std::move(*complex));
  if (const auto* cycles = std::get_if<CycleClaim>(&claim)) return check_cycles(options, input, *cycles);
  return check_diagram(options, oracle, input, std::get<std::vector<ClaimedPair>>(claim));
}

}  // namespace

void add_check_command(CLI::App& app, int& status, const OtherTruth& oracle) {
  auto options = std::make_shared<CheckCommandOptions>();
  CLI::App* command = app.add_subcommand("check", kCheckPurpose);
  add_input_options(*command, *options, "Point file, or - for standard input", "POINTS");
  command
      ->add_option(
          "CLAIM", options->files.claim,
          "What an implementation claims of it: JSON Lines as compute -o writes them, JSON as pockets --json "
          "writes it, CSV, VTP, or the text format of Giesen and Kühne's algorithm; a persistence diagram, as "
          "persistence writes it or as lines of dimension, birth and death; cycles, as cycles --json writes them or as "
          "lines; or, with --radii, diameters of pores, likewise; also as .gz; - for standard input")
      ->required();
  command
      ->add_option(
          "--claim-format", options->claim_format,
          "pers: the claim is a persistence diagram; lines of four columns are known as one by this or by the "
          "ending .pers. pores: it has diameters of the room between balls; with them --tolerance is 1e-6 if it "
          "is not said")
      ->check(CLI::IsMember({"pers", "pores"}));
  add_radii_options(*command, *options, false);
  command->add_flag("--json", options->json, "Print one JSON object");
  command->add_option("--junit", options->junit, "Write a JUnit report to this file, a test case a level")
      ->check(complaint_about_path);
  add_judging_options(*command, options->files.check, options->is_strict);
  command
      ->add_option("--most", options->most,
                   "After one finding of each reason, show so many of each level; all, without this")
      ->check(CLI::NonNegativeNumber);
  add_threads_option(*command, options->threads);
  command->add_flag(
      "--oracle", options->files.by_oracle,
      fmt::format("Let the oracle say what is true, not the fast implementation: up to {} points", oracle.most_points));
  command->footer(
      "Levels: 1 well formed; 2 every claimed critical point is one; 3 none is missing, none twice, indices, "
      "Euler sum; 4 incidences; 5 polylines, surfaces, lambda-lists, connections, volumes, unstable sets and pockets.\n"
      "Verdicts: conforms; conforms where determined (permitted variations are listed); perturbed (some of it is what "
      "a perturbation of the points makes); fails.\n\n"
      "Examples:\n  flowcert check bunny.obj claim.jsonl\n  flowcert check bunny.obj claim.csv --tolerance "
      "1e-6 "
      "--junit report.xml\n  flowcert check bunny.obj saddles.csv --indices 1,2,3\n  flowcert persistence "
      "bunny.obj -o d.pers; flowcert check bunny.obj d.pers\n  flowcert check bunny.obj bunny.json\n"
      "  flowcert check cage.xyz diameters.txt --claim-format pores --radii bondi");
  command->callback([command, options, oracle, &status] {
    options->has_tolerance = command->count("--tolerance") > 0;
    status = check_claim(*options, oracle);
  });
}

}  // namespace flowcert::cli
