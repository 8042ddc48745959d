// In which sense three samples of a Delaunay polygon go around its Voronoi edge.
//
// Guarantees: exact.
#pragma once

#include <algorithm>
#include <array>

#include "flowcert/rational.h"
#include "geometry/rational_point.h"
#include "morse/layer.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert::morse {

// Three samples of a polygon, and the same three in another order: 1 if both go around it in the same sense, -1 if not.
// 0 if they are not the same samples.
[[nodiscard]] inline int turn_of_same(const std::array<VertexIndex, 3>& from, const std::array<VertexIndex, 3>& to) {
  std::size_t first = 3, shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (from[i] == to[0]) first = i;
    shared += std::ranges::count(to, from[i]) > 0 ? 1u : 0u;
  }
  if (shared < 3) return 0;
  return from[(first + 1) % 3] == to[1] ? 1 : -1;
}

// (b-a) x (c-a)
[[nodiscard]] inline RationalPoint exact_normal(const VoronoiDiagram& diagram, const std::array<VertexIndex, 3>& abc) {
  const auto at = [&](std::size_t k) { return exact_position(diagram.point(abc[k])); };
  return normal_of(at(0), at(1), at(2));
}

// Whether (b-a) x (c-a) points to end 1 of the polygon's Voronoi edge. The samples are not collinear.
[[nodiscard]] inline bool has_turn(const VoronoiDiagram& diagram, PolygonRef polygon,
                                   const std::array<VertexIndex, 3>& abc) {
  const std::array<VertexIndex, 3> corners = diagram.corners(polygon);
  if (const int turn = turn_of_same(corners, abc); turn != 0) return turn > 0;
  // Only polygons with more than three samples come here.
  return dot(exact_normal(diagram, corners), exact_normal(diagram, abc)) > 0;
}

}  // namespace flowcert::morse
