// Where everything flows to: the λ-lists of stationary points, and how Voronoi edges divide by limits.
//
// Guarantees: exact, on every input. Limits are computed at once, and no orbit is followed. Positions are made when
// they are asked for. Source: spec section 11 (clauses FC-UNST).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "flowcert/orbit.h"
#include "flowcert/progress.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

namespace morse {
class LimitPartition;
}  // namespace morse

// The directions of a stationary point, by where they lead (FC-UNST-01, 02). Arcs and single directions take turns.
// X is the type of a position.
template <class X>
struct BasicLambdaList {
  struct Direction {
    std::optional<std::size_t> limit;  // a place in the list of stationary points; nothing for infinity
    // Where the ray of the direction leaves the closed Voronoi face. If it never does, this is a vector along it, whose
    // greatest coordinate is 1 or -1. No cycle has such a direction.
    X exit;
    bool is_vector = false;
  };
  // Counterclockwise, seen from the sample with the greater name. A critical point of index 1 has a cycle, which begins
  // with the direction whose exit comes first in lexicographic order. Points of face dimension 2 have two directions,
  // side 0 first (FC-FLOW-07), or one if they are regular, and no arcs.
  std::vector<Direction> directions;
  // Arc i comes after direction i. After the last direction of a cycle there is an arc, too. The whole circle is an
  // arc without a direction.
  std::vector<std::optional<std::size_t>> arcs;
};

using LambdaList = BasicLambdaList<RationalPoint>;
using RoundedLambdaList = BasicLambdaList<Point>;

// Const access is safe from several threads.
class FlowLimits {
 public:
  // stationary is the list of the same diagram. Both must outlive this. The time is in proportion to the faces and to
  // the points that separate limits on them. One thread makes it, because each face waits for those that it flows to.
  FlowLimits(const VoronoiDiagram& diagram, const StationaryPoints& stationary, FlowOptions options = {},
             const Progress& progress = {});
  FlowLimits(const VoronoiDiagram&, StationaryPoints&&, FlowOptions = {}, const Progress& = {}) = delete;
  FlowLimits(VoronoiDiagram&&, const StationaryPoints&, FlowOptions = {}, const Progress& = {}) = delete;
  ~FlowLimits();
  FlowLimits(FlowLimits&&) noexcept;
  FlowLimits& operator=(FlowLimits&&) noexcept;

  // Stationary points with a face of dimension 1 or 2, in the order of the list.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t record(std::size_t i) const;
  // How many single directions and arcs the i-th of them has.
  [[nodiscard]] std::size_t direction_count(std::size_t i) const;
  [[nodiscard]] std::size_t arc_count(std::size_t i) const;
  // The limits of its directions and arcs, in the order of some λ-list; a cycle may begin anywhere.
  struct Entry {
    static constexpr std::uint32_t kInfinity = 0xffffffffu;
    std::uint32_t limit;  // a place in the list of stationary points, or kInfinity
    bool is_arc;
  };
  [[nodiscard]] std::vector<Entry> entries(std::size_t i) const;
  // The list with exact positions.
  [[nodiscard]] LambdaList list(std::size_t i) const;
  // The list with the doubles nearest to its positions. A coordinate that would overflow is an infinity.
  [[nodiscard]] RoundedLambdaList rounded_list(std::size_t i) const;

  // Points that separate limits on Voronoi edges.
  [[nodiscard]] std::size_t point_count() const;

 private:
  friend class morse::LimitPartition;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
