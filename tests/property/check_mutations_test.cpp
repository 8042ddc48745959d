// Right claims, and right claims with one thing made wrong, on every family of inputs.
//
// Guarantees: a claim made of the answer itself conforms exactly. A claim with what FC-CLAIM permits (parts
// of contact sets, perturbed regular points, decimals, positions alone) never fails. Each mutant fails, with
// a finding on the level and the line, or about the missing point, where it was made wrong. The test fails
// too when some kind of mutant was hardly ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/inputs/input.h"
#include "oracle/exact_geometry.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::check_mutations_test {
namespace {

constexpr int kInputsPerFamily = 12;

// The value as a decimal with all digits of the nearest double.
ClaimedNumber in_decimals(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? ClaimedNumber{Rational(*nearest), false} : number(value);
}

struct Subject : ClaimSubject {
  using ClaimSubject::ClaimSubject;

  [[nodiscard]] std::vector<oracle::Point> coordinates(const std::vector<PointId>& names) const {
    std::vector<oracle::Point> result;
    for (const PointId name : names) {
      const Point& p = points[points.ordinal_of_row(name)];
      result.push_back(oracle::exact({p.x, p.y, p.z}));
    }
    return result;
  }
};

ClaimedTarget target_of(const Subject& subject, const std::optional<std::size_t>& limit) {
  if (!limit) return {true, {}};
  return {false, subject.contact(*limit)};
}

// All that can be claimed, as `compute -o --manifolds u2 --polylines` does. Point k is record k.
Claim full_claim(const Subject& subject) {
  Claim claim;
  claim.format = "exchange";
  claim.point_count = subject.points.row_count();
  claim.merged_duplicates = subject.points.merged_duplicates();
  claim.classes = subject.points.repeated_classes();
  for (std::size_t i = 0; i < subject.truth->size(); ++i) {
    const StationaryIndex index = subject.truth->index(i);
    const ExactSphere sphere = subject.truth->sphere(i);
    ClaimedPoint point;
    point.line = kFirstLine + i;
    point.index = index.face_dimension;
    if (!index.is_critical()) point.hull_dimension = index.hull_dimension;
    point.contact = subject.contact(i);
    point.center = exactly(sphere.center);
    point.squared_distance = number(sphere.squared_radius);
    if (index == StationaryIndex{1, 1}) point.samples = point.contact;
    if (index == StationaryIndex{2, 2}) {
      const auto limits = subject.truth->limits(i);
      point.successors = {{target_of(subject, limits[0]), target_of(subject, limits[1])}};
      point.successors_by_side = true;
      point.u2 = {{polyline_of(subject.truth->polyline(i, 0)), polyline_of(subject.truth->polyline(i, 1))}};
    }
    claim.points.push_back(std::move(point));
  }
  return claim;
}

// ---- Claims that vary where they may.

// The first affinely independent part that spans the same affine hull.
std::vector<PointId> first_spanning_part(const Subject& subject, const std::vector<PointId>& names) {
  std::vector<PointId> part;
  for (const PointId name : names) {
    part.push_back(name);
    if (oracle::affine_dimension(subject.coordinates(part)) + 1 < static_cast<int>(part.size())) part.pop_back();
  }
  return part;
}

std::vector<PointId> spanning_part(const Subject& subject, std::vector<PointId> names) {
  std::rotate(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(below(names.size())), names.end());
  return first_spanning_part(subject, names);
}

// A claim as Giesen and Kühne's format has it: critical points only, parts of contact sets, radii in
// decimals, and incidences as sets.
Claim claim_in_decimals(const Subject& subject) {
  Claim claim = full_claim(subject);
  std::erase_if(claim.points, [](const ClaimedPoint& point) { return point.hull_dimension.has_value(); });
  std::map<std::vector<PointId>, std::vector<ClaimedTarget>> edges;
  for (ClaimedPoint& point : claim.points) {
    if (point.index == 1) {
      for (const PointId name : point.contact) edges[{name}].push_back({false, point.contact});
    }
  }
  for (ClaimedPoint& point : claim.points) {
    for (ClaimedNumber& coordinate : *point.center) coordinate = in_decimals(coordinate.value);
    point.squared_distance = in_decimals(point.squared_distance->value);
    if (point.index == 0) point.successors = edges[point.contact];
    point.contact = spanning_part(subject, point.contact);
    point.successors_by_side = false;
    point.u2.reset();
    if (point.index == 2) std::swap(point.successors->front(), point.successors->back());
  }
  return claim;
}

Claim claim_by_position(const Subject& subject) {
  Claim claim = full_claim(subject);
  for (ClaimedPoint& point : claim.points) {
    for (ClaimedNumber& coordinate : *point.center) coordinate = in_decimals(coordinate.value);
    point.contact.clear();
    point.successors.reset();
    point.samples.reset();
    point.u2.reset();
  }
  return claim;
}

ClaimedPoint critical(int index, const std::vector<PointId>& contact) {
  ClaimedPoint point;
  point.index = index;
  point.contact = contact;
  return point;
}

// All samples of the face of the contact set that has the centre in its relative interior. They are the
// samples of all simplices that have it there.
std::vector<PointId> smallest_face(const Subject& subject, std::size_t i) {
  const std::vector<PointId> names = subject.contact(i);
  const RationalPoint center = subject.truth->sphere(i).center;
  std::set<PointId> face;
  oracle::for_each_subset(names.size(), 4, [&](const std::vector<std::size_t>& chosen) {
    const std::vector<PointId> simplex = oracle::select(names, chosen);
    const auto weights = oracle::barycentric(subject.coordinates(simplex), center);
    if (weights && std::ranges::all_of(*weights, [](const Rational& w) { return w > 0; })) {
      face.insert(simplex.begin(), simplex.end());
    }
  });
  return {face.begin(), face.end()};
}

// The polygons of the contact set's hull that have the edge pq. For kind 1-3 there are two.
std::set<std::vector<PointId>> polygons_of(const Subject& subject, std::size_t i, const std::vector<PointId>& edge) {
  std::set<std::vector<PointId>> polygons;
  const std::vector<PointId> names = subject.contact(i);
  const auto at = [&](PointId name) { return subject.coordinates({name})[0]; };
  for (const PointId r : names) {
    if (r == edge[0] || r == edge[1]) continue;
    const oracle::Point u = oracle::minus(at(edge[1]), at(edge[0])), v = oracle::minus(at(r), at(edge[0]));
    const oracle::Point normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    std::vector<PointId> polygon;
    bool above = false, beneath = false;
    for (const PointId q : names) {
      const Rational height = oracle::dot(normal, oracle::minus(at(q), at(edge[0])));
      if (height == 0) polygon.push_back(q);
      above = above || height > 0;
      beneath = beneath || height < 0;
    }
    if (!(above && beneath)) polygons.insert(polygon);
  }
  return polygons;
}

void shuffle(std::vector<PointId>& names) {
  for (std::size_t k = names.size(); k > 1; --k) std::swap(names[k - 1], names[below(k)]);
}

// A random affinely independent part of these samples that spans their affine hull, and in whose hull the centre of the
// point lies. It lies inside the face.
std::vector<PointId> spanning_part_around(const Subject& subject, std::size_t i, std::vector<PointId> names,
                                          std::vector<PointId> face) {
  const RationalPoint center = subject.truth->sphere(i).center;
  std::erase_if(names, [&](PointId name) { return std::ranges::find(face, name) != face.end(); });
  while (true) {
    shuffle(face);
    shuffle(names);
    std::vector<PointId> order = face;
    order.insert(order.end(), names.begin(), names.end());
    std::vector<PointId> part = first_spanning_part(subject, order);
    const auto weights = oracle::barycentric(subject.coordinates(part), center);
    if (weights && std::ranges::all_of(*weights, [](const Rational& w) { return w >= 0; })) {
      std::ranges::sort(part);
      return part;
    }
  }
}

// The sign of the cosine of a tetrahedron's angle at an edge.
int sign_of_angle(const Subject& subject, const std::vector<PointId>& names, const std::vector<PointId>& edge) {
  std::vector<PointId> others;
  std::ranges::set_difference(names, edge, std::back_inserter(others));
  const auto at = subject.coordinates({edge[0], edge[1], others[0], others[1]});
  const oracle::Point e = oracle::minus(at[1], at[0]), r = oracle::minus(at[2], at[0]), s = oracle::minus(at[3], at[0]);
  const Rational cosine = oracle::dot(r, s) * oracle::dot(e, e) - oracle::dot(r, e) * oracle::dot(s, e);
  return cosine > 0 ? 1 : cosine < 0 ? -1 : 0;
}

// What a perturbation makes of a regular stationary point.
std::vector<ClaimedPoint> perturbed(const Subject& subject, std::size_t i) {
  const StationaryIndex kind = subject.truth->index(i);
  const std::vector<PointId> face = smallest_face(subject, i), whole = subject.contact(i);
  const auto some = [&](int index, const std::vector<PointId>& names) {
    return critical(index, *rc::gen::arbitrary<bool>() ? names : spanning_part_around(subject, i, names, face));
  };
  if (kind == StationaryIndex{1, 2}) return {some(1, face), some(2, whole)};
  if (kind == StationaryIndex{2, 3}) return {some(2, face), some(3, whole)};
  const auto polygons = polygons_of(subject, i, face);
  RC_ASSERT(polygons.size() == 2U);
  const auto &one = *polygons.begin(), &other = *polygons.rbegin();
  const int angle = whole.size() == 4 ? sign_of_angle(subject, whole, face) : 0;
  const std::size_t choice = below(3);
  if (choice == 0 && angle >= 0) return {some(1, face), some(2, one)};
  if (choice == 1 && angle <= 0) return {some(2, other), some(3, whole)};
  return {some(2, other), some(3, whole), some(1, face), some(2, one)};
}

struct PerturbedClaim {
  Claim claim;
  std::vector<std::size_t> lines;  // of the perturbed points
};

PerturbedClaim perturbed_claim(const Subject& subject) {
  PerturbedClaim result{full_claim(subject), {}};
  auto& points = result.claim.points;
  std::erase_if(points, [](const ClaimedPoint& point) { return point.hull_dimension.has_value(); });
  for (std::size_t i = 0; i < subject.truth->size(); ++i) {
    if (subject.truth->index(i).is_critical()) continue;
    for (ClaimedPoint& point : perturbed(subject, i)) {
      point.line = kFirstLine + points.size();
      result.lines.push_back(point.line);
      points.push_back(std::move(point));
    }
  }
  return result;
}

// ---- Mutants.

struct Mutant {
  Claim claim;
  int level = 0;
  std::optional<std::size_t> line;  // where the finding has to be
  std::vector<PointId> missing;     // or what it has to be about
};
using Mutation = std::function<std::optional<Mutant>(const Subject&, const Claim&)>;

std::size_t line_of(std::size_t k) { return kFirstLine + k; }

bool is_critical(const ClaimedPoint& point) { return !point.hull_dimension; }
bool is_any(const ClaimedPoint&) { return true; }

std::optional<Mutant> dropped(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, is_critical);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 3, std::nullopt, subject.contact(*k)};
  mutant.claim.points.erase(mutant.claim.points.begin() + static_cast<std::ptrdiff_t>(*k));
  return mutant;
}

