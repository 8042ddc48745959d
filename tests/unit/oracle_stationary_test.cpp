// The oracle's list of stationary points on sets computed by hand, and its judgement of right and of mutated
// claims.
//
// All comparisons are exact. Where a count is not obvious, the argument is beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "oracle/stationary_points.h"
#include "tests/cites.h"

namespace oracle_stationary_test {
namespace {

using oracle::Answer;
using oracle::PointSet;
using oracle::Rational;
using oracle::StationaryPoint;
using Rows = std::vector<std::array<double, 3>>;
using Four = std::array<std::size_t, 4>;
using Three = std::array<std::size_t, 3>;

constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();
constexpr double kGreatest = std::numeric_limits<double>::max();

Rational ratio(int numerator, int denominator) { return Rational(numerator) / denominator; }

Rows lattice(int kx, int ky, int kz, double step = 1) {
  Rows rows;
  for (int x = 0; x < kx; ++x) {
    for (int y = 0; y < ky; ++y) {
      for (int z = 0; z < kz; ++z) rows.push_back({x * step, y * step, z * step});
    }
  }
  return rows;
}

void expect_counts(const Answer& answer, const Four& critical, const Three& regular) {
  EXPECT_EQ(answer.critical_counts(), critical);
  EXPECT_EQ(answer.regular_counts(), regular);
  // No further kind exists (FC-CRIT-03).
  EXPECT_EQ(critical[0] + critical[1] + critical[2] + critical[3] + regular[0] + regular[1] + regular[2],
            answer.stationary.size());
}

StationaryPoint regular_point(const Answer& answer) {
  for (const auto& s : answer.stationary) {
    if (s.face_dimension != s.hull_dimension) return s;
  }
  ADD_FAILURE() << "no regular stationary point";
  return {};
}

TEST(OracleStationary, UnitCube) {
  CITES("FC-CRIT-02", "FC-CRIT-04", "FC-OUT-01");
  const Answer answer = oracle::stationary_points(lattice(2, 2, 2));
  expect_counts(answer, {8, 12, 6, 1}, {0, 0, 0});
  const StationaryPoint& middle = answer.stationary.back();
  EXPECT_EQ(middle.center, (oracle::Point{ratio(1, 2), ratio(1, 2), ratio(1, 2)}));
  EXPECT_EQ(middle.squared_distance, ratio(3, 4));
  EXPECT_EQ(middle.contact, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(OracleStationary, RegularTetrahedron) {
  CITES("FC-CRIT-02");
  expect_counts(oracle::stationary_points({{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}), {4, 6, 4, 1}, {0, 0, 0});
}

// The 12 edges have midpoints at squared distance 1/2 from their ends and 3/2 from all else. The 8 faces are
// acute, and the plane of each has all other vertices on the centre's side. The three long diagonals meet in
// the centre.
TEST(OracleStationary, Octahedron) {
  CITES("FC-CRIT-02");
  const Answer answer =
      oracle::stationary_points({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  expect_counts(answer, {6, 12, 8, 1}, {0, 0, 0});
  EXPECT_EQ(answer.stationary.back().contact.size(), 6U);
}

// The points are (0, +-a, +-b) and its cyclic shifts, and b/a is 13/8 or 144/89, next to the golden ratio.
// All 12 lie on one sphere around 0, and the hull has the 20 faces of the icosahedron. 8 are equilateral, of
// squared side a^2 + b^2 + (b-a)^2; the others have two such sides and one of 4 a^2, which is less than twice
// as much. So all 20 faces are acute and critical. All 30 edges are critical: their diametral spheres have
// the apexes of both faces outside, and by convexity all other points. 0 is strictly inside.
TEST(OracleStationary, NearlyAnIcosahedron) {
  CITES("FC-CRIT-02", "FC-INV-01");
  for (const auto& [a, b] : {std::pair{8.0, 13.0}, std::pair{89.0, 144.0}}) {
    Rows rows;
    for (const double u : {a, -a}) {
      for (const double v : {b, -b}) rows.insert(rows.end(), {{0, u, v}, {u, v, 0}, {v, 0, u}});
    }
    const Answer answer = oracle::stationary_points(rows);
    expect_counts(answer, {12, 30, 20, 1}, {0, 0, 0});
    EXPECT_EQ(answer.stationary.back().center, (oracle::Point{0, 0, 0}));
    EXPECT_EQ(answer.stationary.back().squared_distance, Rational(a * a + b * b));
  }
}

TEST(OracleStationary, RightTriangleIsOfKind12) {
  CITES("FC-CRIT-03");
  const Answer answer = oracle::stationary_points({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  expect_counts(answer, {3, 2, 0, 0}, {1, 0, 0});
  EXPECT_EQ(regular_point(answer), (StationaryPoint{{ratio(3, 2), 2, 0}, ratio(25, 4), {0, 1, 2}, 1, 2}));
}

// The smallest change of the right angle makes an acute triangle (index 1 and index 2 apart) or an obtuse one
// (neither).
TEST(OracleStationary, NearlyRightTriangles) {
  CITES("FC-CRIT-03", "FC-NUM-01");
  expect_counts(oracle::stationary_points({{-kSubnormal, 0, 0}, {3, 0, 0}, {0, 4, 0}}), {3, 3, 1, 0}, {0, 0, 0});
  expect_counts(oracle::stationary_points({{kSubnormal, 0, 0}, {3, 0, 0}, {0, 4, 0}}), {3, 2, 0, 0}, {0, 0, 0});
}

// The base triangle is acute, with its centre 0 strictly inside; the apex is above 0, at the same distance.
// The three other faces (squared sides 80 50 50, 80 50 50 and 64 50 50) are acute and have 0 on their inner
// side.
TEST(OracleStationary, CentreInATriangleIsOfKind23) {
  CITES("FC-CRIT-03");
  const Answer answer = oracle::stationary_points({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}});
  expect_counts(answer, {4, 6, 3, 0}, {0, 0, 1});
  EXPECT_EQ(regular_point(answer), (StationaryPoint{{0, 0, 0}, 25, {0, 1, 2, 3}, 2, 3}));
}

TEST(OracleStationary, CentreOnAnEdgeIsOfKind13) {
  CITES("FC-CRIT-03");
  const Answer answer = oracle::stationary_points({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  expect_counts(answer, {4, 5, 2, 0}, {0, 1, 0});
  EXPECT_EQ(regular_point(answer), (StationaryPoint{{0, 0, 0}, 1, {0, 1, 2, 3}, 1, 3}));
}

TEST(OracleStationary, CubicLattices) {
  CITES("FC-INV-05", "FC-INV-01");
  for (int k = 1; k <= 3; ++k) {
    const auto n = static_cast<std::size_t>(k);
    const std::size_t m = n - 1;
    expect_counts(oracle::stationary_points(lattice(k, k, k)), {n * n * n, 3 * m * n * n, 3 * m * m * n, m * m * m},
                  {0, 0, 0});
  }
}

TEST(OracleStationary, FewPoints) {
  CITES("FC-IN-04", "FC-INV-01");
  expect_counts(oracle::stationary_points({}), {0, 0, 0, 0}, {0, 0, 0});
  expect_counts(oracle::stationary_points({{1, 2, 3}}), {1, 0, 0, 0}, {0, 0, 0});
  expect_counts(oracle::stationary_points({{1, 2, 3}, {3, 2, 1}}), {2, 1, 0, 0}, {0, 0, 0});
}

TEST(OracleStationary, CollinearPoints) {
  CITES("FC-IN-04");
  const Answer answer = oracle::stationary_points({{0, 0, 0}, {9, 9, 9}, {1, 1, 1}, {3, 3, 3}});
  expect_counts(answer, {4, 3, 0, 0}, {0, 0, 0});
  EXPECT_EQ(answer.stationary[4].contact, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(answer.stationary[5].contact, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(answer.stationary[6].contact, (std::vector<std::size_t>{2, 3}));
}

TEST(OracleStationary, CoplanarGrids) {
  CITES("FC-IN-04");
  expect_counts(oracle::stationary_points(lattice(2, 2, 1)), {4, 4, 1, 0}, {0, 0, 0});
  expect_counts(oracle::stationary_points({{0, 0, 0}, {7, 0, 0}, {7, 1, 0}, {0, 1, 0}}), {4, 4, 1, 0}, {0, 0, 0});
  expect_counts(oracle::stationary_points(lattice(4, 1, 3)), {12, 17, 6, 0}, {0, 0, 0});
}

TEST(OracleStationary, DuplicatesAreMerged) {
  CITES("FC-IN-03", "FC-IN-02");
  const Answer answer = oracle::stationary_points({{0, 0, 0}, {2, 0, -0.0}, {0, -0.0, 0}, {2, 0, 0.0}, {0, 0, 0}});
  EXPECT_EQ(answer.points, 5U);
  EXPECT_EQ(answer.merged_duplicates, 3U);
  expect_counts(answer, {2, 1, 0, 0}, {0, 0, 0});
  EXPECT_EQ(answer.stationary[2], (StationaryPoint{{1, 0, 0}, 1, {0, 1}, 1, 1}));
}

TEST(OracleStationary, AllMagnitudes) {
  CITES("FC-IN-04", "FC-NUM-01");
  expect_counts(oracle::stationary_points(lattice(2, 2, 2, kSubnormal)), {8, 12, 6, 1}, {0, 0, 0});
  expect_counts(oracle::stationary_points({{0, 0, 0}, {1e-300, 0, 0}, {1e300, 0, 0}}), {3, 2, 0, 0}, {0, 0, 0});
  // A right angle at the origin, its legs 600 powers of ten apart.
  const Answer right = oracle::stationary_points({{0, 0, 0}, {1e-300, 0, 0}, {0, 1e300, 0}});
  expect_counts(right, {3, 2, 0, 0}, {1, 0, 0});
  EXPECT_EQ(regular_point(right).center, (oracle::Point{Rational(1e-300) / 2, Rational(1e300) / 2, 0}));
  const Answer wide = oracle::stationary_points({{kGreatest, 0, 0}, {-kGreatest, 0, 0}, {0, kSubnormal, 0}});
  expect_counts(wide, {3, 2, 0, 0}, {0, 0, 0});
}

TEST(OracleStationary, CoordinatesHaveToBeFinite) {
  CITES("FC-IN-01");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(oracle::stationary_points({{0, 0, 0}, {0, std::nan(""), 0}}), std::invalid_argument);
  EXPECT_THROW(oracle::stationary_points({{infinity, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(oracle::stationary_points({{0, 0, -infinity}}), std::invalid_argument);
}

TEST(OracleStationary, OrderOfTheList) {
  CITES("FC-OUT-02", "FC-CRIT-06");
  // Kinds 1-2, 1-3 and 2-3, far enough from each other.
  Rows rows = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  rows.insert(rows.end(), {{101, 0, 0}, {99, 0, 0}, {100, 1, 0}, {100, 0, 1}});
  rows.insert(rows.end(), {{205, 0, 0}, {197, 4, 0}, {197, -4, 0}, {200, 0, 5}});
  const Answer answer = oracle::stationary_points(rows);
  EXPECT_GE(answer.count(1, 2), 1U);
  EXPECT_GE(answer.count(1, 3), 1U);
  EXPECT_GE(answer.count(2, 3), 1U);
  const std::vector<std::pair<int, int>> order = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 2}, {1, 3}, {2, 3}};
  const auto group = [&](const StationaryPoint& s) {
    return std::find(order.begin(), order.end(), std::pair(s.face_dimension, s.hull_dimension)) - order.begin();
  };
  for (std::size_t i = 1; i < answer.stationary.size(); ++i) {
    const StationaryPoint& a = answer.stationary[i - 1];
    const StationaryPoint& b = answer.stationary[i];
    EXPECT_TRUE(group(a) < group(b) || (group(a) == group(b) && a.contact < b.contact)) << "at " << i;
    EXPECT_NE(a.center, b.center);
  }
}

TEST(OracleContactSet, OfAnyPoint) {
  CITES("FC-DIST-01");
  const PointSet square({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  EXPECT_EQ(oracle::contact_set(square, {ratio(1, 2), ratio(1, 2), 9}), (std::vector<std::size_t>{0, 1, 3, 4}));
  EXPECT_EQ(oracle::contact_set(square, {ratio(1, 2), ratio(1, 3), 0}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(oracle::contact_set(square, {ratio(1, 2) + Rational(kSubnormal), ratio(1, 3), 0}),
            (std::vector<std::size_t>{1}));
  EXPECT_TRUE(oracle::contact_set(PointSet(Rows{}), {0, 0, 0}).empty());
}

class OracleCertify : public ::testing::Test {
 protected:
  static std::string clause(const PointSet& set, const StationaryPoint& claim) {
    const auto fault = oracle::certify(set, claim);
    return fault ? fault->clause : "right";
  }
  static std::string on_square(const StationaryPoint& claim) {
    return clause(PointSet({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}, {9, 1, 0}}), claim);
  }
};

TEST_F(OracleCertify, AcceptsWhatTheSearchFinds) {
  CITES("FC-CRIT-05");
  for (const Rows& rows :
       {lattice(2, 2, 2), lattice(3, 2, 2), lattice(3, 3, 1), Rows{{5, 5, 5}},
        Rows{{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}, {1, 0, 1}},
        Rows{{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}}, Rows{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}) {
    const PointSet set(rows);
    for (const auto& s : oracle::stationary_points(rows).stationary) EXPECT_EQ(clause(set, s), "right");
  }
}

TEST_F(OracleCertify, RejectsListsThatAreNoContactSets) {
  CITES("FC-OUT-01", "FC-IN-03");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2, 3}, 2, 2}), "right");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {}, 2, 2}), "FC-OUT-01");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 3, 2}, 2, 2}), "FC-OUT-01");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2, 2, 3}, 2, 2}), "FC-OUT-01");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {1, 2, 3, 4}, 2, 2}), "FC-IN-03");  // 4 was merged into 0
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2, 99}, 2, 2}), "FC-IN-03");
}

