// fast::PointSet against the plain one: each of its functions, and what all of the oracle makes of them, on
// inputs of all families and on hand-made ones, from subnormals to the largest doubles. Critical points of balls from
// near subsets against those from all.
//
// Guarantees: exact equality; and each sort of answer that a function can give was among those compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "fuzz/inputs/stable_configurations.h"
#include "oracle/fast/near_balls.h"
#include "oracle/fast/point_set.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_set.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace oracle::oracle_fast_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;

constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();
constexpr double kGreatest = std::numeric_limits<double>::max();
constexpr std::size_t kMostPoints = 8;

struct Case {
  std::string name;
  Rows rows;
};

Rows times(double factor, Rows rows) {
  for (auto& row : rows) {
    for (double& coordinate : row) coordinate *= factor;
  }
  return rows;
}

std::vector<Case> hand_made_cases() {
  const Rows octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
  const Rows square = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1, 1, 1}, {5, 1, 1}};
  const Rows sphere = {{3, 4, 0}, {-5, 0, 0}, {0, -3, 4}, {0, 3, -4}, {4, 0, 3}, {3, -4, 0}, {0, 0, 5}};
  Rows random_doubles;
  flowcert_tests::PortableRandom random(1);
  for (std::size_t i = 0; i < 8; ++i) {
    random_doubles.push_back({random.coordinate(), random.coordinate(), random.coordinate()});
  }
  return {
      {"none", {}},
      {"one", {{1, 2, 3}}},
      {"repeated", {{1, 2, 0.0}, {1, 2, -0.0}, {4, 2, 0}}},
      {"collinear", {{0, 0, 0}, {9, 9, 9}, {1, 1, 1}, {3, 3, 3}, {-4, -4, -4}}},
      {"octahedron", octahedron},
      {"subnormal octahedron", times(kSubnormal, octahedron)},
      {"greatest octahedron", times(kGreatest, octahedron)},
      {"square", square},
      {"sphere", sphere},
      {"tiny sphere", times(0x1p-1070, sphere)},
      {"huge sphere", times(0x1p1020, sphere)},
      {"random doubles", random_doubles},
      {"subnormal beside greatest", {{kSubnormal, 0, 0}, {0, kGreatest, 0}, {0, 0, -kGreatest}, {1, 1, 1}, {0, 0, 0}}},
      {"nearly flat", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, kSubnormal}, {2, 2, -kSubnormal}}}};
}

std::vector<Case> drawn_cases() {
  std::vector<Case> cases;
  for (const auto& family : flowcert::fuzz::families_and_stable_ones()) {
    for (const int size : {20, 80}) {
      Rows rows = flowcert::fuzz::draw(family, 7, size).rows;
      rows.resize(std::min(rows.size(), kMostPoints));
      cases.push_back({family.name + " " + std::to_string(size), rows});
    }
  }
  return cases;
}

// How often a function gave each of its sorts of answers.
struct Tally {
  std::size_t centres = 0, no_centre = 0, meetings = 0, infinity = 0, clusters = 0;
};

// Samples, midpoints and centres of triples, where ties are, and two positions where none are.
std::vector<Point> positions(const PointSet& set) {
  std::vector<Point> result = {exact({0.1, -3, 1e9}), {Rational(1) / 3, Rational(-2) / 7, 0}};
  for_each_subset(set.points.size(), 3, [&](const Places& subset) {
    if (const auto sphere = circumcentre(select(set.points, subset))) result.push_back(sphere->center);
  });
  return result;
}

void expect_same_simplices(const PointSet& plain, const PointSet& fast, Tally& tally) {
  EXPECT_EQ(fast.inner_circumcentre({}), std::nullopt);
  for_each_subset(plain.points.size(), 5, [&](const Places& subset) {
    const auto centre = plain.inner_circumcentre(subset);
    EXPECT_EQ(fast.inner_circumcentre(subset), centre);
    ++(centre ? tally.centres : tally.no_centre);
  });
}

// Directions towards each sample, away from it, and at right angles to two of them.
std::vector<Point> directions(const PointSet& set, const Point& x) {
  std::vector<Point> result = {cross(minus(set.points.front(), x), minus(set.points.back(), x))};
  for (const Point& p : set.points) {
    result.push_back(minus(p, x));
    result.push_back(minus(x, p));
  }
  return result;
}

