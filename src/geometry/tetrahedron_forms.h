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

struct CellForms {
  // This is not double[4], because g++ 12 miscompiles loops over references to such arrays under UBSan.
  using PerFacet = std::array<double, 4>;

  CellAngles<double> angles;
  double angle_error;
  PerFacet sides, side_errors;
  CellSphere sphere;
};

// a, b, c: the cell's other vertices, seen from vertex 0. If they are on a grid of a power of two, exact_reach is
// kExactReach of its units; otherwise it is 0.
[[nodiscard, gnu::always_inline]] inline CellForms cell_forms(const Vector3<double>& a, const Vector3<double>& b,
                                                              const Vector3<double>& c, double exact_reach = 0) {
  const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  const double na = std::sqrt(aa), nb = std::sqrt(bb), nc = std::sqrt(cc);
  // std::min() is a branch to the compiler, because it returns a reference.
  const auto least = [](double x, double y) __attribute__((always_inline)) { return y < x ? y : x; };
  const auto most = [](double x, double y) __attribute__((always_inline)) { return x < y ? y : x; };
  const double smallest = least(least(na, nb), nc), largest = most(most(na, nb), nc);
  // Conditions are numbers, because && is a branch.
  const int in_range = static_cast<int>(smallest >= kSmallestNorm) & static_cast<int>(largest <= kLargestNorm);
  // An infinite bound leaves every sign open.
  const double unit = in_range != 0 ? kUnitRoundoff : HUGE_VAL;

  const Circumsphere<double> circum = circumsphere(a, b, c);
  const double product = na * nb * nc, sum = na + nb + nc, t = product * sum;
  const double s1 = dot(circum.bc, circum.numerator), s2 = dot(circum.ca, circum.numerator),
               s3 = dot(circum.ab, circum.numerator);
  const double s0 = 2 * circum.determinant * circum.determinant - s1 - s2 - s3;
  const double side_error = kCellSideBound * unit * t;
  return {cell_angles(aa, bb, cc, dot(a, b), dot(b, c), dot(c, a)),
          kCellAngleBound * unit * largest * largest,
          {s0, s1, s2, s3},
          {kFarCellSideBound * unit * t * (na * nb + nb * nc + nc * na), side_error * (nb * nc), side_error * (nc * na),
           side_error * (na * nb)},
          {{circum.numerator.x, circum.numerator.y, circum.numerator.z},
           circum.determinant,
           product,
           sum,
           in_range != 0,
           (in_range & static_cast<int>(largest <= exact_reach)) != 0}};
}

// What the filter decides about a sample and the cell's sphere: 0 or 1 each.
struct SphereAnswer {
  int is_beyond_bound;  // so that the sample does not lie on the sphere
  int is_exact;         // nothing was rounded
  int is_zero;          // the polynomial, which counts where it is exact
};

// v: the sample, seen from vertex 0. exact_reach: as of the cell.
[[nodiscard, gnu::always_inline]] inline SphereAnswer compare_sphere(const CellSphere& sphere, const Vector3<double>& v,
                                                                     double exact_reach = 0) {
  const double norm = std::sqrt(dot(v, v));
  const double value = OutsideSphere::value(sphere.numerator, sphere.determinant, v);
  const int in_range = static_cast<int>(sphere.in_range) & static_cast<int>(norm >= kSmallestNorm) &
                       static_cast<int>(norm <= kLargestNorm);
  const double error = OutsideSphere::error_bound(sphere.norm_product, sphere.norm_sum, norm);
  return {in_range & static_cast<int>(std::fabs(value) > error),
          in_range & static_cast<int>(sphere.is_exact) & static_cast<int>(norm <= exact_reach),
          static_cast<int>(value == 0)};
}

}  // namespace flowcert::geometry
