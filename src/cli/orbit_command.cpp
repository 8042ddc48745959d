// `flowcert orbit`: where the flow takes a position, segment by segment. The output is a table for people or one
// exact JSON object (spec/formats/orbit.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "io/json_fields.h"
#include "io/number_text.h"

namespace flowcert::cli {

namespace {

struct OrbitOptions : InputOptions {
  std::string start;
  bool json = false;
  FlowChoice flow;
};

// Longer exact numbers are shown as doubles.
constexpr std::size_t kShort = 12;

std::string short_text(const Rational& value) {
  std::string text = to_text(value);
  if (text.size() <= kShort) return text;
  if (const std::optional<double> nearest = nearest_double(value)) return fmt::format("{:.9g}", *nearest);
  return value > 0 ? "> 1.8e308" : "< -1.8e308";
}

std::string point_text(const RationalPoint& p) {
  return fmt::format("{}, {}, {}", short_text(p[0]), short_text(p[1]), short_text(p[2]));
}

std::string kind_text(StationaryIndex index) {
  if (!index.is_critical()) {
    return fmt::format("a regular stationary point of kind {}-{}", index.face_dimension, index.hull_dimension);
  }
  constexpr const char* kNames[] = {"a minimum", "a saddle", "a saddle", "a maximum"};
  return fmt::format("{} (critical point of index {})", kNames[index.face_dimension], index.face_dimension);
}

std::string limit_text(const PointSet& points, const StationaryLimit& limit) {
  return fmt::format("{}, contact set {}, squared distance {}", kind_text(limit.index), fmt::join(limit.contact, " "),
                     short_text(exact_sphere(points, limit.contact).squared_radius));
}

void print_segments(const Orbit& orbit) {
  Table table("rllll", {"", "type", "driver", "end", "contact set of the end"});
  for (const FlowSegment& segment : orbit.segments) {
    table.row(fmt::format("{}", table.height())).cell(type_text(segment.type));
    table.cell(point_text(segment.driver)).cell(segment.end ? point_text(*segment.end) : "infinity");
    table.cell(fmt::format("{}", fmt::join(segment.end_contact, " ")));
  }
  table.print();
}

// An orbit from a stationary start has no segments, so the flow is asked for the step's type, for example "V-V-V".
void print_text(const Orbit& orbit, const FlowComplex& complex) {
  print_wrapped(fmt::format("orbit from {}", point_text(orbit.start)), 2);
  if (orbit.segments.empty()) {
    print_wrapped(fmt::format("stays: {}, {}", type_text(complex.step(orbit.start).type),
                              limit_text(complex.points(), *orbit.limit)),
                  2);
    return;
  }
  print_segments(orbit);
  print_wrapped(orbit.limit ? "ends at " + limit_text(complex.points(), *orbit.limit) : "goes to infinity", 2);
}

void print_json(const Orbit& orbit, const Input& input) {
  Json json = header_fields("flowcert-orbit", 1, input.points);
  json["start"] = center_field(orbit.start);
  Json& segments = json["segments"] = Json::array();
  for (const FlowSegment& segment : orbit.segments) {
    segments.push_back(segment_with_contacts_field(segment));
  }
  json["limit"] = limit_field(input.points, orbit.limit);
  fmt::print("{}\n", json.dump());
}

void print_orbit(const OrbitOptions& options) {
  const RationalPoint start = naming("--from", [&] { return parse_rational_point(options.start); });
  const Input input = read_input(options);
  if (input.points.empty()) {
    throw InvalidInput(fmt::format("{}: there are no points", input.name));
  }
  const FlowComplex complex(input.points, complex_options(input, options.flow.options()), part_progress());
  const Orbit orbit = with_progress("following the orbit", [&] { return complex.orbit(start); });
  if (options.json) {
    print_json(orbit, input);
  } else {
    print_text(orbit, complex);
  }
}

}  // namespace

void add_orbit_command(CLI::App& app) {
  auto options = std::make_shared<OrbitOptions>();
  CLI::App* command = app.add_subcommand("orbit", "Where the flow takes a position, segment by segment");
  add_input_options(*command, *options);
  command
      ->add_option("--from", options->start,
                   "The position: decimals (the nearest doubles), hex floats or fractions p/q (exact)")
      ->type_name("X,Y,Z")
      ->required();
  command->add_flag("--json", options->json, "Print one JSON object, all exact; the table rounds long numbers");
  add_flow_options(*command, options->flow);
  add_threads_option(*command, options->threads);
  command->footer(
      "Examples:\n  flowcert orbit bunny.obj --from -1/2,0.25,0x1p-3\n"
      "  flowcert orbit bunny.obj --from 0.01,0.02,0.03 --json");
  command->callback([options] { print_orbit(*options); });
}

}  // namespace flowcert::cli
