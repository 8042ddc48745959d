// The oracle's unstable sets of dimension 2 against its search against the flow, on small inputs of all families.
//
// A set is made by following rays forward. The search starts at a point x, and goes against the flow. So whether x is
// in the set is found in two ways that have nothing in common. Points are tried on traces, at their ends and beyond
// them, on runs, in sheets and beside them, on segments, and at Voronoi vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <string>

#include "oracle/orbit.h"
#include "oracle/stable_set.h"
#include "oracle/unstable_set.h"
#include "oracle/unstable_surface.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace oracle::oracle_unstable_surface_families_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;

struct Count {
  std::size_t sets = 0, traces = 0, runs = 0, sheets = 0, segments = 0, vertices = 0;
  std::size_t inside = 0, outside = 0, orbits = 0;
};

// A point of a part. The weights are positive.
Point mixture(const std::vector<Corner>& corners, const std::vector<int>& weights) {
  Point sum = {};
  Rational finite = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].at_infinity) continue;
    finite += weights[i % weights.size()];
    sum = moved(sum, weights[i % weights.size()], corners[i].position);
  }
  sum = {sum[0] / finite, sum[1] / finite, sum[2] / finite};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].at_infinity) sum = moved(sum, weights[i % weights.size()], corners[i].position);
  }
  return sum;
}

// A line without an end goes through the centre of its polygon's circle.
Point on_edge(const PointSet& set, const EdgePart& part, int a, int b) {
  if (!part.front.at_infinity) return mixture({part.front, part.back}, {a, b});
  const std::vector<Point> corners = select(set.points, places_of(set, part.polygon));
  return moved(circumcentre({corners[0], corners[1], corners[2]})->center, Rational(a - b, a), part.back.position);
}

// Points of all parts of a set, and others near them.
std::vector<Point> tried(const PointSet& set, const UnstableSurface& surface, std::mt19937& random) {
  const auto weight = [&] { return 1 + static_cast<int>(random() % 7); };
  std::vector<Point> result = surface.vertices;
  for (const auto* parts : {&surface.traces, &surface.runs}) {
    for (const EdgePart& part : *parts) {
      result.push_back(on_edge(set, part, weight(), weight()));
      for (const Corner* end : {&part.front, &part.back}) {
        if (end->at_infinity) continue;
        result.push_back(end->position);
        const Point other = end == &part.front ? on_edge(set, part, 1, 2) : on_edge(set, part, 2, 1);
        result.push_back(moved(end->position, Rational(-1, weight()), minus(other, end->position)));
      }
    }
  }
  for (const Region& sheet : surface.sheets) {
    if (sheet.corners.empty()) continue;
    result.push_back(mixture(sheet.corners, {weight(), weight(), weight(), weight()}));
    const Point centre = mixture(sheet.corners, {1});
    for (std::size_t i = 0; i < sheet.corners.size(); ++i) {
      const Corner &a = sheet.corners[i], &b = sheet.corners[(i + 1) % sheet.corners.size()];
      if (a.at_infinity && b.at_infinity) continue;
      const Point side = mixture({a, b}, {weight(), weight()});
      result.push_back(side);
      result.push_back(moved(side, Rational(1, 8), minus(side, centre)));
    }
  }
  for (const Crossing& segment : surface.segments) {
    result.push_back(mixture({segment.back, segment.front}, {weight(), weight()}));
  }
  return result;
}

// Whether the skeleton of all that flows to x reaches y: by a way that ends there, or by a sector with y as a corner,
// in the facet of F.
bool is_reached(const PointSet& set, const StableSet& found, const StationaryPoint& y, const Places& face) {
  const std::array<std::size_t, 2> samples = {set.names[face[0]], set.names[face[1]]};
  const auto is_back = [&](const auto& piece) { return piece.back == y.center; };
  const auto is_back_of_f = [&](const EdgePart& i) { return is_back(i) && std::ranges::includes(i.polygon, samples); };
  return std::ranges::any_of(found.segments, is_back) || std::ranges::any_of(found.intervals, is_back_of_f) ||
         std::ranges::any_of(found.sectors, [&](const Region& s) { return s.samples == samples; });
}

