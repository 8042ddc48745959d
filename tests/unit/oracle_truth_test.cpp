// The oracle as the truth of a judge, against the fast implementation: each answer that a check may ask for.
//
// Guarantees: exact equality on small inputs of all families; and each sort of answer was among those compared. A
// vector's own answers come before the oracle's.
#include "fuzz/judge/oracle_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "geometry/contract.h"
#include "oracle/fast/point_set.h"
#include "tests/cites.h"
#include "tests/unit/case_points.h"

namespace flowcert::judge::oracle_truth_test {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kMostRows = 8;

// Points of a plane. The first and the second are the ends of an edge that dangles in the polygon of the other edges,
// so both of its sides flow from the centre of that polygon.
const std::vector<Point> kDangling = {{0, 0, 0}, {-10, 0, 0}, {-11, 30, 0}, {-11, -30, 0}, {69, 60, 0}, {69, -60, 0}};

// How often each sort of answer was compared.
struct Tally {
  std::size_t limits = 0, infinity = 0, boundaries = 0, ties = 0, intervals = 0, stationary_backs = 0, sectors = 0;
  std::size_t arcs = 0, exits = 0, vectors = 0, volumes = 0, solids = 0, morse_smale = 0, others = 0;
  std::size_t traces = 0, runs = 0, sheets = 0, single_rays = 0;
  std::size_t twice = 0;  // two orbits of one index-2 point end in one index-1 point, and there is no tie
  std::array<std::size_t, 4> backs{};
};

std::string words_of(const RationalPoint& x) { return to_text(x[0]) + " " + to_text(x[1]) + " " + to_text(x[2]); }

std::string words_of(std::span<const PointId> names) {
  std::string text;
  for (const PointId name : names) text += std::to_string(name) + " ";
  return text;
}

Words words_of(const std::vector<TrueSegment>& line) {
  Words words;
  for (const TrueSegment& segment : line) {
    words.push_back(segment.type + " | " + words_of(segment.driver) + " | " +
                    (segment.end ? words_of(*segment.end) : "infinity"));
  }
  return words;
}

std::string words_of(const Corner<>& corner) {
  return (corner.at_infinity ? "along " : "") + words_of(corner.position);
}

// The pieces of a stable set, in any order.
Words words_of(const StableSet<>& set) {
  Words words;
  for (const BackwardSegment<>& s : set.segments) {
    words.push_back(words_of(s.samples) + "| " + words_of(s.front) + " | " + words_of(s.back) + " | " +
                    words_of(s.front_contact) + "| " + words_of(s.back_contact) + back_kind_text(s.back_kind));
  }
  for (const BackwardInterval<>& i : set.intervals) {
    words.push_back(words_of(i.polygon) + "| " + words_of(i.front) + " | " + words_of(i.back) +
                    (i.back_is_stationary ? " stationary" : ""));
  }
  for (const Region<>& s : set.sectors) {
    words.push_back(words_of(s.samples));
    for (const Corner<>& corner : s.corners) words.back() += "| " + words_of(corner);
  }
  std::ranges::sort(words);
  return words;
}

void expect_same_infinity(Truth& fast, Truth& oracle) {
  const Words found = words_of(oracle.stable_set(std::nullopt));
  EXPECT_EQ(found, words_of(fast.stable_set(std::nullopt)));
  EXPECT_EQ(found.empty(), fast.size() < 2);
}

void expect_same_orbit(const RationalPoint& start, Truth& fast, Truth& oracle) {
  const TruePath expected = fast.orbit(start), found = oracle.orbit(start);
  EXPECT_EQ(found.limit, expected.limit) << "from " << words_of(start);
  EXPECT_EQ(words_of(found.segments), words_of(expected.segments)) << "from " << words_of(start);
}

void expect_same_saddle(std::size_t i, Truth& fast, Truth& oracle, Tally& tally) {
  const auto limits = oracle.limits(i);
  EXPECT_EQ(limits, fast.limits(i));
  for (const auto& limit : limits) ++(limit ? tally.limits : tally.infinity);
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_EQ(words_of(oracle.polyline(i, side)), words_of(fast.polyline(i, side)));
  }
  const auto boundary = oracle.boundary(i);
  ++(boundary ? tally.boundaries : tally.ties);
  if (boundary) {
    EXPECT_EQ(boundary, fast.boundary(i));
  }
}

