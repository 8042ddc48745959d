// The merged Voronoi complex, as contact sets. It does not depend on the order of the points, nor on how CGAL
// cuts what is cospherical. On small inputs it equals what a search by definition finds, over all subsets of
// the points, in rationals, without any triangulation.
#include "voronoi/voronoi_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/portable_random.h"
#include "tests/unit/rational_geometry.h"
#include "tests/unit/read_out_complex.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::voronoi_complex_test {

using namespace voronoi;
namespace {

using flowcert_tests::circle_center;
using flowcert_tests::circumcenter;
using flowcert_tests::determinant;
using flowcert_tests::exactly;
using flowcert_tests::inner;
using flowcert_tests::minus;
using flowcert_tests::normal_of;
using flowcert_tests::PortableRandom;

using Coordinates = std::array<double, 3>;
using ContactSet = std::set<Coordinates>;
using ContactSets = std::set<ContactSet>;

Coordinates coordinates_of(const Point& p) { return {p.x, p.y, p.z}; }

// The faces of the diagram by dimension. Each contact set belongs to one face, so sets of sets lose nothing.
struct Faces {
  ContactSets vertices, edges, facets;
  friend bool operator==(const Faces&, const Faces&) = default;
};

std::ostream& operator<<(std::ostream& out, const Faces& faces) {
  for (const ContactSets* sets : {&faces.vertices, &faces.edges, &faces.facets}) {
    out << sets->size() << " faces:";
    for (const ContactSet& contact : *sets) {
      out << " {";
      for (const Coordinates& p : contact) out << '(' << p[0] << ',' << p[1] << ',' << p[2] << ')';
      out << '}';
    }
    out << '\n';
  }
  return out;
}

// ---- The complex under test, read out ----

ContactSet contact_of(const CompactDelaunay& delaunay, const std::set<VertexIndex>& vertices) {
  ContactSet contact;
  for (const VertexIndex v : vertices) contact.insert(coordinates_of(delaunay.points[v]));
  return contact;
}

std::set<VertexIndex> vertices_of(const CompactDelaunay& delaunay, const std::vector<FacetRef>& facets) {
  std::set<VertexIndex> vertices;
  for (const FacetRef facet : facets) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (k != facet.index) vertices.insert(delaunay.vertices(facet.cell)[k]);
    }
  }
  return vertices;
}

Faces faces_of(const VoronoiComplex& complex) {
  Faces faces;
  const CompactDelaunay& delaunay = complex.delaunay();
  std::map<CellIndex, std::set<VertexIndex>> clusters;
  for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
    const auto& v = delaunay.vertices(cell);
    clusters[complex.cluster(cell)].insert(v.begin(), v.end());
  }
  for (const auto& [cluster, vertices] : clusters) {
    EXPECT_TRUE(faces.vertices.insert(contact_of(delaunay, vertices)).second) << "a Voronoi vertex twice";
  }
  for (const auto& [polygon, facets] : facets_by_polygon(complex)) {
    EXPECT_TRUE(faces.edges.insert(contact_of(delaunay, vertices_of(delaunay, facets))).second)
        << "a Voronoi edge twice";
  }
  for (const auto& [edge, around] : edges_of(complex)) {
    if (around.polygons.size() > 1) faces.facets.insert(contact_of(delaunay, {edge.first, edge.second}));
  }
  return faces;
}

// The edges of a coplanar set's diagram are the lines of centres. It has no vertices.
Faces faces_of(const PlanarComplex& complex) {
  Faces faces;
  const CompactDelaunay& delaunay = complex.delaunay();
  for (const std::vector<CellIndex>& polygon : complex.polygons()) {
    std::set<VertexIndex> vertices;
    for (const CellIndex cell : polygon) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        vertices.insert(delaunay.vertices(cell)[i]);
        const FacetRef edge{cell, i};
        const CellIndex beyond = delaunay.neighbors(cell)[i];
        const bool same =
            delaunay.is_finite(beyond) && std::find(polygon.begin(), polygon.end(), beyond) != polygon.end();
        EXPECT_EQ(complex.is_diagonal(edge), same);
      }
    }
    EXPECT_TRUE(faces.edges.insert(contact_of(delaunay, vertices)).second) << "a Voronoi edge twice";
  }
  for (const auto& [edge, around] : edges_of(complex)) {
    if (around.polygons.size() > 1 || around.on_hull) {
      faces.facets.insert(contact_of(delaunay, {edge.first, edge.second}));
    }
  }
  return faces;
}

