// Locations and the selections of a medial axis by the oracle, on small inputs of all families.
//
// Locations are held to the stable sets, which are found against the flow, and to the tree of pockets. Angles have the
// bounds of their indices, and persistence pairs tell of each critical point once.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

#include "oracle/connections.h"
#include "oracle/medial_axis.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/unit/landscape_inputs.h"

namespace oracle::oracle_location_families_test {
namespace {

using Subject = LandscapeSubject;

struct LocationCount {
  std::size_t queries = 0, infinite = 0, ties = 0;
  std::map<std::string, std::size_t> limits;
};

// A location, held to stable sets; to the ray from the nearest sample; to what is above it, which is together.
void expect_location(const Subject& subject, const StableSet& infinity, const PeaksAbove& above, const Point& x,
                     LocationCount& count) {
  const Location location = locate(subject.set, x);
  ++count.queries;
  count.ties += location.nearest.size() > 1 ? 1 : 0;
  EXPECT_EQ(location.nearest, contact_set(subject.set, x));
  EXPECT_EQ(flows_to_infinity(subject.set, infinity, x), !location.limit);
  const Point& sample = subject.set.points[places_of(subject.set, location.nearest)[0]];
  if (location.nearest.size() == 1 && x != sample) {
    EXPECT_EQ(locate(subject.set, moved(sample, Rational(1, 3), minus(x, sample))), location);
  }
  if (!location.limit) {
    ++count.infinite;
    return;
  }
  const StationaryPoint& z = *location.limit;
  ++count.limits[std::to_string(z.face_dimension) + "-" + std::to_string(z.hull_dimension)];
  EXPECT_TRUE(contains(subject.set, stable_set(subject.set, z), x));
  const auto place = std::find(subject.all.begin(), subject.all.end(), z) - subject.all.begin();
  ASSERT_LT(place, std::ssize(subject.all));
  const Peaks& peaks = above.of[static_cast<std::size_t>(place)];
  EXPECT_EQ(peaks.empty(), z.face_dimension == 0);
  for (const std::size_t leaf : peaks) {
    if (leaf == *peaks.begin()) continue;
    EXPECT_GE(subject.joining(leaf, *peaks.begin()), z.squared_distance);
  }
}

TEST(OracleLocationFamilies, LocationsHoldToStableSets) {
  CITES("FC-LOC-01", "FC-LOC-03", "FC-POCK-01");
  LocationCount count;
  for_each_drawn(2, [&](const Subject& subject, std::uint64_t seed) {
    const StableSet infinity = stable_set_of_infinity(subject.set);
    const PeaksAbove above = peaks_above(subject.set, subject.all);
    rc::Random random(seed);
    const auto any = [&] { return subject.all[static_cast<std::size_t>(random.next() % subject.all.size())].center; };
    for (int k = 0; k < 6; ++k) {
      const Point from = any();
      const Rational share(static_cast<long>(random.next() % 9), 6);  // 0 to 4/3
      expect_location(subject, infinity, above, moved(from, share, minus(any(), from)), count);
    }
  });
  std::printf("%zu queries, %zu to infinity, %zu with several nearest samples\n", count.queries, count.infinite,
              count.ties);
  for (const auto& [kind, number] : count.limits) std::printf("%8zu  %s\n", number, kind.c_str());
  const double scale = flowcert::property::scale_of_run();
  EXPECT_GT(static_cast<double>(count.infinite), 50 * scale);
  EXPECT_GT(static_cast<double>(count.ties), 50 * scale);
  for (const char* kind : {"0-0", "1-1", "2-2", "1-2", "3-3"}) EXPECT_GT(count.limits[kind], 0U) << kind;
}

// Angles have the bounds of their indices, and pairs tell each critical point of index 1 and 2 once.
void expect_selection(const Subject& subject, const std::vector<PersistencePair>& pairs) {
  std::map<std::pair<int, Rational>, std::size_t> number;
  for (const StationaryPoint& z : subject.all) {
    if (!z.is_critical() || z.hull_dimension == 0 || z.hull_dimension == 3) continue;
    ++number[{z.hull_dimension, z.squared_distance}];
    const Rational cosine = contact_cosine(subject.set, z);
    if (z.hull_dimension == 1) {
      EXPECT_EQ(cosine, -1);
    }
    EXPECT_GE(cosine, -1);
    EXPECT_LE(cosine, Rational(-1, 2));
  }
  EXPECT_EQ(above_angle(subject.set, subject.all, 0).size(), subject.count(1) + subject.count(2));
  EXPECT_TRUE(above_angle(subject.set, subject.all, -1).empty());
  for (const auto& [key, count] : number) {
    const auto& [index, value] = key;
    EXPECT_EQ(count_above_persistence(pairs, index, value, 0), count);
  }
}

TEST(OracleMedialAxisFamilies, SelectionsForTheMedialAxis) {
  CITES("FC-MED-01", "FC-MED-02", "FC-MED-03");
  for_each_drawn(1, [&](const Subject& subject, std::uint64_t) {
    expect_selection(subject, persistence_pairs(subject.set));
    for (const StationaryPoint& z : subject.all) {
      if (!z.is_critical() || z.hull_dimension != 2) continue;
      EXPECT_TRUE(in_medial_axis(subject.set, {z}, z.center));
      for (const std::size_t name : z.contact) {
        EXPECT_FALSE(in_medial_axis(subject.set, {z}, subject.set.points[places_of(subject.set, {name})[0]]));
      }
    }
  });
}

}  // namespace
}  // namespace oracle::oracle_location_families_test
