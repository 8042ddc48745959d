// In which sense three samples of a Delaunay polygon go around its Voronoi edge.
//
// Guarantees: exact.
#pragma once

#include <algorithm>
#include <array>

#include "flowcert/rational.h"
#include "geometry/vector3.h"
#include "morse/layer.h"
#include "voronoi/diagram.h"

namespace flowcert::morse {

// Whether (b-a) x (c-a) points to end 1 of the polygon's Voronoi edge. The samples are not collinear.
[[nodiscard]] inline bool has_turn(const Diagram& diagram, PolygonRef polygon, const std::array<VertexIndex, 3>& abc) {
  const std::array<VertexIndex, 3> corners = diagram.corners(polygon);
  std::size_t first = 0, shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] == abc[0]) first = i;
    shared += std::ranges::count(abc, corners[i]) > 0 ? 1u : 0u;
  }
  if (shared == 3) return corners[(first + 1) % 3] == abc[1];
  // Only polygons with more than three samples come here.
  using Vector = Vector3<Rational>;
  const auto at = [&](VertexIndex v) {
    const Point& p = diagram.point(v);
    return Vector{Rational(p.x), Rational(p.y), Rational(p.z)};
  };
  const auto normal = [&](const std::array<VertexIndex, 3>& v) {
    return cross(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]));
  };
  return dot(normal(corners), normal(abc)) > 0;
}

}  // namespace flowcert::morse