void expect_same_scans(const PointSet& plain, const PointSet& fast, Tally& tally) {
  for (const Point& x : positions(plain)) {
    const Places contact = plain.nearest_places(x);
    EXPECT_EQ(fast.nearest_places(x), contact);
    tally.clusters += contact.size() > 4 ? 1 : 0;
    if (contact.empty()) continue;
    for (const Point& u : directions(plain, x)) {
      for (const std::size_t p : crossed_places(plain, contact, u)) {
        const auto meeting = plain.first_meeting(p, x, u);
        EXPECT_EQ(fast.first_meeting(p, x, u), meeting);
        ++(meeting ? tally.meetings : tally.infinity);
      }
    }
  }
}

void expect_same_orbits(const PointSet& plain, const PointSet& fast) {
  const std::vector<Point> starts = positions(plain);
  for (std::size_t k = 0; k < starts.size(); k += 7) {
    const Orbit expected = orbit(plain, starts[k]), found = orbit(fast, starts[k]);
    EXPECT_EQ(found.limit, expected.limit);
    ASSERT_EQ(found.segments.size(), expected.segments.size());
    for (std::size_t i = 0; i < expected.segments.size(); ++i) {
      EXPECT_EQ(found.segments[i].driver, expected.segments[i].driver);
      EXPECT_EQ(found.segments[i].end, expected.segments[i].end);
      EXPECT_EQ(found.segments[i].end_contact, expected.segments[i].end_contact);
    }
  }
}

void expect_same_answers(const PointSet& plain, const PointSet& fast) {
  const Answer expected = stationary_points(plain);
  EXPECT_EQ(stationary_points(fast).stationary, expected.stationary);
  for (const StationaryPoint& z : expected.stationary) {
    EXPECT_FALSE(certify(fast, z));
    if (z.face_dimension == 3) continue;
    EXPECT_EQ(stable_set(fast, z), stable_set(plain, z));
  }
  EXPECT_EQ(persistence_pairs(fast), persistence_pairs(plain));
  if (!plain.points.empty()) expect_same_orbits(plain, fast);
}

Tally compared(const std::vector<Case>& cases) {
  Tally tally;
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const PointSet plain(one.rows);
    const fast::PointSet fast(one.rows);
    EXPECT_EQ(fast.names, plain.names);
    expect_same_simplices(plain, fast, tally);
    expect_same_scans(plain, fast, tally);
    if (::testing::Test::HasFailure()) break;  // what is made of wrong answers may never end
    expect_same_answers(plain, fast);
  }
  return tally;
}

void expect_all_sorts(const Tally& tally, std::size_t at_least) {
  for (const std::size_t count : {tally.centres, tally.no_centre, tally.meetings, tally.infinity, tally.clusters}) {
    EXPECT_GE(count, at_least);
  }
}

TEST(OracleFast, AgreesOnHandMadeInputs) {
  CITES("FC-DIST-01", "FC-CRIT-05", "FC-FLOW-01", "FC-NUM-01", "FC-IN-04");
  expect_all_sorts(compared(hand_made_cases()), 20);
}

TEST(OracleFast, AgreesOnAllFamilies) {
  CITES("FC-DIST-01", "FC-CRIT-05", "FC-FLOW-01", "FC-NUM-01", "FC-STAB-04");
  expect_all_sorts(compared(drawn_cases()), 40);
}

TEST(OracleFast, FindsTheSamePointsOfBalls) {
  CITES("FC-BALL-03");
  std::size_t points = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    flowcert_tests::PortableRandom random(seed);
    std::vector<Ball> balls;
    const auto number = [&](int most) { return Rational(random.between(0, most)); };
    for (int k = 0; k < 14; ++k) {
      balls.push_back({{number(9), number(9), number(9)}, Rational(random.between(1, 8), 4)});
    }
    const std::vector<BallPoint> right = critical_points(balls), found = fast::critical_points(balls);
    ASSERT_EQ(found.size(), right.size());
    for (std::size_t k = 0; k < right.size(); ++k) {
      EXPECT_EQ(found[k].index, right[k].index);
      EXPECT_EQ(found[k].contacts, right[k].contacts);
      EXPECT_EQ(found[k].value, right[k].value);
    }
    std::size_t all = 0;
    for_each_subset(balls.size(), 4, [&](const Places&) { ++all; });
    EXPECT_LT(fast::near_subsets(balls).size(), all);
    points += right.size();
  }
  EXPECT_GE(points, 100U);
}

TEST(OracleFast, RefusesWhatThePlainOneRefuses) {
  CITES("FC-IN-01");
  EXPECT_THROW(fast::PointSet({{0, std::numeric_limits<double>::infinity(), 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace oracle::oracle_fast_test