TEST_F(OracleCertify, RejectsByTheFirstConditionThatFails) {
  CITES("FC-CRIT-05");
  // (a) Three points of a line; then the square's corners and a point that is not on their sphere.
  EXPECT_EQ(clause(PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), {{1, 0, 0}, 1, {0, 1, 2}, 1, 1}), "FC-CRIT-05 (a)");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2, 3, 5}, 2, 2}), "FC-CRIT-05 (a)");
  // (b) a point strictly inside.
  EXPECT_EQ(clause(PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), {{1, 0, 0}, 1, {0, 2}, 1, 1}), "FC-CRIT-05 (b)");
  // (c) the diagonal of the square, and the square without a corner.
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 2}, 1, 1}), "FC-CRIT-05 (c)");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2}, 1, 2}), "FC-CRIT-05 (c)");
  // (d) an obtuse triangle whose circle is empty.
  EXPECT_EQ(clause(PointSet({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}), {{2, -1, 0}, 5, {0, 1, 2}, 2, 2}), "FC-CRIT-05 (d)");
}

TEST_F(OracleCertify, NamesAPointThatMakesItFail) {
  CITES("FC-CRIT-05");
  const auto fault =
      oracle::certify(PointSet({{0, 0, 0}, {7, 7, 7}, {4, 0, 0}, {1, 0, 0}}), {{2, 0, 0}, 4, {0, 2}, 1, 1});
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->explanation.find("point 3 is at squared distance 1 from (2, 0, 0)"), std::string::npos)
      << fault->explanation;
}

