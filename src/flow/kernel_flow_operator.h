// The flow operator over a construction kernel (paper, Table 1 and section 4): which face the flow crosses
// from here, what drives it, and where it arrives.
//
// Guarantees: exact, for every start and every entry of Table 1; the choice of kernel and of the search
// changes no answer. The only decisions are signs of the merged Voronoi complex and of steering.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "flow/courses_in_step.h"
#include "flow/drivers.h"
#include "flow/facet_search.h"
#include "flow/flow_operator.h"
#include "geometry/rational_point.h"

namespace flowcert::flow {

template <ConstructsPoints Kernel>
class KernelFlowOperator final : public FlowOperator {
 public:
  KernelFlowOperator(VoronoiFaces& faces, FacetSearch search)
      : faces_(faces),
        diagram_(faces.diagram()),
        kernel_(tally_),
        centers_{*this},
        search_(search),
        in_step_(faces, tally_) {}

  PointNumber add(const RationalPoint& x) override { return kernel_.add(x); }

  FlowStep step(const Location& from) override {
    switch (from.place.kind) {
      case Place::Kind::kVertex:
        return step_from_vertex(from);
      case Place::Kind::kEdge:
        return step_from_edge(from);
      case Place::Kind::kFacet:
        return step_from_facet(from);
      case Place::Kind::kCell:
        return step_from_cell(from);
      case Place::Kind::kInfinity:
        break;
    }
    return {};
  }

  // A loop over rings. The way from one to the next is known from the second visit on.
  Course follow(CellIndex cluster) override {
    const VertexFlow flow = vertex_flow(diagram_, cluster);
    const Location start{Place::at_vertex(cluster), kNoPoint};
    if (flow.way != VertexFlow::Way::kAcrossFacet) return course_of(start, step_from_vertex(start));
    Course course;
    FacetRing ring = faces_.ring(flow.facet, cluster);
    MovingPoint x = moving_point(center(cluster), ring);
    Exit exit = exit_from_vertex(ring, cluster, x);
    char from = 'V';
    for (; exit.kind == Exit::Kind::kPiece; from = 'E') {
      course.add({from, 'F', 'E'});
      x.leave(diagram_.point(ring.pieces[exit.at].apex));
      const RingLink link = faces_.link(ring.id, exit.at);
      if (link.ring == RingLink::kAlongEdge) {
        const Location at{Place::on_edge(faces_.ring(ring.id).pieces[exit.at].polygon()), kNoPoint};
        const auto [a, b, c] = diagram_.corners(at.place.edge);
        const Sign side = x.sign_along_edge(diagram_.point(a), diagram_.point(b), diagram_.point(c));
        return course_of(at, step_along_edge(at, diagram_.driver(at.place.edge).shape, side), course);
      }
      ring = faces_.ring(link.ring);
      x.enter(diagram_.point(ring.facet.v0), diagram_.point(ring.facet.v1));
      exit = exit_from_piece(ring, link.place, x);
    }
    if (exit.kind == Exit::Kind::kElement) course.end = Place::at_vertex(ring.pieces[exit.at].vertex);
    course.add({from, 'F', letter(course.end.kind)});
    return course;
  }

  // Longer precisions follow the courses that doubles do not decide, one at a time.
  void follow_all(CourseSource& source) override {
    if constexpr (HasMovingPoint<Kernel>) {
      if (search_ == FacetSearch::kBinary) {
        struct {
          KernelFlowOperator& flow;
          CourseSource& source;
          CellIndex next() { return source.next(); }
          void done(CellIndex cluster, const Course& course) { source.take(cluster, course); }
          void undecided(CellIndex cluster) { source.take(cluster, flow.follow(cluster)); }
        } step_by_step{*this, source};
        return in_step_.follow(step_by_step);
      }
    }
    for (CellIndex cluster = source.next(); cluster != kNoCell; cluster = source.next()) {
      source.take(cluster, follow(cluster));
    }
  }

  Location end_of_edge(PolygonRef polygon, std::size_t side) override {
    const CellIndex cluster = diagram_.end(polygon, side);
    return cluster == kNoCell ? Location{} : Location{Place::at_vertex(cluster), kNoPoint};
  }

