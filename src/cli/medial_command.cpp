// `flowcert medial`: the medial axis as unstable sets U1 and U2 of chosen critical points, for viewers
// (src/cli/manual/medial.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/automatic_threshold.h"
#include "cli/command.h"
#include "cli/export_files.h"
#include "cli/layer.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/flow_complex.h"
#include "io/json_fields.h"
#include "io/medial_points.h"
#include "io/number_text.h"
#include "io/unstable_surface_export.h"
#include "io/vtk_exports.h"

namespace flowcert::cli {

namespace {

struct MedialOptions : InputOptions {
  std::optional<std::string> persistence, radius, angle;
  std::string directory;
  std::string clip = "3";
  bool json = false;
};

MedialChoice choice_of(const MedialOptions& options) {
  MedialChoice choice;
  if (options.persistence) choice.persistence_above = io::length_bound_of(*options.persistence, "--persistence", 1);
  if (options.radius) choice.radius_above = io::length_bound_of(*options.radius, "--radius", 1);
  if (options.angle) {
    choice.angle_above = io::claimed_number(*options.angle, io::PlainInteger::kExact, {"--angle", 1}).value;
    if (*choice.angle_above < 0 || *choice.angle_above > 180) {
      throw InvalidInput("--angle: not from 0 to 180 degrees: " + *options.angle);
    }
  }
  return choice;
}

void write_files(const MedialOptions& options, const FlowComplex& complex, const std::vector<std::size_t>& records,
                 const std::optional<Rational>& clip) {
  make_directory(options.directory);
  const std::optional<ClipBox> box = clip_box(complex.points(), clip);
  const auto write = [&](const char* name, const WriteExport& how) {
    write_export(options.directory, name, complex, how);
  };
  {
    ProgressLine progress("exporting unstable manifolds of index-1 points");
    const UnstableSurfaceExport sheets(complex, box, options.directory, std::ref(progress), &records);
    write("medial_sheets.vtp", [&](std::ostream& out, const std::string& made_by) { sheets.write_vtp(out, made_by); });
    write("medial_sheets.ply", [&](std::ostream& out, const std::string& made_by) { sheets.write_ply(out, made_by); });
  }
  ProgressLine progress("exporting unstable manifolds of index-2 points");
  const PolyData lines = unstable_line_data(complex, box, std::ref(progress), &records);
  write("medial_lines.vtp", [&](std::ostream& out, const std::string& made_by) { write_vtp(out, lines, made_by); });
}

std::array<std::size_t, 2> counts_of(const FlowComplex& complex, const std::vector<std::size_t>& records) {
  std::array<std::size_t, 2> counts{};
  for (const std::size_t record : records) ++counts[complex.stationary().index(record).hull_dimension - 1];
  return counts;
}

void print_result(const MedialOptions& options, const Input& input, const FlowComplex& complex,
                  const MedialPoints& medial) {
  const std::vector<std::size_t>& records = medial.records;
  const auto chosen = counts_of(complex, records);
  const auto& all = complex.stationary().critical_counts();
  if (options.json) {
    io::Json json = io::header_fields("flowcert-medial", 1, complex.points());
    io::add_counts(json, complex.points(), complex.stationary());
    json["persistence"] = options.persistence ? io::Json(*options.persistence) : io::Json(nullptr);
    json["radius"] = options.radius ? io::Json(*options.radius) : io::Json(nullptr);
    if (medial.automatic_persistence) json["auto_persistence"] = automatic_field(*medial.automatic_persistence);
    if (medial.automatic_radius) json["auto_radius"] = automatic_field(*medial.automatic_radius);
    json["angle"] = options.angle ? io::Json(*options.angle) : io::Json(nullptr);
    json["chosen"] = io::Json::array();
    for (const std::size_t record : records) {
      json["chosen"].push_back({{"index", complex.stationary().index(record).hull_dimension},
                                {"contact", complex.stationary().contact(record)}});
    }
    fmt::print("{}\n", json.dump());
    return;
  }
  print_input(input);
  print_point_counts(input.points);
  if (medial.automatic_persistence) print_automatic("persistence", *medial.automatic_persistence, "all are taken");
  if (medial.automatic_radius) print_automatic("radii", *medial.automatic_radius, "all are taken");
  for (const std::size_t k : {0U, 1U}) {
    print_row(fmt::format("chosen of index {}", k + 1), with_commas(chosen[k]), "of " + with_commas(all[k + 1]));
  }
}

void run_medial(const MedialOptions& options) {
  const MedialChoice choice = choice_of(options);
  const std::optional<Rational> clip = clip_factor(options.clip);
  const Input input = read_input(options);
  const FlowComplex complex(input.points, complex_options(input), part_progress());
  const MedialPoints medial = medial_points(complex, choice);
  if (!options.directory.empty()) {
    naming(input.name, [&] { write_files(options, complex, medial.records, clip); });
  }
  print_result(options, input, complex, medial);
}

}  // namespace

void add_medial_command(CLI::App& app) {
  auto options = std::make_shared<MedialOptions>();
  CLI::App* command = app.add_subcommand("medial", "The medial axis: what flows from chosen saddles, for viewers");
  add_input_options(*command, *options);
  command
      ->add_option("--persistence", options->persistence,
                   "Only saddles whose pairs are longer, a difference of distances: a number, Xspacing, qX "
                   "(a quantile) or auto")
      ->type_name("X");
  command
      ->add_option("--radius", options->radius,
                   "Only saddles that are farther from their nearest points: a number, Xspacing, qX (a quantile) or "
                   "auto")
      ->type_name("R");
  command
      ->add_option("--angle", options->angle,
                   "Only saddles that see two of their nearest points under a greater angle, in degrees; it is 180 at "
                   "index 1, and 120 or more at index 2")
      ->type_name("T");
  CLI::Option* directory =
      command
          ->add_option("--export", options->directory,
                       "Write medial_sheets.vtp and .ply (of index 1) and medial_lines.vtp (of index 2) to this folder")
          ->type_name("DIR");
  command
      ->add_option("--clip", options->clip,
                   "Cut what goes to infinity at a box this many times as large as the input, or none, to leave out "
                   "what has no end")
      ->capture_default_str()
      ->needs(directory);
  command->add_flag("--json", options->json, "Print one JSON object, with the contact sets of the chosen saddles");
  add_threads_option(*command, options->threads);
  command->footer(
      "Source: J. Giesen, E. A. Ramos, B. Sadri, Medial axis approximation and unstable flow complex, 2006.\n\n"
      "Examples:\n  flowcert medial bunny.obj --persistence q0.99 --export axis\n"
      "  flowcert medial bunny.obj --angle 175 --persistence auto");
  command->callback([options] { run_medial(*options); });
}

}  // namespace flowcert::cli
