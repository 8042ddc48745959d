// Follows many courses at once, each from one Voronoi vertex to the next, in doubles alone. A course waits for memory
// at every facet, so the courses advance in step and wait together and not one after the other.
//
// Guarantees: exact. Each sign is beyond its proven bound (direction.h). A course that doubles do not decide is handed
// back, to be followed alone with longer precisions. What a course is and what it counts does not depend on the
// courses beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flow/drivers.h"
#include "flow/flow_operator.h"
#include "flow/kernels/moving_direction.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::flow {

class CoursesInStep {
 public:
  // Both must outlive it.
  CoursesInStep(VoronoiFaces& faces, KernelTally& tally) : faces_(faces), tally_(tally) {}

  // source.next() is a Voronoi vertex to start from, or kNoCell if there is none for now. source.done(cluster, course)
  // takes what was found, source.undecided(cluster) what was not. Both may make further starts known.
  template <class Source>
  void follow(Source& source) {
    std::size_t running = 0;
    do {
      running = 0;
      for (Lane& lane : lanes_) {
        if (lane.stage == Stage::kFree) start(lane, source.next());
        if (lane.stage == Stage::kFree) continue;
        ++running;
        advance(lane);
        if (lane.stage == Stage::kDone) finish(lane, source);
      }
    } while (running > 0);
  }

  // The longest recipe that a point on a course would have.
  [[nodiscard]] std::size_t deepest() const { return deepest_; }
  void forget_deepest() { deepest_ = 0; }

 private:
  // What a lane does next. Between two stages, memory that the next one needs is on its way.
  enum class Stage : std::uint8_t { kFree, kStart, kFirstFacet, kFacet, kDone };
  struct Lane {
    Stage stage = Stage::kFree;
    bool is_decided = true;
    CellIndex cluster = kNoCell;
    Course course;
    RingNumber ring = kNoRing;
    std::uint32_t exit = 0;  // the piece through which the ring is left
    SeenSample seen;         // the sample by whose bisector that is
    MovingDirection moving;
    std::size_t sides = 0, rays = 0;  // signs
    std::size_t along = 0, crossings = 0, centers = 0;
  };
  static constexpr std::size_t kLanes = 12;

  void start(Lane& lane, CellIndex cluster) {
    if (cluster == kNoCell) return;
    lane.stage = Stage::kStart;
    lane.is_decided = true;
    lane.cluster = cluster;
    lane.course = {};
    lane.sides = lane.rays = lane.along = lane.crossings = lane.centers = 0;
    __builtin_prefetch(&faces_.complex().signs(cluster));
    __builtin_prefetch(&faces_.delaunay().cells[cluster]);
  }

  void advance(Lane& lane) {
    switch (lane.stage) {
      case Stage::kStart:
        return leave_vertex(lane);
      case Stage::kFirstFacet:
        return cross_first(lane);
      case Stage::kFacet:
        return go_on(lane);
      case Stage::kFree:
      case Stage::kDone:
        break;
    }
  }

  template <class Source>
  void finish(Lane& lane, Source& source) {
    lane.stage = Stage::kFree;
    if (!lane.is_decided) return source.undecided(lane.cluster);
    tally_[FlowPrimitive::kSideOfRay].calls += lane.sides;
    tally_[FlowPrimitive::kRayAtInfinity].calls += lane.rays;
    tally_[FlowPrimitive::kAlongEdge].calls += lane.along;
    tally_[FlowPrimitive::kCrossing].calls += lane.crossings;
    tally_[FlowPrimitive::kCircumcenter].calls += lane.centers;
    if (lane.crossings > 0) deepest_ = std::max(deepest_, 1 + lane.crossings);
    source.done(lane.cluster, lane.course);
  }

  void give_up(Lane& lane) {
    lane.is_decided = false;
    lane.stage = Stage::kDone;
  }

  // ---- Stages ----

  void leave_vertex(Lane& lane) {
    const VertexFlow flow = vertex_flow(faces_.diagram(), lane.cluster);
    lane.stage = Stage::kDone;
    if (flow.way == VertexFlow::Way::kStays) {
      lane.course.end = Place::at_vertex(lane.cluster);
      lane.course.stationary = flow.index;
    } else if (flow.way == VertexFlow::Way::kAlongEdge) {
      end_along({'V', 'E', 0}, flow.edge, faces_.end(flow.edge, 0) == lane.cluster ? 1 : 0, lane);
    } else {
      const FacetRing ring = faces_.ring(flow.facet, lane.cluster);
      for (const VertexIndex v : faces_.delaunay().vertices(lane.cluster)) __builtin_prefetch(&faces_.point(v));
      lane.ring = ring.id;
      lane.stage = Stage::kFirstFacet;
    }
  }