Faces faces_of(const std::vector<Point>& rows, ContactSets* cells = nullptr) {
  const PointSet points(rows);
  const Delaunay delaunay(points);
  CompactDelaunay compact = compact_copy(delaunay);
  if (cells != nullptr) {
    for (CellIndex cell = 0; cell < compact.finite_count; ++cell) {
      std::set<VertexIndex> vertices;
      for (const VertexIndex v : compact.vertices(cell)) {
        if (v != kInfiniteVertex) vertices.insert(v);
      }
      cells->insert(contact_of(compact, vertices));
    }
  }
  FilterTally tally;
  EXPECT_GE(compact.dimension, 2);
  if (compact.dimension == 2) return faces_of(PlanarComplex(std::move(compact), tally));
  return faces_of(VoronoiComplex(std::move(compact), tally));
}

// ---- By definition ----

// All points at the centre's distance, or nothing where one is nearer.
std::vector<Point> empty_sphere_contact(const std::vector<Point>& rows, const RationalPoint& center, const Point& on) {
  const Rational radius = flowcert_tests::squared_distance(exactly(on), center);
  std::vector<Point> contact;
  for (const Point& p : rows) {
    const Rational distance = flowcert_tests::squared_distance(exactly(p), center);
    if (distance < radius) return {};
    if (distance == radius) contact.push_back(p);
  }
  return contact;
}

ContactSet set_of(const std::vector<Point>& points) {
  ContactSet contact;
  for (const Point& p : points) contact.insert(coordinates_of(p));
  return contact;
}

// The sides of a convex polygon: pairs of its points with all others strictly on one side, in its plane.
void add_sides(const std::vector<Point>& polygon, Faces& faces) {
  const RationalPoint normal = normal_of(exactly(polygon[0]), exactly(polygon[1]), exactly(polygon[2]));
  for (const Point& p : polygon) {
    for (const Point& q : polygon) {
      if (p == q) continue;
      const bool is_side = std::all_of(polygon.begin(), polygon.end(), [&](const Point& r) {
        return r == p || r == q ||
               determinant(normal, minus(exactly(q), exactly(p)), minus(exactly(r), exactly(p))) > 0;
      });
      if (is_side) faces.facets.insert({coordinates_of(p), coordinates_of(q)});
    }
  }
}

// Adds the faces of a convex polytope, by its supporting planes. The points are all its vertices.
void add_polytope(const std::vector<Point>& polytope, Faces& faces) {
  const std::size_t n = polytope.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const RationalPoint base = exactly(polytope[i]);
        const RationalPoint normal = normal_of(base, exactly(polytope[j]), exactly(polytope[k]));
        std::vector<Point> on;
        bool above = false, below = false;
        for (const Point& p : polytope) {
          const Rational height = inner(normal, minus(exactly(p), base));
          if (height == 0) on.push_back(p);
          above = above || height > 0;
          below = below || height < 0;
        }
        if (above && below) continue;
        if (faces.edges.insert(set_of(on)).second) add_sides(on, faces);
      }
    }
  }
}

// The faces of the polytopes in the empty spheres (FC-VOR-01), among the spheres through all four points that
// are not coplanar.
Faces spatial_faces_by_definition(const std::vector<Point>& rows) {
  Faces faces;
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        for (std::size_t l = k + 1; l < n; ++l) {
          const RationalPoint p = exactly(rows[i]), q = exactly(rows[j]), r = exactly(rows[k]), s = exactly(rows[l]);
          if (determinant(minus(q, p), minus(r, p), minus(s, p)) == 0) continue;
          const std::vector<Point> contact = empty_sphere_contact(rows, circumcenter(p, q, r, s), rows[i]);
          if (!contact.empty() && faces.vertices.insert(set_of(contact)).second) add_polytope(contact, faces);
        }
      }
    }
  }
  return faces;
}

