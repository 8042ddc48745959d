// The stable sets of index-2 and regular stationary points, by the fast implementation under all kernels,
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
#include <string>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "fuzz/properties/stable_pieces.h"
#include "oracle/stable_set.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"
#include "tests/property/stable_skeleton.h"

namespace flowcert::property::stable_agreement_test {
namespace {

constexpr int kInputsPerFamily = 30;
constexpr int kInputsMadeForThis = 140;    // of each of the families for stable sets
constexpr std::size_t kSetsByOracle = 40;  // at most so many of an input

struct Totals {
  std::size_t sets = 0, with_vertex = 0, with_interval = 0, with_sector_cut = 0, regular_ends = 0;

  void add(const Totals& part) {
    sets += part.sets;
    with_vertex += part.with_vertex;
    with_interval += part.with_interval;
    with_sector_cut += part.with_sector_cut;
    regular_ends += part.regular_ends;
  }
  void print_row(const std::string& name) const {
    std::printf(
        "%-24s %6zu sets; with a Voronoi vertex %5zu, with intervals %5zu, with sectors cut off %3zu, with "
        "regular ends %5zu\n",
        name.c_str(), sets, with_vertex, with_interval, with_sector_cut, regular_ends);
  }
};

void require_same_pieces(const Subject& subject, const std::string& what, const StableSet<>& a, const StableSet<>& b) {
  require_none(subject.input, a == b ? "" : what,
               "the fast implementation's:\n" + text_of(a) + "the oracle's:\n" + text_of(b));
}

// What the list says of a set without its geometry.
void require_right_summary(const Subject& subject, const StationaryPoints& stationary, const StableManifolds& manifolds,
                           std::size_t i, const StableSet<>& pieces, bool has_vertex, Totals& totals) {
  const bool has_regular_end = std::any_of(pieces.segments.begin(), pieces.segments.end(),
                                           [](const auto& segment) { return segment.back_kind == BackKind::kRegular; });
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
  totals.with_sector_cut +=
      std::any_of(pieces.sectors.begin(), pieces.sectors.end(), [](const Region<>& s) { return s.corners.size() > 3; });
  const auto boundary = boundary_of(pieces, has_vertex);
  if (!boundary || !stationary.index(manifolds.record(i)).is_critical()) return;
  std::vector<Ids> edges;
  for (const std::uint32_t record : manifolds.boundary(i)) edges.push_back(ids(stationary.contact(record)));
  std::sort(edges.begin(), edges.end());
  require_none(subject.input, edges == *boundary ? "" : "boundary() is wrong", "");
}

void require_right_sets(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const auto sets_by = [&](ConstructionKernel kernel, FacetSearch search) {
    return StableManifolds(subject.complex.diagram(), stationary, {kernel, search});
  };
  const StableManifolds lazy = sets_by(ConstructionKernel::kLazy, FacetSearch::kBinary);
  const StableManifolds cascade = sets_by(ConstructionKernel::kCascade, FacetSearch::kBinary);
  const StableManifolds exact = sets_by(ConstructionKernel::kExact, FacetSearch::kLinear);
  RC_ASSERT(lazy.size() == exact.size());
  RC_ASSERT(lazy.size() == cascade.size());
  const std::size_t step = 1 + lazy.size() / kSetsByOracle;
  for (std::size_t i = 0; i < lazy.size(); i += step) {
    const StableSet<> fast = lazy.set(i);
    const auto z = oracle_point(subject.complex.points(), stationary, lazy.record(i));
    const oracle::StableSet by_oracle = oracle::stable_set(subject.set, z);
    const std::string name = "the stable set of " + text_of(z.contact);
    require_same_pieces(subject, name, fast, to_fast(subject.set, by_oracle));
    require_same_pieces(subject, name + ", by the exact kernel", exact.set(i), fast);
    require_same_pieces(subject, name + ", by the cascade kernel", cascade.set(i), fast);
    const bool same_boundary = std::ranges::equal(cascade.boundary(i), lazy.boundary(i)) &&
                               cascade.has_vertex(i) == lazy.has_vertex(i) &&
                               cascade.has_interval(i) == lazy.has_interval(i);
    require_none(subject.input, same_boundary ? "" : "another summary by the cascade kernel for " + name, "");
    const bool same_skeleton = skeleton_of(subject.set, z, lazy.set(i)) == by_oracle;
    require_none(subject.input, same_skeleton ? "" : "another skeleton follows for " + name, text_of(fast));
    require_right_summary(subject, stationary, lazy, i, fast, by_oracle.has_vertex, totals);
  }
}

// The stable sets of maxima, of dimension 3 all over.
void require_right_maxima(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const StableManifolds exact(subject.complex.diagram(), stationary,
                              {ConstructionKernel::kExact, FacetSearch::kLinear});
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    if (stationary.index(record) != StationaryIndex{3, 3}) continue;
    const StableSet<> fast = subject.complex.stable().set_of_record(record);
    const auto z = oracle_point(subject.complex.points(), stationary, record);
    const std::string name = "the stable set of the maximum " + text_of(z.contact);
    require_same_pieces(subject, name, fast, to_fast(subject.set, oracle::stable_set(subject.set, z)));
    require_same_pieces(subject, name + ", by the exact kernel", exact.set_of_record(record), fast);
    ++totals.sets;
    totals.with_sector_cut +=
        std::any_of(fast.sectors.begin(), fast.sectors.end(), [](const Region<>& s) { return s.corners.size() > 3; });
  }
}

TEST(StableAgreement, SetsAreTheOracles) {
  CITES("FC-STAB-01", "FC-STAB-03", "FC-STAB-04", "FC-STAB-05", "FC-STAB-06", "FC-STAB-07");
  Totals all;
  const bool agreed =
      expect_in_all_families("stable sets", {kInputsPerFamily, kInputsMadeForThis}, require_right_sets, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.sets, 3300U);
    EXPECT_GE(all.with_vertex, 500U);
    EXPECT_GE(all.with_interval, 300U);
    EXPECT_GE(all.with_sector_cut, 65U);
    EXPECT_GE(all.regular_ends, 300U);
  }
}

TEST(StableAgreement, SetsOfMaximaAreTheOracles) {
  CITES("FC-STAB-03", "FC-STAB-05");
  Totals all;
  const bool agreed =
      expect_in_all_families("stable sets of maxima", {kInputsPerFamily, kInputsPerFamily}, require_right_maxima, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.sets, 150U);
    EXPECT_GE(all.with_sector_cut, 65U);
  }
}

// In each input a sector's ray ends in a Voronoi vertex of the near side. That vertex belongs to neither side
// of the ray, and nothing beyond it belongs to the sector. Random inputs seldom have such rays.
TEST(StableAgreement, SectorsWhoseRaysMeetVoronoiVerticesAreTheOracles) {
  CITES("FC-STAB-05");
  const std::vector<fuzz::Input> inputs = {{{{-9, -2, 3}, {-1, -2, 3}, {-5, 6, 3}, {-5, -4, 5}, {-5, -4, 1}}},
                                           {{{-3, 1, 1}, {5, 1, 1}, {1, 9, 1}, {-1, -1, 1}, {1, -1, -1}, {1, -1, 3}}}};
  for (const fuzz::Input& input : inputs) {
    Totals totals;
    expect_holds("sectors", parameters_of_one_input(), [&] { require_right_sets(Subject(input), totals); });
    EXPECT_GE(totals.with_interval, 2U);
  }
}

}  // namespace
}  // namespace flowcert::property::stable_agreement_test
