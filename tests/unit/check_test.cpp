// check() on claims made by hand: every kind of finding, by what it says, and every permitted variation.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "certify/truth.h"
#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::check_test {
namespace {

TEST(CheckTest, ReportsWhatItChecked) {
  CITES("FC-CLAIM-03", "FC-CLAIM-19", "FC-CLAIM-20", "FC-INV-01");
  const Truly cube(kCube);
  const CheckReport report = cube.check(cube.claim());
  EXPECT_EQ(report.verdict, Verdict::kConforms) << text(report);
  EXPECT_TRUE(report.is_exact);
  EXPECT_EQ(report.conforms, (std::array<std::optional<bool>, 5>{true, true, true, {}, {}}));
  EXPECT_EQ(report.claimed_counts, (std::array<std::size_t, 4>{8, 12, 6, 1}));
  EXPECT_EQ(report.true_counts, report.claimed_counts);
  const CheckReport nothing = cube.check(Claimed());
  EXPECT_EQ(nothing.verdict, Verdict::kFails);
  EXPECT_EQ(nothing.conforms, (std::array<std::optional<bool>, 5>{true, {}, false, {}, {}}));
  EXPECT_EQ(nothing.findings.size(), 28U) << "27 points and the Euler sum";
  EXPECT_EQ(Truly({}).check(Claimed()).verdict, Verdict::kConforms);
  const CheckReport form_alone = cube.check(Claimed(), {.highest_level = 1});
  EXPECT_EQ(form_alone.verdict, Verdict::kConforms);
}

TEST(CheckTest, TellsHowMuchOfEachLevelIsDone) {
  CITES("FC-CLAIM-03");
  const Truly truly(std::vector<Point>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {1, 1, 5}});
  int last_level = 0;
  std::size_t last = 0;
  std::set<int> levels;
  CheckOptions options;
  options.progress = [&](int level, std::size_t done, std::size_t total) {
    EXPECT_GE(level, last_level);
    EXPECT_TRUE(level > last_level || done > last);
    EXPECT_LT(done, total);
    last_level = level;
    last = done;
    levels.insert(level);
  };
  (void)truly.check(truly.whole_claim(), options);
  EXPECT_EQ(levels, (std::set<int>{1, 2, 3, 4, 5}));
  options.progress = [](int level, std::size_t, std::size_t) {
    if (level == 3) throw std::runtime_error("stopped");
  };
  EXPECT_THROW((void)truly.check(truly.whole_claim(), options), std::runtime_error);
}

TEST(CheckTest, RefusesWhatIsMalformed) {
  CITES("FC-CLAIM-01", "FC-IN-03");
  const Truly triangle(kRightTriangle);
  Claimed claimed = triangle.claim();
  const std::size_t right = claimed.claim.points.size();
  claimed.add(1, {0, 3}).add(1, {1, 1}).add(4, {0}).regular(2, 2, {0, 1, 2}).add(1, {});
  const CheckReport report = triangle.check(claimed);
  for (std::size_t line = right + 1; line <= right + 5; ++line) {
    expect_finding(report, 1, FindingReason::kMalformed, line == right + 4 ? "FC-CRIT-03" : "FC-CLAIM-01", line);
  }
  EXPECT_EQ(report.conforms[0], false);
  Claimed header = triangle.claim();
  header.claim.point_count = 4;
  header.claim.critical_counts = {{3, 2, 1, 0}};
  header.claim.input_sha256 = "other";
  const CheckReport wrong_header = triangle.check(header);
  EXPECT_EQ(wrong_header.findings.size(), 3U) << text(wrong_header);
  expect_finding(wrong_header, 1, FindingReason::kWrongCounts, "FC-IN-03", std::nullopt);
  expect_finding(wrong_header, 1, FindingReason::kWrongCounts, "FC-CLAIM-01", std::nullopt);
  expect_finding(wrong_header, 1, FindingReason::kMalformed, "FC-CLAIM-01", std::nullopt);
}

TEST(CheckTest, AnyRowStandsForItsClass) {
  CITES("FC-CLAIM-01", "FC-IN-03");
  const Truly points({{0, 0, 0}, {4, 0, 0}, {0, 0, 0}});
  Claimed claimed;
  claimed.add(0, {2}).add(0, {1}).add(1, {1, 2});
  EXPECT_EQ(points.check(claimed).verdict, Verdict::kConforms);
  claimed.add(0, {0});
  expect_finding(points.check(claimed), 3, FindingReason::kClaimedTwice, "FC-CRIT-06", 4);
}