  void cross_first(Lane& lane) {
    const auto& v = faces_.delaunay().vertices(lane.cluster);
    const FacetRing ring = faces_.rings().at(lane.ring);
    ++lane.centers;
    const FacetEdge edge = edge_of(ring);
    lane.moving.begin(direction_from_vertex<double>(
                          {&faces_.point(v[0]), &faces_.point(v[1]), &faces_.point(v[2]), &faces_.point(v[3])}, edge),
                      edge);
    leave(lane, ring, 'V', faces_.rings().element_of(ring, lane.cluster) + 1, ring.size() - 2);
  }

  // Goes on from the inside of a Voronoi edge.
  void go_on(Lane& lane) {
    FacetRings& rings = faces_.rings();
    const RingLink link = rings.link(lane.ring, lane.exit);
    if (link.ring == RingLink::kAlongEdge) return end_on_edge(lane);
    const FacetRing ring = rings.at(link.ring);
    lane.ring = link.ring;
    lane.moving.cross(lane.seen, edge_of(ring));
    leave(lane, ring, 'E', link.place + 1, ring.size() - 1);
  }

  void end_on_edge(Lane& lane) {
    const PolygonRef polygon = faces_.rings().at(lane.ring).pieces[lane.exit].polygon();
    const auto [a, b, c] = faces_.corners(polygon);
    ++lane.along;
    const MaybeSign side = normal_sign(lane.moving.direction(), faces_.point(a), faces_.point(b), faces_.point(c));
    // A zero would be a stationary point. Doubles never decide that.
    if (!side) return give_up(lane);
    lane.stage = Stage::kDone;
    end_along({'E', 'E', 0}, polygon, *side == Sign::kPositive ? 1 : 0, lane);
  }

  // ---- Parts of stages ----

  void end_along(SegmentType type, PolygonRef edge, std::size_t side, Lane& lane) {
    const CellIndex end = faces_.end(edge, side);
    if (end != kNoCell) lane.course.end = Place::at_vertex(end);
    type[2] = letter(lane.course.end.kind);
    lane.course.add(type);
  }

  [[nodiscard]] FacetEdge edge_of(const FacetRing& ring) const {
    return {&faces_.point(ring.facet.v0), &faces_.point(ring.facet.v1)};
  }

  // Whether the element before piece k lies clockwise of the ray. It is a direction at infinity.
  [[nodiscard]] std::optional<bool> is_ray_clockwise(Lane& lane, const FacetRing& ring, std::size_t k) const {
    ++lane.rays;
    const RingElement e = ring.element(k);
    const MaybeSign sign = lane.moving.approach(faces_.point(e.apex));
    if (!sign) return std::nullopt;
    return (*sign == Sign::kPositive) == (e.factor < 0);
  }

  // The binary search of RingQuery::from_boundary. Pieces are counted from the one before element `first` on, so that
  // element k lies between pieces k and k + 1. What is seen of a piece's sample serves the next sign. Doubles never say
  // that an element lies on the ray.
  void leave(Lane& lane, const FacetRing& ring, char from, std::size_t first, std::size_t count) {
    if (!lane.moving.is_known()) return give_up(lane);
    const std::size_t n = ring.size();
    const auto around = [n](std::size_t k) { return k < n ? k : k - n; };
    const std::size_t start = ring.before(around(first));
    const auto see = [&](std::size_t k) { return lane.moving.see(faces_.point(ring.pieces[around(start + k)].apex)); };
    constexpr std::size_t kUnseen = ~std::size_t{0};
    std::size_t low = 0, high = count, seen_low = kUnseen, seen_high = kUnseen;
    SeenSample at_low{}, at_high{};
    while (low < high) {
      const std::size_t probe = (low + high) / 2, next = around(around(start + probe) + 1);
      if (ring.pieces[next].vertex == kNoCell) {
        const std::optional<bool> is_clockwise = is_ray_clockwise(lane, ring, next);
        if (!is_clockwise) return give_up(lane);
        (*is_clockwise ? low : high) = *is_clockwise ? probe + 1 : probe;
        continue;
      }
      ++lane.sides;
      const SeenSample here = seen_low == probe ? at_low : see(probe);
      const SeenSample behind = seen_high == probe + 1 ? at_high : see(probe + 1);
      const MaybeSign sign = lane.moving.order(here, behind);
      if (!sign) return give_up(lane);
      if (*sign == Sign::kNegative) {
        seen_low = low = probe + 1;
        at_low = behind;
      } else {
        seen_high = high = probe;
        at_high = here;
      }
    }
    const std::size_t piece = around(start + low);
    const bool is_finite = ring.pieces[piece].is_finite();
    lane.course.add({from, 'F', is_finite ? 'E' : '\0'});
    lane.stage = Stage::kDone;
    if (!is_finite) return;
    ++lane.crossings;
    lane.exit = static_cast<std::uint32_t>(piece);
    lane.seen = seen_low == low ? at_low : seen_high == low ? at_high : see(low);
    lane.stage = Stage::kFacet;
    faces_.rings().prefetch_link(ring, piece);
  }

  VoronoiFaces& faces_;
  KernelTally& tally_;
  std::array<Lane, kLanes> lanes_;
  std::size_t deepest_ = 0;
};

}  // namespace flowcert::flow
