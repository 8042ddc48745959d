// The double filter of several Delaunay cells side by side (tetrahedron_forms.h). Loops without branches over all lanes
// compute it, so that one instruction serves two lanes, or four where the processor has AVX2.
//
// Guarantees: each lane gives to the bit what tetrahedron_signs() and on_sphere() compute for its cell, on every
// processor. What a lane gives does not depend on the lanes beside it. Points of a lattice, or of another coarse grid
// of a power of two, are exact in doubles (kExactReach), so that zeros are certain, too. Nothing else is resolved here:
// where a lane does not know all of its signs, tetrahedron_signs() has to look at the cell.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/lane_rows.h"
#include "geometry/tetrahedron_signs.h"

namespace flowcert::geometry {

class TetrahedronLanes {
 public:
  static constexpr std::size_t kLanes = 16;

  // IntegerGrid::exact_reach() of all points; 0 asks nothing of them.
  explicit TetrahedronLanes(double exact_reach = 0) : exact_reach_(exact_reach) {}

  void set(std::size_t lane, const TetrahedronPoints& points) {
    for (std::size_t k = 0; k < 4; ++k) points_[k].put(lane, *points[k]);
  }
  // The filter of all lanes.
  void compute();
  // How many of the twelve angles, and of the four sides, are not beyond the filter's bounds.
  [[nodiscard]] unsigned angle_failures(std::size_t lane) const { return static_cast<unsigned>(open_angles_[lane]); }
  [[nodiscard]] unsigned side_failures(std::size_t lane) const { return static_cast<unsigned>(open_sides_[lane]); }
  // Whether all signs are known.
  [[nodiscard]] bool is_known(std::size_t lane) const {
    return is_exact_[lane] != 0 || open_angles_[lane] + open_sides_[lane] == 0;
  }
  // Only where they are.
  [[nodiscard]] TetrahedronSigns signs(std::size_t lane) const {
    return {static_cast<std::uint16_t>(angles_[lane]), static_cast<std::uint16_t>(zero_angles_[lane]),
            static_cast<std::uint8_t>(sides_[lane]), static_cast<std::uint8_t>(zero_sides_[lane]), 0};
  }
  [[nodiscard, gnu::always_inline]] CellSphere sphere(std::size_t lane) const {
    return {numerator_.at(lane),
            determinant_[lane],
            product_[lane],
            sum_[lane],
            condition(in_range_[lane] != 0),
            condition(is_exact_[lane] != 0)};
  }

  // One sample a facet of each lane's cell.
  void set_sample(std::size_t lane, std::size_t facet, const Point& q) { samples_[facet].put(lane, q); }
  // Compares all samples with the spheres that compute() found.
  void compare();
  // Bit i: the sample of facet i is beyond the filter's bound, so that it does not lie on the cell's sphere.
  [[nodiscard]] unsigned off_sphere(std::size_t lane) const { return static_cast<unsigned>(off_[lane]); }
  // Bit i: the comparison of facet i is exact, so that the sample lies on the sphere or not.
  [[nodiscard]] unsigned exactly_on_sphere(std::size_t lane) const { return static_cast<unsigned>(exactly_on_[lane]); }
  [[nodiscard]] unsigned exactly_off_sphere(std::size_t lane) const {
    return static_cast<unsigned>(exactly_off_[lane]);
  }

  // For tests: without it the best that the processor has is used.
  void use_wide_instructions(bool use) { has_wide_ = use && processor_has_wide(); }
  [[nodiscard]] static bool processor_has_wide();

 private:
  using Row = LaneRow<kLanes>;
  using Rows = LaneRows<kLanes>;

  template <bool kGrid>
  [[gnu::always_inline]] inline void compute_lanes();
  template <bool kGrid>
  [[gnu::always_inline]] inline void compare_lanes();
  void compute_narrow();
  void compare_narrow();
  template <bool kGrid>
  void compute_wide();
  template <bool kGrid>
  void compare_wide();

  std::array<Rows, 4> points_;
  double exact_reach_;
  // The masks of TetrahedronSigns, and numbers of signs. Small integers in doubles are exact, and loops over numbers of
  // one size are wide.
  Row angles_{}, sides_{}, zero_angles_{}, zero_sides_{}, open_angles_{}, open_sides_{};
  Rows numerator_;
  Row determinant_{}, product_{}, sum_{}, in_range_{}, is_exact_{};
  std::array<Rows, 4> samples_;
  Row off_{}, exactly_on_{}, exactly_off_{};
  bool has_wide_ = processor_has_wide();
};

}  // namespace flowcert::geometry
