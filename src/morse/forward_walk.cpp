// New parts wait on a stack. Each is followed once: along its edge, or through the facet that it flows into.
#include "morse/forward_walk.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace flowcert::morse {

namespace {

Location vertex_location(CellIndex cluster) { return {Place::at_vertex(cluster), kNoPoint}; }

}  // namespace

// ---- The walk ----

void ForwardWalk::clear() {
  order_.clear();
  tasks_.clear();
  vertices_.clear();
  edges_.clear();
  facets_.clear();
  steps_.clear();
  flow_.drop_from(0);
}

SurfaceParts ForwardWalk::walk(FacetName root, CellIndex hint) {
  clear();
  SurfaceParts parts;
  parts.sheets.push_back({root, {}});
  if (diagram_.dimension() < 2) return parts;
  const FacetSides from = facet(root, hint);
  add_root(from);
  while (!tasks_.empty()) {
    const Task task = tasks_.back();
    tasks_.pop_back();
    task.vertex != kNoCell ? follow_vertex(task.vertex) : follow_part(task.polygon, task.part);
  }
  if (diagram_.dimension() == 3) {
    for (std::size_t k = 0; k < from.size(); ++k) parts.sheets.front().corners.push_back(element(from, k));
  }
  for (const auto& [cluster, step] : vertices_) parts.vertices.push_back(cluster);
  for (const auto& [packed, edge] : edges_) parts.edges.push_back(parts_of(edge));
  for (const auto& [number, facet] : facets_) {
    if (number != from.ring().id) list_facet(facet.sides, parts);
  }
  return parts;
}

void ForwardWalk::add_root(const FacetSides& root) {
  for (const RingPiece& piece : root.ring().pieces) {
    if (piece.vertex != kNoCell) add_vertex(piece.vertex);
    if (piece.is_finite()) add_part(piece.polygon(), {TraceEnd::end(0), TraceEnd::end(1)});
  }
}

void ForwardWalk::add_vertex(CellIndex cluster) {
  if (vertices_.try_emplace(cluster).second) tasks_.push_back({cluster, {kNoCell, 0}, {}});
}

// A trace that comes to the end of its edge has the Voronoi vertex there, too (FC-UNST-06).
void ForwardWalk::add_part(PolygonRef polygon, const TracePart& part) {
  for (const TracePart& added : edge(polygon).arrived.add(polygon, part, order_)) {
    tasks_.push_back({kNoCell, polygon, added});
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const CellIndex cluster = part.from.is_end(k) || part.to.is_end(k) ? diagram_.end(polygon, k) : kNoCell;
    if (cluster != kNoCell) add_vertex(cluster);
  }
}

void ForwardWalk::follow_vertex(CellIndex cluster) {
  const FlowStep step = step_of(cluster);
  if (step.stationary) return;
  if (step.crossed.kind == Place::Kind::kEdge) {
    const PolygonRef polygon = step.crossed.edge;
    const std::size_t far = diagram_.end(polygon, 0) == cluster ? 1 : 0;
    edge(polygon).runs_whole_to[far] = true;
    if (diagram_.end(polygon, far) != kNoCell) add_vertex(diagram_.end(polygon, far));
    return;
  }
  const FacetSides& through = facet(step.crossed.facet, cluster);
  const Exit exit = exit_of(through, vertex_location(cluster), step);
  sweep(through, exit, exit);
}

void ForwardWalk::follow_part(PolygonRef polygon, const TracePart& part) {
  const PolygonDriver driver = diagram_.driver(polygon);
  if (driver.shape != Sign::kNegative) return run(polygon, part);
  const FacetSides& through = facet(driver.side, diagram_.cell_of_side(polygon, driver.side));
  const std::size_t piece = faces_.piece_of(through.ring(), polygon);
  const bool forward = through.is_forward(piece);
  const Exit first = exit_of_end(through, piece, forward ? part.to : part.from);
  const Exit last = exit_of_end(through, piece, forward ? part.from : part.to);
  sweep(through, first, last);
}

