// `flowcert pockets`: pockets, their mouths, and the widest paths out of them; the merge trees; surfaces and cells for
// viewers. The output is a table, or one exact JSON object (spec/formats/pockets.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/automatic_threshold.h"
#include "cli/command.h"
#include "cli/layer.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/flow_complex.h"
#include "flowcert/pocket_persistence.h"
#include "flowcert/pocket_surfaces.h"
#include "flowcert/region_exports.h"
#include "flowcert/reproducibility.h"
#include "flowcert/rounded_sphere.h"
#include "flowcert/write_pockets.h"
#include "io/number_text.h"
#include "io/output_file.h"
#include "io/pair_lengths.h"

namespace flowcert::cli {

namespace {

namespace fs = std::filesystem;

struct PocketsOptions {
  std::string input;
  ReadingOptions reading;
  std::string persistence = "0";
  std::string probe;
  std::string volumes = "double";
  std::string tree;
  std::string directory;
  bool json = false;
  bool all = false;
  unsigned threads = 1;
};

// ---- What is computed ----

std::optional<Probe> probe_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const Rational radius = io::claimed_number(text, io::PlainInteger::kExact, {"--probe", 1}).value;
  if (radius < 0) throw InvalidInput("--probe: not 0 or more: " + text);
  return Probe{radius};
}

struct PocketsRun {
  PocketsRun(const Input& input, const PocketsOptions& options)
      : complex(input.points, complex_options(input, options.threads), part_progress()) {
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
    const auto [persistence, found] = pocket_persistence(complex, options.persistence, "--persistence");
    automatic = found;
    pockets.emplace(complex.merge_trees(), persistence);
    complex.make(FlowComplexPart::kVolumes);
    complex.make(FlowComplexPart::kStable);
    other_seconds = lap();
  }

