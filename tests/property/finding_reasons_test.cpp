// The reason of a finding follows from the point and from what is claimed of it, on every family of inputs. Claims of
// some indices alone are right where they are right.
//
// Guarantees: each claim is right but for one change to one point, and has no other wrong finding than the one that
// the change explains, apart from the Euler sum. The test fails too when some change was hardly ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::finding_reasons_test {
namespace {

constexpr int kInputsPerFamily = 10;

// All critical points, by contact set and exact centre. Regular ones are not told.
Claim claim_of_points(const ClaimSubject& subject) {
  Claim claim;
  for (std::size_t i = 0; i < subject.truth->size(); ++i) {
    if (!subject.truth->index(i).is_critical()) continue;
    ClaimedPoint point;
    point.line = kFirstLine + i;
    point.index = subject.truth->index(i).face_dimension;
    point.contact = subject.contact(i);
    point.center = exactly(subject.truth->sphere(i).center);
    claim.points.push_back(std::move(point));
  }
  return claim;
}

struct Changed {
  Claim claim;
  FindingReason reason;  // that has to be found
};

std::size_t record_of(const ClaimedPoint& point) { return point.line - kFirstLine; }

// A contact set of more samples than a simplex of its dimension has.
bool is_cluster(const ClaimSubject& subject, std::size_t record) {
  return subject.contact(record).size() > subject.truth->index(record).hull_dimension + std::size_t{1};
}

std::optional<Changed> left_out(const ClaimSubject& subject, Claim claim) {
  if (claim.points.empty()) return std::nullopt;
  const std::size_t k = below(claim.points.size());
  const bool is_missed_by_cluster = is_cluster(subject, record_of(claim.points[k]));
  claim.points.erase(claim.points.begin() + static_cast<std::ptrdiff_t>(k));
  return Changed{claim, is_missed_by_cluster ? FindingReason::kMissedByCluster : FindingReason::kMissing};
}

std::optional<Changed> twice(const ClaimSubject&, Claim claim) {
  if (claim.points.empty()) return std::nullopt;
  claim.points.push_back(claim.points[below(claim.points.size())]);
  return Changed{claim, FindingReason::kClaimedTwice};
}

std::optional<Changed> of_another_index(const ClaimSubject&, Claim claim) {
  if (claim.points.empty()) return std::nullopt;
  ClaimedPoint& point = claim.points[below(claim.points.size())];
  point.index = static_cast<int>((static_cast<std::size_t>(point.index) + 1 + below(3)) % 4);
  return Changed{claim, FindingReason::kWrongIndex};
}

std::optional<Changed> a_regular_one(const ClaimSubject& subject, Claim claim) {
  std::vector<std::size_t> regular;
  for (std::size_t i = 0; i < subject.truth->size(); ++i) {
    if (!subject.truth->index(i).is_critical()) regular.push_back(i);
  }
  if (regular.empty()) return std::nullopt;
  const std::size_t i = regular[below(regular.size())];
  ClaimedPoint point;
  point.line = kFirstLine + i;
  point.index = subject.truth->index(i).face_dimension;
  point.contact = subject.contact(i);
  claim.points.push_back(point);
  return Changed{claim, FindingReason::kCollisionAsCritical};
}

// By a thousandth of the radius, which no rounding explains.
std::optional<Changed> elsewhere(const ClaimSubject& subject, Claim claim) {
  const auto k = some_point(claim, [](const ClaimedPoint& point) { return point.index > 0; });
  if (!k) return std::nullopt;
  ClaimedPoint& point = claim.points[*k];
  const ExactSphere sphere = subject.truth->sphere(record_of(point));
  const std::optional<double> square = nearest_double(sphere.squared_radius);
  if (!square || *square == 0 || !(rounding_length(sphere) <= 1e6 * std::sqrt(*square))) return std::nullopt;
  (*point.center)[below(3)].value += Rational(std::sqrt(*square)) / 1000;
  return Changed{claim, FindingReason::kWrongPosition};
}

using Change = std::function<std::optional<Changed>(const ClaimSubject&, Claim)>;
const std::map<std::string, Change> kChanges = {{"left out", left_out},
                                                {"twice", twice},
                                                {"another index", of_another_index},
                                                {"a regular one", a_regular_one},
                                                {"elsewhere", elsewhere}};

TEST(FindingReasons, FollowFromThePoint) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-06", "FC-OUT-01");
  std::map<std::string, std::size_t> made;
  on_all_families<ClaimSubject>(fuzz::families(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    const Claim claim = claim_of_points(subject);
    for (const auto& [name, change] : kChanges) {
      const std::optional<Changed> changed = change(subject, claim);
      if (!changed) continue;
      ++made[name];
      CheckReport report = check(subject.points, changed->claim, *subject.truth);
      std::erase_if(report.findings, [](const Finding& finding) { return finding.clause == "FC-INV-01"; });
      require(subject, report.findings.size() == 1 && report.findings[0].reason == changed->reason,
              name + ": not just " + reason_text(changed->reason), report);
    }
  });
  if (scale_of_run() < 1) return;
  for (const auto& [name, change] : kChanges) EXPECT_GT(made[name], 50U) << name;
}

// ---- Claims of some indices

ClaimedIndices some_indices() {
  ClaimedIndices indices{};
  for (bool& is_claimed : indices) is_claimed = *rc::gen::arbitrary<bool>();
  return indices;
}

TEST(PartialClaims, AreRightWhereTheyAreRight) {
  CITES("FC-CLAIM-12");
  std::size_t with_misses = 0;
  on_all_families<ClaimSubject>(fuzz::families(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    const ClaimedIndices indices = some_indices();
    const auto is_left_out = [&](const ClaimedPoint& point) {
      return !indices.at(static_cast<std::size_t>(point.index));
    };
    const Claim whole = claim_of_points(subject);
    Claim part = whole;
    std::erase_if(part.points, is_left_out);
    part.indices = indices;
    const CheckReport report = check(subject.points, part, *subject.truth);
    require(subject, report.verdict == Verdict::kConforms && report.indices == indices, "a part", report);
    require(subject, indices == ClaimedIndices{true, true, true, true} || !report.not_judged.empty(),
            "a part without what is not judged", report);
    // Who judges leaves the others out, though all of them are wrong.
    Claim other = whole;
    for (ClaimedPoint& point : other.points) {
      if (is_left_out(point)) point.contact.front() = subject.points.name(below(subject.points.size()));
    }
    CheckOptions options;
    options.indices = indices;
    require(subject, check(subject.points, other, *subject.truth, options).verdict == Verdict::kConforms,
            "the judged indices", report);
    // One that is claimed is missing.
    if (part.points.empty()) return;
    part.points.erase(part.points.begin() + static_cast<std::ptrdiff_t>(below(part.points.size())));
    const CheckReport missing = check(subject.points, part, *subject.truth);
    require(subject, missing.verdict == Verdict::kFails && !missing.findings.empty(), "a smaller part", missing);
    ++with_misses;
  });
  if (scale_of_run() < 1) return;
  EXPECT_GT(with_misses, 50U);
}

}  // namespace
}  // namespace flowcert::property::finding_reasons_test
