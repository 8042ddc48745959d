// The oracle's exact geometry on examples computed by hand: circumcentres, affine hulls, faces of convex
// hulls.
//
// Each expected value was worked out on paper and is an exact rational; comparisons are for equality.
#include <gtest/gtest.h>

#include <limits>

#include "oracle/exact_geometry.h"
#include "tests/cites.h"

namespace oracle_geometry_test {
namespace {

using oracle::Point;
using oracle::Rational;
using Points = std::vector<Point>;

constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();

Point point(int x, int y, int z) { return {Rational(x), Rational(y), Rational(z)}; }

Rational ratio(int numerator, int denominator) { return Rational(numerator) / denominator; }

const Points kSquare = {point(0, 0, 0), point(2, 0, 0), point(2, 2, 0), point(0, 2, 0)};
const Points kOctahedron = {point(1, 0, 0),  point(-1, 0, 0), point(0, 1, 0),
                            point(0, -1, 0), point(0, 0, 1),  point(0, 0, -1)};

TEST(OracleExact, TakesDoublesAsTheyAre) {
  CITES("FC-IN-02");
  const Point x = oracle::exact({0.1, kSubnormal, -0.0});
  EXPECT_EQ(x[0].str(), "3602879701896397/36028797018963968");
  EXPECT_EQ(x[1], Rational(1) / (oracle::Integer(1) << 1074));
  EXPECT_EQ(x[2], 0);
  EXPECT_EQ(oracle::exact({std::numeric_limits<double>::max(), 0, 0})[0],
            Rational(((oracle::Integer(1) << 53) - 1) << 971));
}

TEST(OraclePoints, AreCalculatedWithExactly) {
  CITES("FC-CRIT-05");
  const Point a = point(1, 2, 3), b = point(4, -5, 6);
  EXPECT_EQ(oracle::minus(a, b), point(-3, 7, -3));
  EXPECT_EQ(oracle::dot(a, b), 12);
  EXPECT_EQ(oracle::cross(a, b), point(27, 6, -13));
  EXPECT_EQ(oracle::moved(a, ratio(1, 3), b), (Point{ratio(7, 3), ratio(1, 3), 5}));
  EXPECT_EQ(oracle::squared_distance(a, b), 67);
}

TEST(OracleCircumcentre, OfOneToFourPoints) {
  CITES("FC-CRIT-05");
  const auto one = oracle::circumcentre({point(3, 1, 4)});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->center, point(3, 1, 4));
  EXPECT_EQ(one->weights, (std::vector<Rational>{1}));

  const auto two = oracle::circumcentre({point(0, 0, 0), point(1, 2, 3)});
  ASSERT_TRUE(two);
  EXPECT_EQ(two->center, (Point{ratio(1, 2), 1, ratio(3, 2)}));
  EXPECT_EQ(two->weights, (std::vector<Rational>{ratio(1, 2), ratio(1, 2)}));

  // A right triangle: the middle of the hypotenuse, weight 0 at the right angle.
  const auto three = oracle::circumcentre({point(0, 0, 1), point(3, 0, 1), point(0, 4, 1)});
  ASSERT_TRUE(three);
  EXPECT_EQ(three->center, (Point{ratio(3, 2), 2, 1}));
  EXPECT_EQ(three->weights, (std::vector<Rational>{0, ratio(1, 2), ratio(1, 2)}));

