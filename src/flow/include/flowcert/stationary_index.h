// What a stationary point is: the index of a critical one, the kind of a regular one. Source: spec clause
// FC-CRIT-03.
#pragma once

#include <compare>
#include <cstdint>

namespace flowcert {

// The dimensions (0 to 3) of the face of conv C(x) that has x in its relative interior, and of conv C(x)
// itself. Equal for a critical point, whose index they are; (1,2), (2,3) or (1,3) for a regular stationary
// one.
struct StationaryIndex {
  std::uint8_t face_dimension = 0;
  std::uint8_t hull_dimension = 0;

  [[nodiscard]] bool is_critical() const { return face_dimension == hull_dimension; }
  friend auto operator<=>(const StationaryIndex&, const StationaryIndex&) = default;
};

}  // namespace flowcert