// The same in a plane, with the circles through three points that are not collinear.
Faces planar_faces_by_definition(const std::vector<Point>& rows) {
  Faces faces;
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        const RationalPoint p = exactly(rows[i]), q = exactly(rows[j]), r = exactly(rows[k]);
        const RationalPoint normal = normal_of(p, q, r);
        if (inner(normal, normal) == 0) continue;
        const std::vector<Point> contact = empty_sphere_contact(rows, circle_center(p, q, r), rows[i]);
        if (!contact.empty() && faces.edges.insert(set_of(contact)).second) add_sides(contact, faces);
      }
    }
  }
  return faces;
}

// ---- Inputs ----

std::vector<Point> box_corners(double x, double y, double z, const Point& at) {
  std::vector<Point> rows;
  for (const double i : {0.0, x}) {
    for (const double j : {0.0, y}) {
      for (const double k : {0.0, z}) rows.push_back({at.x + i, at.y + j, at.z + k});
    }
  }
  return rows;
}

std::vector<Point> lattice(int nx, int ny, int nz) {
  std::vector<Point> rows;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) rows.push_back({double(i), double(j), double(k)});
    }
  }
  return rows;
}

// All integer points of a sphere about the origin.
std::vector<Point> integer_sphere(int squared_radius) {
  std::vector<Point> rows;
  for (int i = -9; i <= 9; ++i) {
    for (int j = -9; j <= 9; ++j) {
      for (int k = -9; k <= 9; ++k) {
        if (i * i + j * j + k * k == squared_radius) rows.push_back({double(i), double(j), double(k)});
      }
    }
  }
  return rows;
}

// Points (u, v) in the plane along (1,2,2) and (2,1,-2), which are orthogonal and of one length.
Point tilted(double u, double v) { return {u + 2 * v + 1, 2 * u + v, 2 * u - 2 * v - 3}; }

struct Named {
  std::string name;
  std::vector<Point> rows;
};

std::vector<Named> degenerate_inputs() {
  std::vector<Named> inputs = {
      {"cube", box_corners(1, 1, 1, {0, 0, 0})},
      {"box", box_corners(1, 2, 3, {0, 0, 0})},
      {"lattice 3x3x3", lattice(3, 3, 3)},
      {"lattice 2x2x4", lattice(2, 2, 4)},
      {"octahedron", integer_sphere(1)},
      {"cuboctahedron", integer_sphere(2)},
      {"sphere of 24 points", integer_sphere(5)},
      {"sphere of 30 points", integer_sphere(9)},
      {"sphere and its centre", integer_sphere(5)},
      // Two clusters that share the square z = 0, and no other vertex.
      {"two cospherical clusters",
       {{3, 4, 0},
        {-3, 4, 0},
        {3, -4, 0},
        {-3, -4, 0},
        {4, 3, 5},
        {-4, -3, 5},
        {3, -4, 5},
        {4, 3, -7},
        {-4, -3, -7},
        {-3, 4, -7}}},
      {"stacked boxes", box_corners(2, 2, 1, {0, 0, 0})},
      {"square pyramid", {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {0, 0, 3}}},
      {"pyramid over a hexagon in a tilted plane",
       {tilted(5, 0), tilted(3, 4), tilted(-3, 4), tilted(-5, 0), tilted(-4, -3), tilted(4, -3), {40, -60, 7}}},
  };
  inputs[8].rows.push_back({0, 0, 0});
  for (const Point& p : box_corners(2, 2, 5, {0, 0, 1})) {
    if (p.z > 1) inputs[10].rows.push_back(p);
  }
  return inputs;
}

std::vector<Named> coplanar_inputs() {
  Named grid{"tilted grid", {}}, circle{"tilted circle", {}}, beside{"tilted circle and a point beside it", {}},
      level{"level grid", lattice(4, 3, 1)};
  for (int u = 0; u < 4; ++u) {
    for (int v = 0; v < 3; ++v) grid.rows.push_back(tilted(u, v));
  }
  for (int u = -5; u <= 5; ++u) {
    for (int v = -5; v <= 5; ++v) {
      if (u * u + v * v == 25) circle.rows.push_back(tilted(u, v));
    }
  }
  beside.rows = circle.rows;
  beside.rows.push_back(tilted(20, 1));
  return {grid, circle, beside, level};
}

std::vector<Point> distinct(std::vector<Point> rows) {
  const PointSet set(rows);
  return {set.points().begin(), set.points().end()};
}

int dimension_of(const std::vector<Point>& rows) {
  const PointSet set(rows);
  return Delaunay(set).dimension();
}

