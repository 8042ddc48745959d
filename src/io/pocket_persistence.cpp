#include "io/pocket_persistence.h"

#include <numeric>
#include <vector>

#include "geometry/floating_point.h"
#include "io/coordinate_rounding.h"
#include "io/layer.h"
#include "io/number_text.h"
#include "morse/log_histogram.h"
#include "morse/saddle_radii.h"

namespace flowcert {

using namespace io;

namespace {

// In each node all parts but the highest one end.
std::vector<PairEnds> pairs_of_maxima(const MergeTrees& trees) {
  const MergeTree& tree = trees.pockets();
  const auto rank = [&](std::uint32_t leaf) { return trees.squared_distances().rank(trees.record_of(leaf)); };
  const auto infinity = static_cast<std::uint32_t>(trees.maxima());
  std::vector<std::uint32_t> highest(tree.leaves + tree.nodes.size());
  std::iota(highest.begin(), highest.end(), 0U);
  std::vector<PairEnds> pairs;
  for (std::size_t k = 0; k < tree.nodes.size(); ++k) {
    std::uint32_t& top = highest[tree.leaves + k];
    top = highest[tree.nodes[k].parts.front()];
    for (const std::uint32_t part : tree.nodes[k].parts) {
      const std::uint32_t leaf = highest[part];
      if (top != infinity && (leaf == infinity || rank(leaf) > rank(top))) top = leaf;
    }
    for (const std::uint32_t part : tree.nodes[k].parts) {
      if (highest[part] != top) pairs.push_back({tree.nodes[k].points.front(), trees.record_of(highest[part])});
    }
  }
  return pairs;
}

}  // namespace

PocketPersistence pocket_persistence(const FlowComplex& complex, const std::string& text, const std::string& option) {
  const geometry::IeeeDoubles ieee;
  const LengthBound bound = length_bound_of(text, option, 1);
  if (bound.number < 0) throw InvalidInput(option + ": not 0 or more: " + text);
  if (bound.unit == LengthBound::Unit::kInput) return {bound.number * bound.number, {}};
  const MergeTrees& trees = complex.merge_trees();
  const ValueOrder lengths = length_order(trees.squared_distances(), pairs_of_maxima(trees));
  const std::optional<Rational> spacing = squared_spacing(complex);
  auto [square, automatic] = threshold_of(bound, lengths, spacing, length_rounding(complex.points()));
  if (automatic && !automatic->valley) square = spacing.value_or(0) * kShallowInSpacings * kShallowInSpacings;
  return {square.value_or(0), automatic};
}

}  // namespace flowcert
