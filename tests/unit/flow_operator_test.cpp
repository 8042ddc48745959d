// What decides the flow's signs: intervals suffice where nothing is degenerate, exact numbers are asked where
// something is, and chains of constructions beyond the limit are cut. The statistics' arithmetic is tested
// too. (tests/property/orbit_agreement_test.cpp tests that the answers are right.)
#include "flow/flow_operator.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"
#include "morse/record_finder.h"
#include "tests/cites.h"

namespace flowcert::flow_operator_test {

using namespace flow;
using namespace morse;
namespace {

using property::rows_of;

constexpr FlowOptions kLazyBinary = {ConstructionKernel::kLazy, FacetSearch::kBinary};

// An edge whose facet is a decagon, seen from an obtuse neighbour. Rows 0 and 1 are its ends.
PointSet decagon() { return PointSet(rows_of(fuzz::high_degree_facet(10, false, 1))); }

// All failures of the kernel's intervals.
std::uint64_t failures(const KernelTally& tally) {
  std::uint64_t sum = 0;
  for (const FilterCount& count : tally.counts) sum += count.failures;
  return sum;
}

TEST(LazyKernel, IntervalsDecideWhereNothingIsDegenerate) {
  CITES("FC-NUM-01");
  const PointSet points(std::vector<Point>{{0, 0, 0}, {7, 1, 2}, {3, 9, 1}, {2, 3, 8}, {11, 12, 5}, {-4, 6, 7}});
  const VoronoiDiagram diagram{Delaunay(points)};
  Flow flow(diagram, kLazyBinary);
  for (int k = 0; k < 20; ++k) {
    (void)flow.orbit({Rational(3 * k + 1) / 7, Rational(5 * k - 30) / 11, Rational(40 - 2 * k) / 13});
  }
  EXPECT_GT(flow.tally()[FlowPrimitive::kSideOfRay].calls, 0u);
  EXPECT_EQ(failures(flow.tally()), 0u);
}

// The decagon's facet.
FacetName facet_of_rows_0_and_1(const VoronoiFaces& faces) {
  std::array<VertexIndex, 2> v{};
  for (VertexIndex k = 0; k < faces.diagram().delaunay().ordinals.size(); ++k) {
    if (faces.diagram().delaunay().ordinals[k] < 2) v[faces.diagram().delaunay().ordinals[k]] = k;
  }
  return {std::min(v[0], v[1]), std::max(v[0], v[1])};
}

// Symmetry sends the orbit through a Voronoi vertex. There a sign is zero, which no interval of a constructed
// point can tell.
TEST(LazyKernel, ExactNumbersDecideAtAVoronoiVertex) {
  CITES("FC-NUM-01", "FC-FLOW-02");
  const PointSet points = decagon();
  const VoronoiDiagram diagram{Delaunay(points)};
  VoronoiFaces faces(diagram);
  const auto flow = make_flow_operator(faces, kLazyBinary);
  const FacetName name = facet_of_rows_0_and_1(faces);
  const FacetRing ring = faces.ring(name);
  std::size_t hits = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    // x lies on the way from m to a vertex, a little before it. For vertices on the far side x is in the facet.
    const Location vertex{Place::at_vertex(ring.pieces[k].vertex), kNoPoint};
    const RationalPoint o = flow->exact(vertex);
    const RationalPoint x{o[0] * 999 / 1000, o[1] * 999 / 1000, o[2] * 999 / 1000};
    if (faces.locate(x).kind != Place::Kind::kFacet) continue;
    const std::uint64_t before = failures(flow->tally());
    const FlowStep step = flow->step({Place::on_facet(name), flow->add(x)});
    EXPECT_EQ(step.end.place, vertex.place);
    EXPECT_GT(failures(flow->tally()), before);
    ++hits;
  }
  EXPECT_GT(hits, 0u);
}

// The orbit misses the Voronoi vertex by less and less. Below the rounding of a double, intervals that are
// not rounded outwards would tell a wrong sign.
TEST(LazyKernel, NearTiesAreTheExactKernels) {
  CITES("FC-NUM-01", "FC-FLOW-02");
  const PointSet points = decagon();
  const VoronoiDiagram diagram{Delaunay(points)};
  VoronoiFaces faces(diagram);
  const auto lazy = make_flow_operator(faces, kLazyBinary);
  const auto exact = make_flow_operator(faces, {ConstructionKernel::kExact, FacetSearch::kBinary});
  const FacetName name = facet_of_rows_0_and_1(faces);
  const FacetRing ring = faces.ring(name);
  const std::size_t n = ring.size();
  std::size_t compared = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const RationalPoint o = exact->exact({Place::at_vertex(ring.pieces[k].vertex), kNoPoint});
    const RationalPoint beside = exact->exact({Place::at_vertex(ring.pieces[(k + 1) % n].vertex), kNoPoint});
    for (int exponent = 40; exponent < 80; ++exponent) {
      for (const int sign : {-1, 1}) {
        const Rational little = Rational(sign) / Rational(std::uint64_t{1} << (exponent / 2)) /
                                Rational(std::uint64_t{1} << (exponent - exponent / 2));
        RationalPoint x;
        for (std::size_t i = 0; i < 3; ++i) x[i] = o[i] * 997 / 1000 + little * (beside[i] - o[i]);
        if (faces.locate(x).kind != Place::Kind::kFacet) continue;
        const Place start = Place::on_facet(name);
        EXPECT_EQ(lazy->step({start, lazy->add(x)}).end.place, exact->step({start, exact->add(x)}).end.place);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 100u);
}

TEST(LazyKernel, LongChainsAreCut) {
  CITES("FC-FLOW-05");
  const PointSet points(rows_of(fuzz::long_cascade(1200, 1)));
  const FlowComplex complex(points, kLazyBinary);
  const UnstableManifolds& manifolds = complex.unstable();
  EXPECT_GT(manifolds.statistics().n_wcc.max(), 1000u);
  EXPECT_EQ(manifolds.statistics().depth, 1000u);
}

// Its recipes are replayed in a loop.
TEST(CascadeKernel, LongChainsStayWhole) {
  CITES("FC-FLOW-05");
  const PointSet points(rows_of(fuzz::long_cascade(1200, 1)));
  const FlowComplex complex(points, {ConstructionKernel::kCascade, FacetSearch::kBinary});
  const FlowStatistics& statistics = complex.unstable().statistics();
  EXPECT_GT(statistics.n_wcc.max(), 1000u);
  EXPECT_GT(statistics.depth, 1000u);
}

TEST(ExactKernel, CountsNoFailure) {
  CITES("FC-NUM-01");
  const PointSet points = decagon();
  const FlowComplex complex(points);
  const StationaryPoints& stationary = complex.stationary();
  const UnstableManifolds manifolds(complex.diagram(), stationary, {ConstructionKernel::kExact, FacetSearch::kBinary});
  EXPECT_EQ(failures(manifolds.statistics().tally), 0u);
  EXPECT_EQ(manifolds.statistics().depth, 0u);
  EXPECT_EQ(manifolds.statistics().exact_bytes.count(),
            3 * manifolds.statistics().tally[FlowPrimitive::kCrossing].calls);
}

TEST(Distribution, TellsWhatAListTells) {
  CITES("FC-FLOW-07");
  Distribution d;
  EXPECT_EQ(d.count(), 0u);
  EXPECT_EQ(d.max(), 0u);
  EXPECT_EQ(d.mode(), 0u);
  EXPECT_EQ(d.mean(), 0);
  EXPECT_EQ(d.median(), 0);
  EXPECT_EQ(d.standard_deviation(), 0);
  for (const std::size_t value : std::initializer_list<std::size_t>{2, 4, 4, 4, 5, 5, 7, 9}) d.add(value);
  EXPECT_EQ(d.count(), 8u);
  EXPECT_EQ(d.max(), 9u);
  EXPECT_EQ(d.mode(), 4u);
  EXPECT_EQ(d.mean(), 5);
  EXPECT_EQ(d.median(), 4.5);
  EXPECT_EQ(d.standard_deviation(), 2);
  d.add(5);
  EXPECT_EQ(d.mode(), 4u) << "of several the smallest";
  EXPECT_EQ(d.median(), 5);
  d.add(100, 3);
  EXPECT_EQ(d.count(), 12u);
}

TEST(RecordFinder, FindsEachRecordAndNoOther) {
  CITES("FC-OUT-02");
  const PointSet points(
      rows_of({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}, {5, 1, 1}}}));
  const FlowComplex complex(points);
  const StationaryPoints& list = complex.stationary();
  const RecordFinder finder(list);
  for (std::size_t record = 0; record < list.size(); ++record) {
    EXPECT_EQ(finder.find(list.index(record), list.contact(record)), record);
    const auto [first, last] = finder.range(list.index(record));
    EXPECT_LE(first, record);
    EXPECT_LT(record, last);
  }
  const std::array<PointId, 3> nothing{0, 7, 8};
  EXPECT_EQ(finder.find({2, 2}, nothing), std::nullopt);
  const auto [first, last] = finder.range({1, 3});
  EXPECT_EQ(first, last);
}

}  // namespace
}  // namespace flowcert::flow_operator_test
