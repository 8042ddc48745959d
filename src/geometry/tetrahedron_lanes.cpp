#include "geometry/tetrahedron_lanes.h"

#include <cmath>
#include <utility>

#include "geometry/tetrahedron_forms.h"

namespace flowcert::geometry {

namespace {

// Loops inside of the loops over lanes would keep these from being wide, so that they are written out.
template <std::size_t... k>
[[gnu::always_inline]] inline double angle_mask(const CellForms& forms, std::index_sequence<k...>) {
  return ((forms.angles[k] < 0 ? double{1u << kAngleBits[k]} : 0.0) + ...);
}
template <std::size_t... k>
[[gnu::always_inline]] inline double side_mask(const CellForms& forms, std::index_sequence<k...>) {
  return ((forms.sides[k] < 0 ? double{1u << k} : 0.0) + ...);
}
// The comparisons are false of NaN.
template <std::size_t... k>
[[gnu::always_inline]] inline double certain_angles(const CellForms& forms, std::index_sequence<k...>) {
  return ((std::fabs(forms.angles[k]) > forms.angle_error ? 1.0 : 0.0) + ...);
}
template <std::size_t... k>
[[gnu::always_inline]] inline double certain_sides(const CellForms& forms, std::index_sequence<k...>) {
  return ((std::fabs(forms.sides[k]) > forms.side_errors[k] ? 1.0 : 0.0) + ...);
}

}  // namespace

inline void TetrahedronLanes::compute_lanes() {
  constexpr std::make_index_sequence<12> kAngles;
  constexpr std::make_index_sequence<4> kSides;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Vector3<double> origin = points_[0].at(lane);
    const CellForms forms =
        cell_forms(points_[1].at(lane) - origin, points_[2].at(lane) - origin, points_[3].at(lane) - origin);
    angles_[lane] = angle_mask(forms, kAngles);
    sides_[lane] = side_mask(forms, kSides);
    unknown_[lane] = 16 - certain_angles(forms, kAngles) - certain_sides(forms, kSides);
    numerator_.put(lane, forms.sphere.numerator);
    determinant_[lane] = forms.sphere.determinant;
    product_[lane] = forms.sphere.norm_product;
    sum_[lane] = forms.sphere.norm_sum;
    in_range_[lane] = forms.sphere.in_range ? 1 : 0;
  }
}

inline void TetrahedronLanes::compare_lanes() {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Vector3<double> origin = points_[0].at(lane);
    const CellSphere sphere = this->sphere(lane);
    const auto off = [&](std::size_t facet) __attribute__((always_inline)) {
      return is_off_sphere(sphere, samples_[facet].at(lane) - origin) != 0;
    };
    off_[lane] = (off(0) ? 1.0 : 0.0) + (off(1) ? 2.0 : 0.0) + (off(2) ? 4.0 : 0.0) + (off(3) ? 8.0 : 0.0);
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2"), gnu::flatten]] void TetrahedronLanes::compute_wide() { compute_lanes(); }
[[gnu::target("avx2"), gnu::flatten]] void TetrahedronLanes::compare_wide() { compare_lanes(); }
bool TetrahedronLanes::processor_has_wide() { return __builtin_cpu_supports("avx2") != 0; }
#else
void TetrahedronLanes::compute_wide() { compute_lanes(); }
void TetrahedronLanes::compare_wide() { compare_lanes(); }
bool TetrahedronLanes::processor_has_wide() { return false; }
#endif

[[gnu::flatten]] void TetrahedronLanes::compute() {
  if (has_wide_) return compute_wide();
  compute_lanes();
}
[[gnu::flatten]] void TetrahedronLanes::compare() {
  if (has_wide_) return compare_wide();
  compare_lanes();
}

}  // namespace flowcert::geometry