  std::optional<BackwardStep> one_back(const Place& front, FacetName facet, CellIndex hint) override {
    if (front.kind == Place::Kind::kEdge && diagram_.spatial() != nullptr) {
      if (const auto near = only_near_edge(diagram_, facet, front.edge)) return edge_step(near->polygon, near->apex);
    }
    const FacetRing ring = faces_.ring(facet, hint);
    const ObtuseChain chain = chain_of(ring);
    if (chain.count > 1) return std::nullopt;
    return chain.count == 0 ? midpoint_step(ring, chain) : edge_step(ring.pieces[chain.first]);
  }

  // In the ring's order, the inner vertices of the near side lie first counterclockwise of the ray from the midpoint
  // to the front, then clockwise of it.
  BackwardStep step_back(const Location& front, FacetName facet, CellIndex hint) override {
    const FacetRing ring = faces_.ring(facet, hint);
    const ObtuseChain chain = chain_of(ring);
    const std::size_t n = ring.size();
    FLOWCERT_REQUIRES(chain.count > 1);
    std::size_t low = 0, high = chain.count - 1;
    MovingPoint x = moving_point(number_of(front), ring);
    const RaySides<Kernel, const Centers> sides(kernel_, centers_, ring, x);
    while (low < high) {
      const std::size_t probe = search_ == FacetSearch::kBinary ? (low + high) / 2 : low;
      const std::size_t element = (chain.first + 1 + probe) % n;
      const Sign sign = sides.of_vertex(element);
      if (sign == Sign::kZero) return {Place::at_vertex(ring.pieces[element].vertex), false, kInfiniteVertex};
      (sign == Sign::kPositive ? low : high) = sign == Sign::kPositive ? probe + 1 : probe;
    }
    return edge_step(ring.pieces[(chain.first + low) % n]);
  }

  PointNumber cross_back(const Location& front, FacetName facet, VertexIndex apex) override {
    return kernel_.add_crossing(number_of(front), diagram_.point(facet.v0), diagram_.point(facet.v1),
                                diagram_.point(apex));
  }

  PointNumber add_center(const std::array<VertexIndex, 3>& samples) override {
    return kernel_.add_circumcenter(
        std::array{&diagram_.point(samples[0]), &diagram_.point(samples[1]), &diagram_.point(samples[2])},
        Stay::kPassing);
  }

  RationalPoint exact(const Location& at) override { return kernel_.exact(number_of(at)); }
  RoundedSphere rounded(const Location& at) override {
    const PointNumber number = number_of(at);
    if constexpr (RoundsPoints<Kernel>) {
      if (const auto sphere = kernel_.rounded(number)) return *sphere;
    }
    const RationalPoint x = kernel_.exact(number);
    const Point& nearest = diagram_.point(diagram_.contact(at.place).front());
    return rounded_sphere(ExactSphere{x, geometry::squared_distance(x, nearest)});
  }
  void count_sizes(Distribution& exact_bytes, std::size_t& depth) const override {
    depth = std::max({depth, kernel_.deepest(), in_step_.deepest()});
    for (PointNumber point = 0; point < kernel_.kept(); ++point) {
      if (const auto bytes = kernel_.exact_bytes(point)) {
        for (const std::size_t size : *bytes) exact_bytes.add(size);
      }
    }
  }

  PointNumber kept() const override { return kernel_.kept(); }
  void drop_from(PointNumber point) override { kernel_.drop_from(point); }

  void drop_all() override {
    kernel_.drop_all();
    in_step_.forget_deepest();
    for (const CellIndex cluster : constructed_) center_of_[cluster] = kNoPoint;
    constructed_.clear();
  }

  const KernelTally& tally() const override { return tally_; }

 private:
  // What a query of a ring needs of the operator.
  struct Centers {
    KernelFlowOperator& flow;
    PointNumber operator()(CellIndex cluster) const { return flow.center(cluster); }
    const Point& point(VertexIndex v) const { return flow.diagram_.point(v); }
  };
  using Query = RingQuery<Kernel, const Centers>;
  using Exit = typename Query::Exit;
  using MovingPoint = typename MovingPointOf<Kernel>::Type;

  MovingPoint moving_point(PointNumber start, const FacetRing& ring) {
    return MovingPoint(kernel_, start, diagram_.point(ring.facet.v0), diagram_.point(ring.facet.v1));
  }

