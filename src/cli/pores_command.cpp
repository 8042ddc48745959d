// `flowcert pores`: chambers between balls, their gates, exits and windows, for probes of all radii. The output is a
// table, or one exact JSON object (src/cli/manual/pores.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "cli/ball_input.h"
#include "cli/cavity_curve_svg.h"
#include "cli/command.h"
#include "cli/export_files.h"
#include "cli/layer.h"
#include "cli/pores_report.h"
#include "cli/progress.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

struct PoresOptions : BallOptions {
  std::string depth = "0.1";
  std::string csv, windows_csv, curve;
  bool json = false, all = false;
};

void write_curve(const std::string& path, const Pores& pores, const std::string& source) {
  io::write_whole_file(path, [&](std::ostream& out) {
    if (std::filesystem::path(path).extension() == ".csv") {
      write_cavity_curve_csv(out, pores);
    } else {
      out << cavity_curve_svg(pores, source);
    }
  });
}

void run_pores(const PoresOptions& options) {
  const Rational depth = length_of_option(options.depth, "--depth");
  const std::optional<Rational> probe =
      options.probe.empty() ? std::nullopt : std::optional(length_of_option(options.probe, "--probe"));
  if ((options.csv == kStandardStream) + (options.windows_csv == kStandardStream) + options.json > 1) {
    throw InvalidInput("only one of --csv, --windows-csv and --json can write to standard output");
  }
  const BallInput input = read_ball_input(options);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::optional<Pores> pores;
  {
    const ProgressLine progress("computing");
    pores.emplace(input.balls, depth, input.threads);
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const PoresToWrite what{*pores, depth, probe, input.atoms(), on_one_line(options.radii)};
  const std::string source = fmt::format("{}, radii {}", input.title(), what.radii);
  if (!options.curve.empty()) write_curve(options.curve, *pores, source);
  const bool is_csv = write_table(options.csv, [&](std::ostream& out) { write_pores_csv(out, what); });
  const bool is_windows = write_table(options.windows_csv, [&](std::ostream& out) { write_windows_csv(out, what); });
  if (options.json) {
    ProgressLine progress("writing pores", STDOUT_FILENO);
    write_pores(std::cout, what);
    std::cout.flush();
  } else if (!is_csv && !is_windows) {
    print_pores_report({input.title(), what, options.all, seconds});
    if (!options.curve.empty()) print_cavity_curve(*pores);
  }
}

}  // namespace

void add_pores_command(CLI::App& app) {
  auto options = std::make_shared<PoresOptions>();
  CLI::App* command = app.add_subcommand("pores", "Chambers between atoms with radii: gates, exits and windows");
  add_input_options(*command, *options, "File of atoms, or - for standard input");
  add_radii_options(*command, *options, true);
  command->add_option("--depth", options->depth, "Tell chambers whose peak is this much wider than their gate, or more")
      ->type_name("D")
      ->capture_default_str();
  command->add_option("--probe", options->probe, "Say for each chamber what it is for a probe of this radius")
      ->type_name("R");
  command->add_flag("--json", options->json, "Print one JSON object, all exact");
  command->add_flag("--all", options->all, "All chambers and windows in the tables, not the deepest and widest alone");
  command
      ->add_option("--csv", options->csv,
                   "Write a table of CSV to this file, a row for each chamber; -: to standard output")
      ->check(complaint_about_path);
  command
      ->add_option("--windows-csv", options->windows_csv,
                   "Write a row for each window of each chamber to this file; -: likewise")
      ->check(complaint_about_path);
  command
      ->add_option("--curve", options->curve,
                   "Write the number of cavities for each probe to this file: as a picture, or as a table if it ends "
                   "in .csv; and print it")
      ->type_name("FILE")
      ->check(complaint_about_path);
  add_threads_option(*command, options->threads);
  command->footer(
      "Radii: bondi, alvarez, pqr, column:N, table:FILE or a number, with ,Fe=2.04 for others.\n\n"
      "Examples:\n  flowcert pores cage.xyz --radii bondi\n"
      "  flowcert pores cage.xyz --radii bondi --depth 0.5 --probe 1.4\n"
      "  flowcert pores cage.xyz --radii bondi --curve curve.svg\n"
      "  flowcert pores protein.pdb --atoms protein --radii bondi --json >pores.json");
  command->callback([options] { run_pores(*options); });
}

}  // namespace flowcert::cli
