// The corners of one unstable set of dimension 2, exactly and as numbers with the nearest doubles.
//
// Guarantees: two corners have one number iff their exact positions, or directions, are equal. Exact positions are
// computed only where the nearest doubles are equal.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "flowcert/unstable_surfaces.h"
#include "morse/forward_walk.h"

namespace flowcert::morse {

class SurfaceCorners {
 public:
  // Both must outlive it.
  SurfaceCorners(VoronoiFaces& faces, FlowOperator& flow) : faces_(faces), flow_(flow) {}

  [[nodiscard]] Corner<> exact(const SurfaceEnd& end);
  [[nodiscard]] Corner<> exact(PolygonRef polygon, const TraceEnd& end);

  // ---- By number ----
  // Forgets all numbers, which are of points of the latest walk.
  void clear();
  [[nodiscard]] std::uint32_t number(const SurfaceEnd& end);
  [[nodiscard]] std::uint32_t number(PolygonRef polygon, const TraceEnd& end);
  [[nodiscard]] std::uint32_t number(const Location& at);
  [[nodiscard]] std::uint32_t number(Corner<> corner);
  // The middle of a Voronoi edge that is a whole line: the centre of its polygon.
  [[nodiscard]] Corner<> middle_of_line(PolygonRef polygon);
  // Puts them into order. Returns the new number of each.
  [[nodiscard]] std::vector<std::uint32_t> sort();
  [[nodiscard]] std::vector<RoundedUnstableSurface::Corner> rounded();

 private:
  struct Numbered {
    Point rounded;
    bool at_infinity;
    Location at;  // where there is no exact position yet
    std::optional<RationalPoint> exact;
  };
  using Coordinates = std::array<double, 3>;

  [[nodiscard]] RationalPoint sample(VertexIndex v) const;
  [[nodiscard]] std::uint32_t number_of(Numbered corner);
  [[nodiscard]] const RationalPoint& exact_of(Numbered& corner);

  VoronoiFaces& faces_;
  FlowOperator& flow_;
  std::vector<Numbered> corners_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;                // by Voronoi vertex, or by point
  std::array<std::multimap<Coordinates, std::uint32_t>, 2> by_position_;  // finite ones, directions
};

}  // namespace flowcert::morse
