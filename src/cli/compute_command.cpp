// `flowcert compute`: all stationary points of an input and, if wanted, all that flows. It writes a table
// for people or one JSON object for programs (src/cli/manual/summary.md). It can also write a file of exact records
// (spec/formats/stationary_points.md) and files for viewers (src/cli/manual/exports.md).
//
// Guarantees: each file for viewers is written when what it shows is made, and appears whole or not at all.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/compute_report.h"
#include "cli/compute_run.h"
#include "cli/export_files.h"
#include "cli/layer.h"
#include "cli/progress.h"
#include "flowcert/flow_complex.h"
#include "flowcert/write_stationary_points.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

struct ComputeOptions : InputOptions {
  std::string output;
  std::string certificate;
  bool json = false;
  unsigned runs = 1;
  std::vector<std::string> manifolds;  // "u2", "s2", "all"
  RecordsToWrite records;              // what the options say of them
  std::string centers = "exact";
  std::string volumes;  // "double", "shares", "exact", or none
  std::string export_directory;
  std::vector<std::string> only;    // names of exported files; all of them if there is none
  std::optional<std::string> clip;  // a number or "none"
  U2Choice u2;
};

bool has_word(const std::vector<std::string>& words, const char* word) { return std::ranges::count(words, word) > 0; }

bool exports(const ComputeOptions& options, const char* what) {
  return !options.export_directory.empty() && (options.only.empty() || has_word(options.only, what));
}

ExportChoice export_choice(const ComputeOptions& options) {
  const bool has_all = has_word(options.manifolds, "all");
  const bool infinity = has_word(options.only, "infinity"), sheets = has_word(options.only, "sheets");
  const bool is_clipped = exports(options, "lines") || infinity || sheets;
  if (options.clip && !is_clipped) {
    throw InvalidInput("--clip: needs lines, infinity or sheets, which --only omits");
  }
  return {.directory = options.export_directory,
          .critical = exports(options, "critical"),
          .surfaces = exports(options, "surfaces"),
          .lines = exports(options, "lines"),
          .cells = has_all && exports(options, "cells"),
          .fans = has_all && exports(options, "fans"),
          .infinity = infinity,
          .sheets = sheets,
          .clip = options.clip ? clip_factor(*options.clip) : ExportChoice{}.clip};
}

std::vector<FlowComplexPart> wanted_parts(const ComputeOptions& options) {
  const bool all = has_word(options.manifolds, "all");
  const bool u2 = all || has_word(options.manifolds, "u2") || exports(options, "lines");
  const bool s2 = all || has_word(options.manifolds, "s2") || exports(options, "surfaces");
  if (options.records.polylines && !u2) throw InvalidInput("--polylines: needs --manifolds u2");
  if (options.u2.alone && !u2) throw InvalidInput("--alone: needs --manifolds u2");
  if (options.records.skeletons && !s2) throw InvalidInput("--skeletons: needs --manifolds s2");
  if (options.records.sheets && !all) throw InvalidInput("--sheets: needs --manifolds all");
  for (const char* file : {"cells", "fans", "infinity", "sheets"}) {
    if (has_word(options.only, file) && !all) {
      throw InvalidInput(fmt::format("--only: {} needs --manifolds all", file));
    }
  }
  if (!options.volumes.empty() && !all) throw InvalidInput("--volumes: needs --manifolds all");
  std::vector<FlowComplexPart> parts;
  if (s2) parts.push_back(FlowComplexPart::kStable);
  if (u2) parts.push_back(FlowComplexPart::kUnstable);
  if (all) parts.insert(parts.end(), {FlowComplexPart::kLimits, FlowComplexPart::kVolumes});
  return parts;
}

WrittenCenters written_centers(const std::string& name) {
  if (name == "double") return WrittenCenters::kDouble;
  return name == "none" ? WrittenCenters::kNone : WrittenCenters::kExact;
}

WrittenVolumes written_volumes(const std::string& name) {
  if (name == "exact") return WrittenVolumes::kExact;
  return name == "shares" ? WrittenVolumes::kShares : WrittenVolumes::kDouble;
}

void write_records(const ComputeOptions& options, const Measured& measured) {
  std::optional<OutputFile> file;
  if (options.output != kStandardStream) file.emplace(options.output);
  ProgressLine progress("writing exact records", file ? -1 : STDOUT_FILENO);
  RecordsToWrite wanted = options.records;
  wanted.u2 = measured.has_u2();
  wanted.s2 = measured.has_s2();
  wanted.all = measured.has_all();
  wanted.centers = written_centers(options.centers);
  wanted.volumes = written_volumes(options.volumes);
  write_stationary_points(file ? file->stream() : std::cout, *measured.last, wanted, std::ref(progress));
  if (file) file->commit();
}

