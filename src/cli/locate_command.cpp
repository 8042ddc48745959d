// `flowcert locate`: where the flow takes each of many positions, and the samples nearest to each. The output is one
// line a position, as text or as JSON (src/cli/manual/locate.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/flow_complex.h"
#include "flowcert/reproducibility.h"
#include "io/json_fields.h"
#include "io/ordered_text.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

struct LocateOptions : InputOptions {
  std::string positions;
  std::string output;
  bool json = false;
};

Json json_of(const FlowComplex& complex, const FlowPlace& place) {
  if (!place.limit) {
    return {{"kind", "infinity"}, {"index", nullptr}, {"contact", nullptr}, {"nearest", place.nearest}};
  }
  const StationaryIndex index = complex.stationary().index(*place.limit);
  return {{"kind", index.is_critical() ? "critical" : "regular"},
          {"index", index_field(index)},
          {"contact", complex.stationary().contact(*place.limit)},
          {"nearest", place.nearest}};
}

void append_line(const FlowComplex& complex, const FlowPlace& place, std::string& text) {
  auto out = std::back_inserter(text);
  if (place.limit) {
    const StationaryIndex index = complex.stationary().index(*place.limit);
    fmt::format_to(out, "{}", index.face_dimension);
    if (!index.is_critical()) fmt::format_to(out, "-{}", index.hull_dimension);
    fmt::format_to(out, " {} ", fmt::join(complex.stationary().contact(*place.limit), ","));
  } else {
    fmt::format_to(out, "infinity - ");
  }
  fmt::format_to(out, "{}\n", fmt::join(place.nearest, ","));
}

// A head, and a line for each position, in order.
void write_places(const FlowComplex& complex, const std::vector<Point>& positions, bool json, ProgressLine& progress,
                  std::ostream& out) {
  out << (json ? header_fields("flowcert-locate", 1, complex.points()).dump()
               : fmt::format("# {}\n# limit's index or kind, its contact set, nearest samples",
                             made_by_text("flowcert-locate", 1, complex.points())))
      << '\n';
  if (!out.good()) return;
  const auto make = [&](std::size_t first, std::size_t last, std::string& text) {
    for (std::size_t k = first; k < last; ++k) {
      const FlowPlace place = complex.locate(positions[k]);
      if (json) {
        text += json_of(complex, place).dump() + '\n';
      } else {
        append_line(complex, place, text);
      }
    }
  };
  const auto take = [&](const std::string& text, std::size_t done) {
    progress(done, positions.size());
    out << text;
    return out.good();
  };
  io::write_in_order(positions.size(), io::kShortRecords, complex.threads(), make, take);
}

void print_summary(std::size_t positions, const Input& input, double seconds) {
  print_input(input);
  print_point_counts(input.points);
  print_row("positions", with_commas(positions));
  print_row("time for them", seconds_text(seconds), "after all limits were made");
}

void locate_all(const LocateOptions& options) {
  if (options.input == kStandardStream && options.positions == kStandardStream) {
    throw InvalidInput("INPUT and --positions cannot both be standard input");
  }
  const Input input = read_input(options);
  if (input.points.empty()) throw InvalidInput(input.name + ": there are no points");
  const std::vector<Point> positions = read_points_aloud(options.positions).rows;
  const FlowComplex complex(input.points, complex_options(input), part_progress());
  const bool is_streamed = options.output.empty() || options.output == kStandardStream;
  std::optional<OutputFile> file;
  if (!is_streamed) file.emplace(options.output);
  complex.make(FlowComplexPart::kLimits);
  const auto start = std::chrono::steady_clock::now();
  {
    ProgressLine progress("locating positions", is_streamed ? STDOUT_FILENO : -1);
    write_places(complex, positions, options.json, progress, is_streamed ? std::cout : file->stream());
  }
  if (is_streamed) return;
  file->commit();
  print_summary(positions.size(), input,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace

void add_locate_command(CLI::App& app) {
  auto options = std::make_shared<LocateOptions>();
  CLI::App* command = app.add_subcommand("locate", "Where the flow takes many positions; their nearest samples");
  add_input_options(*command, *options);
  command->add_option("--positions", options->positions, "The positions: a point file, or - for standard input")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Write the lines to this file, and print a summary; -: to standard output")
      ->check(complaint_about_path);
  command->add_flag("--json", options->json, "JSON Lines: a header, and an object for each position");
  add_threads_option(*command, options->threads);
  command->footer(
      "Examples:\n  flowcert locate bunny.obj --positions probes.xyz\n"
      "  flowcert locate bunny.obj --positions probes.xyz --json -o places.jsonl");
  command->callback([options] { locate_all(*options); });
}

}  // namespace flowcert::cli
