// Level 2. For a claim where nothing is stationary, finds the first condition of FC-CRIT-05 that fails. For a claim
// at a stationary point, judges the claimed centre and distance.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "geometry/enclosing_ball.h"
#include "geometry/nearest_samples.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

struct Fault {
  FindingReason reason;
  std::string clause;
  std::string words;
};

Fault not_cospherical(const PointSet& points, const std::vector<PointId>& names, const ExactSphere& sphere) {
  bool by_rounding = true;
  PointId witness = names.back();
  for (const PointId name : names) {
    const Rational distance = squared_distance(sphere.center, sample(points, name));
    if (distance == sphere.squared_radius) continue;
    witness = name;
    by_rounding = by_rounding && is_rounding(distance, sphere.squared_radius, squared_rounding(sphere));
  }
  return {rounding_or(FindingReason::kNotCospherical, by_rounding), "FC-CRIT-05 (a)",
          "point " + std::to_string(witness) + " is not on the sphere of the others, centred in their affine hull"};
}

Fault not_empty(const ExactSphere& sphere, const NearestSamples& nearest) {
  return {rounding_or(FindingReason::kBallNotEmpty,
                      is_rounding(nearest.squared_distance, sphere.squared_radius, squared_rounding(sphere))),
          "FC-CRIT-05 (b)",
          "point " + names_text(nearest.names) + " lies inside the ball: squared distance " +
              number_text(nearest.squared_distance) + " from its centre, squared radius " +
              number_text(sphere.squared_radius)};
}

Fault outside_hull(const PointSet& points, const std::vector<PointId>& names, const ExactSphere& sphere) {
  std::vector<Point> coordinates;
  coordinates.reserve(names.size());
  for (const PointId name : names) coordinates.push_back(sample(points, name));
  const RationalPoint driver = enclosing_ball_center(coordinates);
  const bool by_rounding = is_rounding(squared_distance(driver, sphere.center), 0, squared_rounding(sphere));
  return {rounding_or(FindingReason::kOutsideHull, by_rounding), "FC-CRIT-05 (d)",
          "the centre " + position_text(sphere.center) + " lies outside the hull of the contact set"};
}

// The fault of a set that is not the contact set of a stationary point.
Fault fault_of(const PointSet& points, const std::vector<PointId>& names) {
  const ExactSphere sphere = exact_sphere(points, names);
  if (!all_on_sphere(points, names, sphere)) return not_cospherical(points, names, sphere);
  const NearestSamples nearest = nearest_samples(points, sphere.center);
  if (nearest.squared_distance < sphere.squared_radius) return not_empty(sphere, nearest);
  if (nearest.names.size() == names.size()) return outside_hull(points, names, sphere);
  std::vector<PointId> further;
  std::ranges::set_difference(nearest.names, names, std::back_inserter(further));
  return {FindingReason::kContactIncomplete, "FC-CRIT-05 (c)",
          "point " + names_text(further) + " lies on the sphere too, and the centre outside the hull of all of them"};
}

// Decides the usual case quickly. Only decimals need more.
bool is_exactly_right(const ClaimedPoint& point, const ExactSphere& sphere) {
  if (point.distance || (point.center && !is_exact(*point.center))) return false;
  for (std::size_t axis = 0; point.center && axis < 3; ++axis) {
    if ((*point.center)[axis].value != sphere.center[axis]) return false;
  }
  return !point.squared_distance ||
         (point.squared_distance->is_exact && point.squared_distance->value == sphere.squared_radius);
}

bool is_exact_throughout(const ClaimedPoint& point) {
  return (!point.center || is_exact(*point.center)) && (!point.distance || point.distance->is_exact) &&
         (!point.squared_distance || point.squared_distance->is_exact);
}

struct WrongValue {
  ValueMatch match;
  std::string claimed;
  std::string truth;
};

// The wrong values of a claimed point if it means this stationary point.
std::vector<WrongValue> wrong_values(CheckRun& run, const ClaimedPoint& point, std::size_t record) {
  const ExactSphere sphere = run.truth.sphere(record);
  if (is_exactly_right(point, sphere)) return {};
  const ValueScale scale(sphere, run.options.tolerance);
  std::vector<WrongValue> wrong;
  const auto squared = [&sphere] { return "the squared distance is " + number_text(sphere.squared_radius); };
  if (point.center) {
    const ValueMatch match = match_position(*point.center, sphere.center, scale);
    if (is_wrong(match)) {
      wrong.push_back(
          {match, "centre " + position_text(*point.center),
           "the centre is " + position_text(sphere.center) + ", " + offset_text(*point.center, sphere.center, scale)});
    }
  }
  if (point.squared_distance) {
    const ValueMatch match = match_squared_distance(*point.squared_distance, sphere.squared_radius, scale);
    if (is_wrong(match)) {
      wrong.push_back({match, "squared distance " + number_text(*point.squared_distance), squared()});
    }
  }
  if (point.distance) {
    const ValueMatch match = match_distance(*point.distance, sphere.squared_radius, scale);
    if (is_wrong(match)) {
      wrong.push_back({match, "distance " + number_text(*point.distance), squared()});
    }
  }
  return wrong;
}

