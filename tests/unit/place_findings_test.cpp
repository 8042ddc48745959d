// check() on what a claim says of itself, and on which points it has where (levels 1 to 3). The claims are
// made by hand, and the reports are compared word for word.
#include <gtest/gtest.h>

#include "certify/finding_words.h"
#include "flowcert/reproducibility.h"
#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::place_findings_test {
namespace {

std::string said(const Truly& truly, const Claimed& claimed) { return text(truly.check(claimed)); }

Rational ten_to(int exponent) {
  Rational power = 1;
  for (int k = 0; k < exponent; ++k) power *= 10;
  return power;
}

// ---- Form

TEST(FormFindings, OfTheWhole) {
  CITES("FC-CLAIM-01", "FC-IN-03");
  const Truly points({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {3, 0, 0}});
  Claimed claimed = points.whole_claim();
  claimed.claim.merged_duplicates = 1;
  claimed.claim.classes = {{{1, 3}}};
  claimed.claim.critical_counts = {{3, 2, 0, 0}};
  claimed.claim.regular_counts = {{1, 0, 0}};
  EXPECT_EQ(said(points, claimed), "conforms");
  claimed.claim.merged_duplicates = 2;
  claimed.claim.classes->clear();
  claimed.claim.regular_counts = {{0, 0, 1}};
  EXPECT_EQ(said(points, claimed),
            "fails"
            "\n1 wrong-counts FC-IN-03: 2 merged duplicates; 1"
            "\n1 malformed FC-IN-03: other classes of repeated points; 1 classes of more than one row"
            "\n1 wrong-counts FC-CLAIM-01: 0 0 1 regular stationary points of kinds 1-2, 1-3, 2-3; the claim "
            "itself lists 1 0 0");
  Claimed other = points.whole_claim();
  other.claim.input_sha256 = coordinates_sha256(points.points);
  EXPECT_EQ(said(points, other), "conforms");
  std::ranges::reverse(*other.claim.input_sha256);
  EXPECT_TRUE(said(points, other).starts_with("fails\n1 malformed FC-CLAIM-01: a claim about the input with SHA-256 "));
}

TEST(FormFindings, OfIndicesAndKinds) {
  CITES("FC-CLAIM-01", "FC-CRIT-03");
  const Truly points(kTetrahedron);
  const auto added = [&](int index, const std::optional<int>& hull) {
    Claimed claimed = points.claim().add(index, {0, 1, 2, 3});
    claimed.last().hull_dimension = hull;
    claimed.claim.points.erase(claimed.claim.points.end() - 2);  // the right one
    return text(points.check(claimed, {.highest_level = 1}));
  };
  for (const int index : {-1, 4}) {
    EXPECT_EQ(added(index, {}), "fails\n1 malformed FC-CLAIM-01: index " + std::to_string(index) +
                                    ", contact set 0 1 2 3; an index is 0, 1, 2 or 3");
  }
  for (const auto& [index, hull] : {std::pair{0, 2}, {1, 1}, {2, 1}, {1, 4}, {3, 3}}) {
    EXPECT_EQ(added(index, hull), "fails\n1 malformed FC-CRIT-03: regular, kind " + std::to_string(index) + "-" +
                                      std::to_string(hull) +
                                      ", contact set 0 1 2 3; only the kinds 1-2, 1-3 and 2-3 exist");
  }
  for (const auto& [index, hull] : {std::pair{1, 2}, {2, 3}, {1, 3}}) EXPECT_EQ(added(index, hull), "conforms");
  EXPECT_EQ(text(points.check(points.claim().add(1, {}), {.highest_level = 1})),
            "fails\n1 malformed FC-CLAIM-01: index 1; neither a contact set nor a position");
}

TEST(FormFindings, OfWhatFlows) {
  CITES("FC-CLAIM-01");
  const Truly points(kTetrahedron);
  const auto fault = [&](const auto& change) {
    Claimed claimed = points.whole_claim();
    change(claimed.of({0, 1, 2}));
    const CheckReport report = points.check(claimed, {.highest_level = 1});
    EXPECT_EQ(report.findings.size(), 1U) << text(report);
    if (report.findings.size() != 1) return std::string();
    EXPECT_EQ(report.findings[0].reason, FindingReason::kMalformed);
    EXPECT_EQ(report.findings[0].clause, "FC-CLAIM-01");
    EXPECT_EQ(report.findings[0].line, 11U);
    return report.findings[0].truth;
  };
  using Point = ClaimedPoint;
  EXPECT_EQ(fault([](Point& point) { point.successors->front() = {false, {}}; }), "a successor without a contact set");
  EXPECT_EQ(fault([](Point& point) { point.successors->front() = to({0, 4}); }),
            "of a successor: there is no point 4; the ids are 0 to 3");
  EXPECT_EQ(fault([](Point& point) { point.successors->pop_back(); }), "there are two sides");
  EXPECT_EQ(fault([](Point& point) { point.samples = {{2, 0, 2}}; }), "of the samples: point 2 is named twice");
  EXPECT_EQ(fault([](Point& point) { point.u2->pop_back(); }), "an unstable manifold U2 has two orbits");
  EXPECT_EQ(fault([](Point& point) { point.stable->boundary->front().clear(); }),
            "of a stable set: a contact set without points");
  EXPECT_EQ(fault([](Point& point) { point.stable->walk = {{0, 1, 7}}; }),
            "of a stable set: there is no point 7; the ids are 0 to 3");
  EXPECT_EQ(fault([](Point& point) { point.skeleton->segments[0].samples = {1, 1}; }),
            "of a stable set: point 1 is named twice");
  EXPECT_EQ(fault([](Point& point) { point.skeleton->segments[1].front_contact = {{0, 5}}; }),
            "of a stable set: there is no point 5; the ids are 0 to 3");
  EXPECT_EQ(fault([](Point& point) { point.skeleton->segments[1].back_contact = Ids{}; }),
            "of a stable set: a contact set without points");
  EXPECT_EQ(fault([](Point& point) { point.skeleton->intervals.push_back({{{0, 1, 6}, {}, {}}, {}}); }),
            "of a stable set: there is no point 6; the ids are 0 to 3");
  EXPECT_EQ(fault([](Point& point) { point.skeleton->intervals.push_back({}); }),
            "of a stable set: a contact set without points");
}

TEST(FormFindings, OnlyToTheLevelThatIsAskedFor) {
  CITES("FC-CLAIM-03");
  const Truly points(kTetrahedron);
  Claimed claimed = points.whole_claim();
  claimed.of({0, 1}).samples = {{0, 3}};
  claimed.of({0, 1, 2}).stable->walk->pop_back();
  claimed.of({0, 1, 3}).stable->walk->pop_back();
  claimed.of({0, 2, 3}).center = exactly(RationalPoint{1, 2, 3});
  claimed.claim.points.erase(claimed.claim.points.begin());
  const std::array<std::size_t, 5> expected = {0, 1, 3, 4, 6};
  for (int level = 1; level <= kLevels; ++level) {
    const CheckReport report = points.check(claimed, {.highest_level = level});
    const auto at = static_cast<std::size_t>(level - 1);
    EXPECT_EQ(report.findings.size(), expected[at]) << text(report);
    for (std::size_t k = at + 1; k < 5; ++k) EXPECT_FALSE(report.conforms[k].has_value());
  }
  EXPECT_THROW((void)points.check(claimed, {.tolerance = 1.5}), InvalidInput);
}

// What is permitted is never told as what is wrong, even where it is about a point and the other is not.
TEST(FormFindings, TheTellingOneIsWrong) {
  CITES("FC-CLAIM-04");
  const Finding sum{3, FindingReason::kWrongCounts, false, "FC-INV-01", std::nullopt, {}, "", ""};
  const Finding denied{3, FindingReason::kSymbolicPerturbation, true, "FC-CLAIM-04", std::nullopt, {1, 2}, "", ""};
  Finding missing{3, FindingReason::kMissing, false, "FC-CLAIM-03", std::nullopt, {0, 1}, "", ""};
  EXPECT_EQ(certify::telling_finding({sum, denied}).reason, FindingReason::kWrongCounts);
  EXPECT_EQ(certify::telling_finding({sum, missing, denied}).reason, FindingReason::kMissing);
  missing.level = 4;
  EXPECT_EQ(certify::telling_finding({sum, missing}).reason, FindingReason::kWrongCounts);
}

// ---- At regular stationary points

TEST(PlaceFindings, OfRegularPoints) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04", "FC-CRIT-03");
  const Truly triangle(kRightTriangle), both(kKind13);
  EXPECT_EQ(said(triangle, triangle.claim().regular(1, 3, {0, 1, 2})),
            "fails\n3 wrong-index FC-CRIT-03: regular, kind 1-3, contact set 0 1 2; a regular stationary point "
            "of kind 1-2, contact set 0 1 2");
  EXPECT_EQ(said(triangle, triangle.claim().regular(2, 3, {0, 1, 2})),
            "fails\n3 wrong-index FC-CRIT-03: regular, kind 2-3, contact set 0 1 2; a regular stationary point "
            "of kind 1-2, contact set 0 1 2");
  const std::string incomplete = said(triangle, triangle.claim().regular(1, 2, {1, 2}));
  EXPECT_TRUE(
      incomplete.starts_with("fails\n2 contact-incomplete FC-CRIT-05 (c): regular, kind 1-2, contact set 1 2; "))
      << incomplete;
  EXPECT_EQ(said(triangle, triangle.claim().regular(1, 2, {0, 1, 2}).regular(1, 2, {0, 1, 2})),
            "fails\n3 claimed-twice FC-CRIT-06: regular, kind 1-2, contact set 0 1 2; claimed already in line 6");
  EXPECT_EQ(said(both, both.claim().regular(1, 3, {0, 1, 2, 3})), "conforms");
}