// All that is true is claimed already, so whatever is added is wrong.
std::optional<Mutant> added(const Subject& subject, const Claim& claim) {
  if (subject.points.empty()) return std::nullopt;
  std::set<PointId> names;
  const std::size_t count = 1 + below(4);
  for (std::size_t k = 0; k < count; ++k) names.insert(subject.points.name(below(subject.points.size())));
  Mutant mutant{claim, 0, line_of(claim.points.size()), {}};
  mutant.claim.points.push_back(critical(static_cast<int>(names.size()) - 1, {names.begin(), names.end()}));
  mutant.claim.points.back().line = *mutant.line;
  return mutant;
}

std::optional<Mutant> duplicated(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, is_any);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 3, line_of(claim.points.size()), {}};
  mutant.claim.points.push_back(claim.points[*k]);
  mutant.claim.points.back().line = *mutant.line;
  return mutant;
}

std::optional<Mutant> of_other_index(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, is_any);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 0, line_of(*k), {}};
  ClaimedPoint& point = mutant.claim.points[*k];
  if (!is_critical(point) && *rc::gen::arbitrary<bool>()) {
    point.hull_dimension = point.index + *point.hull_dimension == 3 ? 3 : 2;  // 1-2 to 1-3, others to ?-2
    if (point.index == 2) point.index = 1;
    return mutant;
  }
  if (!is_critical(point)) {
    point.hull_dimension.reset();
  } else if (below(4) == 0) {
    point.index = 1;
    point.hull_dimension = 2 + static_cast<int>(below(2));
  } else {
    point.index = (point.index + 1 + static_cast<int>(below(3))) % 4;
  }
  point.successors.reset();
  point.samples.reset();
  return mutant;
}

