#include "flowcert/chain_complex.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/prefetch.h"
#include "morse/chain_boundary.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

// The maximum that an orbit comes to, or infinity. At any other stationary point it goes on, by one of the ways.
std::uint32_t resolved(const std::pair<std::size_t, std::size_t>& maxima, const UnstableManifolds& unstable,
                       std::optional<std::size_t> limit, TieBreaking& ties, std::size_t& broken) {
  while (limit && (*limit < maxima.first || *limit >= maxima.second)) {
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
  const auto edges = finder.range({1, 1}), saddles = finder.range({2, 2}), maxima = finder.range({3, 3});
  limits_.resize(unstable.size());
  for (std::size_t i = 0; i < unstable.size(); ++i) {
    for (const std::size_t side : {0U, 1U}) {
      limits_[i][side] = resolved(maxima, unstable, unstable.limit(i, side), ties, broken_ties_);
    }
  }
  // How many cells the boundary before has, and then, as a sum, where the next one begins.
  first_.assign(stationary.size() + 1, 0);
  for (std::size_t edge = edges.first; edge < edges.second; ++edge) first_[edge + 1] = 2;
  for (std::size_t i = 0; i < limits_.size(); ++i) first_[saddles.first + i + 1] = stable.boundary(i).size();
  const auto for_each_side = [&](const auto& use) {
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      geometry::prefetch_ahead(i, limits_.size(), [this](std::size_t later) {
        for (const std::uint32_t limit : limits_[later]) {
          if (limit != kInfinity) prefetch(limit);
        }
      });
      if (limits_[i][0] == limits_[i][1]) continue;
      for (const std::uint32_t limit : limits_[i]) {
        if (limit != kInfinity) use(limit, static_cast<std::uint32_t>(saddles.first + i));
      }
    }
  };
  for_each_side([this](std::uint32_t maximum, std::uint32_t) { ++first_[maximum + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cells_.resize(first_.back());
  // Critical points of index 0 are listed by name, as the ordinals of the point set are.
  for (std::size_t edge = edges.first; edge < edges.second; ++edge) {
    const auto contact = stationary.contact(edge);
    for (std::size_t k = 0; k < 2; ++k) {
      cells_[first_[edge] + k] = static_cast<std::uint32_t>(points.ordinal_of_row(contact[k]));
    }
  }
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    geometry::prefetch_ahead(i, limits_.size(),
                             [&](std::size_t later) { __builtin_prefetch(stable.boundary(later).data()); });
    std::ranges::copy(stable.boundary(i), cells_.begin() + static_cast<std::ptrdiff_t>(first_[saddles.first + i]));
  }
  std::vector<std::size_t> next(first_.begin() + static_cast<std::ptrdiff_t>(maxima.first), first_.end());
  for_each_side([&](std::uint32_t maximum, std::uint32_t saddle) { cells_[next[maximum - maxima.first]++] = saddle; });
}

}  // namespace flowcert
