// `flowcert points`: the points of a file, as every command reads them, in a form that needs no reader. A checker of
// certificates takes them so, where the file is not plain text (spec/formats/certificates.md).
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "cli/command.h"
#include "cli/layer.h"
#include "cli/table.h"
#include "flowcert/reproducibility.h"
#include "io/byte_spool.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

struct PointsOptions : InputOptions {
  std::string output;
};

// 24 bytes a row: x, y and z as little-endian doubles.
void write_rows(std::ostream& out, const PointSet& points) {
  io::ByteWriter bytes(out);
  for (PointId row = 0; row < points.row_count(); ++row) {
    for (const double coordinate : points.at_row(row).coordinates()) bytes.append(coordinate);
  }
}

void run_points(const PointsOptions& options) {
  const Input input = read_input(options);
  if (options.output == kStandardStream) return write_rows(std::cout, input.points);
  io::write_whole_file(options.output, [&](std::ostream& out) { write_rows(out, input.points); });
  print_input(input);
  print_point_counts(input.points);
  print_wrapped("SHA-256 " + coordinates_sha256(input.points));
}

}  // namespace

void add_points_command(CLI::App& app) {
  auto options = std::make_shared<PointsOptions>();
  CLI::App* command = app.add_subcommand("points", "The points of a file as raw doubles, for flowcert-proof");
  add_input_options(*command, *options);
  command
      ->add_option("-o,--output", options->output,
                   "Write the points to this file, 24 bytes each: x, y and z as little-endian IEEE doubles, in the "
                   "order of the rows, with repeated ones; -: to standard output")
      ->required()
      ->check(complaint_about_path);
  command->footer(
      "Examples:\n  flowcert points bunny.obj -o bunny.f64\n"
      "  flowcert points bunny.obj -o - >bunny.f64");
  command->callback([options] { run_points(*options); });
}

}  // namespace flowcert::cli