void compute(const ComputeOptions& options) {
  const std::vector<FlowComplexPart> parts = wanted_parts(options);
  const bool is_streamed = options.output == kStandardStream;
  if (is_streamed && options.json) throw InvalidInput("-o - and --json would both write to standard output");
  require_another_file(options.certificate, options.output);
  std::optional<ExportFiles> files;
  if (!options.export_directory.empty()) files.emplace(export_choice(options), display_name(options.input));
  const Input input = read_input(options);
  const PartMade made = [&files](const FlowComplex& complex, FlowComplexPart part) {
    if (files) files->write_after(complex, part);
  };
  const Measured measured =
      measure(input.points, options.runs, complex_options(input, options.u2.options()), parts, made);
  tell_of_many_cells(*measured.last);
  if (!options.output.empty()) write_records(options, measured);
  write_certificate_file(options.certificate, *measured.last);
  if (options.json) {
    print_compute_summary(input, measured, options.u2);
  } else if (!is_streamed) {
    print_compute_table(input, measured, options.u2);
  }
}

// These options mean nothing without --manifolds.
void add_manifold_options(CLI::App& command, ComputeOptions& options, CLI::Option* output) {
  CLI::Option* manifolds =
      command
          .add_option("--manifolds", options.manifolds,
                      "Compute these as well, separated by commas: u2 and s2, the unstable and stable manifolds of "
                      "all critical points of index 2; all: these, the limits of all directions, and volumes")
          ->delimiter(',')
          ->check(CLI::IsMember({"u2", "s2", "all"}));
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
      .add_option("--volumes", options.volumes,
                  "What the file of -o says of volumes, with --manifolds all: double (the nearest doubles), shares "
                  "(also the doubles of what lies in which Voronoi cell) or exact (also the exact numbers of both)")
      ->check(CLI::IsMember({"double", "shares", "exact"}))
      ->default_str("double")
      ->needs(manifolds)
      ->needs(output);
  command
      .add_flag("--polylines", options.records.polylines,
                "Write each U2 to the file of -o, as exact polylines: a large file")
      ->needs(manifolds)
      ->needs(output);
  command
      .add_flag("--skeletons", options.records.skeletons,
                "Write each S2, and the stable sets of regular stationary points, to the file of -o, exactly; with "
                "--manifolds all also each S3, and what flows to infinity")
      ->needs(manifolds)
      ->needs(output);
  command
      .add_flag("--sheets", options.records.sheets,
                "Write each U1, and the unstable sets of regular stationary points of the kinds 1-2 and 1-3, to the "
                "file of -o, exactly, with --manifolds all: a very large file")
      ->needs(manifolds)
      ->needs(output);
}

void add_export_options(CLI::App& command, ComputeOptions& options) {
  CLI::Option* directory =
      command
          .add_option("--export", options.export_directory,
                      "Write critical points, S2 and U2 into this directory, as VTP and PLY files for viewers; "
                      "computes what they need; with --manifolds all also fans of U1, and S3 as VTU")
          ->check(complaint_about_path);
  command
      .add_option("--only", options.only,
                  "Of the files of --export only these, separated by commas: critical, surfaces, lines; "
                  "with --manifolds all also fans and cells, "
                  "and what is written only if it is named here: infinity (what flows there, in the box of --clip) and "
                  "sheets (all of U1: a large file)")
      ->delimiter(',')
      ->check(CLI::IsMember({"critical", "surfaces", "lines", "fans", "cells", "infinity", "sheets"}))
      ->needs(directory);
  command
      .add_option("--clip", options.clip,
                  "Where exported lines, sheets and cells to infinity end: at a box so many times as large as that of "
                  "the input (3, without this), or none, to leave out what has no end")
      ->needs(directory);
}

}  // namespace

void add_compute_command(CLI::App& app) {
  auto options = std::make_shared<ComputeOptions>();
  CLI::App* command = app.add_subcommand("compute", "All critical points, and what flows from them and to them");
  add_input_options(*command, *options,
                    "Point file: XYZ/text, OFF, PLY or OBJ; or a molecule: PDB or mmCIF; also as .gz; - for standard "
                    "input");
  command->add_flag("--json", options->json, "Print one JSON object instead of the table");
  CLI::Option* output =
      command
          ->add_option(
              "-o,--output", options->output,
              "Write the stationary points to this file, JSON Lines; -: to standard output, instead of the table")
          ->check(complaint_about_path);
  command
      ->add_option("--centers", options->centers,
                   "What the file of -o says of centres and squared distances: exact (also the nearest doubles), "
                   "double (these alone) or none")
      ->check(CLI::IsMember({"exact", "double", "none"}))
      ->capture_default_str()
      ->needs(output);
  add_certificate_option(*command, options->certificate);
  command->add_option("--runs", options->runs, "Measure this many times and print medians; 5 for a ratio to quote")
      ->check(CLI::Range(1, 1000));
  add_export_options(*command, *options);
  add_manifold_options(*command, *options, output);
  add_threads_option(*command, options->threads);
  command->footer(
      "Examples:\n  flowcert compute bunny.obj\n  flowcert compute bunny.obj -o bunny.jsonl\n"
      "  flowcert compute bunny.obj -o bunny.jsonl --certificate bunny.fcert\n"
      "  flowcert compute bunny.obj --manifolds u2,s2 --stats\n"
      "  flowcert compute bunny.obj --manifolds all --volumes exact -o bunny.jsonl\n"
      "  flowcert compute bunny.obj --export bunny-files");
  command->callback([options] { compute(*options); });
}

}  // namespace flowcert::cli
