// The unstable sets U1 of critical points of index 1, and of regular stationary points of the kinds 1-2 and 1-3, as
// sets of dimension 2.
//
// Guarantees: exact, on every input. A part that several families of rays cover counts once. A set is made when it is
// asked for. nearest_double() rounds its coordinates, and rounded_set() makes them so. Source: spec section 11
// (clauses FC-UNST-04 to 06).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "flowcert/orbit.h"
#include "flowcert/pieces.h"
#include "flowcert/rounded_unstable_surface.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

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