void ForwardWalk::run(PolygonRef polygon, const TracePart& part) {
  Edge& along = edge(polygon);
  along.runs_to[0] = along.runs_to[0] || side_of(polygon, part.from) < 0;
  along.runs_to[1] = along.runs_to[1] || side_of(polygon, part.to) > 0;
  for (std::size_t k = 0; k < 2; ++k) {
    if (along.runs_to[k] && diagram_.end(polygon, k) != kNoCell) add_vertex(diagram_.end(polygon, k));
  }
}

// Adds what the rays come to that leave from the first exit to the last one, in the ring's order.
void ForwardWalk::sweep(const FacetSides& facet, const Exit& first, const Exit& last) {
  const std::size_t count = 2 * facet.size();
  const auto inside = [&](std::size_t piece, const TraceEnd& from, const TraceEnd& to) {
    if (!facet.piece(piece).is_finite()) return;
    const bool forward = facet.is_forward(piece);
    add_part(facet.piece(piece).polygon(), forward ? TracePart{from, to} : TracePart{to, from});
  };
  const auto ring_end = [&](std::size_t piece, bool is_last) {
    return TraceEnd::end(facet.is_forward(piece) == is_last ? 1 : 0);
  };
  const auto is_inside = [](const Exit& exit) { return exit.place % 2 == 1; };
  const auto point = [](const Exit& exit) { return TraceEnd{TraceEnd::Kind::kPoint, exit.end.at}; };
  if (first.place == last.place && is_inside(first)) return inside(first.place / 2, point(first), point(last));
  if (is_inside(first) && facet.piece(first.place / 2).is_finite()) {
    inside(first.place / 2, point(first), ring_end(first.place / 2, true));
  }
  for (std::size_t place = is_inside(first) ? (first.place + 1) % count : first.place;; place = (place + 1) % count) {
    const std::size_t k = place / 2;
    if (place % 2 == 0) {
      if (facet.vertex(k) != kNoCell) add_vertex(facet.vertex(k));
    } else if (facet.piece(k).is_finite()) {
      inside(k, ring_end(k, false), place == last.place ? point(last) : ring_end(k, true));
    }
    if (place == last.place) return;
  }
}

// ---- Faces ----

const FacetSides& ForwardWalk::facet(FacetName name, CellIndex hint) {
  const FacetRing ring = faces_.ring(name, hint);
  if (const auto known = facets_.find(ring.id); known != facets_.end()) return known->second.sides;
  std::vector<RingPiece> pieces(ring.pieces.begin(), ring.pieces.end());
  const FacetSides sides(diagram_, {ring.id, ring.facet, pieces});
  return facets_.emplace(ring.id, Facet{std::move(pieces), sides}).first->second.sides;
}

ForwardWalk::Edge& ForwardWalk::edge(PolygonRef polygon) {
  Edge& edge = edges_[polygon.packed()];
  edge.polygon = polygon;
  return edge;
}

const FlowStep& ForwardWalk::step_of(CellIndex cluster) {
  std::optional<FlowStep>& step = vertices_[cluster];
  if (!step) step = flow_.step(vertex_location(cluster));
  return *step;
}

const FlowStep& ForwardWalk::step_of(const Location& point) {
  const auto [known, is_new] = steps_.try_emplace(point.point);
  if (is_new) known->second = flow_.step(point);
  return known->second;
}

// The end of the edge beyond which the centre of its polygon lies, or at which; nothing if it is inside the edge.
std::optional<int> ForwardWalk::centre_beyond(PolygonRef polygon) const {
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_vertex = diagram_.end(polygon, k) != kNoCell;
    if (is_vertex && side_at(diagram_, polygon, k) != Sign::kPositive) return static_cast<int>(k);
  }
  return std::nullopt;
}

// On which side of the centre, seen along the edge: 0 at the centre.
int ForwardWalk::side_of(PolygonRef polygon, const TraceEnd& end) {
  if (const auto beyond = centre_beyond(polygon)) return *beyond == 0 ? 1 : -1;
  if (end.kind != TraceEnd::Kind::kPoint) return end.is_end(0) ? -1 : 1;
  const FlowStep& step = step_of(end.at);
  if (step.stationary) return 0;
  const CellIndex to = step.end.place.kind == Place::Kind::kVertex ? step.end.place.vertex : kNoCell;
  return to == diagram_.end(polygon, 1) ? 1 : -1;
}

// ---- Exits ----

