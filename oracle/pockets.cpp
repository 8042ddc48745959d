// At each value from the highest index-2 point down, shallow components give their maxima to others. It is asked of the
// merge tree which components there are, and of the flow what is above the two sides of an index-2 point.
#include "oracle/pockets.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "oracle/connections.h"
#include "oracle/merge_tree.h"
#include "oracle/persistence.h"
#include "oracle/stable_pieces.h"

namespace oracle {

namespace {

// What all steps ask of. Leaves are those of the merge tree: maxima, and infinity.
struct Landscape {
  const PointSet& set;
  const std::vector<StationaryPoint>& all;
  MergeTree tree;
  std::vector<std::size_t> maxima;
  PeaksAbove above;

  std::size_t infinity() const { return maxima.size(); }
  const Rational& value(std::size_t leaf) const { return all[maxima[leaf]].squared_distance; }
  bool is_index_2(std::size_t place) const { return all[place].is_critical() && all[place].hull_dimension == 2; }

  // Whether the leaf is in {d^2 > a}.
  bool is_above(std::size_t leaf, const Rational& a) const { return leaf == infinity() || value(leaf) > a; }

  // The component of {d^2 > a} that has the leaf, by its leaves.
  Peaks component(std::size_t leaf, const Rational& a) const {
    Peaks found = {leaf};
    for (std::size_t other = 0; other <= infinity(); ++other) {
      if (other != leaf && joining_value(tree, leaf, other).value() > a) found.insert(other);
    }
    return found;
  }
};

// An index-2 point with different components of {d^2 > its value} at its sides.
struct Gate {
  std::size_t point = 0;
  std::array<Peaks, 2> sides;       // the leaves above each side
  std::array<Peaks, 2> components;  // the component at each side
};

std::vector<Gate> gates_at(const Landscape& land, const Rational& value) {
  std::vector<Gate> gates;
  for (std::size_t point = 0; point < land.all.size(); ++point) {
    if (!land.is_index_2(point) || land.all[point].squared_distance != value) continue;
    Gate gate{point, land.above.of_sides[point], {}};
    for (const std::size_t side : {0U, 1U}) gate.components[side] = land.component(*gate.sides[side].begin(), value);
    if (gate.components[0] != gate.components[1]) gates.push_back(gate);
  }
  return gates;
}

bool is_shallow(const Landscape& land, const Peaks& component, const Rational& level,
                const Rational& squared_persistence) {
  return std::all_of(component.begin(), component.end(), [&](std::size_t leaf) {
    return leaf != land.infinity() && is_root_difference_up_to(land.value(leaf), level, squared_persistence);
  });
}

// FC-POCK-02, at one value. All of a shallow component is one pocket already. First these join each other, and then,
// each group of them at once, what is not shallow. `pocket_of` has a number for each leaf, the same for those of one
// pocket.
void merge_at(const Landscape& land, const Rational& level, const Rational& squared_persistence,
              std::vector<std::size_t>& pocket_of) {
  std::map<std::size_t, Peaks> beyond;  // by the shallow pocket: the pockets that are not, behind gates
  const std::vector<Gate> gates = gates_at(land, level);
  const auto is_shallow_at = [&](const Gate& gate, std::size_t side) {
    return is_shallow(land, gate.components[side], level, squared_persistence);
  };
  for (const Gate& gate : gates) {
    if (!is_shallow_at(gate, 0) || !is_shallow_at(gate, 1)) continue;
    const std::size_t one = pocket_of[*gate.components[0].begin()], other = pocket_of[*gate.components[1].begin()];
    std::replace(pocket_of.begin(), pocket_of.end(), one, other);
  }
  for (const Gate& gate : gates) {
    for (const std::size_t side : {0U, 1U}) {
      if (!is_shallow_at(gate, side) || is_shallow_at(gate, 1 - side)) continue;
      Peaks& found = beyond[pocket_of[*gate.components[side].begin()]];
      for (const std::size_t leaf : gate.sides[1 - side]) found.insert(pocket_of[leaf]);
    }
  }
  const std::vector<std::size_t> before = pocket_of;
  for (std::size_t leaf = 0; leaf < before.size(); ++leaf) {
    const auto others = beyond.find(before[leaf]);
    if (others != beyond.end() && others->second.size() == 1) pocket_of[leaf] = *others->second.begin();
  }
}

std::vector<std::size_t> merged(const Landscape& land, const Rational& squared_persistence) {
  std::vector<std::size_t> pocket_of(land.infinity() + 1);
  std::iota(pocket_of.begin(), pocket_of.end(), std::size_t{0});
  std::set<Rational, std::greater<>> levels;
  for (std::size_t k = 0; k < land.all.size(); ++k) {
    if (land.is_index_2(k)) levels.insert(land.all[k].squared_distance);
  }
  for (const Rational& level : levels) merge_at(land, level, squared_persistence, pocket_of);
  return pocket_of;
}

// The pockets of some leaves.
Peaks pockets_of(const std::vector<std::size_t>& number_of, const Peaks& leaves) {
  Peaks found;
  for (const std::size_t leaf : leaves) found.insert(number_of[leaf]);
  return found;
}

// All components of {d^2 > value} that one can go to from the one with the leaf, over gates of that value, without
// coming through the one with infinity. The last gates are those that lead from one of these to the one with infinity.
std::vector<std::size_t> last_gates(const Landscape& land, std::size_t leaf, const Rational& value) {
  const std::vector<Gate> gates = gates_at(land, value);
  const Peaks outer = land.component(land.infinity(), value);
  std::set<Peaks> reached = {land.component(leaf, value)};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const Gate& gate : gates) {
      if (gate.components[0] == outer || gate.components[1] == outer) continue;
      for (const std::size_t side : {0U, 1U}) {
        if (reached.count(gate.components[side]) > 0) reached.insert(gate.components[1 - side]);
      }
    }
  }
  std::vector<std::size_t> last;
  for (const Gate& gate : gates) {
    for (const std::size_t side : {0U, 1U}) {
      if (gate.components[side] == outer && reached.count(gate.components[1 - side]) > 0) last.push_back(gate.point);
    }
  }
  return last;
}

