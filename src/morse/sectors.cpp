// See sectors.h. The sector is a triangle of which the facet's near side, seen from its midpoint, cuts off
// the corner there.
#include "morse/sectors.h"

#include <algorithm>

#include "flow/obtuse_chain.h"
#include "geometry/vector3.h"

namespace flowcert::morse {

namespace {

using Vector = Vector3<Rational>;

Vector vector(const Point& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Vector vector(const RationalPoint& p) { return {p[0], p[1], p[2]}; }
RationalPoint point(const Vector& v) { return {v.x, v.y, v.z}; }

// The plane of a facet: its Delaunay edge p0p1 with the midpoint m.
struct FacetPlane {
  FacetPlane(const Point& p0_, const Point& p1_)
      : p0(vector(p0_)), p1(vector(p1_)), m(Rational(1, 2) * (p0 + p1)) {}

  // Positive where m and q are on one side of the bisector of p0 and q, and x on the other: 2 <x-m, q-m> -
  // h(q), times -1 where q is obtuse.
  [[nodiscard]] Rational beyond(const Vector& x, const Vector& q) const {
    return Rational(2) * dot(x - m, q - m) - dot(q - p0, q - p1);
  }
  // Twice the area spanned with m, counterclockwise seen from p1, times |p0p1|.
  [[nodiscard]] Rational turn(const Vector& a, const Vector& b) const {
    return dot(cross(a - m, b - m), p1 - p0);
  }

  Vector p0, p1, m;
};

// Where the line from m through x meets the bisector of q.
Vector on_bisector(const FacetPlane& plane, const Vector& x, const Vector& q) {
  const Rational s = dot(q - plane.p0, q - plane.p1) / (Rational(2) * dot(x - plane.m, q - plane.m));
  return plane.m + s * (x - plane.m);
}

void make_canonical(std::vector<RationalPoint>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 2 && corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
}

}  // namespace

SectorParts sector_of(VoronoiFaces& faces, FlowMachine& machine, FacetName facet, const Arc& arc) {
  const FacetPlane plane(faces.point(facet.v0), faces.point(facet.v1));
  const FacetRing ring = faces.ring(facet, arc.polygon.cell);
  FilterTally tally;
  const ObtuseChain chain = obtuse_chain(faces, facet, ring, tally);
  Vector a = vector(arc.a), b = vector(arc.b);
  if (plane.turn(a, b) < 0) std::swap(a, b);
  SectorParts parts;
  parts.corners = {point(a), point(b)};
  if (chain.count == 0) {
    parts.corners.push_back(point(plane.m));
    make_canonical(parts.corners);
    return parts;
  }
  // From b back to a: the near side is met clockwise, in the ring's order.
  const std::size_t n = ring.pieces.size();
  const auto piece = [&](std::size_t k) -> const RingPiece& { return ring.pieces[(chain.first + k) % n]; };
  const auto inner = [&](std::size_t k) { return ring.elements[(chain.first + k + 1) % n].vertex; };
  std::size_t k = 0;
  while (k + 1 < chain.count &&
         plane.turn(b, vector(machine.exact({Place::at_vertex(inner(k)), kNoPoint}))) >= 0) {
    ++k;
  }
  Vector from = on_bisector(plane, b, vector(faces.point(piece(k).apex)));
  parts.corners.push_back(point(from));
  for (; k < chain.count; ++k) {
    const bool is_last = k + 1 == chain.count;
    const Vector next = is_last ? a : vector(machine.exact({Place::at_vertex(inner(k)), kNoPoint}));
    if (!is_last && plane.turn(a, next) > 0) {
      parts.arcs.push_back({piece(k).polygon, point(from), point(next)});
      parts.vertices.push_back(inner(k));
      parts.corners.push_back(point(next));
      from = next;
      continue;
    }
    const Vector end = on_bisector(plane, a, vector(faces.point(piece(k).apex)));
    parts.arcs.push_back({piece(k).polygon, point(from), point(end)});
    parts.corners.push_back(point(end));
    break;
  }
  make_canonical(parts.corners);
  return parts;
}

}  // namespace flowcert::morse
