// What flows to infinity is found from rounded volumes, because exact ones take long on large inputs. Their roundings
// add up to less than 2^-53 of the hull's volume, unless volumes are subnormal.
#include "cli/whole_complex_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/rough_number.h"
#include "cli/table.h"
#include "flowcert/connections.h"

namespace flowcert::cli {

namespace {

struct LimitTotals {
  std::size_t directions = 0, arcs = 0;
};

LimitTotals totals_of(const FlowLimits& limits) {
  LimitTotals totals;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    totals.directions += limits.direction_count(i);
    totals.arcs += limits.arc_count(i);
  }
  return totals;
}

// Why the input is not Morse-Smale.
struct Obstacles {
  std::size_t regular, with_interval, ends_elsewhere;

  [[nodiscard]] bool are_none() const { return regular + with_interval + ends_elsewhere == 0; }
};

Obstacles obstacles_of(const FlowComplex& complex) {
  const RegularCounts& regular = complex.stationary().regular_counts();
  return {.regular = regular.kind12 + regular.kind13 + regular.kind23,
          .with_interval = complex.stable().statistics().with_interval,
          .ends_elsewhere = orbits_that_end_elsewhere(complex.stationary(), complex.limits())};
}

std::string obstacle_text(const Obstacles& obstacles) {
  std::vector<std::string> reasons;
  const auto add = [&reasons](std::size_t count, const char* what) {
    if (count > 0) reasons.push_back(fmt::format("{}: {}", what, with_commas(count)));
  };
  add(obstacles.regular, "regular points");
  add(obstacles.with_interval, "S2 of dimension 3");
  add(obstacles.ends_elsewhere, "orbits of U2 to no maximum");
  return fmt::format("{}", fmt::join(reasons, ", "));
}

// Nothing if a volume is beyond the doubles.
std::optional<Rational> volume_to_infinity(const FlowComplex& complex) {
  const StableVolumes& volumes = complex.volumes();
  Rational rest = volumes.hull();
  for (std::size_t i = 0; i < complex.stationary().size(); ++i) {
    const double volume = volumes.nearest(i);
    if (!std::isfinite(volume)) return std::nullopt;
    if (volume != 0) rest -= Rational(volume);
  }
  return rest < 0 ? Rational(0) : rest;
}

Json nearest_field(const Rational& number) {
  const std::optional<double> nearest = nearest_double(number);
  return nearest ? Json(*nearest) : Json(nullptr);
}

}  // namespace

void print_whole_complex_rows(const FlowComplex& complex) {
  const FlowLimits& limits = complex.limits();
  const LimitTotals totals = totals_of(limits);
  print_row("lists of limits", with_commas(limits.size()), "where all directions lead");
  print_row("single directions in them", with_commas(totals.directions));
  print_row("arcs of directions in them", with_commas(totals.arcs));
  print_row("connections", with_commas(connections(limits).size()), "to points and to infinity");
  const Obstacles obstacles = obstacles_of(complex);
  print_row("Morse-Smale", obstacles.are_none() ? "yes" : "no", obstacle_text(obstacles));
  const std::optional<Rational> rest = volume_to_infinity(complex);
  print_row("volume of the convex hull", rough_text(complex.volumes().hull()));
  print_row("volume that flows to infinity", rest ? rough_text(*rest) : "?", "hull - rounded volumes");
}

Json whole_complex_field(const FlowComplex& complex) {
  const FlowLimits& limits = complex.limits();
  const LimitTotals totals = totals_of(limits);
  const Obstacles obstacles = obstacles_of(complex);
  const Rational& hull = complex.volumes().hull();
  const std::optional<Rational> rest = volume_to_infinity(complex);
  return {{"lists", limits.size()},
          {"directions", totals.directions},
          {"arcs", totals.arcs},
          {"connections", connections(limits).size()},
          {"morse_smale", obstacles.are_none()},
          {"with_interval", obstacles.with_interval},
          {"ends_elsewhere", obstacles.ends_elsewhere},
          {"hull_volume", to_text(hull)},
          {"hull_volume_double", nearest_field(hull)},
          {"volume_to_infinity_double", rest ? nearest_field(*rest) : Json(nullptr)},
          {"volumes_decided_exactly", complex.volumes().decided_exactly()}};
}

}  // namespace flowcert::cli
