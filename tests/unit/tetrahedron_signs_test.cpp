// All signs of a Delaunay cell at once (tetrahedron_signs) against the single predicates' exact rungs, sign
// by sign, on the kinds of inputs of tests/unit/point_tuples.h: twelve angles, four sides, and whether a
// point lies on the cell's sphere.
//
// Also: a side stays open only where the spec never asks for it; the tally counts what was decided by whom;
// the filter decides generic cells by itself; and the signature of every cell sums to 1.
#include "geometry/tetrahedron_signs.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <ostream>

#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::geometry {

// GoogleTest finds this for its messages.
static void PrintTo(Sign sign, std::ostream* out) { *out << static_cast<int>(sign); }

}  // namespace flowcert::geometry

namespace flowcert::tetrahedron_signs_test {

using namespace geometry;

namespace {

using flowcert_tests::draw_cell;
using flowcert_tests::kTupleKinds;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

template <std::size_t N>
TetrahedronPoints first_four(const std::array<Point, N>& points) {
  return {&points[0], &points[1], &points[2], &points[3]};
}

Sign angle_of(const TetrahedronSigns& signs, unsigned facet, unsigned vertex) {
  const unsigned bit = TetrahedronSigns::angle_bit(facet, vertex);
  if (((signs.angle_negative >> bit) & 1u) != 0) return Sign::kNegative;
  return ((signs.angle_zero >> bit) & 1u) != 0 ? Sign::kZero : Sign::kPositive;
}

bool is_open(const TetrahedronSigns& signs, unsigned facet) { return ((signs.side_open >> facet) & 1u) != 0; }

Sign side_of(const TetrahedronPoints& points, const TetrahedronSigns& signs, unsigned facet) {
  if (is_open(signs, facet)) return side_exactly(points, facet);
  if (((signs.side_negative >> facet) & 1u) != 0) return Sign::kNegative;
  return ((signs.side_zero >> facet) & 1u) != 0 ? Sign::kZero : Sign::kPositive;
}

// The definitions, by the exact rungs of the single predicates.
Sign exact_angle(const TetrahedronPoints& p, unsigned facet, unsigned vertex) {
  std::array<unsigned, 2> others{};
  std::size_t filled = 0;
  for (unsigned k = 0; k < 4; ++k) {
    if (k != facet && k != vertex) others[filled++] = k;
  }
  return unfiltered_sign(Angle{*p[others[0]], *p[vertex], *p[others[1]]});
}

Sign exact_side(const TetrahedronPoints& p, unsigned facet) {
  return unfiltered_sign(SideOfPlane{*p[(facet + 1) % 4], *p[(facet + 2) % 4], *p[(facet + 3) % 4], *p[facet]});
}

struct Seen {
  std::map<Sign, int> angles, sides;
  int open = 0, failures = 0;
};

void compare_cell(const TetrahedronPoints& points, Seen& seen) {
  CellSphere sphere;
  FilterTally tally;
  const TetrahedronSigns signs = tetrahedron_signs(points, sphere, tally);
  for (unsigned facet = 0; facet < 4; ++facet) {
    bool obtuse = false, right = false;
    for (unsigned vertex = 0; vertex < 4; ++vertex) {
      if (vertex == facet) continue;
      const Sign expected = exact_angle(points, facet, vertex);
      ASSERT_EQ(angle_of(signs, facet, vertex), expected) << "angle of facet " << facet << " at " << vertex;
      obtuse = obtuse || expected == Sign::kNegative;
      right = right || expected == Sign::kZero;
      ++seen.angles[expected];
    }
    ASSERT_EQ(signs.is_obtuse(facet), obtuse);
    ASSERT_EQ(signs.is_right(facet), right);
    ASSERT_EQ(signs.is_acute(facet), !obtuse && !right);

    const Sign expected = exact_side(points, facet);
    ASSERT_EQ(side_of(points, signs, facet), expected) << "side of facet " << facet;
    ASSERT_EQ(side_exactly(points, facet), expected);
    ++seen.sides[expected];
    if (is_open(signs, facet)) {
      ASSERT_TRUE(obtuse) << "a side is open although its facet contains its centre";
      ASSERT_FALSE(signs.has_positive_side(facet));
      ++seen.open;
    } else {
      ASSERT_EQ(signs.has_positive_side(facet), expected == Sign::kPositive);
    }
  }
  const FilterCount& of_angles = tally[Predicate::kAngle];
  const FilterCount& of_sides = tally[Predicate::kSideOfPlane];
  ASSERT_EQ(of_angles.calls, 12u);
  ASSERT_EQ(of_sides.calls, 4u);
  // The filter cannot know a zero, so each is one failure at least.
  ASSERT_GE(of_angles.failures, static_cast<unsigned>(std::popcount(signs.angle_zero)));
  ASSERT_LE(of_angles.failures, 12u);
  ASSERT_GE(of_sides.failures, static_cast<unsigned>(std::popcount(signs.side_zero) + std::popcount(signs.side_open)));
  ASSERT_LE(of_sides.failures, 4u);
  if (!sphere.in_range) {
    ASSERT_EQ(of_angles.failures, 12u);
    ASSERT_EQ(of_sides.failures, 4u);
  }
  seen.failures += of_angles.failures + of_sides.failures == 0 ? 0 : 1;
}

TEST(TetrahedronSignsTest, AgreeWithTheSinglePredicates) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-NUM-01");
  constexpr int kCells = 2500;
  PortableRandom random(4);
  std::map<TupleKind, Seen> seen;
  for (const TupleKind kind : kTupleKinds) {
    for (int k = 0; k < kCells; ++k) {
      const auto cell = draw_cell<4>(kind, random);
      compare_cell(first_four(cell), seen[kind]);
      if (HasFatalFailure()) return;
    }
    for (const Sign sign : {Sign::kNegative, Sign::kPositive}) {
      EXPECT_GT(seen[kind].angles[sign], 100);
      EXPECT_GT(seen[kind].sides[sign], 100);
    }
  }
  for (const TupleKind kind : {TupleKind::kLattice, TupleKind::kSpherical, TupleKind::kFarOff, TupleKind::kSubnormal}) {
    EXPECT_GT(seen[kind].angles[Sign::kZero], 100);
    EXPECT_GT(seen[kind].sides[Sign::kZero], 30);
  }
  EXPECT_GT(seen[TupleKind::kMagnitudes].open, 100);
  EXPECT_GT(seen[TupleKind::kSubnormal].open, 100);
  // Less than one generic cell in a thousand needs an exact sign.
  EXPECT_LT(seen[TupleKind::kGeneric].failures * 1000, kCells);
}

// A corner of a cube: three right angles at vertex 0 are ties, everything else is the filter's.
TEST(TetrahedronSignsTest, TallyOfACubesCorner) {
  CITES("FC-SIGN-01", "FC-SIGN-03");
  const std::array<Point, 4> corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  CellSphere sphere;
  FilterTally tally;
  const TetrahedronSigns signs = tetrahedron_signs(first_four(corner), sphere, tally);
  EXPECT_EQ(tally[Predicate::kAngle], (FilterCount{12, 3}));
  EXPECT_EQ(tally[Predicate::kSideOfPlane], (FilterCount{4, 0}));
  EXPECT_EQ(signs.angle_negative, 0);
  EXPECT_EQ(signs.angle_zero, (1u << TetrahedronSigns::angle_bit(1, 0)) | (1u << TetrahedronSigns::angle_bit(2, 0)) |
                                  (1u << TetrahedronSigns::angle_bit(3, 0)));
  // The centre (1/2, 1/2, 1/2) lies beyond the slanted facet.
  EXPECT_EQ(signs.side_negative, 1u);
  EXPECT_EQ(signs.side_zero | signs.side_open, 0);
  EXPECT_TRUE(sphere.in_range);
}

// At lengths that the filter does not take all signs are still right, and all come from the exact rungs. They
// are the signs of the same cell at length 1.
TEST(TetrahedronSignsTest, CellsOutsideOfTheFiltersRange) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-NUM-01", "FC-IN-04");
  PortableRandom random(5);
  for (int k = 0; k < 300; ++k) {
    const auto cell = draw_cell<4>(k % 2 == 0 ? TupleKind::kLattice : TupleKind::kSpherical, random);
    CellSphere sphere;
    FilterTally unused;
    const TetrahedronSigns plain = tetrahedron_signs(first_four(cell), sphere, unused);
    ASSERT_TRUE(sphere.in_range);
    for (const int exponent : {-1074, -150, 150, 1000}) {
      std::array<Point, 4> scaled;
      for (std::size_t i = 0; i < 4; ++i) {
        scaled[i] = {std::ldexp(cell[i].x, exponent), std::ldexp(cell[i].y, exponent), std::ldexp(cell[i].z, exponent)};
      }
      FilterTally tally;
      const TetrahedronSigns signs = tetrahedron_signs(first_four(scaled), sphere, tally);
      ASSERT_FALSE(sphere.in_range) << exponent;
      ASSERT_EQ(tally[Predicate::kAngle], (FilterCount{12, 12}));
      ASSERT_EQ(tally[Predicate::kSideOfPlane], (FilterCount{4, 4}));
      ASSERT_EQ(signs.angle_negative, plain.angle_negative);
      ASSERT_EQ(signs.angle_zero, plain.angle_zero);
      for (unsigned facet = 0; facet < 4; ++facet) {
        ASSERT_EQ(side_of(first_four(scaled), signs, facet), side_of(first_four(cell), plain, facet));
      }
    }
  }
}