// One sample more, less or another, but not in a way that FC-CLAIM-02 permits.
std::optional<Mutant> of_other_contact(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, is_any);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 0, line_of(*k), {}};
  std::vector<PointId>& contact = mutant.claim.points[*k].contact;
  const std::vector<PointId> right = contact;
  const std::size_t change = below(3);
  if (change != 0 && contact.size() > 1) {
    contact.erase(contact.begin() + static_cast<std::ptrdiff_t>(below(contact.size())));
  }
  if (change != 1) contact.push_back(subject.points.name(below(subject.points.size())));
  std::sort(contact.begin(), contact.end());
  const bool is_part = std::ranges::includes(right, contact);
  const int dimension = subject.truth->index(*k).hull_dimension;
  if (contact == right || (is_part && static_cast<int>(contact.size()) == dimension + 1 &&
                           oracle::affine_dimension(subject.coordinates(contact)) == dimension)) {
    return std::nullopt;
  }
  return mutant;
}

// The nearest double, or a double beside it where the nearest is the exact value itself.
std::optional<Rational> rounded_off(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest) return std::nullopt;
  const Rational rounded(*nearest);
  return rounded != value ? rounded : Rational(fuzz::nudged(*nearest, *rc::gen::arbitrary<bool>() ? 1 : -1));
}

