// A cycle's latest index-1 point is the birth of a pair. So the reduced boundary of that pair's death point is added
// until nothing is left.
#include "flowcert/loop_classes.h"

#include <algorithm>
#include <queue>
#include <set>
#include <stdexcept>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/nearest_samples.h"
#include "geometry/rational_point.h"
#include "morse/chain_boundary.h"
#include "morse/dependent_sums.h"
#include "morse/layer.h"
#include "morse/record_finder.h"
#include "morse/toggle.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr StationaryIndex kIndex1{1, 1};

bool is_cycle(const std::set<SampleEdge>& edges) {
  std::set<PointId> odd;
  for (const auto& [p, q] : edges) {
    toggle(odd, p);
    toggle(odd, q);
  }
  return odd.empty();
}

}  // namespace

std::set<SampleEdge> odd_edges(const PointSet& points, std::span<const SampleEdge> edges) {
  std::set<SampleEdge> odd;
  for (const auto& [a, b] : edges) {
    const PointId p = points.name(points.ordinal_of_row(a)), q = points.name(points.ordinal_of_row(b));
    if (p != q) toggle(odd, {std::min(p, q), std::max(p, q)});
  }
  return odd;
}

const char* reason_text(LoopFault fault) {
  constexpr const char* kReasons[] = {"", "not-a-cycle", "edge-too-long", "dies-later", "dies-earlier", "born-earlier"};
  return kReasons[static_cast<std::size_t>(fault)];
}

LoopClasses::LoopClasses(const FlowComplex& complex)
    : complex_(complex),
      persistence_(complex.persistence()),
      loops_(complex.stationary(), complex.links(), persistence_) {}

// The longest edge is split first, into shorter ones. So none is split twice.
std::vector<std::uint32_t> LoopClasses::as_index_1_points(std::span<const SampleEdge> edges) const {
  const geometry::IeeeDoubles ieee;
  const PointSet& points = complex_.points();
  const RecordFinder finder(complex_.stationary());
  std::vector<std::uint32_t> found;
  std::set<std::pair<Rational, SampleEdge>> left;
  const auto place = [&](const SampleEdge& edge) {
    if (const auto record = finder.find(kIndex1, edge)) {
      found.push_back(static_cast<std::uint32_t>(*record));
    } else {
      const RationalPoint p = geometry::exact_position(points.at_row(edge[0]));
      toggle(left, {geometry::squared_distance(p, points.at_row(edge[1])), edge});
    }
  };
  std::ranges::for_each(odd_edges(points, edges), place);
  while (!left.empty()) {
    const SampleEdge longest = left.extract(std::prev(left.end())).value().second;
    const PointId p = longest[0], q = longest[1];
    const RationalPoint middle = geometry::exact_midpoint(points.at_row(p), points.at_row(q));
    // Some sample other than the ends is nearest, because the midpoint is not critical of index 1.
    const std::vector<PointId> nearest = geometry::nearest_samples(points, middle).names;
    const PointId r = *std::ranges::find_if(nearest, [&](PointId name) { return name != p && name != q; });
    place({std::min(p, r), std::max(p, r)});
    place({std::min(r, q), std::max(r, q)});
  }
  std::vector<std::uint32_t> odd;
  add_mod_2(found, odd);
  return odd;
}

const std::vector<std::uint32_t>& LoopClasses::reduced_boundary(std::uint32_t death) {
  const auto [known, is_new] = reduced_.try_emplace(death);
  if (is_new) known->second = loops_.boundary(loops_.whole_surface(death));
  return known->second;
}

std::optional<std::vector<std::uint32_t>> LoopClasses::deaths_of(std::span<const std::uint32_t> loop) {
  const geometry::IeeeDoubles ieee;
  const SquaredDistances& values = persistence_.squared_distances();
  const std::size_t first_saddle =
      complex_.stationary().critical_counts()[0] + complex_.stationary().critical_counts()[1];
  std::priority_queue<std::pair<std::uint32_t, std::uint32_t>> left;  // the latest one comes first
  const auto push = [&](std::uint32_t edge) { left.emplace(values.rank(edge), edge); };
  std::ranges::for_each(loop, push);
  std::vector<std::uint32_t> deaths;
  while (!left.empty()) {
    const auto latest = left.top();
    bool is_odd = false;
    for (; !left.empty() && left.top() == latest; left.pop()) is_odd = !is_odd;
    if (!is_odd) continue;
    const std::uint32_t death = persistence_.partner(latest.second);
    if (death < first_saddle) return std::nullopt;  // it joins components, and a cycle has no such latest point
    deaths.push_back(death);
    for (const std::uint32_t edge : reduced_boundary(death)) push(edge);
    // The latest point of that is the one that was taken away.
    left.pop();
  }
  std::ranges::sort(deaths);
  return deaths;
}

