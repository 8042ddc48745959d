// What flows to infinity, by the fast implementation under all kernels, against the oracle's, which finds what comes
// from there by trying all pairs and triples of samples (FC-STAB-08).
//
// Guarantees: all pieces are compared as sets, exactly, those with ends at infinity and the others. The test fails too
// when there were too few pieces of a sort, or too few inputs that do not span space.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/stable_pieces.h"
#include "fuzz/properties/subject.h"
#include "oracle/stable_set.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::infinity_agreement_test {
namespace {

constexpr int kInputsPerFamily = 10;
constexpr int kInputsMadeForThis = 20;  // of each of the families for stable sets

struct Totals {
  std::size_t inputs = 0, flat = 0, bounded = 0, segments = 0, intervals = 0, sectors = 0, two_ends = 0, regular = 0,
              through_vertex = 0, cut = 0;

  void add(const StableSet<>& set) {
    ++inputs;
    for (const auto& segment : set.segments) {
      ++(is_unbounded(segment) ? segments : bounded);
      regular += is_unbounded(segment) && segment.back_kind == BackKind::kRegular ? 1 : 0;
      through_vertex += is_unbounded(segment) && segment.back_kind == BackKind::kVertex ? 1 : 0;
    }
    for (const auto& interval : set.intervals) ++(is_unbounded(interval) ? intervals : bounded);
    for (const auto& sector : set.sectors) {
      ++(is_unbounded(sector) ? sectors : bounded);
      two_ends += std::ranges::count(sector.corners, true, &Corner<>::at_infinity) == 2 ? 1 : 0;
      cut += is_unbounded(sector) && sector.corners.size() > 3 ? 1 : 0;
    }
  }
};

// The lists of both implementations are sorted.
void require_right_set(const Subject& subject, Totals& totals) {
  const auto set_by = [&](ConstructionKernel kernel, FacetSearch search) {
    return StableManifolds(subject.complex.diagram(), subject.complex.stationary(), {kernel, search}).set_of_infinity();
  };
  const StableSet<> fast = set_by(ConstructionKernel::kCascade, FacetSearch::kBinary);
  const auto require_same = [&](const StableSet<>& other, const std::string& whose) {
    require_none(subject.input, fast == other ? "" : "another set of infinity",
                 "the cascade kernel's:\n" + text_of(fast) + whose + ":\n" + text_of(other));
  };
  require_same(to_fast(subject.set, oracle::stable_set_of_infinity(subject.set)), "the oracle's");
  require_same(set_by(ConstructionKernel::kLazy, FacetSearch::kBinary), "the lazy kernel's");
  require_same(set_by(ConstructionKernel::kExact, FacetSearch::kLinear), "the exact kernel's");
  totals.add(fast);
  totals.flat += subject.complex.dimension() < 3 ? 1 : 0;
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
