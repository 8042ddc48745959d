#include "cli/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "cli/progress.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "flowcert/write_stationary_points.h"
#include "geometry/parallel_for.h"
#include "io/diagnostic.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::cli {

std::string complaint_about_path(const std::string& path) { return path.empty() ? "the path is empty" : ""; }

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : on_one_line(path); }

namespace {

constexpr char kReadingGroup[] = "Reading points";

void add_options_of_tables(CLI::App& command, ReadingOptions& reading) {
  command
      .add_option("--columns", reading.columns,
                  "Of a table, which columns are x, y and z, by number from 1 or by name: 2,3,4 or x,y,z")
      ->type_name("C,C,C")
      ->group(kReadingGroup);
  // CLI11 would round a number twice.
  command
      .add_option_function<std::string>(
          "--z",
          [&reading](const std::string& text) {
            const io::NumberText number = io::parse_number(text);
            if (number.fault != nullptr)
              throw InvalidInput(fmt::format("--z: {}: {}", number.fault, io::in_quotes(text)));
            reading.z = number.value;
          },
          "Of a table of two columns, the third coordinate of all points")
      ->type_name("Z")
      ->group(kReadingGroup);
  command
      .add_flag("--skip-invalid", reading.skip_invalid,
                "Leave out rows with a coordinate that is not a finite number; they are counted")
      ->group(kReadingGroup);
  command
      .add_flag("--unlimited", reading.unlimited,
                "Also read compressed files that grow to more than a hundred times their size, and compute points "
                "with more than a hundred Delaunay cells each, and two million")
      ->group(kReadingGroup);
}

void add_options_of_molecules(CLI::App& command, ReadingOptions& reading) {
  command
      .add_option(
          "--atoms", reading.atoms,
          "Of a molecule, words for its atoms: all, protein, nucleic, water, ligands, hydrogens, hetatm, chain X "
          "add atoms, and take them away after 'no'; altloc X chooses alternate locations. Atoms are points: "
          "their radii are ignored, and distances are those to their centres")
      ->delimiter(',')
      ->type_name("WORDS")
      ->group(kReadingGroup);
  command.add_option("--chains", reading.chains, "Of a molecule, only the atoms of these chains: A,B")
      ->delimiter(',')
      ->group(kReadingGroup);
  command
      .add_option("--models", reading.models, "Of a molecule, the models to read: all, or 1,2; the first without this")
      ->group(kReadingGroup);
  command.add_option("--frame", reading.frame, "Of chemical XYZ with several frames, the one to read; the first is 1")
      ->check(CLI::PositiveNumber)
      ->group(kReadingGroup);
}

}  // namespace

void add_input_options(CLI::App& command, InputOptions& options, const std::string& description, const char* name) {
  ReadingOptions& reading = options.reading;
  command.add_option(name, options.input, description)->required();
  command
      .add_option(
          "--format", reading.format,
          "Read it as this: table (rows of numbers, CSV), pts, chemical (XYZ with elements), off, ply, obj, pcd, "
          "npy, pdb, pqr or cif, each also compressed by gzip; without this its content says what it is")
      ->type_name("NAME")
      ->group(kReadingGroup);
  add_options_of_tables(command, reading);
  add_options_of_molecules(command, reading);
}

ProgressLine reading_line(const std::string& path, const std::string& what) {
  const bool is_piped = path == kStandardStream;
  return ProgressLine(is_piped ? "reading standard input" : "reading " + what, is_piped ? STDIN_FILENO : -1);
}

void tell_of_reading(const std::string& path, const PointFile& file) {
  for (const ReadingNote& note : file.notes) {
    const std::string line = note.line > 0 ? fmt::format(":{}", note.line) : "";
    io::tell(fmt::format("note: {}{}: {}\n", display_name(path), line, on_one_line(note.text)));
  }
  if (const std::size_t rows = file.left_out.size(); rows > 0) {
    io::tell(fmt::format("note: {}: {} row{} left out, with a coordinate that is not a finite number\n",
                         display_name(path), with_commas(rows), rows == 1 ? " is" : "s are"));
  }
}

PointFile read_points_aloud(const std::string& path, const ReadingOptions& reading) {
  PointFile file = [&] {
    const ProgressLine progress = reading_line(path, "points");
    return read_points(path, reading);
  }();
  tell_of_reading(path, file);
  return file;
}

Input read_input(const InputOptions& options) {
  Input input;
  input.name = display_name(options.input);
  input.file = read_points_aloud(options.input, options.reading);
  input.points = PointSet(input.file.rows, input.file.left_out);
  if (const std::size_t merged = input.points.merged_duplicates(); merged > 0) {
    io::tell(fmt::format("warning: {}: {} merged\n", input.name, counted(merged, "repeated point")));
  }
  input.most_cells = options.reading.unlimited ? kAnyNumberOfCells : usual_most_cells(input.points.size());
  input.threads = options.threads;
  return input;
}

FlowOptions complex_options(const Input& input, FlowOptions flow) {
  flow.threads = input.threads;
  flow.most_cells = input.most_cells;
  return flow;
}

void tell_of_many_cells(std::size_t cells, std::size_t points) {
  constexpr std::size_t kManyForAPoint = 100, kMany = 100'000;
  if (cells < kMany || cells / points < kManyForAPoint) return;
  io::tell(fmt::format("note: {} Delaunay cells, {} a point: memory and output grow with the square of the points\n",
                       with_commas(cells), with_commas(cells / points)));
}

void print_input(const Input& input) { print_wrapped(fmt::format("{} ({})", input.name, input.file.format)); }

void print_point_counts(const PointSet& points) {
  print_row("points", with_commas(points.row_count()));
  print_row("merged duplicates", with_commas(points.merged_duplicates()));
  if (!points.left_out().empty()) print_row("rows left out", with_commas(points.left_out().size()));
}

std::string unbroken(std::string name) {
  std::ranges::replace(name, ' ', kFixedBlank);
  return name;
}

std::string atoms_of_contact(const AtomNames& atoms, std::span<const PointId> rows) {
  constexpr std::size_t kShown = 4;
  if (atoms.empty() || rows.empty()) return "";
  std::vector<std::string> texts;
  for (const PointId row : rows.first(std::min(kShown, rows.size()))) texts.push_back(unbroken(atoms.text(row)));
  return fmt::format(" ({}{})", fmt::join(texts, ", "), rows.size() > kShown ? ", ..." : "");
}

std::string contact_text(const AtomNames& atoms, std::span<const PointId> rows) {
  constexpr std::size_t kShown = 4;
  std::string text = fmt::format("{}", fmt::join(rows.first(std::min(kShown, rows.size())), " "));
  if (rows.size() > kShown) text += fmt::format(" and {} more", rows.size() - kShown);
  return text + atoms_of_contact(atoms, rows);
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

void add_certificate_option(CLI::App& command, std::string& path) {
  command
      .add_option("--certificate", path,
                  "Write the Delaunay cells to this file, about two bytes each; flowcert-proof proves from them that "
                  "the results are right and that nothing is missing")
      ->check(complaint_about_path);
}

void require_another_file(const std::string& certificate, const std::string& output) {
  if (certificate.empty() || certificate != output) return;
  throw InvalidInput("-o and --certificate would both write to " + display_name(certificate));
}

void write_certificate_file(const std::string& path, const FlowComplex& complex) {
  if (path.empty()) return;
  const ProgressLine progress("writing the certificate");
  io::write_whole_file(path, [&](std::ostream& out) { write_certificate(out, complex); });
}

}  // namespace flowcert::cli
