// What the double filter computes of a Delaunay cell: the forms whose signs are wanted, and the bounds of their errors.
// The one cell of tetrahedron_signs.cpp and the lanes of tetrahedron_lanes.cpp share it, so that both give the same
// bits.
//
// Guarantees: a sign is certain where the form's size is above its error. Nothing is certain where the bound is
// infinite or NaN. There is no branch. Source: spec clauses FC-SIGN-01, FC-SIGN-03; bounds in filter_bounds.h.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/condition.h"
#include "geometry/filter_bounds.h"
#include "geometry/tetrahedron_signs.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

// The angles in the order of kAngleBits.
template <class Number>
using CellAngles = std::array<Number, 12>;
inline constexpr std::array<std::uint8_t, 12> kAngleBits = {
    TetrahedronSigns::angle_bit(3, 0), TetrahedronSigns::angle_bit(2, 0), TetrahedronSigns::angle_bit(1, 0),
    TetrahedronSigns::angle_bit(3, 1), TetrahedronSigns::angle_bit(2, 1), TetrahedronSigns::angle_bit(0, 1),
    TetrahedronSigns::angle_bit(3, 2), TetrahedronSigns::angle_bit(1, 2), TetrahedronSigns::angle_bit(0, 2),
    TetrahedronSigns::angle_bit(2, 3), TetrahedronSigns::angle_bit(1, 3), TetrahedronSigns::angle_bit(0, 3)};

// <v_k - v_j, v_l - v_j> = G_kl - G_jk - G_jl + G_jj of the Gram matrix of a, b, c; v_0 = 0.
template <class Number>
[[nodiscard, gnu::always_inline]] inline CellAngles<Number> cell_angles(Number aa, Number bb, Number cc, Number ab,
                                                                        Number bc, Number ca) {
  return {ab,      ca,      bc,                     //
          aa - ab, aa - ca, (bc - ab) + (aa - ca),  //
          bb - ab, bb - bc, (ca - ab) + (bb - bc),  //
          cc - ca, cc - bc, (ab - ca) + (cc - bc)};
}

template <class Number>
struct CellForms {
  // This is not Number[4], because g++ 12 miscompiles loops over references to such arrays under UBSan.
  using PerFacet = std::array<Number, 4>;

  CellAngles<Number> angles;
  Number angle_error;
  PerFacet sides, side_errors;
  SphereForms<Number> sphere;
};

// A form's sign is certain where its size is above its error. Nothing is certain of NaN.
template <class Number>
[[nodiscard, gnu::always_inline]] inline auto is_certain(const Number& form, const Number& error) {
  return condition(absolute(form) > error);
}

// The s of the four facets: twice the square of the determinant times the barycentric coordinates of the centre.
template <class Number>
[[nodiscard, gnu::always_inline]] inline std::array<typename Promoted<Number>::Type, 4> cell_sides(
    const Circumsphere<Number>& sphere) {
  using Wide = typename Promoted<Number>::Type;
  const Wide s1 = dot(sphere.bc, sphere.numerator), s2 = dot(sphere.ca, sphere.numerator),
             s3 = dot(sphere.ab, sphere.numerator);
  return {Wide(2) * sphere.determinant * sphere.determinant - s1 - s2 - s3, s1, s2, s3};
}

// a, b, c: the cell's other vertices, seen from vertex 0. If they are on a grid of a power of two, exact_reach is
// kExactReach of its units; otherwise it is 0.
template <class Number>
[[nodiscard, gnu::always_inline]] inline CellForms<Number> cell_forms(const Vector3<Number>& a,
                                                                      const Vector3<Number>& b,
                                                                      const Vector3<Number>& c,
                                                                      const Number& exact_reach = Number(0)) {
  using std::sqrt;
  const Number aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  const Number na = sqrt(aa), nb = sqrt(bb), nc = sqrt(cc);
  const Number smallest = least(least(na, nb), nc), largest = most(most(na, nb), nc);
  const auto in_range = condition(smallest >= kSmallestNorm) & condition(largest <= kLargestNorm);
  // An infinite bound leaves every sign open.
  const Number unit = select(in_range, Number(kUnitRoundoff), Number(HUGE_VAL));

  const Circumsphere<Number> circum = circumsphere(a, b, c);
  const Number product = na * nb * nc, sum = na + nb + nc, t = product * sum;
  const Number side_error = kCellSideBound * unit * t;
  return {cell_angles<Number>(aa, bb, cc, dot(a, b), dot(b, c), dot(c, a)),
          kCellAngleBound * unit * largest * largest,
          cell_sides(circum),
          {kFarCellSideBound * unit * t * (na * nb + nb * nc + nc * na), side_error * (nb * nc), side_error * (nc * na),
           side_error * (na * nb)},
          {{circum.numerator.x, circum.numerator.y, circum.numerator.z},
           circum.determinant,
           product,
           sum,
           in_range,
           in_range & condition(largest <= exact_reach)}};
}

// What the filter decides about a sample and the cell's sphere.
template <class Number>
struct SphereAnswer {
  Condition<Number> is_beyond_bound;  // so that the sample does not lie on the sphere
  Condition<Number> is_exact;         // nothing was rounded
  Condition<Number> is_zero;          // the polynomial, which counts where it is exact
};

// v: the sample, seen from vertex 0. exact_reach: as of the cell.
template <class Number>
[[nodiscard, gnu::always_inline]] inline SphereAnswer<Number> compare_sphere(const SphereForms<Number>& sphere,
                                                                             const Vector3<Number>& v,
                                                                             const Number& exact_reach = Number(0)) {
  using std::sqrt;
  const Number norm = sqrt(dot(v, v));
  const Number value = OutsideSphere::value(sphere.numerator, sphere.determinant, v);
  const auto in_range = sphere.in_range & condition(norm >= kSmallestNorm) & condition(norm <= kLargestNorm);
  const Number error = OutsideSphere::error_bound(sphere.norm_product, sphere.norm_sum, norm);
  return {in_range & is_certain(value, error), in_range & sphere.is_exact & condition(norm <= exact_reach),
          condition(value == 0)};
}

}  // namespace flowcert::geometry
