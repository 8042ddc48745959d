// The table of recipes, second part: the groups that are about the flow.
#include "fuzz/inputs/large_configurations.h"
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

namespace {

Rows cascade(std::size_t points, std::uint64_t seed) {
  return flowcert::fuzz::long_cascade(points, seed).rows;
}
Rows shell(std::size_t points, std::uint64_t seed) { return flowcert::fuzz::half_shell(points, seed).rows; }
Rows facet(std::size_t degree, bool perturbed, std::uint64_t seed) {
  return flowcert::fuzz::high_degree_facet(degree, perturbed, seed).rows;
}

Group unstable_manifolds() {
  GroupWriter cases("unstable-manifolds", "Where the two orbits of U2 of each critical point of index 2 end",
                    "FC-CRIT-02 FC-FLOW-05 FC-FLOW-07 FC-FLOW-08");
  cases.with_limits();
  cases.given(1, "an acute triangle: both orbits go to infinity", "", {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}});
  cases.given(2, "a regular tetrahedron", "", {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}});
  cases.given(3, "two cubes with a common face", "lattice cospherical", grid(2, 2, 3));
  cases.given(4, "the octahedron", "cospherical", sphere(1));
  cases.given(5, "four points with a maximum of kind 2-3", "",
              {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}});
  cases.given(6, "a square and a point above its centre", "",
              {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}});
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
  return cases.group();
}

// The orbits that tests/unit works out by hand, and others of which a line says where they go.
void add_orbits_by_hand(GroupWriter& cases) {
  const Rows tetrahedron = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  cases.given(1, "one point: its orbits go to infinity, or stay", "", {{0, 0, 0}});
  cases.start_from(positions({"0 0 0", "1/3 0 -1/2"}));
  cases.given(2, "two points: from a cell, from the facet, from the saddle", "", {{0, 0, 0}, {1, 0, 0}});
  cases.start_from(positions({"1/4 0 0", "1/4 1 0", "1/2 1/3 0", "1/2 0 0", "-1 0 0"}));
  cases.given(3, "a regular tetrahedron: straight to the maximum, and onto facet, edge and vertex", "",
              tetrahedron);
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
  cases.given(7, "a square and a point above its centre", "",
              {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}});
  cases.start_from(positions({"1/2 1/4 1/2", "1 1 1/2", "1 1 -1", "1 1/2 1"}));
  cases.given(8, "the cube: centre, faces, edges, corners, and outside", "cospherical", grid(2, 2, 2));
  cases.start_from(positions({"1/2 1/2 1/2", "1/2 1/2 0", "1/2 0 0", "0 0 0", "1/2 1/2 1/8", "1/2 1/2 -1",
                              "1/4 1/4 1/4", "1/4 1/8 1/16"}));
  cases.given(9, "points of a line: cells, planes between them, and the ends", "",
              {{0, 0, 0}, {1, 1, 1}, {4, 4, 4}});
  cases.start_from(positions({"1/2 1/2 1/2", "1 0 1/2", "2 1 0", "3 3 3", "-1 0 0"}));
  cases.given(10, "the octahedron and its centre", "right-angle", joined(sphere(1), {{0, 0, 0}}));
  cases.start_from(positions({"1/8 1/8 1/8", "1/2 1/2 1/2", "1/2 1/2 0", "1/2 1/3 0", "1/4 0 0"}));
  std::vector<Point> starts = positions({"0 0 0", "1/3 1/4 0", "1 0 0"});
  for (Rational& coordinate : starts[1]) coordinate *= Rational(0x1p-1074);
  cases.given(11, "subnormals: the start is given in their units", "extreme-scale",
              scaled(grid(2, 2, 1), -1074));
  cases.start_from(starts);
}

Group orbits() {
  GroupWriter cases("orbits", "Orbits from given starts, segment by segment",
                    "FC-FLOW-01 FC-FLOW-02 FC-FLOW-05");
  add_orbits_by_hand(cases);
  constexpr std::size_t kStarts = 7;
  cases.with_own_starts(kStarts);
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
  return cases.group();
}

}  // namespace

void add_orbit_groups(std::vector<Group>& table) {
  table.push_back(unstable_manifolds());
  table.push_back(orbits());
}

}  // namespace oracle::vectors
