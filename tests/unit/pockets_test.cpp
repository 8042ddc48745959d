// Pockets of the fast implementation: what their numbers and meshes promise beyond the comparison with the oracle.
#include "flowcert/pockets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <random>
#include <sstream>

#include "flowcert/stable_manifolds.h"
#include "geometry/difference_of_roots.h"
#include "io/cell_surfaces.h"
#include "io/pocket_persistence.h"
#include "io/write_pockets.h"
#include "morse/saddle_radii.h"
#include "tests/cites.h"
#include "tests/property/root_differences.h"

namespace flowcert::pockets_test {
namespace {

using geometry::RootDifference;

std::vector<Point> lattice(int side) {
  std::vector<Point> rows;
  for (int k = 0; k < side * side * side; ++k) {
    const int x = k % side, y = k / side % side, z = k / side / side;
    rows.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  }
  return rows;
}

std::vector<Point> cloud(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Point> rows;
  for (std::size_t k = 0; k < count; ++k) {
    const auto coordinate = [&] { return static_cast<double>(random() % 1000) / 100; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    rows.push_back({x, y, z});
  }
  return rows;
}

TEST(DifferenceOfRoots, IsTheNearestDouble) {
  CITES("FC-POCK-11");
  using geometry::nearest_difference_of_roots;
  EXPECT_EQ(nearest_difference_of_roots(9, 4), 1);
  EXPECT_EQ(nearest_difference_of_roots(4, 9), -1);
  EXPECT_EQ(nearest_difference_of_roots(Rational(1, 4), Rational(1, 9)), 1.0 / 6);
  EXPECT_EQ(nearest_difference_of_roots(2, 2), 0);
  EXPECT_EQ(nearest_difference_of_roots(2, 0), std::sqrt(2.0));
  EXPECT_EQ(nearest_difference_of_roots(Rational(1e300) * 1e300, 0), 1e300);
  EXPECT_EQ(nearest_difference_of_roots(Rational(1e308) * 1e308 * 1000000, 0), HUGE_VAL);
  EXPECT_EQ(nearest_difference_of_roots(Rational(5e-324) * 5e-324, 0), 5e-324);
  EXPECT_EQ(nearest_difference_of_roots(Rational(5e-324) * 5e-324 / 8, 0), 0);
  // Differences that cancel, and numbers of all sizes.
  std::mt19937_64 random(5);
  for (int k = 0; k < 2000; ++k) {
    const auto number = [&] {
      return Rational(std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 200) - 150)) /
             (1 + random() % 7);
    };
    const Rational b = number(), a = k % 2 == 0 ? number() : b * (1 + Rational(1, 1 + (random() >> 8)));
    EXPECT_TRUE(oracle::is_nearest_root_difference(nearest_difference_of_roots(a, b), a, b)) << a << ' ' << b;
  }
}

// Against the same differences of integer roots of many digits.
TEST(DifferenceOfRoots, IsComparedExactly) {
  CITES("FC-POCK-02");
  std::mt19937_64 random(6);
  const auto scaled_root = [](const Rational& x) {
    constexpr unsigned kDigits = 400;
    const boost::multiprecision::mpz_int top(numerator(x)), bottom(denominator(x));
    return boost::multiprecision::mpz_int(sqrt(boost::multiprecision::mpz_int((top << (2 * kDigits)) / bottom)));
  };
  std::size_t equal = 0;
  for (int k = 0; k < 6000; ++k) {
    // Squares of small numbers, their multiples and others: differences of two are often equal.
    const auto number = [&](unsigned most) { return Rational(static_cast<unsigned>(random() % most)); };
    const Rational factor = k % 3 == 0 ? Rational(1) : 1 + number(5);
    const auto square = [&] {
      const Rational root = number(7);
      return Rational(k % 4 == 3 ? number(40) : root * root * factor);
    };
    const RootDifference x{square(), square()}, y{square(), square()};
    const auto difference = [&](const RootDifference& one) {
      return boost::multiprecision::mpz_int(scaled_root(one.square) - scaled_root(one.less));
    };
    // Roots are cut: numbers that differ by less than four units are equal here, as no others come so near.
    const boost::multiprecision::mpz_int gap = difference(x) - difference(y);
    const auto expected = abs(gap) < 4 ? std::strong_ordering::equal : gap.compare(0) <=> 0;
    EXPECT_EQ(x <=> y, expected) << x.square << ' ' << x.less << ' ' << y.square << ' ' << y.less;
    equal += expected == std::strong_ordering::equal ? 1 : 0;
  }
  EXPECT_GT(equal, 300U);
}

TEST(DifferenceOfRoots, FromAboveIsTheLeastOf53Digits) {
  CITES("FC-POCK-02");
  using geometry::square_from_above;
  EXPECT_EQ(square_from_above({2, 0}), 2);
  EXPECT_EQ(square_from_above({9, 4}), 1);
  EXPECT_EQ(square_from_above({2, 2}), 0);
  std::mt19937_64 random(7);
  for (int k = 0; k < 1000; ++k) {
    const Rational b(static_cast<unsigned>(random() % 1000)),
        a = b + Rational(static_cast<unsigned>(1 + random() % 1000), 3);
    const RootDifference number{a, b};
    const Rational square = square_from_above(number);
    EXPECT_GE(RootDifference{square}, number);
    const double root = std::sqrt(nearest_double(square).value());
    if (b == 0) continue;
    EXPECT_EQ(Rational(root) * Rational(root), square);
    const Rational below(std::nextafter(root, 0));
    EXPECT_LT(RootDifference{below * below}, number);
  }
}

TEST(SquaredDistances, LengthsLieWithinTheirBounds) {
  CITES("FC-PERS-01");
  const FlowComplex complex(cloud(60, 3));
  const Persistence& persistence = complex.persistence();
  for (const PersistencePair& pair : persistence.pairs()) {
    if (!pair.death) continue;
    const auto [value, error] = persistence.squared_distances().length(pair.birth, *pair.death);
    const RootDifference length{persistence.squared_value(*pair.death), persistence.squared_value(pair.birth)};
    const Rational low = Rational(value) - Rational(error), high = Rational(value) + Rational(error);
    EXPECT_LE(low < 0 ? RootDifference{0} : RootDifference{low * low}, length);
    EXPECT_GE(RootDifference{high * high}, length);
    EXPECT_LT(error, 1e-9 * (1 + value));
  }
}

TEST(SquaredDistances, AreComparedWithNumbersExactly) {
  CITES("FC-PERS-01");
  const FlowComplex complex(cloud(60, 3));
  const SquaredDistances& distances = complex.merge_trees().squared_distances();
  for (std::size_t record = 0; record < complex.stationary().size(); ++record) {
    const Rational value = distances.exact(record);
    const Rational little(1, Rational(1e60).convert_to<boost::multiprecision::mpz_int>());
    EXPECT_EQ(distances.compare(record, value), std::strong_ordering::equal);
    for (const Rational& more : {little, Rational(1, 3)}) {
      EXPECT_EQ(distances.compare(record, value + more), std::strong_ordering::less);
      EXPECT_EQ(distances.compare(record, value - more), std::strong_ordering::greater);
    }
  }
}

// Six times the volume that a closed mesh encloses, in doubles, and whether each edge is passed both ways alike.
std::pair<double, bool> enclosed(const CellSurface& surface) {
  double six_volumes = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : surface.triangles) {
    const Point &a = surface.vertices[triangle[0]], &b = surface.vertices[triangle[1]],
                &c = surface.vertices[triangle[2]];
    six_volumes += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  bool is_closed = true;
  for (const auto& [edge, sum] : edges) is_closed = is_closed && sum == 0;
  return {six_volumes, is_closed};
}

TEST(CellSurfaces, AreClosedAndEncloseTheVolume) {
  CITES("FC-POCK-03");
  for (const auto& rows : {lattice(4), cloud(150, 1), cloud(300, 2)}) {
    const FlowComplex complex(rows);
    for (const Rational& persistence : {Rational(0), Rational(1, 5), Rational(1)}) {
      const Pockets pockets(complex.merge_trees(), persistence);
      const std::vector<CellSurface> surfaces = cell_surfaces(complex, pockets.cells());
      ASSERT_EQ(surfaces.size(), pockets.size());
      for (std::size_t k = 0; k < surfaces.size(); ++k) {
        const auto [six_volumes, is_closed] = enclosed(surfaces[k]);
        EXPECT_TRUE(is_closed);
        const double volume = complex.volumes().nearest_sum(pockets[k].cell);
        EXPECT_NEAR(six_volumes / 6, volume, 1e-9 * (1 + volume));
        EXPECT_GT(volume, 0);
      }
    }
  }
}

// So far from the origin, doubles say too little of the corners.
TEST(SurfaceArea, DoesNotDependOnWhatDecidesIt) {
  CITES("FC-POCK-04", "FC-STAB-04");
  std::vector<Point> far_away = lattice(2);
  for (Point& p : far_away) p = {p.x + 0x1p40, p.y - 0x1p40, p.z + 0x1p40};
  for (const auto& rows : {lattice(2), far_away}) {
    const FlowComplex complex(rows);
    ASSERT_GE(complex.stable().size(), 6U);
    for (std::size_t side = 0; side < 6; ++side) {
      EXPECT_NEAR(surface_area(complex.points(), complex.stable(), side), 1, 1e-12);
    }
  }
}

TEST(StableVolumes, SumsAreTheNearestDoubles) {
  CITES("FC-VOL-01", "FC-POCK-03");
  const FlowComplex complex(cloud(200, 9));
  const Pockets pockets(complex.merge_trees(), Rational(1, 50));
  std::size_t merged = 0;
  for (std::size_t k = 0; k < pockets.size(); ++k) {
    const auto& cell = pockets[k].cell;
    EXPECT_EQ(complex.volumes().nearest_sum(cell), nearest_double(complex.volumes().exact_sum(cell)));
    merged += cell.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(merged, 3U);
  EXPECT_EQ(complex.volumes().nearest_sum({}), 0);
  EXPECT_EQ(complex.volumes().exact_sum({}), 0);
}

TEST(Pockets, MergeMoreWithMorePersistence) {
  CITES("FC-POCK-02", "FC-POCK-09");
  const FlowComplex complex(cloud(400, 4));
  const Persistence& persistence = complex.persistence();
  for (const Rational& bound : {Rational(0), Rational(1, 100), Rational(1, 10), Rational(1), Rational(10)}) {
    const Pockets pockets(complex.merge_trees(), bound);
    std::size_t longer = 0, deep = 0;
    for (const PersistencePair& pair : persistence.pairs()) {
      if (pair.dimension != 2) continue;
      const RootDifference length{persistence.squared_value(*pair.death), persistence.squared_value(pair.birth)};
      longer += length > RootDifference{bound} ? 1 : 0;
    }
    for (std::size_t k = 0; k < pockets.size(); ++k) {
      const RootDifference depth{complex.sphere(pockets[k].peaks.front()).squared_radius,
                                 complex.sphere(pockets[k].highest_mouth).squared_radius};
      deep += depth > RootDifference{bound} ? 1 : 0;
    }
    EXPECT_EQ(deep, longer) << bound;
  }
  EXPECT_THROW((void)Pockets(complex.merge_trees(), Rational(-1)), std::invalid_argument);
}

TEST(PocketPersistence, HasQuantilesOfTheLengthsOfVoids) {
  CITES("FC-TREE-05");
  const FlowComplex complex(cloud(120, 6));
  std::vector<RootDifference> lengths;
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    if (pair.dimension == 2) {
      lengths.push_back(
          {complex.persistence().squared_value(*pair.death), complex.persistence().squared_value(pair.birth)});
    }
  }
  std::ranges::sort(lengths);
  const Rational longest = pocket_persistence(complex, "q1", "--x").square;
  EXPECT_EQ(longest, geometry::square_from_above(lengths.back()));
  EXPECT_EQ(pocket_persistence(complex, "q0", "--x").square, 0);
  EXPECT_EQ(pocket_persistence(complex, "0.25", "--x").square, Rational(1, 16));
  EXPECT_EQ(pocket_persistence(complex, "2spacing", "--x").square, 4 * morse::squared_spacing(complex).value());
  EXPECT_EQ(Pockets(complex.merge_trees(), longest).size(), 0U);
  EXPECT_THROW((void)pocket_persistence(complex, "-1", "--x"), InvalidInput);
  EXPECT_THROW((void)pocket_persistence(complex, "2spacing^2", "--x"), InvalidInput);
}

// The pairs of two flat boxes are few: there is no valley.
TEST(PocketPersistence, WithoutAValleyIsHalfTheSpacing) {
  const FlowComplex complex(lattice(2));
  const PocketPersistence found = pocket_persistence(complex, "auto", "--x");
  ASSERT_TRUE(found.automatic.has_value());
  EXPECT_FALSE(found.automatic->valley.has_value());
  EXPECT_EQ(found.square, morse::squared_spacing(complex).value() / 4);
}

TEST(Newick, OfADeepTreeIsWritten) {
  CITES("FC-TREE-06");
  // Points on a line, farther and farther apart: each joins all before it.
  std::vector<Point> rows;
  rows.reserve(20000);
  double x = 0;
  for (int k = 0; k < 20000; ++k) rows.push_back({x += 1 + k * 1e-3, 0, 0});
  const FlowComplex complex(rows);
  std::ostringstream text;
  write_newick(text, complex, TreeKind::kComponents);
  EXPECT_EQ(std::ranges::count(text.str(), '('), 19999);
  EXPECT_EQ(std::ranges::count(text.str(), ')'), 19999);
}

}  // namespace
}  // namespace flowcert::pockets_test