TEST(CheckTest, NamesTheConditionThatFails) {
  CITES("FC-CRIT-05", "FC-CLAIM-03");
  const Truly points({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, -9, 0}, {2, 9, 0}});
  Claimed claimed = points.claim();
  const std::size_t right = claimed.claim.points.size();
  claimed.add(2, {2, 3, 4}).add(1, {0, 1}).add(2, {0, 1, 2});
  const CheckReport report = points.check(claimed);
  expect_finding(report, 2, FindingReason::kNotCospherical, "FC-CRIT-05 (a)", right + 1);
  expect_finding(report, 2, FindingReason::kBallNotEmpty, "FC-CRIT-05 (b)", right + 2);
  expect_finding(report, 2, FindingReason::kOutsideHull, "FC-CRIT-05 (d)", right + 3);
  const Truly cube(kCube);
  Claimed diagonal = cube.claim();
  diagonal.add(1, {0, 3});
  expect_finding(cube.check(diagonal), 2, FindingReason::kContactIncomplete, "FC-CRIT-05 (c)", 28);
  // The third point is inside the ball of the first two, by one part in 2^50.
  const Truly nearly({{0, 0, 0}, {2, 0, 0}, {1, 1 - 0x1p-50, 0}});
  Claimed rounded = nearly.claim();
  rounded.add(1, {0, 1});
  expect_finding(nearly.check(rounded), 2, FindingReason::kRounding, "FC-CRIT-05 (b)", 6);
}

TEST(CheckTest, FindsWrongIndicesAndWhatIsMissing) {
  CITES("FC-CLAIM-03", "FC-CRIT-02", "FC-INV-01");
  const Truly cube(kCube);
  const CheckReport square = cube.check(cube.claim_without({{0, 1, 2, 3}}));
  expect_finding(square, 3, FindingReason::kMissedByCluster, "FC-CLAIM-03", std::nullopt);
  // A corner and a side of the square are missed for other reasons than a cluster.
  const CheckReport corner = Truly(kCube).check(Truly(kCube).claim_without({{0}, {0, 1}}));
  EXPECT_EQ(count(corner, FindingReason::kMissing), 2U) << text(corner);
  EXPECT_EQ(count(corner, FindingReason::kMissedByCluster), 0U);
  expect_finding(square, 3, FindingReason::kWrongCounts, "FC-INV-01", std::nullopt);
  EXPECT_EQ(square.findings.size(), 2U);
  EXPECT_EQ(square.findings.front().contact, Ids()) << "the Euler sum comes first, by its empty contact set";
  EXPECT_EQ(square.findings.back().contact, (Ids{0, 1, 2, 3}));
  Claimed other = cube.claim_without({{0, 1, 2, 3}});
  other.add(1, {0, 1, 2, 3});
  const CheckReport wrong_index = cube.check(other);
  expect_finding(wrong_index, 3, FindingReason::kWrongIndex, "FC-CRIT-02", 27);
  EXPECT_EQ(count(wrong_index, FindingReason::kMissedByCluster), 0U);
  const Truly two({{0, 0, 0}, {1, 0, 0}});
  expect_finding(two.check(two.claim_without({{0, 1}})), 3, FindingReason::kMissing, "FC-CLAIM-03", std::nullopt);
}

TEST(CheckTest, PermitsASpanningPart) {
  CITES("FC-CLAIM-02");
  const Truly cube(kCube);
  const CheckReport part =
      cube.check(cube.claim_without({{0, 1, 2, 3}, {0, 1, 2, 3, 4, 5, 6, 7}}).add(2, {0, 1, 2}).add(3, {0, 1, 2, 4}));
  EXPECT_EQ(part.verdict, Verdict::kConformsWhereDetermined) << text(part);
  EXPECT_EQ(count(part, FindingReason::kSpanningPart), 2U);
  expect_finding(part, 2, FindingReason::kSpanningPart, "FC-CLAIM-02", 26);
  // A simplex that does not span will not do, nor will more than a simplex.
  for (const Ids& names : {Ids{0, 1, 4, 5}, Ids{0, 1, 2, 4, 7}, Ids{0, 7}}) {
    const CheckReport wrong = cube.check(cube.claim_without({{0, 1, 2, 3, 4, 5, 6, 7}}).add(3, names));
    EXPECT_EQ(wrong.verdict, Verdict::kFails) << text(wrong);
  }
}