TEST(OnSphereTest, IsTheInSpherePredicatesZero) {
  CITES("FC-VOR-01", "FC-NUM-01");
  PortableRandom random(6);
  std::map<TupleKind, int> on, outside, failures;
  for (const TupleKind kind : kTupleKinds) {
    for (int k = 0; k < 6000; ++k) {
      const auto points = draw_cell<5>(kind, random);
      const Sign expected = unfiltered_sign(OutsideSphere{points[0], points[1], points[2], points[3], points[4]});
      if (expected == Sign::kNegative) continue;  // no Delaunay cell has such a neighbour
      CellSphere sphere;
      FilterTally tally;
      (void)tetrahedron_signs(first_four(points), sphere, tally);
      ASSERT_EQ(on_sphere(first_four(points), sphere, points[4], tally), expected == Sign::kZero);
      const FilterCount& count = tally[Predicate::kCospherical];
      ASSERT_EQ(count.calls, 1u);
      ASSERT_LE(count.failures, 1u);
      if (expected == Sign::kZero || !sphere.in_range) {
        ASSERT_EQ(count.failures, 1u);
      }
      ++(expected == Sign::kZero ? on : outside)[kind];
      failures[kind] += static_cast<int>(count.failures);
    }
    if (kind != TupleKind::kSpherical) {
      EXPECT_GT(outside[kind], 20);
    }
  }
  EXPECT_GT(on[TupleKind::kLattice], 300);
  EXPECT_GT(on[TupleKind::kSpherical], 5000);
  EXPECT_GT(on[TupleKind::kSubnormal], 100);
  EXPECT_GT(failures[TupleKind::kOneUlp], on[TupleKind::kOneUlp]) << "near ties on which the filter gives up";
  EXPECT_LT(failures[TupleKind::kGeneric] * 1000, outside[TupleKind::kGeneric]);
}

