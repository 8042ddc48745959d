// The group of recipes about cycles: claims of loops, voids and components, right ones and wrong ones. Surfaces made of
// triangles, and what is wrong with them, are by hand.
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

namespace {

const Rows kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
const Rows kRing = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}, {0, 4, 0}, {0, 2, 0}};
const Rows kRectangle = {{1, 7, 0}, {-1, 7, 0}, {1, -7, 0}, {-1, -7, 0}};
const Rows kEqualRectangle = {{5, 5, 0}, {-5, 5, 0}, {5, -5, 0}, {-5, -5, 0}};
const Rows kEqualPeaks = {{-1, -1, -3}, {-1, 0, -1}, {0, -2, -1}, {0, 1, -3}, {0, 2, 1}, {1, -1, -3}, {1, 0, -1}};
const Rows kFaceCentres = {{1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {1, 2, 1}, {2, 1, 1}};

Rows face_centred_cell() { return joined(scaled(grid(2, 2, 2), 1), kFaceCentres); }

// Each edge of a square to one more point.
std::vector<std::string> with_tent(std::vector<std::string> lines) {
  lines.insert(lines.end(), {"triangle 0 1 4", "triangle 1 2 4", "triangle 2 3 4", "triangle 0 3 4"});
  return lines;
}

void add_by_hand(GroupWriter& cases) {
  const std::vector<std::string> loop = {"cycles 1", "pair 0,1/0,1,2,3", "loop 0 1 2 3"};
  cases.given(1, "no points", "", {});
  cases.given(2, "one point", "", {{1, 2, 3}});
  cases.given(3, "a square", "cocircular", kSquare);
  cases.claim_cycles(loop, {});
  cases.claim_cycles({"cycles 1 all", "pair 1.0 2.0", "loop 2 1 0 3"}, {});
  cases.claim_cycles({"cycles 1 all", "pair 1.0 2.0", "loop 3 1 0 2"}, {"edge-too-long", "missing"});
  cases.claim_cycles({"cycles 1", "pair 1/1 9/4", "loop 0 1 2 3"}, {"wrong-pair"});
  cases.claim_cycles({"cycles 1", "pair 1/1 2/1", "level 2/1", "loop 0 1 2 3"}, {"wrong-pair"});
  cases.claim_cycles({loop[0], loop[1], loop[2], "triangle 0 1 2", "triangle 0 2 3"}, {});
  cases.claim_cycles({loop[0], loop[1], loop[2], "triangle 0 1 2"}, {"surface-boundary"});
  cases.given(4, "a square, and a point far above it", "cocircular", joined(kSquare, {{1, 1, 9}}));
  cases.claim_cycles(with_tent(loop), {"triangle-too-large"});
  cases.given(5, "a regular tetrahedron", "", scaled(kTetrahedron, 1));
  cases.claim_cycles(
      {"cycles 2 all", "pair 0,1,2/0,1,2,3", "triangle 0 1 2", "triangle 0 1 3", "triangle 0 2 3", "triangle 1 2 3"},
      {});
  cases.claim_cycles({"cycles 2", "pair 0,1,2/0,1,2,3", "triangle 0 1 2", "triangle 0 1 3", "triangle 0 2 3"},
                     {"not-a-cycle"});
}

void add_of_the_spec(GroupWriter& cases) {
  cases.given(6, "two acute triangles of a plane", "", {{0, 0, 0}, {8, 0, 0}, {4, 7, 0}, {4, -2, 0}});
  cases.given(7, "ties below, by which boundaries differ", "", kTieInTheComplex);
  cases.given(8, "at a level a loop has a class that is born later", "",
              {{0, 1, 1}, {1, 0, 2}, {1, 2, 0}, {1, 2, 2}, {2, 0, 2}, {2, 1, 1}});
  cases.given(9, "two equal peaks", "", kEqualPeaks);
  cases.given(10, "two rectangles whose loops die at one value", "cocircular",
              joined(kRectangle, shifted(kEqualRectangle, {0, 0, 900})));
  cases.given(11, "three of them, two alike", "cocircular",
              joined(joined(kRectangle, shifted(kEqualRectangle, {0, 0, 900})), shifted(kRectangle, {0, 0, 1900})));
  cases.given(12, "a square beside a ring: one loop dies later", "cocircular",
              joined(kSquare, shifted(kRing, {50, 0, 0})));
  cases.given(13, "a ring, and a loop of its diagonals", "cocircular", kRing);
  cases.claim_cycles({"cycles 1", "pair 1/1 4/1", "level 2/1", "loop 1 3 5 7"}, {});
  cases.claim_cycles({"cycles 1", "pair 1/1 4/1", "level 7/4", "loop 1 3 5 7"}, {"edge-too-long"});
  cases.given(14, "a tube, with a class of two polygons", "cocircular", joined(kRing, shifted(kRing, {0, 0, 3})));
}

void add_shapes(GroupWriter& cases) {
  cases.given(15, "an octahedron", "cospherical", sphere(1));
  cases.given(16, "a cuboctahedron", "cospherical", sphere(2));
  cases.given(17, "a lattice of 8 points", "lattice", grid(2, 2, 2));
  cases.given(18, "a lattice of 12 points", "lattice", grid(3, 2, 2));
  cases.given(19, "a lattice of 18 points", "lattice", grid(3, 3, 2));
  cases.given(20, "a face-centred cell", "lattice", face_centred_cell());
  cases.given(21, "points of a line", "", {{0, 0, 0}, {2, 0, 0}, {6, 0, 0}, {7, 0, 0}, {7, 0, 0}});
  cases.given(22, "two squares, each around a corner of the other", "cocircular",
              joined({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{1, 0, -1}, {3, 0, -1}, {3, 0, 1}, {1, 0, 1}}));
}

}  // namespace

void add_cycle_groups(std::vector<Group>& table) {
  GroupWriter cases("cycles", "Claims of loops, voids and components, right and wrong ones",
                    "FC-CYC-01 FC-CYC-02 FC-CYC-03 FC-CYC-06 FC-CYC-07 FC-CLAIM-25");
  cases.asking({.cycles = true});
  add_by_hand(cases);
  add_of_the_spec(cases);
  add_shapes(cases);
  cases.drawn(23, "general-position", 100, {1, 3});
  cases.drawn(25, "lattice-2", 100, {5, 9});
  cases.drawn(27, "signed-permutations", 100, {3});
  cases.drawn(28, "integer-sphere", 100, {3, 4});
  cases.drawn(30, "right-angle-12", 100, {5});
  cases.drawn(31, "right-angle-23", 100, {2});
  cases.drawn(32, "right-angle-13", 100, {1});
  cases.drawn(33, "torus-scan", 100, {3});
  cases.drawn(34, "rounded-sphere", 100, {1});
  cases.drawn(35, "one-ulp-off", 100, {5});
  cases.drawn(36, "far-away-rounded", 100, {5});
  cases.drawn(37, "duplicates", 100, {2, 4});
  cases.drawn(39, "coplanar-circles", 100, {8});
  cases.drawn(40, "two-scales", 100, {2});
  table.push_back(cases.group());
}

}  // namespace oracle::vectors