TEST(CheckTest, PermitsWhatAPerturbationGives) {
  CITES("FC-CLAIM-04", "FC-CRIT-03");
  const Truly low(kRightTriangle), high(kKind23), both(kKind13);
  const auto verdict = [](const Truly& truly, const Claimed& claimed) { return truly.check(claimed).verdict; };
  const auto varies = Verdict::kPerturbed;
  for (const Truly* truly : {&low, &high, &both}) EXPECT_EQ(verdict(*truly, truly->claim()), Verdict::kConforms);
  EXPECT_EQ(verdict(low, low.claim().regular(1, 2, {0, 1, 2})), Verdict::kConforms);
  EXPECT_EQ(verdict(low, low.claim().add(1, {1, 2}).add(2, {0, 1, 2})), varies);
  EXPECT_EQ(verdict(low, low.claim().add(1, {1, 2})), Verdict::kFails);
  EXPECT_EQ(verdict(low, low.claim().add(1, {1, 2}).add(2, {0, 1, 2}).regular(1, 2, {0, 1, 2})), Verdict::kFails);
  EXPECT_EQ(verdict(low, low.claim().add(1, {1, 2}).add(2, {0, 1, 2}).add(2, {0, 1, 2})), Verdict::kFails);
  EXPECT_EQ(verdict(high, high.claim().add(2, {0, 1, 2}).add(3, {0, 1, 2, 3})), varies);
  EXPECT_EQ(verdict(high, high.claim().add(3, {0, 1, 2, 3})), Verdict::kFails);
  EXPECT_EQ(verdict(both, both.claim().add(1, {0, 1}).add(2, {0, 1, 2})), varies);
  EXPECT_EQ(verdict(both, both.claim().add(2, {0, 1, 3}).add(3, {0, 1, 2, 3})), varies);
  const auto all = [&] { return both.claim().add(1, {0, 1}).add(2, {0, 1, 2}).add(3, {0, 1, 2, 3}); };
  EXPECT_EQ(verdict(both, all().add(2, {0, 1, 3})), varies);
  EXPECT_EQ(verdict(both, all()), Verdict::kFails);
  EXPECT_EQ(verdict(both, all().add(2, {0, 1, 2})), Verdict::kFails);
  const CheckReport alone = low.check(low.claim().add(1, {1, 2}));
  expect_finding(alone, 2, FindingReason::kCollisionAsCritical, "FC-CRIT-03", 6);
}

// The points of a half sphere. Half a great circle contains the centre, but is no face.
TEST(CheckTest, OnlyFacesCollide) {
  CITES("FC-CLAIM-04");
  const Truly half({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}, {-4, 0, 3}, {3, 0, 4}});
  const Ids whole = {0, 1, 2, 3, 4, 5};
  EXPECT_EQ(half.check(half.claim().add(2, {0, 1, 2}).add(3, whole)).verdict, Verdict::kPerturbed);
  EXPECT_EQ(half.check(half.claim().add(2, {0, 1, 2}).add(3, {0, 1, 2, 5})).verdict, Verdict::kPerturbed);
  EXPECT_EQ(half.check(half.claim().add(2, {0, 3, 4}).add(3, whole)).verdict, Verdict::kFails);
}