std::optional<Mutant> with_other_center(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, is_any);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 2, line_of(*k), {}};
  Rational& coordinate = (*mutant.claim.points[*k].center)[below(3)].value;
  const auto other = rounded_off(coordinate);
  if (!other) return std::nullopt;
  coordinate = *other;
  return mutant;
}

std::optional<Mutant> with_other_distance(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, is_any);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 2, line_of(*k), {}};
  Rational& square = mutant.claim.points[*k].squared_distance->value;
  const auto other = rounded_off(square);
  if (!other || *other < 0) return std::nullopt;
  square = *other;
  return mutant;
}

// Whether both limits are such that no perturbation lets an orbit go on.
bool has_final_limits(const Subject& subject, const ClaimedPoint& point) {
  if (!point.successors) return false;
  const auto limits = subject.truth->limits(point.line - kFirstLine);
  return std::ranges::all_of(limits, [&](const std::optional<std::size_t>& limit) {
    return !limit || subject.truth->index(*limit) == StationaryIndex{3, 3};
  });
}
bool same(const ClaimedTarget& a, const ClaimedTarget& b) {
  return a.is_infinity == b.is_infinity && a.contact == b.contact;
}

std::optional<Mutant> with_swapped_sides(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [&](const ClaimedPoint& point) {
    return has_final_limits(subject, point) && !same(point.successors->front(), point.successors->back());
  });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 4, line_of(*k), {}};
  auto& successors = *mutant.claim.points[*k].successors;
  std::swap(successors.front(), successors.back());
  return mutant;
}

