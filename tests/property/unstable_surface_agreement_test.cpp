// Unstable sets of dimension 2 of the fast implementation against the oracle's (FC-UNST-04 to 06), on all families.
//
// Guarantees: sets are compared exactly, part by part, for the cascade kernel and the exact one. The oracle follows
// intervals and points, and cuts regions by the bisectors of all points. The fast implementation finds the exits of
// single rays by the signs of the flow. The sets in doubles have the same parts, where P spans space. The test fails
// too when too few sets had parts that are rare.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/unstable_surfaces.h"
#include "fuzz/properties/stable_pieces.h"
#include "oracle/unstable_surface.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/oracle_pieces.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::unstable_surface_agreement_test {
namespace {

constexpr int kInputsPerFamily = 8;
constexpr int kInputsMadeForThis = 20;     // of each of the families for stable sets
constexpr std::size_t kSetsByOracle = 12;  // at most so many of an input

struct Totals {
  std::size_t sets = 0, regular = 0, vertices = 0, traces = 0, points = 0, runs = 0, sheets = 0, unbounded = 0;
  std::size_t segments = 0, shared = 0, in_doubles = 0;

  void add(const Totals& part) {
    sets += part.sets, regular += part.regular, vertices += part.vertices, traces += part.traces;
    points += part.points, runs += part.runs, sheets += part.sheets, unbounded += part.unbounded;
    segments += part.segments, shared += part.shared, in_doubles += part.in_doubles;
  }
  void print_row(const std::string& name) const {
    std::printf("%-24s %5zu sets, %4zu regular; %6zu vertices, %6zu traces (%4zu points, %4zu of two facets), ",
                name.c_str(), sets, regular, vertices, traces, points, shared);
    std::printf("%5zu runs, %6zu sheets (%5zu unbounded), %4zu segments\n", runs, sheets, unbounded, segments);
  }
};

// How many sheets have a side on the trace, with rays that leave there.
std::size_t sheets_into(const oracle::PointSet& points, const oracle::UnstableSurface& set,
                        const oracle::EdgePart& trace) {
  const auto& polygon = trace.polygon;
  const auto has = [&](std::size_t name) { return std::ranges::binary_search(polygon, name); };
  const auto is_on = [&](const oracle::Corner& x) {
    if (x == trace.front || x == trace.back) return true;
    if (x.at_infinity || trace.front.at_infinity) return false;
    const oracle::Point u = oracle::way_to(trace.front, x.position), v = oracle::way_to(trace.back, x.position);
    return oracle::cross(u, v) == oracle::Point{} && oracle::dot(u, v) < 0;
  };
  return static_cast<std::size_t>(std::ranges::count_if(set.sheets, [&](const oracle::Region& sheet) {
    if (!has(sheet.samples[0]) || !has(sheet.samples[1]) || std::ranges::count_if(sheet.corners, is_on) < 2)
      return false;
    const oracle::Places pair = oracle::places_of(points, {sheet.samples[0], sheet.samples[1]});
    return std::ranges::any_of(oracle::places_of(points, polygon), [&](std::size_t q) {
      return oracle::dot(oracle::minus(points.points[q], points.points[pair[0]]),
                         oracle::minus(points.points[q], points.points[pair[1]])) > 0;
    });
  }));
}

void count(const oracle::PointSet& points, const oracle::UnstableSurface& set, bool is_critical, Totals& totals) {
  ++totals.sets;
  totals.regular += is_critical ? 0 : 1;
  totals.vertices += set.vertices.size();
  totals.traces += set.traces.size();
  for (const auto& trace : set.traces) totals.points += trace.front == trace.back;
  totals.runs += set.runs.size();
  totals.sheets += set.sheets.size();
  for (const auto& sheet : set.sheets) totals.unbounded += !sheet.corners.empty() && sheet.corners.back().at_infinity;
  totals.segments += set.segments.size();
  for (const auto& trace : set.traces) totals.shared += sheets_into(points, set, trace) > 1;
}

// ---- In doubles ----

using RoundedPart = std::tuple<RoundedUnstableSurface::Kind, std::vector<PointId>, std::vector<Corner<>>>;

// Nearest doubles; what would overflow stays exact.
Corner<> rounded(Corner<> corner) {
  for (Rational& x : corner.position) {
    if (const auto nearest = nearest_double(x)) x = Rational(*nearest);
  }
  return corner;
}

// Counterclockwise seen from the second sample, from the least corner on. Corners at infinity are vectors.
std::vector<Corner<>> turned(const PointSet& points, const Region<>& sheet) {
  const auto sample = [&](std::size_t k) {
    const Point& p = points[points.ordinal_of_row(sheet.samples[k])];
    return std::array<Rational, 3>{Rational(p.x), Rational(p.y), Rational(p.z)};
  };
  const auto minus = [](const RationalPoint& u, const RationalPoint& v) {
    return RationalPoint{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  };
  const RationalPoint way = minus(sample(1), sample(0)), origin = sheet.corners.front().position;
  const auto from_origin = [&](const Corner<>& c) { return c.at_infinity ? c.position : minus(c.position, origin); };
  Rational turn = 0;
  for (std::size_t k = 1; k + 1 < sheet.corners.size(); ++k) {
    const RationalPoint u = from_origin(sheet.corners[k]), v = from_origin(sheet.corners[k + 1]);
    turn += way[0] * (u[1] * v[2] - u[2] * v[1]) + way[1] * (u[2] * v[0] - u[0] * v[2]) +
            way[2] * (u[0] * v[1] - u[1] * v[0]);
  }
  RC_ASSERT(turn != 0);
  std::vector<Corner<>> corners = sheet.corners;
  if (turn < 0) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

std::vector<RoundedPart> parts_in_doubles(const PointSet& points, const UnstableSurface<>& set) {
  using Kind = RoundedUnstableSurface::Kind;
  std::vector<RoundedPart> parts;
  const auto add_edge = [&](Kind kind, const EdgePart<>& part) {
    const std::vector<PointId> samples(part.polygon.begin(), part.polygon.begin() + 3);
    parts.push_back({kind, samples, {part.front, part.back}});
    if (part.front == part.back) std::get<2>(parts.back()).pop_back();
  };
  for (const auto& part : set.traces) add_edge(Kind::kTrace, part);
  for (const auto& part : set.runs) add_edge(Kind::kRun, part);
  for (const auto& [samples, front, back] : set.segments) {
    parts.push_back({Kind::kSegment, {samples[0], samples[1]}, {back, front}});
  }
  for (const auto& sheet : set.sheets) {
    parts.push_back({Kind::kSheet, {sheet.samples[0], sheet.samples[1]}, turned(points, sheet)});
  }
  return parts;
}

// Corners in an order of their own: of lines both ways are one, and a sheet begins anywhere.
void make_comparable(std::vector<RoundedPart>& parts) {
  for (auto& [kind, samples, corners] : parts) {
    for (Corner<>& corner : corners) corner = rounded(std::move(corner));
    if (kind != RoundedUnstableSurface::Kind::kSheet) {
      std::sort(corners.begin(), corners.end());
      continue;
    }
    std::vector<Corner<>> least = corners;
    for (std::size_t k = 1; k < corners.size(); ++k) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      if (corners < least) least = corners;
    }
    corners = least;
  }
  std::ranges::sort(parts);
}

// The set in doubles has the same parts, with corners that are one iff they are exactly equal.
void require_same_in_doubles(const PointSet& points, const UnstableSurface<>& set, const RoundedUnstableSurface& fast) {
  std::vector<RoundedPart> exact = parts_in_doubles(points, set), mine;
  std::vector<Corner<>> corners;
  for (const auto& [kind, samples, places] : exact) corners.insert(corners.end(), places.begin(), places.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  RC_ASSERT(corners.size() == fast.corners.size());
  for (const auto& [kind, samples, numbers] : fast.parts) {
    mine.push_back({kind, samples, {}});
    for (const std::uint32_t number : numbers) {
      const auto& [position, at_infinity, beyond] = fast.corners[number];
      const RationalPoint x =
          beyond ? *beyond : RationalPoint{Rational(position.x), Rational(position.y), Rational(position.z)};
      std::get<2>(mine.back()).push_back({x, at_infinity});
    }
  }
  make_comparable(exact);
  make_comparable(mine);
  RC_ASSERT(exact == mine);
}

void require_right_sets(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const UnstableSurfaces cascade(subject.complex.diagram(), stationary);
  const UnstableSurfaces exact(subject.complex.diagram(), stationary,
                               {ConstructionKernel::kExact, FacetSearch::kLinear});
  const std::size_t step = 1 + cascade.size() / kSetsByOracle;
  for (std::size_t i = 0; i < cascade.size(); i += step) {
    const auto y = oracle_point(subject.complex.points(), stationary, cascade.record(i));
    const UnstableSurface<> fast = cascade.set(i), its = to_fast(oracle::unstable_surface(subject.set, y));
    require_none(subject.input, fast == its ? "" : "another unstable set of " + text_of(Ids(y.contact)),
                 "the fast implementation's:\n" + text_of(fast) + "the oracle's:\n" + text_of(its));
    RC_ASSERT(exact.set(i) == fast);
    RC_ASSERT(cascade.size_of(i) == (UnstableSurfaceSize{fast.vertices.size(), fast.traces.size(), fast.runs.size(),
                                                         fast.sheets.size(), fast.segments.size()}));
    if (subject.complex.dimension() == 3) {
      require_same_in_doubles(subject.complex.points(), fast, cascade.rounded_set(i));
      ++totals.in_doubles;
    }
    count(subject.set, to_oracle(fast), y.is_critical(), totals);
  }
}

TEST(UnstableSurfaceAgreement, SetsAreTheOracles) {
  CITES("FC-UNST-04", "FC-UNST-05", "FC-UNST-06");
  Totals all;
  const bool agreed =
      expect_in_all_families("unstable sets", {kInputsPerFamily, kInputsMadeForThis}, require_right_sets, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.sets, 1650U);
    EXPECT_GE(all.regular, 100U);
    EXPECT_GE(all.runs, 300U);
    EXPECT_GE(all.segments, 100U);
    EXPECT_GE(all.unbounded, 1000U);
    EXPECT_GE(all.shared, 150U);
    EXPECT_GE(all.in_doubles, 1000U);
  }
}

}  // namespace
}  // namespace flowcert::property::unstable_surface_agreement_test
