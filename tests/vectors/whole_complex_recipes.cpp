// The groups of recipes about the whole complex: λ-lists, connections, volumes of stable sets, and unstable sets. Their
// inputs are small, because the oracle follows each ray by scans over all points, and exact ends of rays have many
// digits.
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

namespace {

const Rows kHalfOctahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
// Two regular stationary points of kind 1-3, each with the volume 1/6.
const Rows kChain = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}};
// Two orbits from {0,1} to {4,5,6} meet before they come there.
const Rows kTwoOrbits = {{0, 0, 0}, {-10, 0, 0}, {-11, 30, 0}, {-11, -30, 0}, {69, 90, 0}, {69, -90, 0}, {300, 0, 0}};

}  // namespace

void add_named_shapes(GroupWriter& cases) {
  add_first_cases(cases);
  cases.given(9, "a square of 9 points", "lattice cocircular", grid(3, 3, 1));
  cases.given(10, "a regular tetrahedron", "", kTetrahedron);
  cases.given(11, "a tetrahedron without a maximum: its circumcentre is outside", "",
              {{0, 0, 0}, {6, 0, 0}, {2, 5, 0}, {2, 2, 1}});
  cases.given(12, "the cube", "cospherical cocircular", grid(2, 2, 2));
  cases.given(13, "the octahedron", "cospherical", sphere(1));
  cases.given(14, "a square pyramid whose apex is as high as 3/2 of an edge", "", kSquareAndPoint);
  cases.given(15, "half of the octahedron: kind 2-3", "cospherical", kHalfOctahedron);
  cases.given(16, "a chain of unit steps: two tetrahedra of volume 1/6, both of kind 1-3", "right-angle", kChain);
  cases.given(17, "an orbit from index 2 to index 2, whose stable set has dimension 3", "right-angle",
              kTieInTheComplex);
  cases.given(18, "two orbits from one point to another that meet on their way", "", kTwoOrbits);
  cases.given(19, "the centre of a sphere inside one of four triangles: kind 2-3", "", kKind23);
  cases.given(20, "an edge through the centre of a sphere: kind 1-3", "right-angle", kKind13);
  cases.given(21, "the octahedron and its centre", "right-angle", joined(sphere(1), {{0, 0, 0}}));
  cases.given(22, "two cubes with a common face", "lattice cospherical", grid(2, 2, 3));
  cases.given(23, "the cuboctahedron", "cospherical cocircular", sphere(2));
  cases.given(24, "a pyramid over a pentagon of a circle", "cocircular", kPentagonPyramid);
  cases.given(25, "a prism over a triangle", "cospherical cocircular", kPrism);
  cases.given(26, "two tetrahedra, one a thousand times as large", "",
              joined(scaled(kTetrahedron, 10), shifted(kTetrahedron, {300, 200, 100})));
}

void add_named_extremes(GroupWriter& cases) {
  cases.given(27, "the octahedron of subnormals", "cospherical extreme-scale", scaled(sphere(1), -1074));
  cases.given(28, "the octahedron next to overflow", "cospherical extreme-scale", scaled(sphere(1), 1023));
  cases.given(29, "a regular tetrahedron at 2^-200, another at 2^200", "extreme-scale",
              joined(scaled(kTetrahedron, -200), shifted(scaled(kTetrahedron, 200), {0x1p+202, 0, 0})));
}

void add_named_triples(GroupWriter& cases) {
  cases.threefold(30, "a right triangle, upright", {{0, 0, 0}, {0, 3, 0}, {0, 0, 4}}, 0, 1);
  cases.threefold(33, "half of the octahedron", scaled(kHalfOctahedron, 1), 4, 2);
  cases.threefold(36, "a cube of edge 2", scaled(grid(2, 2, 2), 1), 7, 2);
}

void add_named_cases(GroupWriter& cases) {
  add_named_shapes(cases);
  add_named_extremes(cases);
  add_named_triples(cases);
}

