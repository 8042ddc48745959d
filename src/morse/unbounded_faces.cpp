// All unbounded facets are beside unbounded Voronoi edges, unless the samples are on one line.
#include "morse/unbounded_faces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/rational_point.h"
#include "morse/polygon_turn.h"

namespace flowcert::morse {

namespace {

// A quarter turn around the axis, counterclockwise seen from its end.
RationalPoint turned(const RationalPoint& axis, const RationalPoint& direction) {
  return as_direction(cross(axis, direction));
}

class UnboundedSearch {
 public:
  explicit UnboundedSearch(VoronoiFaces& faces) : faces_(faces), diagram_(faces.diagram()) {}

  UnboundedFaces found() && {
    if (diagram_.dimension() == 1) add_planes();
    if (diagram_.dimension() >= 2) add_edges();
    return std::move(found_);
  }

 private:
  // The samples lie on a line, so that all directions from a midpoint lead to infinity.
  void add_planes() {
    for (CellIndex edge = 0; edge < diagram_.delaunay().finite_count; ++edge) {
      const auto& v = diagram_.delaunay().vertices(edge);
      UnboundedFacet facet{facet_name(v[0], v[1]), edge, {}, {}};
      const RationalPoint axis = axis_of(facet.facet);
      facet.rays.push_back(
          turned(axis, axis[0] != 0 || axis[1] != 0 ? RationalPoint{0, 0, 1} : RationalPoint{1, 0, 0}));
      for (std::size_t k = 0; k < 3; ++k) facet.rays.push_back(turned(axis, facet.rays.back()));
      for (std::size_t k = 0; k < 4; ++k) facet.arcs.push_back({facet.rays[k], facet.rays[(k + 1) % 4]});
      found_.facets.push_back(std::move(facet));
    }
  }

  void add_edges() {
    const bool is_spatial = diagram_.spatial() != nullptr;
    for (CellIndex cell = 0; cell < diagram_.delaunay().finite_count; ++cell) {
      for (std::uint32_t i = is_spatial ? 0 : 3; i < 4; ++i) {
        const PolygonRef polygon{cell, i};
        const bool is_inside = is_spatial && diagram_.delaunay().is_finite(diagram_.delaunay().neighbors(cell)[i]);
        if (!is_inside && diagram_.polygon(polygon) == polygon) add_edge(polygon);
      }
    }
  }

  void add_edge(PolygonRef polygon) {
    const bool leads = diagram_.driver(polygon).shape != Sign::kNegative;
    for (std::size_t end = 0; end < 2; ++end) {
      if (leads && diagram_.end(polygon, end) == kNoCell) found_.edges.push_back({polygon, end});
    }
    for (const PolygonSide& side : diagram_.sides(polygon)) {
      const FacetRing ring = faces_.ring(side.facet(), diagram_.cell_of_side(polygon, side.facet()));
      if (ring.id >= is_seen_.size()) is_seen_.resize(2 * std::size_t{ring.id} + 1, false);
      if (!is_seen_[ring.id]) add_facet(ring, polygon.cell);
      is_seen_[ring.id] = true;
    }
  }

  void add_facet(const FacetRing& ring, CellIndex hint) {
    const FacetSides sides(diagram_, ring);
    UnboundedFacet facet{ring.facet, hint, {}, {}};
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (!ring.pieces[k].is_finite()) add_piece(sides, k, facet);
    }
    if (!facet.rays.empty() || !facet.arcs.empty()) found_.facets.push_back(std::move(facet));
  }

  // Piece k is at infinity, and the pieces beside it are Voronoi edges. Its ends are one direction, or the ends of an
  // arc, or, in a half plane, opposite. Where the polygon of an edge is acute, the midpoint is on the inner side of the
  // edge, and the ray from there along the edge stays on that side.
  void add_piece(const FacetSides& sides, std::size_t k, UnboundedFacet& facet) const {
    const RationalPoint from = direction_of(diagram_, sides.end_at_infinity(k)),
                        to = direction_of(diagram_, sides.end_at_infinity(k + 1));
    const bool is_from_free = sides.angle(sides.ring().before(k)) == Sign::kPositive,
               is_to_free = sides.angle(k + 1) == Sign::kPositive;
    if (from == to) {
      if (is_from_free && is_to_free) facet.rays.push_back(from);
      return;
    }
    if (is_from_free) facet.rays.push_back(from);
    if (is_to_free) facet.rays.push_back(to);
    if (to != -from) {
      facet.arcs.push_back({from, to});
      return;
    }
    const RationalPoint middle = turned(axis_of(facet.facet), from);
    facet.rays.push_back(middle);
    facet.arcs.push_back({from, middle});
    facet.arcs.push_back({middle, to});
  }

  [[nodiscard]] RationalPoint axis_of(FacetName facet) const {
    return exact_position(diagram_.point(facet.v1)) - exact_position(diagram_.point(facet.v0));
  }

  VoronoiFaces& faces_;
  const VoronoiDiagram& diagram_;
  std::vector<bool> is_seen_;  // by ring
  UnboundedFaces found_;
};

}  // namespace

UnboundedFaces unbounded_faces(VoronoiFaces& faces) { return UnboundedSearch(faces).found(); }

RationalPoint direction_of(const VoronoiDiagram& diagram, const EdgeEnd& at) {
  const RationalPoint normal = as_direction(exact_normal(diagram, diagram.corners(at.polygon)));
  return at.end == 1 ? normal : -normal;
}

}  // namespace flowcert::morse
