// Follows many courses at once, each from one Voronoi vertex to the next, in doubles alone. The courses advance in
// step, facet by facet. So they wait for memory together and not one after the other, and one instruction computes for
// several of them (DirectionLanes).
//
// Guarantees: exact. Each sign is beyond its proven bound (direction.h). A course that doubles do not decide is handed
// back, to be followed alone with longer precisions. What a course is and what it counts does not depend on the
// courses beside it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flow/direction_lanes.h"
#include "flow/drivers.h"
#include "flow/flow_operator.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::flow {

class CoursesInStep {
 public:
  // Both must outlive it.
  CoursesInStep(VoronoiFaces& faces, KernelTally& tally) : faces_(faces), diagram_(faces.diagram()), tally_(tally) {}

  // source.next() is a Voronoi vertex to start from, or kNoCell if there is none for now. source.done(cluster, course)
  // takes what was found, source.undecided(cluster) what was not. Both may make further starts known.
  void follow(auto& source) {
    std::size_t running = 0;
    do {
      running = 0;
      for (std::size_t k = 0; k < kLanes; ++k) {
        if (lanes_[k].stage == Stage::kFree) start(lanes_[k], source.next());
        if (lanes_[k].stage == Stage::kFree) continue;
        ++running;
        advance(k);
        if (lanes_[k].stage == Stage::kDone) finish(lanes_[k], source);
      }
      directions_.cross();
      search();
    } while (running > 0);
  }

  // The longest recipe that a point on a course would have.
  [[nodiscard]] std::size_t deepest() const { return deepest_; }
  void forget_deepest() { deepest_ = 0; }

 private:
  // What a lane does next. Between two stages, memory that the next one needs is on its way.
  enum class Stage : std::uint8_t { kFree, kStart, kFirstFacet, kSearch, kFacet, kDone };
  struct Lane {
    Stage stage = Stage::kFree;
    bool is_decided = true;
    char from = 'V';  // the letter of the face in which the facet was entered
    CellIndex cluster = kNoCell;
    Course course;
    RingNumber ring = kNoRing;
    FacetName facet{0, 0};
    std::span<const RingPiece> pieces;  // of the ring, until another one is laid out
    // Pieces are counted from the one before the element that follows the point. All elements before `low` lie
    // clockwise of the ray; that of `high` does not, or is the point's own. In the end low is the exit's piece.
    std::size_t start = 0, low = 0, high = 0;
    std::size_t sides = 0, rays = 0;  // signs
    std::size_t along = 0, crossings = 0, centers = 0;

    [[nodiscard]] std::size_t around(std::size_t k) const { return k < pieces.size() ? k : k - pieces.size(); }
    [[nodiscard]] std::size_t exit() const { return around(start + low); }
  };
  static constexpr std::size_t kLanes = DirectionLanes::kLanes;

  void start(Lane& lane, CellIndex cluster) {
    if (cluster == kNoCell) return;
    lane.stage = Stage::kStart;
    lane.is_decided = true;
    lane.cluster = cluster;
    lane.course = {};
    lane.sides = lane.rays = lane.along = lane.crossings = lane.centers = 0;
    __builtin_prefetch(&diagram_.complex().signs(cluster));
    __builtin_prefetch(&diagram_.delaunay().cells[cluster]);
  }

  void advance(std::size_t k) {
    Lane& lane = lanes_[k];
    switch (lane.stage) {
      case Stage::kStart:
        return leave_vertex(lane);
      case Stage::kFirstFacet:
        return enter_first(k);
      case Stage::kFacet:
        return go_on(k);
      case Stage::kFree:
      case Stage::kSearch:
      case Stage::kDone:
        break;
    }
  }

