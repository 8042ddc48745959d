// `flowcert cycles`: the loops of tunnels, with the surfaces that fill them; voids; the components that come together.
// The output is a table, or one exact JSON object (src/cli/manual/cycles.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/command.h"
#include "cli/compute_run.h"
#include "cli/export_files.h"
#include "cli/fixed_decimals.h"
#include "cli/layer.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/flow_complex.h"
#include "geometry/difference_of_roots.h"
#include "io/cycle_exports.h"
#include "io/cycles.h"
#include "io/write_cycles.h"
#include "morse/saddle_radii.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kShownCycles = 20;

struct CyclesOptions : InputOptions {
  int dimension = 1;
  std::size_t longest = 10;
  std::string persistence, pair, directory;
  std::string level = "25%";
  bool has_witness = false, json = false, shows_all = false;
};

CycleChoice choice_of(const CyclesOptions& options) {
  CycleChoice choice;
  choice.dimension = options.dimension;
  choice.level = cycle_level_of(options.level, "--level");
  choice.longest = options.longest;
  if (!options.persistence.empty()) choice.longer_than = io::length_bound_of(options.persistence, "--persistence", 1);
  if (!options.pair.empty()) choice.pair = pair_name_of(options.pair, "--pair");
  if (options.has_witness && options.dimension != 1) throw InvalidInput("--witness is for --dimension 1");
  if (!options.directory.empty() && options.dimension == 0) {
    throw InvalidInput("--export is for --dimension 1 and 2; components have no files");
  }
  return choice;
}

// ---- What is computed ----

struct CyclesRun {
  Measured measured;
  std::vector<Cycle> found;
  double seconds = 0;  // for the cycles alone

  [[nodiscard]] const FlowComplex& complex() const { return *measured.last; }
};