// The doubles that are claimed beside exact values are these values in decimals (FC-NUM-02, FC-CLAIM-05). There is none
// exactly where no double is near.
std::vector<WrongValue> wrong_doubles(CheckRun& run, const ClaimedPoint& point, std::size_t record) {
  if (!point.rounded_center && !point.has_rounded_squared_distance) return {};
  std::vector<WrongValue> wrong;
  const ExactSphere sphere = run.truth.sphere(record);
  const ValueScale scale(sphere, run.options.tolerance);
  for (std::size_t axis = 0; point.rounded_center && axis < 3; ++axis) {
    const std::optional<ClaimedNumber>& claimed = (*point.rounded_center)[axis];
    const Rational& truth = sphere.center[axis];
    const ValueMatch match = match_double(claimed, truth, scale);
    if (!is_wrong(match)) continue;
    wrong.push_back({match, "center_double with " + double_text(claimed), "the coordinate is " + number_text(truth)});
  }
  if (point.has_rounded_squared_distance) {
    const Boxed<ClaimedNumber>& claimed = point.rounded_squared_distance;
    ValueMatch match = ValueMatch::kOff;
    if (claimed.has_value() == nearest_double(sphere.squared_radius).has_value()) {
      match = claimed ? match_squared_distance(*claimed, sphere.squared_radius, scale) : ValueMatch::kEqual;
    }
    if (is_wrong(match)) {
      wrong.push_back({match, "squared_distance_double " + double_text(claimed),
                       "the squared distance is " + number_text(sphere.squared_radius)});
    }
  }
  return wrong;
}

// The stationary point of the claimed index or kind that is nearest to a claimed position. Which one is the nearest is
// found in doubles, because it only helps to read the finding.
std::optional<std::size_t> nearest_of_index(CheckRun& run, const ClaimedPoint& point) {
  const std::array<double, 3> at = as_doubles(values_of(*point.center));
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t record = 0; record < run.truth.size(); ++record) {
    const StationaryIndex index = run.index(record);
    const int hull_dimension = point.hull_dimension.value_or(index.hull_dimension);
    const bool is_meant = index.face_dimension == point.index && index.hull_dimension == hull_dimension &&
                          index.is_critical() != point.hull_dimension.has_value();
    if (!is_meant) continue;
    const std::array<double, 3>& center = run.center_in_doubles(record);
    const double off = std::hypot(at[0] - center[0], at[1] - center[1], at[2] - center[2]);
    if (nearest && !(off < least)) continue;
    nearest = record;
    least = off;
  }
  return nearest;
}

std::string nearest_text(CheckRun& run, const ClaimedPoint& point) {
  const std::optional<std::size_t> nearest = nearest_of_index(run, point);
  if (!nearest) return "there is none of that " + std::string(point.hull_dimension ? "kind" : "index");
  const ExactSphere sphere = run.truth.sphere(*nearest);
  return "the nearest one of that " + std::string(point.hull_dimension ? "kind" : "index") + " has the contact set " +
         names_text(run.truth.contact(*nearest)) + " and is at " + position_text(sphere.center) + ", " +
         offset_text(*point.center, sphere.center, ValueScale(sphere, run.options.tolerance));
}

}  // namespace

void check_stray_claim(CheckRun& run, std::size_t k) {
  const std::vector<PointId>& names = run.placed[k].names;
  if (names.empty()) {
    run.find(2, FindingReason::kWrongPosition, "FC-CRIT-01", k,
             "no stationary point is there, or within the tolerance of it; " + nearest_text(run, run.claim.points[k]));
    return;
  }
  const Fault fault = fault_of(run.points, names);
  run.find(2, fault.reason, fault.clause, k, fault.words);
}

bool has_right_values(CheckRun& run, std::size_t k, std::size_t record) {
  const ClaimedPoint& point = run.claim.points[k];
  return wrong_values(run, point, record).empty() && wrong_doubles(run, point, record).empty();
}

void check_values(CheckRun& run, std::size_t k) {
  const ClaimedPoint& point = run.claim.points[k];
  const std::size_t record = run.placed[k].place->record;
  const auto find = [&](const std::vector<WrongValue>& wrong, const char* clause) {
    for (const auto& [match, claimed, truth] : wrong) {
      run.find(2, rounding_or(FindingReason::kWrongPosition, match), clause, k, truth, claimed);
    }
  };
  find(wrong_doubles(run, point, record), "FC-NUM-02");
  if (!point.center && !point.distance && !point.squared_distance) return;
  run.note_exactness(is_exact_throughout(point));
  find(wrong_values(run, point, record), "FC-OUT-01");
}

}  // namespace flowcert::certify