  // The Voronoi vertex, constructed when first needed. A kernel that constructs vertices for its signs keeps it until
  // drop_all().
  PointNumber center(CellIndex cluster) {
    const auto constructed = [&](Stay stay) {
      const auto& v = diagram_.delaunay().vertices(cluster);
      return kernel_.add_circumcenter(
          std::array{&diagram_.point(v[0]), &diagram_.point(v[1]), &diagram_.point(v[2]), &diagram_.point(v[3])}, stay);
    };
    if constexpr (HasMovingPoint<Kernel>) return constructed(Stay::kPassing);
    if (center_of_.empty()) center_of_.assign(diagram_.delaunay().finite_count, kNoPoint);
    PointNumber& number = center_of_[cluster];
    if (number == kNoPoint) {
      constructed_.push_back(cluster);
      number = constructed(Stay::kLasting);
    }
    return number;
  }

  PointNumber number_of(const Location& at) {
    return at.place.kind == Place::Kind::kVertex ? center(at.place.vertex) : at.point;
  }

  ObtuseChain chain_of(const FacetRing& ring) {
    std::uint32_t& number = faces_.note(ring.id);
    if (number == VoronoiFaces::kNoNote) {
      number = static_cast<std::uint32_t>(chains_.size());
      chains_.push_back(obtuse_chain(diagram_, ring));
    }
    FLOWCERT_REQUIRES(number < chains_.size());
    return chains_[number];
  }

  static BackwardStep edge_step(PolygonRef polygon, VertexIndex apex) { return {Place::on_edge(polygon), false, apex}; }
  static BackwardStep edge_step(const RingPiece& piece) { return edge_step(piece.polygon(), piece.apex); }
  static BackwardStep midpoint_step(const FacetRing& ring, const ObtuseChain& chain) {
    Place back = Place::on_facet(ring.facet);
    if (chain.right_count == 1) back = Place::on_edge(ring.pieces[chain.right].polygon());
    if (chain.right_count == 2) back = Place::at_vertex(ring.pieces[chain.right].vertex);
    return {back, true, kInfiniteVertex};
  }

  static Driver midpoint_of(FacetName facet) { return {{facet.v0, facet.v1, kInfiniteVertex}, 2}; }
  Driver center_of(PolygonRef polygon) const { return {diagram_.corners(polygon), 3}; }

  // V-V-V, V-E-{V, infinity}, V-F-{V, E, infinity}.
  FlowStep step_from_vertex(const Location& from) {
    const CellIndex cluster = from.place.vertex;
    const VertexFlow flow = vertex_flow(diagram_, cluster);
    if (flow.way == VertexFlow::Way::kStays) return stays(from, flow.index, {});
    if (flow.way == VertexFlow::Way::kAlongEdge) {
      const std::size_t side = diagram_.end(flow.edge, 0) == cluster ? 1 : 0;
      return {Place::on_edge(flow.edge), center_of(flow.edge), end_of_edge(flow.edge, side), std::nullopt};
    }
    const FacetRing ring = faces_.ring(flow.facet, cluster);
    MovingPoint x = moving_point(center(cluster), ring);
    return across(ring, exit_from_vertex(ring, cluster, x), x);
  }

  // E-E-{V, infinity}, E-F-{V, E, infinity}.
  FlowStep step_from_edge(const Location& from) {
    const PolygonRef polygon = from.place.edge;
    const PolygonDriver driver = diagram_.driver(polygon);
    if (driver.shape == Sign::kNegative) {
      const FacetRing ring = faces_.ring(driver.side, polygon.cell);
      MovingPoint x = moving_point(from.point, ring);
      return across(ring, exit_from_piece(ring, faces_.piece_of(ring, polygon), x), x);
    }
    const auto [a, b, c] = diagram_.corners(polygon);
    const Sign side = kernel_.sign(AlongEdge{from.point, diagram_.point(a), diagram_.point(b), diagram_.point(c)});
    return step_along_edge(from, driver.shape, side);
  }

  // E-E-{V, infinity}. The polygon contains its centre, and `side` is that of its plane on which the start lies.
  FlowStep step_along_edge(const Location& from, Sign shape, Sign side) {
    const PolygonRef polygon = from.place.edge;
    if (side == Sign::kZero) {
      return stays(from, {static_cast<std::uint8_t>(shape == Sign::kZero ? 1 : 2), 2}, center_of(polygon));
    }
    return {from.place, center_of(polygon), end_of_edge(polygon, side == Sign::kPositive ? 1 : 0), std::nullopt};
  }

