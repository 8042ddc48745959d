#include "morse/backward_walk.h"

#include <stdexcept>

#include "geometry/rational_point.h"

namespace flowcert::morse {

FrontNumber BackwardWalk::add(const Front& front) {
  fronts_.push_back(front);
  return static_cast<FrontNumber>(fronts_.size() - 1);
}

FrontNumber BackwardWalk::at_vertex(CellIndex cluster) { return add({.place = Place::at_vertex(cluster)}); }

FrontNumber BackwardWalk::at_infinity(const RationalPoint& direction, CellIndex hint) {
  directions_.push_back(direction);
  return add({.place = {.edge = {hint, 0}}, .direction = directions_.size() - 1});
}

FrontNumber BackwardWalk::on_ray(FrontNumber front, FacetName facet) {
  Front on_it = fronts_[front];
  on_it.point =
      flow_.add(exact_midpoint(faces_.diagram().point(facet.v0), faces_.diagram().point(facet.v1)) + direction(front));
  return add(on_it);
}

FrontNumber BackwardWalk::at_center(const std::array<VertexIndex, 3>& samples, PolygonRef edge) {
  return add({.place = Place::on_edge(edge), .samples = samples});
}

void BackwardWalk::clear() {
  fronts_.clear();
  directions_.clear();
  flow_.drop_from(0);
}

// Constructs all points that the front's point depends on, in the order of the walk, and then the point itself.
Location BackwardWalk::location(FrontNumber front) {
  pending_.clear();
  for (FrontNumber at = front; at != kNone && !is_constructed(fronts_[at]); at = fronts_[at].before) {
    pending_.push_back(at);
  }
  while (!pending_.empty()) {
    Front& next = fronts_[pending_.back()];
    pending_.pop_back();
    if (next.before == kNone) {
      next.point = flow_.add_center(next.samples);
    } else {
      const Front& before = fronts_[next.before];
      next.point = flow_.cross_back({before.place, before.point}, next.facet, next.apex);
    }
  }
  return {fronts_[front].place, fronts_[front].point};
}

BackwardWalk::Back BackwardWalk::step(FrontNumber front, FacetName facet) {
  if (const auto record = gabriel_.find(facet)) return {record, false, 0};
  if (is_at_infinity(front)) front = on_ray(front, facet);
  const Place& from = fronts_[front].place;
  const CellIndex hint = from.kind == Place::Kind::kVertex ? from.vertex : from.edge.cell;
  const std::optional<BackwardStep> one = flow_.one_back(from, facet, hint);
  const BackwardStep step = one ? *one : flow_.step_back(location(front), facet, hint);
  Front back{.place = step.back, .facet = facet};
  back.depth = fronts_[front].depth + 1;
  if (step.is_midpoint) {
    if (step.back.kind == Place::Kind::kFacet) throw std::logic_error("a Gabriel edge that is not listed");
    if (step.back.kind == Place::Kind::kEdge) back.samples = faces_.diagram().corners(step.back.edge);
  } else {
    back.before = front;
    back.apex = step.apex;
  }
  return {std::nullopt, step.is_midpoint, add(back)};
}

}  // namespace flowcert::morse