TEST(CheckTest, JudgesPositionsExactlyOrWithinTheTolerance) {
  CITES("FC-CLAIM-05", "FC-OUT-01");
  const Truly two({{0, 0, 0}, {2, 0, 0}});
  const auto report = [&](const ClaimedPosition& center) {
    Claimed claimed = two.claim();
    claimed.last().center = center;
    return two.check(claimed);
  };
  const Rational little(1, 1000000000), tiny = Rational(1) / (Rational(1 << 30) * Rational(1 << 22));
  EXPECT_EQ(report(exactly({1, 0, 0})).verdict, Verdict::kConforms);
  EXPECT_TRUE(report(exactly({1, 0, 0})).is_exact);
  EXPECT_EQ(report(decimals({1 + little, 0, 0})).verdict, Verdict::kConforms);
  EXPECT_FALSE(report(decimals({1 + little, 0, 0})).is_exact);
  EXPECT_EQ(report(decimals({1 + 2 * little, 0, 0})).verdict, Verdict::kFails);
  expect_finding(report(exactly({1 + little, 0, 0})), 2, FindingReason::kWrongPosition, "FC-OUT-01", 3);
  expect_finding(report(exactly({1, tiny, 0})), 2, FindingReason::kRounding, "FC-OUT-01", 3);
  Claimed claimed = two.claim();
  claimed.last().distance = decimal(1 - little);
  claimed.last().squared_distance = number(1);
  EXPECT_EQ(two.check(claimed).verdict, Verdict::kConforms);
  claimed.last().distance = decimal(1 - 2 * little);
  EXPECT_EQ(two.check(claimed).verdict, Verdict::kFails);
  EXPECT_EQ(two.check(claimed, {.tolerance = 1e-6}).verdict, Verdict::kConforms);
  EXPECT_THROW((void)two.check(claimed, {.tolerance = -1}), InvalidInput);
  EXPECT_THROW((void)two.check(claimed, {.tolerance = std::numeric_limits<double>::quiet_NaN()}), InvalidInput);
}

// The squares of these lengths are no doubles.
TEST(CheckTest, TellsRoundingAtAnyScale) {
  CITES("FC-CLAIM-05");
  for (const double scale : {0x1p-600, 0x1p600}) {
    const Truly two({{0, 0, 0}, {2 * scale, 0, 0}});
    const Rational unit(scale);
    const auto expect_reason = [&](const Rational& off, FindingReason reason) {
      Claimed claimed = two.claim();
      claimed.last().center = exactly({unit * (1 + off), 0, 0});
      expect_finding(two.check(claimed), 2, reason, "FC-OUT-01", 3);
    };
    expect_reason(Rational(1, 2), FindingReason::kWrongPosition);
    expect_reason(Rational(1, 1LL << 43), FindingReason::kWrongPosition);
    expect_reason(Rational(1, 1LL << 44), FindingReason::kRounding);
  }
}

TEST(CheckTest, FindsOutWhatIsClaimedByPosition) {
  CITES("FC-CLAIM-05");
  const Truly triangle({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}});
  Claimed claimed;
  for (std::size_t i = 0; i < triangle.truth->size(); ++i) {
    claimed.at(triangle.truth->index(i).face_dimension, decimals(triangle.truth->sphere(i).center));
  }
  const CheckReport right = triangle.check(claimed);
  EXPECT_EQ(right.verdict, Verdict::kConforms) << text(right);
  EXPECT_FALSE(right.is_exact);
  claimed.at(2, decimals({1, 1, 1}));
  expect_finding(triangle.check(claimed), 2, FindingReason::kWrongPosition, "FC-CRIT-01", 8);
  // Nearly a right triangle: the index-1 and the index-2 point are at the same place, but for 2^-40.
  const Truly nearly({{0, 0, 0}, {2, 0, 0}, {1, 1 + 0x1p-40, 0}});
  Claimed both;
  for (std::size_t i = 0; i < nearly.truth->size(); ++i) {
    both.at(nearly.truth->index(i).face_dimension, decimals(nearly.truth->sphere(i).center));
  }
  const CheckReport ambiguous = nearly.check(both);
  EXPECT_EQ(ambiguous.verdict, Verdict::kConformsWhereDetermined) << text(ambiguous);
  EXPECT_EQ(count(ambiguous, FindingReason::kAmbiguous), 2U);
  both.claim.points.pop_back();
  EXPECT_EQ(count(nearly.check(both), FindingReason::kMissing), 1U);
}

