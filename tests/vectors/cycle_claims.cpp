#include "tests/vectors/cycle_claims.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "oracle/loops.h"
#include "oracle/merge_tree.h"

namespace oracle::vectors {

namespace {

constexpr std::size_t kMostOfAReason = 2, kMostDeaths = 4;

std::string words(const std::string& first, const std::vector<std::size_t>& numbers) {
  std::string line = first;
  for (const std::size_t number : numbers) line += ' ' + std::to_string(number);
  return line;
}

// A number that lines have as exact.
std::string exact(const Rational& value) {
  const std::string text = value.str();
  return text.find('/') == std::string::npos ? text + "/1" : text;
}

std::string pair_line(const Rational& birth, const Rational& death) {
  return "pair " + exact(birth) + ' ' + exact(death);
}

// ---- Loops ----

struct ClaimedLoop {
  Rational birth, death, level;
  Loop loop;
};

class LoopClaims {
 public:
  explicit LoopClaims(const PointSet& set) : set_(set), tunnels_(set) {
    for (const auto& [place, column] : tunnels_.columns) {
      const Rational& birth = tunnels_.values[place];
      if (birth == column.death) continue;
      Loop loop;
      for (const auto& [edge, at] : tunnels_.edge_place) {
        if (std::binary_search(column.edges.begin(), column.edges.end(), at)) loop.push_back(edge);
      }
      pairs_.push_back({birth, column.death, birth, loop});
    }
  }

  std::vector<CycleClaim> all() {
    add(pairs_, true);
    if (pairs_.empty()) return claims_;
    add({pairs_.begin(), pairs_.end() - 1}, true);
    std::map<Rational, std::vector<ClaimedLoop>> by_death;
    for (const ClaimedLoop& pair : pairs_) by_death[pair.death].push_back(pair);
    std::size_t deaths = 0;
    for (auto& [death, pairs] : by_death) {
      if (deaths++ == kMostDeaths) break;
      const auto latest =
          std::max_element(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.birth < b.birth; });
      const Rational level = (latest->birth + death) / 2;
      for (ClaimedLoop& pair : pairs) pair.level = level;
      add(pairs, false);
      for (ClaimedLoop& pair : pairs) pair.loop = pairs.front().loop;
      if (pairs.size() > 1) add(pairs, false);
    }
    for (const ClaimedLoop& pair : pairs_) add_changed(pair);
    for (const ClaimedLoop& pair : pairs_) {
      for (const ClaimedLoop& other : pairs_) {
        if (&other != &pair) add_if_rare({pair.birth, pair.death, pair.birth, other.loop});
      }
    }
    return claims_;
  }

 private:
  // Without its last edge, and with that one by way of another sample.
  void add_changed(const ClaimedLoop& pair) {
    ClaimedLoop changed = pair;
    const Edge last = changed.loop.back();
    changed.loop.pop_back();
    add_if_rare(changed);
    for (std::size_t r = 0; r < set_.points.size(); ++r) {
      if (r == last[0] || r == last[1]) continue;
      ClaimedLoop longer = changed;
      for (const std::size_t end : last) {
        const Edge edge{std::min(end, r), std::max(end, r)};
        const auto there = std::find(longer.loop.begin(), longer.loop.end(), edge);
        if (there == longer.loop.end()) {
          longer.loop.push_back(edge);
        } else {
          longer.loop.erase(there);
        }
      }
      add_if_rare(longer);
    }
  }

  void add_if_rare(const ClaimedLoop& claimed) {
    const std::vector<std::string> reasons = reasons_of({claimed}, false);
    if (times_[reasons]++ < kMostOfAReason) add({claimed}, false);
  }

  // All of one death have one level, or each the one of its birth.
  [[nodiscard]] std::vector<std::string> reasons_of(const std::vector<ClaimedLoop>& claimed, bool is_whole) const {
    std::map<std::pair<Rational, Rational>, std::vector<Loop>> at_birth, at_level;
    for (const ClaimedLoop& one : claimed) {
      (one.level == one.birth ? at_birth : at_level)[{one.level, one.death}].push_back(one.loop);
    }
    if (is_whole) {
      for (const ClaimedLoop& pair : pairs_) at_birth[{pair.birth, pair.death}];
    }
    std::set<std::string> reasons;
    for (const auto& [values, loops] : at_birth) {
      const std::string fault = tunnels_.fault_at_birth(loops, values.first, values.second);
      if (fault != "too-few") reasons.insert(fault);
      if (fault == "too-few" && is_whole) reasons.insert("missing");
    }
    for (const auto& [values, loops] : at_level) {
      const std::string fault = tunnels_.fault_at_level(loops, values.first, values.second);
      if (fault != "too-few") reasons.insert(fault);
    }
    reasons.erase("");
    return {reasons.begin(), reasons.end()};
  }

  void add(const std::vector<ClaimedLoop>& claimed, bool is_whole) {
    CycleClaim claim{{is_whole ? "cycles 1 all" : "cycles 1"}, reasons_of(claimed, is_whole)};
    for (const ClaimedLoop& one : claimed) {
      claim.lines.push_back(pair_line(one.birth, one.death));
      if (one.level != one.birth) claim.lines.push_back("level " + exact(one.level));
      for (const Edge& edge : one.loop) {
        claim.lines.push_back(words("edge", {set_.names[edge[0]], set_.names[edge[1]]}));
      }
    }
    claims_.push_back(claim);
  }

