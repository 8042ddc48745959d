// Explanations: why a set of points is, or is not, the contact set of a stationary point, and why a position
// is, or is not, stationary. Inputs made by hand meet each condition of the spec, with its witnesses.
//
// Explanations are compared with the list too: just what stationary_points() lists is explained as
// stationary. Whatever is said to fail does fail, by the definitions, in rationals.
#include "morse/explain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"
#include "tests/unit/rational_geometry.h"

namespace flowcert::explain_test {
namespace {

using flowcert_tests::exactly;
using flowcert_tests::inner;
using flowcert_tests::minus;
using flowcert_tests::PortableRandom;

using Ids = std::vector<PointId>;
constexpr StationaryIndex kMinimum{0, 0}, kIndex1{1, 1}, kIndex2{2, 2}, kIndex3{3, 3}, kKind12{1, 2}, kKind23{2, 3},
    kKind13{1, 3};

RationalPoint position(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z}; }

Explanation explained(const std::vector<Point>& rows, const Ids& ids) { return explain_points(PointSet(rows), ids); }

const std::vector<Point>& unit_cube() {
  static const std::vector<Point> rows = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  return rows;
}

TEST(ExplainPointsTest, CriticalPointsOfEachIndex) {
  CITES("FC-CRIT-02", "FC-CRIT-04", "FC-CRIT-05");
  const struct {
    Ids ids;
    StationaryIndex index;
    RationalPoint center;
    Rational squared_radius;
  } cases[] = {
      {{3}, kMinimum, position(1, 1, 0), 0},
      {{1, 0}, kIndex1, position(Rational(1) / 2, 0, 0), Rational(1) / 4},
      {{3, 1, 0, 2}, kIndex2, position(Rational(1) / 2, Rational(1) / 2, 0), Rational(1) / 2},
      {{7, 6, 5, 4, 3, 2, 1, 0}, kIndex3, position(Rational(1) / 2, Rational(1) / 2, Rational(1) / 2), Rational(3) / 4},
  };
  for (const auto& expected : cases) {
    const Explanation answer = explained(unit_cube(), expected.ids);
    ASSERT_TRUE(answer.index.has_value());
    EXPECT_EQ(*answer.index, expected.index);
    EXPECT_EQ(answer.clause, "FC-CRIT-02");
    EXPECT_FALSE(answer.reason.empty());
    ASSERT_TRUE(answer.sphere.has_value());
    EXPECT_EQ(answer.sphere->center, expected.center);
    EXPECT_EQ(answer.sphere->squared_radius, expected.squared_radius);
    EXPECT_EQ(answer.squared_distance, expected.squared_radius);
    Ids sorted = expected.ids;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(answer.contact, sorted);
    EXPECT_TRUE(answer.witnesses.empty());
    EXPECT_FALSE(answer.driver.has_value());
  }
}

TEST(ExplainPointsTest, RegularPointsOfEachKind) {
  CITES("FC-CRIT-03", "FC-CRIT-05");
  const struct {
    std::vector<Point> rows;
    StationaryIndex index;
  } cases[] = {
      {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, kKind12},
      {{{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}}, kKind23},
      {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, kKind13},
  };
  for (const auto& expected : cases) {
    Ids all;
    for (PointId id = 0; id < expected.rows.size(); ++id) all.push_back(id);
    const Explanation answer = explained(expected.rows, all);
    ASSERT_TRUE(answer.index.has_value());
    EXPECT_EQ(*answer.index, expected.index);
    EXPECT_EQ(answer.clause, "FC-CRIT-03");
    EXPECT_EQ(answer.contact, all);
    EXPECT_TRUE(answer.witnesses.empty());
  }
}

TEST(ExplainPointsTest, NoSphereCentredInTheirHull) {
  CITES("FC-CRIT-05");
  const std::vector<std::vector<Point>> inputs = {
      {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}},                        // collinear
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {3, 3, 0}},             // coplanar, not cocircular
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 2}},  // not cospherical
  };
  for (const std::vector<Point>& rows : inputs) {
    Ids all;
    for (PointId id = 0; id < rows.size(); ++id) all.push_back(id);
    const Explanation answer = explained(rows, all);
    EXPECT_FALSE(answer.index || answer.sphere || answer.driver);
    EXPECT_EQ(answer.clause, "FC-CRIT-05 (a)");
    EXPECT_TRUE(answer.contact.empty());
    // Any of these points may be the witnesses, but at least one has to be named.
    EXPECT_FALSE(answer.witnesses.empty());
    EXPECT_TRUE(std::includes(all.begin(), all.end(), answer.witnesses.begin(), answer.witnesses.end()));
  }
  // Coplanar points on a common sphere never fail (a): they also lie on a sphere around their circle's
  // centre. Three points that are not collinear always have a centre.
  EXPECT_NE(explained({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}).clause, "FC-CRIT-05 (a)");
}

