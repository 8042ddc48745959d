// Numbers and vectors of several lanes, stored side by side, so that one instruction of the processor serves several
// lanes: two doubles, or four where it has AVX2.
//
// Guarantees: a row is aligned to a line of the cache, and all of its lanes are 0 at first.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/vector3.h"

namespace flowcert::geometry {

template <std::size_t kLanes>
struct alignas(64) LaneRow : std::array<double, kLanes> {};

// One row for each coordinate.
template <std::size_t kLanes>
struct LaneRows {
  LaneRow<kLanes> x{}, y{}, z{};

  [[gnu::always_inline]] void put(std::size_t lane, const auto& value) {
    x[lane] = value.x;
    y[lane] = value.y;
    z[lane] = value.z;
  }
  [[nodiscard, gnu::always_inline]] Vector3<double> at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};

}  // namespace flowcert::geometry
