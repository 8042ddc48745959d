#include "morse/stable_sector.h"

#include <algorithm>
#include <utility>

#include "flow/drivers.h"
#include "flow/kernels/steering.h"

namespace flowcert::morse {

namespace {

using Vector = Vector3<Rational>;

Vector vector(const Point& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Vector vector(const RationalPoint& p) { return {p[0], p[1], p[2]}; }
RationalPoint point(const Vector& v) { return {v.x, v.y, v.z}; }

// The plane of a facet: its Delaunay edge p0p1 with the midpoint m.
struct FacetPlane {
  FacetPlane(const Point& p0_, const Point& p1_) : p0(vector(p0_)), p1(vector(p1_)), m(Rational(1, 2) * (p0 + p1)) {}

  // Twice the area spanned with m, counterclockwise seen from p1, times |p0p1|.
  [[nodiscard]] Rational turn(const Vector& a, const Vector& b) const { return dot(cross(a - m, b - m), p1 - p0); }

  Vector p0, p1, m;
};

void make_canonical(std::vector<RationalPoint>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 2 && corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
}

}  // namespace

SectorParts sector_of(VoronoiFaces& faces, FlowOperator& flow, FacetName facet, const Arc& arc) {
  const FacetPlane plane(faces.point(facet.v0), faces.point(facet.v1));
  const FacetRing ring = faces.ring(facet, arc.polygon.cell);
  FilterTally tally;
  const ObtuseChain chain = obtuse_chain(faces.diagram(), facet, ring, tally);
  Vector a = vector(arc.a), b = vector(arc.b);
  if (plane.turn(a, b) < 0) std::swap(a, b);
  SectorParts parts;
  parts.corners = {point(a), point(b)};
  if (chain.count == 0) {
    parts.corners.push_back(point(plane.m));
    make_canonical(parts.corners);
    return parts;
  }
  // Goes from b back to a. Rays from m meet the near side clockwise, in the ring's order.
  const std::size_t n = ring.pieces.size();
  const auto piece = [&](std::size_t k) -> const RingPiece& { return ring.pieces[(chain.first + k) % n]; };
  const auto inner = [&](std::size_t k) { return ring.pieces[(chain.first + k + 1) % n].vertex; };
  std::size_t k = 0;
  while (k + 1 < chain.count && plane.turn(b, vector(flow.exact({Place::at_vertex(inner(k)), kNoPoint}))) >= 0) {
    ++k;
  }
  Vector from = crossing(b, plane.p0, plane.p1, vector(faces.point(piece(k).apex)));
  parts.corners.push_back(point(from));
  for (; k < chain.count; ++k) {
    const bool is_last = k + 1 == chain.count;
    const Vector next = is_last ? a : vector(flow.exact({Place::at_vertex(inner(k)), kNoPoint}));
    if (!is_last && plane.turn(a, next) > 0) {
      parts.arcs.push_back({piece(k).polygon(), point(from), point(next)});
      parts.vertices.push_back(inner(k));
      parts.corners.push_back(point(next));
      from = next;
      continue;
    }
    const Vector end = crossing(a, plane.p0, plane.p1, vector(faces.point(piece(k).apex)));
    parts.arcs.push_back({piece(k).polygon(), point(from), point(end)});
    parts.corners.push_back(point(end));
    break;
  }
  make_canonical(parts.corners);
  return parts;
}

}  // namespace flowcert::morse
