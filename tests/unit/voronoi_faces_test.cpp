// The rings of Voronoi facets, on every family of degenerate inputs, in rationals: strictly convex polygons,
// counterclockwise, without duplicate vertices, each piece an edge of the diagram between the two vertices
// that it says; and the lookups that make a query logarithmic.
#include "voronoi/voronoi_faces.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "fuzz/inputs/case_stream.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/rational_geometry.h"

namespace flowcert::voronoi_faces_test {

using namespace voronoi;
namespace {

using flowcert_tests::determinant;
using flowcert_tests::exactly;
using flowcert_tests::inner;
using flowcert_tests::minus;
using flowcert_tests::normal_of;
using flowcert_tests::sign_of;

struct Subject {
  explicit Subject(const fuzz::Input& input)
      : points(property::point_set_of(input)), diagram(Delaunay(points)), faces(diagram) {}

  [[nodiscard]] RationalPoint at(VertexIndex v) const { return exactly(faces.diagram().point(v)); }
  [[nodiscard]] RationalPoint center(CellIndex cluster) const {
    const auto& v = faces.diagram().delaunay().vertices(cluster);
    return flowcert_tests::circumcenter(at(v[0]), at(v[1]), at(v[2]), at(v[3]));
  }
  // The sides of all polygons.
  [[nodiscard]] std::vector<FacetName> facets() const {
    std::set<std::pair<VertexIndex, VertexIndex>> names;
    for (CellIndex cell = 0; cell < faces.diagram().delaunay().finite_count; ++cell) {
      for (std::uint32_t i = faces.diagram().dimension() == 2 ? 3 : 0; i < 4; ++i) {
        if (faces.diagram().dimension() == 3 &&
            faces.diagram().complex().role({cell, i}) == VoronoiComplex::FacetRole::kInterior)
          continue;
        for (const PolygonSide& side : faces.diagram().sides(faces.diagram().polygon({cell, i})))
          names.emplace(side.v0, side.v1);
      }
    }
    std::vector<FacetName> facets;
    facets.reserve(names.size());
    for (const auto& [v0, v1] : names) facets.push_back({v0, v1});
    return facets;
  }