std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

// The widest of some paths, with the gates of all that are as wide.
void widen(std::optional<WidestPath>& widest, const WidestPath& path) {
  if (!widest || widest->value < path.value) {
    widest = path;
  } else if (widest->value == path.value) {
    widest->gates = united(widest->gates, path.gates);
  }
}

Pocket described(const Landscape& land, const std::vector<std::size_t>& number_of, std::size_t number) {
  Pocket pocket;
  std::vector<std::size_t> leaves;
  for (std::size_t leaf = 0; leaf < land.infinity(); ++leaf) {
    if (number_of[leaf] == number) leaves.push_back(leaf);
  }
  pocket.maxima = select(land.maxima, leaves);
  for (const std::size_t leaf : leaves) pocket.height = std::max(pocket.height, land.value(leaf));
  std::optional<WidestPath> widest;
  for (const std::size_t leaf : leaves) {
    if (land.value(leaf) != pocket.height) continue;
    pocket.peaks.push_back(land.maxima[leaf]);
    const Rational value = joining_value(land.tree, leaf, land.infinity()).value();
    widen(widest, {value, last_gates(land, leaf, value)});
  }
  pocket.to_infinity = widest.value();
  Peaks neighbours;
  for (std::size_t place = 0; place < land.all.size(); ++place) {
    const Peaks beside = pockets_of(number_of, land.above.of[place]);
    if (beside.count(number) == 0) continue;
    if (beside.size() == 1) {
      pocket.cell.push_back(place);
      pocket.volume += volume(land.set, stable_set(land.set, land.all[place]));
    } else if (land.is_index_2(place)) {
      pocket.mouths.push_back(place);
      neighbours.insert(beside.begin(), beside.end());
      pocket.highest_mouth = std::max(pocket.highest_mouth, land.all[place].squared_distance);
    }
  }
  neighbours.erase(number);
  pocket.neighbours.assign(neighbours.begin(), neighbours.end());
  return pocket;
}

// Pockets get numbers in the order of their first leaves, and the outside gets the last one.
std::vector<std::size_t> numbered(const std::vector<std::size_t>& pocket_of) {
  std::vector<std::size_t> first, numbers;
  const auto number = [&](std::size_t pocket) { return std::find(first.begin(), first.end(), pocket) - first.begin(); };
  for (const std::size_t pocket : pocket_of) {
    if (pocket != pocket_of.back() && number(pocket) == std::ssize(first)) first.push_back(pocket);
  }
  for (const std::size_t pocket : pocket_of) numbers.push_back(static_cast<std::size_t>(number(pocket)));
  return numbers;
}

}  // namespace

Pockets pockets(const PointSet& set, const std::vector<StationaryPoint>& all, const Rational& squared_persistence) {
  if (set.points.empty()) return {};
  const Landscape land{set, all, superlevel_tree(set, all), maxima_places(all), peaks_above(set, all)};
  const std::vector<std::size_t> numbers = numbered(merged(land, squared_persistence));
  Pockets result;
  for (std::size_t number = 0; number < numbers.back(); ++number) {
    result.pockets.push_back(described(land, numbers, number));
  }
  for (std::size_t leaf = 0; leaf < land.infinity(); ++leaf) {
    if (numbers[leaf] == numbers.back()) result.outside.push_back(land.maxima[leaf]);
  }
  return result;
}

std::vector<std::size_t> pockets_above(const PointSet& set, const std::vector<StationaryPoint>& all,
                                       const Pockets& pockets, const std::optional<StationaryPoint>& limit) {
  const std::vector<std::size_t> maxima = maxima_places(all);
  std::vector<std::size_t> number_of(maxima.size() + 1, pockets.pockets.size());
  for (std::size_t leaf = 0; leaf < maxima.size(); ++leaf) {
    for (std::size_t number = 0; number < pockets.pockets.size(); ++number) {
      const std::vector<std::size_t>& own = pockets.pockets[number].maxima;
      if (std::binary_search(own.begin(), own.end(), maxima[leaf])) number_of[leaf] = number;
    }
  }
  const Peaks found = pockets_of(number_of, peaks_above(set, all).of[place_of(all, limit)]);
  return {found.begin(), found.end()};
}

Passage passage(const std::vector<StationaryPoint>& all, const Pocket& pocket, const Rational& squared_radius) {
  if (pocket.to_infinity.value < squared_radius) return Passage::kCavity;
  const auto passable = std::count_if(pocket.mouths.begin(), pocket.mouths.end(),
                                      [&](std::size_t place) { return all[place].squared_distance >= squared_radius; });
  return passable > 1 ? Passage::kChannel : Passage::kPocket;
}

std::optional<WidestPath> widest_path(const Pockets& pockets) {
  std::optional<WidestPath> widest;
  for (const Pocket& pocket : pockets.pockets) widen(widest, pocket.to_infinity);
  return widest;
}

std::vector<std::size_t> largest_balls(const std::vector<StationaryPoint>& all, const Pockets& pockets) {
  std::vector<std::size_t> largest;
  for (const Pocket& pocket : pockets.pockets) {
    const Rational& value = all[pocket.peaks[0]].squared_distance;
    if (!largest.empty() && all[largest[0]].squared_distance < value) largest.clear();
    if (largest.empty() || all[largest[0]].squared_distance == value) largest = united(largest, pocket.peaks);
  }
  return largest;
}

}  // namespace oracle
