// The double filter of several Delaunay cells side by side (tetrahedron_forms.h). Loops without branches over all lanes
// compute it, so that one instruction serves two lanes, or four where the processor has AVX2.
//
// Guarantees: each lane gives to the bit what tetrahedron_signs() and on_sphere() compute for its cell, on every
// processor. What a lane gives does not depend on the lanes beside it. Nothing is resolved here: where a lane is not
// certain of all of its signs, tetrahedron_signs() has to look at the cell.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/tetrahedron_signs.h"

namespace flowcert::geometry {

class TetrahedronLanes {
 public:
  static constexpr std::size_t kLanes = 16;

  void set(std::size_t lane, const TetrahedronPoints& points) {
    for (std::size_t k = 0; k < 4; ++k) points_[k].put(lane, *points[k]);
  }
  // The filter of all lanes.
  void compute();
  // Whether the filter tells all twelve angles and four sides.
  [[nodiscard]] bool is_certain(std::size_t lane) const { return unknown_[lane] == 0; }
  // Only where it does.
  [[nodiscard]] TetrahedronSigns signs(std::size_t lane) const {
    return {static_cast<std::uint16_t>(angles_[lane]), 0, static_cast<std::uint8_t>(sides_[lane]), 0, 0};
  }
  [[nodiscard]] CellSphere sphere(std::size_t lane) const {
    return {numerator_.at(lane), determinant_[lane], product_[lane], sum_[lane], in_range_[lane] != 0};
  }

  // One sample a facet of each lane's cell.
  void set_sample(std::size_t lane, std::size_t facet, const Point& q) { samples_[facet].put(lane, q); }
  // Compares all samples with the spheres that compute() found.
  void compare();
  // Bit i: the sample of facet i certainly does not lie on the cell's sphere.
  [[nodiscard]] unsigned off_sphere(std::size_t lane) const { return static_cast<unsigned>(off_[lane]); }

  // For tests: without it the best that the processor has is used.
  void use_wide_instructions(bool use) { has_wide_ = use && processor_has_wide(); }
  [[nodiscard]] static bool processor_has_wide();

 private:
  struct alignas(64) Row : std::array<double, kLanes> {};
  struct Rows {
    Row x{}, y{}, z{};
    template <class Triple>
    [[gnu::always_inline]] void put(std::size_t lane, const Triple& value) {
      x[lane] = value.x;
      y[lane] = value.y;
      z[lane] = value.z;
    }
    [[nodiscard, gnu::always_inline]] Vector3<double> at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  };
  [[gnu::always_inline]] inline void compute_lanes();
  [[gnu::always_inline]] inline void compare_lanes();
  void compute_wide();
  void compare_wide();

  std::array<Rows, 4> points_;
  // The masks of TetrahedronSigns, and whether a sign is unknown. Small integers in doubles are exact, and loops over
  // numbers of one size are wide.
  Row angles_{}, sides_{}, unknown_{};
  Rows numerator_;
  Row determinant_{}, product_{}, sum_{}, in_range_{};
  std::array<Rows, 4> samples_;
  Row off_{};
  bool has_wide_ = processor_has_wide();
};

}  // namespace flowcert::geometry
