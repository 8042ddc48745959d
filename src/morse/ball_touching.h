// The centres from which the balls of a simplex are equally far, as functions of that distance s.
//
// Guarantees: exact in rationals, and bounded in BoundedDouble. A function is a template over the number, so that one
// formula serves both. Lengths are in units of BallSet::scale().
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/ball_set.h"
#include "flowcert/quadratic_number.h"
#include "geometry/bounded_double.h"
#include "geometry/sized_double.h"
#include "geometry/vector3.h"
#include "morse/layer.h"

namespace flowcert::morse {

using geometry::BoundedDouble;
using geometry::SizedDouble;
using geometry::Vector3;

// A ball in a number type.
template <class Number>
struct NumberBall {
  Vector3<Number> center;
  Number radius;
};
template <class Number>
[[nodiscard]] NumberBall<Number> number_ball(const BallSet& balls, std::uint32_t id);
template <>
[[nodiscard]] inline NumberBall<Rational> number_ball<Rational>(const BallSet& balls, std::uint32_t id) {
  const auto& [x, y, z, r] = balls.scaled(id);
  return {{x, y, z}, r};
}
template <>
[[nodiscard]] inline NumberBall<BoundedDouble> number_ball<BoundedDouble>(const BallSet& balls, std::uint32_t id) {
  const auto& [x, y, z, r] = balls.rounded(id);
  if (balls.are_doubles()) return {{x, y, z}, r};
  return {{geometry::rounded(x), geometry::rounded(y), geometry::rounded(z)}, geometry::rounded(r)};
}

// x(s) = p + a + s b for the first ball's centre p. |x - p|^2 - (r + s)^2 = c2 s^2 + 2 c1 s + c0. The weights of the
// other centres are u[k] + s v[k].
template <class Number>
struct Touching {
  Vector3<Number> a, b;
  std::array<Number, 3> u{}, v{};
  Number c2, c1, c0;
};

// The inverse of a positive number, and of one in doubles whose sign is certain.
template <class Number>
[[nodiscard]] std::optional<Number> inverse_of(const Number& x) {
  if constexpr (std::is_same_v<Number, SizedDouble>) {
    const double least = std::fabs(x.value());
    if (!(least > geometry::kSizedDoubleDivisor * x.size())) return std::nullopt;
    return SizedDouble(1 / x.value(), x.size() / least / least);
  } else {
    if constexpr (std::is_same_v<Number, BoundedDouble>) {
      if (x.certain_sign() == 0) return std::nullopt;
    } else {
      if (x == 0) return std::nullopt;
    }
    return Number(1) / x;
  }
}

template <class Number>
void add_power(Touching<Number>& made, const Number& r) {
  made.c2 = dot(made.b, made.b) - Number(1);
  made.c1 = dot(made.a, made.b) - r;
  made.c0 = dot(made.a, made.a) - r * r;
}

// Of two to four balls whose centres are affinely independent; nothing where they are not, or are not certainly so.
template <class Number>
[[nodiscard]] std::optional<Touching<Number>> touching(std::span<const NumberBall<Number>> balls) {
  const std::size_t count = balls.size() - 1;
  std::array<Vector3<Number>, 3> e;
  std::array<Number, 3> one, other;  // <x - p, e> = one + s other
  const Number r = balls[0].radius;
  for (std::size_t k = 0; k < count; ++k) {
    e[k] = balls[k + 1].center - balls[0].center;
    const Number& q = balls[k + 1].radius;
    one[k] = (dot(e[k], e[k]) + (r - q) * (r + q)) * Number(0.5);
    other[k] = r - q;
  }
  Touching<Number> made;
  if (count == 1) {
    const auto inverse = inverse_of<Number>(dot(e[0], e[0]));
    if (!inverse) return std::nullopt;
    made.u[0] = one[0] * *inverse;
    made.v[0] = other[0] * *inverse;
    made.a = made.u[0] * e[0];
    made.b = made.v[0] * e[0];
  } else if (count == 2) {
    const Number aa = dot(e[0], e[0]), ab = dot(e[0], e[1]), bb = dot(e[1], e[1]);
    const Vector3<Number> n = cross(e[0], e[1]);
    const auto inverse = inverse_of<Number>(dot(n, n));
    if (!inverse) return std::nullopt;
    const auto solve = [&](const std::array<Number, 3>& right, std::array<Number, 3>& weights) {
      weights[0] = (right[0] * bb - right[1] * ab) * *inverse;
      weights[1] = (right[1] * aa - right[0] * ab) * *inverse;
      return weights[0] * e[0] + weights[1] * e[1];
    };
    made.a = solve(one, made.u);
    made.b = solve(other, made.v);
  } else {
    const std::array<Vector3<Number>, 3> dual{cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])};
    const auto inverse = inverse_of<Number>(dot(e[0], dual[0]));
    if (!inverse) return std::nullopt;
    const auto solve = [&](const std::array<Number, 3>& right, std::array<Number, 3>& weights) {
      const Vector3<Number> x = *inverse * (right[0] * dual[0] + right[1] * dual[1] + right[2] * dual[2]);
      for (std::size_t k = 0; k < 3; ++k) weights[k] = dot(x, dual[k]) * *inverse;
      return x;
    };
    made.a = solve(one, made.u);
    made.b = solve(other, made.v);
  }
  add_power(made, r);
  return made;
}

