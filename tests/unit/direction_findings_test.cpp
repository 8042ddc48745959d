// What check finds in claims of λ-lists, connections and volumes, in words.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::direction_findings_test {
namespace {

// All that is true, with directions and volumes.
Claimed all_of(const Truly& points) {
  Claimed claimed = points.whole_claim();
  add_directions_and_volumes(claimed.claim, *points.truth);
  return claimed;
}

// What is said of a claim of which one point is changed.
std::string said(const Truly& points, const Ids& contact, const std::function<void(ClaimedPoint&)>& change,
                 const CheckOptions& options = {}) {
  Claimed claimed = all_of(points);
  change(claimed.of(contact));
  return text(points.check(claimed, options));
}

// A right prism: the triangle 0 1 2 and, above it, 3 4 5.
const std::vector<Point> kPrism = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {0, 0, 9}, {4, 0, 9}, {1, 3, 9}};

TEST(DirectionFindings, AllThatIsTrueConforms) {
  CITES("FC-CLAIM-13", "FC-CLAIM-14", "FC-CLAIM-15");
  for (const std::vector<Point>& rows : {kCube,
                                         kTetrahedron,
                                         kRightTriangle,
                                         kKind23,
                                         kKind13,
                                         kArch,
                                         kArchToRegular,
                                         kRegularBack,
                                         kPrism,
                                         {{1, 2, 3}},
                                         {}}) {
    const Truly points(rows);
    const CheckReport report = points.check(all_of(points));
    EXPECT_EQ(text(report), "conforms");
    EXPECT_TRUE(report.is_exact);
    EXPECT_EQ(report.conforms[4], true);
  }
}

TEST(DirectionFindings, OtherLimits) {
  CITES("FC-CLAIM-13", "FC-UNST-02");
  const Truly points(kTetrahedron);
  const auto changed = [&](const std::function<void(ClaimedLambdaList&)>& change) {
    return said(points, {0, 1}, [&](ClaimedPoint& point) { change(*point.lambda); });
  };
  const std::string start = "fails\n5 wrong-lambda-list FC-UNST-02: index 1, contact set 0 1, ";
  const std::string truth = "; 2 directions and 2 arcs: 0 1 3, (0 1 2 3), 0 1 2, (infinity)";
  EXPECT_EQ(changed([](ClaimedLambdaList& list) { list.arcs[0] = kInfinity; }),
            start + "2 directions and 2 arcs: 0 1 3, (infinity), 0 1 2, (infinity)" + truth);
  EXPECT_EQ(changed([](ClaimedLambdaList& list) { list.directions[1].limit = kInfinity; }),
            start + "2 directions and 2 arcs: 0 1 3, (0 1 2 3), infinity, (infinity)" + truth);
  EXPECT_EQ(changed([](ClaimedLambdaList& list) { list.arcs[1] = to({2, 3}); }),
            start + "2 directions and 2 arcs: 0 1 3, (0 1 2 3), 0 1 2, (2 3)" + truth);
  EXPECT_EQ(changed([](ClaimedLambdaList& list) { std::swap(list.arcs[0], list.arcs[1]); }),
            start + "2 directions and 2 arcs: 0 1 3, (infinity), 0 1 2, (0 1 2 3)" + truth);
  EXPECT_EQ(changed([](ClaimedLambdaList& list) { list = {{}, {kInfinity}}; }),
            start + "0 directions and 1 arcs: (infinity)" + truth);
  EXPECT_EQ(changed([](ClaimedLambdaList& list) { list = {}; }), start + "0 directions and 0 arcs: none" + truth);
}

TEST(DirectionFindings, AListMayBeginAnywhere) {
  CITES("FC-CLAIM-13");
  const Truly points(kTetrahedron);
  const auto turn = [](ClaimedPoint& point) {
    std::ranges::reverse(point.lambda->directions);
    std::ranges::reverse(point.lambda->arcs);
  };
  EXPECT_EQ(said(points, {0, 1}, turn), "conforms");
}

