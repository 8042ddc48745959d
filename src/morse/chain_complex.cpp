#include "flowcert/chain_complex.h"

#include "geometry/floating_point.h"
#include "morse/chain_boundary.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

// The maximum that an orbit comes to, or infinity. At any other stationary point it goes on, by one of the ways.
std::uint32_t resolved(const StationaryPoints& stationary, const UnstableManifolds& unstable,
                       std::optional<std::size_t> limit, TieBreaking& ties, std::size_t& broken) {
  while (limit && stationary.index(*limit) != StationaryIndex{3, 3}) {
    ++broken;
    limit = unstable.limit_beyond(*limit, ties.choose(2));
  }
  return limit ? static_cast<std::uint32_t>(*limit) : ChainComplex::kInfinity;
}

}  // namespace

ChainComplex::ChainComplex(const PointSet& points, const StationaryPoints& stationary,
                           const UnstableManifolds& unstable, const StableManifolds& stable, std::uint64_t seed) {
  const geometry::IeeeDoubles ieee;
  TieBreaking ties(seed, TieBreaking::Of::kUnstable);
  const RecordFinder finder(stationary);
  std::vector<std::vector<std::uint32_t>> of_maximum(finder.range({3, 3}).second);
  for (std::size_t i = 0; i < unstable.size(); ++i) {
    auto& limits = limits_.emplace_back();
    for (const std::size_t side : {0U, 1U}) {
      limits[side] = resolved(stationary, unstable, unstable.limit(i, side), ties, broken_ties_);
    }
    if (limits[0] == limits[1]) continue;
    for (const std::uint32_t limit : limits) {
      if (limit != kInfinity) of_maximum[limit].push_back(static_cast<std::uint32_t>(unstable.saddle(i)));
    }
  }
  // Critical points of index 0 are listed by name, as the ordinals of the point set are.
  first_ = {0};
  std::size_t next_set = 0;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    if (index == StationaryIndex{1, 1}) {
      for (const PointId name : stationary.contact(record)) {
        cells_.push_back(static_cast<std::uint32_t>(points.ordinal_of_row(name)));
      }
    } else if (index == StationaryIndex{2, 2}) {
      const auto boundary = stable.boundary(next_set++);
      cells_.insert(cells_.end(), boundary.begin(), boundary.end());
    } else if (index == StationaryIndex{3, 3}) {
      cells_.insert(cells_.end(), of_maximum[record].begin(), of_maximum[record].end());
    }
    first_.push_back(cells_.size());
  }
}

}  // namespace flowcert
