// The three edge vectors are seen from vertex 0; the bounds are those of a whole cell in filter_bounds.h.
#include "geometry/tetrahedron_signs.h"

#include <cmath>

#include "geometry/contract.h"
#include "geometry/integer_grid.h"
#include "geometry/tetrahedron_forms.h"

namespace flowcert::geometry {

namespace {

constexpr unsigned kCorners[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

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
// In the order of the facets.
std::array<Sign, 4> sides_of(const SmallVectors& v) {
  std::array<Sign, 4> signs{};
  const auto sides = cell_sides(circumsphere(v[0], v[1], v[2]));
  for (std::size_t facet = 0; facet < sides.size(); ++facet) signs[facet] = sign_of(sides[facet]);
  return signs;
}

// A cell some of whose signs the filter does not know. The integers are made once for all of them.
class ExactCell {
 public:
  explicit ExactCell(const TetrahedronPoints& points) : points_(points) {
    const std::optional<SmallVectors> small = small_vectors(points);
    if (!small) return;
    const auto& [a, b, c] = *small;
    angles_ = cell_angles(dot(a, a), dot(b, b), dot(c, c), dot(a, b), dot(b, c), dot(c, a));
    sides_ = sides_of(*small);
    is_small_ = true;
  }

  // In the order of kAngleBits.
  [[nodiscard]] Sign angle(std::size_t k) const {
    return is_small_ ? sign_of(angles_[k]) : angle_exactly(points_, kAngleBits[k] / 4, kAngleBits[k] % 4);
  }
  [[nodiscard]] Sign side(unsigned facet) const { return is_small_ ? sides_[facet] : side_exactly(points_, facet); }

 private:
  const TetrahedronPoints& points_;
  bool is_small_ = false;
  CellAngles<SmallInteger> angles_{};
  std::array<Sign, 4> sides_{};
};

void resolve_angles(const ExactCell& cell, const CellForms<double>& forms, TetrahedronSigns& signs,
                    FilterTally& tally) {
  for (std::size_t k = 0; k < forms.angles.size(); ++k) {
    if (is_certain(forms.angles[k], forms.angle_error) != 0) continue;
    ++tally[Predicate::kAngle].failures;
    const Sign sign = cell.angle(k);
    const unsigned mask = 1u << kAngleBits[k];
    signs.angle_negative = static_cast<std::uint16_t>(sign == Sign::kNegative ? signs.angle_negative | mask
                                                                              : signs.angle_negative & ~mask);
    if (sign == Sign::kZero) signs.angle_zero = static_cast<std::uint16_t>(signs.angle_zero | mask);
  }
}

void resolve_sides(const ExactCell& cell, const CellForms<double>& forms, TetrahedronSigns& signs, FilterTally& tally) {
  for (unsigned facet = 0; facet < 4; ++facet) {
    if (is_certain(forms.sides[facet], forms.side_errors[facet]) != 0) continue;
    ++tally[Predicate::kSideOfPlane].failures;
    const auto bit = static_cast<std::uint8_t>(1u << facet);
    signs.side_negative = static_cast<std::uint8_t>(signs.side_negative & ~bit);
    if (signs.is_obtuse(facet)) {
      signs.side_open |= bit;
      continue;
    }
    const Sign sign = cell.side(facet);
    if (sign == Sign::kNegative) signs.side_negative |= bit;
    if (sign == Sign::kZero) signs.side_zero |= bit;
  }
}

}  // namespace

TetrahedronSigns tetrahedron_signs(const TetrahedronPoints& points, CellSphere& sphere, FilterTally& tally) {
  FLOWCERT_REQUIRES(unfiltered_sign(Orientation{*points[0], *points[1], *points[2], *points[3]}) == Sign::kPositive);
  const CellForms<double> forms =
      cell_forms(vector_between(*points[0], *points[1]), vector_between(*points[0], *points[2]),
                 vector_between(*points[0], *points[3]));
  sphere = forms.sphere;
  tally[Predicate::kAngle].calls += forms.angles.size();
  tally[Predicate::kSideOfPlane].calls += forms.sides.size();

  TetrahedronSigns signs{};
  bool all_certain = true;  // written so that NaN, from an overflow, is not certain
  for (std::size_t k = 0; k < forms.angles.size(); ++k) {
    const unsigned negative = forms.angles[k] < 0 ? 1u : 0u;
    signs.angle_negative = static_cast<std::uint16_t>(signs.angle_negative | negative << kAngleBits[k]);
    all_certain &= is_certain(forms.angles[k], forms.angle_error) != 0;
  }
  for (unsigned facet = 0; facet < 4; ++facet) {
    const unsigned negative = forms.sides[facet] < 0 ? 1u : 0u;
    signs.side_negative = static_cast<std::uint8_t>(signs.side_negative | negative << facet);
    all_certain &= is_certain(forms.sides[facet], forms.side_errors[facet]) != 0;
  }
  if (all_certain) return signs;
  const ExactCell exact(points);
  resolve_angles(exact, forms, signs, tally);
  resolve_sides(exact, forms, signs, tally);
  return signs;
}

Sign side_exactly(const TetrahedronPoints& points, unsigned facet) {
  const unsigned* f = kCorners[facet];
  return unfiltered_sign(SideOfPlane{*points[f[0]], *points[f[1]], *points[f[2]], *points[facet]});
}

bool on_sphere(const TetrahedronPoints& points, const CellSphere& sphere, const Point& q, FilterTally& tally) {
  FilterCount& count = tally[Predicate::kCospherical];
  ++count.calls;
  if (compare_sphere(sphere, vector_between(*points[0], q)).is_beyond_bound != 0) return false;
  ++count.failures;
  return unfiltered_sign(OutsideSphere{*points[0], *points[1], *points[2], *points[3], q}) == Sign::kZero;
}

}  // namespace flowcert::geometry