// ---- FC-VOR-01 to 04 ----

TEST(Delaunay, HasNoMoreCellsThanItMay) {
  CITES("FC-VOR-04");
  std::vector<Point> rows;
  for (int k = 0; k < 12; ++k) {
    rows.push_back({k + 0.01 * (k % 3), 0, 0});
    rows.push_back({6, k - 6 + 0.01 * (k % 5), 6});
  }
  const PointSet set(rows);
  const std::size_t cells = VoronoiDiagram(Delaunay(set)).delaunay().cells.size();
  EXPECT_GE(cells, 11U * 11U);
  EXPECT_EQ(VoronoiDiagram(Delaunay(set, {}, cells)).delaunay().cells.size(), cells);
  EXPECT_THROW((void)Delaunay(set, {}, cells - 1), InvalidInput);
}

// Image of integer points under a scaled isometry: axes permuted, signs changed, and half the time turned so
// that all axes are tilted. CGAL breaks ties by the lexicographic order of coordinates, so a permutation of
// the rows alone never changes the triangulation, but this does.
Point isometric_image(const Point& p, const std::array<std::size_t, 3>& axes, const std::array<double, 3>& signs,
                      bool is_turned) {
  const Coordinates from = coordinates_of(p);
  const double x = signs[0] * from[axes[0]], y = signs[1] * from[axes[1]], z = signs[2] * from[axes[2]];
  return is_turned ? Point{x + 2 * y + 2 * z, 2 * x + y - 2 * z, 2 * x - 2 * y + z} : Point{x, y, z};
}

ContactSets mapped(const ContactSets& sets, const std::map<Coordinates, Coordinates>& back) {
  ContactSets result;
  for (const ContactSet& contact : sets) {
    ContactSet original;
    for (const Coordinates& p : contact) original.insert(back.at(p));
    result.insert(std::move(original));
  }
  return result;
}

// The faces of the rows, found by way of another order and another triangulation; `cells` are its cells.
Faces faces_by_detour(std::vector<Point> rows, PortableRandom& random, ContactSets& cells) {
  random.shuffle(rows);
  std::vector<std::size_t> axes = {0, 1, 2};
  random.shuffle(axes);
  std::array<double, 3> signs{};
  for (double& sign : signs) sign = random.coin() ? 1 : -1;
  const bool is_turned = random.coin();
  std::map<Coordinates, Coordinates> back;
  for (Point& p : rows) {
    const Point image = isometric_image(p, {axes[0], axes[1], axes[2]}, signs, is_turned);
    back[coordinates_of(image)] = coordinates_of(p);
    p = image;
  }
  ContactSets cells_of_images;
  const Faces faces = faces_of(rows, &cells_of_images);
  cells = mapped(cells_of_images, back);
  return {mapped(faces.vertices, back), mapped(faces.edges, back), mapped(faces.facets, back)};
}

TEST(VoronoiComplexTest, FacesDoNotDependOnTheTriangulation) {
  CITES("FC-VOR-01", "FC-VOR-02", "FC-VOR-03", "FC-VOR-04");
  PortableRandom random(31);
  std::vector<Named> inputs = degenerate_inputs();
  for (Named& coplanar : coplanar_inputs()) inputs.push_back(std::move(coplanar));
  for (const Named& input : inputs) {
    const Faces expected = faces_of(input.rows);
    std::set<ContactSets> triangulations;
    for (int k = 0; k < 40; ++k) {
      ContactSets cells;
      ASSERT_EQ(faces_by_detour(input.rows, random, cells), expected) << input.name;
      triangulations.insert(std::move(cells));
    }
    // Otherwise the detours would have shown nothing.
    EXPECT_GE(triangulations.size(), 2u) << input.name;
  }
}

TEST(VoronoiComplexTest, FacesDoNotDependOnTheTriangulationOfRandomLattices) {
  CITES("FC-VOR-01", "FC-VOR-02", "FC-VOR-03", "FC-VOR-04");
  PortableRandom random(32);
  int spatial = 0, differently_cut = 0;
  for (int run = 0; run < 400; ++run) {
    std::vector<Point> rows(4 + random.below(20));
    const int width = random.between(1, 3);
    for (Point& p : rows) {
      p = {double(random.between(0, width)), double(random.between(0, width)), double(random.between(0, width))};
    }
    if (dimension_of(rows) < 2) continue;
    spatial += dimension_of(rows) == 3 ? 1 : 0;
    ContactSets first;
    const Faces expected = faces_of(rows, &first);
    for (int k = 0; k < 5; ++k) {
      ContactSets cells;
      ASSERT_EQ(faces_by_detour(rows, random, cells), expected);
      differently_cut += cells == first ? 0 : 1;
    }
  }
  EXPECT_GT(spatial, 300);
  EXPECT_GT(differently_cut, 500);
}