CyclesRun run_of(const Input& input, const CyclesOptions& options, const CycleChoice& choice) {
  using enum FlowComplexPart;
  CyclesRun run;
  // Loops are made of links and pairs, which take as much memory as all before them.
  const bool needs_diagram = options.dimension != 1 || !options.directory.empty();
  run.measured = measure(input.points, 1, complex_options(input), {kStable, kLinks, kPersistence},
                         [&](FlowComplex& complex, FlowComplexPart part) {
                           if (part == kLinks && !needs_diagram) complex.forget_diagram();
                         });
  const auto start = std::chrono::steady_clock::now();
  {
    ProgressLine progress("cycles");
    run.found = cycles(run.complex(), choice, std::ref(progress));
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

// ---- Files ----

void write_files(const CyclesOptions& options, const CyclesRun& run) {
  const FlowComplex& complex = run.complex();
  make_directory(options.directory);
  const auto write = [&](const std::string& name, const WriteExport& how) {
    write_export(options.directory, name, complex, how);
  };
  const auto write_meshes = [&](const auto& mesh_of) {
    for (std::size_t k = 0; k < run.found.size(); ++k) {
      write(fmt::format("pair_{}.ply", k), [&](std::ostream& out, const std::string& made_by) {
        write_ply(out, mesh_of(k), fmt::format("{}; pair {}", made_by, k));
      });
    }
  };
  if (options.dimension == 1) {
    write("loops.vtp", [&](std::ostream& out, const std::string& made_by) {
      write_vtp(out, loop_data(complex, run.found), made_by);
    });
    write("loop_surfaces.vtp", [&](std::ostream& out, const std::string& made_by) {
      write_vtp(out, loop_surface_data(complex, run.found), made_by);
    });
    write_meshes(
        [&](std::size_t k) { return loop_surface_mesh(complex, std::get<LoopCycle>(run.found[k].chain).surface); });
  } else {
    write("voids.vtu", [&](std::ostream& out, const std::string& made_by) {
      write_vtu(out, void_data(complex, run.found), made_by);
    });
    const std::vector<CellSurface> surfaces = void_surfaces(complex, run.found);
    write_meshes([&](std::size_t k) { return surfaces[k]; });
  }
}

// ---- The table ----

class Report {
 public:
  Report(const Input& input, const CyclesOptions& options, const CyclesRun& run)
      : input_(input),
        options_(options),
        run_(run),
        complex_(run.complex()),
        values_(complex_.persistence().squared_distances()),
        decimals_(morse::squared_spacing(complex_, values_)),
        shown_(run.found.size()) {
    if (!options.persistence.empty() && !options.shows_all) shown_ = std::min(shown_, kShownCycles);
  }

  void print() const {
    constexpr const char* kNames[] = {"components", "tunnels", "voids"};
    print_input(input_);
    print_point_counts(input_.points);
    const auto is_meant = [this](const PersistencePair& pair) {
      return pair.dimension == options_.dimension && pair.death;
    };
    print_row(fmt::format("pairs of dimension {}", options_.dimension),
              with_commas(static_cast<std::size_t>(std::ranges::count_if(complex_.persistence().pairs(), is_meant))),
              kNames[options_.dimension]);
    print_times(run_.measured);
    print_time(run_.measured, "cycles", run_.seconds);
    if (run_.found.empty()) return print_wrapped("\nno such pair");
    print_title();
    if (options_.dimension == 0) print_components();
    if (options_.dimension == 1) print_loops();
    if (options_.dimension == 2) print_voids();
    if (options_.has_witness) print_witnesses();
  }

 private:
  void print_title() const {
    const bool is_whole = shown_ == run_.found.size();
    print_wrapped(
        fmt::format("\n{}, by distances that are not squared, and the contact sets of both ends: the points nearest "
                    "to them, by row from 0",
                    is_whole ? "pairs, from the longest one down"
                             : fmt::format("the {} longest pairs of {}; --all shows all", shown_,
                                           with_commas(run_.found.size()))),
        2);
    if (options_.dimension == 1) {
      print_wrapped("  loop: the length of its edges; surfaces: stable manifolds S2 that fill the loop", 2);
    }
    if (options_.dimension == 2) print_wrapped("  walls: index-2 points that lead into the void and out of it", 2);
  }

  // The first columns of all dimensions.
  void add_pair(Table& table, std::size_t k) const {
    const auto& [pair, level, chain] = run_.found[k];
    table.row(std::to_string(k));
    table.cell(
        decimals_.length(geometry::nearest_difference_of_roots(values_.exact(*pair.death), values_.exact(pair.birth))));
    if (pair.dimension == 0) return;
    for (const Rational& value : {values_.exact(pair.birth), values_.exact(*pair.death), level->exact()}) {
      table.cell(decimals_.length(geometry::nearest_difference_of_roots(value, 0)));
    }
  }

  void print_loops() const {
    Table table("rrrrrrrrrll", {"pair", "length", "birth", "death", "level", "loop", "edges", "polygons", "surfaces",
                                "born at", "dies at"});
    for (std::size_t k = 0; k < shown_; ++k) {
      const LoopCycle& loop = std::get<LoopCycle>(run_.found[k].chain);
      add_pair(table, k);
      table.cell(decimals_.length(loop_length(complex_, loop)));
      table.cell(loop.edges.size()).cell(loop.polygons.size()).cell(loop.surface.size());
      add_ends(table, run_.found[k].pair);
    }
    table.print_in_parts();
  }

  void print_voids() const {
    Table table("rrrrrrrrll",
                {"pair", "length", "birth", "death", "level", "volume", "maxima", "walls", "born at", "dies at"});
    for (std::size_t k = 0; k < shown_; ++k) {
      const Void& space = std::get<Void>(run_.found[k].chain);
      add_pair(table, k);
      table.cell(decimals_.volume(complex_.volumes().nearest_sum(space.cell)));
      table.cell(space.maxima.size()).cell(space.walls.size());
      add_ends(table, run_.found[k].pair);
    }
    table.print_in_parts();
  }

  void print_components() const {
    Table table("rrrrll", {"pair", "death", "samples", "joined to", "born at", "dies at"});
    for (std::size_t k = 0; k < shown_; ++k) {
      const auto& [one, other] = std::get<JoinedComponents>(run_.found[k].chain);
      add_pair(table, k);
      table.cell(one.size()).cell(other.size());
      add_ends(table, run_.found[k].pair);
    }
    table.print();
  }

  void print_witnesses() const {
    print_wrapped(
        "\nthe witness of each pair, always of its loop at birth; met: index-2 points before the death whose boundary "
        "meets the cocycle. --json has them",
        2);
    const Loops loops(complex_.stationary(), complex_.links(), complex_.persistence());
    Table table("rrrrr", {"pair", "edges", "surfaces", "cocycle", "met"});
    for (std::size_t k = 0; k < shown_; ++k) {
      const LoopWitness witness = loops.witness(run_.found[k].pair);
      table.row(std::to_string(k)).cell(witness.loop.size()).cell(witness.surface.size());
      table.cell(witness.cocycle.size()).cell(witness.met.size());
    }
    table.print();
  }

  void add_ends(Table& table, const PersistencePair& pair) const {
    for (const std::uint32_t record : {pair.birth, *pair.death}) {
      table.cell(contact_text(input_.file.atoms, complex_.stationary().contact(record)));
    }
  }

  const Input& input_;
  const CyclesOptions& options_;
  const CyclesRun& run_;
  const FlowComplex& complex_;
  const SquaredDistances& values_;
  FixedDecimals decimals_;
  std::size_t shown_;
};

// ---- The command ----

void run_cycles(const CyclesOptions& options) {
  const CycleChoice choice = choice_of(options);
  const Input input = read_input(options);
  const CyclesRun run = run_of(input, options, choice);
  if (!options.directory.empty()) {
    naming(input.name, [&] { write_files(options, run); });
  }
  if (options.json) {
    const ProgressLine progress("writing cycles", STDOUT_FILENO);
    write_cycles(std::cout, {run.complex(), options.dimension, run.found, options.has_witness});
    std::cout.flush();
  } else {
    Report(input, options, run).print();
  }
}

}  // namespace

void add_cycles_command(CLI::App& app) {
  auto options = std::make_shared<CyclesOptions>();
  CLI::App* command = app.add_subcommand("cycles", "Loops around tunnels, with surfaces that fill them; voids");
  add_input_options(*command, *options);
  command->add_option("--dimension", options->dimension, "0: components that come together; 1: tunnels; 2: voids")
      ->check(CLI::Range(0, 2))
      ->capture_default_str();
  CLI::Option* longest = command->add_option("--longest", options->longest, "So many pairs, from the longest one down")
                             ->type_name("N")
                             ->capture_default_str();
  CLI::Option* persistence =
      command
          ->add_option("--persistence", options->persistence,
                       "Instead, all pairs that are longer than this, a difference of distances: a number, Xspacing, "
                       "qX (a quantile), or auto, by the valley of all lengths")
          ->type_name("X")
          ->excludes(longest);
  command
      ->add_option("--pair", options->pair,
                   "Instead, one pair, by the contact sets of its ends as the tables tell them: 3,17/5,8,20")
      ->type_name("IDS/IDS")
      ->excludes(longest)
      ->excludes(persistence);
  command
      ->add_option("--level", options->level,
                   "Where between birth and death: a share of the way, in squared distances; a distance, for the pairs "
                   "that are there at it; birth; or death, for the death point's own surface alone")
      ->type_name("F%|R")
      ->capture_default_str();
  command->add_flag("--witness", options->has_witness,
                    "Also what proves each pair of dimension 1, by its loop at birth");
  command->add_flag("--json", options->json, "Print one JSON object, all exact");
  command->add_flag("--all", options->shows_all, "All pairs of --persistence in the table, not the 20 longest alone");
  command
      ->add_option("--export", options->directory,
                   "Write loops.vtp and loop_surfaces.vtp, or voids.vtu, and a surface pair_N.ply for each pair to "
                   "this folder")
      ->type_name("DIR");
  add_threads_option(*command, options->threads);
  command->footer(
      "A loop goes along edges between samples; what fills it is made of stable manifolds\nof index-2 points.\n\n"
      "Examples:\n  flowcert cycles bunny.obj\n"
      "  flowcert cycles bunny.obj --dimension 2 --longest 3 --export voids\n"
      "  flowcert cycles bunny.obj --longest 1 --witness --json >tunnel.json");
  command->callback([options] { run_cycles(*options); });
}

}  // namespace flowcert::cli
