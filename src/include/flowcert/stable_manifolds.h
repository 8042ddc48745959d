// The stable manifolds S2 of all critical points of index 2, and the stable sets of the regular stationary
// points: everything that the flow carries there.
//
// Guarantees: exact, on every input. Sizes, boundaries and statistics are computed at once; the geometry of
// a set is made when asked for. Source: spec section 11 (clauses FC-STAB); paper, section 2.3.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "flowcert/orbit.h"

namespace flowcert {

struct StableOptions {
  FlowOptions flow;
  // Of the choices where ties are broken (FC-CHAIN-02); 0 takes the first way always.
  std::uint64_t seed = 0;
};

struct StableStatistics {
  Distribution n_s2;  // flow segments from an index-2 point down to an index-1 point, a connecting orbit each
  Distribution triangles;           // of the S2's without interval
  std::size_t with_vertex = 0;      // S2's whose skeleton has a Voronoi vertex
  std::size_t with_interval = 0;    // S2's that have parts of dimension 3
  std::size_t ends_at_regular = 0;  // branches of S2's that end at a regular stationary point
  std::size_t broken_ties = 0;      // index-2 points whose boundary a tie leaves open
  KernelTally tally;
};

class StableManifolds {
 public:
  // Told now and then how many stationary points are done; may throw to stop.
  using Progress = std::function<void(std::size_t done, std::size_t total)>;

  // stationary: that of the same triangulation. Both must outlive this. Time in proportion to the segments of
  // all skeletons.
  StableManifolds(const Delaunay& delaunay, const StationaryPoints& stationary, StableOptions options = {},
                  const Progress& progress = {});
  ~StableManifolds();
  StableManifolds(StableManifolds&&) noexcept;
  StableManifolds& operator=(StableManifolds&&) noexcept;

  // The critical points of index 2 and then the regular stationary points, in the order of the list.
  [[nodiscard]] std::size_t size() const;
  // Where the i-th of them is in the list.
  [[nodiscard]] std::size_t record(std::size_t i) const;
  // Of its skeleton, intervals left out: backward segments. A surface has two triangles for each.
  [[nodiscard]] std::size_t segment_count(std::size_t i) const;
  [[nodiscard]] bool has_vertex(std::size_t i) const;
  [[nodiscard]] bool has_interval(std::size_t i) const;
  // Of a critical point of index 2, its boundary in the chain complex: records of index 1, mod 2, ascending.
  // Where its skeleton has no Voronoi vertex and no regular back, FC-STAB-07 determines it; otherwise ties
  // are broken (FC-CHAIN-02).
  [[nodiscard]] std::span<const std::uint32_t> boundary(std::size_t i) const;

  [[nodiscard]] const StableStatistics& statistics() const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace flowcert