std::optional<Mutant> with_other_limit(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [&](const ClaimedPoint& point) { return has_final_limits(subject, point); });
  const auto other = some_point(claim, [](const ClaimedPoint& point) { return point.index > 0; });
  if (!k || !other) return std::nullopt;
  Mutant mutant{claim, 4, line_of(*k), {}};
  ClaimedTarget& target = (*mutant.claim.points[*k].successors)[below(2)];
  const ClaimedTarget wrong =
      *rc::gen::arbitrary<bool>() ? ClaimedTarget{true, {}} : ClaimedTarget{false, claim.points[*other].contact};
  if (same(target, wrong)) return std::nullopt;
  target = wrong;
  return mutant;
}

std::optional<Mutant> with_other_samples(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [](const ClaimedPoint& point) { return point.samples.has_value(); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 4, line_of(*k), {}};
  std::vector<PointId>& samples = *mutant.claim.points[*k].samples;
  samples[below(2)] = subject.points.name(below(subject.points.size()));
  std::sort(samples.begin(), samples.end());
  if (samples == claim.points[*k].contact || samples[0] == samples[1]) return std::nullopt;
  return mutant;
}

std::optional<Mutant> with_other_polyline(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, [](const ClaimedPoint& point) { return point.u2.has_value(); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, line_of(*k), {}};
  ClaimedPolyline& line = (*mutant.claim.points[*k].u2)[below(2)];
  const std::size_t at = below(line.size());
  ClaimedSegment& segment = line[at];
  const std::size_t change = below(4);
  if (change == 0) {  // a vertex less
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(at));
    return mutant;
  }
  if (change == 1) {
    segment.type = segment.type == "E-E-V" ? "E-F-V" : "E-E-V";
    return mutant;
  }
  ClaimedPosition& moved = segment.end && *rc::gen::arbitrary<bool>() ? *segment.end : *segment.driver;
  Rational& coordinate = moved[below(3)].value;
  const auto other = rounded_off(coordinate);
  if (!other) return std::nullopt;
  coordinate = *other;
  return mutant;
}

std::optional<Mutant> malformed(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, is_any);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 1, line_of(*k), {}};
  ClaimedPoint& point = mutant.claim.points[*k];
  switch (below(3)) {
    case 0:
      point.contact.push_back(static_cast<PointId>(subject.points.row_count() + below(3)));
      break;
    case 1:
      point.contact.push_back(point.contact.front());
      break;
    default:
      point.index = below(2) == 0 ? -1 : 4;
  }
  return mutant;
}

const std::map<std::string, Mutation>& mutations() {
  static const std::map<std::string, Mutation> all = {{"dropped", dropped},
                                                      {"added", added},
                                                      {"duplicated", duplicated},
                                                      {"other index", of_other_index},
                                                      {"other contact", of_other_contact},
                                                      {"other centre", with_other_center},
                                                      {"other distance", with_other_distance},
                                                      {"swapped sides", with_swapped_sides},
                                                      {"other limit", with_other_limit},
                                                      {"other samples", with_other_samples},
                                                      {"other polyline", with_other_polyline},
                                                      {"malformed", malformed}};
  return all;
}

bool is_at(const Finding& finding, const Mutant& mutant) {
  if (finding.is_variation || (mutant.level != 0 && finding.level != mutant.level)) return false;
  return mutant.line ? finding.line == mutant.line : !finding.line && finding.contact == mutant.missing;
}

// ---- Properties.