TEST(PlaceFindings, OfWhatAPerturbationWouldNotMake) {
  CITES("FC-CLAIM-21", "FC-CLAIM-04", "FC-CRIT-03");
  const Truly triangle(kRightTriangle);
  for (const auto& [index, names] : {std::pair{0, Ids{1, 2}}, {3, {0, 1, 2}}, {2, {1, 2}}, {1, {0, 1, 2}}}) {
    const CheckReport report = triangle.check(triangle.claim().add(index, names));
    EXPECT_EQ(count(report, FindingReason::kCollisionAsCritical), 1U) << text(report);
    EXPECT_NE(text(report).find("; no perturbation makes this of it"), std::string::npos) << text(report);
  }
}

// A position does not tell which of the two polygons of a kind 1-3 is meant. So a third claim repeats one of
// them.
TEST(PlaceFindings, OfPerturbedPointsByPosition) {
  CITES("FC-CLAIM-04", "FC-CLAIM-05");
  const Truly points(kKind13);
  const ClaimedPosition center = exactly(RationalPoint{0, 0, 0});
  const auto all = [&] { return points.claim().at(1, center).at(2, center).at(2, center).at(3, center); };
  EXPECT_EQ(points.check(all()).verdict, Verdict::kPerturbed);
  EXPECT_EQ(count(points.check(all()), FindingReason::kSymbolicPerturbation), 4U);
  const CheckReport thrice = points.check(all().at(2, center));
  EXPECT_EQ(count(thrice, FindingReason::kClaimedTwice), 1U) << text(thrice);
  EXPECT_EQ(points.check(points.claim().at(1, center).at(2, center)).verdict, Verdict::kPerturbed);
  // One polygon is claimed by position, the other by a contact set.
  EXPECT_EQ(points.check(points.claim().add(1, {0, 1}).at(2, center).add(2, {0, 1, 2}).at(3, center)).verdict,
            Verdict::kPerturbed);
  Claimed regular = points.claim().at(1, center);
  regular.last().hull_dimension = 3;
  EXPECT_EQ(said(points, regular), "conforms");
  regular.last().hull_dimension = 2;
  EXPECT_EQ(count(points.check(regular), FindingReason::kWrongIndex), 1U);
}

