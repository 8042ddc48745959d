// What check finds in claims of unstable sets of dimension 2, in words.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::unstable_set_findings_test {
namespace {

Claimed all_sets_of(const Truly& points) {
  Claimed claimed = points.whole_claim();
  add_unstable_sets(claimed.claim, *points.truth);
  return claimed;
}

// What is said of a claim of which one set is changed.
std::string said(const Truly& points, const Ids& contact,
                 const std::function<void(UnstableSurface<ClaimedPosition>&)>& change,
                 const CheckOptions& options = {}) {
  Claimed claimed = all_sets_of(points);
  change(*claimed.of(contact).u1);
  return text(points.check(claimed, options));
}

// Its sheet beside points 0 and 2 fans out from a trace in the facet of points 0 and 1.
const std::vector<Point> kBeyondObtuse = {{-4, 0, 0}, {4, 0, 0}, {0, 1, 0}, {0, 0, 40}};

TEST(UnstableSetFindings, AllThatIsTrueConforms) {
  CITES("FC-CLAIM-17", "FC-UNST-04");
  const std::vector<std::vector<Point>> inputs = {kCube,          kTetrahedron, kRightTriangle, kKind13,     kArch,
                                                  kArchToRegular, kRegularBack, kBeyondObtuse,  {{1, 2, 3}}, {}};
  for (const std::vector<Point>& rows : inputs) {
    const Truly points(rows);
    const CheckReport report = points.check(all_sets_of(points));
    EXPECT_EQ(text(report), "conforms");
    EXPECT_TRUE(report.is_exact);
  }
}

// The set of an edge of the cube is a quarter of a plane.
TEST(UnstableSetFindings, PartsThatAreNotThere) {
  CITES("FC-CLAIM-17");
  const Truly points(kCube);
  const auto changed = [&](const std::function<void(UnstableSurface<ClaimedPosition>&)>& change) {
    return said(points, {0, 1}, change);
  };
  const std::string start = "fails\n5 wrong-unstable-set FC-UNST-04: index 1, contact set 0 1, ";
  const std::string truth = "; there is none, or it is claimed already (in all 1 such ";
  EXPECT_EQ(changed([](auto& set) { set.vertices.push_back(exactly({1, 0, 0})); }),
            start + "the Voronoi vertex 1 0 0" + truth + "Voronoi vertices)");
  EXPECT_EQ(changed([](auto& set) { set.vertices.push_back(set.vertices[0]); }),
            start + "the Voronoi vertex 1/2 1/2 1/2" + truth + "Voronoi vertices)");
  EXPECT_EQ(changed([](auto& set) { set.traces[0].front.position[2] = number(0); }),
            start + "a trace of 0 1 2 3 from 1/2 1/2 0 to infinity along 0 0 -1" + truth + "traces)");
  EXPECT_EQ(changed([](auto& set) { set.runs.push_back(set.traces[0]); }),
            start + "a run of 0 1 2 3 from 1/2 1/2 1/2 to infinity along 0 0 -1" + truth + "runs)");
  EXPECT_EQ(changed([](auto& set) { set.sheets[0].samples = {2, 3}; }),
            start + "a sheet of 2 3 with 3 corners: 1/2 1/2 1/2, infinity along 0 -1 0, infinity along 0 0 -1" + truth +
                "sheets)");
  EXPECT_EQ(changed([](auto& set) { set.sheets[0].corners = {}; }),
            start + "a sheet of 0 1, the whole facet" + truth + "sheets)");
  EXPECT_EQ(
      changed([](auto& set) { set.segments.push_back({{0, 1}, {exactly({0, 2, 1}), true}, {exactly({1, 0, 0})}}); }),
      start + "a segment of 0 1 from 1 0 0 to infinity along 0 2 1" + truth + "segments)");
}

TEST(UnstableSetFindings, PartsThatAreMissing) {
  CITES("FC-CLAIM-17");
  const Truly points(kCube);
  const std::string start = "fails\n5 wrong-unstable-set FC-UNST-04: index 1, contact set 0 1, ";
  EXPECT_EQ(said(points, {0, 1}, [](auto& set) { set.vertices.clear(); }),
            start +
                "too few Voronoi vertices; there is the Voronoi vertex 1/2 1/2 1/2 (in all 1 such Voronoi "
                "vertices)");
  EXPECT_EQ(said(points, {0, 1}, [](auto& set) { set.traces.clear(); }),
            start +
                "too few traces; there is a trace of 0 1 2 3 from 1/2 1/2 1/2 to infinity along 0 0 -1 (in all 2 "
                "such traces)");
  const Truly fan(kBeyondObtuse);
  EXPECT_TRUE(said(fan, {0, 2}, [](auto& set) { set.sheets.pop_back(); })
                  .starts_with("fails\n5 wrong-unstable-set FC-UNST-04: index 1, contact set 0 2, too few sheets; "
                               "there is a sheet of "));
}

TEST(UnstableSetFindings, TheOrderIsFree) {
  CITES("FC-CLAIM-17");
  const Truly points(kBeyondObtuse);
  EXPECT_EQ(said(points, {0, 2},
                 [](auto& set) {
                   std::ranges::reverse(set.vertices);
                   std::ranges::reverse(set.traces);
                   std::ranges::reverse(set.sheets);
                   for (auto& trace : set.traces) std::swap(trace.front, trace.back);
                   for (auto& sheet : set.sheets) std::ranges::reverse(sheet.corners);
                   for (auto& sheet : set.sheets) std::ranges::reverse(sheet.samples);
                 }),
            "conforms");
}

TEST(UnstableSetFindings, Decimals) {
  CITES("FC-CLAIM-17", "FC-CLAIM-05");
  const Truly points(kCube);
  const auto moved = [&](const ClaimedNumber& x, double tolerance) {
    return said(points, {0, 1}, [&](auto& set) { set.vertices[0][0] = x; }, {.tolerance = tolerance});
  };
  const Rational half = Rational(1) / 2;
  EXPECT_EQ(moved(decimal(half), 0), "conforms");
  EXPECT_EQ(moved(decimal(half + Rational(1) / 1000), 0.01), "conforms");
  EXPECT_TRUE(moved(decimal(half + Rational(1) / 1000), 0.0001).starts_with("fails\n5 wrong-unstable-set"));
  EXPECT_TRUE(moved(number(half + Rational(0x1p-50)), 1).starts_with("fails\n5 rounding FC-UNST-04"));
  const auto turned = [&](double tolerance) {
    return said(points, {0, 1},
                [](auto& set) { set.traces[0].back.position = {decimal(Rational(1) / 1000), decimal(0), decimal(-7)}; },
                {.tolerance = tolerance});
  };
  EXPECT_EQ(turned(0.001), "conforms");
  EXPECT_TRUE(turned(0.0001).starts_with("fails\n5 wrong-unstable-set"));
  Claimed claimed = all_sets_of(points);
  claimed.of({0, 1}).u1->vertices[0][0] = decimal(half);
  EXPECT_FALSE(points.check(claimed).is_exact);
}

// Claims of two vertices in decimals, on the line through the true ones, all within the plane x = 0, or a little beside
// it. The first claim comes first in lexicographic order. It is near both true ones, so the second decides which it is.
TEST(UnstableSetFindings, PartsNearSeveralTrueOnes) {
  CITES("FC-CLAIM-17", "FC-CLAIM-05");
  const Truly points({{-5, 0, 0}, {5, 0, 0}, {0, 6, 1}, {0, -6, 1}, {0, 1, 7}, {0, 0, -8}});
  const UnstableSurface truth = points.truth->unstable_surface(points.record_of({0, 1}));
  ASSERT_GE(truth.vertices.size(), 2U);
  const RationalPoint &a = truth.vertices[0], &b = truth.vertices[1];
  const Rational squared = (b[1] - a[1]) * (b[1] - a[1]) + (b[2] - a[2]) * (b[2] - a[2]);
  const double tolerance = 0.6 * std::sqrt(as_double(squared)) / 5;
  ASSERT_TRUE(squared > 1 && tolerance < 1);
  const auto at = [&](const Rational& part, const Rational& beside) {
    return decimals({-beside, a[1] + (b[1] - a[1]) * part, a[2] + (b[2] - a[2]) * part});
  };
  const auto claimed = [&](const Rational& first, const Rational& second) {
    return said(points, {0, 1},
                [&](auto& set) {
                  set.vertices[0] = at(first, Rational(1) / 10);
                  set.vertices[1] = at(second, 0);
                },
                {.tolerance = tolerance});
  };
  const Rational half = Rational(1) / 2;
  EXPECT_EQ(claimed(half, -half), "conforms");
  EXPECT_EQ(claimed(half, 1 + half), "conforms");
  EXPECT_TRUE(claimed(-half, -half).starts_with("fails\n5 wrong-unstable-set"));
}

// The regular point of kind 1-2 in the middle of 1 2 is claimed as an edge and a triangle.
TEST(UnstableSetFindings, WhatAPerturbationMakesIsNotJudged) {
  CITES("FC-CLAIM-17", "FC-CLAIM-04");
  const Truly points(kRightTriangle);
  Claimed claimed = all_sets_of(points);
  ClaimedPoint& regular = claimed.claim.points.back();
  ASSERT_EQ(regular.hull_dimension, 2);
  regular.hull_dimension.reset();
  regular.contact = {1, 2};
  regular.stable.reset();
  regular.skeleton.reset();
  regular.surface.reset();
  regular.u1->sheets.clear();
  claimed.add(2, {0, 1, 2});
  const CheckReport report = points.check(claimed);
  EXPECT_EQ(report.verdict, Verdict::kPerturbed);
  EXPECT_EQ(std::ranges::count(report.not_judged,
                               "unstable sets of the points that a perturbation makes of stationary points"),
            1);
}

TEST(UnstableSetFindings, IdsAndVectorsThatCannotBe) {
  CITES("FC-CLAIM-01");
  const Truly points(kCube);
  const std::string start = "fails\n1 malformed FC-CLAIM-01: index 1, contact set 0 1; of an unstable set: ";
  const auto first_lines = [&](const std::function<void(UnstableSurface<ClaimedPosition>&)>& change) {
    const std::string all = said(points, {0, 1}, change);
    return all.substr(0, all.find('\n', 6));
  };
  EXPECT_EQ(first_lines([](auto& set) { set.traces[0].polygon = {0, 8}; }),
            start + "there is no point 8; the ids are 0 to 7");
  EXPECT_EQ(first_lines([](auto& set) { set.sheets[0].samples = {1, 1}; }), start + "point 1 is named twice");
  EXPECT_EQ(first_lines([](auto& set) { set.traces[0].polygon = {}; }), start + "a contact set without points");
  EXPECT_EQ(first_lines([](auto& set) { set.traces[0].back.position = exactly({0, 0, 0}); }),
            start + "a vector that is zero");
}

}  // namespace
}  // namespace flowcert::unstable_set_findings_test