std::optional<SampleEdge> LoopClasses::longer_edge(const std::set<SampleEdge>& edges, const SquaredLevel& level) const {
  const PointSet& points = complex_.points();
  const RecordFinder finder(complex_.stationary());
  std::optional<Rational> exact;
  for (const SampleEdge& edge : edges) {
    if (const auto record = finder.find(kIndex1, edge)) {
      if (persistence_.squared_distances().compare(*record, level) > 0) return edge;
      continue;
    }
    if (!exact) exact = level.exact();
    const RationalPoint p = geometry::exact_position(points.at_row(edge[0]));
    if (geometry::squared_distance(p, points.at_row(edge[1])) > 4 * *exact) return edge;
  }
  return std::nullopt;
}

LoopClass LoopClasses::of(std::span<const SampleEdge> loop, const PersistencePair& pair, const SquaredLevel& level) {
  if (pair.dimension != 1 || !pair.death) throw std::invalid_argument("a loop of a pair of another dimension");
  const geometry::IeeeDoubles ieee;
  const SquaredDistances& values = persistence_.squared_distances();
  LoopClass found;
  const auto with = [&found](LoopFault fault) {
    found.fault = fault;
    return found;
  };
  const std::set<SampleEdge> edges = odd_edges(complex_.points(), loop);
  if (!is_cycle(edges)) return with(LoopFault::kNotACycle);
  found.edge = longer_edge(edges, level);
  if (found.edge) return with(LoopFault::kEdgeTooLong);
  const auto rank = [&](std::uint32_t point) { return values.rank(point); };
  const std::vector<std::uint32_t> deaths = deaths_of(as_index_1_points(loop)).value();
  const std::uint32_t at = values.rank(*pair.death);
  if (!deaths.empty()) found.death = *std::ranges::max_element(deaths, {}, rank);
  if (found.death && rank(*found.death) > at) return with(LoopFault::kDiesLater);
  if (!found.death || rank(*found.death) < at) return with(LoopFault::kDiesEarlier);
  std::ranges::copy_if(deaths, std::back_inserter(found.dying), [&](std::uint32_t death) { return rank(death) == at; });
  if (values.compare(pair.birth, level) != 0) return found;
  std::ranges::copy_if(found.dying, std::back_inserter(found.born),
                       [&](std::uint32_t death) { return rank(persistence_.partner(death)) == rank(pair.birth); });
  return found.born.empty() ? with(LoopFault::kBornEarlier) : found;
}

bool LoopClasses::represent(std::span<const std::vector<SampleEdge>> loops, const PersistencePair& pair,
                            const SquaredLevel& level) {
  const geometry::IeeeDoubles ieee;
  const SquaredDistances& values = persistence_.squared_distances();
  const bool is_at_birth = values.compare(pair.birth, level) == 0;
  const auto is_meant = [&](const PersistencePair& other) {
    return other.dimension == 1 && values.rank(*other.death) == values.rank(*pair.death) &&
           (is_at_birth ? values.rank(other.birth) == values.rank(pair.birth)
                        : values.compare(other.birth, level) <= 0);
  };
  if (std::ranges::count_if(persistence_.pairs(), is_meant) != std::ssize(loops)) return false;
  std::vector<std::vector<std::uint32_t>> sums;
  for (const std::vector<SampleEdge>& loop : loops) {
    LoopClass found = of(loop, pair, level);
    if (found.fault != LoopFault::kNone) return false;
    sums.push_back(std::move(is_at_birth ? found.born : found.dying));
  }
  return std::ranges::count(dependent_sums(sums), true) == 0;
}

bool LoopClasses::are_homologous(std::span<const SampleEdge> a, std::span<const SampleEdge> b,
                                 const SquaredLevel& level) {
  const geometry::IeeeDoubles ieee;
  std::vector<SampleEdge> sum(a.begin(), a.end());
  sum.insert(sum.end(), b.begin(), b.end());
  for (const auto loop : {a, b}) {
    const std::set<SampleEdge> edges = odd_edges(complex_.points(), loop);
    if (!is_cycle(edges) || longer_edge(edges, level)) return false;
  }
  const std::vector<std::uint32_t> deaths = deaths_of(as_index_1_points(sum)).value();
  return std::ranges::all_of(
      deaths, [&](std::uint32_t death) { return persistence_.squared_distances().compare(death, level) <= 0; });
}

}  // namespace flowcert