// The edge 0 1 of a tetrahedron with the centre in its middle: the angle between the triangles there decides.
TEST(PlaceFindings, OfSimplicesByTheirAngle) {
  CITES("FC-CLAIM-04");
  const Truly right(kKind13), acute({{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, 3, 4}}),
      obtuse({{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, -3, 4}});
  const auto verdict = [](const Truly& truly, const std::vector<Ids>& simplices) {
    Claimed claimed = truly.claim();
    for (const Ids& names : simplices) claimed.add(static_cast<int>(names.size()) - 1, names);
    return truly.check(claimed);
  };
  const Ids edge = {0, 1}, one = {0, 1, 2}, other = {0, 1, 3}, whole = {0, 1, 2, 3};
  for (const Truly* truly : {&right, &acute, &obtuse}) {
    const CheckReport all = verdict(*truly, {edge, one, other, whole});
    EXPECT_EQ(all.verdict, Verdict::kPerturbed) << text(all);
    EXPECT_TRUE(all.not_decided.empty());
    for (const std::vector<Ids>& never : {std::vector<Ids>{edge},
                                          {one},
                                          {whole},
                                          {edge, whole},
                                          {one, other},
                                          {edge, one, other},
                                          {one, other, whole},
                                          {edge, one, whole}}) {
      EXPECT_EQ(verdict(*truly, never).verdict, Verdict::kFails);
    }
    for (const Ids& triangle : {one, other}) {
      EXPECT_EQ(verdict(*truly, {edge, triangle}).verdict, truly == &obtuse ? Verdict::kFails : Verdict::kPerturbed);
      EXPECT_EQ(verdict(*truly, {triangle, whole}).verdict, truly == &acute ? Verdict::kFails : Verdict::kPerturbed);
    }
  }
}

