// What flows to infinity, by the fast implementation under all kernels, against the oracle's, which finds what comes
// from there by trying all pairs and triples of samples (FC-STAB-08).
//
// Guarantees: all pieces are compared as sets, exactly, those with ends at infinity and the others. The test fails too
// when there were too few pieces of a sort, or too few inputs that do not span space.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/stable_pieces.h"
#include "fuzz/properties/subject.h"
#include "oracle/orbit.h"
#include "oracle/stable_set.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::infinity_agreement_test {
namespace {

constexpr int kInputsPerFamily = 10;
constexpr int kInputsMadeForThis = 20;  // of each of the families for stable sets

using RayKey = std::tuple<Ids, RationalPoint, RationalPoint, Ids, std::string>;
using EdgeKey = std::tuple<Ids, RationalPoint, RationalPoint, bool>;
using CornerKey = std::pair<bool, RationalPoint>;
using FarSectorKey = std::pair<Ids, std::vector<CornerKey>>;

// The set of infinity as either implementation has it.
struct FarPieces {
  Pieces bounded;
  std::vector<RayKey> segments;
  std::vector<EdgeKey> intervals;
  std::vector<FarSectorKey> sectors;

  void sort() {
    std::sort(segments.begin(), segments.end());
    std::sort(intervals.begin(), intervals.end());
    std::sort(sectors.begin(), sectors.end());
  }
  friend bool operator==(const FarPieces&, const FarPieces&) = default;
};

FarPieces far_pieces_of(const InfinitySet& set) {
  FarPieces pieces{pieces_of(set.bounded), {}, {}, {}};
  for (const auto& s : set.segments) {
    pieces.segments.emplace_back(ids(s.samples), s.vector, s.back, ids(s.back_contact), back_kind_text(s.back_kind));
  }
  for (const auto& i : set.intervals) {
    pieces.intervals.emplace_back(ids(i.polygon), i.vector, i.back, i.back_is_stationary);
  }
  for (const auto& s : set.sectors) {
    pieces.sectors.emplace_back(ids(s.samples), std::vector<CornerKey>{});
    for (const auto& [is_vector, position] : s.corners) pieces.sectors.back().second.emplace_back(is_vector, position);
  }
  return pieces;
}

// The sectors' corners tell the intervals that sectors come through.
FarPieces far_pieces_of(const oracle::PointSet& points, const oracle::StableSet& set) {
  constexpr std::array kKinds = {"critical", "regular", "edge", "vertex"};
  oracle::StableSet bounded;
  FarPieces pieces;
  for (const auto& s : set.segments) {
    if (!s.front.at_infinity) bounded.segments.push_back(s);
    if (!s.front.at_infinity) continue;
    pieces.segments.emplace_back(ids(s.samples), s.front.position, s.back.position, s.back_contact,
                                 kKinds.at(static_cast<std::size_t>(s.back_kind)));
  }
  for (const auto& i : set.intervals) {
    if (!i.front.at_infinity) bounded.intervals.push_back(i);
    if (!i.front.at_infinity) continue;
    pieces.intervals.emplace_back(i.polygon, i.front.position, i.back.position,
                                  !oracle::flow_segment(points, i.back.position));
  }
  for (const auto& s : set.sectors) {
    if (!oracle::is_unbounded(s)) bounded.sectors.push_back(s);
    if (!oracle::is_unbounded(s)) continue;
    pieces.sectors.emplace_back(ids(s.samples), std::vector<CornerKey>{});
    for (const auto& [at_infinity, x] : s.corners) pieces.sectors.back().second.emplace_back(at_infinity, x);
  }
  pieces.bounded = pieces_of(points, bounded);
  return pieces;
}

std::string text_of_far(const FarPieces& pieces) {
  std::string text = text_of(pieces.bounded);
  for (const auto& [samples, vector, back, contact, kind] : pieces.segments) {
    text += "  ray " + text_of(samples) + " along " + text_of(vector) + " from " + text_of(back) + text_of(contact) +
            ' ' + kind + '\n';
  }
  for (const auto& [polygon, vector, back, is_stationary] : pieces.intervals) {
    text += "  interval " + text_of(polygon) + " along " + text_of(vector) + " from " + text_of(back) +
            (is_stationary ? " stationary\n" : "\n");
  }
  for (const auto& [samples, corners] : pieces.sectors) {
    text += "  sector " + text_of(samples);
    for (const auto& [is_vector, x] : corners) text += (is_vector ? " along " : " ") + text_of(x);
    text += '\n';
  }
  return text;
}

struct Totals {
  std::size_t inputs = 0, flat = 0, bounded = 0, segments = 0, intervals = 0, sectors = 0, two_ends = 0, regular = 0,
              through_vertex = 0, cut = 0;

