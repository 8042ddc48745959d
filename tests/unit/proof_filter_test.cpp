// The filter of flowcert-proof against exact values: a polynomial's value in doubles is as near to the exact one as its
// bound says, at all scales of doubles and with subnormals, and where doubles alone have the wrong sign, it is not
// certain.
//
// The headers of oracle/proof have global names, so that this is a program of its own.
#include <gtest/gtest.h>

#include <random>

#include "oracle/proof/pairs.h"

namespace {

struct Counts {
  int certain = 0, uncertain = 0, wrong_in_doubles = 0, in_128_bits = 0;
};

mpq_class times_power_of_two(mpq_class x, int exponent) {
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(exponent));
  return exponent >= 0 ? mpq_class(x << shift) : mpq_class(x >> shift);
}

// The polynomial is homogeneous in differences of coordinates. 128 bits hold its values if the grid has up to `bits`.
template <class Polynomial>
void compare(const Points& points, int degree, int bits, const Polynomial& polynomial, Counts& counts) {
  const Filtered filtered = polynomial.template operator()<Filtered>();
  const mpz_class exact = polynomial.template operator()<BigInteger>().value;
  // In units of the grid, coordinates that are scaled to less than 1 are these many bits greater.
  const mpq_class scaled = times_power_of_two(exact, -degree * points.grid_bits());
  const mpq_class bound = times_power_of_two(mpq_class(filtered.magnitude), -47) + times_power_of_two(1, -900);
  EXPECT_LE(abs(mpq_class(filtered.value) - scaled), bound) << "degree " << degree;
  EXPECT_LT(filtered.magnitude, 0x1p60);
  if (filtered.has_certain_sign()) {
    EXPECT_EQ(sign_of(filtered), sgn(exact)) << "degree " << degree;
  }
  ++(filtered.has_certain_sign() ? counts.certain : counts.uncertain);
  if (sgn(exact) != 0 && sign_of(filtered) != sgn(exact)) ++counts.wrong_in_doubles;
  if (points.grid_bits() > bits) return;
  EXPECT_EQ(sign_of(polynomial.template operator()<Integer128>()), sgn(exact)) << "degree " << degree;
  ++counts.in_128_bits;
}

template <class N>
Ratio<N> squared_diameter(const Points& points, const Simplex& v) {
  const auto [center, denominator] = circumcenter<N>(points, v);
  return {dot(center, center), denominator * denominator};
}

Counts compare_all(const std::vector<Row>& rows) {
  const std::string path = testing::TempDir() + "proof_filter_test.f64";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(rows.data()), static_cast<std::streamsize>(rows.size() * sizeof(Row)));
  const Points points(path);
  std::remove(path.c_str());
  Counts counts;
  const auto compare_sphere = [&](int degree, const Simplex& v, Id x) {
    compare(
        points, degree, 18,
        [&]<class N>() {
          const auto [numerator, denominator] = circumcenter<N>(points, v);
          const auto y = points.vector<N>(v[0], x);
          return denominator * dot(y, y) - dot(numerator, y);
        },
        counts);
  };
  for (Id p = 0; p + 4 < rows.size(); ++p) {
    compare_sphere(2, {p, p + 1, kNone, kNone}, p + 2);
    compare_sphere(6, {p, p + 1, p + 2, kNone}, p + 3);
    compare_sphere(5, {p, p + 1, p + 2, p + 3}, p + 4);
    const auto volume = [&]<class N>() { return circumcenter<N>(points, {p, p + 1, p + 2, p + 3}).denominator; };
    compare(points, 3, 18, volume, counts);
    const auto order = [&]<class N>() {
      return squared_diameter<N>(points, {p, p + 1, p + 2, p + 3})
          .less(squared_diameter<N>(points, {p, p + 1, p + 2, p + 4}));
    };
    compare(points, 14, 6, order, counts);
  }
  return counts;
}

// Points of a sphere, or of a circle in one plane, times 2^exponent, each coordinate off by up to one in units of
// 2^-bits.
std::vector<Row> near_sphere(std::mt19937_64& random, int exponent, int bits) {
  std::vector<Row> sphere, rows;
  const int flat = random() % 3 == 0 ? 0 : 3;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -flat; z <= flat; ++z) {
        if (x * x + y * y + z * z == (flat == 0 ? 5 : 9)) sphere.push_back({double(x), double(y), double(z)});
      }
    }
  }
  for (int k = 0; k < 7; ++k) {
    Row row = sphere[random() % sphere.size()];
    for (double& x : row) x = std::ldexp(x + std::ldexp(static_cast<double>(random() % 3) - 1, -bits), exponent);
    rows.push_back(row);
  }
  return rows;
}

TEST(ProofFilter, IsRightAtEveryScaleOfDoubles) {
  std::mt19937_64 random(45);
  for (const int exponent : {0, -500, 500, 1000, -1000, -1022, -1072}) {
    for (const int bits : {3, 14, 30, 45, 50}) {
      Counts sum;
      for (int round = 0; round < 40; ++round) {
        const Counts counts = compare_all(near_sphere(random, exponent, bits));
        sum.certain += counts.certain, sum.uncertain += counts.uncertain;
        sum.wrong_in_doubles += counts.wrong_in_doubles, sum.in_128_bits += counts.in_128_bits;
      }
      EXPECT_GT(sum.certain, 0);
      EXPECT_GT(sum.uncertain, 0);
      if (bits > 14 && exponent > -1072) {
        EXPECT_GT(sum.wrong_in_doubles, 0) << exponent << " " << bits;
      }
      EXPECT_EQ(sum.in_128_bits > 0, bits <= 14 || exponent == -1072) << exponent << " " << bits;
    }
  }
}

// Differences of coordinates are so small, beside a coordinate near 1, that products of them underflow.
TEST(ProofFilter, IsRightWhereProductsUnderflow) {
  std::mt19937_64 random(46);
  int certain = 0, uncertain = 0, wrong_in_doubles = 0;
  for (const int exponent : {-60, -120, -150, -180, -215, -270, -358, -540, -1000}) {
    for (int round = 0; round < 40; ++round) {
      std::vector<Row> rows = near_sphere(random, exponent, 3);
      rows.push_back({0.75, 0.5, -0.25});
      const Counts counts = compare_all(rows);
      certain += counts.certain, uncertain += counts.uncertain, wrong_in_doubles += counts.wrong_in_doubles;
    }
  }
  EXPECT_GT(certain, 1000);
  EXPECT_GT(uncertain, 1000);
  EXPECT_GT(wrong_in_doubles, 1000);
}

}  // namespace
