#include "geometry/distance_order.h"

#include <algorithm>
#include <cmath>

#include "flowcert/sphere.h"
#include "geometry/filter_bounds.h"

namespace flowcert::geometry {

DistanceOrder::DistanceOrder(const RationalPoint& x) : x_(x), rounded_(rounded_point(x)) {
  largest_ = greatest_coordinate(rounded_);
}

double DistanceOrder::rounded_distance(const Point& p) const {
  const double dx = p.x - rounded_.x, dy = p.y - rounded_.y, dz = p.z - rounded_.z;
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

double DistanceOrder::reach(double distance) const {
  const double bound =
      distance * (1 + kDistanceBound * kUnitRoundoff) + kPositionBound * kUnitRoundoff * largest_ + kDistanceUnderflow;
  return bound > kLargestDistance ? HUGE_VAL : bound;
}

Sign DistanceOrder::compare(const Point& p, const Point& q) const {
  const double to_p = rounded_distance(p), to_q = rounded_distance(q);
  if (to_p > reach(to_q)) return Sign::kPositive;
  if (to_q > reach(to_p)) return Sign::kNegative;
  // |x - p|^2 - |x - q|^2 = <p - q, p + q - 2 x>
  const auto term = [](const Rational& x, double a, double b) {
    return a == b ? Rational(0) : Rational((Rational(a) - Rational(b)) * (Rational(a) + Rational(b) - 2 * x));
  };
  return sign_of(Rational(term(x_[0], p.x, q.x) + term(x_[1], p.y, q.y) + term(x_[2], p.z, q.z)));
}

}  // namespace flowcert::geometry
