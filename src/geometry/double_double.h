// Numbers of twice a double's precision: the unevaluated sum of two doubles.
//
// Guarantees: with u = 2^-53, a sum has a relative error of at most 3 u^2, a product of 7 u^2, a quotient of 15 u^2 and
// a root of 4 u^2, while nothing overflows and the low parts do not underflow (Joldes, Muller, Popescu: Tight and
// rigorous error bounds for basic building blocks of double-word arithmetic, 2017). The sum of two doubles is exact.
// Boost.Multiprecision of Debian has no such type, and its floats of 128 bits take ten times as long.
#pragma once

#include <cmath>

namespace flowcert::geometry {

class DoubleDouble {
 public:
  // More than the relative error of any operation.
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
  friend constexpr DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double quotient = x.high_ / y.high_;
    const DoubleDouble back = product(y.high_, quotient);
    const DoubleDouble r = ordered_sum(back.high_, back.low_ + y.low_ * quotient);
    return ordered_sum(quotient, ((x.high_ - r.high_) + (x.low_ - r.low_)) / y.high_);
  }
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
