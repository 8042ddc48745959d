// The numbers in which signs are computed, and vectors of them.
//
// Every sign is that of a polynomial in differences of coordinates. It is written once, over a number type N, and
// computed in doubles with a bound on the error (Filtered); where that does not tell the sign, in integers. All of them
// are homogeneous: doubles, which are scaled, and integers, in units of a grid, have one sign.
//
// The bound. Beside its value, a Filtered has the same polynomial of absolute values, with a plus for each minus: its
// magnitude. Count roundings like this: a difference of coordinates has 1, a sum or difference 1 more than the greater
// of its sides, a product 1 more than both together. No polynomial here has more than 60 (the order of two radii, with
// most, has 46). So, where u = 2^-53, each monomial is multiplied by a factor between (1-u)^60 and (1+u)^60, in the
// value as in the magnitude: |value - exact value| <= ((1+u)^60 - 1) / (1-u)^60 * magnitude < 2^-47 * magnitude.
// Coordinates are scaled by a power of two to less than 1, so differences are below 2, and all magnitudes below 2^60
// (with two radii, below 2^31). Scaling and products may underflow, by at most 2^-1074 each time. There are fewer than
// 2^9 of these in a polynomial. What follows multiplies each by less than 2^60: together they add less than 2^-900.
#pragma once

#include <gmpxx.h>

#include <cmath>

#include "verdict.h"

struct Filtered {
  double value, magnitude;
  Filtered(double exact = 0) : Filtered(exact, std::fabs(exact)) {}
  Filtered(double v, double m) : value(v), magnitude(m) {}
  friend Filtered operator+(Filtered a, Filtered b) { return {a.value + b.value, a.magnitude + b.magnitude}; }
  friend Filtered operator-(Filtered a, Filtered b) { return {a.value - b.value, a.magnitude + b.magnitude}; }
  friend Filtered operator*(Filtered a, Filtered b) { return {a.value * b.value, a.magnitude * b.magnitude}; }
  bool has_certain_sign() const { return std::fabs(value) > 0x1p-47 * magnitude + 0x1p-900; }
};
using Integer128 = __int128;
struct BigInteger {  // GMP's, with operations that return numbers, and not expressions
  mpz_class value;
  friend BigInteger operator+(BigInteger a, const BigInteger& b) { return {std::move(a.value += b.value)}; }
  friend BigInteger operator-(BigInteger a, const BigInteger& b) { return {std::move(a.value -= b.value)}; }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) { return {a.value * b.value}; }
};
inline int sign_of(Filtered x) { return x.value < 0 ? -1 : 1; }  // if it is certain
inline int sign_of(Integer128 x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
inline int sign_of(const BigInteger& x) { return sgn(x.value); }

template <class N>
struct Vector {
  N x, y, z;
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator*(const Vector& a, const N& k) { return {a.x * k, a.y * k, a.z * k}; }
  friend N dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

// Nothing is decided unless doubles are rounded once, to the nearest, ties to even, and subnormals are kept. All is
// volatile, so that the processor rounds, and not the compiler.
inline void test_rounding() {
  volatile double one = 1, half_unit = 0x1p-53, above_half = 0x1p-53 + 0x1p-80, near_unit = 0x1p-52 - 0x1p-56;
  volatile double near_one = 1 + 0x1p-30, square = 1 + 0x1p-29, least_normal = 0x1p-1022, half = 0.5;
  const bool is_even_at_ties = one + half_unit == 1 && one + 3 * half_unit == 1 + 0x1p-51;
  const bool is_nearest = one + near_unit == 1 + 0x1p-52 && -one - near_unit == -1 - 0x1p-52;
  const bool is_once = one + above_half == 1 + 0x1p-52 && near_one * near_one - square == 0;
  const bool is_right = is_even_at_ties && is_nearest && is_once && least_normal * half == 0x1p-1023;
  if (!is_right) cannot_decide("doubles are not rounded as the bound needs it");
}
