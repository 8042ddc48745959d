// The reduction of pairs says which columns it added to which. A surface follows these back: it has a point iff the
// point's column was added an odd number of times. Columns are added to later ones alone, so that the latest one that
// is left has all its additions.
#include "flowcert/loops.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <queue>
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

std::vector<std::uint32_t> Loops::surface(const PersistencePair& pair, const SquaredLevel& level) const {
  if (pair.dimension != 1 || !pair.death) throw std::invalid_argument("a surface of a pair of another dimension");
  const geometry::IeeeDoubles ieee;
  const SquaredDistances& values = persistence_->squared_distances();
  // The births of what is added descend.
  const auto added = added_to(*pair.death);
  const auto end = std::ranges::find_if(
      added, [&](std::uint32_t from) { return values.compare(persistence_->partner(from), level) <= 0; });
  return surface_of(*pair.death, added.first(static_cast<std::size_t>(end - added.begin())));
}

std::vector<std::uint32_t> Loops::whole_surface(std::uint32_t death) const {
  return surface_of(death, added_to(death));
}

std::vector<std::uint32_t> Loops::surface_of(std::uint32_t death, std::span<const std::uint32_t> added) const {
  const SquaredDistances& values = persistence_->squared_distances();
  // The latest one comes first.
  std::priority_queue<std::pair<std::uint32_t, std::uint32_t>> left;
  const auto push = [&](std::uint32_t saddle) { left.emplace(values.rank(saddle), saddle); };
  std::vector<std::uint32_t> surface{death};
  std::ranges::for_each(added, push);
  while (!left.empty()) {
    const auto latest = left.top();
    bool is_odd = false;
    for (; !left.empty() && left.top() == latest; left.pop()) is_odd = !is_odd;
    if (!is_odd) continue;
    surface.push_back(latest.second);
    std::ranges::for_each(added_to(latest.second), push);
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

namespace {

// The edges of a loop, at both of their ends. Samples are told by their places among all that the loop has.
class EdgesLeft {
 public:
  EdgesLeft(std::span<const std::uint32_t> loop, const StationaryPoints& stationary) {
    halves_.reserve(2 * loop.size());
    for (const std::uint32_t edge : loop) {
      const auto ends = stationary.contact(edge);
      halves_.push_back({ends[0], ends[1]});
      halves_.push_back({ends[1], ends[0]});
    }
    std::ranges::sort(halves_);
    is_left_.resize(halves_.size(), true);
    for (std::size_t k = 0; k < halves_.size(); ++k) {
      if (k == 0 || halves_[k - 1].first != halves_[k].first) {
        samples_.push_back(halves_[k].first);
        next_.push_back(k);
      }
    }
  }

  [[nodiscard]] std::size_t samples() const { return samples_.size(); }
  [[nodiscard]] PointId name(std::size_t sample) const { return samples_[sample]; }
  // Takes the edge to the least neighbour to which one is left. Nothing where none is left.
  std::optional<std::size_t> take(std::size_t sample) {
    std::size_t& k = next_[sample];
    while (k < halves_.size() && halves_[k].first == samples_[sample] && !is_left_[k]) ++k;
    if (k == halves_.size() || halves_[k].first != samples_[sample]) return std::nullopt;
    const auto [from, to] = halves_[k];
    is_left_[k] = false;
    is_left_[static_cast<std::size_t>(std::ranges::lower_bound(halves_, std::pair(to, from)) - halves_.begin())] =
        false;
    return static_cast<std::size_t>(std::ranges::lower_bound(samples_, to) - samples_.begin());
  }

 private:
  std::vector<std::pair<PointId, PointId>> halves_;  // ascending
  std::vector<bool> is_left_;
  std::vector<PointId> samples_;   // ascending
  std::vector<std::size_t> next_;  // by sample: where its edges are left
};

}  // namespace

// A walk goes from the least sample that is left to the least neighbour that is left, and so on. Where it comes to a
// sample of its own again, what lies between is a polygon.
std::vector<LoopPolygon> Loops::polygons(std::span<const std::uint32_t> loop) const {
  constexpr std::size_t kNowhere = SIZE_MAX;
  EdgesLeft left(loop, *stationary_);
  std::vector<LoopPolygon> polygons;
  std::vector<std::size_t> walk, place(left.samples(), kNowhere);
  for (std::size_t start = 0; start < left.samples(); ++start) {
    walk.assign(1, start);
    place[start] = 0;
    while (const auto to = left.take(walk.back())) {
      if (place[*to] == kNowhere) {
        place[*to] = walk.size();
        walk.push_back(*to);
        continue;
      }
      LoopPolygon polygon;
      for (std::size_t k = place[*to]; k < walk.size(); ++k) polygon.push_back(left.name(walk[k]));
      for (std::size_t k = place[*to] + 1; k < walk.size(); ++k) place[walk[k]] = kNowhere;
      walk.resize(place[*to] + 1);
      make_canonical(polygon);
      polygons.push_back(std::move(polygon));
    }
    // The walk is at its start again.
    place[start] = kNowhere;
  }
  std::ranges::sort(polygons);
  return polygons;
}

}  // namespace flowcert
