// Maxima are merged into pockets from the greatest value of an index-2 point down (FC-POCK-02). Which pockets are above
// a stationary point is read from the leaves above it, and the widest paths from the merge tree, from its last node
// down.
#include "flowcert/pockets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "geometry/difference_of_roots.h"
#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "geometry/value_range.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::uint32_t kNoPart = MergeTree::kNone;

// ---- Merging ----

// Two union-find structures grow while the value falls: the components of what is above it, which always come together,
// and the pockets, which may stay apart. Bounds decide most comparisons with the persistence, exact values the others.
class PocketMerging {
 public:
  PocketMerging(const MergeTrees& trees, const Rational& squared_persistence)
      : trees_(trees),
        persistence_{squared_persistence},
        components_(trees.pockets().leaves),
        pockets_(trees.pockets().leaves),
        highest_(trees.pockets().leaves) {
    for (std::uint32_t leaf = 0; leaf < highest_.size(); ++leaf) highest_[leaf] = leaf;
    const auto saddles = trees.saddles_down();
    for (std::size_t first = 0; first < saddles.size();) {
      std::size_t last = first;
      while (last < saddles.size() && rank(saddles[last]) == rank(saddles[first])) ++last;
      merge_at(saddles.subspan(first, last - first));
      first = last;
    }
  }

  std::vector<std::uint32_t> numbers() {
    const auto leaves = static_cast<std::uint32_t>(highest_.size());
    std::vector<std::uint32_t> number_of(leaves, kNoPart), result(leaves);
    const std::uint32_t outside = pockets_.find(leaves - 1);
    std::uint32_t count = 0;
    for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
      std::uint32_t& number = number_of[pockets_.find(leaf)];
      if (pockets_.find(leaf) != outside && number == kNoPart) number = count++;
    }
    number_of[outside] = count;
    for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) result[leaf] = number_of[pockets_.find(leaf)];
    return result;
  }

 private:
  // An index-2 point with different components of what is above it at its sides.
  struct Gate {
    std::array<std::span<const std::uint32_t>, 2> sides;
    std::array<bool, 2> is_shallow;
  };

  [[nodiscard]] std::uint32_t rank(std::uint32_t record) const { return trees_.squared_distances().rank(record); }

  // Whether the distance at all maxima of a component is at most that at the saddle and the persistence more.
  bool is_shallow(std::uint32_t leaf, std::uint32_t saddle) {
    const std::uint32_t highest = highest_[components_.find(leaf)];
    if (highest == trees_.maxima()) return false;
    const auto record = trees_.record_of(highest);
    const auto [length, inexact] = trees_.squared_distances().length(saddle, record);
    // The root's rounding is within this share of it, or comes from a square below the doubles.
    constexpr double kLeastRoot = 0x1p-500;
    const double bound = std::sqrt(persistence_.square.convert_to<double>());
    const double error = inexact + kRoundingShare * bound + kLeastRoot;
    if (std::isfinite(bound) && length + error < bound) return true;
    if (length - error > bound) return false;
    const auto exact = [this](std::size_t at) { return trees_.squared_distances().exact(at); };
    return geometry::RootDifference{exact(record), exact(saddle)} <= persistence_;
  }

  void merge_at(std::span<const std::uint32_t> saddles) {
    std::vector<Gate> gates;
    for (const std::uint32_t saddle : saddles) {
      Gate gate{trees_.peaks_above_sides(saddle), {}};
      const std::uint32_t one = gate.sides[0].front(), other = gate.sides[1].front();
      if (components_.find(one) == components_.find(other)) continue;
      gate.is_shallow = {is_shallow(one, saddle), is_shallow(other, saddle)};
      gates.push_back(gate);
    }
    // All of a shallow component is one pocket already.
    for (const Gate& gate : gates) {
      if (gate.is_shallow[0] && gate.is_shallow[1]) pockets_.unite(gate.sides[0].front(), gate.sides[1].front());
    }
    join_what_is_not_shallow(gates);
    for (const Gate& gate : gates) join_components(gate.sides[0].front(), gate.sides[1].front());
  }

  // All merging of one value is done at once, so that what is beyond is found before any of it is merged.
  void join_what_is_not_shallow(const std::vector<Gate>& gates) {
    std::map<std::uint32_t, std::set<std::uint32_t>> beyond;  // by the shallow pocket
    for (const Gate& gate : gates) {
      if (gate.is_shallow[0] == gate.is_shallow[1]) continue;
      const std::size_t shallow = gate.is_shallow[0] ? 0 : 1;
      std::set<std::uint32_t>& found = beyond[pockets_.find(gate.sides[shallow].front())];
      for (const std::uint32_t leaf : gate.sides[1 - shallow]) found.insert(pockets_.find(leaf));
    }
    for (const auto& [pocket, others] : beyond) {
      if (others.size() == 1) pockets_.unite(pocket, *others.begin());
    }
  }

  void join_components(std::uint32_t one, std::uint32_t other) {
    const std::uint32_t a = highest_[components_.find(one)], b = highest_[components_.find(other)];
    components_.unite(one, other);
    const auto is_lower = [this](std::uint32_t x, std::uint32_t y) {
      if (x == trees_.maxima() || y == trees_.maxima()) return y == trees_.maxima();
      return trees_.squared_distances().rank(trees_.record_of(x)) <
             trees_.squared_distances().rank(trees_.record_of(y));
    };
    highest_[components_.find(one)] = is_lower(a, b) ? b : a;
  }

  const MergeTrees& trees_;
  const geometry::RootDifference persistence_;
  DisjointSets components_, pockets_;
  std::vector<std::uint32_t> highest_;  // by the representative of a component: its highest leaf
};

