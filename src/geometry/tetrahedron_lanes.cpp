#include "geometry/tetrahedron_lanes.h"

#include <cmath>
#include <type_traits>
#include <utility>

#include "geometry/tetrahedron_forms.h"

namespace flowcert::geometry {

namespace {

// Sums over the forms of a cell. Loops inside of the loops over lanes would keep these from being wide, so that they
// are written out.
template <class Term, std::size_t... k>
[[gnu::always_inline]] inline double sum_of(Term term, std::index_sequence<k...>) {
  return (term(std::integral_constant<std::size_t, k>{}) + ...);
}
template <class Term>
[[gnu::always_inline]] inline double over_angles(Term term) {
  return sum_of(term, std::make_index_sequence<12>{});
}
template <class Term>
[[gnu::always_inline]] inline double over_facets(Term term) {
  return sum_of(term, std::make_index_sequence<4>{});
}

constexpr double bit(unsigned place) { return 1u << place; }

}  // namespace

// The comparisons with an error are false of NaN.
template <bool kGrid>
inline void TetrahedronLanes::compute_lanes() {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Vector3<double> origin = points_[0].at(lane);
    const CellForms<double> f = cell_forms(points_[1].at(lane) - origin, points_[2].at(lane) - origin,
                                           points_[3].at(lane) - origin, exact_reach_);
    angles_[lane] = over_angles([&](auto k) { return f.angles[k] < 0 ? bit(kAngleBits[k]) : 0.0; });
    sides_[lane] = over_facets([&](auto k) { return f.sides[k] < 0 ? bit(k) : 0.0; });
    open_angles_[lane] =
        12 - over_angles([&](auto k) { return is_certain(f.angles[k], f.angle_error) != 0 ? 1.0 : 0.0; });
    open_sides_[lane] =
        4 - over_facets([&](auto k) { return is_certain(f.sides[k], f.side_errors[k]) != 0 ? 1.0 : 0.0; });
    if constexpr (kGrid) {
      zero_angles_[lane] = over_angles([&](auto k) { return f.angles[k] == 0 ? bit(kAngleBits[k]) : 0.0; });
      zero_sides_[lane] = over_facets([&](auto k) { return f.sides[k] == 0 ? bit(k) : 0.0; });
      is_exact_[lane] = f.sphere.is_exact != 0 ? 1 : 0;
    }
    numerator_.put(lane, f.sphere.numerator);
    determinant_[lane] = f.sphere.determinant;
    product_[lane] = f.sphere.norm_product;
    sum_[lane] = f.sphere.norm_sum;
    in_range_[lane] = f.sphere.in_range != 0 ? 1 : 0;
  }
}

template <bool kGrid>
inline void TetrahedronLanes::compare_lanes() {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Vector3<double> origin = points_[0].at(lane);
    const CellSphere sphere = this->sphere(lane);
    const auto answer = [&](auto k) __attribute__((always_inline)) {
      return compare_sphere(sphere, samples_[k].at(lane) - origin, exact_reach_);
    };
    off_[lane] = over_facets([&](auto k) { return answer(k).is_beyond_bound != 0 ? bit(k) : 0.0; });
    if constexpr (kGrid) {
      exactly_on_[lane] =
          over_facets([&](auto k) { return (answer(k).is_exact & answer(k).is_zero) != 0 ? bit(k) : 0.0; });
      exactly_off_[lane] =
          over_facets([&](auto k) { return (answer(k).is_exact & (answer(k).is_zero ^ 1)) != 0 ? bit(k) : 0.0; });
    }
  }
}

#if defined(__x86_64__)
template <bool kGrid>
[[gnu::target("avx2"), gnu::flatten]] void TetrahedronLanes::compute_wide() {
  compute_lanes<kGrid>();
}
template <bool kGrid>
[[gnu::target("avx2"), gnu::flatten]] void TetrahedronLanes::compare_wide() {
  compare_lanes<kGrid>();
}
bool TetrahedronLanes::processor_has_wide() { return __builtin_cpu_supports("avx2") != 0; }
#else
template <bool kGrid>
void TetrahedronLanes::compute_wide() {
  compute_lanes<kGrid>();
}
template <bool kGrid>
void TetrahedronLanes::compare_wide() {
  compare_lanes<kGrid>();
}
bool TetrahedronLanes::processor_has_wide() { return false; }
#endif

[[gnu::flatten]] void TetrahedronLanes::compute_narrow() {
  exact_reach_ > 0 ? compute_lanes<true>() : compute_lanes<false>();
}
[[gnu::flatten]] void TetrahedronLanes::compare_narrow() {
  exact_reach_ > 0 ? compare_lanes<true>() : compare_lanes<false>();
}

void TetrahedronLanes::compute() {
  if (!has_wide_) return compute_narrow();
  exact_reach_ > 0 ? compute_wide<true>() : compute_wide<false>();
}
void TetrahedronLanes::compare() {
  if (!has_wide_) return compare_narrow();
  exact_reach_ > 0 ? compare_wide<true>() : compare_wide<false>();
}

}  // namespace flowcert::geometry
