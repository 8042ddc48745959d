// The stable manifolds S2 of all critical points of index 2, and the stable sets of the regular stationary
// points: everything that the flow carries there.
//
// Guarantees: exact, on every input. Sizes, boundaries and statistics are computed at once; the geometry of
// a set is made when asked for. Source: spec section 9 (clauses FC-STAB); paper, section 2.3.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/orbit.h"
#include "flowcert/pieces.h"
#include "flowcert/progress.h"
#include "flowcert/sphere.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

// The backward segments of a stable set in doubles. They come in the order of StableSet::segments.
struct RoundedSegments {
  struct Position {
    RoundedSphere sphere;      // with the squared distance to the samples
    std::vector<PointId> end;  // the contact set of the stationary point at which segments end here; empty for a front
  };
  struct Segment {
    std::array<PointId, 2> samples;  // ascending
    std::uint32_t front, back;       // places in `positions`
  };
  // No two fronts are equal, exactly. Two ends are equal iff their contact sets are.
  std::vector<Position> positions;
  std::vector<Segment> segments;
};

// The closed walk of FC-STAB-07, as names; the first one is not repeated at the end. It begins at the least sample of
// the contact set and goes towards the lesser of its neighbours in the polygon. Critical points of index 2 and
// regular ones of kind 1-2 have it, unless the skeleton has a Voronoi vertex. contact is the stationary point's,
// ascending. O(n log n) for n segments.
[[nodiscard]] std::optional<std::vector<PointId>> boundary_walk(const StableSet<>& set, StationaryIndex index,
                                                                std::span<const PointId> contact);

struct StableStatistics {
  Distribution n_s2;       // flow segments from an index-2 point down to an index-1 point, a connecting orbit each
  Distribution triangles;  // of the S2's without interval
  std::size_t triangle_count = 0;      // of all of them
  std::optional<std::size_t> largest;  // the number of the first S2 with the most triangles
  std::size_t with_vertex = 0;         // S2's whose skeleton has a Voronoi vertex
  std::size_t with_interval = 0;       // S2's that have parts of dimension 3
  std::size_t ends_at_regular = 0;     // branches of S2's that end at a regular stationary point
  std::size_t broken_ties = 0;         // index-2 points whose boundary a tie leaves open
  KernelTally tally;
  std::size_t depth = 0;  // the longest chain of constructions that the kernel kept (FlowStatistics)
};

// Const access is safe from several threads. Each of them makes sets with arrays of its own.
class StableManifolds {
 public:
  // stationary is the list of the same diagram. Both must outlive this. The time is in proportion to the segments of
  // all skeletons.
  StableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary, FlowOptions options = {},
                  const Progress& progress = {});
  StableManifolds(const VoronoiDiagram&, StationaryPoints&&, FlowOptions = {}, const Progress& = {}) = delete;
  StableManifolds(VoronoiDiagram&&, const StationaryPoints&, FlowOptions = {}, const Progress& = {}) = delete;
  ~StableManifolds();
  StableManifolds(StableManifolds&&) noexcept;
  StableManifolds& operator=(StableManifolds&&) noexcept;

  // The critical points of index 2 and then the regular stationary points, in the order of the list.
  [[nodiscard]] std::size_t size() const;
  // Where the i-th of them is in the list.
  [[nodiscard]] std::size_t record(std::size_t i) const;
  // Its skeleton's backward segments, without those behind intervals. A surface has two triangles for each.
  [[nodiscard]] std::size_t segment_count(std::size_t i) const;
  [[nodiscard]] bool has_vertex(std::size_t i) const;
  [[nodiscard]] bool has_interval(std::size_t i) const;
  // The boundary, in the chain complex, of a critical point of index 2: records of index 1, mod 2, ascending. If its
  // skeleton has no Voronoi vertex and no regular back, FC-STAB-07 determines it. Otherwise ties are broken
  // (FC-CHAIN-02).
  [[nodiscard]] std::span<const std::uint32_t> boundary(std::size_t i) const;

  // The skeleton, with exact coordinates. This flows once more.
  [[nodiscard]] StableSet<> set(std::size_t i) const;
  // The skeleton of any stationary point, by its place in the list: of maxima, too. Index 0 and 1 have no pieces.
  [[nodiscard]] StableSet<> set_of_record(std::size_t record) const;
  // The skeleton of infinity.
  [[nodiscard]] StableSet<> set_of_infinity() const;
  // Its backward segments, in the nearest doubles. This takes much less time.
  [[nodiscard]] RoundedSegments rounded_segments(std::size_t i) const;
  // Those from which the boundary of a critical point of index 2 is read: below a tie these are parts of the skeleton
  // alone (FC-CHAIN-02). Mod 2, the boundary of their triangles, two for each, is the edges of boundary(i).
  [[nodiscard]] RoundedSegments segments_to_boundary(std::size_t i) const;

  [[nodiscard]] const StableStatistics& statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// The area of the triangles which the backward segments of the i-th set of `stable` stand for (FC-STAB-04, FC-POCK-04):
// two of one area for each, one with each of its samples. A relative error of at most 2^-40; an infinity where it would
// overflow. O(segments).
[[nodiscard]] double surface_area(const PointSet& points, const StableManifolds& stable, std::size_t i);

// The connecting orbits of a stable set: how its stationary point and the critical points of index 1 are
// joined (FC-STAB-06; paper, section 6: their lengths are n_S2).
// Exact, as the set is. There is one orbit for each critical back, because every point flows one way only. Each orbit
// is the places of its segments in set.segments, against the flow: from the stationary point down to the critical
// point of index 1. The orbits come in the order of their last segments. If a set has intervals, orbits that come
// through these are left out. O(n log n) for n segments, and the lengths of the orbits.
[[nodiscard]] std::vector<std::vector<std::size_t>> connecting_orbits(const StableSet<>& set,
                                                                      const RationalPoint& stationary);

}  // namespace flowcert
