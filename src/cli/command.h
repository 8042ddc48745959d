// The subcommands of `flowcert`, and what they share. Exit status: 0 right, 1 a negative verdict, 2 unusable input or
// usage. The subcommands that draw inputs are in fuzz/commands/.
#pragma once

#include <array>
#include <span>
#include <string>

#include "cli/layer.h"
#include "flowcert/flow_complex.h"
#include "flowcert/orbit.h"
#include "flowcert/read_points.h"
#include "io/foreign_text.h"
#include "io/naming.h"
#include "io/number_text.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace flowcert::cli {

class ProgressLine;

inline constexpr int kRight = 0;
inline constexpr int kNegativeVerdict = 1;
inline constexpr int kUnusable = 2;

// What commands are for that a program may be built without. Such a program says the same of them.
inline constexpr char kCheckPurpose[] = "Whether a claimed flow complex is right, and where it is not";
inline constexpr char kConformancePurpose[] = "How any program answers the conformance vectors, by flag";
inline constexpr char kFuzzPurpose[] = "Search for degenerate inputs on which implementations disagree";
inline constexpr char kGeneratePurpose[] = "Cases for any program to answer, for flowcert verify";
inline constexpr char kVerifyPurpose[] = "Whether a program's answers to the cases of generate are right";
inline constexpr char kViewPurpose[] = "The complex in a browser, with what is wrong with a claim";

// Each function adds its subcommand, options and callback, which throws InvalidInput or OutputError. Where the exit
// status can be another than kRight, the callback sets it.
void add_compute_command(CLI::App& app);
void add_cycles_command(CLI::App& app);
void add_explain_command(CLI::App& app, int& status);
void add_help_command(CLI::App& app);
void add_locate_command(CLI::App& app);
void add_medial_command(CLI::App& app);
void add_orbit_command(CLI::App& app);
void add_persistence_command(CLI::App& app);
void add_pockets_command(CLI::App& app);
void add_points_command(CLI::App& app);
void add_pores_command(CLI::App& app);
// Several: completion, manual and share-files. They say what the program offers at the time when they are called.
void add_shell_commands(CLI::App& app);
void add_stats_command(CLI::App& app);
void add_surface_command(CLI::App& app);
// In a program that was built without FLOWCERT_JUDGE, a name only.
void add_view_command(CLI::App& app, int& status);

// What is shown while a file of `what` is read.
[[nodiscard]] ProgressLine reading_line(const std::string& path, const std::string& what);
// Says on standard error what a user should know of a file: the reader's notes, and rows that are left out.
void tell_of_reading(const std::string& path, const PointFile& file);
// Reads the file, and says that.
[[nodiscard]] PointFile read_points_aloud(const std::string& path, const ReadingOptions& reading = {});

// What most commands are asked for: a file of points, how to read it, and how many threads compute.
struct InputOptions {
  std::string input;
  ReadingOptions reading;
  unsigned threads = 1;
};

// A file of points, and its points with merged duplicates.
struct Input {
  std::string name;  // for messages
  PointFile file;
  PointSet points;
  std::size_t most_cells = 0;  // that the triangulation may have (FlowOptions)
  unsigned threads = 1;
};
[[nodiscard]] Input read_input(const InputOptions& options);
// For a flow complex of it, which is made in this way.
[[nodiscard]] FlowOptions complex_options(const Input& input, FlowOptions flow = {});

// Says on standard error, before anything is written, that it will be much.
void tell_of_many_cells(std::size_t cells, std::size_t points);
inline void tell_of_many_cells(const FlowComplex& complex) {
  tell_of_many_cells(complex.delaunay_cells(), complex.points().size());
}

// The first line of a report, "bunny.obj (OBJ)".
void print_input(const Input& input);

// The first rows of a table: points, merged duplicates and, where there are any, rows that are left out.
void print_point_counts(const PointSet& points);

// The name of an atom or residue in a text that is wrapped: it stays on one line.
[[nodiscard]] std::string unbroken(std::string name);

// " (A GLY 12 CA, ...)": the first of these rows as the molecule's file names them, or nothing where it is none.
[[nodiscard]] std::string atoms_of_contact(const AtomNames& atoms, std::span<const PointId> rows);
// "3 17 20 46 and 2 more (A GLY 12 CA, ...)": a contact set in a table.
[[nodiscard]] std::string contact_text(const AtomNames& atoms, std::span<const PointId> rows);

// The argument INPUT and the options that say how it is read.
void add_input_options(CLI::App& command, InputOptions& options,
                       const std::string& description = "Point file, or - for standard input",
                       const char* name = "INPUT");

// The options --kernel and --search, which say how orbits are computed, not what they are.
struct FlowChoice {
  std::string kernel = "cascade";  // or "lazy", "exact"
  std::string search = "binary";   // or "linear"

  [[nodiscard]] FlowOptions options() const;
};
// The two options are returned so that they can be made to need others.
std::array<CLI::Option*, 2> add_flow_options(CLI::App& command, FlowChoice& choice);

// The option --threads, of commands that compute: all cores without it. Results do not depend on it.
void add_threads_option(CLI::App& command, unsigned& threads);

// The option --certificate, of commands whose results follow from the triangulation alone.
void add_certificate_option(CLI::App& command, std::string& path);
// Throws InvalidInput where that file and that of -o are one. It is called before anything is computed.
void require_another_file(const std::string& certificate, const std::string& output);
// Writes that file, if there is a path.
void write_certificate_file(const std::string& path, const FlowComplex& complex);

// The path that stands for standard input or standard output.
inline constexpr char kStandardStream[] = "-";
// What is wrong with the path of a file to write, or nothing.
[[nodiscard]] std::string complaint_about_path(const std::string& path);

// For all errors: a path may hold any byte.
using io::on_one_line;

// The name of the file for messages, on one line: "-" gets a readable name.
[[nodiscard]] std::string display_name(const std::string& path);

}  // namespace flowcert::cli