  void add(const FarPieces& pieces) {
    ++inputs;
    bounded += pieces.bounded.segments.size() + pieces.bounded.intervals.size() + pieces.bounded.sectors.size();
    segments += pieces.segments.size();
    intervals += pieces.intervals.size();
    sectors += pieces.sectors.size();
    for (const auto& [samples, vector, back, contact, kind] : pieces.segments) {
      regular += kind == "regular" ? 1 : 0;
      through_vertex += kind == "vertex" ? 1 : 0;
    }
    for (const auto& [samples, corners] : pieces.sectors) {
      two_ends += std::ranges::count(corners, true, &CornerKey::first) == 2 ? 1 : 0;
      cut += corners.size() > 3 ? 1 : 0;
    }
  }
};

void require_right_set(const Subject& subject, Totals& totals) {
  const auto set_by = [&](ConstructionKernel kernel, FacetSearch search) {
    return far_pieces_of(
        StableManifolds(subject.complex.diagram(), subject.complex.stationary(), {{kernel, search}}).set_of_infinity());
  };
  const FarPieces fast = set_by(ConstructionKernel::kCascade, FacetSearch::kBinary);
  const auto require_same = [&](FarPieces other, const std::string& whose) {
    other.sort();
    require_none(subject.input, fast == other ? "" : "another set of infinity",
                 "the cascade kernel's:\n" + text_of_far(fast) + whose + ":\n" + text_of_far(other));
  };
  FarPieces sorted = fast;
  sorted.sort();
  require_none(subject.input, sorted == fast ? "" : "the set of infinity is not sorted", "");
  require_same(far_pieces_of(subject.set, oracle::stable_set_of_infinity(subject.set)), "the oracle's");
  require_same(set_by(ConstructionKernel::kLazy, FacetSearch::kBinary), "the lazy kernel's");
  require_same(set_by(ConstructionKernel::kExact, FacetSearch::kLinear), "the exact kernel's");
  totals.add(fast);
  totals.flat += subject.complex.diagram().dimension() < 3 ? 1 : 0;
}

void add(Totals& sum, const Totals& part) {
  sum.inputs += part.inputs;
  sum.flat += part.flat;
  sum.bounded += part.bounded;
  sum.segments += part.segments;
  sum.intervals += part.intervals;
  sum.sectors += part.sectors;
  sum.two_ends += part.two_ends;
  sum.regular += part.regular;
  sum.through_vertex += part.through_vertex;
  sum.cut += part.cut;
}

void print_row(const std::string& name, const Totals& totals) {
  std::printf(
      "%-24s %5zu inputs, %4zu flat; %6zu rays, %4zu from regular points, %5zu from Voronoi vertices; %5zu intervals; "
      "%6zu sectors, %6zu with two ends, %5zu cut off; %6zu bounded pieces\n",
      name.c_str(), totals.inputs, totals.flat, totals.segments, totals.regular, totals.through_vertex,
      totals.intervals, totals.sectors, totals.two_ends, totals.cut, totals.bounded);
}

TEST(InfinityAgreement, SetsAreTheOracles) {
  CITES("FC-STAB-01", "FC-STAB-08");
  Totals all;
  bool agreed = true;
  const auto run = [&](const std::vector<fuzz::Family>& families, int inputs) {
    for (const fuzz::Family& family : families) {
      Totals totals;
      const rc::Gen<fuzz::Input> generator = family.generate();
      // A ray from a Voronoi vertex is rare elsewhere.
      const int count = family.name == "through-vertex" ? 3 * inputs : inputs;
      agreed = expect_holds("the set of infinity, " + family.name, parameters_of_run(count),
                            [&] {
                              const fuzz::Input input = *generator;
                              require_right_set(Subject(input), totals);
                            }) &&
               agreed;
      print_row(family.name, totals);
      add(all, totals);
    }
  };
  run(fuzz::families(), kInputsPerFamily);
  run(fuzz::stable_families(), kInputsMadeForThis);
  print_row("all", all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 300U);
    EXPECT_GE(all.flat, 30U);
    for (const std::size_t sort : {all.segments, all.intervals, all.sectors, all.two_ends, all.bounded}) {
      EXPECT_GE(sort, 300U);
    }
    EXPECT_GE(all.regular, 100U);
    EXPECT_GE(all.cut, 300U);
    EXPECT_GE(all.through_vertex, 1U);
  }
}

}  // namespace
}  // namespace flowcert::property::infinity_agreement_test