  // F-F-{V, E, infinity}.
  FlowStep step_from_facet(const Location& from) {
    const FacetName facet = from.place.facet;
    if (exact(from) == exact_midpoint(diagram_.point(facet.v0), diagram_.point(facet.v1))) {
      return stays(from, {1, 1}, midpoint_of(facet));
    }
    const FacetRing ring = faces_.ring(facet);
    MovingPoint start = moving_point(from.point, ring);
    return across(ring, query_of(ring, start).from_inside(search_), start);
  }

  // C-C-{V, E, F, infinity}. Bisectors with the Delaunay neighbours bound the cell; the ray ends at the nearest.
  FlowStep step_from_cell(const Location& from) {
    const VertexIndex sample = from.place.sample;
    const Point& p = diagram_.point(sample);
    const Driver driver{{sample, kInfiniteVertex, kInfiniteVertex}, 1};
    if (exact(from) == exact_position(p)) {
      return stays(from, {0, 0}, driver);
    }
    const PointNumber x = from.point;
    std::vector<VertexIndex> first;
    for (const VertexIndex q : faces_.neighbors(sample)) {
      if (kernel_.sign(RayAtInfinity{x, p, p, diagram_.point(q)}) != Sign::kPositive) continue;
      const Sign order = first.empty()
                             ? Sign::kNegative
                             : kernel_.sign(NearerExit{x, p, diagram_.point(q), diagram_.point(first.front())});
      if (order == Sign::kNegative) first.clear();
      if (order != Sign::kPositive) first.push_back(q);
    }
    FlowStep step{from.place, driver, {}, std::nullopt};
    if (first.empty()) return step;
    step.end.place = faces_.place_of(sample, first);
    if (step.end.place.kind != Place::Kind::kVertex) {
      step.end.point = kernel_.add_crossing(x, p, p, diagram_.point(first.front()));
    }
    return step;
  }

  // Adds the last step.
  static Course course_of(const Location& from, const FlowStep& step, Course course = {}) {
    if (!step.stationary) course.add(segment_type(from.place, step));
    course.end = step.end.place;
    course.stationary = step.stationary;
    return course;
  }

  static FlowStep stays(const Location& at, StationaryIndex index, Driver driver) {
    return {at.place, driver, at, index};
  }

  Query query_of(const FacetRing& ring, MovingPoint& x) { return Query(kernel_, centers_, ring, x); }
  Exit exit_from_vertex(const FacetRing& ring, CellIndex cluster, MovingPoint& x) {
    return query_of(ring, x).from_boundary(search_, faces_.element_of(ring, cluster) + 1, ring.size() - 2);
  }
  Exit exit_from_piece(const FacetRing& ring, std::size_t piece, MovingPoint& x) {
    return query_of(ring, x).from_boundary(search_, piece + 1, ring.size() - 1);
  }

  FlowStep across(const FacetRing& ring, Exit exit, MovingPoint& x) {
    const FacetName facet = ring.facet;
    FlowStep step{Place::on_facet(facet), midpoint_of(facet), {}, std::nullopt};
    switch (exit.kind) {
      case Exit::Kind::kInfinity:
        break;
      case Exit::Kind::kElement:
        step.end.place = Place::at_vertex(ring.pieces[exit.at].vertex);
        break;
      case Exit::Kind::kPiece: {
        const RingPiece& piece = ring.pieces[exit.at];
        step.end.place = Place::on_edge(piece.polygon());
        x.leave(diagram_.point(piece.apex));
        step.end.point = x.number();
        break;
      }
    }
    return step;
  }

  VoronoiFaces& faces_;
  const VoronoiDiagram& diagram_;
  KernelTally tally_;
  Kernel kernel_;
  const Centers centers_;
  FacetSearch search_;
  CoursesInStep in_step_;
  std::vector<CellIndex> constructed_;  // clusters whose centers the kernel keeps
  std::vector<PointNumber> center_of_;  // by CellIndex
  std::vector<ObtuseChain> chains_;     // the notes of rings are their numbers
};

}  // namespace flowcert::flow