TEST_F(OracleCertify, RejectsAWrongCenterAndDistance) {
  CITES("FC-OUT-01");
  EXPECT_EQ(on_square({{1, 1, Rational(kSubnormal)}, 2, {0, 1, 2, 3}, 2, 2}), "FC-OUT-01");
  EXPECT_EQ(on_square({{1, 1, 0}, 2 + Rational(kSubnormal), {0, 1, 2, 3}, 2, 2}), "FC-OUT-01");
}

TEST_F(OracleCertify, RejectsAWrongIndex) {
  CITES("FC-CRIT-02", "FC-CRIT-03");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2, 3}, 1, 2}), "FC-CRIT-02");
  EXPECT_EQ(on_square({{1, 1, 0}, 2, {0, 1, 2, 3}, 3, 3}), "FC-CRIT-02");
  const PointSet right_triangle({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  EXPECT_EQ(clause(right_triangle, {{ratio(3, 2), 2, 0}, ratio(25, 4), {0, 1, 2}, 1, 2}), "right");
  EXPECT_EQ(clause(right_triangle, {{ratio(3, 2), 2, 0}, ratio(25, 4), {0, 1, 2}, 2, 2}), "FC-CRIT-03");
  EXPECT_EQ(clause(right_triangle, {{ratio(3, 2), 2, 0}, ratio(25, 4), {0, 1, 2}, 1, 3}), "FC-CRIT-03");
}

}  // namespace
}  // namespace oracle_stationary_test