ForwardWalk::Exit ForwardWalk::exit_of(const FacetSides& facet, const Location& from, const FlowStep& step) {
  const Place& place = step.end.place;
  const FacetRing& ring = facet.ring();
  SurfaceEnd end;
  end.at = step.end;
  if (place.kind == Place::Kind::kVertex) return {2 * faces_.element_of(ring, place.vertex), end};
  if (place.kind == Place::Kind::kEdge) return {2 * faces_.piece_of(ring, place.edge) + 1, end};
  const auto infinite = std::ranges::find_if(ring.pieces, [](const RingPiece& piece) { return !piece.is_finite(); });
  if (infinite == ring.pieces.end()) throw std::logic_error("a ray to infinity in a bounded facet");
  end = {SurfaceEnd::Kind::kThrough, from, ring.facet};
  return {2 * static_cast<std::size_t>(infinite - ring.pieces.begin()) + 1, end};
}

// At the ends of the near side, rays only touch the facet. A right edge there lies on such a ray.
ForwardWalk::Exit ForwardWalk::exit_of_end(const FacetSides& facet, std::size_t piece, const TraceEnd& end) {
  if (end.kind == TraceEnd::Kind::kPoint) return exit_of(facet, end.at, step_of(end.at));
  const std::size_t n = facet.size();
  const PieceRun near = facet.near();
  const bool is_last = end.is_end(1) == facet.is_forward(piece);  // the end in the ring's order
  std::size_t k = is_last ? (piece + 1) % n : piece;
  if (is_last ? k == (near.first + near.count) % n : k == near.first) {
    if (is_last && facet.angle(k) == Sign::kZero) {
      k = (k + 1) % n;
    } else if (!is_last && facet.angle(k + n - 1) == Sign::kZero) {
      k = (k + n - 1) % n;
    }
    return {2 * k, element(facet, k)};
  }
  const CellIndex cluster = facet.vertex(k);
  return exit_of(facet, vertex_location(cluster), FlowStep(step_of(cluster)));
}

bool ForwardWalk::enters(const FacetSides& facet, CellIndex cluster) {
  if (cluster == kNoCell || !vertices_.contains(cluster)) return false;
  const FlowStep& step = step_of(cluster);
  return !step.stationary && step.crossed.kind == Place::Kind::kFacet && step.crossed.facet == facet.ring().facet;
}

// ---- The parts of the set ----

EdgeParts ForwardWalk::parts_of(const Edge& edge) {
  EdgeParts parts{edge.polygon, edge.arrived.parts(), {}};
  for (std::size_t end = 0; end < 2; ++end) {
    if (edge.runs_to[end] || edge.runs_whole_to[end]) add_runs(edge, end, parts.runs);
  }
  return parts;
}

// What runs towards an end, between the traces.
void ForwardWalk::add_runs(const Edge& edge, std::size_t end, std::vector<TracePart>& runs) {
  std::vector<TracePart> traces = edge.arrived.parts();
  // Seen in the direction of the run: each trace from its rear to its front.
  const auto rear = [&](const TracePart& part) { return end == 1 ? part.from : part.to; };
  const auto front = [&](const TracePart& part) { return end == 1 ? part.to : part.from; };
  if (end == 0) std::ranges::reverse(traces);
  std::optional<TraceEnd> at;
  if (edge.runs_whole_to[end]) at = TraceEnd::end(1 - end);
  const auto add = [&](const TraceEnd& from, const TraceEnd& to) {
    if (order_.compare(edge.polygon, from, to) != 0)
      runs.push_back(end == 1 ? TracePart{from, to} : TracePart{to, from});
  };
  for (const TracePart& trace : traces) {
    if (at) {
      add(*at, rear(trace));
    } else if (side_of(edge.polygon, front(trace)) != (end == 1 ? 1 : -1)) {
      continue;
    }
    at = front(trace);
  }
  if (at) add(*at, TraceEnd::end(end));
}

