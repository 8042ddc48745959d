// Orbits of U2 and segments of S2 in doubles, against their exact coordinates.
//
// Guarantees: on inputs of every family, of every kernel, each double is the one nearest to the exact number. The order
// of segments, and which of their ends are equal, is that of exact positions.
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"
#include "geometry/rational_point.h"
#include "tests/cites.h"

namespace flowcert::rounded_manifolds_test {
namespace {

using property::rows_of;

class RoundedManifolds {
 public:
  RoundedManifolds(const std::vector<Point>& rows, FlowOptions options) : complex_(rows, options) {}

  // Returns how many numbers were compared.
  std::size_t check() {
    for (std::size_t record = 0; record < complex_.stationary().size(); ++record) {
      expect_sphere(complex_.rounded_sphere(record), complex_.sphere(record));
    }
    for (std::size_t i = 0; i < complex_.unstable().size(); ++i) {
      for (const std::size_t side : {1U, 0U}) check_orbit(i, side);
    }
    for (std::size_t i = 0; i < complex_.stable().size(); ++i) check_set(i);
    return compared_;
  }

 private:
  void expect_sphere(const RoundedSphere& sphere, const ExactSphere& exact) {
    const RoundedSphere truth = rounded_sphere(exact);
    EXPECT_EQ(sphere.center, truth.center);
    EXPECT_EQ(sphere.squared_radius, truth.squared_radius);
    ++compared_;
  }
  [[nodiscard]] ExactSphere around(const RationalPoint& x, PointId nearest) const {
    const PointSet& points = complex_.points();
    return {x, geometry::squared_distance(x, points[points.ordinal_of_row(nearest)])};
  }

  void check_orbit(std::size_t i, std::size_t side) {
    const Orbit orbit = complex_.unstable().orbit(i, side);
    std::vector<ExactSphere> exact{complex_.sphere(complex_.unstable().saddle(i))};
    for (const FlowSegment& segment : orbit.segments) {
      if (segment.end) exact.push_back(around(*segment.end, segment.end_contact[0]));
    }
    const std::vector<RoundedSphere> rounded = complex_.unstable().rounded_orbit(i, side);
    ASSERT_EQ(rounded.size(), exact.size());
    for (std::size_t k = 0; k < exact.size(); ++k) expect_sphere(rounded[k], exact[k]);
  }

  void check_set(std::size_t i) {
    const StableSet<> set = complex_.stable().set(i);
    const RoundedSegments rounded = complex_.stable().rounded_segments(i);
    ASSERT_EQ(rounded.segments.size(), set.segments.size());
    std::map<std::uint32_t, RationalPoint> position_of;
    std::map<RationalPoint, std::set<std::uint32_t>> fronts;
    const auto meet = [&](std::uint32_t place, const RationalPoint& x, PointId nearest) {
      expect_sphere(rounded.positions.at(place).sphere, around(x, nearest));
      EXPECT_EQ(position_of.try_emplace(place, x).first->second, x);
      if (rounded.positions[place].end.empty()) fronts[x].insert(place);
    };
    for (std::size_t k = 0; k < set.segments.size(); ++k) {
      const BackwardSegment<>& segment = set.segments[k];
      const RoundedSegments::Segment& same = rounded.segments[k];
      ASSERT_EQ(same.samples, segment.samples);
      meet(same.front, segment.front.position, segment.samples[0]);
      meet(same.back, segment.back.position, segment.samples[0]);
      EXPECT_TRUE(rounded.positions[same.front].end.empty());
      const bool ends = segment.back_kind == BackKind::kCritical || segment.back_kind == BackKind::kRegular;
      EXPECT_EQ(rounded.positions[same.back].end, ends ? segment.back_contact : std::vector<PointId>{});
    }
    for (const auto& [x, places] : fronts) EXPECT_EQ(places.size(), 1U);
  }

  FlowComplex complex_;
  std::size_t compared_ = 0;
};

TEST(RoundedManifolds, AreThoseOfTheExactCoordinates) {
  CITES("FC-NUM-02", "FC-FLOW-07", "FC-STAB-04");
  std::size_t compared = 0;
  for (const fuzz::Family& family : fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      for (const int size : {12, 60}) {
        compared += RoundedManifolds(rows_of(fuzz::draw(family, seed, size)), {}).check();
        ASSERT_FALSE(testing::Test::HasFailure()) << family.name << ", seed " << seed;
      }
    }
  }
  EXPECT_GT(compared, 20000U);
}

TEST(RoundedManifolds, EveryKernelGivesTheSameDoubles) {
  CITES("FC-NUM-02", "FC-FLOW-07", "FC-STAB-04");
  for (const ConstructionKernel kernel : {ConstructionKernel::kLazy, ConstructionKernel::kExact}) {
    for (const fuzz::Family& family : fuzz::families()) {
      const FlowOptions options{.kernel = kernel, .share = false};
      RoundedManifolds(rows_of(fuzz::draw(family, 5, 12)), options).check();
    }
  }
}

TEST(RoundedManifolds, LongCascadesAreRoundedRightly) {
  CITES("FC-NUM-02", "FC-FLOW-07", "FC-STAB-04");
  EXPECT_GT(RoundedManifolds(rows_of(fuzz::long_cascade(40, 2)), {}).check(), 100U);
  EXPECT_GT(RoundedManifolds(rows_of(fuzz::half_shell(60, 3)), {}).check(), 100U);
  EXPECT_GT(RoundedManifolds(rows_of(fuzz::high_degree_facet(24, true, 1)), {}).check(), 100U);
  EXPECT_GT(RoundedManifolds(rows_of(fuzz::high_degree_facet(24, false, 1)), {}).check(), 20U);
}

}  // namespace
}  // namespace flowcert::rounded_manifolds_test
