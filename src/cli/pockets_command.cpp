// `flowcert pockets`: pockets, their mouths, and the widest paths out of them; the merge trees; surfaces and cells for
// viewers. With radii, the cavities between balls for one probe. The output is a table, or one exact JSON object
// (src/cli/manual/pockets.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/ball_input.h"
#include "cli/command.h"
#include "cli/export_files.h"
#include "cli/layer.h"
#include "cli/pockets_report.h"
#include "cli/pores_report.h"
#include "cli/progress.h"
#include "flowcert/ball_cavities.h"
#include "flowcert/flow_complex.h"
#include "io/cell_surfaces.h"
#include "io/number_text.h"
#include "io/output_file.h"
#include "io/pocket_persistence.h"
#include "io/region_exports.h"
#include "io/write_pockets.h"

namespace flowcert::cli {

namespace {

struct PocketsOptions : BallOptions {
  std::string persistence = "auto";
  std::string volumes = "double";
  std::string tree;
  std::string directory, csv, atoms_csv;
  bool json = false;
  bool all = false;
};

// ---- What is computed ----

std::optional<Probe> probe_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return Probe{length_of_option(text, "--probe")};
}

struct PocketsRun {
  PocketsRun(const Input& input, const PocketsOptions& options)
      : complex(input.points, complex_options(input), part_progress()) {
    const ProgressLine progress("computing");
    using Clock = std::chrono::steady_clock;
    Clock::time_point start = Clock::now();
    const auto lap = [&start] {
      const Clock::time_point now = Clock::now();
      const double seconds = std::chrono::duration<double>(now - start).count();
      start = now;
      return seconds;
    };
    complex.make(FlowComplexPart::kTriangulation);
    delaunay_seconds = lap();
    complex.make(FlowComplexPart::kMergeTrees);
    const auto [squared_persistence, found] = pocket_persistence(complex, options.persistence, "--persistence");
    automatic = found;
    pockets.emplace(complex.merge_trees(), squared_persistence);
    complex.make(FlowComplexPart::kVolumes);
    complex.make(FlowComplexPart::kStable);
    other_seconds = lap();
  }

  FlowComplex complex;
  std::optional<Pockets> pockets;
  std::optional<AutomaticThreshold> automatic;
  double delaunay_seconds = 0, other_seconds = 0;
};

// ---- Files ----

void write_files(const PocketsOptions& options, const PocketsRun& run, const PocketsToWrite& what) {
  make_directory(options.directory);
  const UnstructuredGrid grid = pocket_cell_data(run.complex, *run.pockets);
  const std::vector<CellSurface> surfaces = cell_surfaces(run.complex, run.pockets->cells());
  const auto write = [&](const std::string& name, const WriteExport& how) {
    write_export(options.directory, name, run.complex, how);
  };
  write("pockets.vtu", [&](std::ostream& out, const std::string& made_by) { write_vtu(out, grid, made_by); });
  for (std::size_t number = 0; number < surfaces.size(); ++number) {
    write(fmt::format("pocket_{}.ply", number), [&](std::ostream& out, const std::string& made_by) {
      write_ply(out, surfaces[number], fmt::format("{}; pocket {}", made_by, number));
    });
  }
  write("pockets.json", [&](std::ostream& out, const std::string&) { write_pockets(out, what); });
  const auto write_trees = [&](TreeKind kind, const std::string& name) {
    write(name + "_tree.json",
          [&](std::ostream& out, const std::string&) { write_merge_tree(out, run.complex, kind); });
    write(name + "_tree.nwk", [&](std::ostream& out, const std::string&) { write_newick(out, run.complex, kind); });
  };
  write_trees(TreeKind::kPockets, "pockets");
  write_trees(TreeKind::kComponents, "components");
}

// ---- The command ----

void print_tree(const PocketsOptions& options, const Input& input) {
  const FlowComplex complex(input.points, complex_options(input), part_progress());
  const TreeKind kind = options.tree == "pockets" ? TreeKind::kPockets : TreeKind::kComponents;
  if (options.json) {
    write_merge_tree(std::cout, complex, kind);
  } else {
    write_newick(std::cout, complex, kind);
  }
  std::cout.flush();
}

// Between balls.
void run_cavities(const PocketsOptions& options) {
  const Rational probe = length_of_option(options.probe, "--probe");
  const BallInput input = read_ball_input(options);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::vector<BallCavity> cavities = [&] {
    const ProgressLine progress("computing");
    return ball_cavities(input.balls, probe);
  }();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const CavitiesToWrite what{input.balls, cavities, probe, input.atoms(), on_one_line(options.radii)};
  const bool is_csv = write_table(options.csv, [&](std::ostream& out) { write_cavities_csv(out, what); });
  const bool is_atoms = write_table(options.atoms_csv, [&](std::ostream& out) { write_cavity_atoms_csv(out, what); });
  if (options.json) {
    write_cavities(std::cout, what);
    std::cout.flush();
  } else if (!is_csv && !is_atoms) {
    print_cavities_report({input.title(), what, options.all, seconds});
  }
}

// Pockets between points have more than cavities between balls.
void refuse_with_radii(const CLI::App& command) {
  for (const char* option : {"--persistence", "--volumes", "--tree", "--export"}) {
    if (command.count(option) == 0) continue;
    throw InvalidInput(fmt::format("{} is for pockets between points, and --radii takes atoms for balls", option));
  }
  if (command.count("--probe") > 0) return;
  throw InvalidInput(
      "--radii needs --probe R, a radius beyond the surfaces of atoms; for all probes at once there is flowcert pores");
}

void run_pockets(const PocketsOptions& options, const CLI::App& command) {
  if (!options.radii.empty()) refuse_with_radii(command);
  const std::optional<Probe> probe = probe_of(options.probe);
  if ((options.csv == kStandardStream) + (options.atoms_csv == kStandardStream) + options.json > 1) {
    throw InvalidInput("only one of --csv, --atoms-csv and --json can write to standard output");
  }
  if (!options.radii.empty()) return run_cavities(options);
  const Input input = read_input(options);
  if (!options.tree.empty()) return print_tree(options, input);
  const AtomNames* const atoms = input.file.atoms.empty() ? nullptr : &input.file.atoms;
  if (!options.atoms_csv.empty() && atoms == nullptr) {
    throw InvalidInput(
        fmt::format("{}: --atoms-csv is for PDB, CIF and chemical XYZ, and this is {}", input.name, input.file.format));
  }
  const PocketsRun run(input, options);
  const PocketsToWrite what{run.complex, *run.pockets, probe, options.volumes == "exact", atoms};
  if (!options.directory.empty()) {
    naming(input.name, [&] { write_files(options, run, what); });
  }
  const bool is_rows_printed = write_table(options.csv, [&](std::ostream& out) { write_pocket_csv(out, what); });
  const bool is_lining_printed =
      write_table(options.atoms_csv, [&](std::ostream& out) { write_lining_csv(out, what); });
  if (options.json) {
    ProgressLine progress("writing pockets", STDOUT_FILENO);
    write_pockets(std::cout, what);
    std::cout.flush();
  } else if (!is_rows_printed && !is_lining_printed) {
    print_pockets_report({input, what, run.automatic, options.all, run.delaunay_seconds, run.other_seconds});
  }
}

}  // namespace

