#include "cli/command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <locale>

#include "cli/progress.h"
#include "geometry/parallel_for.h"

namespace flowcert::cli {

namespace {

struct Commas : std::numpunct<char> {
 protected:
  [[nodiscard]] char do_thousands_sep() const override { return ','; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

}  // namespace

std::string complaint_about_path(const std::string& path) { return path.empty() ? "the path is empty" : ""; }

std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\t') {
      line += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      line += c;
    }
  }
  return line;
}

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : on_one_line(path); }

std::string with_commas(unsigned long long value) {
  static const std::locale commas(std::locale::classic(), new Commas);
  return fmt::format(commas, "{:L}", value);
}

namespace {

Input input_of(const std::string& path, const std::vector<std::string>& chains) {
  const bool is_piped = path == kStandardStream;
  const ProgressLine progress(is_piped ? "reading standard input" : "reading points", is_piped ? STDIN_FILENO : -1);
  Input input;
  input.file = read_points(path, chains);
  input.points = PointSet(input.file.rows);
  return input;
}

}  // namespace

void add_input_options(CLI::App& command, std::string& path, std::vector<std::string>& chains,
                       const std::string& description, const char* name) {
  command.add_option(name, path, description)->required();
  command
      .add_option("--chains", chains,
                  "Of a molecule, PDB or mmCIF, only the atoms of these chains, A,B. Atoms are points: their radii are "
                  "ignored, and distances are those to their centres")
      ->delimiter(',');
}

Input read_input(const std::string& path, const std::vector<std::string>& chains) {
  Input input = input_of(path, chains);
  if (input.file.single_precision) {
    fmt::print(stderr, "note: {}: the coordinates are single precision, and are taken exactly as such\n",
               display_name(path));
  }
  if (input.file.declares_single_precision) {
    fmt::print(stderr, "note: {}: declared as float, but decimals: taken as the nearest doubles, not floats\n",
               display_name(path));
  }
  if (const std::size_t line = input.file.line_of_mixed_separators; line > 0) {
    fmt::print(stderr, "note: {}:{}: a comma separates numbers as a blank does, and is no decimal point\n",
               display_name(path), line);
  }
  if (const std::size_t line = input.file.line_of_further_columns; line > 0) {
    fmt::print(stderr, "note: {}:{}: more than three columns; those after the third are ignored\n", display_name(path),
               line);
  }
  if (const std::size_t models = input.file.other_models; models > 0) {
    fmt::print(stderr, "note: {}: only the first model is read; {} other{} left out\n", display_name(path),
               with_commas(models), models == 1 ? " is" : "s are");
  }
  if (const std::size_t places = input.file.other_locations; places > 0) {
    fmt::print(stderr, "note: {}: of an atom with alternate locations the first is read; {} other{} left out\n",
               display_name(path), with_commas(places), places == 1 ? " is" : "s are");
  }
  if (const std::size_t merged = input.points.merged_duplicates(); merged > 0) {
    fmt::print(stderr, "warning: {}: {} repeated point{} merged\n", display_name(path), with_commas(merged),
               merged == 1 ? "" : "s");
  }
  return input;
}

FlowOptions FlowChoice::options() const {
  return {.kernel = kernel == "exact"  ? ConstructionKernel::kExact
                    : kernel == "lazy" ? ConstructionKernel::kLazy
                                       : ConstructionKernel::kCascade,
          .search = search == "linear" ? FacetSearch::kLinear : FacetSearch::kBinary};
}

std::array<CLI::Option*, 2> add_flow_options(CLI::App& command, FlowChoice& choice) {
  CLI::Option* kernel =
      command
          .add_option("--kernel", choice.kernel,
                      "How points on orbits are represented: cascade (directions with a bound on their angle), lazy "
                      "(CGAL's Epeck) or exact (rationals, slow)")
          ->check(CLI::IsMember({"cascade", "lazy", "exact"}))
          ->capture_default_str();
  CLI::Option* search =
      command
          .add_option("--search", choice.search,
                      "How the edge at which an orbit leaves a Voronoi facet is found: binary or linear")
          ->check(CLI::IsMember({"binary", "linear"}))
          ->capture_default_str();
  return {kernel, search};
}

void add_threads_option(CLI::App& command, unsigned& threads) {
  constexpr unsigned kMost = 1024;
  threads = geometry::all_cores();
  command
      .add_option("--threads", threads,
                  "How many threads compute; all cores, without this. The results are the same for any number; the "
                  "triangulation takes one")
      ->check(CLI::Range(1U, kMost));
}

}  // namespace flowcert::cli
