// capsule_sample() is what it says: a sample of the capsule, an epsilon-sample of it, and one with long cascades.
//
// Guarantees: points are on the surface exactly, by rationals. That every point of the surface has a sample near is
// shown by patches: a patch is covered if the distance from its centre to a sample, with the patch's radius, is below
// epsilon, or if its quarters are. Distances are doubles, of the order of 1, and are taken 1e-9 too large.
#include "fuzz/inputs/capsule_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"

namespace flowcert::fuzz::capsule_sample_test {
namespace {

using Position = std::array<double, 3>;

constexpr double kSlack = 1e-9;
constexpr double kHalfLength = static_cast<double>(kCapsuleHalfLength) / static_cast<double>(kCapsuleRadius);

double distance(const Position& a, const Position& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// The samples, in units of the capsule's radius.
std::vector<Position> in_radii(const Input& input) {
  std::vector<Position> positions;
  for (const auto& [x, y, z] : input.rows) {
    const auto radius = static_cast<double>(kCapsuleRadius);
    positions.push_back({x / radius, y / radius, z / radius});
  }
  return positions;
}

// A part of the surface: angles around the axis, and `along`. On the cylinder this is z. On a half sphere it is the
// latitude, counted from the cylinder's end.
struct Patch {
  enum class On { kCylinder, kUpperEnd, kLowerEnd } on;
  double around, along;  // of the centre
  double half_around, half_along;

  [[nodiscard]] Position center() const {
    if (on == On::kCylinder) {
      return {std::cos(around), std::sin(around), along};
    }
    const double z = kHalfLength + std::sin(along);
    return {std::cos(along) * std::cos(around), std::cos(along) * std::sin(around), on == On::kUpperEnd ? z : -z};
  }
  // Going along and then around leads everywhere. No circle around the axis is larger than the cylinder's.
  [[nodiscard]] double radius() const { return half_around + half_along; }
};

bool is_covered(const Patch& patch, const std::vector<Position>& samples, double epsilon) {
  const Position center = patch.center();
  std::vector<Position> near;
  double nearest = 10;
  for (const Position& sample : samples) {
    const double away = distance(center, sample) + kSlack;
    nearest = std::min(nearest, away);
    if (away <= epsilon + patch.radius() + 2 * kSlack) {
      near.push_back(sample);
    }
  }
  if (nearest + patch.radius() <= epsilon) {
    return true;
  }
  if (patch.radius() < 1e-4) {
    return false;
  }
  const double around = patch.half_around / 2, along = patch.half_along / 2;
  for (const double a : {-around, around}) {
    for (const double b : {-along, along}) {
      if (!is_covered({patch.on, patch.around + a, patch.along + b, around, along}, near, epsilon)) {
        return false;
      }
    }
  }
  return true;
}

bool is_epsilon_sample(const Input& input, double epsilon) {
  constexpr double kPi = std::numbers::pi;
  const std::vector<Position> samples = in_radii(input);
  using On = Patch::On;
  return is_covered({On::kCylinder, 0, 0, kPi, kHalfLength}, samples, epsilon) &&
         is_covered({On::kUpperEnd, 0, kPi / 4, kPi, kPi / 4}, samples, epsilon) &&
         is_covered({On::kLowerEnd, 0, kPi / 4, kPi, kPi / 4}, samples, epsilon);
}

TEST(CapsuleSample, PointsAreOnTheCapsule) {
  const Rational radius(kCapsuleRadius), half_length(kCapsuleHalfLength);
  for (const auto& [x, y, z] : capsule_sample(kMostCapsuleTeeth).rows) {
    const Rational beyond = std::max(Rational(0), Rational(abs(Rational(z)) - half_length));
    ASSERT_EQ(Rational(x) * Rational(x) + Rational(y) * Rational(y) + beyond * beyond, radius * radius);
  }
}

TEST(CapsuleSample, EveryPointOfTheSurfaceHasASampleNear) {
  for (const std::size_t teeth : {std::size_t{20}, kMostCapsuleTeeth}) {
    Input input = capsule_sample(teeth);
    EXPECT_TRUE(is_epsilon_sample(input, kCapsuleEpsilon)) << teeth;
    EXPECT_FALSE(is_epsilon_sample(input, 0.055)) << "the disc at the strip's wide end is larger";
    std::erase_if(input.rows, [](const Row& row) { return row[2] > static_cast<double>(kCapsuleRadius); });
    EXPECT_FALSE(is_epsilon_sample(input, kCapsuleEpsilon)) << "there is a hole around the pole";
  }
}

// The other samples are always the same.
TEST(CapsuleSample, CascadesGrowWithTheNumberOfSamples) {
  CITES("FC-STAB-06");
  const std::size_t others = capsule_sample(20).rows.size() - 20;
  for (const std::size_t teeth : {std::size_t{20}, std::size_t{100}, kMostCapsuleTeeth}) {
    const Input input = capsule_sample(teeth);
    EXPECT_EQ(input.rows.size(), teeth + others);
    const FlowComplex complex(property::rows_of(input));
    EXPECT_GE(complex.stable().statistics().n_s2.max(), teeth - 1);
    EXPECT_GE(complex.unstable().statistics().n_u2.max(), teeth - 1);
  }
}

TEST(CapsuleSample, TheKernelsAgree) {
  CITES("FC-NUM-01");
  const std::vector<Point> rows = property::rows_of(capsule_sample(100));
  const FlowComplex expected(rows);
  for (const ConstructionKernel kernel : {ConstructionKernel::kLazy, ConstructionKernel::kExact}) {
    const FlowComplex complex(rows, {kernel, FacetSearch::kBinary});
    EXPECT_EQ(complex.stable().statistics().n_s2, expected.stable().statistics().n_s2);
    EXPECT_EQ(complex.unstable().statistics().n_u2, expected.unstable().statistics().n_u2);
    ASSERT_EQ(complex.unstable().size(), expected.unstable().size());
    for (std::size_t i = 0; i < expected.unstable().size(); ++i) {
      for (const std::size_t side : {0U, 1U}) {
        ASSERT_EQ(complex.unstable().limit(i, side), expected.unstable().limit(i, side));
      }
    }
  }
}

TEST(CapsuleSample, OtherNumbersOfTeethAreRefused) {
  for (const std::size_t teeth : {std::size_t{0}, std::size_t{18}, std::size_t{21}, kMostCapsuleTeeth + 2}) {
    EXPECT_THROW(capsule_sample(teeth), std::invalid_argument) << teeth;
  }
}

}  // namespace
}  // namespace flowcert::fuzz::capsule_sample_test