TEST(DirectionFindings, OtherExits) {
  CITES("FC-CLAIM-13", "FC-CLAIM-05");
  const Truly points(kTetrahedron);
  const auto moved = [&](const ClaimedNumber& x, double tolerance) {
    return said(points, {0, 1},
                [&](ClaimedPoint& point) {
                  point.lambda->directions[1].exit->at(0) = x;
                  point.lambda->directions[1].rounded_exit.reset();
                },
                {.tolerance = tolerance});
  };
  const Rational exit = points.truth->lambda_list(points.record_of({0, 1})).directions[1].exit[0];
  EXPECT_EQ(exit, Rational(2) / 3);
  EXPECT_EQ(moved(number(exit + 1), 1),
            "fails\n5 wrong-lambda-list FC-UNST-02: index 1, contact set 0 1, a direction to 0 1 2, leaving at 5/3 1/3 "
            "1/3; it leaves at 2/3 1/3 1/3 (in all 1 such directions)");
  EXPECT_EQ(moved(decimal(exit + Rational(1) / 1000), 0.01), "conforms");
  EXPECT_TRUE(moved(decimal(exit + Rational(1) / 1000), 0.0001).starts_with("fails\n5 wrong-lambda-list"));
  EXPECT_EQ(moved(decimal(Rational(as_double(exit))), 0), "conforms");
  EXPECT_TRUE(moved(number(Rational(as_double(exit))), 1).starts_with("fails\n5 rounding FC-UNST-02"));
}

TEST(DirectionFindings, VectorsHaveAnyLength) {
  CITES("FC-CLAIM-13");
  const Truly points(kTetrahedron);
  const auto changed = [&](const std::function<void(ClaimedDirection&)>& change, double tolerance) {
    return said(points, {0, 1, 2},
                [&](ClaimedPoint& point) {
                  for (ClaimedDirection& one : point.lambda->directions) {
                    if (one.is_vector) change(one);
                  }
                },
                {.tolerance = tolerance});
  };
  const auto scale = [](const Rational& factor) {
    return [factor](ClaimedDirection& one) {
      one.rounded_exit.reset();
      for (ClaimedNumber& x : *one.exit) x.value *= factor;
    };
  };
  EXPECT_EQ(changed(scale(7), 0), "conforms");
  EXPECT_TRUE(changed(scale(-1), 1e-9)
                  .starts_with("fails\n5 wrong-lambda-list FC-UNST-02: index 2, contact set 0 1 2, "
                               "a direction to infinity, along "));
  const auto turn = [](ClaimedDirection& one) {
    one.rounded_exit.reset();
    one.exit->at(0) = decimal(one.exit->at(0).value + Rational(1) / 1000);
  };
  EXPECT_EQ(changed(turn, 0.01), "conforms");
  EXPECT_TRUE(changed(turn, 0.0001).starts_with("fails"));
  // Instead of a vector, a position on the ray.
  EXPECT_TRUE(changed([](ClaimedDirection& one) { one.is_vector = false; }, 1).starts_with("fails"));
}

// A square has two diagonals, and a part of three samples may turn the other way.
TEST(DirectionFindings, APartMayTellTheSidesTheOtherWay) {
  CITES("FC-CLAIM-02", "FC-CLAIM-13");
  const Truly points({{0, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}, {1, 1, 5}});
  const Ids whole = {0, 1, 2, 3}, part = {0, 2, 3};
  Claimed claimed = all_of(points);
  claimed.of(whole).contact = part;
  claimed.of(part).successors.reset();
  claimed.of(part).u2.reset();
  EXPECT_FALSE(turn_alike(points.points, part, whole) &&
               points.check(claimed).verdict != Verdict::kConformsWhereDetermined);
  if (!turn_alike(points.points, part, whole)) std::ranges::reverse(claimed.of(part).lambda->directions);
  EXPECT_EQ(points.check(claimed).verdict, Verdict::kConformsWhereDetermined);
  std::ranges::reverse(claimed.of(part).lambda->directions);
  expect_finding(points.check(claimed), 5, FindingReason::kWrongLambdaList, "FC-UNST-02", claimed.of(part).line);
}

