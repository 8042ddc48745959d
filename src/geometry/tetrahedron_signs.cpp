// The three edge vectors are seen from vertex 0; the bounds are those of a whole cell in filter_bounds.h.
#include "geometry/tetrahedron_signs.h"

#include <algorithm>
#include <cmath>

#include "geometry/contract.h"
#include "geometry/integer_grid.h"

namespace flowcert::geometry {

namespace {

constexpr unsigned kCorners[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

// This is not double[4], because g++ 12 miscompiles loops over references to such arrays under UBSan.
using PerFacet = std::array<double, 4>;

// The angles in the order of kAngleBits.
template <class Number>
using Angles = std::array<Number, 12>;
constexpr std::array<std::uint8_t, 12> kAngleBits = {
    TetrahedronSigns::angle_bit(3, 0), TetrahedronSigns::angle_bit(2, 0), TetrahedronSigns::angle_bit(1, 0),
    TetrahedronSigns::angle_bit(3, 1), TetrahedronSigns::angle_bit(2, 1), TetrahedronSigns::angle_bit(0, 1),
    TetrahedronSigns::angle_bit(3, 2), TetrahedronSigns::angle_bit(1, 2), TetrahedronSigns::angle_bit(0, 2),
    TetrahedronSigns::angle_bit(2, 3), TetrahedronSigns::angle_bit(1, 3), TetrahedronSigns::angle_bit(0, 3)};

// <v_k - v_j, v_l - v_j> = G_kl - G_jk - G_jl + G_jj of the Gram matrix of a, b, c; v_0 = 0.
template <class Number>
Angles<Number> angles_from(Number aa, Number bb, Number cc, Number ab, Number bc, Number ca) {
  return {ab,      ca,      bc,                     //
          aa - ab, aa - ca, (bc - ab) + (aa - ca),  //
          bb - ab, bb - bc, (ca - ab) + (bb - bc),  //
          cc - ca, cc - bc, (ab - ca) + (cc - bc)};
}

Sign angle_exactly(const TetrahedronPoints& p, unsigned facet, unsigned vertex) {
  const unsigned* corner = kCorners[facet];
  const unsigned k = corner[0] == vertex ? corner[1] : corner[0];
  const unsigned l = corner[2] == vertex ? corner[1] : corner[2];
  return unfiltered_sign(Angle{*p[k], *p[vertex], *p[l]});
}

// The vectors from vertex 0, where they are small integers on a grid. Then the polynomials of the doubles give all
// signs of a cell at once here, too.
using SmallVectors = std::array<Vector3<SmallInteger>, 3>;
std::optional<SmallVectors> small_vectors(const TetrahedronPoints& p) {
  const IntegerGrid grid(p);
  if (!grid.fits_small()) return std::nullopt;
  const auto to = [&](const Point* q) { return grid.vector_between<SmallInteger>(*p[0], *q); };
  return SmallVectors{to(p[1]), to(p[2]), to(p[3])};
}
Angles<SmallInteger> angles_of(const SmallVectors& v) {
  const auto& [a, b, c] = v;
  return angles_from(dot(a, a), dot(b, b), dot(c, c), dot(a, b), dot(b, c), dot(c, a));
}
// In the order of the facets.
std::array<Sign, 4> sides_of(const SmallVectors& v) {
  const Circumsphere<SmallInteger> sphere = circumsphere(v[0], v[1], v[2]);
  const NarrowInteger s1 = dot(sphere.bc, sphere.numerator), s2 = dot(sphere.ca, sphere.numerator),
                      s3 = dot(sphere.ab, sphere.numerator);
  const NarrowInteger s0 = 2 * sphere.determinant * sphere.determinant - s1 - s2 - s3;
  return {sign_of(s0), sign_of(s1), sign_of(s2), sign_of(s3)};
}

void resolve_angles(const TetrahedronPoints& points, const Angles<double>& h, double error, TetrahedronSigns& signs,
                    FilterTally& tally) {
  const std::optional<SmallVectors> small = small_vectors(points);
  const Angles<SmallInteger> exact = small ? angles_of(*small) : Angles<SmallInteger>{};
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (std::fabs(h[k]) > error) continue;
    ++tally[Predicate::kAngle].failures;
    const unsigned bit = kAngleBits[k];
    const Sign sign = small ? sign_of(exact[k]) : angle_exactly(points, bit / 4, bit % 4);
    const unsigned mask = 1u << bit;
    signs.angle_negative = static_cast<std::uint16_t>(sign == Sign::kNegative ? signs.angle_negative | mask
                                                                              : signs.angle_negative & ~mask);
    if (sign == Sign::kZero) signs.angle_zero = static_cast<std::uint16_t>(signs.angle_zero | mask);
  }
}

void set_angles(const TetrahedronPoints& points, const Angles<double>& h, double error, TetrahedronSigns& signs,
                FilterTally& tally) {
  tally[Predicate::kAngle].calls += h.size();
  unsigned negative = 0;
  bool all_certain = true;  // written so that NaN, from an overflow, is not certain
  for (std::size_t k = 0; k < h.size(); ++k) {
    negative |= (h[k] < 0 ? 1u : 0u) << kAngleBits[k];
    all_certain &= std::fabs(h[k]) > error;
  }
  signs.angle_negative = static_cast<std::uint16_t>(negative);
  if (!all_certain) resolve_angles(points, h, error, signs, tally);
}

void resolve_sides(const TetrahedronPoints& points, const PerFacet& value, const PerFacet& error,
                   TetrahedronSigns& signs, FilterTally& tally) {
  const std::optional<SmallVectors> small = small_vectors(points);
  const std::array<Sign, 4> exact = small ? sides_of(*small) : std::array<Sign, 4>{};
  for (unsigned facet = 0; facet < 4; ++facet) {
    if (std::fabs(value[facet]) > error[facet]) continue;
    ++tally[Predicate::kSideOfPlane].failures;
    const auto bit = static_cast<std::uint8_t>(1u << facet);
    signs.side_negative = static_cast<std::uint8_t>(signs.side_negative & ~bit);
    if (signs.is_obtuse(facet)) {
      signs.side_open |= bit;
      continue;
    }
    const Sign sign = small ? exact[facet] : side_exactly(points, facet);
    if (sign == Sign::kNegative) signs.side_negative |= bit;
    if (sign == Sign::kZero) signs.side_zero |= bit;
  }
}

void set_sides(const TetrahedronPoints& points, const PerFacet& value, const PerFacet& error, TetrahedronSigns& signs,
               FilterTally& tally) {
  tally[Predicate::kSideOfPlane].calls += 4;
  unsigned negative = 0;
  bool all_certain = true;
  for (unsigned facet = 0; facet < 4; ++facet) {
    negative |= (value[facet] < 0 ? 1u : 0u) << facet;
    all_certain &= std::fabs(value[facet]) > error[facet];
  }
  signs.side_negative = static_cast<std::uint8_t>(negative);
  if (!all_certain) resolve_sides(points, value, error, signs, tally);
}

}  // namespace

TetrahedronSigns tetrahedron_signs(const TetrahedronPoints& points, CellSphere& sphere, FilterTally& tally) {
  FLOWCERT_REQUIRES(unfiltered_sign(Orientation{*points[0], *points[1], *points[2], *points[3]}) == Sign::kPositive);
  const Vector3<double> a = vector_between(*points[0], *points[1]);
  const Vector3<double> b = vector_between(*points[0], *points[2]);
  const Vector3<double> c = vector_between(*points[0], *points[3]);
  const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  const double na = std::sqrt(aa), nb = std::sqrt(bb), nc = std::sqrt(cc);
  const double smallest = std::min({na, nb, nc});
  const double largest = std::max({na, nb, nc});

  sphere.in_range = smallest >= kSmallestNorm && largest <= kLargestNorm;
  // An infinite bound leaves every sign open.
  const double unit = sphere.in_range ? kUnitRoundoff : HUGE_VAL;

  TetrahedronSigns signs;
  set_angles(points, angles_from(aa, bb, cc, dot(a, b), dot(b, c), dot(c, a)),
             kCellAngleBound * unit * largest * largest, signs, tally);

  const Circumsphere<double> circum = circumsphere(a, b, c);
  sphere.numerator = circum.numerator;
  sphere.determinant = circum.determinant;
  sphere.norm_product = na * nb * nc;
  sphere.norm_sum = na + nb + nc;
  const double t = sphere.norm_product * sphere.norm_sum;
  const double s3 = dot(circum.ab, circum.numerator);
  const double s1 = dot(circum.bc, circum.numerator);
  const double s2 = dot(circum.ca, circum.numerator);
  const double s0 = 2 * circum.determinant * circum.determinant - s1 - s2 - s3;
  const PerFacet value = {s0, s1, s2, s3};
  const PerFacet error = {kFarCellSideBound * unit * t * (na * nb + nb * nc + nc * na),
                          kCellSideBound * unit * t * (nb * nc), kCellSideBound * unit * t * (nc * na),
                          kCellSideBound * unit * t * (na * nb)};
  set_sides(points, value, error, signs, tally);
  return signs;
}

Sign side_exactly(const TetrahedronPoints& points, unsigned facet) {
  const unsigned* f = kCorners[facet];
  return unfiltered_sign(SideOfPlane{*points[f[0]], *points[f[1]], *points[f[2]], *points[facet]});
}

bool on_sphere(const TetrahedronPoints& points, const CellSphere& sphere, const Point& q, FilterTally& tally) {
  FilterCount& count = tally[Predicate::kCospherical];
  ++count.calls;
  const Vector3<double> v = vector_between(*points[0], q);
  const double norm = std::sqrt(dot(v, v));
  if (sphere.in_range && norm >= kSmallestNorm && norm <= kLargestNorm) {
    const double value = OutsideSphere::value(sphere.numerator, sphere.determinant, v);
    if (std::fabs(value) > OutsideSphere::error_bound(sphere.norm_product, sphere.norm_sum, norm)) return false;
  }
  ++count.failures;
  return unfiltered_sign(OutsideSphere{*points[0], *points[1], *points[2], *points[3], q}) == Sign::kZero;
}

}  // namespace flowcert::geometry