TEST(VoronoiComplexTest, FacesAreThoseOfTheDefinition) {
  CITES("FC-VOR-01", "FC-VOR-02", "FC-VOR-03");
  for (const Named& input : degenerate_inputs()) {
    if (input.rows.size() > 16) continue;
    ASSERT_EQ(dimension_of(input.rows), 3) << input.name;
    EXPECT_EQ(faces_of(input.rows), spatial_faces_by_definition(input.rows)) << input.name;
  }
  for (const Named& input : coplanar_inputs()) {
    ASSERT_EQ(dimension_of(input.rows), 2) << input.name;
    EXPECT_EQ(faces_of(input.rows), planar_faces_by_definition(input.rows)) << input.name;
  }
}

TEST(VoronoiComplexTest, FacesOfRandomInputsAreThoseOfTheDefinition) {
  CITES("FC-VOR-01", "FC-VOR-02", "FC-VOR-03", "FC-NUM-01");
  PortableRandom random(33);
  int spatial = 0, merged = 0;
  for (int run = 0; run < 500; ++run) {
    std::vector<Point> rows(4 + random.below(7));
    const int width = random.between(1, 4);
    const bool flat = random.below(5) == 0;
    for (Point& p : rows) {
      const double u = random.between(0, width), v = random.between(0, width), w = random.between(0, width);
      p = flat ? tilted(u, v) : Point{u, v, w};
    }
    // One ulp breaks what was degenerate.
    if (random.below(4) == 0) rows[0].x = std::nextafter(rows[0].x, 9.0);
    rows = distinct(std::move(rows));
    const int dimension = dimension_of(rows);
    if (dimension < 2) continue;
    const Faces expected = dimension == 3 ? spatial_faces_by_definition(rows) : planar_faces_by_definition(rows);
    ASSERT_EQ(faces_of(rows), expected);
    spatial += dimension == 3 ? 1 : 0;
    for (const ContactSet& contact : dimension == 3 ? expected.vertices : expected.edges) {
      merged += contact.size() > static_cast<std::size_t>(dimension) + 1 ? 1 : 0;
    }
  }
  EXPECT_GT(spatial, 250);
  EXPECT_GT(merged, 200);
}

TEST(VoronoiComplexTest, ASquareHasFourSidesAndNoDiagonal) {
  CITES("FC-VOR-02", "FC-VOR-03", "FC-SIGN-01");
  const PointSet cube(box_corners(1, 1, 1, {0, 0, 0}));
  const Delaunay delaunay(cube);
  FilterTally tally;
  const VoronoiComplex complex(compact_copy(delaunay), tally);
  ASSERT_EQ(complex.large_cluster_count(), 1u);
  ASSERT_EQ(complex.large_polygon_count(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    const PolygonSides sides = sides_of(complex, complex.large_polygon(k));
    ASSERT_EQ(sides.size(), 4u);
    for (const PolygonSide& side : sides) {
      EXPECT_LT(side.v0, side.v1);
      EXPECT_EQ(side.angle, Sign::kPositive);
      const Point& p = complex.delaunay().points[side.v0];
      const Point& q = complex.delaunay().points[side.v1];
      EXPECT_EQ(flowcert_tests::squared_distance(exactly(p), exactly(q)), 1) << "a diagonal";
    }
    for (const FacetRef facet : complex.large_polygon(k)) EXPECT_EQ(complex.side(facet), Sign::kPositive);
  }
  EXPECT_EQ(faces_of(complex).facets.size(), 12u);
}

// Each facet is seen from its other cell, and so are its vertices. The cells may be infinite.
TEST(VoronoiComplexTest, FacetsAreKnownFromBothOfTheirCells) {
  CITES("FC-VOR-01");
  for (const Named& input : degenerate_inputs()) {
    const PointSet points(input.rows);
    const Delaunay delaunay(points);
    FilterTally tally;
    const VoronoiComplex complex(compact_copy(delaunay), tally, 2);
    const CompactDelaunay& cells = complex.delaunay();
    for (CellIndex cell = 0; cell < cells.cells.size(); ++cell) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        const FacetRef mirror = complex.mirror({cell, i});
        ASSERT_EQ(mirror, cells.mirror({cell, i})) << input.name;
        ASSERT_EQ(complex.mirror(mirror), (FacetRef{cell, i}));
        const PlacesBeyond places = complex.places_beyond({cell, i});
        EXPECT_EQ(places[i], mirror.index);
        for (std::uint32_t k = 0; k < 4; ++k) {
          if (k == i) continue;
          EXPECT_EQ(cells.vertices(mirror.cell)[places[k]], cells.vertices(cell)[k]) << input.name;
        }
      }
    }
  }
}