TEST(CheckTest, JudgesIncidences) {
  CITES("FC-CLAIM-06", "FC-FLOW-07", "FC-CHAIN-01");
  const Truly tetrahedron(kTetrahedron);
  const auto report = [&](const std::vector<ClaimedTarget>& targets) {
    Claimed claimed = tetrahedron.claim_without({{0, 1, 2}}).add(2, {0, 1, 2});
    claimed.last().successors = targets;
    return tetrahedron.check(claimed);
  };
  const Ids top = {0, 1, 2, 3};
  EXPECT_EQ(report({to(top), kInfinity}).verdict, Verdict::kConforms);
  EXPECT_EQ(report({kInfinity, to(top), to(top)}).verdict, Verdict::kConforms) << "a set";
  for (const auto& wrong : {std::vector<ClaimedTarget>{to(top)},
                            {kInfinity},
                            {},
                            {to({0, 1, 3}), kInfinity},
                            {to(top), kInfinity, to({0, 1, 3})}}) {
    expect_finding(report(wrong), 4, FindingReason::kWrongIncidence, "FC-FLOW-07", 15);
  }
  Claimed samples = tetrahedron.claim_without({{1}}).add(0, {1});
  samples.last().successors = {{to({0, 1}), to({1, 2}), to({1, 3})}};
  EXPECT_EQ(tetrahedron.check(samples).conforms[3], true);
  samples.last().successors->pop_back();
  expect_finding(tetrahedron.check(samples), 4, FindingReason::kWrongIncidence, "FC-FLOW-07", 15);
  Claimed edge = tetrahedron.claim_without({{0, 1}}).add(1, {0, 1});
  edge.last().successors = {{to({0, 1, 2}), to({0, 1, 3})}};
  const CheckReport upwards = tetrahedron.check(edge);
  EXPECT_EQ(upwards.conforms[3], true);
  EXPECT_TRUE(upwards.not_judged.empty());
  for (const auto& wrong : {std::vector<ClaimedTarget>{to({0, 1, 2})},
                            {to({0, 1, 2}), to({0, 2, 3})},
                            {to({0, 1, 2}), to({0, 1, 3}), to(top)},
                            {to({0, 1, 2}), to({0, 1, 3}), kInfinity},
                            {}}) {
    edge.last().successors = wrong;
    expect_finding(tetrahedron.check(edge), 4, FindingReason::kWrongIncidence, "FC-CHAIN-01", 15);
  }
}

// The verdict on a claim that has infinity above an edge without saddles above it.
CheckReport infinity_above(const Truly& points, const Ids& contact) {
  Claimed edge = points.claim_without({contact}).add(1, contact);
  edge.last().successors.emplace();
  const CheckReport nothing = points.check(edge);
  EXPECT_EQ(nothing.verdict, Verdict::kConforms);
  EXPECT_EQ(nothing.conforms[3], true);
  EXPECT_TRUE(nothing.not_judged.empty());
  edge.last().successors = {{kInfinity}};
  return points.check(edge);
}

// What leaves the edge of the second input ends at infinity, and at regular stationary points of both kinds.
TEST(CheckTest, InfinityIsAboveAnEdgeWhoseListLeadsThere) {
  CITES("FC-CLAIM-06", "FC-UNST-02");
  const Truly pair({{0, 0, 0}, {1, 0, 0}}), five({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}});
  for (const auto& [points, contact] : {std::pair(&pair, Ids{0, 1}), std::pair(&five, Ids{1, 2})}) {
    const CheckReport report = infinity_above(*points, contact);
    EXPECT_EQ(report.verdict, Verdict::kConforms);
    EXPECT_EQ(report.conforms[3], true);
    EXPECT_TRUE(report.not_judged.empty());
  }
  Claimed wrong = five.claim_without({{1, 2}}).add(1, {1, 2});
  wrong.last().successors = {{kInfinity, to({0, 1})}};
  expect_finding(five.check(wrong), 4, FindingReason::kWrongIncidence, "FC-CHAIN-01", wrong.last().line);
}

// All that leaves the edge 6 7 ends at regular stationary points.
TEST(CheckTest, APerturbationCanLeadFromAnEdgeToInfinity) {
  CITES("FC-CLAIM-06", "FC-CLAIM-07");
  const Truly points({{0, 2, 1}, {2, 0, 2}, {1, 0, 0}, {1, 2, 2}, {0, 0, 2}, {0, 2, 2}, {1, 0, 2}, {1, 1, 1}});
  const CheckReport report = infinity_above(points, {6, 7});
  EXPECT_EQ(report.verdict, Verdict::kPerturbed);
  expect_finding(report, 4, FindingReason::kSymbolicPerturbation, "FC-CLAIM-07", report.findings.back().line);
}

