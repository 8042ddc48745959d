// The unstable manifolds U2 of all index-2 critical points. Each is two orbits, which leave the point along its
// Voronoi edge on either side, and go on to a maximum, another stationary point, or infinity.
//
// Guarantees: exact, as orbit.h. Orbits that pass through one Voronoi vertex share what follows, unless the options
// say to compute each alone as the paper did; the answers are the same. Source: spec section 8 (FC-FLOW-07, 08);
// paper, section 2.3.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "flowcert/orbit.h"
#include "flowcert/progress.h"
#include "flowcert/sphere.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

// Const access is safe from several threads. Each of them flows with arrays of its own.
class UnstableManifolds {
 public:
  // stationary is the list of the same diagram. Both must outlive this. The time is in proportion to the segments of
  // all orbits; with sharing, only to those of the visited Voronoi vertices.
  UnstableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary, FlowOptions options = {},
                    const Progress& progress = {});
  UnstableManifolds(const VoronoiDiagram&, StationaryPoints&&, FlowOptions = {}, const Progress& = {}) = delete;
  UnstableManifolds(VoronoiDiagram&&, const StationaryPoints&, FlowOptions = {}, const Progress& = {}) = delete;
  ~UnstableManifolds();
  UnstableManifolds(UnstableManifolds&&) noexcept;
  UnstableManifolds& operator=(UnstableManifolds&&) noexcept;

  // The index-2 critical points, in the order of the list.
  [[nodiscard]] std::size_t size() const;
  // Where the i-th of them is in the list.
  [[nodiscard]] std::size_t saddle(std::size_t i) const;
  // Where the orbit that leaves it on side 0 or 1 ends, by place in the list; nothing for infinity. The plane through
  // the saddle's contact points a < b < c < ... says which side is which: (b-a) x (c-a) points to side 1.
  [[nodiscard]] std::optional<std::size_t> limit(std::size_t i, std::size_t side) const;
  // The end of the flow that leaves a stationary point of index 2, or a regular one, along a Voronoi edge
  // (FC-CHAIN-02). There are one or two ways; the choice is counted modulo their number. The answer is a place in the
  // list, or nothing for infinity.
  [[nodiscard]] std::optional<std::size_t> limit_beyond(std::size_t record, std::size_t choice) const;
  // The orbit of limit(i, side), flowed once more. It starts at the saddle, and its first segment runs along the
  // Voronoi edge (E-E-V or E-E-inf). Exact coordinates of long orbits take time.
  [[nodiscard]] Orbit orbit(std::size_t i, std::size_t side) const;
  // The orbit of limit(i, side) in doubles: where it starts, and where each segment ends, but not infinity. Each point
  // has the squared distance to the samples. What follows a Voronoi vertex is flowed once for all orbits, and kept:
  // 32 bytes for each point.
  [[nodiscard]] std::vector<RoundedSphere> rounded_orbit(std::size_t i, std::size_t side) const;

  // The direction of the last segment of limit(i, side), if that goes to infinity. The coordinates are divided by
  // the largest of their absolute values, which becomes 1, and are then the nearest doubles. What follows the last
  // Voronoi vertex is flowed once for all orbits.
  [[nodiscard]] std::optional<Point> direction_to_infinity(std::size_t i, std::size_t side) const;

  [[nodiscard]] const FlowStatistics& statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
