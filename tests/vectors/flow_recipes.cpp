// The groups of recipes about the flow, stable manifolds, and persistence. Their inputs are small: at most 12 points
// where skeletons are told, which are long, or where the Čech filtration is built, with n^4 / 24 simplices.
#include "fuzz/inputs/large_configurations.h"
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

// ---- Stable manifolds and persistence ----

namespace {

const Rows kKite = {{0, 0, 0}, {25, 0, 0}, {9, 12, 0}, {9, -12, 0}};
// A path of FC-CHAIN-02 goes on from one Voronoi vertex to the next.
const Rows kThroughTwoVertices = {{-1, 2, 1}, {2, 2, -1}, {0, -1, 0}, {-1, 0, 1}, {2, 0, 0}, {-1, 0, 0}};
const Rows kThroughTwoMore = {{-2, -2, 1}, {-3, 0, 1}, {-1, 2, 2}, {-2, -1, 2}, {1, 2, -1}, {-1, -2, 2}, {0, -3, 0}};

// Points outside of a sphere cut the Voronoi facets into which sectors of its centre reach.
const Rows kCutSector = {{2, -1, -2}, {2, 0, -2}, {2, -2, 2}, {-1, 1, -1}, {-2, 1, -2}, {1, 2, 0}, {-2, -2, 2}};
const Rows kCrowded = {{20, -1, -3},  {-16, 11, -3}, {-16, -13, -3}, {12, -1, 13},
                       {-9, -9, -23}, {6, -24, 1},   {-1, -12, -24}, {15, -13, -13}};
const Rows kCrowdedToo = {{22, 4, 5},   {-10, 20, 5}, {-10, -12, 5},  {2, 4, 25},
                          {5, -20, -1}, {9, -4, 22},  {-11, 11, -12}, {12, 23, 17}};

// The cases that both groups begin with.
void add_by_hand(GroupWriter& cases) {
  add_first_cases(cases);
  cases.given(9, "a kite with two right angles", "cocircular right-angle", kKite);
  cases.given(10, "a regular tetrahedron", "", kTetrahedron);
  cases.given(11, "the centre of a sphere inside one of four triangles: kind 2-3", "", kKind23);
  cases.given(12, "an edge through the centre of a sphere: kind 1-3", "right-angle", kKind13);
  cases.given(13, "a square and a point above its centre", "", kSquareAndPoint);
  cases.given(14, "the faces of a cospherical cluster, to be merged", "cospherical right-angle", kUnmergedFaces);
  cases.given(15, "a pyramid over a pentagon of a circle", "cocircular", kPentagonPyramid);
  cases.given(16, "a prism over a triangle", "cospherical cocircular", kPrism);
  cases.given(17, "the octahedron", "cospherical", sphere(1));
  cases.given(18, "the octahedron and its centre", "right-angle", joined(sphere(1), {{0, 0, 0}}));
  cases.given(19, "the cube", "cospherical cocircular", grid(2, 2, 2));
  cases.given(20, "two cubes with a common face", "lattice cospherical", grid(2, 2, 3));
  cases.given(21, "the cuboctahedron", "cospherical cocircular", sphere(2));
  cases.given(22, "half of the cuboctahedron: a square through the centre of the sphere", "cospherical",
              first_of(sphere(2), 8));
  cases.given(23, "ties whose choices need not suit each other", "right-angle", kTieInTheComplex);
  cases.given(24, "a tie at a Voronoi vertex that goes on at another one", "right-angle", kThroughTwoVertices);
  cases.given(25, "another such tie", "right-angle", kThroughTwoMore);
  cases.given(26, "a square of 9 points", "lattice cocircular", grid(3, 3, 1));
  cases.given(27, "8 points in general position", "general-position", general(8, 21));
  cases.given(28, "11 points in general position", "general-position", general(11, 22));
}

Group stable_manifolds() {
  GroupWriter cases("stable-manifolds",
                    "What flows to each critical point of index 2 and each regular stationary point",
                    "FC-CHAIN-01 FC-STAB-01 FC-STAB-02 FC-STAB-04 FC-STAB-07 FC-STAB-11");
  cases.asking({.stable = true});
  add_by_hand(cases);
  cases.drawn(29, "general-position", 100, {3, 6});
  cases.drawn(31, "lattice-3", 100, {1, 2, 4, 5});
  cases.drawn(35, "lattice-4", 100, {4, 6, 7});
  cases.drawn(38, "duplicates", 100, {2, 4});
  cases.drawn(40, "signed-permutations", 100, {2, 3, 8});
  cases.drawn(43, "integer-sphere", 100, {4, 5});
  cases.drawn(45, "sphere-and-others", 100, {1, 6});
  cases.drawn(47, "box-corners", 100, {2, 4, 8});
  cases.drawn(50, "two-circles", 100, {5, 6});
  cases.drawn(52, "coplanar-lattice", 100, {2, 8});
  cases.drawn(54, "coplanar-circles", 100, {8, 9});
  cases.drawn(56, "right-angle-12", 100, {3, 7, 8});
  cases.drawn(59, "right-angle-23", 100, {1, 2, 5, 7});
  cases.drawn(63, "right-angle-13", 100, {1, 3, 5, 6});
  cases.drawn(67, "right-angles", 100, {2, 3, 7, 8, 9});
  cases.drawn(72, "sphere-scan", 100, {3, 4});
  cases.drawn(74, "torus-scan", 100, {4, 8});
  cases.drawn(76, "sheet-scan", 100, {4});
  cases.drawn(77, "long-cascade", 100, {1, 4});
  cases.drawn(79, "half-shell", 100, {2, 6});
  cases.drawn(81, "high-degree-facet", 100, {3, 4});
  cases.drawn(83, "right-angle-chain", 100, {2, 4, 7});
  cases.drawn(86, "through-vertex", 100, {3, 4});
  cases.drawn(88, "rounded-sphere", 100, {3, 5});
  cases.drawn(90, "rounded-rotation", 100, {1, 6});
  cases.drawn(92, "one-ulp-off", 100, {1, 5, 6});
  cases.drawn(95, "far-away", 100, {9});
  cases.drawn(96, "far-away-rounded", 100, {1, 9});
  cases.drawn(98, "extreme-scale", 100, {2, 3});
  cases.drawn(100, "two-scales", 100, {4, 5});
  cases.drawn(102, "mixed-magnitudes", 100, {7});
  cases.given(103, "a sector that is cut off by a point beside it", "lattice", kCutSector);
  cases.given(104, "four points around a centre, and two that cut off sectors", "", first_of(kCrowded, 6));
  cases.given(105, "the same with two points more", "", kCrowded);
  cases.given(106, "four points around a centre, and four others that cut off sectors", "", kCrowdedToo);
  return cases.group();
}

Group persistence() {
  GroupWriter cases("persistence", "The persistence pairs of the squared distance function",
                    "FC-PERS-01 FC-PERS-02 FC-PERS-03 FC-PERS-05");
  cases.asking({.persistence = true});
  add_by_hand(cases);
  cases.given(29, "two pairs of points, far from each other, and one pair again", "",
              {{0, 0, 0}, {1, 0, 0}, {0, 0, 100}, {1, 0, 100}, {0, 0, 0}, {1, 0, 0}});
  cases.given(30, "a circle of 12 points", "cocircular", circle(25, 0));
  cases.given(31, "two squares, each around a corner of the other", "cocircular",
              joined({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{1, 0, -1}, {3, 0, -1}, {3, 0, 1}, {1, 0, 1}}));
  cases.given(32, "two tetrahedra, one a thousand times as large", "",
              joined(scaled(kTetrahedron, 10), shifted(kTetrahedron, {300, 200, 100})));
  cases.threefold(33, "a rectangle", {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {3, 4, 0}}, 3, 1);
  cases.threefold(36, "a right triangle, upright", {{0, 0, 0}, {0, 3, 0}, {0, 0, 4}}, 0, 1);
  cases.threefold(39, "a regular stationary point of kind 1-3", scaled(kKind13, 1), 2, 1);
  cases.threefold(42, "a regular stationary point of kind 2-3", scaled(kKind23, 1), 0, 0);
  cases.drawn(45, "general-position", 100, {1, 3, 4});
  cases.drawn(48, "lattice-2", 100, {5, 9});
  cases.drawn(50, "lattice-3", 100, {1, 2, 7});
  cases.drawn(53, "lattice-4", 100, {4, 6, 7});
  cases.drawn(56, "duplicates", 100, {2, 4});
  cases.drawn(58, "signed-permutations", 100, {3, 8});
  cases.drawn(60, "integer-sphere", 100, {3, 4});
  cases.drawn(62, "sphere-and-others", 100, {1, 3});
  cases.drawn(64, "box-corners", 100, {1, 2, 8});
  cases.drawn(67, "two-circles", 100, {2, 6});
  cases.drawn(69, "coplanar-lattice", 100, {4, 8});
  cases.drawn(71, "coplanar-circles", 100, {8, 9});
  cases.drawn(73, "collinear", 100, {5});
  cases.drawn(74, "right-angle-12", 100, {5, 7});
  cases.drawn(76, "right-angle-23", 100, {2, 5, 7});
  cases.drawn(79, "right-angle-13", 100, {1, 5, 6});
  cases.drawn(82, "right-angles", 100, {7, 8, 9});
  cases.drawn(85, "sphere-scan", 100, {3, 4});
  cases.drawn(87, "torus-scan", 100, {3, 4});
  cases.drawn(89, "long-cascade", 100, {9});
  cases.drawn(90, "high-degree-facet", 100, {1, 9});
  cases.drawn(92, "right-angle-chain", 100, {2, 4});
  cases.drawn(94, "through-vertex", 100, {2, 4});
  cases.drawn(96, "rounded-sphere", 100, {1, 6});
  cases.drawn(98, "one-ulp-off", 100, {5, 9});
  cases.drawn(100, "far-away-rounded", 100, {5, 9});
  // Here no squared distance is beyond the doubles, since a .pers file could not say it.
  cases.drawn(102, "extreme-scale", 100, {2, 3});
  cases.drawn(104, "two-scales", 100, {2, 5});
  cases.given(106, "a regular tetrahedron at 2^-200, another at 2^200", "extreme-scale",
              joined(scaled(kTetrahedron, -200), shifted(scaled(kTetrahedron, 200), {0x1p+202, 0, 0})));
  cases.given(107, "kind 2-3 at 2^500", "extreme-scale", scaled(kKind23, 500));
  return cases.group();
}

}  // namespace