// What one perturbation makes of a contact set that is no simplex: half an octahedron, a trapezoid with its centre on
// the longest edge, a square, and a cube. The indices were computed, after the points had been moved.
TEST(PlaceFindings, OfWhatIsNoSimplex) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04");
  const Truly half({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
  const Truly flat({{-5, 0, 0}, {5, 0, 0}, {3, 4, 0}, {-3, 4, 0}});
  const Truly square({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
  const Truly cube(kCube);
  const auto expect_undecided = [](const Truly& truly, const Claimed& claimed, std::size_t points) {
    const CheckReport report = truly.check(claimed);
    EXPECT_EQ(report.verdict, Verdict::kPerturbed) << text(report);
    EXPECT_EQ(report.not_decided.size(), 1U);
    EXPECT_EQ(count(report, FindingReason::kSymbolicPerturbation), points);
    for (const Finding& finding : report.findings) EXPECT_FALSE(finding.is_decided);
  };
  const auto of_half = [&] {
    return half.claim().add(1, {0, 1}).add(2, {0, 1, 2}).add(2, {0, 1, 3}).add(3, {0, 1, 2, 4}).add(3, {0, 1, 3, 4});
  };
  expect_undecided(half, of_half().add(2, {0, 1, 4}), 6);
  EXPECT_EQ(half.check(of_half()).verdict, Verdict::kFails) << "the alternating sum";
  EXPECT_EQ(half.check(of_half().add(2, {0, 1, 2})).verdict, Verdict::kFails) << "a point twice";
  EXPECT_EQ(half.check(of_half().add(2, {0, 2, 4})).verdict, Verdict::kFails) << "the centre outside";
  expect_undecided(flat, flat.claim().add(1, {0, 1}).add(2, {0, 1, 2}).add(2, {0, 1, 3}).add(3, {0, 1, 2, 3}), 4);
  EXPECT_EQ(flat.check(flat.claim().add(2, {0, 1, 2}).add(3, {0, 1, 2, 3}).add(1, {2, 3})).verdict, Verdict::kFails);
  const auto of_square = [&] {
    return square.claim_without({{0, 1, 2, 3}}).add(1, {0, 1}).add(2, {0, 1, 2}).add(2, {0, 1, 3});
  };
  expect_undecided(square, of_square(), 3);
  // All four points may come to be the corners of a flat tetrahedron.
  expect_undecided(square, of_square().add(1, {2, 3}).add(2, {0, 2, 3}).add(2, {1, 2, 3}).add(3, {0, 1, 2, 3}), 7);
  // If all of the square stays together, there are no diagonals.
  EXPECT_EQ(square.check(of_square().add(2, {0, 1, 2, 3}).add(1, {2, 3})).verdict, Verdict::kFails);
  EXPECT_EQ(square.check(square.claim().add(1, {0, 1})).verdict, Verdict::kFails);
  EXPECT_EQ(
      square
          .check(square.claim_without({{0, 1, 2, 3}}).add(1, {0, 1}).add(1, {2, 3}).add(2, {0, 1, 2}).add(2, {0, 1, 3}))
          .verdict,
      Verdict::kFails);
  // Four corners of a cube in a plane through its centre, alone.
  const Ids all = {0, 1, 2, 3, 4, 5, 6, 7};
  expect_undecided(cube, cube.claim_without({all}).add(3, {0, 1, 6, 7}), 1);
  EXPECT_EQ(cube.check(cube.claim_without({all}).add(2, {0, 1, 6})).verdict, Verdict::kFails) << "the sum";
  EXPECT_EQ(cube.check(cube.claim_without({all}).add(1, {0, 7})).verdict, Verdict::kFails) << "no index 3";
  // That plane is not the plane of a face, so its four corners do not stay together as a polygon.
  EXPECT_EQ(
      cube.check(cube.claim_without({all}).add(2, {0, 1, 6, 7}).add(3, {0, 1, 2, 7}).add(3, {0, 1, 4, 7})).verdict,
      Verdict::kFails);
  // By position alone, two opposite samples make an index-1 point possible.
  const auto at_center = [&](const Truly& truly, const RationalPoint& x, const std::vector<int>& indices) {
    Claimed claimed = truly.claim_without({{0, 1, 2, 3}, all});
    for (const int index : indices) claimed.at(index, exactly(x));
    return truly.check(claimed).verdict;
  };
  EXPECT_EQ(at_center(square, {0, 0, 0}, {1, 2, 2}), Verdict::kPerturbed);
  EXPECT_EQ(at_center(square, {0, 0, 0}, {2, 2}), Verdict::kFails);
  const Truly kite({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {4, 3, 0}});
  EXPECT_EQ(at_center(kite, {0, 0, 0}, {2}), Verdict::kConforms);
  EXPECT_EQ(at_center(kite, {0, 0, 0}, {1, 2, 2}), Verdict::kFails);
}

// There are no more points of index 1 than pairs of opposite samples, and tetrahedra do not overlap.
TEST(PlaceFindings, OfWhatCannotBeTogether) {
  CITES("FC-CLAIM-04");
  const Truly five({{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}});
  const ClaimedPosition middle = exactly(RationalPoint{Rational(1, 2), Rational(1, 2), Rational(1, 2)});
  EXPECT_EQ(five.check(five.claim().at(1, middle).at(2, middle)).verdict, Verdict::kPerturbed);
  EXPECT_EQ(five.check(five.claim().at(1, middle).at(1, middle).at(2, middle).at(2, middle)).verdict, Verdict::kFails);
  EXPECT_EQ(five.check(five.claim().add(1, {2, 3}).at(1, middle).at(2, middle).at(2, middle)).verdict, Verdict::kFails);
  const Truly cube(kCube);
  const Ids all = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto instead = [&] { return cube.claim_without({all}); };
  // One tetrahedron at most can have the centre inside. The whole and a diagonal exclude each other, too.
  EXPECT_EQ(cube.check(instead().add(3, {0, 3, 5, 6}).add(3, {1, 2, 4, 7}).add(2, {0, 1, 7})).verdict, Verdict::kFails);
  EXPECT_EQ(cube.check(instead().add(3, all).add(1, {0, 7}).add(2, {0, 1, 7})).verdict, Verdict::kFails);
  EXPECT_EQ(cube.check(instead().add(3, {0, 1, 2, 7}).add(3, {0, 1, 4, 7}).add(2, {0, 1, 7})).verdict,
            Verdict::kPerturbed);
  // A corner of the cube, in place of the second tetrahedron, overlaps with nothing, but the centre is outside of it.
  EXPECT_EQ(cube.check(instead().add(3, {0, 1, 2, 7}).add(3, {0, 4, 5, 6}).add(2, {0, 1, 7})).verdict, Verdict::kFails);
}

// A claim that counts or lists regular stationary points denies those that it leaves out. Another says nothing of them.
TEST(PlaceFindings, OfRegularPointsThatAreDenied) {
  CITES("FC-CLAIM-01", "FC-CLAIM-04");
  const Truly triangle(kRightTriangle);
  Claimed denied = triangle.claim();
  EXPECT_EQ(said(triangle, denied), "conforms");
  denied.claim.regular_counts = {{0, 0, 0}};
  EXPECT_EQ(
      said(triangle, denied),
      "perturbed\n3 symbolic-perturbation FC-CLAIM-04: no regular stationary point; a regular stationary point of "
      "kind 1-2, contact set 0 1 2");
  denied.regular(1, 2, {0, 1, 2});
  EXPECT_EQ(count(triangle.check(denied), FindingReason::kWrongCounts), 1U);
  denied.claim.regular_counts = {{1, 0, 0}};
  EXPECT_EQ(said(triangle, denied), "conforms");
  // One of two is listed.
  const Truly two({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {100, 7, 50}, {103, 7, 50}, {100, 11, 50}});
  Claimed one = two.claim().regular(1, 2, {0, 1, 2});
  EXPECT_EQ(count(two.check(one), FindingReason::kSymbolicPerturbation), 1U);
  EXPECT_EQ(said(two, one.regular(1, 2, {3, 4, 5})), "conforms");
}

// ---- Positions and distances

TEST(PlaceFindings, OfAnArcOfSamples) {
  CITES("FC-CRIT-05");
  const Truly arc({{25, 0, 0}, {24, 7, 0}, {20, 15, 0}, {15, 20, 0}});
  EXPECT_EQ(text(arc.check(arc.claim().add(2, {0, 1, 2}), {.highest_level = 2})),
            "fails\n2 contact-incomplete FC-CRIT-05 (c): index 2, contact set 0 1 2; point 3 lies on the sphere "
            "too, and the centre outside the hull of all of them");
  EXPECT_EQ(text(arc.check(arc.claim().add(2, {0, 1, 2, 3}), {.highest_level = 2})),
            "fails\n2 outside-hull FC-CRIT-05 (d): index 2, contact set 0 1 2 3; the centre 0 0 0 lies outside "
            "the hull of the contact set");
}

TEST(PlaceFindings, OfValuesBeyondDoubles) {
  CITES("FC-CLAIM-05", "FC-OUT-01");
  const Truly points({{0, 0, 0}, {2, 0, 0}});
  const Rational huge = ten_to(400);
  const auto with = [&](const auto& change) { return said_of(points, {0, 1}, change); };
  const std::string start = "fails\n2 wrong-position FC-OUT-01: index 1, contact set 0 1, ";
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.center = exactly(RationalPoint{huge, -huge, 0}); }),
            start + "centre > 1.8e308 < -1.8e308 0; the centre is 1 0 0, farther away than doubles reach");
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.center = decimals({-huge, huge, 0}); }),
            start + "centre < -1.8e308 > 1.8e308 0; the centre is 1 0 0, farther away than doubles reach");
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.squared_distance = decimal(huge); }),
            start + "squared distance > 1.8e308; the squared distance is 1");
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.squared_distance = number(huge); }),
            start + "squared distance > 1.8e308; the squared distance is 1");
  for (const Rational& x : {huge, Rational(-huge)}) {
    EXPECT_EQ(text(points.check(points.claim().at(1, decimals({x, 0, 0})), {.highest_level = 2})),
              std::string("fails\n2 wrong-position FC-CRIT-01: index 1, at ") + (x > 0 ? ">" : "< -") +
                  (x > 0 ? " 1.8e308" : "1.8e308") +
                  " 0 0; no stationary point is there, or within the tolerance of it; the nearest one of that index "
                  "has the contact set 0 1 and is at 1 0 0, farther away than doubles reach");
  }
  EXPECT_EQ(text(Truly({}).check(Claimed().at(0, decimals({1, 2, 3})), {.highest_level = 2})),
            "fails\n2 wrong-position FC-CRIT-01: index 0, at 1 2 3; no stationary point is there, or within the "
            "tolerance of it; there is none of that index");
}