TEST(ExplainPointsTest, APointInsideTheSphere) {
  CITES("FC-CRIT-05");
  const std::vector<Point> rows = {{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0.5, 0}, {9, 9, 9}, {2, 0, -0.5}};
  const Explanation answer = explained(rows, {0, 1});
  EXPECT_FALSE(answer.index.has_value());
  EXPECT_EQ(answer.clause, "FC-CRIT-05 (b)");
  EXPECT_EQ(answer.witnesses, (Ids{3, 5})) << "the nearest ones";
  EXPECT_EQ(answer.contact, (Ids{3, 5}));
  EXPECT_EQ(answer.squared_distance, Rational(1) / 4);
  ASSERT_TRUE(answer.sphere.has_value());
  EXPECT_EQ(answer.sphere->center, position(2, 0, 0));
  EXPECT_EQ(answer.sphere->squared_radius, 4);
}

// One ulp decides between (b), (c) and yes.
TEST(ExplainPointsTest, OneUlpAroundTheSphere) {
  CITES("FC-CRIT-05", "FC-NUM-01");
  const double in = std::nextafter(1.0, 0.0), out = std::nextafter(1.0, 2.0);
  const auto with = [](double y) { return explained({{-1, 0, 0}, {1, 0, 0}, {0, y, 0}}, {0, 1}); };
  EXPECT_EQ(with(in).clause, "FC-CRIT-05 (b)");
  EXPECT_EQ(with(1.0).clause, "FC-CRIT-05 (c)");
  EXPECT_EQ(with(out).clause, "FC-CRIT-02");
  EXPECT_EQ(with(out).index, kIndex1);
}

TEST(ExplainPointsTest, FurtherPointsOnTheSphere) {
  CITES("FC-CRIT-05");
  const Explanation diagonal = explained(unit_cube(), {0, 3});
  EXPECT_FALSE(diagonal.index.has_value());
  EXPECT_EQ(diagonal.clause, "FC-CRIT-05 (c)");
  EXPECT_EQ(diagonal.witnesses, (Ids{1, 2}));
  EXPECT_EQ(diagonal.contact, (Ids{0, 1, 2, 3}));
  const Explanation long_diagonal = explained(unit_cube(), {0, 7});
  EXPECT_EQ(long_diagonal.witnesses, (Ids{1, 2, 3, 4, 5, 6}));
}

TEST(ExplainPointsTest, CentreOutsideTheHull) {
  CITES("FC-CRIT-05", "FC-DIST-02");
  // An obtuse triangle: driven by the middle of its longest side.
  const Explanation triangle = explained({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}, {0, 1, 2});
  EXPECT_FALSE(triangle.index.has_value());
  EXPECT_EQ(triangle.clause, "FC-CRIT-05 (d)");
  EXPECT_EQ(triangle.contact, (Ids{0, 1, 2}));
  EXPECT_EQ(triangle.sphere.value().center, position(2, -1, 0));
  EXPECT_EQ(triangle.driver, position(2, 0, 0));
  // A cube's corner: driven by the centre of the slanted triangle.
  const Explanation corner = explained({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3});
  EXPECT_EQ(corner.clause, "FC-CRIT-05 (d)");
  EXPECT_EQ(corner.driver, position(Rational(1) / 3, Rational(1) / 3, Rational(1) / 3));
}

TEST(ExplainPointsTest, RepeatedRowsAreTheSamePoint) {
  CITES("FC-IN-03", "FC-CRIT-05");
  const std::vector<Point> rows = {{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {2, 0, -0.0}};
  for (const Ids& ids : {Ids{0, 1}, Ids{2, 3}, Ids{3, 0, 1, 2}}) {
    const Explanation answer = explained(rows, ids);
    EXPECT_EQ(answer.index, kIndex1);
    EXPECT_EQ(answer.contact, (Ids{0, 1}));
  }
  EXPECT_EQ(explained(rows, {2, 0, 2}).index, kMinimum);
}

TEST(ExplainPointsTest, RefusesWhatIsNoSetOfPoints) {
  CITES("FC-IN-03");
  EXPECT_THROW((void)explained(unit_cube(), {}), InvalidInput);
  EXPECT_THROW((void)explained(unit_cube(), {0, 8}), InvalidInput);
  EXPECT_THROW((void)explained({}, {0}), InvalidInput);
  EXPECT_THROW((void)explained({}, {}), InvalidInput);
  try {
    (void)explained(unit_cube(), {0, 8});
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "there is no point 8; the ids are 0 to 7");
  }
}

