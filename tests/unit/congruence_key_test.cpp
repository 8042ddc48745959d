// Keys of congruent edges and triangles: the same for each of its copies on a grid, another one where an edge differs,
// and none where the difference of two coordinates is no double.
#include "geometry/congruence_key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include "flowcert/sphere.h"
#include "geometry/vector3.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::congruence_key_test {
namespace {

using flowcert_tests::PortableRandom;
using geometry::congruence_key;
using geometry::CongruenceKey;
using geometry::Vector3;

std::optional<CongruenceKey> key_of(const std::vector<Point>& points) {
  std::vector<const Point*> given;
  for (const Point& point : points) given.push_back(&point);
  return congruence_key(given);
}

Rational squared_radius(const std::vector<Point>& rows) {
  const PointSet points(rows);
  std::vector<PointId> all(rows.size());
  std::iota(all.begin(), all.end(), PointId{0});
  return exact_squared_radius(points, all);
}

Point drawn(PortableRandom& random) {
  const auto coordinate = [&] { return static_cast<double>(random.between(-3, 3)) / 4; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

// Three points on a line have no circle. These numbers are exact.
bool are_collinear(const std::vector<Point>& points) {
  const auto between = [&](std::size_t k) { return vector_between(points[0], points[k]); };
  const Vector3<double> normal = points.size() == 3 ? cross(between(1), between(2)) : between(1);
  return dot(normal, normal) == 0;
}

// Axes in another order, mirrored and moved, and the points in another order.
std::vector<Point> copy_of(const std::vector<Point>& points, PortableRandom& random) {
  std::vector<std::size_t> axes{0, 1, 2};
  random.shuffle(axes);
  std::array<double, 3> sign{}, step{};
  for (double& s : sign) s = random.coin() ? 1 : -1;
  for (double& s : step) s = static_cast<double>(random.between(-8, 8));
  std::vector<Point> copy;
  for (const Point& p : points) {
    const std::array<double, 3> from{p.x, p.y, p.z};
    const auto at = [&](std::size_t k) { return sign[k] * from[axes[k]] + step[k]; };
    copy.push_back({at(0), at(1), at(2)});
  }
  random.shuffle(copy);
  return copy;
}

TEST(CongruenceKey, IsOneOfAllCopiesAndOfOneRadiusAlone) {
  CITES("FC-NUM-01");
  PortableRandom random(5);
  std::map<CongruenceKey, std::set<Rational>> radii;
  std::size_t met = 0;
  for (int k = 0; k < 4000; ++k) {
    std::vector<Point> points;
    for (std::size_t count = 2 + random.below(2); points.size() < count;) points.push_back(drawn(random));
    if (are_collinear(points)) continue;
    const auto key = key_of(points);
    ASSERT_TRUE(key.has_value());
    EXPECT_EQ(key_of(copy_of(points, random)), key);
    met += radii.contains(*key) ? 1 : 0;
    radii[*key].insert(squared_radius(points));
    EXPECT_EQ(radii[*key].size(), 1U);
  }
  EXPECT_GT(met, 500U);
  EXPECT_GT(radii.size(), 500U);
}

TEST(CongruenceKey, IsAnotherOneWhereALengthDiffers) {
  CITES("FC-NUM-01");
  const std::vector<Point> edge{{0, 0, 0}, {1, 2, 3}}, triangle{{0, 0, 0}, {1, 2, 3}, {1, 2, 4}};
  EXPECT_NE(key_of(edge), key_of({{0, 0, 0}, {1, 2, 3 + 0x1p-50}}));
  EXPECT_NE(key_of(triangle), key_of({{0, 0, 0}, {1, 2, 3}, {1, 2, 5}}));
  EXPECT_NE(key_of(triangle), key_of(edge));
}

// The differences 1 - 2^-60 and 1 have one nearest double.
TEST(CongruenceKey, IsNotThereWhereADifferenceIsNoDouble) {
  CITES("FC-NUM-01");
  EXPECT_TRUE(key_of({{0, 0, 0}, {1, 0, 0}}).has_value());
  EXPECT_FALSE(key_of({{0x1p-60, 0, 0}, {1, 0, 0}}).has_value());
  EXPECT_FALSE(key_of({{0, 0x1p-60, 0}, {0, 1, 0}}).has_value());
  EXPECT_FALSE(key_of({{0, 5, 0x1p-60}, {0, 5, 1}, {0, 0, 0}}).has_value());
  EXPECT_FALSE(key_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0x1p-60}}).has_value()) << "between the second and the third";
  EXPECT_FALSE(key_of({{-0x1p1023, 0, 0}, {0x1p1023, 0, 0}}).has_value()) << "beyond the doubles";
  EXPECT_TRUE(key_of({{0, 0, 0}, {0, 0, 0x1p-1074}}).has_value());
}

}  // namespace
}  // namespace flowcert::congruence_key_test
