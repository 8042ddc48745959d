// The second invariant, in space and in a plane: if every zero sign on merged faces counts as positive, the
// counts exceed the strict ones by what the regular stationary points of each kind account for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "flowcert/stationary_points.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/read_out_complex.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::closed_rule_test {

using namespace voronoi;
namespace {

using Counts = std::array<long long, 3>;  // of index 1, 2, 3

Counts closed_counts(const VoronoiComplex& complex) {
  Counts closed{};
  const CompactDelaunay& delaunay = complex.delaunay();
  for (const auto& [edge, around] : edges_of(complex)) {
    closed[0] += around.polygons.size() > 1 && around.least_angle != Sign::kNegative ? 1 : 0;
  }
  for (const auto& [polygon, facets] : facets_by_polygon(complex)) {
    bool counts = true;
    for (const PolygonSide& side : sides_of(complex, facets)) counts = counts && side.angle != Sign::kNegative;
    const FacetRef mirror = delaunay.mirror(facets.front());
    counts = counts && complex.side(facets.front()) != Sign::kNegative;
    counts = counts && (!delaunay.is_finite(mirror.cell) || complex.side(mirror) != Sign::kNegative);
    closed[1] += counts ? 1 : 0;
  }
  std::map<CellIndex, bool> clusters;
  for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
    bool& counts = clusters.try_emplace(complex.cluster(cell), true).first->second;
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (complex.role({cell, i}) == VoronoiComplex::FacetRole::kInterior) continue;
      counts = counts && complex.side({cell, i}) != Sign::kNegative;
    }
  }
  for (const auto& [cluster, counts] : clusters) closed[2] += counts ? 1 : 0;
  return closed;
}

Counts closed_counts(const PlanarComplex& complex) {
  Counts closed{};
  const CompactDelaunay& delaunay = complex.delaunay();
  for (const auto& [edge, around] : edges_of(complex)) {
    const bool is_facet = around.polygons.size() > 1 || around.on_hull;
    closed[0] += is_facet && around.least_angle != Sign::kNegative ? 1 : 0;
  }
  for (const std::vector<CellIndex>& polygon : complex.polygons()) {
    bool counts = true;
    for (const CellIndex cell : polygon) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const CellIndex beyond = delaunay.neighbors(cell)[i];
        // This does not ask is_diagonal(), because the strict counts use it.
        if (std::find(polygon.begin(), polygon.end(), beyond) != polygon.end()) continue;
        counts = counts && complex.angle(cell, i) != Sign::kNegative;
      }
    }
    closed[1] += counts ? 1 : 0;
  }
  return closed;
}

struct KindsSeen {
  int inputs = 0;
  std::array<std::size_t, 3> points{};  // regular stationary points of kind 1-2, 2-3, 1-3
  std::array<int, 3> inputs_with{};
};

// Checks and counts nothing where the points do not span the dimension.
void check_closed_rule(const std::vector<Point>& rows, int dimension, KindsSeen& seen) {
  const PointSet points(rows);
  const Delaunay delaunay(points);
  if (delaunay.dimension() != dimension) return;
  const VoronoiDiagram diagram(delaunay);
  const StationaryPoints strict = stationary_points(diagram);
  const Counts closed = dimension == 3 ? closed_counts(diagram.complex()) : closed_counts(*diagram.planar());
  const auto& counts = strict.critical_counts();
  const RegularCounts regular = strict.regular_counts();
  const std::array<std::size_t, 3> by_kind = {regular.kind12, regular.kind23, regular.kind13};
  const auto n12 = static_cast<long long>(by_kind[0]), n23 = static_cast<long long>(by_kind[1]),
             n13 = static_cast<long long>(by_kind[2]);
  const Counts excess = {n12 + n13, n12 + 2 * n13 + n23, n13 + n23};
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(closed[k] - static_cast<long long>(counts[k + 1]), excess[k]) << "index " << k + 1;
  }
  ASSERT_EQ(static_cast<long long>(points.size()) - closed[0] + closed[1] - closed[2], 1);
  ++seen.inputs;
  for (std::size_t k = 0; k < 3; ++k) {
    seen.points[k] += by_kind[k];
    seen.inputs_with[k] += by_kind[k] > 0 ? 1 : 0;
  }
}

KindsSeen check_families(int dimension, const std::set<std::string>& names, int inputs_each, int largest_size) {
  KindsSeen seen;
  std::size_t found = 0;
  for (const fuzz::Family& family : fuzz::families()) {
    if (!names.contains(family.name)) continue;
    ++found;
    for (int k = 0; k < inputs_each; ++k) {
      const fuzz::Input input = fuzz::draw(family, static_cast<std::uint64_t>(1000 + k), k % (largest_size + 1));
      SCOPED_TRACE(testing::Message() << family.name << ", seed " << 1000 + k << '\n' << input);
      check_closed_rule(property::rows_of(input), dimension, seen);
      if (testing::Test::HasFatalFailure()) return seen;
    }
  }
  EXPECT_EQ(found, names.size()) << "a family has another name now";
  std::cout << seen.inputs << " inputs of dimension " << dimension
            << "; regular stationary points of kind 1-2: " << seen.points[0] << " in " << seen.inputs_with[0]
            << " inputs, 2-3: " << seen.points[1] << " in " << seen.inputs_with[1] << ", 1-3: " << seen.points[2]
            << " in " << seen.inputs_with[2] << '\n';
  return seen;
}

TEST(ClosedRuleTest, ExceedsTheStrictCountsByTheRegularPoints) {
  CITES("FC-INV-02", "FC-INV-01", "FC-SIGN-04");
  const KindsSeen seen = check_families(
      3,
      {"lattice-2", "lattice-3", "right-angles", "signed-permutations", "integer-sphere", "sphere-and-others",
       "box-corners", "two-circles", "duplicates", "one-ulp-off", "far-away", "rounded-sphere", "mixed-magnitudes"},
      300, 60);
  EXPECT_GE(seen.inputs, 2000);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(seen.inputs_with[k], 50);
}

TEST(ClosedRuleTest, ExceedsTheStrictCountsOfCoplanarInput) {
  CITES("FC-INV-02", "FC-INV-01");
  const KindsSeen seen = check_families(2, {"coplanar-lattice", "coplanar-circles", "few-points"}, 400, 60);
  EXPECT_GE(seen.inputs, 500);
  EXPECT_GT(seen.inputs_with[0], 100);
  EXPECT_EQ(seen.inputs_with[1] + seen.inputs_with[2], 0) << "kinds that need three dimensions";
}

// The signs that the rule counts, on an input where each kind occurs (spec, example of FC-INV-01).
TEST(ClosedRuleTest, OfAnExample) {
  CITES("FC-INV-02");
  KindsSeen seen;
  check_closed_rule({{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}}, 3, seen);
  EXPECT_EQ(seen.points, (std::array<std::size_t, 3>{2, 0, 1}));
}

}  // namespace
}  // namespace flowcert::closed_rule_test