void add_homology_groups(std::vector<Group>& table) {
  table.push_back(stable_manifolds());
  table.push_back(persistence());
}

// ---- The flow ----

namespace {

Rows cascade(std::size_t points, std::uint64_t seed) { return flowcert::fuzz::long_cascade(points, seed).rows; }
Rows shell(std::size_t points, std::uint64_t seed) { return flowcert::fuzz::half_shell(points, seed).rows; }
Rows facet(std::size_t degree, bool perturbed, std::uint64_t seed) {
  return flowcert::fuzz::high_degree_facet(degree, perturbed, seed).rows;
}

Group unstable_manifolds() {
  GroupWriter cases("unstable-manifolds", "Where the two orbits of U2 of each critical point of index 2 end",
                    "FC-CRIT-02 FC-FLOW-05 FC-FLOW-07 FC-FLOW-08");
  cases.asking({.limits = true});
  cases.given(1, "an acute triangle: both orbits go to infinity", "", kAcuteTriangle);
  cases.given(2, "a regular tetrahedron", "", kTetrahedron);
  cases.given(3, "two cubes with a common face", "lattice cospherical", grid(2, 2, 3));
  cases.given(4, "the octahedron", "cospherical", sphere(1));
  cases.given(5, "four points with a maximum of kind 2-3", "", kKind23);
  cases.given(6, "a square and a point above its centre", "", kSquareAndPoint);
  cases.drawn(7, "general-position", 100, seeds(4));
  cases.drawn(11, "lattice-3", 100, seeds(4));
  cases.drawn(15, "box-corners", 100, seeds(3));
  cases.drawn(18, "right-angle-23", 100, seeds(3));
  cases.drawn(21, "right-angle-13", 100, seeds(3));
  cases.drawn(24, "coplanar-circles", 100, seeds(3));
  cases.drawn(27, "long-cascade", 100, seeds(6));
  cases.drawn(33, "half-shell", 100, seeds(6));
  cases.drawn(39, "high-degree-facet", 100, seeds(5));
  cases.drawn(44, "right-angle-chain", 100, seeds(6));
  cases.drawn(50, "through-vertex", 100, seeds(6));
  cases.drawn(56, "one-ulp-off", 100, seeds(4));
  cases.drawn(60, "duplicates", 100, seeds(2));
  cases.drawn(62, "extreme-scale", 100, {11, 12});
  cases.given(64, "20 teeth of two combs", "cascade", cascade(20, 1));
  cases.given(65, "40 teeth of two combs", "cascade", cascade(40, 2));
  cases.given(66, "60 teeth of two combs", "cascade", cascade(60, 3));
  cases.given(67, "an open paraboloid of 40 points", "scan half-shell", shell(40, 1));
  cases.given(68, "an open paraboloid of 60 points", "scan half-shell", shell(60, 2));
  cases.given(69, "a facet of 24 sides", "high-degree-facet cocircular", facet(24, false, 1));
  cases.given(70, "a facet of 40 sides, perturbed", "high-degree-facet", facet(40, true, 2));
  cases.given(71, "the lattice {0..2}^3", "lattice cospherical", grid(3, 3, 3));
  cases.given(72, "40 points of {0..6}^3", "lattice", scattered(40, 7, 21));
  cases.mirrored(73, "8 points in general position", "general-position", general(8, 31));
  cases.mirrored(76, "9 points of {0..3}^3", "lattice", scattered(9, 4, 32));
  cases.mirrored(79, "a square and a point above its centre", "", scaled(kSquareAndPoint, 1));
  cases.mirrored(82, "12 points of {0..2}^3", "lattice", scattered(12, 3, 33));
  return cases.group();
}

// Adds the orbits that tests/unit works out by hand, and others whose comment says where they go.
void add_orbits_by_hand(GroupWriter& cases) {
  cases.given(1, "one point: its orbits go to infinity, or stay", "", {{0, 0, 0}});
  cases.start_from(positions({"0 0 0", "1/3 0 -1/2"}));
  cases.given(2, "two points: from a cell, from the facet, from the saddle", "", {{0, 0, 0}, {1, 0, 0}});
  cases.start_from(positions({"1/4 0 0", "1/4 1 0", "1/2 1/3 0", "1/2 0 0", "-1 0 0"}));
  cases.given(3, "a regular tetrahedron: straight to the maximum, and onto facet, edge and vertex", "", kTetrahedron);
  cases.start_from(positions({"1/8 1/8 1/8", "1/8 1/8 0", "1/3 1/4 1/8", "1/2 1/2 1/2"}));
  cases.given(4, "a right triangle: along the line over the middle of the hypotenuse", "right-angle",
              {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  cases.start_from(positions({"1 1/2 1", "2 2 1", "2 2 0", "1 1 0", "3 3 0"}));
  cases.given(5, "an obtuse triangle: from its line of centres across the facet of the long side", "",
              {{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  cases.start_from(positions({"0 -3/2 1", "0 -3/2 0", "0 -2 0", "1/9 0 0"}));
  cases.given(6, "a boundary degenerate flow: a right angle sends it along the edge", "right-angle",
              {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}});
  cases.start_from(positions({"0 0 1", "0 0 1/2", "0 0 0", "0 0 4/3"}));
  cases.given(7, "a square and a point above its centre", "", kSquareAndPoint);
  cases.start_from(positions({"1/2 1/4 1/2", "1 1 1/2", "1 1 -1", "1 1/2 1"}));
  cases.given(8, "the cube: centre, faces, edges, corners, and outside", "cospherical", grid(2, 2, 2));
  cases.start_from(positions(
      {"1/2 1/2 1/2", "1/2 1/2 0", "1/2 0 0", "0 0 0", "1/2 1/2 1/8", "1/2 1/2 -1", "1/4 1/4 1/4", "1/4 1/8 1/16"}));
  cases.given(9, "points of a line: cells, planes between them, and the ends", "", {{0, 0, 0}, {1, 1, 1}, {4, 4, 4}});
  cases.start_from(positions({"1/2 1/2 1/2", "1 0 1/2", "2 1 0", "3 3 3", "-1 0 0"}));
  cases.given(10, "the octahedron and its centre", "right-angle", joined(sphere(1), {{0, 0, 0}}));
  cases.start_from(positions({"1/8 1/8 1/8", "1/2 1/2 1/2", "1/2 1/2 0", "1/2 1/3 0", "1/4 0 0"}));
  std::vector<Point> starts = positions({"0 0 0", "1/3 1/4 0", "1 0 0"});
  for (Rational& coordinate : starts[1]) coordinate *= Rational(0x1p-1074);
  cases.given(11, "subnormals: the start is given in their units", "extreme-scale", scaled(grid(2, 2, 1), -1074));
  cases.start_from(starts);
}

Group orbits() {
  GroupWriter cases("orbits", "Orbits from given starts, segment by segment",
                    "FC-DIST-01 FC-DIST-02 FC-FLOW-01 FC-FLOW-02 FC-FLOW-05");
  add_orbits_by_hand(cases);
  constexpr std::size_t kStarts = 7;
  cases.asking({.own_starts = kStarts});
  cases.drawn(12, "general-position", 40, seeds(3));
  cases.drawn(15, "lattice-2", 100, seeds(3));
  cases.drawn(18, "lattice-3", 100, seeds(4));
  cases.drawn(22, "lattice-4", 100, seeds(3));
  cases.drawn(25, "few-points", 0, {13, 17, 18, 36});
  cases.drawn(29, "duplicates", 100, {21, 22});
  cases.drawn(31, "integer-sphere", 100, {21, 22});
  cases.drawn(33, "box-corners", 100, {21, 22, 23});
  cases.drawn(36, "two-circles", 100, {21, 22});
  cases.drawn(38, "right-angle-12", 100, {21, 22, 23});
  cases.drawn(41, "right-angle-23", 100, {21, 22, 23});
  cases.drawn(44, "right-angle-13", 100, {21, 22, 23});
  cases.drawn(47, "coplanar-lattice", 100, {21, 22, 23});
  cases.drawn(50, "coplanar-circles", 100, {21, 22});
  cases.drawn(52, "collinear", 100, {21, 22});
  cases.drawn(54, "sheet-scan", 100, {21, 22});
  cases.drawn(56, "long-cascade", 100, {21, 22, 23, 24, 25});
  cases.drawn(61, "half-shell", 100, {21, 22, 23, 24});
  cases.drawn(65, "high-degree-facet", 100, {21, 22, 23, 24});
  cases.drawn(69, "right-angle-chain", 100, {21, 22, 23, 24, 25, 26});
  cases.drawn(75, "through-vertex", 100, {21, 22, 23, 24, 25, 26});
  cases.drawn(81, "one-ulp-off", 100, {21, 22, 23});
  cases.drawn(84, "rounded-rotation", 40, {21, 22});
  cases.drawn(86, "far-away", 100, {21, 22});
  cases.drawn(88, "extreme-scale", 100, {21, 22});
  cases.drawn(90, "two-scales", 40, {21});
  cases.given(91, "24 teeth of two combs", "cascade", cascade(24, 11));
  cases.given(92, "60 teeth of two combs", "cascade", cascade(60, 12));
  cases.given(93, "an open paraboloid of 40 points", "scan half-shell", shell(40, 11));
  cases.given(94, "a facet of 16 sides", "high-degree-facet cocircular", facet(16, false, 11));
  cases.given(95, "24 points of one sphere", "cospherical cocircular", sphere(5));
  cases.given(96, "the lattice {0..2}^3", "lattice cospherical", grid(3, 3, 3));
  cases.given(97, "a triangle, straight up from inside a half plane: no sign tells where its boundary is left", "",
              {{0, 0, 0}, {4, 0, 0}, {2, 3, 0}});
  cases.start_from(positions({"2 0 1", "2 0 -1/3"}));
  cases.given(98, "a right triangle, straight up from its line of centres", "right-angle",
              {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  cases.start_from(positions({"3/2 2 1", "3/2 2 -7"}));
  cases.asking({});
  cases.given(99, "a tetrahedron: from several points of one way", "", scaled(kTetrahedron, 1));
  cases.start_from(positions({"1/4 1/4 1/4", "1/2 1/2 1/2", "4/5 4/5 4/5", "2/3 1/2 1/4"}));
  cases.given(100, "a square: from several points of one way in a facet, and of one that leads to infinity",
              "cocircular", grid(2, 2, 1));
  cases.start_from(positions({"1/2 1/8 0", "1/2 1/4 0", "1/2 1/3 0", "1/2 -1 0", "1/2 -2 0", "-3 1/2 0"}));
  cases.given(101, "an acute triangle: from several points above its centre", "", {{0, 0, 0}, {4, 0, 0}, {2, 4, 0}});
  cases.start_from(positions({"2 3/2 1", "2 3/2 2", "2 3/2 9", "2 1/4 0", "2 1/2 0"}));
  return cases.group();
}

}  // namespace

void add_orbit_groups(std::vector<Group>& table) {
  table.push_back(unstable_manifolds());
  table.push_back(orbits());
}

}  // namespace oracle::vectors