  const auto four = oracle::circumcentre({point(0, 0, 0), point(2, 0, 0), point(0, 2, 0), point(0, 0, 2)});
  ASSERT_TRUE(four);
  EXPECT_EQ(four->center, point(1, 1, 1));
  EXPECT_EQ(four->weights, (std::vector<Rational>{ratio(-1, 2), ratio(1, 2), ratio(1, 2), ratio(1, 2)}));
}

TEST(OracleCircumcentre, OfAnObtuseTriangleIsOutside) {
  CITES("FC-CRIT-05");
  // (0,0), (4,0), (1,1): the centre (2,y) has 4 + y^2 = 1 + (y-1)^2, so y = -1.
  const auto obtuse = oracle::circumcentre({point(0, 0, 0), point(4, 0, 0), point(1, 1, 0)});
  ASSERT_TRUE(obtuse);
  EXPECT_EQ(obtuse->center, point(2, -1, 0));
  EXPECT_LT(obtuse->weights[2], 0);
}

TEST(OracleCircumcentre, DependentPointsHaveNone) {
  CITES("FC-CRIT-05");
  EXPECT_FALSE(oracle::circumcentre({}));
  EXPECT_FALSE(oracle::circumcentre({point(1, 1, 1), point(1, 1, 1)}));
  EXPECT_FALSE(oracle::circumcentre({point(0, 0, 0), point(1, 1, 1), point(3, 3, 3)}));
  EXPECT_FALSE(oracle::circumcentre(kSquare));  // cocircular, but not independent
  EXPECT_FALSE(oracle::circumcentre(kOctahedron));
}

TEST(OracleInnerCircumcentre, OnlyInTheRelativeInterior) {
  CITES("FC-CRIT-05");
  EXPECT_EQ(oracle::inner_circumcentre({point(3, 1, 4)}), point(3, 1, 4));
  EXPECT_EQ(oracle::inner_circumcentre({point(0, 0, 0), point(2, 4, 6)}), point(1, 2, 3));
  EXPECT_EQ(oracle::inner_circumcentre({point(-3, -4, 1), point(-3, 4, 1), point(5, 0, 1)}), point(0, 0, 1));
  // A right angle, and an obtuse one at the first and at the last point.
  EXPECT_FALSE(oracle::inner_circumcentre({point(0, 0, 1), point(3, 0, 1), point(0, 4, 1)}));
  EXPECT_FALSE(oracle::inner_circumcentre({point(1, 1, 0), point(0, 0, 0), point(4, 0, 0)}));
  EXPECT_FALSE(oracle::inner_circumcentre({point(0, 0, 0), point(4, 0, 0), point(1, 1, 0)}));
  EXPECT_FALSE(oracle::inner_circumcentre({}));
  EXPECT_FALSE(oracle::inner_circumcentre(kSquare));
  EXPECT_FALSE(oracle::inner_circumcentre(kOctahedron));
}

TEST(OracleBarycentric, InAndOffTheHull) {
  CITES("FC-CRIT-02");
  const Points triangle = {point(0, 0, 0), point(4, 0, 0), point(0, 4, 0)};
  EXPECT_EQ(oracle::barycentric(triangle, point(1, 2, 0)).value(),
            (std::vector<Rational>{ratio(1, 4), ratio(1, 4), ratio(1, 2)}));
  EXPECT_EQ(oracle::barycentric(triangle, point(-4, 0, 0)).value(), (std::vector<Rational>{2, -1, 0}));
  EXPECT_FALSE(oracle::barycentric(triangle, {1, 2, Rational(kSubnormal)}));
  EXPECT_FALSE(oracle::barycentric(kSquare, point(1, 1, 0)));
  EXPECT_FALSE(oracle::barycentric(kOctahedron, point(0, 0, 0)));
  EXPECT_FALSE(oracle::barycentric({}, point(0, 0, 0)));
}

TEST(OracleAffineDimension, OfEachDimension) {
  CITES("FC-CRIT-02");
  EXPECT_EQ(oracle::affine_dimension({}), -1);
  EXPECT_EQ(oracle::affine_dimension({point(7, 7, 7), point(7, 7, 7)}), 0);
  EXPECT_EQ(oracle::affine_dimension({point(0, 0, 0), point(1, 1, 1), point(-5, -5, -5)}), 1);
  EXPECT_EQ(oracle::affine_dimension(kSquare), 2);
  EXPECT_EQ(oracle::affine_dimension(kOctahedron), 3);
  Points nearly_flat = kSquare;
  nearly_flat.push_back({1, 1, Rational(kSubnormal)});
  EXPECT_EQ(oracle::affine_dimension(nearly_flat), 3);
}

TEST(OracleFaceDimension, OfASquare) {
  CITES("FC-CRIT-02", "FC-CRIT-03");
  EXPECT_EQ(oracle::face_dimension(kSquare, point(2, 2, 0)), 0);
  EXPECT_EQ(oracle::face_dimension(kSquare, point(1, 0, 0)), 1);
  // The diagonals, which are no faces, cross in the relative interior of the square.
  EXPECT_EQ(oracle::face_dimension(kSquare, point(1, 1, 0)), 2);
  EXPECT_EQ(oracle::face_dimension(kSquare, {ratio(1, 3), ratio(1, 7), 0}), 2);
  EXPECT_EQ(oracle::face_dimension(kSquare, point(3, 1, 0)), std::nullopt);
  EXPECT_EQ(oracle::face_dimension(kSquare, {1, 1, Rational(kSubnormal)}), std::nullopt);
  EXPECT_EQ(oracle::face_dimension(kSquare, {1, Rational(-kSubnormal), 0}), std::nullopt);
}

TEST(OracleFaceDimension, OfAnOctahedron) {
  CITES("FC-CRIT-02", "FC-CRIT-03");
  EXPECT_EQ(oracle::face_dimension(kOctahedron, point(0, 0, 0)), 3);
  EXPECT_EQ(oracle::face_dimension(kOctahedron, {ratio(1, 3), ratio(1, 3), ratio(1, 3)}), 2);
  EXPECT_EQ(oracle::face_dimension(kOctahedron, {ratio(1, 2), 0, ratio(-1, 2)}), 1);
  EXPECT_EQ(oracle::face_dimension(kOctahedron, {ratio(1, 2), 0, 0}), 3);
  EXPECT_EQ(oracle::face_dimension(kOctahedron, {ratio(1, 2), ratio(1, 2), Rational(kSubnormal)}), std::nullopt);
  // Without one vertex, (0,0,0) lies on the square face that appears; without one more, on an edge.
  const Points pyramid(kOctahedron.begin(), kOctahedron.end() - 1);
  EXPECT_EQ(oracle::face_dimension(pyramid, point(0, 0, 0)), 2);
  const Points wedge = {kOctahedron[0], kOctahedron[1], kOctahedron[2], kOctahedron[4]};
  EXPECT_EQ(oracle::face_dimension(wedge, point(0, 0, 0)), 1);
}

TEST(OracleFaceDimension, OfOnePointAndOfNone) {
  CITES("FC-CRIT-02", "FC-CRIT-04");
  EXPECT_EQ(oracle::face_dimension({point(1, 2, 3)}, point(1, 2, 3)), 0);
  EXPECT_EQ(oracle::face_dimension({point(1, 2, 3)}, point(1, 2, 4)), std::nullopt);
  EXPECT_EQ(oracle::face_dimension({}, point(0, 0, 0)), std::nullopt);
}

}  // namespace
}  // namespace oracle_geometry_test
