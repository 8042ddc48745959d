#include "morse/chain_boundary.h"

#include <algorithm>
#include <deque>
#include <map>
#include <stdexcept>

#include "flow/drivers.h"

namespace flowcert::morse {

namespace {

// A path from v0 to v1 over edges of a Voronoi vertex' polytope. No edge of it is obtuse, and none passes through the
// Voronoi vertex. It has the fewest edges that are possible, or is any path that the ties choose.
std::vector<PolytopeEdge> path_between(const Diagram& diagram, CellIndex cluster, FacetName ends, TieBreaking& ties) {
  const VertexSources sources = vertex_sources(diagram, cluster);
  std::map<VertexIndex, std::vector<const PolytopeEdge*>> at;
  for (const PolytopeEdge& edge : sources.edges) {
    if (edge.angles[0] == Sign::kNegative || edge.angles[1] == Sign::kZero) continue;
    at[edge.facet.v0].push_back(&edge);
    at[edge.facet.v1].push_back(&edge);
  }
  const auto other_end = [](const PolytopeEdge& edge, VertexIndex v) {
    return edge.facet.v0 == v ? edge.facet.v1 : edge.facet.v0;
  };
  struct Step {
    VertexIndex to;
    const PolytopeEdge* by;
  };
  std::map<VertexIndex, const PolytopeEdge*> came_by;
  // If the first one is always chosen, the search is breadth first.
  for (std::deque<Step> open{{ends.v0, nullptr}}; !open.empty() && !came_by.contains(ends.v1);) {
    const auto next = open.begin() + static_cast<std::ptrdiff_t>(ties.choose(open.size()));
    const Step step = *next;
    open.erase(next);
    if (!came_by.emplace(step.to, step.by).second) continue;
    for (const PolytopeEdge* edge : at[step.to]) open.push_back({other_end(*edge, step.to), edge});
  }
  if (!came_by.contains(ends.v1)) throw std::logic_error("a polytope without a path of acute edges");
  std::vector<PolytopeEdge> path;
  for (VertexIndex v = ends.v1; v != ends.v0; v = other_end(path.back(), v)) path.push_back(*came_by.at(v));
  return path;
}

class TieBreaker {
 public:
  TieBreaker(const Diagram& diagram, BackwardWalk& walk, TieBreaking& ties)
      : diagram_(diagram), walk_(walk), ties_(ties) {}

  void add(FrontNumber front, FacetName facet) { tasks_.push_back({front, facet}); }
  // Adds all sides that lead to a front inside the polygon's Voronoi edge.
  void add_sides(FrontNumber front, PolygonRef polygon) {
    for (const PolygonSide& side : diagram_.sides(polygon)) {
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
      // A regular stationary point is no end here. The other sides of its polygon follow, or a path past it.
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
    for (const PolytopeEdge& edge : path_between(diagram_, cluster, ends, ties_)) {
      if (edge.leads()) {
        add(front, edge.facet);
      } else {
        add_along(cluster, edge);
      }
    }
  }

  // Goes from a Voronoi vertex along the Voronoi edge of a right polygon to the middle of its longest side, or to the
  // other Voronoi vertex if that comes first.
  void add_along(CellIndex cluster, const PolytopeEdge& edge) {
    const PolygonRef polygon = edge.right_polygon;
    const std::size_t far = diagram_.end(polygon, 0) == cluster ? 1 : 0;
    const CellIndex other = diagram_.end(polygon, far);
    if (other == kNoCell || side_at(diagram_, polygon, far) == Sign::kPositive) {
      add_sides(walk_.at_center(diagram_.corners(polygon), polygon), polygon);
    } else {
      add_path(other, walk_.at_vertex(other), edge.facet);
    }
  }

  const Diagram& diagram_;
  BackwardWalk& walk_;
  TieBreaking& ties_;
  std::vector<Task> tasks_;
  std::vector<std::uint32_t> chain_;
};

}  // namespace

std::vector<std::uint32_t> tie_broken_boundary(const Diagram& diagram, BackwardWalk& walk, FrontNumber root,
                                               std::span<const VertexIndex> samples, TieBreaking& ties) {
  TieBreaker breaker(diagram, walk, ties);
  const Place place = walk.place(root);
  if (samples.size() > 3) {
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

}  // namespace flowcert::morse
