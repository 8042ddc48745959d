// How often each sign and each construction of the flow was asked for, and how often its filter left it open so that
// exact arithmetic had to answer (paper, Table 4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flowcert/filter_tally.h"

namespace flowcert {

// The signs and constructions that flowing takes. A predicate fails where the kernel's filter (doubles with a bound, or
// intervals) did not decide. A construction fails where doubles know no bound on its error, or its interval is
// unbounded.
enum class FlowPrimitive : std::uint8_t {
  kSideOfRay,      // <(x-m) ^ (c-m), p0p1>: on which side of the ray a Voronoi vertex lies (paper, Eq. 2, 3)
  kRayAtInfinity,  // the same for the direction of a Voronoi ray (Eq. 4, 5)
  kAroundStart,    // order of Voronoi vertices around a start inside its facet
  kAlongEdge,      // which way along a Voronoi edge
  kNearerExit,     // which of two neighbours a start in a cell meets first
  kCircumcenter,   // construction of a Voronoi vertex
  kCrossing,       // construction of the point where the flow leaves a facet or cell
};
inline constexpr std::size_t kFlowPrimitiveCount = 7;
inline constexpr std::array<const char*, kFlowPrimitiveCount> kFlowPrimitiveNames = {
    "side_of_ray", "ray_at_infinity", "around_start", "along_edge", "nearer_exit", "circumcenter", "crossing"};

struct KernelTally {
  std::array<FilterCount, kFlowPrimitiveCount> counts{};

  FilterCount& operator[](FlowPrimitive p) { return counts[static_cast<std::size_t>(p)]; }
  const FilterCount& operator[](FlowPrimitive p) const { return counts[static_cast<std::size_t>(p)]; }
  KernelTally& operator+=(const KernelTally& other) {
    for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
      counts[k].calls += other.counts[k].calls;
      counts[k].failures += other.counts[k].failures;
    }
    return *this;
  }
};

}  // namespace flowcert
