// `flowcert compute`: all stationary points of an input and, if wanted, the manifolds U2 and S2, as a table
// for people, one JSON object for programs (spec/formats.md, section 3), and a file of exact records
// (section 2), or of files for viewers ("Exports").
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "cli/command.h"
#include "cli/compute_report.h"
#include "cli/compute_run.h"
#include "cli/export_files.h"
#include "cli/progress_line.h"
#include "flowcert/write_stationary_points.h"
#include "io/output_file.h"
#include "io/write_manifolds.h"

namespace flowcert::cli {

namespace {

struct ComputeOptions {
  std::string input;
  std::string output;
  bool json = false;
  unsigned runs = 1;
  std::vector<std::string> manifolds;  // "u2", "s2"
  bool polylines = false;
  bool skeletons = false;
  std::string export_directory;
  U2Choice u2;
};

bool wants(const ComputeOptions& options, const char* manifold) {
  return !options.export_directory.empty() ||
         std::find(options.manifolds.begin(), options.manifolds.end(), manifold) != options.manifolds.end();
}

WantedManifolds wanted_manifolds(const ComputeOptions& options) {
  WantedManifolds wanted;
  const FlowOptions flow = options.u2.flow.options();
  if (wants(options, "u2")) wanted.u2 = UnstableOptions{.flow = flow, .share = !options.u2.alone};
  if (wants(options, "s2")) wanted.s2 = StableOptions{.flow = flow};
  if (options.polylines && !wanted.u2) throw InvalidInput("--polylines: needs --manifolds u2");
  if (options.u2.alone && !wanted.u2) throw InvalidInput("--alone: needs --manifolds u2");
  if (options.skeletons && !wanted.s2) throw InvalidInput("--skeletons: needs --manifolds s2");
  return wanted;
}

void write_records(const ComputeOptions& options, const Input& input, ComputeRun& run) {
  OutputFile file(options.output);
  ProgressLine progress("writing exact records");
  if (run.u2 || run.s2) {
    const ManifoldsToWrite manifolds = {.u2 = run.u2 ? &*run.u2 : nullptr,
                                        .polylines = options.polylines,
                                        .s2 = run.s2 ? &*run.s2 : nullptr,
                                        .skeletons = options.skeletons};
    write_manifolds(file.stream(), input.points, run.stationary, manifolds, input.sha256, std::ref(progress));
  } else {
    write_stationary_points(file.stream(), input.points, run.stationary, input.sha256, std::ref(progress));
  }
  file.commit();
}

void compute(const ComputeOptions& options) {
  const WantedManifolds wanted = wanted_manifolds(options);
  if (!options.export_directory.empty()) check_export_directory(options.export_directory);
  const Input input = read_input(options.input);
  const Measured measured = measure(input.points, options.runs, wanted);
  if (!options.output.empty()) write_records(options, input, *measured.last);
  if (!options.export_directory.empty()) {
    write_export_files(options.export_directory, display_name(options.input), input, *measured.last);
  }
  if (options.json) {
    print_compute_summary(input, measured, options.u2);
  } else {
    print_compute_table(display_name(options.input), input, measured, options.u2);
  }
}

// They mean nothing without --manifolds.
void add_manifold_options(CLI::App& command, ComputeOptions& options, CLI::Option* output) {
  CLI::Option* manifolds =
      command
          .add_option(
              "--manifolds", options.manifolds,
              "Compute these as well, separated by commas: u2 and s2, the unstable and stable manifolds of "
              "all critical points of index 2")
          ->delimiter(',')
          ->check(CLI::IsMember({"u2", "s2"}));
  command
      .add_flag("--stats", options.u2.with_statistics,
                "Print lengths, types and exact sizes of what flows, as the paper's tables do")
      ->needs(manifolds);
  command
      .add_flag("--alone", options.u2.alone,
                "Compute each orbit alone; without this, orbits share what follows a common Voronoi vertex")
      ->needs(manifolds);
  for (CLI::Option* option : add_flow_options(command, options.u2.flow)) option->needs(manifolds);
  command
      .add_flag("--polylines", options.polylines,
                "Write each U2 to the file of -o, as exact polylines: a large file")
      ->needs(manifolds)
      ->needs(output);
  command
      .add_flag("--skeletons", options.skeletons,
                "Write each S2, and the stable sets of regular stationary points, to the file of -o, exactly")
      ->needs(manifolds)
      ->needs(output);
}

}  // namespace

void add_compute_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ComputeOptions>();
  CLI::App* command =
      app.add_subcommand("compute", "All critical points of the distance function, and what flows from them");
  command
      ->add_option("INPUT", options->input,
                   "Point file: XYZ/text, OFF, PLY or OBJ, also as .gz; - for standard input")
      ->required();
  command->add_flag("--json", options->json, "Print one JSON object instead of the table");
  CLI::Option* output = command->add_option("-o,--output", options->output,
                                            "Write the stationary points to this file, JSON Lines");
  command
      ->add_option("--runs", options->runs,
                   "Measure this many times and print medians; 5 for a ratio to quote")
      ->check(CLI::Range(1, 1000));
  command->add_option(
      "--export", options->export_directory,
      "Write critical points, U2 and S2 into this directory, as VTP and PLY files for viewers; "
      "computes u2 and s2");
  add_manifold_options(*command, *options, output);
  command->footer(
      "Examples:\n  flowcert compute bunny.obj -o bunny.jsonl\n  flowcert compute bunny.obj --manifolds "
      "u2,s2 "
      "--stats\n  flowcert compute bunny.obj --export bunny-files");
  command->callback([options, &status] {
    compute(*options);
    status = kRight;
  });
}

}  // namespace flowcert::cli