// The Voronoi cell of point 0 is a body that stands on one facet alone: the midpoint of 0 1 is the only point of its
// surface where the distance has a minimum, and all that leaves the midpoint ends at one maximum.
TEST(CheckTest, InfinityIsNotAboveAnEdgeWhoseListLeadsElsewhere) {
  CITES("FC-CLAIM-06", "FC-CONN-01");
  const Truly points({{0, 0, 0},
                      {0, 0, -200},
                      {306, 19, -328},
                      {-33, 312, -303},
                      {-321, 3, -292},
                      {47, -311, -302},
                      {752, 622, 22},
                      {-677, 673, -35},
                      {-647, -712, 39},
                      {706, -672, 9},
                      {1513, -14, 1375},
                      {102, 1457, 1526},
                      {-1382, -190, 1535},
                      {159, -1478, 1539}});
  const LambdaList list = points.truth->lambda_list(points.record_of({0, 1}));
  EXPECT_TRUE(list.directions.empty());
  ASSERT_EQ(list.arcs.size(), 1U);
  EXPECT_EQ(list.arcs[0], points.record_of({0, 10, 11, 12}));
  EXPECT_EQ(
      text(infinity_above(points, {0, 1})),
      "fails\n4 wrong-incidence FC-CLAIM-06: index 1, contact set 0 1, up to infinity; nothing that leaves it ends "
      "at infinity");
}

TEST(CheckTest, SeveralRowsOfAClassStandForItOnce) {
  CITES("FC-CLAIM-01");
  const Truly points({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(points.check(points.claim_without({{0, 1}}).add(1, {0, 2, 1})).verdict, Verdict::kConforms);
  EXPECT_EQ(points.check(points.claim_without({{0, 1}}).add(1, {2, 2, 1})).verdict, Verdict::kFails);
}

// From the triangle 0 1 2, one orbit ends at the regular stationary point of kind 2-3 above it.
TEST(CheckTest, PermitsOrbitsToGoOn) {
  CITES("FC-CLAIM-07", "FC-CLAIM-08");
  const Truly points(kKind23);
  std::optional<std::size_t> saddle;
  std::size_t side = 0;
  for (std::size_t i = 0; i < points.truth->size(); ++i) {
    if (points.truth->index(i) != StationaryIndex{2, 2}) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto limit = points.truth->limits(i).at(k);
      if (limit && !points.truth->index(*limit).is_critical()) saddle = i, side = k;
    }
  }
  ASSERT_TRUE(saddle.has_value());
  const Ids contact(points.truth->contact(*saddle).begin(), points.truth->contact(*saddle).end());
  const auto report = [&](const ClaimedTarget& target) {
    Claimed claimed = points.claim_without({contact}).add(2, contact);
    const auto other = points.truth->limits(*saddle).at(1 - side);
    EXPECT_FALSE(other.has_value());
    claimed.last().successors = {{target, kInfinity}};
    return points.check(claimed);
  };
  EXPECT_EQ(report(to({0, 1, 2, 3})).verdict, Verdict::kConforms);
  const CheckReport beyond = report(kInfinity);
  EXPECT_EQ(beyond.verdict, Verdict::kPerturbed) << text(beyond);
  expect_finding(beyond, 4, FindingReason::kSymbolicPerturbation, "FC-CLAIM-07", beyond.findings[0].line);
  EXPECT_EQ(beyond.not_judged.size(), 1U);
  EXPECT_EQ(report(to({0, 3})).verdict, Verdict::kFails) << "nothing below it";

  Claimed polylines = points.claim_without({contact}).add(2, contact);
  polylines.last().u2.emplace();
  for (std::size_t k = 0; k < 2; ++k) {
    ClaimedPolyline& line = polylines.last().u2->emplace_back();
    for (const TrueSegment& segment : points.truth->polyline(*saddle, k)) {
      line.push_back({segment.type, exactly(segment.driver), std::nullopt});
      if (segment.end) line.back().end = exactly(*segment.end);
    }
  }
  EXPECT_EQ(points.check(polylines).verdict, Verdict::kConforms);
  EXPECT_EQ(points.check(polylines).conforms[4], true);
  Claimed further = polylines;
  (*further.last().u2)[side].push_back({"V-E-inf", std::nullopt, std::nullopt});
  EXPECT_EQ(points.check(further).verdict, Verdict::kPerturbed);
  further = polylines;
  (*further.last().u2)[1 - side].push_back({"V-E-inf", std::nullopt, std::nullopt});
  expect_finding(points.check(further), 5, FindingReason::kWrongPolyline, "FC-CLAIM-08", further.last().line);
}

}  // namespace
}  // namespace flowcert::check_test