// A decimal is told as it was written.
TEST(PlaceFindings, SayHowWrongAPositionIs) {
  CITES("FC-CLAIM-05", "FC-CRIT-01", "FC-OUT-01");
  const Truly square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const auto by_position = [&](int index, const ClaimedPosition& position) {
    const CheckReport report = square.check(Claimed().at(index, position), {.highest_level = 2});
    return report.findings.at(0).claimed + "; " + report.findings.at(0).truth;
  };
  const std::string none = "; no stationary point is there, or within the tolerance of it; ";
  EXPECT_EQ(by_position(2, decimals({Rational(1, 2) + Rational(1, 10'000'000), Rational(1, 2), 0})),
            "index 2, at 0.5000001 0.5 0" + none +
                "the nearest one of that index has the contact set 0 1 2 3 and is at 1/2 1/2 0, 1e-07 away, 141 times "
                "the tolerance");
  EXPECT_EQ(by_position(1, exactly({1, Rational(3, 4), -2})),
            "index 1, at 1 3/4 -2" + none +
                "the nearest one of that index has the contact set 1 2 and is at 1 1/2 0, 2.02 away");
  EXPECT_EQ(by_position(3, decimals({1, 1, 1})), "index 3, at 1 1 1" + none + "there is none of that index");
  const auto with_center = [&](const ClaimedPosition& position) {
    return said_of(square, {0, 1, 2, 3}, [&](ClaimedPoint& point) { point.center = position; });
  };
  const std::string start = "fails\n2 wrong-position FC-OUT-01: index 2, contact set 0 1 2 3, centre ";
  EXPECT_EQ(with_center(decimals({Rational(-25, 100), Rational(1, 2), 0})),
            start + "-0.25 0.5 0; the centre is 1/2 1/2 0, 0.75 away, 1.06e+09 times the tolerance");
  EXPECT_EQ(with_center(exactly({Rational(1, 4), Rational(1, 2), 0})),
            start + "1/4 1/2 0; the centre is 1/2 1/2 0, 0.25 away");
}

