#include "morse/chain_boundary.h"

#include <algorithm>
#include <deque>
#include <map>
#include <stdexcept>

#include "flow/drivers.h"

namespace flowcert::morse {

namespace {

// A path over edges of a Voronoi vertex' polytope that lead to the Voronoi vertex. It has the fewest edges that are
// possible, or is any path that the ties choose.
std::vector<FacetName> path_between(const VoronoiDiagram& diagram, CellIndex cluster, FacetName ends,
                                    TieBreaking& ties) {
  std::map<VertexIndex, std::vector<FacetName>> at;
  for (const FacetName edge : vertex_sources(diagram, cluster).edges) {
    at[edge.v0].push_back(edge);
    at[edge.v1].push_back(edge);
  }
  const auto other_end = [](FacetName edge, VertexIndex v) { return edge.v0 == v ? edge.v1 : edge.v0; };
  struct Step {
    VertexIndex to;
    FacetName by;
  };
  std::map<VertexIndex, FacetName> came_by;
  // If the first one is always chosen, the search is breadth first.
  for (std::deque<Step> open{{ends.v0, ends}}; !open.empty() && !came_by.contains(ends.v1);) {
    const auto next = open.begin() + static_cast<std::ptrdiff_t>(ties.choose(open.size()));
    const Step step = *next;
    open.erase(next);
    if (!came_by.emplace(step.to, step.by).second) continue;
    for (const FacetName edge : at[step.to]) open.push_back({other_end(edge, step.to), edge});
  }
  if (!came_by.contains(ends.v1)) throw std::logic_error("a polytope whose leading edges do not connect its samples");
  std::vector<FacetName> path;
  for (VertexIndex v = ends.v1; v != ends.v0; v = other_end(path.back(), v)) path.push_back(came_by.at(v));
  return path;
}

class TieBreaker {
 public:
  TieBreaker(const VoronoiDiagram& diagram, BackwardWalk& walk, TieBreaking& ties)
      : diagram_(diagram), walk_(walk), ties_(ties) {}

  void add(FrontNumber front, FacetName facet) { tasks_.push_back({front, facet}); }
  // Adds all sides that lead to a front inside the polygon's Voronoi edge.
  void add_sides(FrontNumber front, PolygonRef polygon) {
    for (const PolygonSide& side : diagram_.sides(polygon)) {
      if (side.angle == Sign::kPositive) add(front, side.facet());
    }
  }

  std::vector<BackwardWalk::Step> walk() {
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      BackwardWalk::Back back = walk_.step(task.front, task.facet);
      // A regular stationary point is no end here. The other sides of its polygon follow, or a path past it.
      back.is_regular = false;
      steps_.push_back({task, back});
      if (back.critical) continue;
      const Place place = walk_.place(back.front);
      if (place.kind == Place::Kind::kVertex) {
        for (const FacetName edge : path_between(diagram_, place.vertex, task.facet, ties_)) add(back.front, edge);
      } else {
        add_sides(back.front, place.edge);
      }
    }
    return std::move(steps_);
  }

 private:
  using Task = BackwardWalk::Task;

  const VoronoiDiagram& diagram_;
  BackwardWalk& walk_;
  TieBreaking& ties_;
  std::vector<Task> tasks_;
  std::vector<BackwardWalk::Step> steps_;
};

}  // namespace

std::vector<BackwardWalk::Step> tie_broken_walk(const VoronoiDiagram& diagram, BackwardWalk& walk, FrontNumber root,
                                                std::span<const VertexIndex> samples, TieBreaking& ties) {
  TieBreaker breaker(diagram, walk, ties);
  const Place place = walk.place(root);
  if (samples.size() > 3) {
    breaker.add_sides(root, place.edge);
  } else {
    for (std::size_t k = 0; k < 3; ++k) breaker.add(root, facet_name(samples[k], samples[(k + 1) % 3]));
  }
  return breaker.walk();
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
