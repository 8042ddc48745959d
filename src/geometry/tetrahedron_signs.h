// All signs of one Delaunay cell at once: its twelve angles, and the sides of its four facets on which its
// circumcentre lies. Three edge vectors give them all. A double filter comes first, and exact arithmetic where that
// fails.
//
// Most of the time of the critical points is spent here, so the signs share their subexpressions (dot products, cross
// products, the centre's numerator). Four sphere predicates would compute these four times. Guarantees: exact.
// Sources: spec clauses FC-SIGN-01, FC-SIGN-03; bounds in filter_bounds.h.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "geometry/condition.h"
#include "geometry/predicates.h"
#include "geometry/vector3.h"

namespace flowcert::geometry {

// Facet i of a cell is the one opposite its vertex i. Bit 4 i + j of a mask, with i != j, is the angle of facet i at
// the cell's vertex j. A facet's mask is thus four neighbouring bits.
struct TetrahedronSigns {
  std::uint16_t angle_negative;
  std::uint16_t angle_zero;
  // Bit i is s of facet i. It is open where the filter failed and nobody has needed the sign yet.
  std::uint8_t side_negative;
  std::uint8_t side_zero;
  std::uint8_t side_open;

  static constexpr unsigned angle_bit(unsigned facet, unsigned vertex) { return 4 * facet + vertex; }
  [[nodiscard]] bool is_obtuse(unsigned facet) const { return ((angle_negative >> (4 * facet)) & 15u) != 0; }
  // The vertex at which the facet has its obtuse angle. It has one at most.
  [[nodiscard]] std::optional<unsigned> obtuse_corner(unsigned facet) const {
    const unsigned angles = (angle_negative >> (4 * facet)) & 15u;
    if (angles == 0) return std::nullopt;
    return static_cast<unsigned>(std::countr_zero(angles));
  }
  [[nodiscard]] Sign angle(unsigned facet, unsigned vertex) const {
    const unsigned bit = angle_bit(facet, vertex);
    if (((angle_negative >> bit) & 1u) != 0) return Sign::kNegative;
    return ((angle_zero >> bit) & 1u) != 0 ? Sign::kZero : Sign::kPositive;
  }
  [[nodiscard]] bool is_right(unsigned facet) const { return ((angle_zero >> (4 * facet)) & 15u) != 0; }
  [[nodiscard]] bool is_acute(unsigned facet) const { return !is_obtuse(facet) && !is_right(facet); }
  // The facets that are not obtuse and have a positive side: bit i.
  [[nodiscard]] unsigned inner_facets() const {
    unsigned obtuse = unsigned{angle_negative} | unsigned{angle_negative} >> 2;
    obtuse = (obtuse | obtuse >> 1) & 0x1111u;
    obtuse |= obtuse >> 3 | obtuse >> 6 | obtuse >> 9;
    return ~(obtuse | side_negative | side_zero | side_open) & 15u;
  }
  [[nodiscard]] bool has_positive_side(unsigned facet) const {
    return (((side_negative | side_zero | side_open) >> facet) & 1u) == 0;
  }
};

// What the cell's filter computed on the way, for the in-sphere tests of its neighbours.
template <class Number>
struct SphereForms {
  Vector3<Number> numerator{};
  Number determinant{};
  Number norm_product{};         // |a||b||c|
  Number norm_sum{};             // |a|+|b|+|c|
  Condition<Number> in_range{};  // the filter's norms are; otherwise nothing here is certain
  Condition<Number> is_exact{};  // nothing here was rounded
};
using CellSphere = SphereForms<double>;

using TetrahedronPoints = std::array<const Point*, 4>;

// The points must be positively oriented and not coplanar. A side is resolved exactly where the facet contains its
// centre (is not obtuse); elsewhere it may stay open.
[[nodiscard]] TetrahedronSigns tetrahedron_signs(const TetrahedronPoints& points, CellSphere& sphere,
                                                 FilterTally& tally);

// The side of one facet, which may be open, by exact arithmetic.
[[nodiscard]] Sign side_exactly(const TetrahedronPoints& points, unsigned facet);

// Whether q lies on the cell's sphere.
[[nodiscard]] bool on_sphere(const TetrahedronPoints& points, const CellSphere& sphere, const Point& q,
                             FilterTally& tally);

}  // namespace flowcert::geometry