void expect_same_answer(const PointSet& set, const std::vector<const StationaryPoint*>& all,
                        const std::vector<UnstableSurface>& surfaces, const Point& x, Count& count) {
  const StableSet found = stable_set(set, x);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool expected = x == all[i]->center || is_reached(set, found, *all[i], face_of(set, *all[i]));
    const bool is_in = contains(set, surfaces[i], x);
    EXPECT_EQ(is_in, expected) << "x = " << x[0] << ' ' << x[1] << ' ' << x[2] << ", y of "
                               << testing::PrintToString(all[i]->contact);
    ++(is_in ? count.inside : count.outside);
  }
}

// The orbits of points of y's set have limits of its λ-list, unless they are y.
void expect_limits(const PointSet& set, const StationaryPoint& y, const UnstableSurface& surface,
                   const std::vector<Point>& points, Count& count) {
  const std::vector<UnstableEntry> list = lambda_list(set, y);
  for (const Point& x : points) {
    if (x == y.center || !contains(set, surface, x)) continue;
    const auto limit = orbit(set, x).limit;
    EXPECT_TRUE(std::any_of(list.begin(), list.end(), [&](const UnstableEntry& e) { return e.limit == limit; }));
    ++count.orbits;
  }
}

void expect_agreement(const Rows& rows, unsigned seed, Count& count) {
  const PointSet set(rows);
  const Answer answer = stationary_points(rows);
  std::mt19937 random(seed);
  std::vector<const StationaryPoint*> all;
  std::vector<UnstableSurface> surfaces;
  for (const StationaryPoint& y : answer.stationary) {
    if (y.face_dimension != 1) continue;
    SCOPED_TRACE(testing::PrintToString(y.contact));
    all.push_back(&y);
    ASSERT_NO_THROW(surfaces.push_back(unstable_surface(set, y)));
    const UnstableSurface& s = surfaces.back();
    ++count.sets;
    count.traces += s.traces.size(), count.runs += s.runs.size(), count.sheets += s.sheets.size();
    count.segments += s.segments.size(), count.vertices += s.vertices.size();
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Point> points = tried(set, surfaces[i], random);
    expect_limits(set, *all[i], surfaces[i], points, count);
    std::shuffle(points.begin(), points.end(), random);
    if (points.size() > 12) points.resize(12);
    for (const Point& x : points) {
      if (contact_set(set, x).size() > 1) expect_same_answer(set, all, surfaces, x, count);
    }
  }
}

TEST(OracleUnstableSurfaceFamilies, PointsAreInASetIffTheSearchAgainstTheFlowComesToItsPoint) {
  CITES("FC-UNST-04", "FC-UNST-05", "FC-UNST-06");
  const double scale = flowcert::property::scale_of_run();
  Count count;
  const std::uint64_t seeds = flowcert_tests::scaled_seeds(1);
  flowcert_tests::for_each_drawn_set({seeds, seeds, scale < 1 ? 7U : 10U}, [&](const Rows& rows, std::uint64_t seed) {
    if (!rows.empty()) expect_agreement(rows, static_cast<unsigned>(seed), count);
  });
  EXPECT_GT(count.sets, 100 * scale);
  EXPECT_GT(count.runs, 17 * scale);
  EXPECT_GT(count.segments, 5 * scale);
  EXPECT_GT(count.inside, 3300 * scale);
  EXPECT_GT(count.outside, 3300 * scale);
  std::printf("%zu sets: %zu traces, %zu runs, %zu sheets, %zu segments, %zu vertices\n", count.sets, count.traces,
              count.runs, count.sheets, count.segments, count.vertices);
  std::printf("points in a set %zu, not in it %zu; orbits %zu\n", count.inside, count.outside, count.orbits);
}

}  // namespace
}  // namespace oracle::oracle_unstable_surface_families_test