TEST(ExplainPositionTest, StationaryOnes) {
  CITES("FC-CRIT-01", "FC-CRIT-02", "FC-CRIT-03", "FC-DIST-01");
  const PointSet cube(unit_cube());
  const Rational half = Rational(1) / 2;
  EXPECT_EQ(explain_position(cube, position(1, 0, 1)).index, kMinimum);
  EXPECT_EQ(explain_position(cube, position(1, half, 1)).index, kIndex1);
  EXPECT_EQ(explain_position(cube, position(half, half, 1)).index, kIndex2);
  const Explanation middle = explain_position(cube, position(half, half, half));
  EXPECT_EQ(middle.index, kIndex3);
  EXPECT_EQ(middle.clause, "FC-CRIT-02");
  EXPECT_EQ(middle.contact, (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(middle.squared_distance, Rational(3) / 4);
  const PointSet right(std::vector<Point>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  const Explanation regular = explain_position(right, position(Rational(3) / 2, 2, 0));
  EXPECT_EQ(regular.index, kKind12);
  EXPECT_EQ(regular.clause, "FC-CRIT-03");
}

TEST(ExplainPositionTest, OthersHaveADriver) {
  CITES("FC-CRIT-01", "FC-DIST-01", "FC-DIST-02");
  const PointSet cube(unit_cube());
  const Rational third = Rational(1) / 3, half = Rational(1) / 2;
  const Explanation inside = explain_position(cube, position(third, third, third));
  EXPECT_FALSE(inside.index.has_value());
  EXPECT_EQ(inside.clause, "FC-CRIT-01");
  EXPECT_EQ(inside.contact, (Ids{0}));
  EXPECT_EQ(inside.squared_distance, third);
  EXPECT_EQ(inside.driver, position(0, 0, 0));
  const Explanation above = explain_position(cube, position(half, half, 5));
  EXPECT_EQ(above.contact, (Ids{4, 5, 6, 7}));
  EXPECT_EQ(above.driver, position(half, half, 1));
  const Explanation beside = explain_position(cube, position(half, third, 0));
  EXPECT_EQ(beside.contact, (Ids{0, 1}));
  EXPECT_EQ(beside.driver, position(half, 0, 0));
  EXPECT_THROW((void)explain_position(PointSet(), position(0, 0, 0)), InvalidInput);
}

// ---- Against the list ----

Rational squared_distance_to(const PointSet& points, PointId id, const RationalPoint& x) {
  return flowcert_tests::squared_distance(exactly(points[points.ordinal_of_row(id)]), x);
}

// A point of the hull is the driver iff no point of the set lies beyond the plane through it, orthogonal to
// the way from it to the centre. It lies in the hull: it is the centre of the smallest enclosing ball, and so
// it is stationary for those points alone that are farthest from it.
void check_driver(const PointSet& points, const Explanation& answer, const RationalPoint& center) {
  ASSERT_TRUE(answer.driver.has_value());
  const RationalPoint way = minus(center, *answer.driver);
  ASSERT_GT(inner(way, way), 0);
  std::vector<Point> farthest;
  Rational radius = -1;
  for (const PointId id : answer.contact) {
    const Point& p = points[points.ordinal_of_row(id)];
    ASSERT_LE(inner(minus(exactly(p), *answer.driver), way), 0);
    const Rational distance = squared_distance_to(points, id, *answer.driver);
    if (distance > radius) farthest.clear();
    if (distance >= radius) farthest.push_back(p);
    radius = std::max(radius, distance);
  }
  ASSERT_TRUE(explain_position(PointSet(farthest), *answer.driver).index.has_value());
}

// Checks by the definitions that the answer's reason holds.
void check_reason(const PointSet& points, const Ids& names, const Explanation& answer) {
  const bool not_a = answer.sphere.has_value();
  ASSERT_EQ(not_a, answer.clause != "FC-CRIT-05 (a)");
  if (!not_a) {
    // There is no such sphere: its centre would be the centre of any of the points that span their hull.
    const ExactSphere sphere = exact_sphere(points, names);
    ASSERT_TRUE(std::any_of(names.begin(), names.end(), [&](PointId id) {
      return squared_distance_to(points, id, sphere.center) != sphere.squared_radius;
    }));
    ASSERT_FALSE(answer.witnesses.empty());
    return;
  }
  const RationalPoint& center = answer.sphere->center;
  Ids inside, on;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Rational distance = squared_distance_to(points, points.name(k), center);
    if (distance < answer.sphere->squared_radius) inside.push_back(points.name(k));
    if (distance == answer.sphere->squared_radius) on.push_back(points.name(k));
  }
  ASSERT_TRUE(std::includes(on.begin(), on.end(), names.begin(), names.end()));
  if (!inside.empty()) {
    ASSERT_EQ(answer.clause, "FC-CRIT-05 (b)");
    ASSERT_FALSE(answer.witnesses.empty());
    ASSERT_TRUE(std::includes(inside.begin(), inside.end(), answer.witnesses.begin(), answer.witnesses.end()));
    return;
  }
  ASSERT_EQ(answer.contact, on);
  if (on.size() > names.size()) {
    Ids further;
    std::set_difference(on.begin(), on.end(), names.begin(), names.end(), std::back_inserter(further));
    ASSERT_EQ(answer.clause, "FC-CRIT-05 (c)");
    ASSERT_EQ(answer.witnesses, further);
    return;
  }
  ASSERT_TRUE(answer.witnesses.empty());
  if (answer.index) {
    ASSERT_EQ(answer.clause, answer.index->is_critical() ? "FC-CRIT-02" : "FC-CRIT-03");
    ASSERT_FALSE(answer.driver.has_value());
  } else {
    ASSERT_EQ(answer.clause, "FC-CRIT-05 (d)");
    check_driver(points, answer, center);
  }
}

struct Seen {
  std::map<std::string, int> clauses;
  std::map<StationaryIndex, int> indices;
};

void check_input(const PointSet& points, PortableRandom& random, Seen& seen) {
  if (points.empty()) return;
  const FlowComplex complex(points);
  const StationaryPoints& list = complex.stationary();
  std::map<Ids, StationaryIndex> listed;
  std::set<RationalPoint> centers;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Ids contact(list.contact(i).begin(), list.contact(i).end());
    const Explanation of_points = explain_points(points, contact);
    ASSERT_EQ(of_points.index, list.index(i));
    ASSERT_EQ(of_points.contact, contact);
    const Explanation of_position = explain_position(points, of_points.sphere.value().center);
    ASSERT_EQ(of_position.index, list.index(i));
    ASSERT_EQ(of_position.contact, contact);
    ASSERT_EQ(of_position.clause, of_points.clause);
    ASSERT_TRUE(listed.emplace(contact, list.index(i)).second);
    ASSERT_TRUE(centers.insert(of_points.sphere->center).second);
    ++seen.indices[list.index(i)];
  }
  for (int k = 0; k < 12; ++k) {
    std::set<PointId> drawn;
    const std::size_t count = 1 + random.below(std::min<std::size_t>(points.size(), 5));
    for (std::size_t i = 0; i < count; ++i) drawn.insert(points.name(random.below(points.size())));
    // A listed contact set, less a point or plus one, is nearly right.
    if (random.coin()) {
      const auto contact = list.contact(random.below(list.size()));
      drawn = {contact.begin(), contact.end()};
      const PointId id = points.name(random.below(points.size()));
      if (random.coin()) {
        drawn.insert(id);
      } else if (drawn.size() > 1) {
        drawn.erase(drawn.begin());
      }
    }
    const Ids names(drawn.begin(), drawn.end());
    const Explanation answer = explain_points(points, names);
    const auto found = listed.find(names);
    ASSERT_EQ(answer.index.has_value(), found != listed.end());
    if (answer.index) {
      ASSERT_EQ(*answer.index, found->second);
    }
    check_reason(points, names, answer);
    if (testing::Test::HasFatalFailure()) return;
    ++seen.clauses[answer.clause];
  }
}

TEST(ExplainTest, AgreesWithTheList) {
  CITES("FC-CRIT-01", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-04", "FC-CRIT-05", "FC-CRIT-06", "FC-DIST-02");
  const std::set<std::string> names = {"lattice-2",   "lattice-3",        "right-angles",    "integer-sphere",
                                       "few-points",  "coplanar-lattice", "collinear",       "duplicates",
                                       "two-circles", "one-ulp-off",      "mixed-magnitudes"};
  Seen seen;
  PortableRandom random(41);
  std::size_t found = 0;
  for (const fuzz::Family& family : fuzz::families()) {
    if (!names.contains(family.name)) continue;
    ++found;
    for (int k = 0; k < 20; ++k) {
      const fuzz::Input input = fuzz::draw(family, static_cast<std::uint64_t>(500 + k), k);
      SCOPED_TRACE(testing::Message() << family.name << ", seed " << 500 + k << '\n' << input);
      check_input(property::point_set_of(input), random, seen);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_EQ(found, names.size()) << "a family has another name now";
  for (const char* clause :
       {"FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05 (a)", "FC-CRIT-05 (b)", "FC-CRIT-05 (c)", "FC-CRIT-05 (d)"}) {
    EXPECT_GT(seen.clauses[clause], 15) << clause;
  }
  for (const StationaryIndex index : {kMinimum, kIndex1, kIndex2, kIndex3, kKind12, kKind23, kKind13}) {
    EXPECT_GT(seen.indices[index], 10);
  }
}

}  // namespace
}  // namespace flowcert::explain_test
