// What a program claims that moves the points a little before it computes.
//
// Guarantees: inputs are points on a small grid, and each is moved so little that no sign changes which is not zero
// (FC-CLAIM-04). The samples of one plane may move together. All that is true of the moved points is claimed of those
// on the grid. Such a claim never fails. The displacements are of two sizes, one the square of the other, because what
// is flat needs both to open.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/inputs/input.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::perturbed_claims_test {
namespace {

constexpr int kInputsPerFamily = 200;
constexpr double kLargestCoordinate = 8;
constexpr double kShift = 0x1p-23;

bool is_on_small_grid(const fuzz::Input& input) {
  return std::ranges::all_of(input.rows, [](const fuzz::Row& row) {
    return std::ranges::all_of(row, [](double x) { return x == std::floor(x) && std::abs(x) <= kLargestCoordinate; });
  });
}

double shift() {
  const auto steps = static_cast<double>(*rc::gen::inRange(-2, 3));
  const auto square = static_cast<double>(*rc::gen::inRange(-2, 3));
  switch (below(3)) {
    case 0:
      return steps * kShift;
    case 1:
      return square * kShift * kShift;
    default:
      return steps * kShift + square * kShift * kShift;
  }
}

fuzz::Row shifts() { return {shift(), shift(), shift()}; }

// The samples of a plane move by the same, so that polygons there stay on their circles.
struct Plane {
  std::size_t axis = 0;
  double at = 0;
  [[nodiscard]] bool has(const fuzz::Row& row) const { return row[axis] == at; }
};

// Equal rows stay equal.
fuzz::Input moved(const fuzz::Input& input, const std::optional<Plane>& kept) {
  std::map<fuzz::Row, fuzz::Row> to;
  const fuzz::Row together = shifts();
  fuzz::Input result;
  for (fuzz::Row row : input.rows) {
    for (double& x : row) x += 0.0;  // -0.0 is 0.0
    const auto [at, is_new] = to.try_emplace(row, row);
    if (is_new) {
      const fuzz::Row by = kept && kept->has(row) ? together : shifts();
      for (std::size_t axis = 0; axis < 3; ++axis) at->second[axis] += by[axis];
    }
    result.rows.push_back(at->second);
  }
  return result;
}

// A contact set keeps one face at most: the samples in the plane are all of it, or the others are on one side.
bool keeps_faces(const ClaimSubject& subject, const Plane& plane) {
  for (std::size_t i = 0; i < subject.truth->size(); ++i) {
    std::size_t kept = 0, above = 0, below = 0;
    for (const PointId name : subject.contact(i)) {
      const fuzz::Row& row = subject.input.rows[name];
      ++(plane.has(row) ? kept : row[plane.axis] > plane.at ? above : below);
    }
    if (kept > 3 && above > 0 && below > 0) return false;
  }
  return true;
}

// All that is true, without positions, and without what the format of a perturbing program has no word for.
Claim claim_of(const ClaimSubject& subject) {
  Claim claim = true_claim(subject.points, *subject.truth);
  std::map<std::vector<PointId>, std::vector<ClaimedTarget>> edges;
  for (ClaimedPoint& point : claim.points) {
    point.line += kFirstLine - 1;
    point.u2.reset();
    point.skeleton.reset();
    point.surface.reset();
    if (point.stable) point.stable = ClaimedStable{{}, {}, {}, point.stable->boundary, {}};
    if (point.index != 1) continue;
    for (const PointId name : point.contact) edges[{name}].push_back({false, point.contact});
  }
  for (ClaimedPoint& point : claim.points) {
    if (point.index == 0) point.successors = edges[point.contact];
  }
  return claim;
}

// A perturbation that leaves something degenerate is none that a program makes by symbols. What is kept in a plane may
// be, with one further sample.
bool is_generic(const ClaimSubject& subject, const fuzz::Input& before, const std::optional<Plane>& kept) {
  for (std::size_t i = 0; i < subject.truth->size(); ++i) {
    const StationaryIndex index = subject.truth->index(i);
    if (!index.is_critical()) return false;
    const auto contact = subject.contact(i);
    const auto is_elsewhere = [&](PointId name) { return !kept || !kept->has(before.rows[name]); };
    if (contact.size() != index.face_dimension + std::size_t{1} && std::ranges::count_if(contact, is_elsewhere) > 1) {
      return false;
    }
  }
  return true;
}

TEST(PerturbedClaims, NeverFail) {
  CITES("FC-CLAIM-21", "FC-CLAIM-03", "FC-CLAIM-04", "FC-CLAIM-06", "FC-CLAIM-07", "FC-CLAIM-09");
  std::map<std::string, std::size_t> verdicts;
  std::size_t undecided = 0;
  on_all_families<ClaimSubject>(fuzz::families(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    if (!is_on_small_grid(subject.input)) return;
    const fuzz::Input near = moved(subject.input, std::nullopt);
    const ClaimSubject perturbed(near);
    if (!is_generic(perturbed, subject.input, std::nullopt)) return;
    const CheckReport report = check(subject.points, claim_of(perturbed), *subject.truth);
    ++verdicts[verdict_text(report.verdict)];
    undecided += report.not_decided.empty() ? 0 : 1;
    std::ostringstream text;
    text << "moved to:\n" << near;
    require(subject, report.verdict != Verdict::kFails, text.str(), report);
  });
  for (const auto& [verdict, count] : verdicts) std::printf("%s: %zu claims\n", verdict.c_str(), count);
  std::printf("not decided: %zu claims\n", undecided);
  if (scale_of_run() < 1) return;
  for (const char* verdict : {"conforms where determined", "perturbed"}) EXPECT_GT(verdicts[verdict], 100U) << verdict;
  EXPECT_GT(undecided, 50U);
}

// Some or all indices are judged.
ClaimedIndices some_indices() {
  ClaimedIndices indices{};
  for (bool& is_judged : indices) is_judged = below(3) > 0;
  return below(2) == 0 ? indices : ClaimedIndices{true, true, true, true};
}

TEST(PerturbedClaims, NeverFailIfAPolygonStays) {
  CITES("FC-CLAIM-21", "FC-CLAIM-04", "FC-CLAIM-12");
  std::size_t perturbed_claims = 0, with_polygons = 0;
  on_all_families<ClaimSubject>(fuzz::families(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    if (!is_on_small_grid(subject.input) || subject.input.rows.empty()) return;
    const fuzz::Row& row = subject.input.rows[below(subject.input.rows.size())];
    Plane plane{below(3), 0};
    plane.at = row[plane.axis];
    if (!keeps_faces(subject, plane)) return;
    const fuzz::Input near = moved(subject.input, plane);
    const ClaimSubject perturbed(near);
    if (!is_generic(perturbed, subject.input, plane)) return;
    CheckOptions options;
    options.indices = some_indices();
    const CheckReport report = check(subject.points, claim_of(perturbed), *subject.truth, options);
    perturbed_claims += report.verdict == Verdict::kPerturbed ? 1 : 0;
    for (const Finding& finding : report.findings) {
      if (finding.reason != FindingReason::kSymbolicPerturbation || finding.level != 2) continue;
      with_polygons += finding.contact.size() > 4 ? 1 : 0;
    }
    std::ostringstream text;
    text << "moved to:\n" << near;
    require(subject, report.verdict != Verdict::kFails, text.str(), report);
  });
  std::printf("perturbed: %zu claims, points with polygons: %zu\n", perturbed_claims, with_polygons);
  if (scale_of_run() < 1) return;
  EXPECT_GT(perturbed_claims, 100U);
  EXPECT_GT(with_polygons, 10U);
}

}  // namespace
}  // namespace flowcert::property::perturbed_claims_test
