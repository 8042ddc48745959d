#include "morse/ball_level.h"

namespace flowcert::morse {

namespace {

// A sum that is nearer than this share of it needs no exact digits. It is a matter of speed alone.
constexpr double kGoodShare = 0x1p-40;

}  // namespace

BoundedDouble bounded(const Rational& number) { return geometry::rounded(nearest_or_infinity(number)); }
BoundedDouble bounded(const QuadraticNumber& number) {
  if (number.b == 0) return bounded(number.a);
  const BoundedDouble sum = bounded(number.a) + bounded(number.b) * sqrt(bounded(number.d));
  if (sum.error <= std::fabs(sum.value) * kGoodShare) return sum;
  return geometry::rounded(nearest_or_infinity(number));
}

const QuadraticNumber& BallLevel::exact(const BallSet& balls) const {
  if (exact_) return *exact_;
  if (count_ == 5) {
    const std::span<const std::uint32_t> four(balls_.data(), 4);
    const auto made = *touching<Rational>(balls, four);
    const auto [first, second] =
        lead(made, number_ball<Rational>(balls, balls_[0]), number_ball<Rational>(balls, balls_[4]));
    exact_ = QuadraticNumber(Rational(-first / second));
  } else {
    const auto made = *touching<Rational>(balls, std::span<const std::uint32_t>(balls_.data(), count_));
    exact_ = roots_of({made.c2, made.c1, made.c0})[root_];
  }
  return *exact_;
}

std::strong_ordering compare(const BallSet& balls, const BallLevel& x, const BallLevel& y) {
  const int sign = (x.near() - y.near()).certain_sign();
  if (sign != 0) return sign <=> 0;
  return x.exact(balls) <=> y.exact(balls);
}

}  // namespace flowcert::morse
