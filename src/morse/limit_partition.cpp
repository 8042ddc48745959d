// Faces are finished in the order in which they ask for one another, over a stack of tasks.
#include "morse/limit_partition.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "geometry/contract.h"

namespace flowcert::morse {

namespace {

constexpr std::size_t kEdgesBetweenTellings = 1024;

}  // namespace

LimitPartition::LimitPartition(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                               const FlowOptions& options, const Progress& progress, std::size_t total)
    : stationary_(stationary),
      gabriel_(diagram, stationary),
      diagram_(diagram),
      faces_(diagram),
      flow_(make_flow_operator(faces_, options)),
      walk_(faces_, *flow_, gabriel_) {
  if (diagram_.dimension() < 2) return;
  note_records();
  divide_all_edges(progress, total);
  walk_.clear();
  fronts_ = {};
}

void LimitPartition::note_records() {
  const std::size_t cells = diagram_.delaunay().finite_count;
  of_vertex_.assign(cells, kUnset);
  of_edge_.assign(4 * cells, kNotDivided);
  record_of_edge_.assign(4 * cells, kInfinityLimit);
  point_of_vertex_.assign(cells, kNoDivision);
  for (std::size_t record = 0; record < stationary_.size(); ++record) {
    if (stationary_.index(record).hull_dimension < 2) continue;
    const Place place = place_of_record(stationary_, record);
    if (place.kind == Place::Kind::kVertex) {
      of_vertex_[place.vertex] = static_cast<Limit>(record);
    } else {
      record_of_edge_[place.edge.packed()] = static_cast<std::uint32_t>(record);
    }
  }
}

// ---- The order of work ----

void LimitPartition::divide_all_edges(const Progress& progress, std::size_t total) {
  for_each_polygon(diagram_, [&](PolygonRef polygon) {
    while (!request_edge(polygon)) finish_tasks(progress, total);
  });
  if (diagram_.dimension() < 3) return;
  // Some Voronoi vertices are at the ends of no edge whose division needed them.
  for (CellIndex cell = 0; cell < diagram_.delaunay().finite_count; ++cell) {
    if (diagram_.complex().cluster(cell) != cell) continue;
    while (!request_vertex(cell)) finish_tasks(progress, total);
  }
}

// A task that is not finished has asked for others, which come first. The first edge may ask for all the others, so
// progress is reported here.
void LimitPartition::finish_tasks(const Progress& progress, std::size_t total) {
  while (!tasks_.empty()) {
    if (progress && divided_ >= told_) {
      progress(divided_, total);
      told_ = divided_ + kEdgesBetweenTellings;
    }
    const Task task = tasks_.back();
    tasks_.back().is_second_try = true;
    const bool is_finished = task.is_vertex ? finish_vertex(task) : finish_facet(task.facet, task.cell);
    if (is_finished) tasks_.pop_back();
  }
}

bool LimitPartition::request_vertex(CellIndex cluster) {
  if (of_vertex_[cluster] != kUnset) return true;
  tasks_.push_back({true, {0, 0}, cluster});
  return false;
}

bool LimitPartition::request_edge(PolygonRef polygon) {
  if (of_edge_[polygon.packed()] != kNotDivided) return true;
  const PolygonDriver driver = diagram_.driver(polygon);
  if (driver.shape != Sign::kNegative) return divide_along(polygon);
  tasks_.push_back({false, driver.side, diagram_.cell_of_side(polygon, driver.side)});
  return false;
}

bool LimitPartition::finish_vertex(const Task& task) {
  const CellIndex cluster = task.cell;
  if (of_vertex_[cluster] != kUnset) return true;
  const VertexFlow flow = vertex_flow(diagram_, cluster);
  if (flow.way == VertexFlow::Way::kStays) throw std::logic_error("a stationary point that is not listed");
  if (flow.way == VertexFlow::Way::kAlongEdge) {
    const CellIndex next = diagram_.end(flow.edge, diagram_.end(flow.edge, 0) == cluster ? 1 : 0);
    if (next != kNoCell && !request_vertex(next)) return false;
    of_vertex_[cluster] = next == kNoCell ? kInfinityLimit : of_vertex_[next];
    return true;
  }
  // The division of that facet knows all vertices of its near side.
  if (task.is_second_try) throw std::logic_error("a Voronoi vertex that the facet of its driver does not reach");
  tasks_.push_back({false, flow.facet, cluster});
  return false;
}

bool LimitPartition::finish_facet(FacetName facet, CellIndex hint) {
  const FacetSides sides(diagram_, faces_.ring(facet, hint));
  const PieceRun near = sides.near();
  if (near.count == 0 || of_edge_[sides.piece(near.first).packed] != kNotDivided) return true;
  if (!is_ready(sides)) return false;
  make_fan(sides);
  divide_near_side(sides);
  return true;
}

// Asks for all that is missing.
bool LimitPartition::is_ready(const FacetSides& sides) {
  bool ready = true;
  const PieceRun far = sides.far();
  for (std::uint32_t i = 0; i < far.count; ++i) {
    const RingPiece& piece = sides.piece(far.first + i);
    if (i > 0 && piece.vertex != kNoCell && !request_vertex(piece.vertex)) ready = false;
    if (piece.is_finite() && !request_edge(piece.polygon())) ready = false;
  }
  return ready;
}

// ---- Edges ----

Limit LimitPartition::limit_at_end(PolygonRef polygon, std::size_t end) const {
  const CellIndex cluster = diagram_.end(polygon, end);
  return cluster == kNoCell ? kInfinityLimit : of_vertex_[cluster];
}

// The polygon contains its centre, and the edge runs away from that. If the centre lies on neither side of end 0, or
// beyond it, all of the edge runs to end 1.
bool LimitPartition::divide_along(PolygonRef polygon) {
  const std::uint32_t record = record_of_edge_[polygon.packed()];
  const bool has_center = record != kInfinityLimit;
  const bool starts_at_0 =
      !has_center && diagram_.end(polygon, 0) != kNoCell && side_at(diagram_, polygon, 0) != Sign::kPositive;
  bool is_ready = true;
  for (std::size_t end = 0; end < 2; ++end) {
    if (!has_center && end != (starts_at_0 ? 1u : 0u)) continue;
    const CellIndex cluster = diagram_.end(polygon, end);
    if (cluster != kNoCell && !request_vertex(cluster)) is_ready = false;
  }
  if (!is_ready) return false;
  slice_.clear();
  if (has_center) {
    slice_.push_back({limit_at_end(polygon, 0)});
    slice_.push_back({record, add({DivisionPoint::Kind::kCenter, polygon.packed()})});
    fronts_.resize(points_.size());
    fronts_.back() = walk_.at_center(diagram_.corners(polygon), polygon);
    slice_.push_back({limit_at_end(polygon, 1)});
  } else {
    slice_.push_back({limit_at_end(polygon, starts_at_0 ? 1 : 0)});
  }
  store(polygon, false);
  return true;
}

void LimitPartition::store(PolygonRef polygon, bool is_reversed) {
  if (is_reversed) std::ranges::reverse(slice_);
  ++divided_;
  of_edge_[polygon.packed()] = static_cast<std::uint32_t>(divisions_.size());
  divisions_.push_back({static_cast<Limit>(slice_.size())});
  divisions_.insert(divisions_.end(), slice_.begin(), slice_.end());
}

// The rays of the fan meet the near side clockwise, and so against the ring's order.
void LimitPartition::divide_near_side(const FacetSides& sides) {
  const PieceRun near = sides.near();
  std::size_t left = near.count;  // pieces that are not divided yet; the last one is at hand
  const auto at_hand = [&] { return near.first + left - 1; };
  const auto close_piece = [&] {
    store(sides.piece(at_hand()).polygon(), sides.is_forward(at_hand()));
    slice_.clear();
    --left;
  };
  slice_.clear();
  Limit arc = kInfinityLimit;
  for (const FanEntry& entry : fan_) {
    if (entry.point == kNoDivision) {
      arc = entry.limit;
      slice_.push_back({arc});
      continue;
    }
    const BackwardWalk::Back back = walk_.step(front_of(sides, entry), sides.ring().facet);
    const Place place = walk_.place(back.front);
    bool is_vertex = false;
    while (!is_vertex && !(place.kind == Place::Kind::kEdge && place.edge == sides.piece(at_hand()).polygon())) {
      const CellIndex cluster = sides.vertex(at_hand());
      is_vertex = place.kind == Place::Kind::kVertex && place.vertex == cluster;
      of_vertex_[cluster] = is_vertex ? entry.limit : arc;
      if (is_vertex) behind_vertex_.emplace(cluster, point_of(sides, entry));
      close_piece();
      if (!is_vertex) slice_.push_back({arc});
    }
    if (is_vertex) continue;
    const PointOfDivision far = point_of(sides, entry);
    DivisionPoint point{DivisionPoint::Kind::kCrossing, far, sides.ring().facet, sides.piece(at_hand()).apex};
    const bool is_element = entry.point == kAtElement;
    point.far_apex = sides.piece(is_element ? sides.ring().before(entry.piece) : entry.piece).apex;
    point.other = sides.piece(entry.piece).apex;
    slice_.push_back({entry.limit, add(point)});
    fronts_.resize(points_.size());
    fronts_.back() = back.front;
  }
  while (left > 1) {
    of_vertex_[sides.vertex(at_hand())] = arc;
    close_piece();
    slice_.push_back({arc});
  }
  close_piece();
}

// ---- Fans ----

void LimitPartition::append_arc(Limit limit) {
  if (!fan_.empty()) {
    FanEntry& last = fan_.back();
    if (last.point == kNoDivision) {
      // Far out on a Voronoi edge, everything flows to infinity.
      FLOWCERT_REQUIRES(last.limit == limit);
      return;
    }
    if (fan_.size() > 1 && last.limit == limit && fan_[fan_.size() - 2].limit == limit) {
      fan_.pop_back();
      return;
    }
  }
  fan_.push_back({limit, kNoDivision, 0});
}

void LimitPartition::append_element(const FacetSides& sides, std::uint32_t piece) {
  const CellIndex cluster = sides.vertex(piece);
  if (cluster != kNoCell) fan_.push_back({of_vertex_[cluster], kAtElement, piece});
}

void LimitPartition::append_edge(const FacetSides& sides, std::uint32_t piece) {
  if (!sides.piece(piece).is_finite()) return append_arc(kInfinityLimit);
  const std::span<const Division> divisions = edge(sides.piece(piece).polygon());
  const bool is_forward = divisions.size() == 1 || sides.is_forward(piece);
  for (std::size_t i = 0; i < divisions.size(); ++i) {
    const Division& next = divisions[is_forward ? i : divisions.size() - 1 - i];
    if (next.is_arc()) {
      append_arc(next.limit);
    } else {
      fan_.push_back({next.limit, next.point, piece});
    }
  }
}

void LimitPartition::make_fan(const FacetSides& sides) {
  fan_.clear();
  const PieceRun far = sides.far();
  for (std::uint32_t i = 0; i < far.count; ++i) {
    const auto piece = static_cast<std::uint32_t>((far.first + i) % sides.size());
    if (i > 0) append_element(sides, piece);
    append_edge(sides, piece);
  }
}

// The fan goes all the way around. It begins with a point then, unless there is none.
void LimitPartition::close_fan(const FacetSides& sides) {
  append_element(sides, 0);
  const std::size_t size = fan_.size();
  const bool ends_with_point = fan_.back().point != kNoDivision;
  const bool is_kept =
      ends_with_point && !(fan_.back().limit == fan_.front().limit && fan_[size - 2].limit == fan_.front().limit);
  if (is_kept) {
    std::rotate(fan_.begin(), fan_.end() - 1, fan_.end());
    return;
  }
  if (ends_with_point) fan_.pop_back();
  if (fan_.size() > 1) fan_.erase(fan_.begin());
}

FrontNumber LimitPartition::front_of(const FacetSides& sides, const FanEntry& entry) {
  if (entry.point == kAtElement) return walk_.at_vertex(sides.vertex(entry.piece));
  return fronts_[entry.point];
}

PointOfDivision LimitPartition::point_at_vertex(CellIndex cluster) {
  PointOfDivision& point = point_of_vertex_[cluster];
  if (point == kNoDivision) point = add({DivisionPoint::Kind::kVertex, cluster});
  return point;
}

PointOfDivision LimitPartition::point_of(const FacetSides& sides, const FanEntry& entry) {
  return entry.point == kAtElement ? point_at_vertex(sides.vertex(entry.piece)) : entry.point;
}

// ---- Directions ----

Division LimitPartition::direction_to_end(PolygonRef polygon, std::size_t end) {
  const CellIndex cluster = diagram_.end(polygon, end);
  if (cluster != kNoCell) return {of_vertex_[cluster], point_at_vertex(cluster)};
  return {kInfinityLimit, add({DivisionPoint::Kind::kEnd, polygon.packed(), {0, 0}, static_cast<VertexIndex>(end)})};
}

void LimitPartition::directions_of_face_2(std::size_t record, std::vector<Division>& list) {
  if (stationary_.index(record).is_critical()) {
    const PolygonRef polygon = edge_of_record(stationary_, record);
    list.push_back(direction_to_end(polygon, 0));
    list.push_back(direction_to_end(polygon, 1));
    return;
  }
  const CellIndex cluster = cell_of_record(stationary_, record);
  const PolygonRef polygon = polygons_through(diagram_, cluster).front();
  list.push_back(direction_to_end(polygon, diagram_.end(polygon, 0) == cluster ? 1 : 0));
}

void LimitPartition::directions(std::size_t record, std::vector<Division>& list) {
  list.clear();
  const StationaryIndex index = stationary_.index(record);
  FLOWCERT_REQUIRES(index.face_dimension == 1 || index.face_dimension == 2);
  if (index.face_dimension == 2) return directions_of_face_2(record, list);
  const FacetRing ring =
      faces_.ring(facet_of_record(diagram_, stationary_, record), cell_of_record(stationary_, record));
  if (ring.size() == 0) {
    list.push_back({kInfinityLimit});
    return;
  }
  const FacetSides sides(diagram_, ring);
  make_fan(sides);
  if (index.is_critical()) close_fan(sides);
  // The midpoint lies on one piece with a right angle, or between two. The ring goes on along the last one.
  const auto towards = [&](std::size_t piece, bool is_ahead) {
    return direction_to_end(sides.piece(piece).polygon(), sides.is_forward(piece) == is_ahead ? 1 : 0);
  };
  if (!index.is_critical()) list.push_back(towards(sides.last_right(), true));
  for (const FanEntry& entry : fan_) {
    list.push_back({entry.limit, entry.point == kNoDivision ? kNoDivision : point_of(sides, entry)});
  }
  if (!index.is_critical()) list.push_back(towards(sides.first_right(), false));
}

}  // namespace flowcert::morse
