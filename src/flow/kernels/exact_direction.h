// The direction in which a moving point lies, in integers: the maps of direction.h without rounding.
//
// Guarantees: exact, up to a positive factor. Each step may take its samples on a grid of its own, because its map is
// homogeneous in them. An integer direction grows by the bits of two coordinates a step, and by no more: there is no
// greatest common divisor, no weight and no division.
#pragma once

#include <array>

#include "flow/kernels/direction.h"
#include "flowcert/rational.h"
#include "geometry/contract.h"
#include "geometry/integer_grid.h"
#include "geometry/rational_point.h"

namespace flowcert::flow {

using geometry::BigInteger;
using IntegerDirection = Vector3<BigInteger>;

// A common power of two does not change a direction, so it is taken out.
[[nodiscard]] inline IntegerDirection without_twos(IntegerDirection u) {
  mp_bitcnt_t twos = ~mp_bitcnt_t{0};
  for (const BigInteger* part : {&u.x, &u.y, &u.z}) {
    if (*part != 0) twos = std::min(twos, mpz_scan1(part->backend().data(), 0));
  }
  if (twos == 0 || twos == ~mp_bitcnt_t{0}) return u;
  for (BigInteger* part : {&u.x, &u.y, &u.z}) *part >>= twos;
  return u;
}

[[nodiscard]] inline IntegerDirection exact_direction_from_vertex(const std::array<const Point*, 4>& v,
                                                                  FacetEdge facet) {
  const geometry::IntegerGrid grid(std::array{v[0], v[1], v[2], v[3], facet.p0, facet.p1});
  const auto between = [&](const Point& from, const Point& to) { return grid.vector_between<BigInteger>(from, to); };
  const auto sphere = geometry::circumsphere(between(*v[0], *v[1]), between(*v[0], *v[2]), between(*v[0], *v[3]));
  FLOWCERT_REQUIRES(sphere.determinant > 0);
  const IntegerDirection w = between(*facet.p0, *v[0]) + between(*facet.p1, *v[0]);
  return without_twos(sphere.numerator + sphere.determinant * w);
}

[[nodiscard]] inline IntegerDirection exact_direction_from_circle(const std::array<const Point*, 3>& v,
                                                                  FacetEdge facet) {
  const geometry::IntegerGrid grid(std::array{v[0], v[1], v[2], facet.p0, facet.p1});
  const auto between = [&](const Point& from, const Point& to) { return grid.vector_between<BigInteger>(from, to); };
  const IntegerDirection a = between(*v[0], *v[1]), b = between(*v[0], *v[2]), n = cross(a, b);
  const IntegerDirection w = between(*facet.p0, *v[0]) + between(*facet.p1, *v[0]);
  return without_twos(BigInteger(dot(n, n)) * w + cross(BigInteger(dot(a, a)) * b - BigInteger(dot(b, b)) * a, n));
}

[[nodiscard]] inline IntegerDirection exact_direction_from_position(const RationalPoint& x, FacetEdge facet) {
  const RationalPoint u = Rational(2) * x - exact_position(*facet.p0) - exact_position(*facet.p1);
  const BigInteger common = lcm(BigInteger(lcm(denominator(u[0]), denominator(u[1]))), BigInteger(denominator(u[2])));
  const auto scaled = [&](const Rational& value) {
    return BigInteger(numerator(value) * BigInteger(common / denominator(value)));
  };
  return without_twos({scaled(u[0]), scaled(u[1]), scaled(u[2])});
}

// What one neighbour of a facet is to a direction, all on the neighbour's own grid.
struct ExactBisector {
  ExactBisector(FacetEdge facet, const Point& q) : grid(std::array{facet.p0, facet.p1, &q}) {
    const auto a = grid.vector_between<BigInteger>(*facet.p0, q), b = grid.vector_between<BigInteger>(*facet.p1, q);
    g = a + b;
    h = dot(a, b);
  }

  geometry::IntegerGrid grid;
  IntegerDirection g;
  BigInteger h;
};

[[nodiscard]] inline IntegerDirection exact_direction_across(const IntegerDirection& u, FacetEdge from, const Point& q,
                                                             FacetEdge to) {
  const geometry::IntegerGrid grid(std::array{from.p0, from.p1, &q, to.p0, to.p1});
  const auto between = [&](const Point& one, const Point& other) {
    return grid.vector_between<BigInteger>(one, other);
  };
  const IntegerDirection a = between(*from.p0, q), b = between(*from.p1, q);
  const BigInteger approach = dot(u, a + b), height = 2 * dot(a, b);
  const IntegerDirection drop = between(*to.p0, *from.p0) + between(*to.p1, *from.p1);
  IntegerDirection next = approach * drop + height * u;
  // A ray that is parallel to the bisector does not cross it, so one of the two is not zero.
  FLOWCERT_REQUIRES(approach != 0);
  if (approach < 0) next = BigInteger(-1) * next;
  return without_twos(next);
}

// RayAtInfinity.
[[nodiscard]] inline Sign exact_approach_sign(const IntegerDirection& u, FacetEdge facet, const Point& q) {
  return geometry::sign_of(BigInteger(dot(u, ExactBisector(facet, q).g)));
}

// OrderOfExits.
[[nodiscard]] inline Sign exact_order_sign(const IntegerDirection& u, FacetEdge facet, const Point& qi,
                                           const Point& qj) {
  const geometry::IntegerGrid grid(std::array{facet.p0, facet.p1, &qi, &qj});
  const auto between = [&](const Point& one, const Point& other) {
    return grid.vector_between<BigInteger>(one, other);
  };
  const IntegerDirection ai = between(*facet.p0, qi), bi = between(*facet.p1, qi);
  const IntegerDirection aj = between(*facet.p0, qj), bj = between(*facet.p1, qj);
  return geometry::sign_of(BigInteger(dot(aj, bj) * dot(u, ai + bi) - dot(ai, bi) * dot(u, aj + bj)));
}

// AlongEdge, of the direction before the crossing.
[[nodiscard]] inline Sign exact_normal_sign(const IntegerDirection& u, const Point& a, const Point& b, const Point& c) {
  const geometry::IntegerGrid grid(std::array{&a, &b, &c});
  const auto between = [&](const Point& one, const Point& other) {
    return grid.vector_between<BigInteger>(one, other);
  };
  return geometry::sign_of(BigInteger(dot(u, cross(between(a, b), between(a, c)))));
}

}  // namespace flowcert::flow
