// The stable sets of index-2 and regular stationary points, by the fast implementation under both kernels,
// against the oracle's, which follows them backwards by scans over all points (FC-STAB-01 to 05).
//
// Guarantees: segments, intervals and sectors are compared as sets, exactly. What the fast implementation
// says of a set without building it (sizes, flags, statistics, boundaries where no tie is broken) is counted
// again from the oracle's. The test fails too when too few sets had Voronoi vertices, intervals, or regular
// ends.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "fuzz/families.h"
#include "oracle/orbit.h"
#include "oracle/stable_set.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property {
namespace {

constexpr int kInputsPerFamily = 80;
constexpr std::size_t kSetsByOracle = 40;  // at most so many of an input

using Ids = std::vector<std::size_t>;
using SegmentKey = std::tuple<Ids, RationalPoint, RationalPoint, Ids, Ids, std::string>;
using IntervalKey = std::tuple<Ids, RationalPoint, RationalPoint, bool>;
using SectorKey = std::tuple<Ids, std::vector<RationalPoint>>;

// A stable set as either implementation has it.
struct Pieces {
  std::vector<SegmentKey> segments;
  std::vector<IntervalKey> intervals;
  std::vector<SectorKey> sectors;

  void sort() {
    std::sort(segments.begin(), segments.end());
    std::sort(intervals.begin(), intervals.end());
    std::sort(sectors.begin(), sectors.end());
  }
  friend bool operator==(const Pieces&, const Pieces&) = default;
};

Ids ids(const auto& names) { return Ids(names.begin(), names.end()); }

Pieces pieces_of(const StableSet& set) {
  Pieces pieces;
  for (const auto& s : set.segments) {
    pieces.segments.emplace_back(ids(s.samples), s.front, s.back, ids(s.front_contact), ids(s.back_contact),
                                 back_kind_text(s.back_kind));
  }
  for (const auto& i : set.intervals) {
    pieces.intervals.emplace_back(ids(i.polygon), i.front, i.back, i.back_is_stationary);
  }
  for (const auto& s : set.sectors) pieces.sectors.emplace_back(ids(s.samples), s.corners);
  pieces.sort();
  return pieces;
}

// The oracle also lists the intervals that sectors come through, which the sectors' corners tell.
Pieces pieces_of(const oracle::PointSet& points, const oracle::StableSet& set) {
  const std::map<oracle::BackKind, std::string> kinds = {{oracle::BackKind::kCritical, "critical"},
                                                         {oracle::BackKind::kRegular, "regular"},
                                                         {oracle::BackKind::kEdge, "edge"},
                                                         {oracle::BackKind::kVertex, "vertex"}};
  Pieces pieces;
  for (const auto& s : set.segments) {
    pieces.segments.emplace_back(ids(s.samples), s.front, s.back, s.front_contact, s.back_contact,
                                 kinds.at(s.back_kind));
  }
  for (const auto& i : set.intervals) {
    if (i.kind == oracle::IntervalKind::kCrossed) continue;
    pieces.intervals.emplace_back(i.polygon, i.front, i.back, !oracle::flow_segment(points, i.back));
  }
  for (const auto& s : set.sectors) pieces.sectors.emplace_back(ids(s.samples), s.polygon);
  pieces.sort();
  return pieces;
}

std::string text_of(const RationalPoint& x) {
  return '(' + x[0].str() + ' ' + x[1].str() + ' ' + x[2].str() + ')';
}
std::string text_of(const Ids& names) {
  std::string text = "{";
  for (const std::size_t name : names) text.append(text.size() > 1 ? " " : "").append(std::to_string(name));
  text += '}';
  return text;
}

std::string text_of(const Pieces& pieces) {
  std::string text;
  for (const auto& [samples, front, back, front_contact, back_contact, kind] : pieces.segments) {
    text += "  segment " + text_of(samples) + ' ' + text_of(front) + text_of(front_contact) + " to " +
            text_of(back) + text_of(back_contact) + ' ' + kind + '\n';
  }
  for (const auto& [polygon, front, back, is_stationary] : pieces.intervals) {
    text += "  interval " + text_of(polygon) + ' ' + text_of(front) + " to " + text_of(back) +
            (is_stationary ? " stationary\n" : "\n");
  }
  for (const auto& [samples, corners] : pieces.sectors) {
    text += "  sector " + text_of(samples);
    for (const RationalPoint& x : corners) text += ' ' + text_of(x);
    text += '\n';
  }
  return text;
}

struct Totals {
  std::size_t sets = 0, with_vertex = 0, with_interval = 0, with_sector_cut = 0, regular_ends = 0;
};

oracle::StationaryPoint stationary_point(const Subject& subject, const StationaryPoints& stationary,
                                         std::size_t record) {
  const ExactSphere sphere = exact_sphere(subject.points, stationary.contact(record));
  return {sphere.center, sphere.squared_radius, ids(stationary.contact(record)),
          stationary.index(record).face_dimension, stationary.index(record).hull_dimension};
}

void require_same_pieces(const Subject& subject, const std::string& what, const Pieces& a, const Pieces& b) {
  require_none(subject.input, a == b ? "" : what,
               "the fast implementation's:\n" + text_of(a) + "the oracle's:\n" + text_of(b));
}

// Sample pairs that critical backs lie between, an odd number of times.
std::vector<Ids> boundary_by_oracle(const Pieces& pieces) {
  std::map<Ids, std::size_t> times;
  for (const auto& segment : pieces.segments) {
    if (std::get<5>(segment) == "critical") ++times[std::get<0>(segment)];
  }
  std::vector<Ids> edges;
  for (const auto& [samples, count] : times) {
    if (count % 2 == 1) edges.push_back(samples);
  }
  return edges;
}

// What the list says of a set without its geometry.
void require_right_summary(const Subject& subject, const StationaryPoints& stationary,
                           const StableManifolds& manifolds, std::size_t i, const Pieces& pieces,
                           bool has_vertex, Totals& totals) {
  const bool has_regular_end =
      std::any_of(pieces.segments.begin(), pieces.segments.end(),
                  [](const SegmentKey& segment) { return std::get<5>(segment) == "regular"; });
  require_none(subject.input, manifolds.has_vertex(i) == has_vertex ? "" : "has_vertex() is wrong", "");
  const bool has_interval = !pieces.intervals.empty();
  require_none(subject.input, manifolds.has_interval(i) == has_interval ? "" : "has_interval() is wrong", "");
  if (!has_interval) {
    const bool right = manifolds.segment_count(i) == pieces.segments.size();
    require_none(subject.input, right ? "" : "segment_count() is wrong", text_of(pieces));
  }
  ++totals.sets;
  totals.with_vertex += has_vertex ? 1 : 0;
  totals.with_interval += has_interval ? 1 : 0;
  totals.regular_ends += has_regular_end ? 1 : 0;
  totals.with_sector_cut += std::any_of(pieces.sectors.begin(), pieces.sectors.end(),
                                        [](const SectorKey& s) { return std::get<1>(s).size() > 3; });
  if (has_vertex || has_regular_end || !stationary.index(manifolds.record(i)).is_critical()) return;
  std::vector<Ids> edges;
  for (const std::uint32_t record : manifolds.boundary(i)) edges.push_back(ids(stationary.contact(record)));
  std::sort(edges.begin(), edges.end());
  require_none(subject.input, edges == boundary_by_oracle(pieces) ? "" : "boundary() is wrong", "");
}

void require_right_sets(const Subject& subject, Totals& totals) {
  const StationaryPoints stationary = stationary_points(subject.delaunay);
  StableManifolds lazy(subject.delaunay, stationary);
  StableManifolds exact(subject.delaunay, stationary, {{ConstructionKernel::kExact, FacetSearch::kLinear}});
  RC_ASSERT(lazy.size() == exact.size());
  const std::size_t step = 1 + lazy.size() / kSetsByOracle;
  for (std::size_t i = 0; i < lazy.size(); i += step) {
    const Pieces fast = pieces_of(lazy.set(i));
    const auto z = stationary_point(subject, stationary, lazy.record(i));
    const oracle::StableSet by_oracle = oracle::stable_set(subject.set, z);
    const std::string name = "the stable set of " + text_of(z.contact);
    require_same_pieces(subject, name, fast, pieces_of(subject.set, by_oracle));
    require_same_pieces(subject, name + ", by the exact kernel", pieces_of(exact.set(i)), fast);
    require_right_summary(subject, stationary, lazy, i, fast, by_oracle.has_vertex, totals);
  }
}

void add(Totals& sum, const Totals& part) {
  sum.sets += part.sets;
  sum.with_vertex += part.with_vertex;
  sum.with_interval += part.with_interval;
  sum.with_sector_cut += part.with_sector_cut;
  sum.regular_ends += part.regular_ends;
}

void print_row(const std::string& name, const Totals& totals) {
  std::printf(
      "%-24s %6zu sets; with a Voronoi vertex %5zu, with intervals %5zu, with sectors cut off %3zu, with "
      "regular ends %5zu\n",
      name.c_str(), totals.sets, totals.with_vertex, totals.with_interval, totals.with_sector_cut,
      totals.regular_ends);
}

TEST(StableAgreement, SetsAreTheOracles) {
  CITES("FC-STAB-01", "FC-STAB-03", "FC-STAB-04", "FC-STAB-05", "FC-STAB-06", "FC-STAB-07");
  Totals all;
  bool agreed = true;
  for (const fuzz::Family& family : fuzz::families()) {
    Totals totals;
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds("stable sets, " + family.name, parameters_of_run(kInputsPerFamily),
                          [&] {
                            const fuzz::Input input = *generator;
                            require_right_sets(Subject(input), totals);
                          }) &&
             agreed;
    print_row(family.name, totals);
    add(all, totals);
  }
  print_row("all", all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.sets, 5000U);
    EXPECT_GE(all.with_vertex, 500U);
    EXPECT_GE(all.with_interval, 500U);
    EXPECT_GT(all.with_sector_cut, 0U);
    EXPECT_GE(all.regular_ends, 500U);
  }
}

}  // namespace
}  // namespace flowcert::property
