// The generators that are made for stable sets give what they promise. They are kept apart from the families
// that numbered cases take turns over.
//
// Guarantees: exact integer checks; which stable sets the inputs have is checked by the property tests, which
// ask for so many of each kind.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>

#include "fuzz/inputs/stable_configurations.h"

namespace flowcert::fuzz::stable_families_test {
namespace {

constexpr std::uint64_t kSeeds = 60;

// |p - (0,t,0)|^2.
Integer squared_distance_to_axis_point(const IntegerPoint& p, Integer t) { return dot(p, p) - 2 * p[1] * t + t * t; }

TEST(StableConfigurations, AimedPointsLieOnASphereOutsideOfWhichTheThirdIs) {
  std::size_t with_sphere = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const IntegerPoints points = aimed_points()(rc::Random(seed), 100).value();
    ASSERT_GE(points.size(), 3U);
    EXPECT_LE(points.size(), 12U);
    const Integer a = points[1][0];
    EXPECT_EQ(points[0], (IntegerPoint{-a, 0, 0}));
    EXPECT_EQ(points[1], (IntegerPoint{a, 0, 0}));
    EXPECT_EQ(points[2], (IntegerPoint{0, points[2][1], 0}));
    EXPECT_TRUE(std::all_of(points.begin() + 3, points.end(), [](const auto& p) { return p[1] < 0; }));
    for (Integer t = 1; t <= a; ++t) {
      const Integer norm = a * a + t * t;
      const auto on_sphere = std::count_if(points.begin() + 3, points.end(),
                                           [&](const auto& p) { return squared_distance_to_axis_point(p, t) == norm; });
      const bool is_third_outside = points[2][1] > t && squared_distance_to_axis_point(points[2], t) > norm;
      if (on_sphere >= 3 && is_third_outside) {
        ++with_sphere;
        break;
      }
    }
  }
  EXPECT_GE(with_sphere, kSeeds / 2);
}

TEST(StableConfigurations, StarsHaveObtuseTrianglesOnly) {
  const auto angle_sign = [](const IntegerPoint& at, const IntegerPoint& p, const IntegerPoint& q) {
    return dot(plus(p, times(-1, at)), plus(q, times(-1, at)));
  };
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const IntegerPoints points = aimed_at_a_star()(rc::Random(seed), 100).value();
    ASSERT_GE(points.size(), 5U);
    EXPECT_LE(points.size(), 12U);
    const auto &a = points[0], &b = points[1], &p = points[3], &q = points[4];
    EXPECT_EQ(b, times(-1, a));
    EXPECT_LT(angle_sign(p, a, b), 0);
    EXPECT_LT(angle_sign(q, a, b), 0);
    EXPECT_LT(angle_sign(q, a, p), 0);
    EXPECT_LT(angle_sign(q, b, p), 0);
  }
}

TEST(StableConfigurations, CrowdedPointsStandAroundASphere) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const IntegerPoints points = crowded_points()(rc::Random(seed), 100).value();
    ASSERT_GE(points.size(), 8U);
    EXPECT_LE(points.size(), 12U);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Integer norm = dot(points[k], points[k]);
      EXPECT_TRUE(k < 4 ? norm == 400 : norm > 400 && norm <= 625);
    }
  }
}

TEST(StableFamilies, HaveTheirOwnNamesAndAreNoCasesOfTheStream) {
  EXPECT_EQ(families().size(), 36U);  // an id's number takes turns over them
  std::set<std::string> names;
  for (const Family& family : families_and_stable_ones()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_EQ(draw(family, 5, 80), draw(family, 5, 80)) << family.name;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      for (const int size : {0, 30, 100}) EXPECT_LE(draw(family, seed, size).rows.size(), 12U) << family.name;
    }
  }
  EXPECT_EQ(names.size(), families().size() + stable_families().size());
}

}  // namespace
}  // namespace flowcert::fuzz::stable_families_test
