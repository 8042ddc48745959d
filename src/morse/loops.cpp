// The reduction of pairs says which columns it added to which. A surface follows these back: it has a point iff the
// point's column was added an odd number of times. Columns are added to later ones alone, so that the latest one that
// is left has all its additions.
#include "flowcert/loops.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <stdexcept>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/ring.h"
#include "morse/chain_boundary.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

Loops::Loops(const StationaryPoints& stationary, const SaddleLinks& links, const Persistence& persistence)
    : stationary_(&stationary), links_(&links), persistence_(&persistence) {
  const auto& counts = stationary.critical_counts();
  first_saddle_ = counts[0] + counts[1];
  const std::vector<ColumnAddition>& additions = persistence.additions();
  first_added_.resize(counts[2] + 1);
  for (const ColumnAddition& addition : additions) ++first_added_[addition.to - first_saddle_ + 1];
  std::partial_sum(first_added_.begin(), first_added_.end(), first_added_.begin());
  added_.resize(additions.size());
  std::vector<std::uint32_t> next(first_added_.begin(), first_added_.end() - 1);
  for (const ColumnAddition& addition : additions) added_[next[addition.to - first_saddle_]++] = addition.from;
}

std::vector<std::uint32_t> Loops::surface(const PersistencePair& pair, const Rational& squared_level) const {
  if (pair.dimension != 1 || !pair.death) throw std::invalid_argument("a surface of a pair of another dimension");
  const geometry::IeeeDoubles ieee;
  const SquaredDistances& values = persistence_->squared_distances();
  // The latest one comes first.
  std::priority_queue<std::pair<std::uint32_t, std::uint32_t>> left;
  const auto push = [&](std::uint32_t saddle) { left.emplace(values.rank(saddle), saddle); };
  const auto added_to = [&](std::uint32_t saddle) {
    const std::size_t k = saddle - first_saddle_;
    return std::span(added_).subspan(first_added_[k], first_added_[k + 1] - first_added_[k]);
  };
  std::vector<std::uint32_t> surface{*pair.death};
  // The births of what is added descend.
  for (const std::uint32_t from : added_to(*pair.death)) {
    if (values.compare(persistence_->partner(from), squared_level) <= 0) break;
    push(from);
  }
  while (!left.empty()) {
    const auto latest = left.top();
    bool is_odd = false;
    for (; !left.empty() && left.top() == latest; left.pop()) is_odd = !is_odd;
    if (!is_odd) continue;
    surface.push_back(latest.second);
    for (const std::uint32_t from : added_to(latest.second)) push(from);
  }
  std::ranges::sort(surface);
  return surface;
}

std::vector<std::uint32_t> Loops::boundary(std::span<const std::uint32_t> surface) const {
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t saddle : surface) {
    const auto lower = links_->lower(saddle - first_saddle_);
    edges.insert(edges.end(), lower.begin(), lower.end());
  }
  std::vector<std::uint32_t> odd;
  add_mod_2(edges, odd);
  return odd;
}

// A walk goes from the least sample that is left to the least neighbour that is left, and so on. Where it comes to a
// sample of its own again, what lies between is a polygon.
std::vector<LoopPolygon> Loops::polygons(std::span<const std::uint32_t> loop) const {
  std::map<PointId, std::set<PointId>> left;
  for (const std::uint32_t edge : loop) {
    const auto ends = stationary_->contact(edge);
    left[ends[0]].insert(ends[1]);
    left[ends[1]].insert(ends[0]);
  }
  std::vector<LoopPolygon> polygons;
  while (!left.empty()) {
    LoopPolygon walk{left.begin()->first};
    std::map<PointId, std::size_t> place{{walk.front(), 0}};
    while (true) {
      const PointId from = walk.back();
      const auto neighbours = left.find(from);
      if (neighbours == left.end()) break;
      const PointId to = *neighbours->second.begin();
      for (const auto& [one, other] : {std::pair{from, to}, std::pair{to, from}}) {
        const auto at = left.find(one);
        at->second.erase(other);
        if (at->second.empty()) left.erase(at);
      }
      const auto [known, is_new] = place.try_emplace(to, walk.size());
      if (is_new) {
        walk.push_back(to);
        continue;
      }
      LoopPolygon polygon(walk.begin() + static_cast<std::ptrdiff_t>(known->second), walk.end());
      for (std::size_t k = known->second + 1; k < walk.size(); ++k) place.erase(walk[k]);
      walk.resize(known->second + 1);
      make_canonical(polygon);
      polygons.push_back(std::move(polygon));
    }
  }
  std::ranges::sort(polygons);
  return polygons;
}

}  // namespace flowcert