TEST(DirectionFindings, OtherConnections) {
  CITES("FC-CLAIM-14", "FC-CONN-01");
  const Truly points(kTetrahedron);
  const auto changed = [&](const std::function<void(std::vector<ClaimedConnection>&)>& change) {
    return said(points, {0, 1}, [&](ClaimedPoint& point) { change(*point.connections); });
  };
  const std::string start = "fails\n5 wrong-connections FC-CONN-01: index 1, contact set 0 1, ";
  EXPECT_EQ(changed([](auto& all) { ++all[0].orbits; }),
            start + "to 0 1 2 orbits: 2, families: 0; orbits: 1, families: 0");
  EXPECT_EQ(changed([](auto& all) { all[3].families = 0; }),
            start + "to infinity orbits: 0, families: 0; orbits: 0, families: 1");
  EXPECT_EQ(changed([](auto& all) { all.pop_back(); }), start + "no connection to infinity; orbits: 0, families: 1");
  EXPECT_EQ(changed([](auto& all) { all.push_back(all[1]); }),
            start + "a connection to 0 1 3; there is none, or it is claimed already");
  EXPECT_EQ(changed([](auto& all) { all.push_back({to({2, 3}), 1, 0}); }),
            start + "a connection to 2 3; there is none, or it is claimed already");
  EXPECT_EQ(changed([](auto& all) { std::ranges::reverse(all); }), "conforms");
}

TEST(DirectionFindings, WhetherItIsMorseSmale) {
  CITES("FC-CLAIM-14", "FC-CONN-03");
  const Truly generic(kTetrahedron), arch(kArch);
  Claimed claimed = all_of(generic);
  claimed.claim.morse_smale = false;
  EXPECT_EQ(text(generic.check(claimed)),
            "fails\n5 wrong-connections FC-CONN-03: an input that is not Morse-Smale; it is Morse-Smale");
  claimed = all_of(arch);
  claimed.claim.morse_smale = true;
  EXPECT_EQ(text(arch.check(claimed)), "fails\n5 wrong-connections FC-CONN-03: a Morse-Smale input; it is not");
}

TEST(DirectionFindings, OtherVolumes) {
  CITES("FC-CLAIM-15", "FC-VOL-01", "FC-VOL-02");
  const Truly points(kArch);
  const auto volume = [&](const ClaimedNumber& claimed, double tolerance) {
    return said(points, {0, 3, 4},
                [&](ClaimedPoint& point) {
                  point.volume = claimed;
                  point.has_rounded_volume = false;
                },
                {.tolerance = tolerance});
  };
  const std::string start = "fails\n5 wrong-volume FC-VOL-01: index 2, contact set 0 3 4, ";
  EXPECT_EQ(volume(number(49), 1), start + "volume 49; the volume is 50");
  EXPECT_EQ(volume(number(50), 0), "conforms");
  EXPECT_EQ(volume(decimal(Rational(5001) / 100), 0.001), "conforms");
  EXPECT_EQ(volume(decimal(Rational(5001) / 100), 0.0001), start + "volume 50.01; the volume is 50");
  EXPECT_TRUE(volume(number(50 + Rational(0x1p-47)), 0).starts_with("fails\n5 rounding FC-VOL-01: index 2"));
  EXPECT_EQ(said(points, {0, 3, 4}, [](ClaimedPoint& point) { point.rounded_volume = decimal(51); }),
            start + "volume_double 51; the volume is 50");
  EXPECT_EQ(said(points, {0, 3, 4}, [](ClaimedPoint& point) { point.rounded_volume.reset(); }),
            start + "volume_double no double; a double is near the volume");
}

