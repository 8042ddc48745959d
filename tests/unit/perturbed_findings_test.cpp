// check() on what a perturbation makes of contact sets that are no simplices: polygons that stay on their circles, and
// claims of some indices alone (FC-CLAIM-04, 12, 21).
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::perturbed_findings_test {
namespace {

struct Simplex {
  int index;
  Ids contact;
};

// The verdict on these points, instead of the critical ones of the same index with centre `center`. Only points of
// these indices are claimed.
Verdict verdict_on(const Truly& truly, const RationalPoint& center, const std::vector<int>& indices,
                   const std::vector<Simplex>& made) {
  CheckOptions options;
  options.indices.fill(false);
  for (const int index : indices) options.indices.at(static_cast<std::size_t>(index)) = true;
  Claimed claimed;
  for (std::size_t i = 0; i < truly.truth->size(); ++i) {
    if (!truly.truth->index(i).is_critical() || truly.truth->sphere(i).center == center) continue;
    claimed.add(truly.truth->index(i).face_dimension, {truly.truth->contact(i).begin(), truly.truth->contact(i).end()});
  }
  for (const Simplex& simplex : made) claimed.add(simplex.index, simplex.contact);
  const CheckReport report = truly.check(claimed, options);
  EXPECT_NE(report.verdict, Verdict::kConforms) << text(report);
  return report.verdict;
}

const RationalPoint kOrigin = {0, 0, 0};
const RationalPoint kMiddle = {Rational(1, 2), Rational(1, 2), Rational(1, 2)};
const std::vector<Point> kHalfOctahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
const std::vector<Point> kSquare = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};

TEST(PerturbedFindings, APolygonStaysOnItsCircleWithOneApex) {
  CITES("FC-CLAIM-04", "FC-CLAIM-21");
  // The rectangle 0 1 2 3, and two samples beside it.
  const Truly prism({{-3, 4, 2}, {-3, 4, -2}, {-3, -4, 2}, {-3, -4, -2}, {5, 0, 2}, {5, 0, -2}});
  const auto verdict = [&](const std::vector<Simplex>& made) { return verdict_on(prism, kOrigin, {3}, made); };
  EXPECT_EQ(verdict({{3, {0, 1, 2, 3, 4}}}), Verdict::kPerturbed);
  EXPECT_EQ(verdict({{3, {0, 1, 2, 3, 5}}}), Verdict::kPerturbed);
  // Both have the centre inside.
  EXPECT_EQ(verdict({{3, {0, 1, 2, 3, 4}}, {3, {0, 1, 2, 3, 5}}}), Verdict::kFails);
  EXPECT_EQ(verdict({{3, {0, 1, 2, 3, 4}}, {3, {0, 1, 2, 3, 4}}}), Verdict::kFails);
  EXPECT_EQ(verdict({{3, {0, 1, 2, 3}}}), Verdict::kFails) << "the centre is outside";
  const Truly cube(kCube);
  const auto of_cube = [&](const std::vector<Simplex>& made) { return verdict_on(cube, kMiddle, {3}, made); };
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 3, 7}}}), Verdict::kPerturbed);
  EXPECT_EQ(of_cube({{3, {1, 3, 4, 5, 7}}}), Verdict::kPerturbed);
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 6, 7}}}), Verdict::kFails) << "the polygon is no face";
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 3, 4, 7}}}), Verdict::kFails) << "two further samples";
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 3, 4, 5, 6}}}), Verdict::kFails);
  EXPECT_EQ(verdict_on(cube, kMiddle, {2, 3}, {{2, {0, 1, 2, 3, 7}}, {3, {0, 1, 2, 3, 4}}}), Verdict::kFails);
}

TEST(PerturbedFindings, OnePolygonAtMostStays) {
  CITES("FC-CLAIM-04", "FC-CLAIM-21");
  const Truly cube(kCube);
  const auto of_cube = [&](const std::vector<Simplex>& made) { return verdict_on(cube, kMiddle, {3}, made); };
  // The centre is on an edge of each of these, so that none has it inside.
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 3, 7}}, {3, {0, 1, 2, 3, 4}}}), Verdict::kPerturbed);
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 3, 7}}, {3, {0, 1, 4, 5, 6}}}), Verdict::kFails);
  EXPECT_EQ(of_cube({{3, {0, 1, 2, 3, 7}}, {3, {3, 4, 5, 6, 7}}}), Verdict::kFails);
  // A polygon with the centre, and two samples above it.
  const Truly roof({{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, -5, 0}, {0, 3, 4}, {0, -3, 4}});
  const auto of_roof = [&](const std::vector<Simplex>& made) { return verdict_on(roof, kOrigin, {1, 2, 3}, made); };
  EXPECT_EQ(of_roof({{2, {0, 1, 2, 3}}, {3, {0, 1, 2, 3, 4}}}), Verdict::kPerturbed);
  EXPECT_EQ(of_roof({{2, {0, 1, 2, 3}}, {3, {0, 1, 2, 3, 4, 5}}}), Verdict::kPerturbed);
  EXPECT_EQ(of_roof({{2, {0, 1, 2, 3}}, {3, {0, 1, 2, 4}}}), Verdict::kPerturbed);
  EXPECT_EQ(of_roof({{2, {0, 1, 2, 3}}, {3, {0, 1, 2, 3}}}), Verdict::kFails) << "one contact set";
  EXPECT_EQ(of_roof({{2, {0, 1, 2, 3}}}), Verdict::kFails) << "the sum";
}

