// The unstable manifolds U2 of all index-2 critical points: two orbits each, from the point along its Voronoi
// edge both ways, on to a maximum, another stationary point, or infinity.
//
// Guarantees: exact, as orbit.h. Orbits that pass through one Voronoi vertex share what follows, unless told
// to compute each alone as the paper did; the answers are the same. Source: spec section 8 (FC-FLOW-07, 08);
// paper, section 2.3.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "flowcert/orbit.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

struct UnstableOptions {
  FlowOptions flow;
  // Otherwise each orbit is computed alone, from its own Voronoi vertices on, as the paper did; only the
  // arrays of facets are common.
  bool share = true;
};

// Const access is safe from several threads; of those that make it flow, one at a time does and the others
// wait.
class UnstableManifolds {
 public:
  // Told now and then how many index-2 points are done; may throw to stop.
  using Progress = std::function<void(std::size_t done, std::size_t total)>;

  // stationary: the list of the same diagram. Both must outlive this. Time in proportion to the segments
  // of all orbits, with sharing to those of the visited Voronoi vertices.
  UnstableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                    UnstableOptions options = {}, const Progress& progress = {});
  ~UnstableManifolds();
  UnstableManifolds(UnstableManifolds&&) noexcept;
  UnstableManifolds& operator=(UnstableManifolds&&) noexcept;

  // The index-2 critical points, in the order of the list.
  [[nodiscard]] std::size_t size() const;
  // Where the i-th of them is in the list.
  [[nodiscard]] std::size_t saddle(std::size_t i) const;
  // Where the orbit that leaves it on side 0 or 1 ends, in the list; none: infinity. The sides are told apart
  // by the plane through the contact points a < b < c < ... of the saddle: side 1 is the one that (b-a) x
  // (c-a) points to.
  [[nodiscard]] std::optional<std::size_t> limit(std::size_t i, std::size_t side) const;
  // Where the flow goes on that leaves a stationary point of index 2, or a regular one, along a Voronoi edge
  // (FC-CHAIN-02): a choice of one or two ways, counted modulo their number. In the list; none: infinity.
  [[nodiscard]] std::optional<std::size_t> limit_beyond(std::size_t record, std::size_t choice) const;
  // That orbit, flowed once more. Its start is the saddle; its first segment runs along the Voronoi edge
  // (E-E-V or E-E-inf). Exact coordinates of long orbits take time.
  [[nodiscard]] Orbit orbit(std::size_t i, std::size_t side) const;

  [[nodiscard]] const FlowStatistics& statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