TEST(DirectionFindings, OtherSharesAndHulls) {
  CITES("FC-CLAIM-15", "FC-VOL-02");
  const Truly points(kCube);
  const Ids all = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto shares = [&](const std::function<void(std::vector<ClaimedShare>&)>& change) {
    return said(points, all, [&](ClaimedPoint& point) { change(*point.shares); });
  };
  const std::string start = "fails\n5 wrong-volume FC-VOL-02: index 3, contact set 0 1 2 3 4 5 6 7, ";
  EXPECT_EQ(shares([](auto& some) { some[3].volume = number(1); }), start + "a share of 1 in the cell of 3; it is 1/8");
  EXPECT_EQ(shares([](auto& some) { some.resize(6); }),
            start + "no share in the cell of 6; it is 1/8 (in all 2 such shares)");
  EXPECT_EQ(shares([](auto& some) { std::ranges::reverse(some); }), "conforms");
  EXPECT_EQ(said(points, {0, 1, 2, 3}, [](ClaimedPoint& point) { point.shares = {{0, number(0)}}; }), "conforms");
  EXPECT_EQ(said(points, {0, 1, 2, 3}, [](ClaimedPoint& point) { point.shares = {{0, number(1)}}; }),
            "fails\n5 wrong-volume FC-VOL-02: index 2, contact set 0 1 2 3, a share of 1 in the cell of 0; there is "
            "none, or it is claimed already");
  Claimed claimed = all_of(points);
  claimed.claim.hull_volume = number(2);
  EXPECT_EQ(text(points.check(claimed)),
            "fails\n5 wrong-volume FC-CLAIM-15: a convex hull of volume 2; its volume is 1");
  claimed.claim.hull_volume = decimal(1);
  EXPECT_EQ(points.check(claimed).verdict, Verdict::kConforms);
  EXPECT_FALSE(points.check(claimed).is_exact);
}

// The regular point of kind 1-2 in the middle of 1 2 is claimed as an edge and a triangle. Of what leads to it, and of
// itself, nothing is judged.
TEST(DirectionFindings, WhatAPerturbationMakesIsNotJudged) {
  CITES("FC-CLAIM-13", "FC-CLAIM-14", "FC-CLAIM-15", "FC-CLAIM-04");
  const Truly points(kRightTriangle);
  Claimed claimed = all_of(points);
  ClaimedPoint& regular = claimed.claim.points.back();
  ASSERT_EQ(regular.hull_dimension, 2);
  regular.hull_dimension.reset();
  regular.contact = {1, 2};
  regular.stable.reset();
  regular.skeleton.reset();
  regular.surface.reset();
  regular.volume = number(5);
  claimed.add(2, {0, 1, 2}).last().volume = number(7);
  const CheckReport report = points.check(claimed);
  EXPECT_EQ(report.verdict, Verdict::kPerturbed);
  const auto has = [&](const std::string& what) {
    return std::ranges::find(report.not_judged, what) != report.not_judged.end();
  };
  EXPECT_TRUE(has("lambda-lists and connections of, or to, the points that a perturbation makes of stationary points"));
  EXPECT_TRUE(has("volumes of the points that a perturbation makes of stationary points"));
  EXPECT_TRUE(std::ranges::none_of(report.findings, [](const Finding& finding) { return finding.level == 5; }));
}

TEST(DirectionFindings, OtherIndicesAreNotJudged) {
  CITES("FC-CLAIM-12", "FC-CLAIM-13");
  const Truly points(kTetrahedron);
  Claimed claimed = all_of(points);
  claimed.of({0, 1}).lambda->arcs = {};
  EXPECT_EQ(points.check(claimed).verdict, Verdict::kFails);
  const CheckReport report = points.check(claimed, {.indices = {true, true, true, false}});
  EXPECT_EQ(report.verdict, Verdict::kConforms);
  EXPECT_EQ(std::ranges::count(report.not_judged,
                               "lambda-lists and connections, which lead to points of other indices (FC-CLAIM-12)"),
            1);
}

TEST(DirectionFindings, IdsThatCannotBe) {
  CITES("FC-CLAIM-01");
  const Truly points(kTetrahedron);
  const std::string start = "fails\n1 malformed FC-CLAIM-01: index 1, contact set 0 1; ";
  const auto first_line = [](const std::string& all) { return all.substr(0, all.find('\n', 6)); };
  EXPECT_EQ(first_line(said(points, {0, 1}, [](ClaimedPoint& point) { point.lambda->arcs[0] = to({0, 9}); })),
            start + "of a limit: there is no point 9; the ids are 0 to 3");
  EXPECT_EQ(first_line(said(points, {0, 1}, [](ClaimedPoint& point) { point.connections->at(0).to = to({}); })),
            start + "a limit without a contact set");
  EXPECT_EQ(
      first_line(said(points, {0, 1}, [](ClaimedPoint& point) { point.shares = {{1, number(0)}, {1, number(0)}}; })),
      start + "of the shares: point 1 is named twice");
}

}  // namespace
}  // namespace flowcert::direction_findings_test