// What else there is lies on proper faces of the hull, but may be diagonals of these.
TEST(PerturbedFindings, AllOfItStaysTogether) {
  CITES("FC-CLAIM-04", "FC-CLAIM-12");
  const Truly half(kHalfOctahedron);
  const Simplex edge{1, {0, 1}}, one{2, {0, 1, 2}}, other{2, {0, 1, 3}}, upright{2, {0, 1, 4}}, all{3, {0, 1, 2, 3, 4}};
  const auto of_half = [&](const std::vector<Simplex>& made) { return verdict_on(half, kOrigin, {1, 2, 3}, made); };
  EXPECT_EQ(of_half({edge, one, other, all}), Verdict::kPerturbed);
  EXPECT_EQ(of_half({edge, one, upright, all}), Verdict::kFails) << "a triangle inside";
  EXPECT_EQ(of_half({{2, {0, 1, 2, 3}}, all}), Verdict::kPerturbed);
  EXPECT_EQ(of_half({one, other, {3, {0, 1, 2, 3}}, all}), Verdict::kPerturbed) << "four samples that become solid";
  EXPECT_EQ(of_half({one, other, {3, {0, 1, 2, 4}}, all}), Verdict::kFails);
  // Two polygons, and the edge of both, with the centre in its middle.
  const Truly wedge({{5, 0, 0}, {-5, 0, 0}, {3, 4, 0}, {-3, 4, 0}, {4, 0, 3}, {-4, 0, 3}});
  const Simplex fold{1, {0, 1}}, left{2, {0, 1, 2, 3}}, right{2, {0, 1, 4, 5}}, whole{3, {0, 1, 2, 3, 4, 5}};
  const Simplex slanted{2, {0, 1, 2}};
  EXPECT_EQ(verdict_on(wedge, kOrigin, {1, 2}, {fold, left, right}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(wedge, kOrigin, {1, 2, 3}, {fold, left, right, whole}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(wedge, kOrigin, {1, 2, 3}, {fold, left, right, {3, {0, 1, 2, 4}}}), Verdict::kFails);
  EXPECT_EQ(verdict_on(wedge, kOrigin, {1, 2, 3}, {fold, left, slanted, {3, {0, 1, 2, 4}}}), Verdict::kPerturbed);
  const Truly filled({{5, 0, 0}, {-5, 0, 0}, {3, 4, 0}, {-3, 4, 0}, {4, 0, 3}, {-4, 0, 3}, {0, 3, 4}});
  EXPECT_EQ(verdict_on(filled, kOrigin, {1, 2}, {fold, left, right}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(filled, kOrigin, {1, 2}, {fold, left, right, {2, {0, 1, 6}}}), Verdict::kFails);
}

// The line from an apex through the centre leaves the pyramid through its base, or through an edge of that.
TEST(PerturbedFindings, OnePyramidAtMostHasTheCentreInside) {
  CITES("FC-CLAIM-04");
  const std::vector<Point> rows = {{356, 0, -267},    {0, 356, -267}, {-356, 0, -267}, {0, -356, -267},
                                   {-300, -112, 309}, {0, 0, 445},    {0, 267, 356}};
  std::vector<PointId> place(rows.size());
  std::iota(place.begin(), place.end(), PointId{0});
  std::mt19937 random(1);
  for (int round = 0; round < 100; ++round) {
    std::ranges::shuffle(place, random);
    std::vector<Point> moved(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) moved[place[k]] = rows[k];
    const Truly truly(moved);
    const auto pyramid = [&](std::size_t apex) {
      Ids names = {place[0], place[1], place[2], place[3], place[apex]};
      std::ranges::sort(names);
      return Simplex{3, names};
    };
    const auto both = [&](std::size_t a, std::size_t b) {
      return verdict_on(truly, kOrigin, {3}, {pyramid(a), pyramid(b)});
    };
    ASSERT_EQ(both(5, 6), Verdict::kFails);
    ASSERT_EQ(both(4, 5), Verdict::kPerturbed);
    ASSERT_EQ(both(6, 4), Verdict::kPerturbed);
  }
}

// The numbers of points of the indices that are not claimed have to be possible.
TEST(PerturbedFindings, SumsOfSomeIndices) {
  CITES("FC-CLAIM-12", "FC-CLAIM-04");
  const Truly half(kHalfOctahedron), cube(kCube), square(kSquare);
  const auto of_half = [&](const std::vector<int>& indices, const std::vector<Simplex>& made) {
    return verdict_on(half, kOrigin, indices, made);
  };
  const Simplex edge{1, {0, 1}}, one{2, {0, 1, 2}}, other{2, {0, 1, 3}}, upright{2, {0, 1, 4}}, across{2, {2, 3, 4}};
  const Simplex front{3, {0, 1, 2, 4}}, back{3, {0, 1, 3, 4}};
  EXPECT_EQ(of_half({2, 3}, {front, back}), Verdict::kFails) << "-2 edges";
  EXPECT_EQ(of_half({2, 3}, {front, back, one}), Verdict::kFails) << "-1 edge";
  EXPECT_EQ(of_half({2, 3}, {front, back, one, other}), Verdict::kPerturbed);
  EXPECT_EQ(of_half({2, 3}, {front, back, one, other, upright}), Verdict::kPerturbed);
  EXPECT_EQ(of_half({2, 3}, {one, other}), Verdict::kPerturbed) << "two edges";
  EXPECT_EQ(of_half({2, 3}, {one, other, upright}), Verdict::kFails) << "three edges";
  EXPECT_EQ(of_half({2, 3}, {one, other, upright, across}), Verdict::kFails) << "four edges";
  EXPECT_EQ(of_half({1, 2}, {edge}), Verdict::kFails) << "-1 tetrahedron";
  EXPECT_EQ(of_half({1, 2}, {edge, one}), Verdict::kPerturbed);
  EXPECT_EQ(of_half({1, 2}, {one, other, upright}), Verdict::kPerturbed) << "three tetrahedra";
  EXPECT_EQ(of_half({1, 3}, {edge, front, back}), Verdict::kPerturbed);
  EXPECT_EQ(of_half({1, 2, 3}, {edge, front, back, one, other}), Verdict::kFails);
  EXPECT_EQ(of_half({1, 2, 3}, {edge, front, back, one, other, upright}), Verdict::kPerturbed);
  // One of the index of a critical point is there.
  const Simplex diagonal{1, {0, 7}}, plane{2, {0, 1, 7}}, next{2, {0, 2, 7}};
  EXPECT_EQ(verdict_on(cube, kMiddle, {1, 2}, {diagonal}), Verdict::kFails);
  EXPECT_EQ(verdict_on(cube, kMiddle, {1, 2}, {diagonal, plane}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(cube, kMiddle, {1, 2}, {diagonal, plane, next}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(cube, kMiddle, {1, 3}, {diagonal}), Verdict::kFails) << "no index 3";
  EXPECT_EQ(verdict_on(square, kOrigin, {1, 3}, {edge}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(square, kOrigin, {1, 2}, {edge}), Verdict::kFails) << "no index 2";
}

// Where the index of a critical point is not claimed, one point of another index can be what a perturbation makes.
TEST(PerturbedFindings, OnePointOfAnotherIndex) {
  CITES("FC-CLAIM-12");
  const Truly square(kSquare), triangle({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}});
  const Simplex tetrahedron{3, {0, 1, 2, 3}};
  EXPECT_EQ(verdict_on(square, kOrigin, {3}, {tetrahedron}), Verdict::kPerturbed);
  EXPECT_EQ(verdict_on(square, kOrigin, {2, 3}, {tetrahedron}), Verdict::kFails);
  const auto at_center = [](const Truly& truly, const RationalPoint& x, bool is_index_2_judged) {
    CheckOptions options;
    options.indices = {false, false, is_index_2_judged, true};
    return truly.check(Claimed().at(3, exactly(x)), options).verdict;
  };
  EXPECT_EQ(at_center(square, kOrigin, false), Verdict::kPerturbed);
  EXPECT_EQ(at_center(square, kOrigin, true), Verdict::kFails);
  EXPECT_EQ(at_center(triangle, {2, 1, 0}, false), Verdict::kFails);
}

}  // namespace
}  // namespace flowcert::perturbed_findings_test
