// Stable sets are walked once, by several threads (SkeletonWalk). Their geometry is made once more when it is asked
// for.
#include "flowcert/stable_manifolds.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "flow/flow_operator.h"
#include "flow/worker_pool.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "geometry/prefetch.h"
#include "morse/along_the_curve.h"
#include "morse/chain_boundary.h"
#include "morse/layer.h"
#include "morse/record_finder.h"
#include "morse/skeleton_walk.h"

namespace flowcert {

using namespace morse;

// ---- All sets ----

namespace {

constexpr std::size_t kProgressStep = geometry::portion_size(1024);

}  // namespace

struct StableManifolds::Parts {
  struct Set {
    std::uint32_t record = 0;
    SkeletonSize size;
    std::uint32_t share = 0;  // where its boundary is
    std::size_t boundary_first = 0, boundary_count = 0;
  };
  // What one thread finds.
  struct Share {
    std::vector<std::uint32_t> boundaries;
    std::vector<std::uint32_t> tied;                    // sets whose boundary a tie leaves open
    std::vector<std::size_t> lengths, triangle_counts;  // how many there are of each
    StableStatistics statistics;
  };

  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, FlowOptions how)
      : diagram(voronoi), stationary(list), options(how), gabriel(voronoi, list) {}

  [[nodiscard]] std::unique_ptr<SkeletonWalk> make_walk() const {
    return std::make_unique<SkeletonWalk>(SkeletonSource{diagram, stationary, gabriel}, options);
  }

  void compute(const Progress& progress);
  void make_set(SkeletonWalk& worker, std::uint32_t i, std::uint32_t share);
  // Sorts the ends.
  void set_boundary(Set& set, std::vector<std::uint32_t>& ends, std::uint32_t share);
  void count(const Set& set, const SkeletonWalk& worker, Share& share) const;
  void break_ties(SkeletonWalk& worker);
  void sum_up();
  void find_largest();
  [[nodiscard]] std::size_t record_of(std::size_t i) const {
    return i < critical_count ? first_critical + i : first_regular + (i - critical_count);
  }
  [[nodiscard]] const Set& at(std::size_t i) const {
    FLOWCERT_REQUIRES(i < sets.size());
    return sets[i];
  }

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  FlowOptions options;
  GabrielEdges gabriel;
  std::size_t first_critical = 0, critical_count = 0, first_regular = 0;  // records
  std::vector<Set> sets;
  std::vector<Share> shares;
  std::vector<std::pair<std::uint32_t, TieBreaking>> ties_before;  // by set: what its choices begin with
  StableStatistics statistics;
  WorkerPool<SkeletonWalk> workers;
};

void StableManifolds::Parts::count(const Set& set, const SkeletonWalk& worker, Share& share) const {
  for (const std::uint32_t length : worker.lengths()) {
    if (share.lengths.size() <= length) share.lengths.resize(length + 1, 0);
    ++share.lengths[length];
  }
  share.statistics.with_vertex += set.size.has_vertex ? 1 : 0;
  share.statistics.with_interval += set.size.has_interval ? 1 : 0;
  share.statistics.ends_at_regular += worker.regular_backs();
  if (set.size.has_interval) return;
  const std::size_t triangles = 2 * std::size_t{set.size.segments};
  if (share.triangle_counts.size() <= triangles) share.triangle_counts.resize(triangles + 1, 0);
  ++share.triangle_counts[triangles];
  share.statistics.triangle_count += triangles;
}

void StableManifolds::Parts::make_set(SkeletonWalk& worker, std::uint32_t i, std::uint32_t share) {
  Set& set = sets[i];
  set = {};
  set.record = static_cast<std::uint32_t>(record_of(i));
  set.size = worker.walk(set.record);
  if (!stationary.index(set.record).is_critical()) return;
  count(set, worker, shares[share]);
  if (set.size.has_vertex || worker.regular_backs() > 0) {
    shares[share].tied.push_back(i);
  } else {
    set_boundary(set, worker.ends(), share);
  }
}

void StableManifolds::Parts::set_boundary(Set& set, std::vector<std::uint32_t>& ends, std::uint32_t share) {
  std::vector<std::uint32_t>& boundaries = shares[share].boundaries;
  set.share = share;
  set.boundary_first = boundaries.size();
  add_mod_2(ends, boundaries);
  set.boundary_count = boundaries.size() - set.boundary_first;
}

// The first of the sets with the most triangles.
void StableManifolds::Parts::find_largest() {
  for (std::size_t i = 0; i < critical_count; ++i) {
    if (sets[i].size.has_interval) continue;
    if (!statistics.largest || sets[i].size.segments > sets[*statistics.largest].size.segments) statistics.largest = i;
  }
}

// Ties are broken in the order of the list, on which the choices depend.
void StableManifolds::Parts::break_ties(SkeletonWalk& worker) {
  std::vector<std::uint32_t> tied;
  for (const Share& share : shares) tied.insert(tied.end(), share.tied.begin(), share.tied.end());
  std::ranges::sort(tied);
  TieBreaking ties(options.seed, TieBreaking::Of::kStable);
  for (const std::uint32_t i : tied) {
    ties_before.emplace_back(i, ties);
    std::vector<std::uint32_t> ends = worker.tie_broken_ends(sets[i].record, ties);
    set_boundary(sets[i], ends, 0);
  }
  statistics.broken_ties = tied.size();
}