// ---- Claims of some indices

TEST(FormFindings, OfIndicesThatAreNotClaimed) {
  CITES("FC-CLAIM-12");
  const Truly triangle(kRightTriangle);
  Claimed claimed = triangle.whole_claim();
  claimed.claim.indices = ClaimedIndices{false, true, true, true};
  claimed.claim.critical_counts = {{9, 2, 0, 0}};
  const CheckReport report = triangle.check(claimed);
  EXPECT_EQ(count(report, FindingReason::kMalformed), 3U) << text(report);
  EXPECT_EQ(report.findings.size(), 3U) << text(report);
  EXPECT_EQ(report.findings[0].clause, "FC-CLAIM-12");
  EXPECT_EQ(report.findings[0].truth, "the claim's header says that it is of other indices");
  std::erase_if(claimed.claim.points, [](const ClaimedPoint& point) { return point.index == 0; });
  EXPECT_EQ(text(triangle.check(claimed)),
            "conforms\nnot judged: which critical points of index 0 there are, and what rests on them (FC-CLAIM-12)"
            "\nnot judged: the Euler sum");
  // What a perturbation makes of the hypotenuse is not all claimed.
  Claimed pair = triangle.claim();
  std::erase_if(pair.claim.points, [](const ClaimedPoint& point) { return point.index != 2; });
  pair.add(2, {0, 1, 2});
  CheckOptions options;
  options.indices = {false, false, true, true};
  EXPECT_EQ(triangle.check(pair, options).verdict, Verdict::kPerturbed);
  EXPECT_EQ(triangle.check(pair).verdict, Verdict::kFails);
}