  void finish(Lane& lane, auto& source) {
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
    const VertexFlow flow = vertex_flow(diagram_, lane.cluster);
    lane.stage = Stage::kDone;
    if (flow.way == VertexFlow::Way::kStays) {
      lane.course.end = Place::at_vertex(lane.cluster);
      lane.course.stationary = flow.index;
    } else if (flow.way == VertexFlow::Way::kAlongEdge) {
      end_along({'V', 'E', 0}, flow.edge, diagram_.end(flow.edge, 0) == lane.cluster ? 1 : 0, lane);
    } else {
      const FacetRing ring = faces_.ring(flow.facet, lane.cluster);
      for (const VertexIndex v : diagram_.delaunay().vertices(lane.cluster)) __builtin_prefetch(&diagram_.point(v));
      lane.ring = ring.id;
      lane.stage = Stage::kFirstFacet;
    }
  }

  void enter_first(std::size_t k) {
    Lane& lane = lanes_[k];
    const auto& v = diagram_.delaunay().vertices(lane.cluster);
    const FacetRing ring = faces_.ring(lane.ring);
    ++lane.centers;
    const FacetEdge edge = edge_of(ring.facet);
    directions_.set(
        k,
        direction_from_vertex<double>(
            {&diagram_.point(v[0]), &diagram_.point(v[1]), &diagram_.point(v[2]), &diagram_.point(v[3])}, edge),
        edge);
    enter(lane, ring, 'V', faces_.element_of(ring, lane.cluster) + 1, ring.size() - 2);
  }

  // Goes on from the inside of a Voronoi edge.
  void go_on(std::size_t k) {
    Lane& lane = lanes_[k];
    const std::size_t exit = lane.exit();
    const RingLink link = faces_.link(lane.ring, exit);
    const std::span<const RingPiece> pieces = faces_.ring(lane.ring).pieces;  // link() may have moved them
    const RingPiece& left = pieces[exit];
    if (link.ring == RingLink::kAlongEdge) return end_on_edge(k, left.polygon());
    const FacetRing ring = faces_.ring(link.ring);
    cross(k, left.apex, ring.facet);
    enter(lane, ring, 'E', link.place + 1, ring.size() - 1);
  }

  void end_on_edge(std::size_t k, PolygonRef polygon) {
    Lane& lane = lanes_[k];
    const auto [a, b, c] = diagram_.corners(polygon);
    ++lane.along;
    const MaybeSign side =
        normal_sign(directions_.direction(k), diagram_.point(a), diagram_.point(b), diagram_.point(c));
    // A zero would be a stationary point. Doubles never decide that.
    if (!side) return give_up(lane);
    lane.stage = Stage::kDone;
    end_along({'E', 'E', 0}, polygon, *side == Sign::kPositive ? 1 : 0, lane);
  }

  // ---- Parts of stages ----

  void end_along(SegmentType type, PolygonRef edge, std::size_t side, Lane& lane) {
    const CellIndex end = diagram_.end(edge, side);
    if (end != kNoCell) lane.course.end = Place::at_vertex(end);
    type[2] = letter(lane.course.end.kind);
    lane.course.add(type);
  }

  [[nodiscard]] FacetEdge edge_of(FacetName facet) const {
    return {&diagram_.point(facet.v0), &diagram_.point(facet.v1)};
  }

  // From one facet to the next, by the bisector of q. Most often q is an end of the next one's edge, and the other end
  // is one of this facet's. Which of them cannot be guessed, so that it is found without branches.
  void cross(std::size_t k, VertexIndex q, FacetName to) {
    const FacetName from = lanes_[k].facet;
    const bool ends_at_q = to.v1 == q;
    const VertexIndex other = ends_at_q ? to.v0 : to.v1, end = ends_at_q ? to.v1 : to.v0;
    const bool keeps_v0 = other == from.v0;
    const VertexIndex kept = keeps_v0 ? from.v0 : from.v1;
    if (other == kept && end == q) return directions_.ask_crossing(k, keeps_v0, diagram_.point(q), ends_at_q);
    directions_.set(k, direction_across(directions_.direction(k), edge_of(from), diagram_.point(q), edge_of(to)),
                    edge_of(to));
  }

