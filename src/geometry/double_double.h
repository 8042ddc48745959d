// Numbers of twice a double's precision: the unevaluated sum of two doubles. The type of these parts is a parameter, so
// that the terms of spec/proofs/ are what the code computes.
//
// Guarantees: the relative error of a sum, a product, a quotient and a root is below 2^-102, while nothing overflows
// and the low parts do not underflow. The sum and the product of two doubles are exact. Both are machine-checked
// (spec/proofs/filters/DoubleDouble.v). With u = 2^-53, 2^-102 is 16 u^2, and the four need 7, 9, 15 and 5 u^2 there.
// What is proved by hand is no larger:
//   x + y   3 u^2 / (1 - 4u): algorithm 6 (AccurateDWPlusDW) of Joldes, Muller, Popescu: Tight and rigorous error
//           bounds for basic building blocks of double-word arithmetic, 2017
//   x y     7 u^2: algorithm 10 (DWTimesDW1) there
//   x / y   15 u^2: below, because it is none of the algorithms there
//   sqrt x  5 u^2: below
// Boost.Multiprecision of Debian has no such type, and its floats of 128 bits take ten times as long.
#pragma once

#include <cmath>

namespace flowcert::geometry {

template <class Part>
class DoubledNumber {
 public:
  // More than the relative error of any operation. Whoever uses the type may rely on this, and on no less.
  static constexpr double kRoundoff = 0x1p-102;

  constexpr DoubledNumber() = default;
  constexpr DoubledNumber(Part value) : high_(value) {}  // NOLINT: numbers mix with their parts
  // high is high + low, rounded.
  [[nodiscard]] static constexpr DoubledNumber of_parts(Part high, Part low) { return {high, low}; }

  // a + b
  [[nodiscard]] static constexpr DoubledNumber sum(Part a, Part b) {
    const Part s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  // a b (Dekker: both factors are split into halves of 26 bits)
  [[nodiscard]] static constexpr DoubledNumber product(Part a, Part b) {
    const Part p = a * b;
    const auto [ah, al] = halves(a);
    const auto [bh, bl] = halves(b);
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
  }

  [[nodiscard]] constexpr Part high() const { return high_; }
  [[nodiscard]] constexpr Part low() const { return low_; }
  constexpr explicit operator Part() const { return high_; }

  constexpr DoubledNumber operator-() const { return {-high_, -low_}; }
  friend constexpr DoubledNumber operator+(const DoubledNumber& x, const DoubledNumber& y) {
    const DoubledNumber s = sum(x.high_, y.high_), t = sum(x.low_, y.low_);
    const DoubledNumber v = ordered_sum(s.high_, s.low_ + t.high_);
    return ordered_sum(v.high_, t.low_ + v.low_);
  }
  friend constexpr DoubledNumber operator-(const DoubledNumber& x, const DoubledNumber& y) { return x + -y; }
  friend constexpr DoubledNumber operator*(const DoubledNumber& x, const DoubledNumber& y) {
    const DoubledNumber p = product(x.high_, y.high_);
    return ordered_sum(p.high_, p.low_ + (x.high_ * y.low_ + x.low_ * y.high_));
  }
  // It is algorithm 17 (DWDivDW2), but r = y q is made by algorithm 8 (DWTimesFP2), not by 7. In units of |xh/yh|, up
  // to terms of order u^3, which are less than 100 u^3:
  //   q = xh/yh (1 + e), |e| <= u, so that N = x - y q = xl - xh yl/yh - e xh y/yh is at most 3 u |xh|.
  //   r is y q but for 3 u^2: u^2 for the product yl q, and 2 u^2 for its sum with the low part of yh q. (Both are at
  //   most u |yh q|.)
  //   xh - rh is exact, because rh is between xh/2 and 2 xh (Sterbenz).
  //   xl - rl is at most 2 u |xh|, so its rounding is 2 u^2.
  //   The sum of the two is N but for these, so its rounding is 3 u^2, and that of its quotient by yh 3 u^2.
  //   Divided by yh instead of y, N/y changes by |N/yh| |yl/y|: 3 u^2.
  // The last sum is exact. Together that is 14 u^2.
  friend constexpr DoubledNumber operator/(const DoubledNumber& x, const DoubledNumber& y) {
    const Part quotient = x.high_ / y.high_;
    const DoubledNumber back = product(y.high_, quotient);
    const DoubledNumber r = ordered_sum(back.high_, back.low_ + y.low_ * quotient);
    return ordered_sum(quotient, ((x.high_ - r.high_) + (x.low_ - r.low_)) / y.high_);
  }
  // In units of the root, up to terms of order u^3: root = sqrt(xh) (1 + e), |e| <= u. xh - root^2 is a double, and is
  // exact here. x - root^2 is at most 3 u x. Its rounding makes 3/2 u^2, that of the quotient 3/2 u^2, and the division
  // by 2 root instead of root + sqrt x 9/8 u^2: together 33/8 u^2. (Lefevre, Louvet, Muller, Picot, Rideau: Accurate
  // calculation of Euclidean norms using double-word arithmetic, 2023, have 25/8 u^2.)
  friend DoubledNumber sqrt(const DoubledNumber& x) {
    using std::sqrt;
    if (!(x.high_ > 0)) return {sqrt(x.high_), 0};
    const Part root = sqrt(x.high_);
    const DoubledNumber square = product(root, root);
    return ordered_sum(root, ((x.high_ - square.high_) - square.low_ + x.low_) / (2 * root));
  }
  friend constexpr DoubledNumber abs(const DoubledNumber& x) { return x.high_ < 0 ? -x : x; }

  friend constexpr bool operator==(const DoubledNumber&, const DoubledNumber&) = default;
  friend constexpr bool operator<(const DoubledNumber& x, const DoubledNumber& y) {
    return x.high_ < y.high_ || (x.high_ == y.high_ && x.low_ < y.low_);
  }
  friend constexpr bool operator>(const DoubledNumber& x, const DoubledNumber& y) { return y < x; }
  // A NaN is neither.
  friend constexpr bool operator<=(const DoubledNumber& x, const DoubledNumber& y) { return x < y || x == y; }
  friend constexpr bool operator>=(const DoubledNumber& x, const DoubledNumber& y) { return y <= x; }

 private:
  struct Halves {
    Part high, low;
  };
  static constexpr Halves halves(Part a) {
    const Part c = Part(134217729.0) * a;
    const Part high = c - (c - a);
    return {high, a - high};
  }
  // a + b for |a| >= |b|
  static constexpr DoubledNumber ordered_sum(Part a, Part b) {
    const Part s = a + b;
    return {s, b - (s - a)};
  }
  constexpr DoubledNumber(Part high, Part low) : high_(high), low_(low) {}

  Part high_ = 0, low_ = 0;
};

using DoubleDouble = DoubledNumber<double>;

}  // namespace flowcert::geometry