// The traces on the near side, put together where they meet at Voronoi vertices. Vertices that no trace comes to are
// segments of their own.
std::vector<ForwardWalk::NearPart> ForwardWalk::near_parts(const FacetSides& facet, SurfaceParts& parts) {
  std::vector<NearPart> near;
  const std::size_t n = facet.size();
  for (std::size_t left = facet.near().count; left > 0; --left) {
    const std::size_t piece = (facet.near().first + left - 1) % n;
    const bool forward = facet.is_forward(piece);
    const auto known = edges_.find(facet.piece(piece).packed);
    std::vector<TracePart> traces;
    if (known != edges_.end()) traces = known->second.arrived.parts();
    if (forward) std::ranges::reverse(traces);
    bool is_joined = left < facet.near().count && !near.empty() && near.back().last_piece == (piece + 1) % n &&
                     near.back().last.is_end(facet.is_forward(near.back().last_piece) ? 0 : 1);
    for (const TracePart& trace : traces) {
      const TraceEnd &first = forward ? trace.to : trace.from, &last = forward ? trace.from : trace.to;
      if (is_joined && first.is_end(forward ? 1 : 0)) {
        near.back().last_piece = piece;
        near.back().last = last;
      } else {
        near.push_back({piece, piece, first, last});
      }
      is_joined = false;
    }
    const CellIndex cluster = facet.vertex(piece);
    const bool has_trace = !traces.empty() && near.back().last.is_end(forward ? 0 : 1);
    if (left == 1 || has_trace || !enters(facet, cluster)) continue;
    const std::size_t next = (piece + n - 1) % n;
    const auto beyond = edges_.find(facet.piece(next).packed);
    const std::size_t end = facet.is_forward(next) ? 1 : 0;
    const bool is_begun = beyond != edges_.end() &&
                          std::ranges::any_of(beyond->second.arrived.parts(),
                                              [&](const auto& t) { return t.from.is_end(end) || t.to.is_end(end); });
    if (is_begun) continue;
    const Location start = vertex_location(cluster);
    parts.segments.push_back({facet.ring().facet, start, exit_of(facet, start, FlowStep(step_of(cluster))).end});
  }
  return near;
}

void ForwardWalk::list_facet(const FacetSides& facet, SurfaceParts& parts) {
  for (const NearPart& part : near_parts(facet, parts)) list_near_part(facet, part, parts);
}

// The corners go along the near part, and back along the exits.
void ForwardWalk::list_near_part(const FacetSides& facet, const NearPart& part, SurfaceParts& parts) {
  const auto& [first_piece, last_piece, first, last] = part;
  const Exit from = exit_of_end(facet, first_piece, first);
  const bool is_point = first.kind == TraceEnd::Kind::kPoint && last.kind == TraceEnd::Kind::kPoint &&
                        first_piece == last_piece &&
                        order_.compare(facet.piece(first_piece).polygon(), first, last) == 0;
  if (is_point) {
    parts.segments.push_back({facet.ring().facet, first.at, from.end});
    return;
  }
  SheetParts sheet{facet.ring().facet, {}};
  if (diagram_.dimension() == 3) {
    const std::size_t n = facet.size();
    sheet.corners.push_back(near_corner(facet, first_piece, first));
    for (std::size_t k = first_piece; k != last_piece; k = (k + n - 1) % n) sheet.corners.push_back(element(facet, k));
    sheet.corners.push_back(near_corner(facet, last_piece, last));
    const Exit to = exit_of_end(facet, last_piece, last);
    sheet.corners.push_back(to.end);
    for (std::size_t place = to.place; place != from.place; place = (place + 2 * n - 1) % (2 * n)) {
      if (place % 2 == 0) sheet.corners.push_back(element(facet, place / 2));
    }
    sheet.corners.push_back(from.end);
  }
  parts.sheets.push_back(std::move(sheet));
}

SurfaceEnd ForwardWalk::near_corner(const FacetSides& facet, std::size_t piece, const TraceEnd& end) {
  if (end.kind == TraceEnd::Kind::kPoint) return {SurfaceEnd::Kind::kPoint, end.at};
  return element(facet, end.is_end(1) == facet.is_forward(piece) ? piece + 1 : piece);
}

SurfaceEnd ForwardWalk::element(const FacetSides& facet, std::size_t k) {
  if (facet.vertex(k) != kNoCell) return {SurfaceEnd::Kind::kPoint, vertex_location(facet.vertex(k))};
  return {SurfaceEnd::Kind::kAlong, {}, {0, 0}, facet.end_at_infinity(k)};
}

}  // namespace flowcert::morse