void expect_same_stable_set(std::size_t i, Truth& fast, Truth& oracle, Tally& tally) {
  const StableSummary found = oracle.stable_summary(i), expected = fast.stable_summary(i);
  EXPECT_EQ(found.segments, expected.segments);
  EXPECT_EQ(found.has_vertex, expected.has_vertex);
  EXPECT_EQ(found.has_interval, expected.has_interval);
  const StableSet<> set = oracle.stable_set(i);
  EXPECT_EQ(words_of(set), words_of(fast.stable_set(i)));
  std::vector<RationalPoint> critical;
  for (const BackwardSegment<>& s : set.segments) {
    ++tally.backs.at(static_cast<std::size_t>(s.back_kind));
    if (s.back_kind == BackKind::kCritical) critical.push_back(s.back.position);
  }
  std::ranges::sort(critical);
  const bool is_twice = std::ranges::adjacent_find(critical) != critical.end();
  tally.twice += is_twice && fast.index(i).is_critical() && oracle.boundary(i) ? 1 : 0;
  tally.intervals += set.intervals.size();
  tally.sectors += set.sectors.size();
  for (const BackwardInterval<>& interval : set.intervals)
    tally.stationary_backs += interval.back_is_stationary ? 1 : 0;
}

std::string words_of(const std::optional<std::size_t>& limit) { return limit ? std::to_string(*limit) : "infinity"; }

// Each direction with the arc after it. A cycle begins with the least of these.
Words words_of(const LambdaList& list, bool is_cycle) {
  Words words;
  for (std::size_t k = 0; k < std::max(list.directions.size(), list.arcs.size()); ++k) {
    std::string& one = words.emplace_back();
    if (k < list.directions.size()) {
      const LambdaList::Direction& direction = list.directions[k];
      one = words_of(direction.exit) + (direction.is_vector ? " for ever to " : " to ") + words_of(direction.limit);
    }
    if (k < list.arcs.size()) one += ", then " + words_of(list.arcs[k]);
  }
  if (is_cycle) std::rotate(words.begin(), std::ranges::min_element(words), words.end());
  return words;
}

void expect_same_directions(std::size_t i, Truth& fast, Truth& oracle, Tally& tally) {
  const bool is_cycle = fast.index(i) == StationaryIndex{1, 1};
  const LambdaList list = oracle.lambda_list(i);
  EXPECT_EQ(words_of(list, is_cycle), words_of(fast.lambda_list(i), is_cycle));
  EXPECT_EQ(oracle.connections(i), fast.connections(i));
  tally.arcs += list.arcs.size();
  for (const LambdaList::Direction& one : list.directions) ++(one.is_vector ? tally.vectors : tally.exits);
  const auto limits = [i](Truth& truth) {
    std::vector<std::pair<std::uint32_t, bool>> sorted;
    for (const FlowLimits::Entry& entry : truth.lambda_entries(i)) sorted.emplace_back(entry.limit, entry.is_arc);
    std::ranges::sort(sorted);
    return sorted;
  };
  EXPECT_EQ(limits(oracle), limits(fast));
}

void expect_same_unstable_set(std::size_t i, Truth& fast, Truth& oracle, Tally& tally) {
  const UnstableSurface set = oracle.unstable_surface(i);
  EXPECT_TRUE(set == fast.unstable_surface(i)) << words_of(fast.contact(i));
  tally.traces += set.traces.size();
  tally.runs += set.runs.size();
  tally.sheets += set.sheets.size();
  tally.single_rays += set.segments.size();
}

void expect_same_volume(std::size_t i, Truth& fast, Truth& oracle, Tally& tally) {
  const Rational volume = oracle.volume(i);
  EXPECT_EQ(volume, fast.volume(i));
  EXPECT_EQ(oracle.nearest_volume(i), fast.nearest_volume(i));
  EXPECT_EQ(oracle.shares(i), fast.shares(i));
  tally.volumes += volume > 0 ? 1 : 0;
}

