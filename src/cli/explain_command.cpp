// `flowcert explain`: why a set of points, or a position, is or is not critical. Exit status: 0 if it is stationary,
// 1 if it is not.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "cli/progress.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "geometry/difference_of_roots.h"
#include "io/json_fields.h"
#include "io/number_text.h"
#include "morse/explain.h"

namespace flowcert::cli {

namespace {

struct ExplainOptions : InputOptions {
  std::vector<PointId> ids;
  std::string position;
  bool json = false;
};

std::string exact_and_double(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  std::string text = with_short_numbers(to_text(value));
  // An integer is clear by itself. A fraction is easier to read with its double beside it.
  if (text.find('/') == std::string::npos || !nearest) return text;
  return fmt::format("{} ({})", text, *nearest);
}

std::string explained_point(const RationalPoint& p) {
  return fmt::format("{}, {}, {}", exact_and_double(p[0]), exact_and_double(p[1]), exact_and_double(p[2]));
}

std::string verdict_text(const Explanation& explanation) {
  if (!explanation.index) return "no stationary point";
  const StationaryIndex index = *explanation.index;
  if (index.is_critical()) return fmt::format("critical point of index {}", index.face_dimension);
  return fmt::format("regular stationary point of kind {}-{}", index.face_dimension, index.hull_dimension);
}

// "  centre       1/2 (0.5), 0, 0"
void print_fact(const char* name, const std::string& text) { print_wrapped(fmt::format("  {:<13}{}", name, text), 15); }

void print_text(const Explanation& explanation, const AtomNames& atoms, const std::string& asked) {
  print_wrapped(fmt::format("{}: {}", asked, verdict_text(explanation)), 2);
  std::string clause = explanation.clause;
  std::ranges::replace(clause, ' ', kFixedBlank);
  print_fact("because", fmt::format("{} [{}]", with_short_numbers(explanation.reason), clause));
  if (!explanation.witnesses.empty()) {
    const char* name = explanation.witnesses.size() == 1 ? "by point" : "by points";
    print_fact(name, fmt::format("{}{}", fmt::join(explanation.witnesses, ", "),
                                 atoms_of_contact(atoms, explanation.witnesses)));
  }
  if (!explanation.sphere) return;
  print_fact("centre", explained_point(explanation.sphere->center));
  print_fact("radius", fmt::format("{}", geometry::nearest_difference_of_roots(explanation.sphere->squared_radius, 0)));
  print_fact("radius^2", exact_and_double(explanation.sphere->squared_radius));
  if (explanation.squared_distance != explanation.sphere->squared_radius) {
    print_fact("nearest^2", exact_and_double(explanation.squared_distance));
  }
  print_fact("contact set",
             fmt::format("{}{}", fmt::join(explanation.contact, ", "), atoms_of_contact(atoms, explanation.contact)));
  if (explanation.driver) print_fact("driver", explained_point(*explanation.driver));
}

// Of points that are only some of those on their sphere: what its centre is.
void print_centre(const PointSet& points, const Explanation& explanation) {
  if (explanation.index || !explanation.sphere) return;
  const Explanation of_centre = explain_position(points, explanation.sphere->center);
  if (!of_centre.index) return;
  print_fact("its centre",
             fmt::format("a {}, contact set {}", verdict_text(of_centre), fmt::join(of_centre.contact, ", ")));
}

void print_json(const Explanation& explanation, const Input& input) {
  const AtomNames& atoms = input.file.atoms;
  Json json = header_fields("flowcert-explain", 1, input.points);
  json["stationary"] = explanation.index.has_value();
  json["index"] = explanation.index ? index_field(*explanation.index) : Json(nullptr);
  json["kind"] = !explanation.index                 ? Json(nullptr)
                 : explanation.index->is_critical() ? Json("critical")
                                                    : Json("regular");
  json["clause"] = explanation.clause;
  json["reason"] = explanation.reason;
  json["witnesses"] = explanation.witnesses;
  json["center"] = explanation.sphere ? center_field(explanation.sphere->center) : Json(nullptr);
  json["squared_radius"] = explanation.sphere ? Json(to_text(explanation.sphere->squared_radius)) : Json(nullptr);
  json["contact"] = explanation.contact;
  if (!atoms.empty()) {
    json["names"] = Json::array();
    for (const PointId row : explanation.contact) json["names"].push_back(atoms.text(row));
  }
  json["squared_distance"] = explanation.sphere ? Json(to_text(explanation.squared_distance)) : Json(nullptr);
  json["driver"] = explanation.driver ? center_field(*explanation.driver) : Json(nullptr);
  fmt::print("{}\n", json.dump());
}

// Returns what is wrong, as CLI11's validators do. CLI11 itself reads empty text as 0, and 010 as octal 8.
std::string complaint_about_id(const std::string& word) {
  const bool is_digits = !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
  if (is_digits && (word == "0" || word[0] != '0')) return "";
  return fmt::format("'{}' is no id", word);
}

int explain(const ExplainOptions& options) {
  const bool by_position = !options.position.empty();
  const RationalPoint position = by_position ? parse_rational_point(options.position) : RationalPoint{};
  const Input input = read_input(options);
  const Explanation explanation = with_progress("explaining", [&] {
    return by_position ? explain_position(input.points, position) : explain_points(input.points, options.ids);
  });
  if (options.json) {
    print_json(explanation, input);
  } else {
    print_text(explanation, input.file.atoms,
               by_position ? fmt::format("position {}", explained_point(position))
                           : fmt::format("points {}", fmt::join(options.ids, ", ")));
  }
  if (!options.json && !by_position) print_centre(input.points, explanation);
  return explanation.index ? kRight : kNegativeVerdict;
}

}  // namespace

void add_explain_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand("explain", "Why points, or a position, are or are not stationary");
  add_input_options(*command, *options);
  auto* what = command->add_option_group("what", "One of");
  what->add_option("--ids", options->ids, "The points, by 0-based row: 3,17,20")
      ->delimiter(',')
      ->allow_extra_args(false)  // else `--ids 3,17 INPUT` takes INPUT for a further id
      ->check(complaint_about_id)
      ->type_name("ID,ID,...");
  what->add_option("--at", options->position,
                   "The position: decimals (the nearest doubles), hex floats or fractions p/q (exact)")
      ->type_name("X,Y,Z");
  what->require_option(1);
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "Examples:\n  flowcert explain bunny.obj --ids 3,17,20\n  flowcert explain bunny.obj --at 1/2,0.25,-1");
  command->callback([options, &status] { status = explain(*options); });
}

}  // namespace flowcert::cli