void StableManifolds::Parts::sum_up() {
  for (Share& share : shares) {
    statistics.with_vertex += share.statistics.with_vertex;
    statistics.with_interval += share.statistics.with_interval;
    statistics.ends_at_regular += share.statistics.ends_at_regular;
    statistics.triangle_count += share.statistics.triangle_count;
    for (std::size_t k = 0; k < share.lengths.size(); ++k) {
      if (share.lengths[k] > 0) statistics.n_s2.add(k, share.lengths[k]);
    }
    for (std::size_t k = 0; k < share.triangle_counts.size(); ++k) {
      if (share.triangle_counts[k] > 0) statistics.triangles.add(k, share.triangle_counts[k]);
    }
    share.tied = {}, share.lengths = {}, share.triangle_counts = {};
  }
  find_largest();
}

void StableManifolds::Parts::compute(const Progress& progress) {
  const RecordFinder finder(stationary);
  const auto [first, last] = finder.range({2, 2});
  first_critical = first;
  critical_count = last - first;
  first_regular = finder.range({3, 3}).second;
  sets.resize(critical_count + stationary.size() - first_regular);
  const std::vector<std::uint32_t> order =
      along_the_curve(stationary, sets.size(), [this](std::uint32_t k) { return record_of(k); }, options.threads);
  std::vector<std::unique_ptr<SkeletonWalk>> team;
  const unsigned threads = team_size(options, options.threads);
  team.reserve(threads);
  for (unsigned k = 0; k < threads; ++k) team.push_back(make_walk());
  shares.resize(team.size());
  geometry::in_portions(threads, order.size(), kProgressStep, progress, [&](std::size_t thread, std::size_t at) {
    geometry::prefetch_ahead(at, order.size(), [&](std::size_t later) {
      stationary.prefetch(record_of(order[later]));
      __builtin_prefetch(&sets[order[later]], 1);
    });
    make_set(*team[thread], order[at], static_cast<std::uint32_t>(thread));
  });
  break_ties(*team.front());
  sum_up();
  for (const auto& worker : team) {
    statistics.tally += worker->tally();
    statistics.depth = std::max(statistics.depth, worker->depth());
  }
  if (progress) progress(sets.size(), sets.size());
}

StableManifolds::StableManifolds(const VoronoiDiagram& diagram, const StationaryPoints& stationary, FlowOptions options,
                                 const Progress& progress)
    : parts_(geometry::in_ieee_doubles([&] {
        auto parts = std::make_unique<Parts>(diagram, stationary, options);
        parts->compute(progress);
        return parts;
      })) {}
StableManifolds::~StableManifolds() = default;
StableManifolds::StableManifolds(StableManifolds&&) noexcept = default;
StableManifolds& StableManifolds::operator=(StableManifolds&&) noexcept = default;

const char* back_kind_text(BackKind kind) {
  constexpr std::array<const char*, 4> kTexts = {"critical", "regular", "edge", "vertex"};
  return kTexts.at(static_cast<std::size_t>(kind));
}

StableSet<> StableManifolds::set(std::size_t i) const { return set_of_record(record(i)); }
StableSet<> StableManifolds::set_of_record(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  if (parts_->stationary.index(record).hull_dimension < 2) return {};
  const auto make = [this] { return parts_->make_walk(); };
  return parts_->workers.with(make, [&](SkeletonWalk& worker) { return worker.set(record); });
}
StableSet<> StableManifolds::set_of_infinity() const {
  const geometry::IeeeDoubles ieee;
  const auto make = [this] { return parts_->make_walk(); };
  return parts_->workers.with(make, [](SkeletonWalk& worker) { return worker.set_of_infinity(); });
}
RoundedSegments StableManifolds::rounded_segments(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  const auto make = [this] { return parts_->make_walk(); };
  return parts_->workers.with(make, [&](SkeletonWalk& worker) { return worker.rounded_segments(record(i)); });
}
RoundedSegments StableManifolds::segments_to_boundary(std::size_t i) const {
  const auto& tied = parts_->ties_before;
  const auto at = std::ranges::lower_bound(tied, i, {}, [](const auto& one) { return std::size_t{one.first}; });
  if (at == tied.end() || at->first != i) return rounded_segments(i);
  const geometry::IeeeDoubles ieee;
  TieBreaking ties = at->second;
  const auto make = [this] { return parts_->make_walk(); };
  return parts_->workers.with(make, [&](SkeletonWalk& worker) { return worker.tie_broken_segments(record(i), ties); });
}
std::size_t StableManifolds::size() const { return parts_->sets.size(); }
std::size_t StableManifolds::record(std::size_t i) const { return parts_->at(i).record; }
std::size_t StableManifolds::segment_count(std::size_t i) const { return parts_->at(i).size.segments; }
bool StableManifolds::has_vertex(std::size_t i) const { return parts_->at(i).size.has_vertex; }
bool StableManifolds::has_interval(std::size_t i) const { return parts_->at(i).size.has_interval; }
std::span<const std::uint32_t> StableManifolds::boundary(std::size_t i) const {
  const auto& set = parts_->at(i);
  return std::span(parts_->shares[set.share].boundaries).subspan(set.boundary_first, set.boundary_count);
}
const StableStatistics& StableManifolds::statistics() const { return parts_->statistics; }

}  // namespace flowcert
