// The cocycle comes from reducing coboundaries: that of the pair's birth is reduced until its earliest point is the
// death. What is earlier is the death of a pair that is born later, and the reduced coboundary of that birth is added.
// A reduced one is made when it is first needed.
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "flowcert/loops.h"
#include "geometry/floating_point.h"
#include "morse/layer.h"
#include "morse/toggle.h"

namespace flowcert {

using namespace morse;

namespace {

// Points in the order of the reduction: by value, and then by place in the list.
using RankedPoint = std::pair<std::uint32_t, std::uint32_t>;

struct Coboundary {
  std::set<std::uint32_t> edges;  // the sum of these points' coboundaries
  std::set<RankedPoint> saddles;
};

class Coboundaries {
 public:
  Coboundaries(const SaddleLinks& links, const Persistence& persistence, std::size_t first_edge,
               std::size_t first_saddle)
      : persistence_(persistence), first_edge_(first_edge), first_(first_saddle - first_edge + 1) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (const std::uint32_t edge : links.lower(i)) ++first_[edge - first_edge + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    saddles_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (const std::uint32_t edge : links.lower(i)) {
        saddles_[next[edge - first_edge]++] = static_cast<std::uint32_t>(first_saddle + i);
      }
    }
  }

  // Reduces the coboundary of a birth until its earliest point is the death.
  const Coboundary& reduced(std::uint32_t birth) {
    std::vector<std::uint32_t> unfinished{birth};
    while (!unfinished.empty()) {
      const std::uint32_t edge = unfinished.back();
      const auto [known, is_new] = columns_.try_emplace(edge);
      Coboundary& column = known->second;
      if (is_new) column = {{edge}, places(of(edge))};
      if (const std::uint32_t earliest = column.saddles.begin()->second; earliest != persistence_.partner(edge)) {
        const std::uint32_t later = persistence_.partner(earliest);
        // It may still have to be reduced. It is later than this edge, so this comes to an end.
        const auto other = columns_.find(later);
        if (other == columns_.end() || other->second.saddles.begin()->second != earliest) {
          unfinished.push_back(later);
          continue;
        }
        for (const std::uint32_t item : other->second.edges) toggle(column.edges, item);
        for (const RankedPoint& item : other->second.saddles) toggle(column.saddles, item);
        continue;
      }
      unfinished.pop_back();
    }
    return columns_.at(birth);
  }

  // The index-2 points with the index-1 point in their boundaries.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t edge) const {
    const std::size_t k = edge - first_edge_;
    return std::span(saddles_).subspan(first_[k], first_[k + 1] - first_[k]);
  }

 private:
  [[nodiscard]] std::set<RankedPoint> places(std::span<const std::uint32_t> saddles) const {
    std::set<RankedPoint> found;
    for (const std::uint32_t saddle : saddles) found.emplace(persistence_.squared_distances().rank(saddle), saddle);
    return found;
  }

  const Persistence& persistence_;
  std::size_t first_edge_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> saddles_;
  std::map<std::uint32_t, Coboundary> columns_;  // by index-1 point
};

}  // namespace

LoopWitness Loops::witness(const PersistencePair& pair) const {
  const geometry::IeeeDoubles ieee;
  LoopWitness witness;
  witness.surface = surface(pair, SquaredLevel(persistence_->squared_distances(), pair.birth, pair.birth, 0));
  witness.loop = boundary(witness.surface);
  const SquaredDistances& values = persistence_->squared_distances();
  Coboundaries coboundaries(*links_, *persistence_, stationary_->critical_counts()[0], first_saddle_);
  const Coboundary& reduced = coboundaries.reduced(pair.birth);
  witness.cocycle.assign(reduced.edges.begin(), reduced.edges.end());
  std::set<std::uint32_t> met;
  for (const std::uint32_t edge : witness.cocycle) {
    for (const std::uint32_t saddle : coboundaries.of(edge)) {
      if (values.rank(saddle) < values.rank(*pair.death)) met.insert(saddle);
    }
  }
  witness.met.assign(met.begin(), met.end());
  return witness;
}

}  // namespace flowcert