  void enter(Lane& lane, const FacetRing& ring, char from, std::size_t first, std::size_t count) {
    lane.ring = ring.id;
    lane.facet = ring.facet;
    lane.from = from;
    lane.low = 0;
    lane.high = count;
    lane.start = ring.before(first < ring.size() ? first : first - ring.size());
    lane.stage = Stage::kSearch;
  }

  // ---- The binary search of RingQuery::from_boundary, of all lanes in step ----

  void search() {
    std::array<std::size_t, kLanes> searching;
    std::size_t count = 0;
    for (std::size_t k = 0; k < kLanes; ++k) {
      if (lanes_[k].stage != Stage::kSearch) continue;
      lanes_[k].pieces = faces_.ring(lanes_[k].ring).pieces;
      if (!directions_.is_known(k)) {
        give_up(lanes_[k]);
      } else if (asks(k)) {
        searching[count++] = k;
      }
    }
    while (count > 0) {
      directions_.order();
      std::size_t left = 0;
      for (std::size_t at = 0; at < count; ++at) {
        const std::size_t k = searching[at];
        Lane& lane = lanes_[k];
        const int sign = directions_.sign(k);
        // Doubles never say that an element lies on the ray.
        if (sign == 0) {
          give_up(lane);
          continue;
        }
        // Without a branch, because half of its guesses would be wrong.
        const std::size_t probe = (lane.low + lane.high) / 2, is_before = sign < 0 ? 1 : 0;
        lane.low += is_before * (probe + 1 - lane.low);
        lane.high -= (1 - is_before) * (lane.high - probe);
        if (asks(k)) searching[left++] = k;
      }
      count = left;
    }
  }

  // Asks for the next sign that the lane's search needs. Otherwise the lane has its next stage.
  [[nodiscard]] bool asks(std::size_t k) {
    Lane& lane = lanes_[k];
    while (lane.low < lane.high) {
      const std::size_t probe = (lane.low + lane.high) / 2;
      const std::size_t here = lane.around(lane.start + probe), behind = lane.around(here + 1);
      if (lane.pieces[behind].vertex != kNoCell) {
        ++lane.sides;
        directions_.ask_order(k, diagram_.point(lane.pieces[here].apex), diagram_.point(lane.pieces[behind].apex));
        return true;
      }
      const std::optional<bool> is_clockwise = is_ray_clockwise(k, behind);
      if (!is_clockwise) {
        give_up(lane);
        return false;
      }
      (*is_clockwise ? lane.low : lane.high) = *is_clockwise ? probe + 1 : probe;
    }
    leave(lane);
    return false;
  }

  // Whether the element before piece k lies clockwise of the ray. It is a direction at infinity.
  [[nodiscard]] std::optional<bool> is_ray_clockwise(std::size_t k, std::size_t piece) {
    ++lanes_[k].rays;
    const FacetRing ring{lanes_[k].ring, lanes_[k].facet, lanes_[k].pieces};
    const RingElement e = ring.element(piece);
    const MaybeSign sign = approach_sign(directions_.direction(k), edge_of(ring.facet), diagram_.point(e.apex));
    if (!sign) return std::nullopt;
    return (*sign == Sign::kPositive) == (e.factor < 0);
  }

  void leave(Lane& lane) {
    const std::size_t piece = lane.exit();
    const bool is_finite = lane.pieces[piece].is_finite();
    lane.course.add({lane.from, 'F', is_finite ? 'E' : '\0'});
    lane.stage = Stage::kDone;
    if (!is_finite) return;
    ++lane.crossings;
    lane.stage = Stage::kFacet;
    faces_.prefetch_link(lane.pieces[piece]);
  }

  VoronoiFaces& faces_;
  const VoronoiDiagram& diagram_;
  KernelTally& tally_;
  std::array<Lane, kLanes> lanes_;
  DirectionLanes directions_;
  std::size_t deepest_ = 0;
};

}  // namespace flowcert::flow
