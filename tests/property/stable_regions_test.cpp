// The regions of Voronoi facets by where they flow to (FC-STAB-05, FC-VOL-01, 02), on all families.
//
// Guarantees: all of it is exact. Regions are convex. In each bounded facet their areas add up to that of the convex
// hull of all their corners, so they tile it. The pyramids over the regions of one limit add up to the volume of its
// stable set, which is computed from arcs of Voronoi edges instead. Points inside the pyramids flow to the limit.
#include "morse/stable_regions.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "flowcert/stable_volumes.h"
#include "fuzz/properties/stable_pieces.h"
#include "oracle/exact_geometry.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::stable_regions_test {
namespace {

constexpr int kInputsPerFamily = 40;
constexpr std::size_t kPoints = 12;  // at most so many of an input are followed

struct Totals {
  std::size_t inputs = 0, facets = 0, bounded = 0, regions = 0, points = 0;

  void add(const Totals& part) {
    inputs += part.inputs;
    facets += part.facets;
    bounded += part.bounded;
    regions += part.regions;
    points += part.points;
  }
  void print_row(const std::string& name) const {
    std::printf("%-24s %zu inputs, %zu facets, %zu of them bounded, %zu regions, %zu points followed\n", name.c_str(),
                inputs, facets, bounded, regions, points);
  }
};

using oracle::Point;

struct Region {
  std::optional<std::size_t> limit;
  std::vector<Point> corners;  // or vectors
  std::vector<bool> is_vector;
  [[nodiscard]] bool is_bounded() const { return std::ranges::count(is_vector, true) == 0 && !corners.empty(); }
};
using Facets = std::map<std::array<PointId, 2>, std::vector<Region>>;

Facets facets_of(StableRegions& regions) {
  Facets facets;
  regions.visit([&](const StableRegion& region) {
    Region found{region.limit, {}, {}};
    for (const RegionCorner& corner : region.corners) {
      const RationalPoint x = regions.exact(region, corner);
      found.corners.push_back({x[0], x[1], x[2]});
      found.is_vector.push_back(corner.kind == RegionCorner::Kind::kEnd);
    }
    facets[region.samples].push_back(found);
  });
  return facets;
}

// Twice the area, with a sign, times the length of the axis.
oracle::Rational turn(const Point& axis, const Point& a, const Point& b, const Point& c) {
  return oracle::dot(axis, oracle::cross(oracle::minus(b, a), oracle::minus(c, a)));
}
oracle::Rational area(const Point& axis, const std::vector<Point>& corners) {
  oracle::Rational sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += turn(axis, corners[0], corners[i], corners[i + 1]);
  return sum;
}

bool is_convex(const Point& axis, const std::vector<Point>& corners) {
  int sense = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int sign =
        turn(axis, corners[i], corners[(i + 1) % corners.size()], corners[(i + 2) % corners.size()]).sign();
    if (sign * sense < 0) return false;
    if (sign != 0) sense = sign;
  }
  return sense != 0;
}