  const PointSet& set_;
  CechTunnels tunnels_;
  std::vector<ClaimedLoop> pairs_;  // at birth
  std::map<std::vector<std::string>, std::size_t> times_;
  std::vector<CycleClaim> claims_;
};

// ---- Voids and components ----

// A part of a tree that comes at a node to one that lasts longer.
struct EndingPart {
  Rational value;
  std::size_t part = 0, other = 0;
};

// Of equal parts the first one lasts longer, or the last one.
std::vector<EndingPart> ending_parts(const MergeTree& tree, const std::vector<Rational>& leaf_values,
                                     bool first_lasts) {
  // The value of its greatest leaf. Infinity has none.
  const auto is_less = [&](std::size_t a, std::size_t b) {
    if (a >= leaf_values.size()) return false;
    return b >= leaf_values.size() || leaf_values[a] < leaf_values[b];
  };
  const auto top = [&](std::size_t part) {
    const std::vector<std::size_t> leaves = leaves_of(tree, part);
    return *std::max_element(leaves.begin(), leaves.end(), is_less);
  };
  std::vector<EndingPart> ending;
  for (const MergeNode& node : tree.nodes) {
    std::size_t lasting = node.parts.front();
    for (const std::size_t part : node.parts) {
      if (is_less(top(lasting), top(part)) || (!first_lasts && !is_less(top(part), top(lasting)))) lasting = part;
    }
    for (const std::size_t part : node.parts) {
      if (part != lasting) ending.push_back({node.value, part, lasting});
    }
  }
  return ending;
}

class VoidClaims {
 public:
  VoidClaims(const PointSet& set, const std::vector<StationaryPoint>& all)
      : all_(all), tree_(superlevel_tree(set, all)), maxima_(maxima_places(all)) {
    for (const std::size_t place : maxima_) values_.push_back(all[place].squared_distance);
  }

  std::vector<CycleClaim> all() {
    const std::vector<EndingPart> ending = ending_parts(tree_, values_, true),
                                  other = ending_parts(tree_, values_, false);
    claims_.push_back(whole(ending));
    if (ending.empty()) return claims_;
    if (whole(other).lines != claims_.front().lines) claims_.push_back(whole(other));
    claims_.push_back(whole({ending.begin(), ending.end() - 1}));
    claims_.back().reasons = {"missing"};
    add_wrong(ending);
    return claims_;
  }

 private:
  [[nodiscard]] std::string maximum_line(std::size_t leaf) const {
    return words("maximum", all_[maxima_[leaf]].contact);
  }
  [[nodiscard]] std::string pair_of(const EndingPart& ending) const {
    Rational death = 0;
    for (const std::size_t leaf : leaves_of(tree_, ending.part)) death = std::max(death, values_[leaf]);
    return pair_line(ending.value, death);
  }
  [[nodiscard]] CycleClaim whole(const std::vector<EndingPart>& ending) const {
    CycleClaim claim{{"cycles 2 all"}, {}};
    for (const EndingPart& one : ending) {
      claim.lines.push_back(pair_of(one));
      for (const std::size_t leaf : leaves_of(tree_, one.part)) claim.lines.push_back(maximum_line(leaf));
    }
    return claim;
  }
  // A maximum more than the void has, or one less.
  void add_wrong(const std::vector<EndingPart>& ending) {
    for (std::size_t k = 0; k < std::min(ending.size(), kMostOfAReason); ++k) {
      CycleClaim claim{{"cycles 2", pair_of(ending[k])}, {"wrong-void"}};
      const std::vector<std::size_t> inside = leaves_of(tree_, ending[k].part);
      std::size_t more = 0;
      while (more < maxima_.size() && std::binary_search(inside.begin(), inside.end(), more)) ++more;
      if (more == maxima_.size() && inside.size() == 1) continue;
      for (const std::size_t leaf : inside) claim.lines.push_back(maximum_line(leaf));
      if (more < maxima_.size()) {
        claim.lines.push_back(maximum_line(more));
      } else {
        claim.lines.pop_back();
      }
      claims_.push_back(claim);
    }
  }

  const std::vector<StationaryPoint>& all_;
  MergeTree tree_;
  std::vector<std::size_t> maxima_;
  std::vector<Rational> values_;
  std::vector<CycleClaim> claims_;
};

std::vector<CycleClaim> component_claims(const PointSet& set, const std::vector<StationaryPoint>& all) {
  const MergeTree tree = sublevel_tree(set, all);
  const std::vector<Rational> zeros(set.points.size(), Rational(0));
  const auto line = [&](const std::vector<std::size_t>& leaves) {
    std::vector<std::size_t> names;
    for (const std::size_t leaf : leaves) names.push_back(set.names[leaf]);
    return words("component", names);
  };
  CycleClaim whole{{"cycles 0 all"}, {}};
  std::vector<CycleClaim> claims;
  for (const EndingPart& one : ending_parts(tree, zeros, true)) {
    const std::vector<std::size_t> a = leaves_of(tree, one.part), b = leaves_of(tree, one.other);
    const std::string pair = pair_line(0, one.value);
    whole.lines.insert(whole.lines.end(), {pair, line(a), line(b)});
    if (claims.size() == kMostOfAReason || a.size() < 2) continue;
    claims.push_back({{"cycles 0", pair, line({a.begin(), a.end() - 1}), line(b)}, {"wrong-components"}});
  }
  claims.insert(claims.begin(), whole);
  return claims;
}

}  // namespace

std::vector<CycleClaim> cycle_claims(const PointSet& set, const std::vector<StationaryPoint>& all) {
  std::vector<CycleClaim> claims = LoopClaims(set).all();
  for (const auto& more : {VoidClaims(set, all).all(), component_claims(set, all)}) {
    claims.insert(claims.end(), more.begin(), more.end());
  }
  return claims;
}

}  // namespace oracle::vectors