namespace {

// In each, an orbit of U2 of the first triangle ends at another index-2 point, whose stable set has dimension 3.
const Rows kSaddleToSaddle[] = {
    {{0, 4, 1}, {10, 4, 1}, {5, 12, 1}, {6, 2, 5}, {1, 2, 0}, {6, 2, -3}, {-4, -7, 4}},
    {{-5, 0, 3}, {1, 0, 3}, {-2, 9, 3}, {-3, -1, 2}, {-3, -1, 4}, {-1, -1, 2}, {3, -6, 2}, {-5, -10, 5}},
    {{-3, -1, -2}, {7, -1, -2}, {2, 7, -2}, {0, -2, -6}, {4, -2, 2}, {-4, -21, -5}},
    {{-14, 0, 22}, {22, 0, -26}, {4, -70, -2}, {-20, 5, 5}, {29, 5, -2}, {-11, 5, 18}}};

void add_saddles_to_saddles(GroupWriter& cases, std::size_t first) {
  for (const Rows& points : kSaddleToSaddle) {
    cases.given(first++, "an orbit from index 2 to index 2, found among small integers", "", points);
  }
}

// Inputs of many families. Each group takes other ones of them.
void add_drawn(GroupWriter& cases, std::uint64_t seed, int size = 100) {
  std::size_t next = 39;
  for (const char* family :
       {"general-position",    "lattice-2",        "lattice-3",         "lattice-4",         "duplicates",
        "signed-permutations", "integer-sphere",   "sphere-and-others", "box-corners",       "two-circles",
        "coplanar-lattice",    "coplanar-circles", "collinear",         "right-angle-12",    "right-angle-23",
        "right-angle-13",      "right-angles",     "sphere-scan",       "torus-scan",        "sheet-scan",
        "long-cascade",        "half-shell",       "high-degree-facet", "right-angle-chain", "through-vertex",
        "rounded-sphere",      "rounded-rotation", "rounded-to-float",  "one-ulp-off",       "far-away",
        "far-away-rounded",    "extreme-scale",    "two-scales",        "mixed-magnitudes"}) {
    cases.drawn(next++, family, size, {seed});
  }
}

Group lambda_lists() {
  GroupWriter cases("lambda-lists", "Where the directions of stationary points lead", "FC-UNST-01 FC-UNST-02");
  cases.asking({.lambda = true});
  add_named_cases(cases);
  add_drawn(cases, 31);
  return cases.group();
}

Group volumes() {
  GroupWriter cases("volumes", "Volumes of stable sets, and what Voronoi cells have of them", "FC-VOL-01 FC-VOL-02");
  cases.asking({.volumes = true});
  add_named_cases(cases);
  add_drawn(cases, 32);
  add_saddles_to_saddles(cases, 73);
  return cases.group();
}

Group connections() {
  GroupWriter cases("connections", "Which stationary points lead to which, and whether the input is Morse-Smale",
                    "FC-CONN-01 FC-CONN-02 FC-CONN-03");
  cases.asking({.connections = true});
  add_named_cases(cases);
  add_drawn(cases, 33);
  add_saddles_to_saddles(cases, 73);
  return cases.group();
}

// The triangle is obtuse at the edge of 0 and 1. The trace on its Voronoi edge fans out in the facet of 0 and 1.
const Rows kBeyondObtuse = {{-4, 0, 0}, {4, 0, 0}, {0, 1, 0}, {0, 0, 40}};

const Rows kTraceOfAPoint[] = {
    {{0, -2, 1}, {-2, -2, -2}, {1, 2, 0}, {2, 1, 2}, {-2, 1, 0}, {-1, -1, 0}, {-2, -1, 0}},
    {{-2, 1, -1}, {3, -3, -3}, {-2, 2, 3}, {-1, -2, 0}, {-1, 0, -3}, {-1, -2, -1}, {1, -2, 3}},
    {{0, 4, 1}, {10, 4, 1}, {5, 12, 1}, {6, 2, 5}, {1, 2, 0}, {6, 2, -3}, {-4, -7, 4}}};

// A set has more parts than all other answers have numbers, so drawn inputs are smaller.
Group unstable_surfaces() {
  GroupWriter cases("unstable-surfaces", "What flows from edges, as sets", "FC-UNST-04 FC-UNST-05 FC-UNST-06");
  cases.asking({.surfaces = true});
  add_named_cases(cases);
  add_drawn(cases, 34, 30);
  cases.given(73, "a sheet that fans out beyond an obtuse triangle", "", kBeyondObtuse);
  cases.given(74, "obtuse triangles in a row, in a plane", "",
              {{-4, 0, 0}, {4, 0, 0}, {0, 1, 0}, {3, 2, 0}, {-3, 2, 0}, {0, -9, 0}});
  for (std::size_t number = 75; const Rows& points : kTraceOfAPoint) {
    cases.given(number++, "a trace that is one point, found among small integers", "", points);
  }
  cases.given(78, "a run on which no piece flows in from a stationary back: FC-UNST-06", "",
              {{3, 3, 1}, {3, 2, 3}, {0, 0, 3}, {0, 4, 1}, {0, 0, 1}});
  cases.given(79, "a facet that is entered through two traces: FC-UNST-05", "",
              {{3, 0, 6}, {3, 6, 0}, {4, 6, 5}, {6, 3, 4}, {1, 4, 8}});
  return cases.group();
}

}  // namespace

void add_whole_complex_groups(std::vector<Group>& table) {
  table.push_back(lambda_lists());
  table.push_back(volumes());
  table.push_back(connections());
  table.push_back(unstable_surfaces());
}

}  // namespace oracle::vectors
