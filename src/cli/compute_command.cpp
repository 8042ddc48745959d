// `flowcert compute`: all stationary points of an input and, if wanted, the manifolds U2 and S2. It writes a table
// for people or one JSON object for programs (spec/formats/summary.md). It can also write a file of exact records
// (stationary_points.md) and files for viewers (exports.md).
//
// Guarantees: all files for viewers are computed before the first is written. Each appears whole or not at all.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "cli/command.h"
#include "cli/compute_report.h"
#include "cli/compute_run.h"
#include "cli/layer.h"
#include "cli/progress.h"
#include "flowcert/flow_complex.h"
#include "flowcert/reproducibility.h"
#include "flowcert/vtk_exports.h"
#include "flowcert/write_stationary_points.h"
#include "io/output_file.h"

namespace flowcert::cli {

// ---- --export DIR: the files that viewers open ----

namespace {

namespace fs = std::filesystem;

struct Exports {
  PolyData critical_points, unstable_lines, stable_surfaces;
  SurfaceMesh mesh;
};

Exports exports_of(const FlowComplex& complex) {
  Exports exports;
  ProgressLine points_progress("exporting critical points");
  const VtkExports data_sets(complex, std::ref(points_progress));
  exports.critical_points = data_sets.critical_points();
  ProgressLine surfaces_progress("exporting stable manifolds");
  const std::vector<std::size_t> all = SurfaceSelection({}).sets(complex);
  exports.mesh = surface_mesh(complex, all, std::ref(surfaces_progress));
  exports.stable_surfaces = data_sets.stable_surfaces(exports.mesh);
  ProgressLine lines_progress("exporting unstable manifolds");
  exports.unstable_lines = data_sets.unstable_lines(std::ref(lines_progress));
  return exports;
}

template <typename Write>
void write_file(const fs::path& path, const Write& write) {
  OutputFile file(path.string());
  write(file.stream());
  file.commit();
}

void make_directory(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", directory, error.message()));
}

// Called before anything is computed. Throws OutputError if the path exists and is no directory.
void check_export_directory(const std::string& directory) {
  std::error_code ignored;
  if (fs::exists(directory, ignored) && !fs::is_directory(directory, ignored)) {
    throw OutputError(directory + ": cannot be written: Not a directory");
  }
}

// Makes the directory if it does not exist. input_name is for messages.
void write_export_files(const std::string& directory, const std::string& input_name, const FlowComplex& complex) {
  Exports exports;
  try {
    exports = exports_of(complex);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", input_name, error.what()));
  }
  make_directory(directory);
  const fs::path folder(directory);
  const std::string comment = made_by_text("flowcert-export", 1, complex.points());
  const std::pair<const char*, const PolyData*> data_sets[] = {{"critical_points.vtp", &exports.critical_points},
                                                               {"unstable_lines.vtp", &exports.unstable_lines},
                                                               {"stable_surfaces.vtp", &exports.stable_surfaces}};
  for (const auto& [name, data] : data_sets) {
    write_file(folder / name, [&comment, poly = data](std::ostream& out) { write_vtp(out, *poly, comment); });
  }
  write_file(folder / "stable_surfaces.ply", [&](std::ostream& out) { write_ply(out, exports.mesh, comment); });
}

// ---- The command ----

struct ComputeOptions {
  std::string input;
  std::string output;
  bool json = false;
  unsigned runs = 1;
  std::vector<std::string> manifolds;  // "u2", "s2"
  bool polylines = false;
  bool skeletons = false;
  std::string centers = "exact";
  std::string export_directory;
  unsigned threads = 1;
  U2Choice u2;
};

bool wants(const ComputeOptions& options, const char* manifold) {
  return !options.export_directory.empty() ||
         std::find(options.manifolds.begin(), options.manifolds.end(), manifold) != options.manifolds.end();
}

WantedManifolds wanted_manifolds(const ComputeOptions& options) {
  WantedManifolds wanted;
  wanted.u2 = wants(options, "u2");
  wanted.s2 = wants(options, "s2");
  wanted.options = {.flow = options.u2.flow.options(), .share = !options.u2.alone, .threads = options.threads};
  if (options.polylines && !wanted.u2) throw InvalidInput("--polylines: needs --manifolds u2");
  if (options.u2.alone && !wanted.u2) throw InvalidInput("--alone: needs --manifolds u2");
  if (options.skeletons && !wanted.s2) throw InvalidInput("--skeletons: needs --manifolds s2");
  return wanted;
}

WrittenCenters written_centers(const std::string& name) {
  if (name == "double") return WrittenCenters::kDouble;
  return name == "none" ? WrittenCenters::kNone : WrittenCenters::kExact;
}

void write_records(const ComputeOptions& options, const Measured& measured) {
  std::optional<OutputFile> file;
  if (options.output != kStandardStream) file.emplace(options.output);
  ProgressLine progress("writing exact records");
  const RecordsToWrite wanted = {.u2 = measured.has.u2,
                                 .polylines = options.polylines,
                                 .s2 = measured.has.s2,
                                 .skeletons = options.skeletons,
                                 .centers = written_centers(options.centers)};
  write_stationary_points(file ? file->stream() : std::cout, *measured.last, wanted, std::ref(progress));
  if (file) file->commit();
}

void compute(const ComputeOptions& options) {
  const WantedManifolds wanted = wanted_manifolds(options);
  const bool is_streamed = options.output == kStandardStream;
  if (is_streamed && options.json) throw InvalidInput("-o - and --json would both write to standard output");
  if (!options.export_directory.empty()) check_export_directory(options.export_directory);
  const Input input = read_input(options.input);
  const Measured measured = measure(input.points, options.runs, wanted);
  if (!options.output.empty()) write_records(options, measured);
  if (!options.export_directory.empty()) {
    write_export_files(options.export_directory, display_name(options.input), *measured.last);
  }
  if (options.json) {
    print_compute_summary(input, measured, options.u2);
  } else if (!is_streamed) {
    print_compute_table(display_name(options.input), input, measured, options.u2);
  }
}

// These options mean nothing without --manifolds.
void add_manifold_options(CLI::App& command, ComputeOptions& options, CLI::Option* output) {
  CLI::Option* manifolds =
      command
          .add_option("--manifolds", options.manifolds,
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
      .add_flag("--polylines", options.polylines, "Write each U2 to the file of -o, as exact polylines: a large file")
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
      ->add_option("INPUT", options->input, "Point file: XYZ/text, OFF, PLY or OBJ, also as .gz; - for standard input")
      ->required();
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
  command->add_option("--runs", options->runs, "Measure this many times and print medians; 5 for a ratio to quote")
      ->check(CLI::Range(1, 1000));
  command
      ->add_option("--export", options->export_directory,
                   "Write critical points, U2 and S2 into this directory, as VTP and PLY files for viewers; "
                   "computes u2 and s2")
      ->check(complaint_about_path);
  add_manifold_options(*command, *options, output);
  add_threads_option(*command, options->threads);
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