// Two cells that share a facet, with their vertices in every order that keeps them positively oriented.
TEST(FacetTurnsTest, KnowAllWaysInWhichTwoCellsMeet) {
  CITES("FC-VOR-01");
  using Cell = std::array<VertexIndex, 4>;
  const auto orders_of = [](const Cell& cell) {
    std::vector<Cell> orders;
    std::array<std::uint32_t, 4> place{0, 1, 2, 3};
    do {
      int swaps = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) swaps += place[i] > place[j] ? 1 : 0;
      }
      if (swaps % 2 == 0) orders.push_back({cell[place[0]], cell[place[1]], cell[place[2]], cell[place[3]]});
    } while (std::next_permutation(place.begin(), place.end()));
    return orders;
  };
  std::set<std::array<std::uint32_t, 3>> met;  // facet, its place in the neighbour, and where its first vertex lies
  for (const Cell& cell : orders_of({0, 1, 2, 3})) {
    for (const Cell& neighbor : orders_of({1, 0, 2, 4})) {
      const std::uint32_t facet = place_among(cell, 3), mirror = place_among(neighbor, 4);
      CompactDelaunay delaunay;
      delaunay.cells = {{cell, {1, 1, 1, 1}}, {neighbor, {2, 2, 2, 2}}, {{5, 6, 7, 8}, {2, 2, 2, 2}}};
      delaunay.cells[1].neighbors[mirror] = 0;
      FacetTurns turns;
      turns.resize(3);
      turns.look(delaunay, 0);
      ASSERT_EQ(turns.mirror({0, facet}), mirror);
      const PlacesBeyond places = turns.places_beyond({0, facet});
      EXPECT_EQ(places[facet], mirror);
      for (std::uint32_t k = 0; k < 4; ++k) {
        EXPECT_EQ(neighbor[places[k]], k == facet ? 4 : cell[k]);
      }
      met.insert({facet, mirror, places[kOutward[facet][0]]});
    }
  }
  EXPECT_EQ(met.size(), 48u);
}

// All pieces of a polygon, from one side, have one sign s; and h at a side is that of any of its points.
TEST(VoronoiComplexTest, SignsAreThoseOfThePolygonNotOfItsPieces) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-VOR-02");
  for (const Named& input : degenerate_inputs()) {
    const PointSet points(input.rows);
    const Delaunay delaunay(points);
    FilterTally tally;
    const VoronoiComplex complex(compact_copy(delaunay), tally);
    const std::vector<Point>& at = complex.delaunay().points;
    for (std::size_t k = 0; k < complex.large_polygon_count(); ++k) {
      const auto polygon = complex.large_polygon(k);
      for (const FacetRef facet : polygon) EXPECT_EQ(complex.side(facet), complex.side(polygon.front())) << input.name;
      const std::set<VertexIndex> corners =
          vertices_of(complex.delaunay(), std::vector<FacetRef>(polygon.begin(), polygon.end()));
      for (const PolygonSide& side : sides_of(complex, polygon)) {
        for (const VertexIndex v : corners) {
          if (v == side.v0 || v == side.v1) continue;
          const RationalPoint q = exactly(at[v]);
          const Rational h = inner(minus(exactly(at[side.v0]), q), minus(exactly(at[side.v1]), q));
          EXPECT_EQ(sign_of(h), side.angle) << input.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace flowcert::voronoi_complex_test