// Of points in a plane that the axis is orthogonal to. Each side of the hull has all points on its left.
oracle::Rational area_of_hull(const Point& axis, std::vector<Point> points) {
  std::ranges::sort(points);
  const auto half = [&](const std::vector<Point>& sorted) {
    std::vector<Point> chain;
    for (const Point& p : sorted) {
      while (chain.size() > 1 && turn(axis, chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    return chain;
  };
  std::vector<Point> hull = half(points);
  std::ranges::reverse(points);
  const std::vector<Point> back = half(points);
  hull.insert(hull.end(), back.begin() + 1, back.end());
  return abs(area(axis, hull));
}

void require_tiled(const Subject& subject, const Point& axis, const std::vector<Region>& regions) {
  oracle::Rational sum = 0;
  std::vector<Point> corners;
  for (const Region& region : regions) {
    require_none(subject.input, is_convex(axis, region.corners) ? "" : "a region that is not convex", "");
    sum += abs(area(axis, region.corners));
    corners.insert(corners.end(), region.corners.begin(), region.corners.end());
  }
  require_none(subject.input, sum == area_of_hull(axis, corners) ? "" : "regions that do not tile their facet",
               oracle::Rational(sum).str() + " of " + area_of_hull(axis, corners).str());
}

// Its corners do not tell a point inside.
bool is_half_plane_or_more(const Region& region) {
  Point sum;
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    if (region.is_vector[i]) sum = oracle::moved(sum, 1, region.corners[i]);
  }
  return region.corners.empty() || (!region.is_bounded() && sum == Point{});
}

// Inside of the pyramid over the region, near its middle.
Point point_inside(const Region& region, const Point& apex) {
  Point middle;
  oracle::Rational count = 0;
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    middle = oracle::moved(middle, 1, region.corners[i]);
    count += region.is_vector[i] ? 0 : 1;
  }
  for (oracle::Rational& x : middle) x /= count;
  return oracle::moved(apex, oracle::Rational(2, 3), oracle::minus(middle, apex));
}

void require_right_regions(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const PointSet& points = subject.complex.points();
  const FlowLimits limits(subject.complex.diagram(), stationary);
  const StableVolumes volumes(subject.complex.diagram(), stationary, limits);
  StableRegions made(subject.complex.diagram(), limits);
  const Facets facets = facets_of(made);
  const auto sample = [&](PointId name) {
    const auto& p = points.points()[points.ordinal_of_row(name)];
    return Point{p.x, p.y, p.z};
  };
  std::vector<oracle::Rational> sums(stationary.size());
  std::size_t asked = 0;
  const std::size_t step = 1 + facets.size() / kPoints;
  for (const auto& [samples, regions] : facets) {
    const Point p = sample(samples[0]), axis = oracle::minus(sample(samples[1]), p);
    const bool is_bounded = std::ranges::all_of(regions, &Region::is_bounded);
    if (is_bounded) require_tiled(subject, axis, regions);
    ++totals.facets;
    totals.bounded += is_bounded ? 1 : 0;
    for (const Region& region : regions) {
      ++totals.regions;
      if (region.limit) {
        require_none(subject.input, region.is_bounded() ? "" : "an unbounded region with a finite limit", "");
        sums[*region.limit] += abs(area(axis, region.corners)) / 6;
      }
      if (is_half_plane_or_more(region) || asked++ % step != 0) continue;
      const Point x = point_inside(region, p);
      const auto limit = subject.complex.limit({x[0], x[1], x[2]});
      const Ids mine = region.limit ? ids(stationary.contact(*region.limit)) : Ids{};
      require_none(subject.input, (limit ? ids(limit->contact) : Ids{}) == mine ? "" : "a point that flows elsewhere",
                   "");
      ++totals.points;
    }
  }
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    require_none(subject.input, sums[i] == volumes.exact(i) ? "" : "regions and arcs give different volumes", "");
  }
  ++totals.inputs;
}

TEST(StableRegions, TileFacetsAndFlowToTheirLimits) {
  CITES("FC-STAB-05", "FC-VOL-01", "FC-VOL-02");
  Totals all;
  const bool agreed =
      expect_in_all_families("regions", {kInputsPerFamily, kInputsPerFamily}, require_right_regions, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 1150U);
    EXPECT_GE(all.bounded, 1300U);
    EXPECT_GE(all.regions, all.facets + 20000);
    EXPECT_GE(all.points, 6650U);
  }
}

// In the first inputs, the near side of a facet ends at a right angle, whose edge lies on a ray. In the others, a
// regular point separates two regions that flow to infinity. Random inputs seldom have these.
TEST(StableRegions, OfRareFacets) {
  CITES("FC-STAB-05", "FC-VOL-02");
  const std::vector<fuzz::Input> inputs = {
      {{{0, 3, 1}, {3, 2, 0}, {2, 1, 0}, {1, 3, 0}, {1, 3, 3}, {1, 2, 0}}},
      {{{0, 0, 1}, {0, 4, 0}, {1, 1, 0}, {1, 2, 1}, {1, 0, 3}, {3, 1, 0}}},
      {{{0, 3, 0}, {5, 3, 1}, {0, 2, 0}, {2, 4, 2}, {5, 3, 0}}},
      {{{5, 2, 0}, {4, 1, 0}, {0, 1, 0}, {1, 0, 1}, {4, 4, 2}}},
  };
  Totals totals;
  for (const fuzz::Input& input : inputs) {
    expect_holds("regions", parameters_of_one_input(), [&] { require_right_regions(Subject(input), totals); });
  }
  EXPECT_EQ(totals.inputs, inputs.size());
}

}  // namespace
}  // namespace flowcert::property::stable_regions_test