// The critical points of four points alone follow from the signs of their one cell.
TEST(TetrahedronSignsTest, SignaturesSumToOne) {
  CITES("FC-INV-03", "FC-SIGN-02", "FC-SIGN-03");
  PortableRandom random(8);
  std::map<std::array<int, 3>, int> seen;
  for (const TupleKind kind : kTupleKinds) {
    for (int k = 0; k < 2000; ++k) {
      const auto cell = draw_cell<4>(kind, random);
      CellSphere sphere;
      FilterTally tally;
      const TetrahedronSigns signs = tetrahedron_signs(first_four(cell), sphere, tally);
      std::array<int, 3> count{};
      // The common edge of facets i and j is seen from vertex j in facet i, and from vertex i in facet j.
      for (unsigned i = 0; i < 4; ++i) {
        for (unsigned j = i + 1; j < 4; ++j) {
          const bool acute = angle_of(signs, i, j) == Sign::kPositive && angle_of(signs, j, i) == Sign::kPositive;
          count[0] += acute ? 1 : 0;
        }
      }
      unsigned positive = 0;
      for (unsigned facet = 0; facet < 4; ++facet) {
        const bool beyond = side_of(first_four(cell), signs, facet) == Sign::kPositive;
        positive += beyond ? 1 : 0;
        count[1] += beyond && signs.is_acute(facet) ? 1 : 0;
      }
      count[2] = positive == 4 ? 1 : 0;
      ASSERT_EQ(4 - count[0] + count[1] - count[2], 1);
      ++seen[count];
    }
  }
  EXPECT_GE(seen.size(), 6u) << "signatures met";
}

}  // namespace
}  // namespace flowcert::tetrahedron_signs_test
