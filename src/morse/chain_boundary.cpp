// See chain_boundary.h.
#include "morse/chain_boundary.h"

#include <algorithm>
#include <deque>
#include <map>
#include <stdexcept>

#include "flow/drivers.h"

namespace flowcert {

namespace {

FacetName facet_name(VertexIndex v, VertexIndex w) { return {std::min(v, w), std::max(v, w)}; }

// Edges of a Voronoi vertex' polytope that lead from v0 to v1, all of them not obtuse and none of them
// through the Voronoi vertex: the fewest there are.
std::vector<PolytopeEdge> path_between(const VoronoiFaces& faces, CellIndex cluster, FacetName ends) {
  const VertexSources sources = vertex_sources(faces, cluster);
  std::map<VertexIndex, std::vector<const PolytopeEdge*>> at;
  for (const PolytopeEdge& edge : sources.edges) {
    if (edge.angles[0] == Sign::kNegative || edge.angles[1] == Sign::kZero) continue;
    at[edge.facet.v0].push_back(&edge);
    at[edge.facet.v1].push_back(&edge);
  }
  std::map<VertexIndex, const PolytopeEdge*> came_by{{ends.v0, nullptr}};
  const auto other_end = [](const PolytopeEdge& edge, VertexIndex v) {
    return edge.facet.v0 == v ? edge.facet.v1 : edge.facet.v0;
  };
  for (std::deque<VertexIndex> next{ends.v0}; !next.empty() && !came_by.contains(ends.v1); next.pop_front()) {
    for (const PolytopeEdge* edge : at[next.front()]) {
      const VertexIndex there = other_end(*edge, next.front());
      if (came_by.emplace(there, edge).second) next.push_back(there);
    }
  }
  if (!came_by.contains(ends.v1)) throw std::logic_error("a polytope without a path of acute edges");
  std::vector<PolytopeEdge> path;
  for (VertexIndex v = ends.v1; v != ends.v0; v = other_end(path.back(), v)) path.push_back(*came_by.at(v));
  return path;
}

class TieBreaker {
 public:
  TieBreaker(const VoronoiFaces& faces, BackwardWalk& walk) : faces_(faces), walk_(walk) {}

  void add(FrontNumber front, FacetName facet) { tasks_.push_back({front, facet}); }
  // All sides that lead to a front inside the polygon's Voronoi edge.
  void add_sides(FrontNumber front, PolygonRef polygon) {
    for (const PolygonSide& side : faces_.sides(polygon)) {
      if (side.angle == Sign::kPositive) add(front, {side.v0, side.v1});
    }
  }

  std::vector<std::uint32_t> chain() {
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      const BackwardWalk::Back back = walk_.step(task.front, task.facet);
      if (back.critical) {
        chain_.push_back(*back.critical);
        continue;
      }
      // At a regular stationary point, too, the other sides of its polygon, or a path past it.
      const Place place = walk_.place(back.front);
      if (place.kind == Place::Kind::kVertex) {
        add_path(place.vertex, back.front, task.facet);
      } else {
        add_sides(back.front, place.edge);
      }
    }
    return std::move(chain_);
  }

 private:
  struct Task {
    FrontNumber front;
    FacetName facet;
  };

  void add_path(CellIndex cluster, FrontNumber front, FacetName ends) {
    for (const PolytopeEdge& edge : path_between(faces_, cluster, ends)) {
      if (edge.leads()) {
        add(front, edge.facet);
      } else {
        add_along(cluster, edge);
      }
    }
  }

  // From a Voronoi vertex along the Voronoi edge of a right polygon, to the middle of its longest side, or to
  // the other Voronoi vertex if that comes first.
  void add_along(CellIndex cluster, const PolytopeEdge& edge) {
    const PolygonRef polygon = edge.right_polygon;
    const std::size_t far = faces_.end(polygon, 0) == cluster ? 1 : 0;
    const CellIndex other = faces_.end(polygon, far);
    if (other == kNoCell || side_at(faces_, polygon, far) == Sign::kPositive) {
      add_sides(walk_.at_center(faces_.corners(polygon), polygon), polygon);
    } else {
      add_path(other, walk_.at_vertex(other), edge.facet);
    }
  }

  const VoronoiFaces& faces_;
  BackwardWalk& walk_;
  std::vector<Task> tasks_;
  std::vector<std::uint32_t> chain_;
};

}  // namespace

std::vector<std::uint32_t> tie_broken_boundary(const VoronoiFaces& faces, BackwardWalk& walk,
                                               FrontNumber root, std::span<const VertexIndex> samples) {
  TieBreaker breaker(faces, walk);
  const Place place = walk.place(root);
  if (place.edge.cell != kNoCell) {
    breaker.add_sides(root, place.edge);
  } else {
    for (std::size_t k = 0; k < 3; ++k) breaker.add(root, facet_name(samples[k], samples[(k + 1) % 3]));
  }
  return breaker.chain();
}

void add_mod_2(std::vector<std::uint32_t>& chain, std::vector<std::uint32_t>& sum) {
  std::sort(chain.begin(), chain.end());
  for (auto at = chain.begin(); at != chain.end();) {
    const auto end = std::find_if(at, chain.end(), [&](std::uint32_t other) { return other != *at; });
    if ((end - at) % 2 == 1) sum.push_back(*at);
    at = end;
  }
}

}  // namespace flowcert
