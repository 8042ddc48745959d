// What a stationary point is: the index of a critical one, the kind of a regular one. Source: spec clause
// FC-CRIT-03.
#pragma once

#include <compare>
#include <cstdint>

namespace flowcert {

// The dimension of the face of conv C(x) that has x in its relative interior, and the dimension of conv C(x) itself
// (0 to 3). They are equal for a critical point, and are its index. They are (1,2), (2,3) or (1,3) for a regular
// stationary point.
struct StationaryIndex {
  std::uint8_t face_dimension = 0;
  std::uint8_t hull_dimension = 0;

  [[nodiscard]] bool is_critical() const { return face_dimension == hull_dimension; }
  friend auto operator<=>(const StationaryIndex&, const StationaryIndex&) = default;
};

}  // namespace flowcert
