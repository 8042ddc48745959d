// The unstable sets U1 of critical points of index 1, and of regular stationary points of the kinds 1-2 and 1-3, as
// sets of dimension 2.
//
// Guarantees: exact, on every input. A part that several families of rays cover counts once. A set is made when it is
// asked for. nearest_double() rounds its coordinates, and rounded_set() makes them so. Source: spec section 11
// (clauses FC-UNST-04 to 06).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "flowcert/orbit.h"
#include "flowcert/pieces.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

// A set in the nearest doubles, for pictures: corners by number, and parts.
struct RoundedUnstableSurface {
  // A coordinate that would overflow is an infinity. At infinity, the position is a vector in that direction, scaled so
  // that its largest coordinate is 1 or -1.
  struct Corner {
    Point position;
    bool at_infinity = false;
    std::optional<RationalPoint> exact;  // where a coordinate would overflow
  };
  enum class Kind : std::uint8_t { kTrace, kRun, kSegment, kSheet };
  struct Part {
    Kind kind;
    // Of a segment's or a sheet's facet both samples; of a trace's or a run's polygon the first three: ascending.
    std::vector<PointId> samples;
    // Numbers of corners. A sheet goes counterclockwise, seen from samples[1], from its least number on. At most two of
    // its corners are at infinity; two are neighbours, and not opposite. Any other part goes from the lesser number to
    // the greater one. A trace that is a point has one corner, and one that is a whole line has its middle, too.
    std::vector<std::uint32_t> corners;
  };

  // Two are one iff their exact positions are equal, or their exact directions. Those at infinity come last. The order
  // is lexicographic in the doubles, and then in the exact numbers.
  std::vector<Corner> corners;
  // By kind, samples and corners. If P does not span space, a sheet is a whole facet, and two parts here, or four of a
  // whole plane.
  std::vector<Part> parts;
};

// How many parts of each sort a set has.
struct UnstableSurfaceSize {
  std::size_t vertices = 0, traces = 0, runs = 0, sheets = 0, segments = 0;

  friend bool operator==(const UnstableSurfaceSize&, const UnstableSurfaceSize&) = default;
};

// Const access is safe from several threads. Each of them makes sets with arrays of its own.
class UnstableSurfaces {
 public:
  // stationary is the list of the same diagram. Both must outlive this.
  UnstableSurfaces(const VoronoiDiagram& diagram, const StationaryPoints& stationary, FlowOptions options = {});
  UnstableSurfaces(const VoronoiDiagram&, StationaryPoints&&, FlowOptions = {}) = delete;
  UnstableSurfaces(VoronoiDiagram&&, const StationaryPoints&, FlowOptions = {}) = delete;
  ~UnstableSurfaces();
  UnstableSurfaces(UnstableSurfaces&&) noexcept;
  UnstableSurfaces& operator=(UnstableSurfaces&&) noexcept;

  // Stationary points with a face of dimension 1, in the order of the list.
  [[nodiscard]] std::size_t size() const;
  // Where the i-th of them is in the list.
  [[nodiscard]] std::size_t record(std::size_t i) const;
  // Its set. The time is in proportion to the Voronoi edges that it meets, the sizes of the facets that it enters, and
  // the intervals that come to one edge; and to the lengths of the numbers.
  [[nodiscard]] UnstableSurface<> set(std::size_t i) const;
  // The same in the nearest doubles, without vertices. It takes less time, because few exact coordinates are made.
  [[nodiscard]] RoundedUnstableSurface rounded_set(std::size_t i) const;
  // The size of set(i). That takes much less time, because no coordinates are made.
  [[nodiscard]] UnstableSurfaceSize size_of(std::size_t i) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