TEST(PlaceFindings, OfDistances) {
  CITES("FC-CLAIM-05", "FC-OUT-01");
  const Truly points({{0, 0, 0}, {2, 0, 0}});
  const auto with = [&](const auto& change) { return said_of(points, {0, 1}, change); };
  const std::string start = "fails\n2 wrong-position FC-OUT-01: index 1, contact set 0 1, ";
  const std::string rounding = "fails\n2 rounding FC-OUT-01: index 1, contact set 0 1, ";
  const std::string end = "; the squared distance is 1";
  const Rational tiny = Rational(1) / (Rational(1 << 30) * Rational(1 << 22));
  EXPECT_EQ(with([](ClaimedPoint& point) { point.distance = number(1); }), "conforms");
  EXPECT_EQ(with([](ClaimedPoint& point) { point.distance = number(-1); }), start + "distance -1" + end);
  EXPECT_EQ(with([](ClaimedPoint& point) { point.squared_distance = number(-1); }),
            start + "squared distance -1" + end);
  EXPECT_EQ(with([](ClaimedPoint& point) { point.squared_distance = decimal(2); }), start + "squared distance 2" + end);
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.squared_distance = number(1 + tiny); }),
            rounding + "squared distance ~1.0000000000000002" + end);
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.squared_distance = number(1 + 1000 * tiny); }),
            start + "squared distance ~1.000000000000222" + end)
      << "more than rounding explains";
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.squared_distance = decimal(1 + tiny); }), "conforms");
  // The claimed squared distance is off by all of the radius.
  Claimed nothing = points.claim();
  nothing.last().squared_distance = decimal(0);
  EXPECT_EQ(points.check(nothing, {.tolerance = 1}).verdict, Verdict::kConforms);
  EXPECT_EQ(points.check(nothing, {.tolerance = 0.5}).verdict, Verdict::kFails);
  // What is exact is not right because it rounds to the right double.
  EXPECT_EQ(with([&](ClaimedPoint& point) { point.center = {number(1 + tiny / 256), number(0), number(0)}; }),
            "fails\n2 rounding FC-OUT-01: index 1, contact set 0 1, centre ~1 0 0; the centre is 1 0 0, 8.67e-19 away");
  // A position that is partly exact and partly in decimals is approximate.
  Claimed mixed = points.claim();
  mixed.last().center = {number(1), decimal(0), number(0)};
  EXPECT_FALSE(points.check(mixed).is_exact);
  EXPECT_EQ(points.check(mixed).verdict, Verdict::kConforms);
  mixed.last().center = {number(2), decimal(0), number(0)};
  EXPECT_EQ(points.check(mixed).verdict, Verdict::kFails) << "what is exact has no tolerance";
}

// The radius of the cube's sphere is 0.866025...
TEST(PlaceFindings, AsFarAsTheToleranceGoes) {
  CITES("FC-CLAIM-05");
  const Truly cube(kCube);
  const auto verdict = [&](const Rational& off) {
    Claimed claimed = cube.claim_without({{0, 1, 2, 3, 4, 5, 6, 7}});
    claimed.at(3, decimals({Rational(1, 2), Rational(1, 2), Rational(1, 2) + off}));
    return cube.check(claimed, {.tolerance = 0.01}).verdict;
  };
  for (const int sign : {-1, 1}) {
    EXPECT_EQ(verdict(Rational(sign * 866, 100000)), Verdict::kConforms);
    EXPECT_EQ(verdict(Rational(sign * 867, 100000)), Verdict::kFails);
  }
}

// Two places look the same. Each claim finds a place of its own while there is one.
TEST(PlaceFindings, OfAmbiguousPositions) {
  CITES("FC-CLAIM-05");
  const Truly nearly({{0, 0, 0}, {2, 0, 0}, {1, 1 + 0x1p-40, 0}});
  const auto claim = [&](const std::vector<int>& indices) {
    Claimed claimed = nearly.claim_without({{0, 1}, {0, 1, 2}});
    for (const int index : indices) claimed.at(index, decimals({1, 0, 0}));
    return nearly.check(claimed);
  };
  EXPECT_EQ(count(claim({1, 2}), FindingReason::kAmbiguous), 2U) << text(claim({1, 2}));
  EXPECT_EQ(claim({1, 2}).verdict, Verdict::kConformsWhereDetermined);
  EXPECT_EQ(claim({2, 1}).verdict, Verdict::kConformsWhereDetermined);
  const CheckReport again = claim({1, 2, 1});
  EXPECT_EQ(count(again, FindingReason::kClaimedTwice), 1U) << text(again);
  // A claim too many does not take the place of another index.
  const CheckReport early = claim({1, 1, 2});
  EXPECT_EQ(count(early, FindingReason::kClaimedTwice), 1U) << text(early);
  EXPECT_EQ(count(early, FindingReason::kWrongIndex), 0U) << text(early);
  const CheckReport wrong = claim({1, 3});
  EXPECT_EQ(wrong.verdict, Verdict::kFails);
  // A claim that is exactly at one of the places means that place.
  Claimed exact = nearly.claim_without({{0, 1}});
  exact.at(1, exactly(RationalPoint{1, 0, 0}));
  EXPECT_EQ(said(nearly, exact), "conforms");
}

