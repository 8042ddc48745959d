// The groups of recipes about locations, merge trees, pockets, the medial axis, infinity, and statistics. Their inputs
// are small, because the oracle finds pockets by trying, and pairs by the Čech filtration.
#include <utility>

#include "fuzz/inputs/large_configurations.h"
#include "tests/chambers.h"
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

namespace {

// Inputs of many families. Each group takes other ones of them.
void add_drawn(GroupWriter& cases, std::size_t first, int size, std::uint64_t seed) {
  for (const char* family :
       {"general-position",    "lattice-2",      "lattice-3",        "lattice-4",         "duplicates",
        "signed-permutations", "integer-sphere", "box-corners",      "two-circles",       "coplanar-lattice",
        "coplanar-circles",    "collinear",      "right-angle-12",   "right-angle-23",    "right-angle-13",
        "right-angles",        "sphere-scan",    "torus-scan",       "high-degree-facet", "right-angle-chain",
        "through-vertex",      "one-ulp-off",    "far-away-rounded", "extreme-scale",     "two-scales"}) {
    cases.drawn(first++, family, size, {seed});
  }
}

// ---- Locations ----

Group locations() {
  GroupWriter cases("locations", "Where positions flow to, and which samples are nearest to them",
                    "FC-DIST-01 FC-LOC-01");
  cases.asking({.locations = true});
  cases.given(1, "one point: itself, and a position beside it", "", {{0, 0, 0}});
  cases.start_from(positions({"0 0 0", "1/3 0 -1/2"}));
  cases.given(2, "two points: from their cells, from the plane between them, and the middle", "",
              {{0, 0, 0}, {1, 0, 0}});
  cases.start_from(positions({"1/4 0 0", "1/4 1 0", "1/2 1/3 0", "1/2 0 0", "-1 0 0", "1 0 0"}));
  cases.given(3, "two points, one of them twice", "", {{0, 0, 0}, {4, 0, 0}, {0, 0, 0}});
  cases.start_from(positions({"2 0 0", "2 1 0", "0 0 0", "1 0 0"}));
  cases.given(4, "a right triangle: above the middle of the hypotenuse, and on the hypotenuse", "right-angle",
              {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  cases.start_from(positions({"2 2 1", "2 2 0", "1 1 0", "3 1 0", "3 3 0"}));
  cases.given(5, "a regular tetrahedron: inside, on its faces and edges, outside", "", kTetrahedron);
  cases.start_from(positions({"1/8 1/8 1/8", "1/8 1/8 0", "1/3 1/3 0", "1/4 1/4 0", "1/2 1/2 1/2", "2 2 2", "1 1 1"}));
  cases.given(6, "the cube: centre, faces, edges, corners, and outside", "cospherical", grid(2, 2, 2));
  cases.start_from(positions({"1/4 1/4 1/4", "1/2 1/2 1/2", "1/2 1/2 0", "1/2 0 0", "0 0 0", "1/4 1/4 0", "1/2 1/2 -1",
                              "3/4 2/3 1/2", "-1/3 1/2 1/2"}));
  cases.given(7, "kind 1-3: what comes to the middle of an edge", "right-angle", kKind13);
  cases.start_from(positions({"1/2 0 0", "1/3 1/9 1/9", "0 0 0", "1/4 1/4 1/4", "0 0 -1/2"}));
  cases.given(8, "kind 2-3: what comes to the centre of a triangle", "", kKind23);
  cases.start_from(positions({"1 0 1", "0 0 1", "0 0 0", "1 1 -1", "4 0 0"}));
  cases.given(9, "the octahedron next to overflow: positions in its units", "cospherical extreme-scale",
              scaled(sphere(1), 1023));
  std::vector<Point> large = positions({"1/3 1/4 1/5", "0 0 0", "1/2 0 0", "1 0 0"});
  for (Point& x : large) {
    for (Rational& coordinate : x) coordinate *= Rational(0x1p+1023);
  }
  cases.start_from(large);
  constexpr std::size_t kStarts = 6;
  cases.asking({.locations = true, .own_starts = kStarts});
  cases.given(10, "the octahedron and its centre", "right-angle", joined(sphere(1), {{0, 0, 0}}));
  cases.given(11, "two cubes with a common face", "lattice cospherical", grid(2, 2, 3));
  cases.given(12, "the cuboctahedron", "cospherical cocircular", sphere(2));
  cases.given(13, "an orbit from index 2 to index 2", "right-angle", kTieInTheComplex);
  cases.given(14, "a square and a point above its centre", "", kSquareAndPoint);
  add_drawn(cases, 15, 100, 41);
  cases.drawn(40, "long-cascade", 60, {1});
  cases.drawn(41, "half-shell", 60, {1});
  return cases.group();
}

// ---- Merge trees and pockets ----

Rows without(Rows rows, std::size_t row) {
  rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(row));
  return rows;
}
Rows stretched(Rows rows, double x, double y, double z) {
  for (Row& row : rows) row = {row[0] * x, row[1] * y, row[2] * z};
  return rows;
}
Rows box(double x, double y, double z) { return stretched(grid(2, 2, 2), x, y, z); }

// Over a triangle, each of the height 50, closed at both ends by a point on the sphere of the last one.
Rows prisms(int count) {
  Rows rows = {{-40, 0, 0}, {count * 50 + 40.0, 0, 0}};
  for (int k = 0; k <= count; ++k) {
    for (const auto& [y, z] : {std::pair(60, 0), std::pair(-36, 48), std::pair(-36, -48)}) {
      rows.push_back({k * 50.0, static_cast<double>(y), static_cast<double>(z)});
    }
  }
  return rows;
}

// Found among small integer points: at some persistence pockets merge, or one stays apart.
const Rows kMergedAndApart = {{1, -1, -1}, {-1, 0, 0}, {1, -1, 1}, {0, 0, -1}, {1, 1, 0}, {1, 0, 1}, {-1, -1, 0}};
const Rows kMerged = {{1, 1, -2}, {-2, 1, 1}, {1, 0, 1},  {0, 1, 1},  {-2, 0, 1},
                      {2, -1, 0}, {2, 2, 0},  {0, -1, 2}, {-1, -1, 0}};
const Rows kMergedMore = {{-1, 2, 2},   {-2, 0, 0}, {0, 2, 1},  {2, 2, 2},  {-1, 1, -2}, {1, 2, -2},
                          {-2, -1, -1}, {1, 1, 2},  {1, -2, 0}, {1, -2, 2}, {2, 0, 0},   {0, -2, 1}};
const Rows kApart = {{-1, 1, -1}, {1, 0, -1}, {0, 1, 1},   {-1, 0, 1},  {0, 0, -1},
                     {1, -1, 0},  {1, 0, 1},  {1, -1, -1}, {-1, 0, -1}, {0, -1, 1}};
const Rows kApartToo = {{1, -1, 1}, {0, 1, 1},   {0, -1, 1},  {0, 1, -1}, {1, 0, 0},
                        {0, 1, 0},  {-1, -1, 0}, {-1, -1, 1}, {-1, 1, 1}};

// Adds the points, and the points times a power of two.
void add_scaled(GroupWriter& cases, std::size_t first, const std::string& comment, const char* aims, const Rows& points,
                int exponent) {
  cases.given(first, comment, aims, points);
  cases.given(first + 1, comment + ", times 2^" + std::to_string(exponent),
              (std::string(aims) + " scaled-copy").c_str(), scaled(points, exponent));
}

// Hollow shapes, whole and with holes; several maxima.
void add_hollow(GroupWriter& cases) {
  add_scaled(cases, 39, "a box whose faces are three different gates", "cospherical cocircular", box(4, 6, 7), 3);
  add_scaled(cases, 41, "two flat boxes with a wide mouth between them: they merge, and both are peaks", "cospherical",
             joined(stretched(grid(3, 2, 2), 1, 2, 2), {{-1, 1, 1}, {3, 1, 1}}), -5);
  add_scaled(cases, 43, "9 points of which two pockets merge", "lattice", kMerged, 40);
  cases.given(45, "a long box and one point within", "cocircular", joined(box(4, 5, 12), {{2, 2, 5}}));
  cases.given(46, "three cubes in a row: the one in the middle is left through four faces", "lattice cospherical",
              grid(2, 2, 4));
  cases.given(47, "two prisms with a wide mouth between them", "cospherical", prisms(2));
  cases.given(48, "three such prisms in a row: three peaks", "cospherical", prisms(3));
  cases.given(49, "two flat boxes, one of them flatter", "cospherical cocircular",
              {{0, 0, 0},
               {0, 0, 6},
               {0, 6, 0},
               {0, 6, 6},
               {2, 0, 0},
               {2, 0, 6},
               {2, 6, 0},
               {2, 6, 6},
               {5, 0, 0},
               {5, 0, 6},
               {5, 6, 0},
               {5, 6, 6}});
  cases.given(50, "the octahedron without a corner", "", without(sphere(1), 0));
  cases.given(51, "the cube without a corner", "cospherical", without(grid(2, 2, 2), 7));
  cases.given(52, "the cuboctahedron without a corner", "cospherical", without(sphere(2), 3));
  cases.given(53, "the cuboctahedron without two opposite corners", "cospherical", without(without(sphere(2), 11), 0));
  cases.given(54, "an octahedron around a smaller one", "cospherical", joined(sphere(1), scaled(sphere(1), 2)));
  cases.given(55, "7 points, of which a pocket stays apart", "lattice", kMergedAndApart);
  cases.given(56, "10 points, of which a pocket stays apart", "lattice", kApart);
  cases.given(57, "9 points, of which a pocket stays apart", "lattice", kApartToo);
  cases.given(58, "12 points, of which pockets merge", "lattice", kMergedMore);
  std::size_t next = 59;
  for (const std::uint64_t seed : {1U, 4U, 72U}) {
    cases.given(next++, "chambers in a row, with mouths of few different widths (seed " + std::to_string(seed) + ")",
                "cocircular", flowcert::fuzz::chambers(seed));
  }
  for (const std::uint64_t seed : {1U, 2U}) {
    cases.given(next++, "a cell of the face-centred lattice without a corner (seed " + std::to_string(seed) + ")",
                "lattice cospherical", flowcert::fuzz::face_centred_cell(seed));
  }
}

Group merge_trees() {
  GroupWriter cases("merge-trees", "How pockets and components join, and the pairs that follow from that",
                    "FC-TREE-02 FC-TREE-05 FC-TREE-06 FC-TREE-07");
  cases.asking({.trees = true});
  add_named_cases(cases);
  cases.asking({.persistence = true, .trees = true});
  add_hollow(cases);
  add_drawn(cases, 64, 100, 42);
  return cases.group();
}

Group pockets() {
  GroupWriter cases("pockets", "Maxima merged by persistence, what leads out of them, and what passes", "FC-POCK-02");
  cases.asking({.pockets = true});
  add_named_shapes(cases);
  cases.given(27, "the octahedron of subnormals", "cospherical extreme-scale", scaled(sphere(1), -1074));
  cases.given(28, "the octahedron next to overflow", "cospherical extreme-scale", scaled(sphere(1), 1023));
  add_named_triples(cases);
  add_hollow(cases);
  std::size_t next = 64;
  for (const char* family :
       {"general-position", "lattice-3", "lattice-4", "duplicates", "integer-sphere", "box-corners", "coplanar-circles",
        "right-angle-23", "right-angle-13", "torus-scan", "right-angle-chain", "through-vertex"}) {
    cases.drawn(next++, family, 60, {43});
  }
  return cases.group();
}

// ---- The medial axis, infinity, statistics ----

Group medial_axes() {
  GroupWriter cases("medial-axes", "Which critical points are above an angle, and how many above a persistence",
                    "FC-MED-01 FC-MED-02");
  cases.asking({.medial = true});
  add_named_cases(cases);
  cases.given(39, "an equilateral triangle: 120 degrees", "", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  cases.given(40, "a right prism over it", "cospherical",
              {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}});
  cases.given(41, "16 points of a circle: an angle of 180 degrees", "cocircular", circle(65, 0));
  cases.given(42, "a triangle whose angle is above 135 degrees, and not above 150", "",
              {{0, 0, 0}, {6, 0, 0}, {2, 4, 0}});
  cases.given(43, "two such triangles", "", {{0, 0, 0}, {6, 0, 0}, {2, 4, 0}, {0, 0, 9}, {6, 0, 9}});
  add_drawn(cases, 44, 60, 44);
  return cases.group();
}

Group infinity() {
  GroupWriter cases("infinity", "The skeleton of what flows to infinity", "FC-STAB-08");
  cases.asking({.infinity = true});
  add_named_shapes(cases);
  add_named_triples(cases);
  add_drawn(cases, 39, 30, 45);
  return cases.group();
}

Rows cascade(std::size_t points, std::uint64_t seed) { return flowcert::fuzz::long_cascade(points, seed).rows; }

Group statistics() {
  GroupWriter cases("statistics", "Segments of orbits of U2, of connecting orbits, and of cascades", "FC-STAT-01");
  cases.asking({.statistics = true});
  add_named_cases(cases);
  add_drawn(cases, 39, 100, 46);
  cases.drawn(64, "long-cascade", 100, {31, 32, 33});
  cases.drawn(67, "half-shell", 100, {31, 32});
  cases.given(69, "20 teeth of two combs", "cascade", cascade(20, 21));
  return cases.group();
}

}  // namespace

void add_landscape_groups(std::vector<Group>& table) {
  table.push_back(locations());
  table.push_back(merge_trees());
  table.push_back(pockets());
  table.push_back(medial_axes());
  table.push_back(infinity());
  table.push_back(statistics());
}

}  // namespace oracle::vectors