void add_pockets_command(CLI::App& app) {
  auto options = std::make_shared<PocketsOptions>();
  CLI::App* command = app.add_subcommand("pockets", "Cavities, pockets and channels between points; merge trees");
  add_input_options(*command, *options);
  add_radii_options(*command, *options, false);
  command
      ->add_option("--persistence", options->persistence,
                   "Tell pockets that are deeper than this, a difference of distances, and merge others: a number, "
                   "Xspacing, qX (a quantile), or auto: by the valley of all depths, or else 1/2spacing; 0 tells each "
                   "maximum")
      ->type_name("X")
      ->capture_default_str();
  command
      ->add_option("--probe", options->probe,
                   "Say for each pocket what it is for a probe of this radius, measured to the points, of atoms to "
                   "their centres; with --radii, tell the cavities for it, measured to the atoms' surfaces")
      ->type_name("R");
  command->add_option("--volumes", options->volumes, "Volumes in JSON: nearest doubles, or rationals, which take long")
      ->check(CLI::IsMember({"double", "exact"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object, all exact");
  command->add_flag("--all", options->all, "All pockets in the table, not the 20 deepest alone");
  command
      ->add_option("--csv", options->csv,
                   "Write a table of CSV to this file, a row for each pocket; -: to standard output")
      ->check(complaint_about_path);
  command
      ->add_option("--atoms-csv", options->atoms_csv,
                   "Write the atoms of a molecule that line each pocket to this file, with their residues; -: likewise")
      ->check(complaint_about_path);
  CLI::Option* tree =
      command
          ->add_option(
              "--tree", options->tree,
              "Print a merge tree instead, as Newick text or with --json: of the pockets, or of the components")
          ->check(CLI::IsMember({"pockets", "components"}));
  command
      ->add_option("--export", options->directory,
                   "Write pockets.vtu, a surface pocket_N.ply for each, pockets.json and both trees to this folder")
      ->type_name("DIR")
      ->excludes(tree);
  add_threads_option(*command, options->threads);
  command->footer(
      "A pocket is where the flow ends at some maxima; its mouths are critical points of index 2.\n\n"
      "Examples:\n  flowcert pockets bunny.obj\n"
      "  flowcert pockets protein.pdb --atoms \"no water,no ligands\" --probe 3.1\n"
      "  flowcert pockets bunny.obj --probe 0.002 --json >pockets.json\n"
      "  flowcert pockets cage.xyz --radii bondi --probe 2");
  command->callback([options, command] { run_pockets(*options, *command); });
}

}  // namespace flowcert::cli
