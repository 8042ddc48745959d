// A distance s that a walk over the diagram of balls comes to: a root of a simplex, or where five balls are equally
// far.
//
// Guarantees: the double has a bound, and the exact number is made when it is asked for.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <utility>

#include "flowcert/ball_set.h"
#include "flowcert/quadratic_number.h"
#include "geometry/bounded_double.h"
#include "morse/ball_touching.h"

namespace flowcert::morse {

// near + a bound, from an exact number.
[[nodiscard]] BoundedDouble bounded(const Rational& number);
[[nodiscard]] BoundedDouble bounded(const QuadraticNumber& number);

// How much less near a ball q is than those of `made` at s: |x-q|^2 - (r_q+s)^2 - (|x-p|^2 - (r+s)^2) = first + second
// s, where p is the first ball of `made`.
template <class Number>
[[nodiscard]] std::pair<Number, Number> lead(const Touching<Number>& made, const NumberBall<Number>& p,
                                             const NumberBall<Number>& q) {
  const Vector3<Number> w = q.center - p.center;
  const Number first = dot(w, w) - Number(2) * dot(made.a, w) + (p.radius - q.radius) * (p.radius + q.radius);
  return {first, Number(2) * ((p.radius - q.radius) - dot(made.b, w))};
}

class BallLevel {
 public:
  // A root of the simplex of `count` balls, by its number in roots_of().
  BallLevel(std::array<std::uint32_t, 4> balls, std::size_t count, std::size_t root, BoundedDouble near)
      : balls_{balls[0], balls[1], balls[2], balls[3], 0}, count_(count), root_(root), near_(near) {}
  // Where the fifth ball is as near as the four.
  BallLevel(std::array<std::uint32_t, 4> balls, std::uint32_t fifth, BoundedDouble near)
      : balls_{balls[0], balls[1], balls[2], balls[3], fifth}, near_(near) {}

  [[nodiscard]] const BoundedDouble& near() const { return near_; }
  // Of a root of a simplex.
  [[nodiscard]] std::size_t root() const { return root_; }
  [[nodiscard]] const QuadraticNumber& exact(const BallSet& balls) const;

 private:
  std::array<std::uint32_t, 5> balls_;
  std::size_t count_ = 5, root_ = 0;
  BoundedDouble near_;
  mutable std::optional<QuadraticNumber> exact_;
};

[[nodiscard]] std::strong_ordering compare(const BallSet& balls, const BallLevel& x, const BallLevel& y);

}  // namespace flowcert::morse