// Claims by contact set take part in the matching, so the position means the other diagonal, which is farther away.
TEST(PlaceFindings, APositionIsWhatNoOtherClaimHasTaken) {
  CITES("FC-CLAIM-05", "FC-CLAIM-24");
  const Truly points({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0x1p-13}, {0, -1, 0x1p-13}});
  const ClaimedPosition position = decimals({0, 0, Rational(1, 100'000)});
  const auto report_on = [&](const std::vector<Ids>& by_contact, int by_position) {
    Claimed claimed = points.claim_without({{0, 1}, {2, 3}});
    for (int k = 0; k < by_position; ++k) claimed.at(1, position);
    for (const Ids& contact : by_contact) claimed.add(1, contact);
    return points.check(claimed, {.tolerance = 1e-3});
  };
  ASSERT_EQ(points.truth->index(points.record_of({2, 3})).face_dimension, 1);
  for (const Ids& contact : {Ids{0, 1}, Ids{2, 3}}) {
    const CheckReport report = report_on({contact}, 1);
    EXPECT_EQ(report.verdict, Verdict::kConformsWhereDetermined) << text(report);
    EXPECT_EQ(count(report, FindingReason::kAmbiguous), 1U) << text(report);
  }
  EXPECT_EQ(report_on({}, 2).verdict, Verdict::kConformsWhereDetermined);
  EXPECT_EQ(report_on({}, 1).verdict, Verdict::kFails);
  EXPECT_EQ(count(report_on({{0, 1}, {2, 3}}, 1), FindingReason::kClaimedTwice), 1U);
  // The point of index 3 in the middle between them is nearer.
  const CheckReport third = points.check(points.claim().at(1, decimals({0, 0, 0x1p-14})), {.tolerance = 1e-3});
  EXPECT_EQ(count(third, FindingReason::kClaimedTwice), 1U) << text(third);
  // It may be either of its index, so what it says of itself further on is not judged.
  Claimed claimed = points.claim_without({{2, 3}}).at(1, position);
  claimed.last().samples = {{0, 2}};
  const CheckReport report = points.check(claimed, {.tolerance = 1e-3});
  EXPECT_EQ(report.verdict, Verdict::kConformsWhereDetermined) << text(report);
  EXPECT_EQ(report.not_judged.size(), 1U) << text(report);
  EXPECT_FALSE(report.conforms[3].has_value());
}

// The distance tells which of two points of one index is meant, and then it is followed.
TEST(PlaceFindings, ADistanceTellsWhichPointIsMeant) {
  CITES("FC-CLAIM-24");
  constexpr double kFar = 1 + 0x1p-28;
  const Truly points({{1, 0, 0}, {-1, 0, 0}, {0, kFar, 0x1p-13}, {0, -kFar, 0x1p-13}});
  const auto report_on = [&](const std::vector<std::pair<double, Ids>>& distances_and_samples) {
    Claimed claimed = points.claim_without({{0, 1}, {2, 3}});
    for (const auto& [distance, samples] : distances_and_samples) {
      claimed.at(1, decimals({0, 0, Rational(1, 20'000)}));
      claimed.last().distance = number(Rational(distance));
      claimed.last().samples = samples;
    }
    return points.check(claimed, {.tolerance = 1e-3});
  };
  ASSERT_EQ(points.truth->index(points.record_of({2, 3})), (StationaryIndex{1, 1}));
  const std::pair<double, Ids> near{1, {0, 1}}, far{kFar, {2, 3}};
  for (const auto& both : {std::vector{near, far}, {far, near}}) {
    const CheckReport right = report_on(both);
    EXPECT_EQ(right.verdict, Verdict::kConformsWhereDetermined) << text(right);
    EXPECT_TRUE(right.not_judged.empty()) << text(right);
  }
  EXPECT_EQ(count(report_on({near, {kFar, {0, 1}}}), FindingReason::kWrongIncidence), 1U);
  EXPECT_EQ(report_on({near, near}).verdict, Verdict::kFails);
  EXPECT_EQ(count(report_on({near, {1.5, {2, 3}}}), FindingReason::kWrongPosition), 1U);
}

// A plain 0 is a decimal. The exact coordinates beside it exclude all but one of the points that are near.
TEST(PlaceFindings, OfADecimalBesideExactCoordinates) {
  CITES("FC-CLAIM-05");
  const Truly nearly({{0, 0, 0}, {2, 0, 0}, {1, 1 + 0x1p-46, 0}});
  const RationalPoint center = nearly.truth->sphere(nearly.record_of({0, 1, 2})).center;
  Claimed claimed = nearly.claim_without({{0, 1, 2}});
  claimed.at(2, {number(center[0]), number(center[1]), decimal(0)});
  EXPECT_EQ(said(nearly, claimed), "conforms");
  claimed.last().center = ClaimedPosition{number(center[0]), number(2 * center[1]), decimal(0)};
  EXPECT_EQ(nearly.check(claimed).verdict, Verdict::kFails);
}

// Points that are claimed wrongly, or a second time, are not followed any further.
TEST(PlaceFindings, OnlyRightPointsAreFollowed) {
  CITES("FC-CLAIM-06", "FC-CLAIM-08");
  const Truly points(kTetrahedron);
  Claimed claimed = points.whole_claim();
  ClaimedPoint again = claimed.of({0, 1, 2});
  again.line = claimed.claim.points.size() + 1;
  again.u2->front().clear();
  again.successors->clear();
  again.successors_by_side = false;
  again.stable->segments = 9;
  claimed.claim.points.push_back(again);
  const CheckReport report = points.check(claimed);
  for (const Finding& finding : report.findings) EXPECT_EQ(finding.level, 3) << text(report);
  EXPECT_EQ(count(report, FindingReason::kClaimedTwice), 1U);
}

}  // namespace
}  // namespace flowcert::place_findings_test