  FlowComplex complex;
  std::optional<Pockets> pockets;
  std::optional<AutomaticThreshold> automatic;
  double delaunay_seconds = 0, other_seconds = 0;
};

// ---- The table ----

constexpr std::size_t kShownPockets = 20;

std::string number_text(double value) { return fmt::format("{:.4g}", value); }
double root_of(const PocketsRun& run, std::uint32_t record) {
  return std::sqrt(run.complex.rounded_sphere(record).squared_radius);
}

// The deepest come first; of equal depths, the first in the list.
std::vector<std::size_t> by_depth(const Pockets& pockets) {
  std::vector<io::PairEnds> ends;
  ends.reserve(pockets.size());
  for (std::size_t number = 0; number < pockets.size(); ++number) {
    ends.push_back({pockets[number].highest_mouth, pockets[number].peaks.front()});
  }
  const io::ValueOrder order = io::length_order(pockets.squared_distances(), ends);
  std::vector<std::size_t> numbers;
  for (std::size_t k = order.size(); k > 0; --k) numbers.push_back(order.at(k - 1));
  return numbers;
}

void print_pockets(const PocketsRun& run, const std::optional<Probe>& probe, bool all) {
  const Pockets& pockets = *run.pockets;
  if (pockets.size() == 0) return;
  const std::size_t shown = all ? pockets.size() : std::min(kShownPockets, pockets.size());
  const std::string which = shown == pockets.size() ? "all pockets, from the deepest one"
                                                    : fmt::format("the {} deepest pockets", with_commas(shown));
  print_wrapped(fmt::format("\n{}; depths are differences of radii", which), 2);
  Table table(probe ? "rlrrrrrl" : "rlrrrrr",
              {"pocket", "position", "radius", "depth", "volume", "mouths", "widest", probe ? "probe" : ""});
  const std::vector<std::size_t> order = by_depth(pockets);
  for (std::size_t k = 0; k < shown; ++k) {
    const Pocket& pocket = pockets[order[k]];
    const Point center = run.complex.rounded_sphere(pocket.peaks.front()).center;
    table.row(with_commas(order[k]));
    table.cell(fmt::format("{:.4g} {:.4g} {:.4g}", center.x, center.y, center.z));
    table.cell(number_text(root_of(run, pocket.peaks.front())));
    table.cell(number_text(pockets.depth_of_radii(pocket)));
    table.cell(number_text(run.complex.volumes().nearest_sum(pocket.cell)));
    table.cell(pocket.mouths.size());
    table.cell(number_text(root_of(run, pocket.to_infinity.gates.front())));
    if (probe) table.cell(passage_text(pockets.passage(pocket, probe->squared_radius())));
  }
  table.print();
}

void print_passages(const Pockets& pockets, const Probe& probe) {
  std::array<std::size_t, 3> counts{};
  for (std::size_t number = 0; number < pockets.size(); ++number) {
    ++counts.at(static_cast<std::size_t>(pockets.passage(pockets[number], probe.squared_radius())));
  }
  print_row("cavities for the probe", with_commas(counts[0]), "no path to infinity keeps its radius");
  print_row("pockets for the probe", with_commas(counts[1]), "with one mouth that is wide enough");
  print_row("channels for the probe", with_commas(counts[2]), "with several");
}

void print_table(const PocketsOptions& options, const Input& input, const PocketsRun& run,
                 const std::optional<Probe>& probe) {
  const Pockets& pockets = *run.pockets;
  print_wrapped(fmt::format("{} ({})", display_name(options.input), input.file.format));
  print_point_counts(input.points);
  print_row("maxima", with_commas(run.complex.stationary().critical_counts()[3]));
  print_row("pockets", with_commas(pockets.size()),
            fmt::format("merged by persistence {}", number_text(nearest_or_infinity(pockets.persistence()))));
  if (run.automatic) print_automatic("lengths", *run.automatic, "nothing is merged");
  print_row("maxima of the outside", with_commas(pockets.outside().size()));
  if (const auto widest = pockets.widest_path()) {
    print_row("pore limiting radius", number_text(root_of(run, widest->gates.front())), "the widest path to infinity");
    print_row("largest cavity radius", number_text(root_of(run, pockets.largest_balls().front())),
              "the largest ball in a pocket");
  }
  if (probe) print_passages(pockets, *probe);
  print_row("Delaunay triangulation", seconds_text(run.delaunay_seconds));
  print_row("pockets after it", seconds_text(run.other_seconds),
            input.points.size() >= 4 && run.delaunay_seconds > 0
                ? fmt::format("{:.2f} x the triangulation", run.other_seconds / run.delaunay_seconds)
                : "");
  print_pockets(run, probe, options.all);
}

// ---- Files ----

void write_file(const fs::path& path, const FlowComplex& complex,
                const std::function<void(std::ostream&, const std::string&)>& write) {
  const ProgressLine progress("writing " + path.filename().string());
  OutputFile file(path.string());
  write(file.stream(), made_by_text("flowcert-export", 1, complex.points()));
  file.commit();
}

void write_files(const PocketsOptions& options, const PocketsRun& run, const std::optional<Probe>& probe) {
  const fs::path directory = options.directory;
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", options.directory, error.message()));
  const UnstructuredGrid grid = pocket_cell_data(run.complex, *run.pockets);
  const std::vector<PocketSurface> surfaces = pocket_surfaces(run.complex, *run.pockets);
  const auto write = [&](const std::string& name, const auto& how) { write_file(directory / name, run.complex, how); };
  write("pockets.vtu", [&](std::ostream& out, const std::string& made_by) { write_vtu(out, grid, made_by); });
  for (std::size_t number = 0; number < surfaces.size(); ++number) {
    write(fmt::format("pocket_{}.ply", number), [&](std::ostream& out, const std::string& made_by) {
      write_ply(out, surfaces[number], fmt::format("{}; pocket {}", made_by, number));
    });
  }
  write("pockets.json", [&](std::ostream& out, const std::string&) {
    write_pockets(out, {run.complex, *run.pockets, probe, options.volumes == "exact"});
  });
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
  const FlowComplex complex(input.points, complex_options(input, options.threads), part_progress());
  const TreeKind kind = options.tree == "pockets" ? TreeKind::kPockets : TreeKind::kComponents;
  if (options.json) {
    write_merge_tree(std::cout, complex, kind);
  } else {
    write_newick(std::cout, complex, kind);
  }
  std::cout.flush();
}

void run_pockets(const PocketsOptions& options) {
  const std::optional<Probe> probe = probe_of(options.probe);
  const Input input = read_input(options.input, options.reading);
  if (!options.tree.empty()) return print_tree(options, input);
  const PocketsRun run(input, options);
  if (!options.directory.empty()) {
    try {
      write_files(options, run, probe);
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("{}: {}", display_name(options.input), error.what()));
    }
  }
  if (options.json) {
    ProgressLine progress("writing pockets", STDOUT_FILENO);
    write_pockets(std::cout, {run.complex, *run.pockets, probe, options.volumes == "exact"});
    std::cout.flush();
  } else {
    print_table(options, input, run, probe);
  }
}

}  // namespace

void add_pockets_command(CLI::App& app, int& status) {
  auto options = std::make_shared<PocketsOptions>();
  CLI::App* command = app.add_subcommand("pockets", "Cavities, pockets and channels between points; merge trees");
  add_input_options(*command, options->input, options->reading);
  command
      ->add_option("--persistence", options->persistence,
                   "Merge what is not deeper than this, a difference of squared distances: a number, Xspacing^2, qX "
                   "(a quantile) or auto; 0 merges nothing")
      ->type_name("X")
      ->capture_default_str();
  command
      ->add_option("--probe", options->probe,
                   "Say for each pocket what it is for a probe of this radius, measured to the points")
      ->type_name("R");
  command->add_option("--volumes", options->volumes, "Volumes in JSON: nearest doubles, or rationals, which take long")
      ->check(CLI::IsMember({"double", "exact"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object, all exact");
  command->add_flag("--all", options->all, "All pockets in the table, not the 20 deepest alone");
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
      "Examples:\n  flowcert pockets bunny.obj --persistence auto\n"
      "  flowcert pockets bunny.obj --probe 0.002 --json >pockets.json");
  command->callback([options, &status] {
    run_pockets(*options);
    status = kRight;
  });
}

}  // namespace flowcert::cli
