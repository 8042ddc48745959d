// Numbers of twice a double's precision: the unevaluated sum of two doubles.
//
// Guarantees: the relative error of a sum, a product, a quotient and a root is below 2^-102, while nothing overflows
// and the low parts do not underflow. The sum and the product of two doubles are exact. What is proved, with u = 2^-53
// and 2^-102 = 16 u^2:
//   x + y   3 u^2 / (1 - 4u): algorithm 6 (AccurateDWPlusDW) of Joldes, Muller, Popescu: Tight and rigorous error
//           bounds for basic building blocks of double-word arithmetic, 2017
//   x y     7 u^2: algorithm 10 (DWTimesDW1) there
//   x / y   15 u^2: below, because it is none of the algorithms there
//   sqrt x  5 u^2: below
// Boost.Multiprecision of Debian has no such type, and its floats of 128 bits take ten times as long.
#pragma once

#include <cmath>

namespace flowcert::geometry {

class DoubleDouble {
 public:
  // More than the relative error of any operation. Whoever uses the type may rely on this, and on no less.
  static constexpr double kRoundoff = 0x1p-102;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high_(value) {}  // NOLINT: numbers mix with doubles

  // a + b
  [[nodiscard]] static constexpr DoubleDouble sum(double a, double b) {
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  // a b (Dekker: both factors are split into halves of 26 bits)
  [[nodiscard]] static constexpr DoubleDouble product(double a, double b) {
    const double p = a * b;
    const auto [ah, al] = halves(a);
    const auto [bh, bl] = halves(b);
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
  }

  [[nodiscard]] constexpr double high() const { return high_; }
  [[nodiscard]] constexpr double low() const { return low_; }
  constexpr explicit operator double() const { return high_; }

  constexpr DoubleDouble operator-() const { return {-high_, -low_}; }
  friend constexpr DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble s = sum(x.high_, y.high_), t = sum(x.low_, y.low_);
    const DoubleDouble v = ordered_sum(s.high_, s.low_ + t.high_);
    return ordered_sum(v.high_, t.low_ + v.low_);
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }
  friend constexpr DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble p = product(x.high_, y.high_);
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
  friend constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.high_ / y.high_;
    const DoubleDouble back = product(y.high_, quotient);
    const DoubleDouble r = ordered_sum(back.high_, back.low_ + y.low_ * quotient);
    return ordered_sum(quotient, ((x.high_ - r.high_) + (x.low_ - r.low_)) / y.high_);
  }
  // In units of the root, up to terms of order u^3: root = sqrt(xh) (1 + e), |e| <= u. xh - root^2 is a double, and is
  // exact here. x - root^2 is at most 3 u x. Its rounding makes 3/2 u^2, that of the quotient 3/2 u^2, and the division
  // by 2 root instead of root + sqrt x 9/8 u^2: together 33/8 u^2. (Lefevre, Louvet, Muller, Picot, Rideau: Accurate
  // calculation of Euclidean norms using double-word arithmetic, 2023, have 25/8 u^2.)
  friend DoubleDouble sqrt(const DoubleDouble& x) {
    if (!(x.high_ > 0)) return {std::sqrt(x.high_), 0};
    const double root = std::sqrt(x.high_);
    const DoubleDouble square = product(root, root);
    return ordered_sum(root, ((x.high_ - square.high_) - square.low_ + x.low_) / (2 * root));
  }
  friend constexpr DoubleDouble abs(const DoubleDouble& x) { return x.high_ < 0 ? -x : x; }

  friend constexpr bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
  friend constexpr bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.high_ < y.high_ || (x.high_ == y.high_ && x.low_ < y.low_);
  }
  friend constexpr bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }
  // A NaN is neither.
  friend constexpr bool operator<=(const DoubleDouble& x, const DoubleDouble& y) { return x < y || x == y; }
  friend constexpr bool operator>=(const DoubleDouble& x, const DoubleDouble& y) { return y <= x; }

 private:
  struct Halves {
    double high, low;
  };
  static constexpr Halves halves(double a) {
    const double c = 134217729.0 * a;
    const double high = c - (c - a);
    return {high, a - high};
  }
  // a + b for |a| >= |b|
  static constexpr DoubleDouble ordered_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  constexpr DoubleDouble(double high, double low) : high_(high), low_(low) {}

  double high_ = 0, low_ = 0;
};

}  // namespace flowcert::geometry
