// check() on incidences and boundaries (level 4): each claim is true but for one change, and the whole report
// is compared, word for word.
#include <gtest/gtest.h>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::incidence_findings_test {
namespace {

using Targets = std::vector<ClaimedTarget>;

// The report on a claim that is true but for one change. It has no polylines, because these would tell the limits
// again.
template <typename Change>
std::string said(const Truly& truly, const Change& change) {
  Claimed claimed = truly.whole_claim();
  for (ClaimedPoint& point : claimed.claim.points) point.u2.reset();
  change(claimed);
  return text(truly.check(claimed));
}

std::string said_of_targets(const Truly& truly, const Ids& contact, const Targets& targets) {
  return said(truly, [&](Claimed& claimed) {
    claimed.of(contact).successors = targets;
    claimed.of(contact).successors_by_side = false;
  });
}

std::string said_of_boundary(const Truly& truly, const Ids& contact, const std::vector<Ids>& boundary) {
  return said(truly, [&](Claimed& claimed) { claimed.of(contact).stable->boundary = boundary; });
}

TEST(IncidenceFindings, NoneOfWhatIsTrue) {
  CITES("FC-CLAIM-06", "FC-CLAIM-08", "FC-CLAIM-10");
  for (const auto* rows :
       {&kCube, &kTetrahedron, &kRightTriangle, &kKind23, &kKind13, &kArch, &kArchToRegular, &kRegularBack}) {
    EXPECT_EQ(said(Truly(*rows), [](Claimed&) {}), "conforms");
  }
}

TEST(IncidenceFindings, NothingFlowsFromAMaximum) {
  CITES("FC-CLAIM-06", "FC-FLOW-03");
  const Truly points(kTetrahedron);
  const Ids top = {0, 1, 2, 3};
  EXPECT_EQ(said_of_targets(points, top, {kInfinity}), "conforms");
  EXPECT_EQ(said_of_targets(points, top, {kInfinity, to({0, 1})}),
            "fails\n4 wrong-incidence FC-FLOW-03: index 3, contact set 0 1 2 3, up to 0 1; "
            "nothing flows from a maximum");
}

TEST(IncidenceFindings, SamplesOfAnEdge) {
  CITES("FC-CLAIM-04", "FC-FLOW-07");
  const Truly points(kTetrahedron), triangle(kRightTriangle);
  EXPECT_EQ(said(points, [](Claimed& claimed) { claimed.of({0, 1}).samples = {{0, 2}}; }),
            "fails\n4 wrong-incidence FC-FLOW-07: index 1, contact set 0 1, samples 0 2; "
            "the stable manifold is the segment between the two points of the contact set");
  // These are samples of the edge that a perturbation makes critical.
  const auto perturbed = [&](const Ids& samples) {
    Claimed claimed = triangle.claim().add(2, {0, 1, 2}).add(1, {1, 2});
    claimed.last().samples = samples;
    return text(triangle.check(claimed));
  };
  const std::string permitted =
      "\n2 symbolic-perturbation FC-CLAIM-04: index 2, contact set 0 1 2; a regular stationary point of kind "
      "1-2, contact set 0 1 2"
      "\n2 symbolic-perturbation FC-CLAIM-04: index 1, contact set 1 2; a regular stationary point of kind "
      "1-2, contact set 0 1 2";
  EXPECT_EQ(perturbed({1, 2}), "perturbed" + permitted);
  EXPECT_EQ(perturbed({0, 2}),
            "fails" + permitted +
                "\n4 wrong-incidence FC-FLOW-07: index 1, contact set 1 2, samples 0 2; the stable manifold is "
                "the segment between the two points of the contact set");
  // If a position is claimed instead of an edge, it must be the middle of the samples.
  Claimed by_position = triangle.claim().add(2, {0, 1, 2}).at(1, exactly(RationalPoint{Rational(3, 2), 2, 0}));
  by_position.last().samples = {{1, 2}};
  EXPECT_EQ(triangle.check(by_position).verdict, Verdict::kPerturbed) << text(triangle.check(by_position));
  by_position.last().samples = {{0, 2}};
  EXPECT_EQ(count(triangle.check(by_position), FindingReason::kWrongIncidence), 1U);
}

TEST(IncidenceFindings, EdgesOfASample) {
  CITES("FC-CLAIM-04", "FC-CLAIM-06", "FC-FLOW-07");
  const Truly obtuse({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}});
  EXPECT_EQ(said_of_targets(obtuse, {0}, {to({0, 2}), to({0, 2})}), "conforms");
  EXPECT_EQ(said_of_targets(obtuse, {0}, {to({1, 2}), to({0, 1})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 0; "
            "it is an end also of 0 2; it is no end of 1 2, 0 1");
  EXPECT_EQ(said_of_targets(obtuse, {2}, {kInfinity, to({0, 2}), to({1, 2})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 2; it is no end of infinity");
  EXPECT_EQ(said_of_targets(obtuse, {2}, {}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 2; it is an end also of 0 2, 1 2");
  const auto by_position = [&](const Targets& targets) {
    return said(obtuse, [&](Claimed& claimed) {
      claimed.of({2}).successors = targets;
      claimed.of({2}).center = exactly(RationalPoint{2, 1, 0});
      claimed.of({2}).contact.clear();
    });
  };
  EXPECT_EQ(by_position({to({0, 2}), to({1, 2})}), "conforms");
  EXPECT_EQ(by_position({to({0, 2})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, at 2 1 0; it is an end also of 1 2");
}

TEST(IncidenceFindings, EdgesThatAPerturbationMakes) {
  CITES("FC-CLAIM-04");
  const Truly triangle(kRightTriangle), high(kKind23);
  Claimed perturbed = triangle.claim().add(2, {0, 1, 2}).add(1, {1, 2});
  perturbed.of({1}).successors = {{to({0, 1}), to({1, 2})}};
  EXPECT_NE(text(triangle.check(perturbed))
                .find("\n4 symbolic-perturbation FC-CLAIM-04: index 0, contact set 1; a perturbation makes some of the "
                      "edges"),
            std::string::npos);
  EXPECT_EQ(triangle.check(perturbed).verdict, Verdict::kPerturbed);
  // Nobody may name a point that is not claimed.
  EXPECT_EQ(said_of_targets(triangle, {1}, {to({0, 1}), to({1, 2})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 1; it is no end of 1 2");
  // Wrong in turn: an edge without this end, more than an edge, a regular point that gives no edge, a saddle.
  EXPECT_EQ(said_of_targets(triangle, {0}, {to({0, 1}), to({0, 2}), to({1, 2})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 0; it is no end of 1 2");
  EXPECT_EQ(said_of_targets(triangle, {1}, {to({0, 1}), to({0, 1, 2})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 1; it is no end of 0 1 2");
  EXPECT_EQ(said_of_targets(high, {3}, {to({0, 3}), to({1, 3}), to({2, 3}), to({0, 1, 2, 3})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 3; it is no end of 0 1 2 3");
  EXPECT_EQ(said_of_targets(high, {3}, {to({0, 3}), to({1, 3}), to({2, 3}), to({0, 1, 3})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 0, contact set 3; it is no end of 0 1 3");
}

TEST(IncidenceFindings, SaddlesAboveAnEdge) {
  CITES("FC-CHAIN-01", "FC-CLAIM-02", "FC-CLAIM-09");
  const Truly cube(kCube), triangle(kRightTriangle), arch(kArch);
  const Ids edge = {0, 1};
  const ClaimedTarget one = to({0, 1, 2, 3}), other = to({0, 1, 4, 5});
  EXPECT_EQ(said_of_targets(cube, edge, {one, other, one}), "conforms");
  EXPECT_EQ(said_of_targets(cube, edge, {one, to({0, 1, 4})}),
            "conforms where determined\n4 spanning-part FC-CLAIM-02: index 1, contact set 0 1; "
            "parts of contact sets are named");
  // A diagonal is no part of a face that will do, and the triangle 1 2 4 is no part of any face.
  EXPECT_EQ(said_of_targets(cube, edge, {to({0, 3}), to({1, 2, 4})}),
            "fails\n4 wrong-incidence FC-CHAIN-01: index 1, contact set 0 1; an orbit comes to it also from "
            "0 1 2 3, 0 1 4 5; no orbit comes to it from 0 3, 1 2 4");
  EXPECT_EQ(said_of_targets(triangle, {0, 1}, {to({0, 1, 2})}),
            "perturbed\n4 symbolic-perturbation FC-CLAIM-09: index 1, contact set 0 1; "
            "a perturbation makes some of the points above it");
  // A tie leaves the boundary of the saddle 0 3 4 open. It may be above 0 1, but never above a higher point.
  EXPECT_EQ(said_of_targets(arch, {0, 1}, {to({0, 1, 2}), to({0, 1, 3})}),
            "conforms where determined\n4 tie-break FC-CLAIM-09: index 1, contact set 0 1; "
            "there are ties in the stable manifolds above it");
  EXPECT_EQ(said_of_targets(arch, {1, 3}, {to({0, 1, 3}), to({1, 3, 4}), to({0, 3, 4})}),
            "fails\n4 wrong-incidence FC-CHAIN-01: index 1, contact set 1 3; no orbit comes to it from 0 3 4");
}

TEST(IncidenceFindings, LimitsByPartsOfContactSets) {
  CITES("FC-CLAIM-02", "FC-CLAIM-06");
  const Truly cube(kCube);
  const Ids face = {0, 1, 2, 3};
  const std::string ends =
      "its orbits end at infinity (side 0) and at a critical point of index 3, contact set "
      "0 1 2 3 4 5 6 7 (side 1)";
  EXPECT_EQ(said_of_targets(cube, face, {to({0, 1, 2, 4}), kInfinity}),
            "conforms where determined\n4 spanning-part FC-CLAIM-02: index 2, contact set 0 1 2 3, up to "
            "0 1 2 4, infinity; " +
                ends);
  // The diagonal 0 7 has the same centre, but does not span the set. The triangle 1 2 4 has another centre.
  for (const Ids& wrong : {Ids{0, 7}, Ids{1, 2, 4}}) {
    const std::string names = wrong.size() == 2 ? "0 7" : "1 2 4";
    EXPECT_EQ(
        said_of_targets(cube, face, {to(wrong), kInfinity}),
        "fails\n4 wrong-incidence FC-FLOW-07: index 2, contact set 0 1 2 3, up to " + names + ", infinity; " + ends);
  }
  EXPECT_EQ(said_of_targets(cube, face, {}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 2, contact set 0 1 2 3, up to nothing; " + ends);
}

// Sides are told by the samples that are named. The part 1 2 3 of 0 1 2 3 turns the other way than 0 1 2.
TEST(IncidenceFindings, SidesOfParts) {
  CITES("FC-CLAIM-02", "FC-FLOW-07");
  const Truly cube(kCube);
  const ClaimedTarget center = to({0, 1, 2, 3, 4, 5, 6, 7});
  const auto by_side = [&](const Ids& part, const ClaimedTarget& first, const ClaimedTarget& second) {
    Claimed claimed = cube.claim_without({{0, 1, 2, 3}}).add(2, part);
    claimed.last().successors = {{first, second}};
    claimed.last().successors_by_side = true;
    return cube.check(claimed).verdict;
  };
  EXPECT_EQ(by_side({0, 1, 2, 3}, kInfinity, center), Verdict::kConforms);
  EXPECT_EQ(by_side({0, 1, 2}, kInfinity, center), Verdict::kConformsWhereDetermined);
  EXPECT_EQ(by_side({0, 1, 2}, center, kInfinity), Verdict::kFails);
  EXPECT_EQ(by_side({1, 2, 3}, center, kInfinity), Verdict::kConformsWhereDetermined);
  EXPECT_EQ(by_side({1, 2, 3}, kInfinity, center), Verdict::kFails);
}

TEST(IncidenceFindings, OrbitsThatGoOnBeyondASaddle) {
  CITES("FC-CLAIM-07");
  const Truly arch(kArch);
  const Ids saddle = {0, 1, 2};
  const std::string ends =
      "its orbits end at infinity (side 0) and at a critical point of index 2, contact set "
      "0 3 4 (side 1)";
  const auto by_side = [&](const ClaimedTarget& first, const ClaimedTarget& second) {
    return said(arch, [&](Claimed& claimed) { claimed.of(saddle).successors = {{first, second}}; });
  };
  for (const Ids& beyond : {Ids{0, 1, 3, 4}, Ids{0, 2, 3, 4}}) {
    const std::string names = beyond[1] == 1 ? "0 1 3 4" : "0 2 3 4";
    EXPECT_EQ(by_side(kInfinity, to(beyond)),
              "perturbed\n4 symbolic-perturbation FC-CLAIM-07: index 2, contact set 0 1 2, "
              "up to infinity, " +
                  names + "; " + ends);
    EXPECT_EQ(said_of_targets(arch, saddle, {to(beyond), kInfinity}),
              "perturbed\n4 symbolic-perturbation FC-CLAIM-07: index 2, contact set 0 1 2, "
              "up to " +
                  names + ", infinity; " + ends);
  }
  EXPECT_EQ(by_side(to({0, 1, 3, 4}), kInfinity),
            "fails\n4 wrong-incidence FC-FLOW-07: index 2, contact set 0 1 2, up to 0 1 3 4, infinity; " + ends);
  EXPECT_EQ(by_side(kInfinity, to({0, 1, 3})),
            "fails\n4 wrong-incidence FC-FLOW-07: index 2, contact set 0 1 2, up to infinity, 0 1 3; " + ends);
  // Each of these limits is permitted, but there are only two sides.
  EXPECT_EQ(said_of_targets(arch, saddle, {kInfinity, to({0, 1, 3, 4}), to({0, 2, 3, 4})}),
            "fails\n4 wrong-incidence FC-FLOW-07: index 2, contact set 0 1 2, up to infinity, 0 1 3 4, "
            "0 2 3 4; " +
                ends);
}

TEST(IncidenceFindings, OrbitsThatGoOnBeyondRegularPoints) {
  CITES("FC-CLAIM-07");
  const Truly arch(kArchToRegular);
  const std::string ends =
      "its orbits end at a critical point of index 2, contact set 1 2 4 (side 0) and at "
      "infinity (side 1)";
  const std::string unjudged =
      "\nnot judged: where, beyond a regular stationary point, a perturbation lets an "
      "orbit end (FC-CLAIM-07)";
  EXPECT_EQ(said_of_targets(arch, {0, 1, 3}, {kInfinity}),
            "perturbed\n4 symbolic-perturbation FC-CLAIM-07: index 2, contact set 0 1 3, up to "
            "infinity; " +
                ends + unjudged);
  EXPECT_EQ(said_of_targets(arch, {0, 1, 3}, {to({0, 1, 2, 4}), kInfinity}),
            "perturbed\n4 symbolic-perturbation FC-CLAIM-07: index 2, contact set 0 1 3, up to "
            "0 1 2 4, infinity; " +
                ends + unjudged);
  // Neither an edge can be the limit, nor a lower saddle.
  for (const Ids& wrong : {Ids{1, 2}, Ids{0, 3, 4}}) {
    const std::string names = wrong.size() == 2 ? "1 2" : "0 3 4";
    EXPECT_EQ(said_of_targets(arch, {0, 1, 3}, {to(wrong), kInfinity}),
              "fails\n4 wrong-incidence FC-FLOW-07: index 2, contact set 0 1 3, up to " + names + ", infinity; " +
                  ends + unjudged);
  }
}

TEST(IncidenceFindings, WhatAPerturbationMakesIsNotJudged) {
  CITES("FC-CLAIM-07");
  const Truly triangle(kRightTriangle);
  Claimed claimed = triangle.claim().add(1, {1, 2}).add(2, {0, 1, 2});
  claimed.last().successors = {{kInfinity}};
  claimed.last().u2.emplace(2);
  claimed.last().stable = ClaimedStable{7, {}, {}, {{{0, 1}}}, {}};
  const CheckReport report = triangle.check(claimed);
  EXPECT_EQ(report.verdict, Verdict::kPerturbed) << text(report);
  EXPECT_EQ(report.not_judged,
            (std::vector<std::string>{"incidences of the points that a perturbation makes of stationary points",
                                      "polylines of the points that a perturbation makes of stationary points",
                                      "stable sets of the points that a perturbation makes of stationary points"}));
}

// ---- Boundaries

TEST(BoundaryFindings, WithoutATieThereIsOneBoundary) {
  CITES("FC-CHAIN-01", "FC-CLAIM-06");
  const Truly points(kTetrahedron);
  const std::string start = "fails\n4 wrong-incidence FC-CHAIN-01: index 2, contact set 0 1 2, bounded by ";
  EXPECT_EQ(said_of_boundary(points, {0, 1, 2}, {}), start + "nothing; its boundary is 0 1, 0 2, 1 2");
  EXPECT_EQ(said_of_boundary(points, {0, 1, 2}, {{0, 1}}), start + "0 1; its boundary is 0 1, 0 2, 1 2");
  EXPECT_EQ(said_of_boundary(points, {0, 1, 2}, {{0, 1}, {0, 2}, {1, 2}, {0, 1}}),
            start + "0 1, 0 2, 1 2, 0 1; 0 1 is named twice");
  EXPECT_EQ(said_of_boundary(points, {0, 1, 2}, {{0, 1, 3}, {0, 1}}),
            start + "0 1 3, 0 1; 0 1 3 is no critical point of index 1");
  const Truly obtuse({{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, -9, 0}, {2, 9, 0}});
  const auto saddle = [](const ClaimedPoint& point) { return point.index == 2; };
  Claimed claimed = obtuse.whole_claim();
  const auto found = std::ranges::find_if(claimed.claim.points, saddle);
  ASSERT_NE(found, claimed.claim.points.end());
  found->stable->boundary = {{{0, 1}}};
  EXPECT_NE(text(obtuse.check(claimed)).find("0 1 is no critical point of index 1"), std::string::npos);
}

TEST(BoundaryFindings, ATieLeavesSomeOpen) {
  CITES("FC-CHAIN-01", "FC-CHAIN-02", "FC-CLAIM-09");
  const Truly arch(kArch);
  const Ids saddle = {0, 3, 4};
  const std::string start = "index 2, contact set 0 3 4, bounded by ";
  const std::string wrong = "fails\n4 wrong-incidence FC-CHAIN-01: " + start;
  EXPECT_EQ(
      said_of_boundary(arch, saddle, {{0, 3}, {3, 4}, {0, 2}, {2, 4}}),
      "conforms where determined\n4 tie-break FC-CLAIM-09: " + start + "0 3, 3 4, 0 2, 2 4; another way to break ties");
  EXPECT_EQ(said_of_boundary(arch, saddle, {{0, 1}, {0, 2}, {1, 2}}),
            wrong + "0 1, 0 2, 1 2; no way to break ties gives this boundary");
  EXPECT_EQ(said_of_boundary(arch, saddle, {}), wrong + "nothing; no way to break ties gives this boundary");
  EXPECT_EQ(said_of_boundary(arch, saddle, {{0, 3}}), wrong + "0 3; its boundary is 0 1, 0 3, 1 4, 3 4");
  EXPECT_EQ(said_of_boundary(arch, saddle, {{0, 3}, {1, 3}, {0, 1}}),
            wrong + "0 3, 1 3, 0 1; 1 3 does not lie below it");
}

// The walk from 0 over 1 to 3 goes back along the hypotenuse 0 3 of the right angle 0 2 3, or along its sides, but not
// along both.
TEST(BoundaryFindings, ThreeEdgesAtASampleAreNoCycle) {
  CITES("FC-CLAIM-09", "FC-CHAIN-01");
  const Truly points(kRegularBack);
  const auto verdict = [&](const std::vector<Ids>& boundary) {
    Claimed claimed = points.whole_claim();
    claimed.of({0, 1, 3}).stable->boundary = boundary;
    return points.check(claimed, {.highest_level = 4}).verdict;
  };
  EXPECT_EQ(verdict({{0, 1}, {1, 3}, {0, 2}, {2, 3}}), Verdict::kConforms);
  EXPECT_EQ(verdict({{0, 1}, {1, 3}, {0, 3}}), Verdict::kPerturbed);
  EXPECT_EQ(verdict({{0, 1}, {1, 3}, {0, 3}, {0, 2}, {2, 3}}), Verdict::kFails);
}

// The stable manifold of 0 1 4 has a Voronoi vertex, (0,1,0), and no interval: no triangle of the four samples around
// the vertex contains its circumcentre. An index-1 point below it may name it, or not.
TEST(BoundaryFindings, AVertexWithoutIntervalsIsATie) {
  CITES("FC-CLAIM-09", "FC-CHAIN-01");
  const Truly points({{-3, 0, 0}, {3, 0, 0}, {-1, -2, 0}, {0, -2, -1}, {0, 7, 0}}), flat(kTetrahedron);
  const Ids saddle = {0, 1, 4}, edge = {2, 3};
  const StableSummary summary = points.truth->stable_summary(points.record_of(saddle));
  EXPECT_TRUE(summary.has_vertex);
  EXPECT_FALSE(summary.has_interval);
  EXPECT_TRUE(has_tie(*points.truth, points.record_of(saddle)));
  EXPECT_FALSE(has_tie(*flat.truth, flat.record_of({0, 1, 2})));
  Claimed claimed = points.whole_claim();
  std::vector<ClaimedTarget>& above = claimed.of(edge).successors.value();
  EXPECT_EQ(std::erase_if(above, [&](const ClaimedTarget& target) { return target.contact == saddle; }), 1U);
  const CheckReport report = points.check(claimed);
  EXPECT_EQ(report.verdict, Verdict::kConformsWhereDetermined) << text(report);
  EXPECT_EQ(count(report, FindingReason::kTieBreak), 1U);
}

TEST(BoundaryFindings, ThroughWhatAPerturbationMakesCritical) {
  CITES("FC-CLAIM-09");
  const Truly points(kRegularBack);
  EXPECT_EQ(said_of_boundary(points, {0, 1, 3}, {{0, 1}, {1, 3}, {0, 3}}),
            "perturbed\n4 symbolic-perturbation FC-CLAIM-09: index 2, contact set 0 1 3; its "
            "boundary is 0 1, 0 2, 1 3, 2 3"
            "\nnot judged: which of the boundaries that ties allow are claimed, where they pass regular "
            "stationary points or the truth breaks no ties (FC-CLAIM-09)");
  EXPECT_EQ(said_of_boundary(points, {0, 1, 3}, {{0, 1}, {1, 3}, {0, 2, 3}}),
            "fails\n4 wrong-incidence FC-CHAIN-01: index 2, contact set 0 1 3, bounded by 0 1, 1 3, 0 2 3; "
            "0 2 3 is no critical point of index 1");
}

// A truth that breaks no ties.
class Undecided final : public Truth {
 public:
  explicit Undecided(Truth& truth) : truth_(truth) {
    for (std::size_t i = 0; i < truth.size(); ++i) add(truth.index(i), truth.contact(i));
  }
  [[nodiscard]] ExactSphere sphere(std::size_t i) override { return truth_.sphere(i); }
  [[nodiscard]] std::array<std::optional<std::size_t>, 2> limits(std::size_t i) override { return truth_.limits(i); }
  [[nodiscard]] std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) override {
    return truth_.polyline(i, side);
  }
  [[nodiscard]] TruePath orbit(const RationalPoint& start) override { return truth_.orbit(start); }
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) override {
    if (has_tie(truth_, i)) return std::nullopt;
    return truth_.boundary(i);
  }
  [[nodiscard]] StableSummary stable_summary(std::size_t i) override { return truth_.stable_summary(i); }
  [[nodiscard]] StableSet<> stable_set(std::optional<std::size_t> i) override { return truth_.stable_set(i); }
  [[nodiscard]] LambdaList lambda_list(std::size_t i) override { return truth_.lambda_list(i); }
  [[nodiscard]] std::vector<FlowLimits::Entry> lambda_entries(std::size_t i) override {
    return truth_.lambda_entries(i);
  }
  [[nodiscard]] Rational volume(std::size_t i) override { return truth_.volume(i); }
  [[nodiscard]] double nearest_sum(std::span<const std::uint32_t> records) override {
    return truth_.nearest_sum(records);
  }
  [[nodiscard]] std::vector<std::pair<PointId, Rational>> shares(std::size_t i) override { return truth_.shares(i); }
  [[nodiscard]] std::vector<std::pair<PointId, double>> nearest_shares(std::size_t i) override {
    return truth_.nearest_shares(i);
  }
  [[nodiscard]] Rational hull_volume() override { return truth_.hull_volume(); }
  [[nodiscard]] UnstableSurface<> unstable_surface(std::size_t i) override { return truth_.unstable_surface(i); }
  [[nodiscard]] TruePockets pockets(const Rational& persistence) override { return truth_.pockets(persistence); }
  [[nodiscard]] double area(std::size_t i) override { return truth_.area(i); }

 private:
  Truth& truth_;
};

TEST(BoundaryFindings, ByATruthThatBreaksNoTies) {
  CITES("FC-CLAIM-09");
  const Truly arch(kArch);
  Undecided undecided(*arch.truth);
  const auto report = [&](const std::vector<Ids>& boundary) {
    Claimed claimed = arch.whole_claim();
    claimed.of({0, 3, 4}).stable->boundary = boundary;
    return text(check(arch.points, claimed.claim, undecided));
  };
  EXPECT_EQ(report({{0, 3}, {3, 4}, {0, 2}, {2, 4}}),
            "conforms\nnot judged: which of the boundaries that ties allow are claimed, where they pass regular "
            "stationary points or the truth breaks no ties (FC-CLAIM-09)");
  EXPECT_EQ(report({{0, 3}, {3, 4}, {0, 2}}),
            "fails\n4 wrong-incidence FC-CHAIN-01: index 2, contact set 0 3 4, bounded by 0 3, 3 4, 0 2; "
            "a boundary is a cycle");
}

// Twenty samples on a circle; the numbers in the findings are cut off.
TEST(BoundaryFindings, OfManyEdges) {
  CITES("FC-CHAIN-01");
  std::vector<Point> circle;
  for (const auto& [x, y] : {std::pair{25., 0.}, {24., 7.}, {20., 15.}, {15., 20.}, {7., 24.}}) {
    circle.insert(circle.end(), {{x, y, 0}, {-y, x, 0}, {-x, -y, 0}, {y, -x, 0}});
  }
  const Truly points(circle);
  Ids all(20);
  for (PointId k = 0; k < 20; ++k) all[k] = k;
  const std::string found = said_of_boundary(points, all, {});
  EXPECT_TRUE(found.starts_with(
      "fails\n4 wrong-incidence FC-CHAIN-01: index 2, contact set 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 ... "
      "(20 points), bounded by nothing; its boundary is 0 4, "))
      << found;
  EXPECT_TRUE(found.ends_with(", and more")) << found;
  EXPECT_EQ(std::ranges::count(found.substr(found.find("its boundary is")), ','), 8) << found;
}

}  // namespace
}  // namespace flowcert::incidence_findings_test
