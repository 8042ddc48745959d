// What the paper's section 6 reports of a computation of orbits: lengths, types, filter failures, sizes of
// exact numbers, depths of cascades (Tables 1, 3, 4, 5, Figure 12).
//
// Guarantees: lengths and types are properties of the input alone, the same with and without sharing and for
// every kernel. The tally, bit sizes and depths say how they were computed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

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

using KernelTally = Tally<FlowPrimitive, kFlowPrimitiveCount>;

// Counts how often each number came.
class Distribution {
 public:
  void add(std::size_t value, std::size_t times = 1) { times_[value] += times; }

  [[nodiscard]] const std::map<std::size_t, std::size_t>& times() const { return times_; }
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] double mean() const;  // all of these are 0 where there is nothing
  [[nodiscard]] std::size_t max() const;
  [[nodiscard]] double standard_deviation() const;  // of the whole, not an estimate from a sample
  [[nodiscard]] std::size_t mode() const;           // the smallest, if there are several
  [[nodiscard]] double median() const;              // halfway between the middle two, if there are two

  friend bool operator==(const Distribution&, const Distribution&) = default;

 private:
  std::map<std::size_t, std::size_t> times_;
};

struct FlowStatistics {
  // Two orbits for each index-2 point. Each is counted by itself, even where orbits share what follows.
  Distribution n_u2;                                  // segments of an orbit, the first one included
  Distribution n_wcc;                                 // runs of consecutive segments that end at a constructed point
  std::map<std::array<char, 3>, std::size_t> census;  // segments by type
  std::size_t to_critical = 0;                        // orbits that end at a critical point,
  std::size_t to_regular = 0;                         // at a regular stationary point,
  std::size_t to_infinity = 0;

  // The computation.
  KernelTally tally;
  std::size_t segments_computed = 0;  // with sharing, each shared segment once
  Distribution exact_bytes;           // where exact numbers of a constructed point were needed: numerator and
                                      // denominator of each coordinate; of the cascade kernel, each component of the
                                      // direction
  std::size_t depth = 0;              // the longest chain of constructions that a kernel keeps, from input points up
};

}  // namespace flowcert
