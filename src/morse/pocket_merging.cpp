// Two union-find structures grow while the value falls: the components of what is above it, which always come together,
// and the pockets, which may stay apart.
#include "morse/pocket_merging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "geometry/difference_of_roots.h"
#include "geometry/disjoint_sets.h"
#include "geometry/value_range.h"

namespace flowcert::morse {

namespace {

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
    constexpr std::uint32_t kNone = MergeTree::kNone;
    std::vector<std::uint32_t> number_of(leaves, kNone), result(leaves);
    const std::uint32_t outside = pockets_.find(leaves - 1);
    std::uint32_t count = 0;
    for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
      std::uint32_t& number = number_of[pockets_.find(leaf)];
      if (pockets_.find(leaf) != outside && number == kNone) number = count++;
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
    const double bound = std::sqrt(persistence_.square.convert_to<double>());
    const double error = inexact + kRoundingShare * bound + 0x1p-500;
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

}  // namespace

std::vector<std::uint32_t> pocket_numbers(const MergeTrees& trees, const Rational& squared_persistence) {
  if (trees.pockets().leaves == 0) return {};
  return PocketMerging(trees, squared_persistence).numbers();
}

}  // namespace flowcert::morse