  PointSet points;
  VoronoiDiagram diagram;
  VoronoiFaces faces;
};

// The direction in which the boundary runs along a piece: the edge turned by a quarter from its outward
// normal.
RationalPoint along(const Subject& diagram, FacetName name, VertexIndex apex) {
  const RationalPoint e = minus(diagram.at(name.v1), diagram.at(name.v0));
  const RationalPoint g = minus(diagram.at(apex), diagram.at(name.v0));
  return {e[1] * g[2] - e[2] * g[1], e[2] * g[0] - e[0] * g[2], e[0] * g[1] - e[1] * g[0]};
}

void expect_piece_is_an_edge(const Subject& diagram, const FacetRing& ring, FacetName name, std::size_t k) {
  const std::size_t n = ring.pieces.size();
  const RingPiece& piece = ring.pieces[k];
  const RingElement from = ring.element(k), to = ring.element((k + 1) % n);
  // The gaps are exactly the pieces at infinity, from a direction that leads away to one that comes back.
  const bool is_gap = from.vertex == kNoCell && to.vertex == kNoCell && from.factor == 1 && to.factor == -1;
  ASSERT_EQ(!piece.is_finite(), is_gap);
  if (is_gap) return;
  const auto contact = diagram.faces.diagram().contact(Place::on_edge(piece.polygon()));
  for (const VertexIndex v : {name.v0, name.v1, piece.apex}) {
    EXPECT_TRUE(std::find(contact.begin(), contact.end(), v) != contact.end());
  }
  // The edge's two ends are the elements beside the piece, in either order.
  std::multiset<CellIndex> ends, beside{from.vertex, to.vertex};
  for (const std::size_t side : {0U, 1U}) ends.insert(diagram.faces.diagram().end(piece.polygon(), side));
  EXPECT_EQ(ends, beside);
  if (from.vertex != kNoCell && to.vertex != kNoCell) {
    const RationalPoint step = minus(diagram.center(to.vertex), diagram.center(from.vertex));
    EXPECT_GT(inner(step, along(diagram, name, piece.apex)), 0) << "counterclockwise";
  }
  if (from.vertex == kNoCell) {
    EXPECT_EQ(from.apex, piece.apex);
  }
  if (to.vertex == kNoCell) {
    EXPECT_EQ(to.apex, piece.apex);
  }
}

void expect_convex(const Subject& diagram, const FacetRing& ring, FacetName name) {
  const RationalPoint e = minus(diagram.at(name.v1), diagram.at(name.v0));
  const std::size_t n = ring.pieces.size();
  for (std::size_t k = 0; k < n; ++k) {
    const RingPiece &here = ring.pieces[k], &next = ring.pieces[(k + 1) % n];
    if (!here.is_finite() || !next.is_finite() || n < 3) continue;
    EXPECT_EQ(sign_of(determinant(along(diagram, name, here.apex), along(diagram, name, next.apex), e)), 1);
  }
}

void expect_lookups(const Subject& diagram, const FacetRing& ring) {
  for (std::size_t k = 0; k < ring.pieces.size(); ++k) {
    if (ring.pieces[k].is_finite()) {
      EXPECT_EQ(diagram.faces.piece_of(ring, ring.pieces[k].polygon()), k);
    }
    if (ring.pieces[k].vertex != kNoCell) {
      EXPECT_EQ(diagram.faces.element_of(ring, ring.pieces[k].vertex), k);
    }
  }
}

// A link leads to the same Voronoi edge in the ring of the polygon's obtuse side, asked for the first time or again.
void expect_links(Subject& diagram, RingNumber id) {
  VoronoiFaces& rings = diagram.faces;
  for (std::size_t k = 0; k < rings.ring(id).size(); ++k) {
    const RingPiece piece = rings.ring(id).pieces[k];
    if (!piece.is_finite()) continue;
    const PolygonDriver driver = diagram.faces.diagram().driver(piece.polygon());
    for (int twice = 0; twice < 2; ++twice) {
      const RingLink link = rings.link(id, k);
      ASSERT_EQ(link.ring == RingLink::kAlongEdge, driver.shape != Sign::kNegative);
      if (link.ring == RingLink::kAlongEdge) continue;
      const FacetRing next = rings.ring(link.ring);
      EXPECT_EQ(next.facet, driver.side);
      EXPECT_EQ(next.pieces[link.place].polygon(), piece.polygon());
      EXPECT_EQ(next.pieces.data(), diagram.faces.ring(driver.side).pieces.data());
    }
  }
}

TEST(VoronoiFaces, RingsAreConvexPolygonsWithoutDuplicates) {
  CITES("FC-VOR-01", "FC-VOR-02", "FC-VOR-03");
  std::size_t rings = 0, unbounded = 0, merged = 0;
  for (const fuzz::Family& family : fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const fuzz::Input input = fuzz::draw(family, seed, static_cast<int>(20 + 4 * seed));
      if (input.rows.empty()) continue;
      Subject diagram(input);
      if (diagram.faces.diagram().dimension() < 2) continue;
      for (const FacetName name : diagram.facets()) {
        const FacetRing ring = diagram.faces.ring(name);
        std::set<CellIndex> vertices;
        std::size_t finite = 0;
        for (const RingPiece& piece : ring.pieces) {
          if (piece.vertex == kNoCell) continue;
          vertices.insert(piece.vertex);
          ++finite;
          merged += diagram.faces.diagram().complex().is_alone(piece.vertex) ? 0 : 1;
        }
        EXPECT_EQ(vertices.size(), finite) << "a Voronoi vertex twice in one ring";
        for (std::size_t k = 0; k < ring.pieces.size(); ++k) expect_piece_is_an_edge(diagram, ring, name, k);
        expect_convex(diagram, ring, name);
        expect_lookups(diagram, ring);
        expect_links(diagram, ring.id);
        ++rings;
        unbounded += finite < ring.size() ? 1 : 0;
      }
    }
  }
  // Otherwise nothing of this was tested.
  EXPECT_GT(rings, 5000u);
  EXPECT_GT(unbounded, 1000u);
  EXPECT_GT(merged, 500u);
}

TEST(VoronoiFaces, LargeRingsAreSearchedNotScanned) {
  CITES("FC-VOR-03");
  for (const bool perturbed : {false, true}) {
    Subject diagram(fuzz::high_degree_facet(500, perturbed, 3));
    std::size_t large = 0;
    for (const FacetName name : diagram.facets()) {
      const FacetRing ring = diagram.faces.ring(name);
      large += ring.size() == 500 ? 1 : 0;
      expect_lookups(diagram, ring);
      expect_links(diagram, ring.id);
      // A second query gives the same array.
      EXPECT_EQ(diagram.faces.ring(name).pieces.data(), diagram.faces.ring(name).pieces.data());
    }
    EXPECT_EQ(large, 1u);
  }
}

// The walk may begin at any sample.
TEST(VoronoiFaces, APositionIsFoundFromEveryHint) {
  CITES("FC-VOR-01");
  fuzz::CaseRun run;
  run.seed = 11;
  std::set<Place::Kind> kinds;
  for (std::size_t number = 0; number < 40; ++number) {
    Subject diagram(fuzz::input_of_case(run, number));
    const auto samples = static_cast<VertexIndex>(diagram.faces.diagram().delaunay().points.size());
    if (samples < 2) continue;
    for (VertexIndex v = 1; v < samples && v < 12; ++v) {
      const RationalPoint p = diagram.at(v - 1), q = diagram.at(v);
      const RationalPoint x = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
      const Place place = diagram.faces.locate(x);
      kinds.insert(place.kind);
      for (VertexIndex hint = 0; hint < samples; ++hint) EXPECT_EQ(diagram.faces.locate(x, hint), place);
    }
  }
  EXPECT_GE(kinds.size(), 3U);
}

TEST(VoronoiFaces, FewerDimensionsHaveNoRings) {
  CITES("FC-VOR-03");
  Subject line({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}});
  EXPECT_TRUE(line.faces.ring({0, 1}).pieces.empty());
  EXPECT_EQ(line.faces.locate({Rational(1) / 2, Rational(1) / 2, Rational(1) / 2}).kind, Place::Kind::kFacet);
  Subject point({{{5, 6, 7}}});
  EXPECT_EQ(point.faces.locate({0, 0, 0}).kind, Place::Kind::kCell);
}

}  // namespace
}  // namespace flowcert::voronoi_faces_test
