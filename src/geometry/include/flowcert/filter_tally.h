// How often each predicate, and each sign and construction of the flow, was asked for, and how often its filter
// left it open so that exact arithmetic had to answer (paper, Table 4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace flowcert {

enum class Predicate : std::uint8_t {
  kAngle,        // h(q): acute, right or obtuse (FC-SIGN-01)
  kSideOfPlane,  // s(o,f): the side of a facet's plane on which a circumcentre lies (FC-SIGN-03)
  kCospherical,  // five points on one sphere (FC-VOR-01)
  kCoplanar,     // two hull facets in one plane (FC-VOR-02)
  kCocircular,   // four coplanar points on one circle (FC-VOR-02)
};
inline constexpr std::size_t kPredicateCount = 5;
inline constexpr std::array<const char*, kPredicateCount> kPredicateNames = {
    "angle", "side_of_plane", "cospherical", "coplanar", "cocircular"};

struct FilterCount {
  std::uint64_t calls = 0;
  std::uint64_t failures = 0;

  FilterCount& operator+=(const FilterCount& other) {
    calls += other.calls;
    failures += other.failures;
    return *this;
  }
  friend bool operator==(const FilterCount&, const FilterCount&) = default;
};

struct FilterTally {
  std::array<FilterCount, kPredicateCount> counts{};

  FilterCount& operator[](Predicate p) { return counts[static_cast<std::size_t>(p)]; }
  const FilterCount& operator[](Predicate p) const { return counts[static_cast<std::size_t>(p)]; }
};

// The signs and constructions that flowing takes. A predicate fails where the kernel's intervals did not decide and
// exact numbers were asked. A construction fails where its interval is unbounded.
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
    "side_of_ray", "ray_at_infinity", "around_start", "along_edge",
    "nearer_exit", "circumcenter",    "crossing"};

struct KernelTally {
  std::array<FilterCount, kFlowPrimitiveCount> counts{};

  FilterCount& operator[](FlowPrimitive p) { return counts[static_cast<std::size_t>(p)]; }
  const FilterCount& operator[](FlowPrimitive p) const { return counts[static_cast<std::size_t>(p)]; }
};

}  // namespace flowcert