// By leaf of the tree of pockets: the number of its pocket. Pockets are numbered by their first leaves, but the one of
// infinity is the last. O(n log n) but for sets of maxima.
std::vector<std::uint32_t> pocket_numbers(const MergeTrees& trees, const Rational& squared_persistence) {
  if (trees.pockets().leaves == 0) return {};
  return PocketMerging(trees, squared_persistence).numbers();
}

// ---- Ways out ----

// Where parts of the tree of pockets come to infinity, and through which gates.
class WaysOut {
 public:
  explicit WaysOut(const MergeTrees& trees) : trees_(trees), tree_(trees.pockets()), parent_(tree_.parents()) {
    const std::size_t parts = tree_.leaves + tree_.nodes.size();
    has_infinity_.resize(parts, false);
    for (auto part = static_cast<std::uint32_t>(tree_.leaves - 1); part != kNoPart; part = parent_[part]) {
      has_infinity_[part] = true;
    }
    below_infinity_.resize(parts, kNoPart);
    for (std::size_t part = parts; part-- > 0;) {
      if (has_infinity_[part]) continue;
      const std::uint32_t parent = parent_[part];
      below_infinity_[part] = has_infinity_[parent] ? static_cast<std::uint32_t>(part) : below_infinity_[parent];
    }
  }

  // The node in which a maximum joins infinity.
  [[nodiscard]] const MergeNode& node(std::uint32_t leaf) const {
    return tree_.nodes[parent_[below_infinity_[leaf]] - tree_.leaves];
  }

  // The part with the maximum goes through gates of the node to other parts, but not through the one with infinity.
  // The last gates lead from there to that one.
  [[nodiscard]] const std::vector<std::uint32_t>& last_gates(std::uint32_t leaf) {
    const std::uint32_t start = below_infinity_[leaf];
    const auto [found, is_new] = gates_of_.try_emplace(start);
    if (is_new) found->second = gates_from(start, tree_.nodes[parent_[start] - tree_.leaves]);
    return found->second;
  }

 private:
  // What joined infinity before the node is in its part with infinity.
  [[nodiscard]] std::uint32_t part_of(std::uint32_t leaf, const MergeNode& node) const {
    const std::uint32_t part = below_infinity_[leaf];
    if (part != kNoPart && std::ranges::binary_search(node.parts, part)) return part;
    return *std::ranges::find_if(node.parts, [this](std::uint32_t other) { return has_infinity_[other]; });
  }

  [[nodiscard]] std::vector<std::uint32_t> gates_from(std::uint32_t start, const MergeNode& node) const {
    std::vector<std::array<std::uint32_t, 2>> sides;
    for (const std::uint32_t gate : node.points) {
      const auto peaks = trees_.peaks_above_sides(gate);
      sides.push_back({part_of(peaks[0].front(), node), part_of(peaks[1].front(), node)});
    }
    std::vector<std::uint32_t> reached = {start}, gates;
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (std::size_t k = 0; k < sides.size(); ++k) {
        for (const std::size_t side : {0U, 1U}) {
          if (sides[k][side] != reached[next]) continue;
          const std::uint32_t other = sides[k][1 - side];
          if (has_infinity_[other]) {
            gates.push_back(node.points[k]);
          } else if (std::ranges::find(reached, other) == reached.end()) {
            reached.push_back(other);
          }
        }
      }
    }
    keep_unique(gates);
    return gates;
  }

  const MergeTrees& trees_;
  const MergeTree& tree_;
  std::vector<std::uint32_t> parent_;
  std::vector<bool> has_infinity_;             // by part
  std::vector<std::uint32_t> below_infinity_;  // by part: the latest part with it that is without infinity
  std::map<std::uint32_t, std::vector<std::uint32_t>> gates_of_;
};

// Takes a path that is wider than all before, or adds the gates of one that is as wide.
void widen(std::vector<std::uint32_t>& gates, const std::vector<std::uint32_t>& others,
           const SquaredDistances& distances) {
  if (!gates.empty() && distances.rank(gates.front()) > distances.rank(others.front())) return;
  if (!gates.empty() && distances.rank(gates.front()) < distances.rank(others.front())) gates.clear();
  gates.insert(gates.end(), others.begin(), others.end());
  keep_unique(gates);
}

}  // namespace

const char* passage_text(Passage passage) {
  switch (passage) {
    case Passage::kCavity:
      return "cavity";
    case Passage::kPocket:
      return "pocket";
    default:
      return "channel";
  }
}