// Where the power is 0, in the order of roots_of(): nothing unless there are certainly two such places. One is the sum
// of two numbers of one sign, and the other one comes by the product of both.
struct BoundedRoots {
  int discriminant = 0;  // its sign where that is certain
  std::optional<std::array<BoundedDouble, 2>> both;
};
[[nodiscard]] inline BoundedRoots bounded_roots(const Touching<BoundedDouble>& made) {
  const BoundedDouble discriminant = made.c1 * made.c1 - made.c2 * made.c0;
  BoundedRoots roots{discriminant.certain_sign(), std::nullopt};
  if (roots.discriminant <= 0 || made.c2.certain_sign() == 0) return roots;
  const BoundedDouble root = sqrt(discriminant);
  const bool is_first = made.c1.value >= 0;
  const BoundedDouble top = is_first ? -made.c1 - root : root - made.c1;
  if (top.certain_sign() == 0) return roots;
  const BoundedDouble by_sum = top / made.c2, by_product = made.c0 / top;
  roots.both = is_first ? std::array{by_sum, by_product} : std::array{by_product, by_sum};
  return roots;
}

// A ball as touching() and lead() take it. Sizes do not tell that differences are exact, so that the origin is the
// first centre there. Of integers of up to 2^60 no term under- or overflows: all of them have less than 17 such factors.
template <class Number>
[[nodiscard]] NumberBall<Number> ball_from(const BallSet& balls, std::uint32_t origin, std::uint32_t id) {
  if constexpr (std::is_same_v<Number, SizedDouble>) {
    constexpr double kGreatest = 0x1p60;
    const std::array<double, 4>&from = balls.rounded(origin), &to = balls.rounded(id);
    const auto way = [&](std::size_t k) {
      const double sum = std::fabs(to[k]) + std::fabs(from[k]);
      const double difference = to[k] - from[k];
      if (!(sum < kGreatest && to[3] < kGreatest)) return SizedDouble(difference, HUGE_VAL);
      return balls.are_doubles() ? SizedDouble(difference) : SizedDouble(difference, sum);
    };
    return {{way(0), way(1), way(2)}, to[3]};
  } else {
    return number_ball<Number>(balls, id);
  }
}

template <class Number>
[[nodiscard]] std::optional<Touching<Number>> touching(const BallSet& balls, std::span<const std::uint32_t> ids) {
  std::array<NumberBall<Number>, 4> some;
  for (std::size_t k = 0; k < ids.size(); ++k) some[k] = ball_from<Number>(balls, ids[0], ids[k]);
  return touching<Number>(std::span<const NumberBall<Number>>(some.data(), ids.size()));
}

}  // namespace flowcert::morse