TEST(CheckMutations, RightClaimsNeverFail) {
  CITES("FC-CLAIM-01", "FC-CLAIM-02", "FC-CLAIM-04", "FC-CLAIM-05", "FC-CLAIM-06", "FC-CLAIM-08");
  std::size_t perturbed_points = 0, parts = 0;
  on_all_families<Subject>(fuzz::families(), kInputsPerFamily, [&](const Subject& subject) {
    const CheckReport exact = check(subject.points, full_claim(subject), *subject.truth);
    require(subject, exact.verdict == Verdict::kConforms && exact.findings.empty() && exact.is_exact, "the full claim",
            exact);
    const CheckReport decimals = check(subject.points, claim_in_decimals(subject), *subject.truth);
    require(subject, decimals.verdict != Verdict::kFails, "the claim in decimals", decimals);
    for (const Finding& finding : decimals.findings) {
      parts += finding.reason == FindingReason::kSpanningPart ? 1 : 0;
    }
    const CheckReport positions = check(subject.points, claim_by_position(subject), *subject.truth);
    require(subject, positions.verdict != Verdict::kFails, "the claim by position", positions);
    const PerturbedClaim perturbation = perturbed_claim(subject);
    const CheckReport varied = check(subject.points, perturbation.claim, *subject.truth);
    require(subject, varied.verdict == (perturbation.lines.empty() ? Verdict::kConforms : Verdict::kPerturbed),
            "the perturbed claim", varied);
    perturbed_points += perturbation.lines.size();
  });
  if (scale_of_run() >= 1) {
    EXPECT_GT(perturbed_points, 100U);
    EXPECT_GT(parts, 100U);
  }
}

TEST(CheckMutations, MutantsFailWhereTheyAreWrong) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03", "FC-CLAIM-05", "FC-CLAIM-06", "FC-CLAIM-08", "FC-CRIT-05", "FC-CRIT-06");
  std::map<std::string, std::size_t> made;
  on_all_families<Subject>(fuzz::families(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = full_claim(subject);
    for (const auto& [name, mutation] : mutations()) {
      const std::optional<Mutant> mutant = mutation(subject, claim);
      if (!mutant) continue;
      ++made[name];
      const CheckReport report = check(subject.points, mutant->claim, *subject.truth);
      require(subject, report.verdict == Verdict::kFails, name + ": is not rejected", report);
      const bool found =
          std::ranges::any_of(report.findings, [&](const Finding& finding) { return is_at(finding, *mutant); });
      require(subject, found,
              name + ": no finding at line " + std::to_string(mutant->line.value_or(0)) + ", level " +
                  std::to_string(mutant->level),
              report);
    }
  });
  if (scale_of_run() < 1) return;  // fewer inputs may have none of a kind
  for (const auto& [name, mutation] : mutations()) EXPECT_GT(made[name], 50U) << name;
}

// What a perturbation makes of a regular stationary point is right only as a whole.
TEST(CheckMutations, HalfAPerturbationFails) {
  CITES("FC-CLAIM-04");
  std::size_t made = 0;
  on_all_families<Subject>(fuzz::families(), kInputsPerFamily, [&](const Subject& subject) {
    PerturbedClaim half = perturbed_claim(subject);
    if (half.lines.empty()) return;
    // Three of the four points of a kind 1-3 are never right, nor is one of two.
    const std::size_t line = half.lines[below(half.lines.size())];
    const auto dropped_at = std::ranges::find(half.claim.points, line, &ClaimedPoint::line);
    const RationalPoint center = exact_sphere(subject.points, dropped_at->contact).center;
    half.claim.points.erase(dropped_at);
    ++made;
    const CheckReport report = check(subject.points, half.claim, *subject.truth);
    const bool found = std::ranges::any_of(report.findings, [&](const Finding& finding) {
      return !finding.is_variation && finding.reason == FindingReason::kCollisionAsCritical &&
             exact_sphere(subject.points, finding.contact).center == center;
    });
    require(subject, report.verdict == Verdict::kFails && found, "half a perturbation", report);
  });
  EXPECT_GT(made, scale_of_run() >= 1 ? 50U : 0U);
}

}  // namespace
}  // namespace flowcert::property::check_mutations_test
