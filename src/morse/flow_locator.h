// Where points flow to: many of them, one after the other.
//
// Guarantees: exact, on every input and for every position. A position costs microseconds once everything is divided
// by limits (flow_limits.h), because no orbit is followed: its ray leaves the Voronoi cell, and then a Voronoi facet,
// and meets a Voronoi edge, which is divided already. Numbers with bounds decide all of that. Where a bound leaves
// something open, for example if several samples are nearest, the orbit is followed exactly. Source: spec section 8
// (clauses FC-FLOW).
#pragma once

#include <cstddef>
#include <memory>

#include "flowcert/flow_complex.h"

namespace flowcert {

// Not to be used from two threads at once. Several may use one FlowLimits.
class FlowLocator {
 public:
  // All are of one diagram, and must outlive this. It sorts the samples in space, and notes who are neighbours.
  // O(n log n).
  FlowLocator(const VoronoiDiagram& diagram, const StationaryPoints& stationary, const FlowLimits& limits,
              FlowOptions options = {});
  FlowLocator(VoronoiDiagram&&, const StationaryPoints&, const FlowLimits&, FlowOptions = {}) = delete;
  // Another one, for another thread: they share what does not change. O(1).
  FlowLocator(const FlowLocator& other);
  ~FlowLocator();
  FlowLocator(FlowLocator&&) noexcept;
  FlowLocator& operator=(const FlowLocator&) = delete;
  FlowLocator& operator=(FlowLocator&&) noexcept;

  // Both throw InvalidInput for an empty point set. The second one also does for coordinates that are not finite.
  [[nodiscard]] FlowPlace locate(const RationalPoint& x);
  [[nodiscard]] FlowPlace locate(const Point& x);

  // How many positions had their orbits followed.
  [[nodiscard]] std::size_t followed() const;

 private:
  struct Map;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