void expect_same(const std::vector<Point>& rows, Tally& tally) {
  const PointSet points(rows);
  const auto fast = fast_truth(points), oracle = oracle_truth(rows);
  ASSERT_EQ(oracle->size(), fast->size());
  for (std::size_t i = 0; i < fast->size(); ++i) {
    const StationaryIndex index = fast->index(i);
    ASSERT_EQ(oracle->index(i), index);
    ASSERT_TRUE(std::ranges::equal(oracle->contact(i), fast->contact(i)));
    const ExactSphere sphere = oracle->sphere(i);
    EXPECT_EQ(sphere.center, fast->sphere(i).center);
    EXPECT_EQ(sphere.squared_radius, fast->sphere(i).squared_radius);
    expect_same_orbit(sphere.center, *fast, *oracle);
    // A third of the way from one stationary point to the one before it.
    if (i > 0) {
      RationalPoint start = sphere.center;
      const RationalPoint other = fast->sphere(i - 1).center;
      for (std::size_t k = 0; k < 3; ++k) start.at(k) += (other.at(k) - start.at(k)) / 3;
      expect_same_orbit(start, *fast, *oracle);
    }
    if (index == StationaryIndex{2, 2}) expect_same_saddle(i, *fast, *oracle, tally);
    if (index == StationaryIndex{2, 2} || !index.is_critical()) expect_same_stable_set(i, *fast, *oracle, tally);
    if (index.face_dimension == 1 || index.face_dimension == 2) expect_same_directions(i, *fast, *oracle, tally);
    if (index.face_dimension == 1) expect_same_unstable_set(i, *fast, *oracle, tally);
    expect_same_volume(i, *fast, *oracle, tally);
  }
  expect_same_infinity(*fast, *oracle);
  EXPECT_EQ(oracle->hull_volume(), fast->hull_volume());
  tally.solids += oracle->hull_volume() > 0 ? 1 : 0;
  EXPECT_EQ(oracle->is_morse_smale(), fast->is_morse_smale());
  ++(oracle->is_morse_smale() ? tally.morse_smale : tally.others);
}

TEST(OracleTruth, IsThatOfTheFastImplementation) {
  CITES("FC-CRIT-02", "FC-FLOW-07", "FC-FLOW-08", "FC-STAB-04", "FC-STAB-05", "FC-STAB-11", "FC-CHAIN-01", "FC-UNST-02",
        "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02", "FC-STAB-08", "FC-UNST-04");
  Tally tally;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    for (const std::uint64_t seed : {3U, 4U}) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      std::vector<Point> rows = property::rows_of(fuzz::draw(family, seed, 60));
      rows.resize(std::min(rows.size(), kMostRows));
      expect_same(rows, tally);
    }
  }
  expect_same(kDangling, tally);
  for (const std::size_t count :
       {tally.limits,  tally.infinity, tally.boundaries, tally.ties,       tally.intervals,   tally.stationary_backs,
        tally.sectors, tally.backs[0], tally.backs[1],   tally.backs[2],   tally.backs[3],    tally.arcs,
        tally.exits,   tally.vectors,  tally.volumes,    tally.solids,     tally.morse_smale, tally.others,
        tally.traces,  tally.runs,     tally.sheets,     tally.single_rays}) {
    EXPECT_GE(count, 3U);
  }
  EXPECT_LT(tally.stationary_backs, tally.intervals);
  EXPECT_GE(tally.twice, 1U);
}

TEST(OracleTruth, ServesNoMorePointsThanItSays) {
  CITES("FC-CLAIM-03");
  std::vector<Point> rows(kMostPointsForOracle + 1);
  EXPECT_THROW((void)oracle_truth(rows), InvalidInput);
  rows.pop_back();
  EXPECT_EQ(oracle_truth(rows)->size(), 1U) << "one point, over and over";
}

// A vector says that both orbits of the triangle's centre end at the first sample, and that its stable set has nine
// segments and no boundary. None of this is so, but the vector decides.
TEST(VectorTruth, IsWhatTheVectorSays) {
  CITES("FC-FLOW-07");
  VectorCase one;
  one.rows = {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}};
  one.stationary = case_points(*oracle_truth(one.rows));
  const std::size_t saddle = one.stationary.size() - 1;
  one.limits.resize(saddle + 1);
  one.stable.resize(saddle + 1);
  const auto by_oracle = vector_truth(one);
  EXPECT_EQ(by_oracle->limits(saddle), CaseLimits{});
  EXPECT_EQ(by_oracle->stable_summary(saddle).segments, 3U);
  EXPECT_EQ(by_oracle->boundary(saddle), (std::vector<std::uint32_t>{3, 4, 5}));
  one.limits[saddle] = CaseLimits{0, 0};
  one.stable[saddle] = CaseStable{9, true, true, std::nullopt, std::nullopt};
  const auto by_vector = vector_truth(one);
  EXPECT_EQ(by_vector->limits(saddle), (CaseLimits{0, 0}));
  EXPECT_EQ(by_vector->stable_summary(saddle).segments, 9U);
  EXPECT_TRUE(by_vector->stable_summary(saddle).has_vertex);
  EXPECT_EQ(by_vector->boundary(saddle), std::nullopt);
  one.stable[saddle]->boundary = {3};
  EXPECT_EQ(vector_truth(one)->boundary(saddle), (std::vector<std::uint32_t>{3}));
}

}  // namespace
}  // namespace flowcert::judge::oracle_truth_test