Pockets::Pockets(const MergeTrees& trees, const Rational& squared_persistence)
    : trees_(&trees), squared_persistence_(squared_persistence) {
  const geometry::IeeeDoubles ieee;
  if (squared_persistence < 0) throw std::invalid_argument("the square of a persistence is not negative");
  number_of_ = pocket_numbers(trees, squared_persistence);
  if (number_of_.empty()) return;
  pockets_.resize(number_of_.back());
  for (std::uint32_t leaf = 0; leaf < trees.maxima(); ++leaf) {
    const auto record = static_cast<std::uint32_t>(trees.record_of(leaf));
    (number_of_[leaf] < pockets_.size() ? pockets_[number_of_[leaf]].maxima : outside_).push_back(record);
  }
  add_peaks();
  add_cells_and_mouths();
  if (pockets_.empty()) return;
  WaysOut ways(trees);
  for (Pocket& pocket : pockets_) {
    for (const std::uint32_t peak : pocket.peaks) {
      widen(pocket.to_infinity.gates, ways.last_gates(static_cast<std::uint32_t>(peak - trees.record_of(0))),
            squared_distances());
    }
  }
}

void Pockets::add_peaks() {
  for (Pocket& pocket : pockets_) {
    std::uint32_t highest = 0;
    for (const std::uint32_t record : pocket.maxima) highest = std::max(highest, squared_distances().rank(record));
    for (const std::uint32_t record : pocket.maxima) {
      if (squared_distances().rank(record) == highest) pocket.peaks.push_back(record);
    }
  }
}

void Pockets::add_cells_and_mouths() {
  const StationaryPoints& stationary = trees_->stationary();
  for (std::uint32_t record = 0; record < stationary.size(); ++record) {
    if (stationary.index(record).hull_dimension == 0) continue;
    const std::vector<std::uint32_t> beside = above(record);
    if (beside.size() == 1 && beside.front() < size()) pockets_[beside.front()].cell.push_back(record);
    if (beside.size() < 2 || stationary.index(record) != StationaryIndex{2, 2}) continue;
    for (const std::uint32_t number : beside) {
      if (number == size()) continue;
      Pocket& pocket = pockets_[number];
      const auto rank = squared_distances().rank(record);
      if (pocket.mouths.empty() || squared_distances().rank(pocket.highest_mouth) < rank) pocket.highest_mouth = record;
      pocket.mouths.push_back(record);
      for (const std::uint32_t other : beside) {
        if (other != number) pocket.neighbours.push_back(other);
      }
    }
  }
  for (Pocket& pocket : pockets_) keep_unique(pocket.neighbours);
}

std::vector<std::span<const std::uint32_t>> Pockets::cells() const {
  std::vector<std::span<const std::uint32_t>> cells;
  cells.reserve(size());
  for (const Pocket& pocket : pockets_) cells.emplace_back(pocket.cell);
  return cells;
}

std::vector<std::uint32_t> Pockets::above(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t leaf : trees_->peaks_above(record)) numbers.push_back(number_of_[leaf]);
  keep_unique(numbers);
  return numbers;
}

Rational Pockets::difference_of_squares(const Pocket& pocket) const {
  const geometry::IeeeDoubles ieee;
  return squared_distances().exact(pocket.peaks.front()) - squared_distances().exact(pocket.highest_mouth);
}

double Pockets::depth(const Pocket& pocket) const {
  const geometry::IeeeDoubles ieee;
  return geometry::nearest_difference_of_roots(squared_distances().exact(pocket.peaks.front()),
                                               squared_distances().exact(pocket.highest_mouth));
}

Passage Pockets::passage(const Pocket& pocket, const Rational& squared_radius) const {
  const geometry::IeeeDoubles ieee;
  const auto is_open = [&](std::uint32_t record) { return squared_distances().compare(record, squared_radius) >= 0; };
  if (!is_open(pocket.to_infinity.gates.front())) return Passage::kCavity;
  return std::ranges::count_if(pocket.mouths, is_open) > 1 ? Passage::kChannel : Passage::kPocket;
}

std::vector<PointId> Pockets::lining(const Pocket& pocket, const StableVolumes& volumes) {
  const geometry::IeeeDoubles ieee;
  std::vector<PointId> samples;
  for (const std::uint32_t record : pocket.cell) {
    for (const auto& [sample, share] : volumes.rounded_shares(record)) samples.push_back(sample);
  }
  keep_unique(samples);
  return samples;
}

std::optional<WidestPath> Pockets::widest_path() const {
  const geometry::IeeeDoubles ieee;
  if (pockets_.empty()) return std::nullopt;
  WidestPath widest;
  for (const Pocket& pocket : pockets_) widen(widest.gates, pocket.to_infinity.gates, squared_distances());
  return widest;
}

std::vector<std::uint32_t> Pockets::largest_balls() const {
  const geometry::IeeeDoubles ieee;
  std::vector<std::uint32_t> largest;
  for (const Pocket& pocket : pockets_) widen(largest, pocket.peaks, squared_distances());
  return largest;
}

}  // namespace flowcert
