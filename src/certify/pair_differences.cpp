// A maximum flow from claimed to true pairs shows which of them find a partner. It is found for each set of pairs that
// can be each other's partners, through others or not: such sets are small.
#include "certify/pair_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/edmonds_karp_max_flow.hpp>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "flowcert/flow_complex.h"
#include "geometry/disjoint_sets.h"
#include "geometry/floating_point.h"

namespace flowcert {

using namespace certify;

namespace {

constexpr char kWrongPair[] = "wrong-pair", kRounding[] = "rounding";

// A message shows at most this many characters of a number.
constexpr std::size_t kLongestPairNumber = 60;

// ---- Groups of equal pairs ----

struct PairGroup {
  ClaimedPair pair;  // the truth is exact
  std::size_t count = 0;
  bool needs_partner = true;

  [[nodiscard]] bool is_exact() const { return is_exact_pair(pair); }
};

std::vector<ClaimedPair> as_claimed(const std::vector<ListedPair>& pairs) {
  std::vector<ClaimedPair> exact;
  exact.reserve(pairs.size());
  for (const ListedPair& pair : pairs) {
    exact.push_back({pair.dimension, {pair.birth, true}, std::nullopt});
    if (pair.death) exact.back().death = ClaimedNumber{*pair.death, true};
  }
  return exact;
}

// Ascending by dimension, birth and death; pairs of length zero are left out. A class that lasts comes last.
std::vector<PairGroup> groups_of(const std::vector<ClaimedPair>& pairs) {
  using Key = std::tuple<int, Rational, bool, Rational, bool, bool>;
  std::map<Key, PairGroup> groups;
  for (const ClaimedPair& pair : pairs) {
    if (pair.death && pair.death->value == pair.birth.value) continue;
    const Key key{pair.dimension,      pair.birth.value,
                  !pair.death,         pair.death ? pair.death->value : Rational(0),
                  pair.birth.is_exact, pair.death && pair.death->is_exact};
    PairGroup& group = groups[key];
    if (group.count++ == 0) group.pair = pair;
  }
  std::vector<PairGroup> sorted;
  sorted.reserve(groups.size());
  for (auto& [key, group] : groups) sorted.push_back(std::move(group));
  return sorted;
}

// ---- Which pairs can be partners ----

class Closeness {
 public:
  explicit Closeness(double tolerance) : tolerance_(tolerance) {}

  // Both have one dimension.
  [[nodiscard]] bool are_partners(const ClaimedPair& claimed, const ClaimedPair& truth) const {
    if (claimed.death.has_value() != truth.death.has_value()) return false;
    return is_right_value(claimed.birth, truth.birth.value, tolerance_) &&
           (!claimed.death || is_right_value(*claimed.death, truth.death->value, tolerance_));
  }

  // Whether a pair may be left over, because it may as well have no length.
  [[nodiscard]] bool is_short(const ClaimedPair& pair) const {
    if (!pair.death) return false;
    const Rational length = pair.death->value - pair.birth.value;
    if (length < 0) return false;
    return length <= 2 * tolerance_ * pair.death->value || rounds_alike(pair.birth.value, pair.death->value);
  }

 private:
  Rational tolerance_;
};

// ---- Matching ----

using Groups = std::vector<PairGroup>;
using Edge = std::pair<std::size_t, std::size_t>;  // places among the claimed and among the true groups

// How many pairs of each group find no partner, if only the pairs of one side that need one ask for them. By the
// theorem of Mendelsohn and Dulmage, what either side can have alone, both can have at once.
class PartnerFlow {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Graph = boost::adjacency_list<
      boost::vecS, boost::vecS, boost::directedS,
      boost::property<boost::vertex_color_t, boost::default_color_type,
                      boost::property<boost::vertex_distance_t, std::int64_t,
                                      boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>,
      boost::property<boost::edge_capacity_t, std::int64_t,
                      boost::property<boost::edge_residual_capacity_t, std::int64_t,
                                      boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

 public:
  PartnerFlow(const Groups& asking, const Groups& giving) : asking_(asking), graph_(asking.size() + giving.size() + 2) {
    for (std::size_t k = 0; k < asking.size(); ++k) {
      const bool asks = asking[k].needs_partner;
      from_source_.push_back(add(source(), k, asks ? static_cast<std::int64_t>(asking[k].count) : 0));
    }
    for (std::size_t k = 0; k < giving.size(); ++k) {
      add(asking.size() + k, sink(), static_cast<std::int64_t>(giving[k].count));
    }
  }

  void connect(std::size_t asking, std::size_t giving) {
    add(asking, asking_.size() + giving, static_cast<std::int64_t>(asking_[asking].count));
  }

  // By group of the asking side.
  [[nodiscard]] std::vector<std::size_t> without_partner() {
    boost::edmonds_karp_max_flow(graph_, source(), sink());
    std::vector<std::size_t> left;
    left.reserve(from_source_.size());
    for (const Traits::edge_descriptor& edge : from_source_) {
      left.push_back(static_cast<std::size_t>(get(boost::edge_residual_capacity, graph_, edge)));
    }
    return left;
  }

 private:
  [[nodiscard]] std::size_t source() const { return num_vertices(graph_) - 2; }
  [[nodiscard]] std::size_t sink() const { return num_vertices(graph_) - 1; }

  Traits::edge_descriptor add(std::size_t from, std::size_t to, std::int64_t capacity) {
    const auto there = add_edge(from, to, graph_).first, back = add_edge(to, from, graph_).first;
    put(boost::edge_capacity, graph_, there, capacity);
    put(boost::edge_capacity, graph_, back, 0);
    put(boost::edge_reverse, graph_, there, back);
    put(boost::edge_reverse, graph_, back, there);
    return there;
  }

  const Groups& asking_;
  Graph graph_;
  std::vector<Traits::edge_descriptor> from_source_;
};

// ---- Sets of possible partners ----

using Partners = std::vector<Edge>;

// The true groups are ascending, so those that can be a claimed group's partners are near each other: in a run of equal
// dimensions and near births, and within each run of equal births near its death.
class PartnerSearch {
 public:
  PartnerSearch(const Groups& truth, const Closeness& closeness, double tolerance)
      : truth_(truth), closeness_(closeness), part_(2 * Rational(tolerance) + kStep) {}

  void add_partners(const Groups& claimed, std::size_t i, Partners& partners) const {
    const ClaimedPair& pair = claimed[i].pair;
    auto run = std::ranges::partition_point(truth_, [&](const PairGroup& group) {
      return group.pair.dimension < pair.dimension ||
             (group.pair.dimension == pair.dimension && is_below(group.pair.birth.value, pair.birth.value));
    });
    while (run != truth_.end() && run->pair.dimension == pair.dimension &&
           !is_below(pair.birth.value, run->pair.birth.value)) {
      const auto end = std::find_if(run, truth_.end(), [&](const PairGroup& group) {
        return group.pair.dimension != run->pair.dimension || group.pair.birth.value != run->pair.birth.value;
      });
      add_partners_of_run(run, end, pair, i, partners);
      run = end;
    }
  }

 private:
  using Place = Groups::const_iterator;

  // Whether a is too far below b for any tolerance that are_partners() has.
  [[nodiscard]] bool is_below(const Rational& a, const Rational& b) const {
    return a < b && b - a > part_ * abs(b) + kLeast;
  }

  void add_partners_of_run(Place first, Place last, const ClaimedPair& pair, std::size_t i, Partners& partners) const {
    // A class that lasts comes last.
    auto at = std::partition_point(first, last, [&](const PairGroup& group) {
      return group.pair.death && (!pair.death || is_below(group.pair.death->value, pair.death->value));
    });
    for (; at != last; ++at) {
      if (pair.death && at->pair.death && is_below(pair.death->value, at->pair.death->value)) break;
      if (closeness_.are_partners(pair, at->pair))
        partners.emplace_back(i, static_cast<std::size_t>(at - truth_.begin()));
    }
  }

  // More than doubles that two numbers are rounded to alike leave between them.
  inline static const Rational kStep = Rational(1) / (1LL << 50), kLeast = Rational(std::numeric_limits<double>::min());

  const Groups& truth_;
  const Closeness& closeness_;
  Rational part_;
};

// A claimed and a true group are in one set if they can be partners, or each with a third.
class PartnerSets {
 public:
  PartnerSets(std::size_t claimed, std::size_t truth, const Partners& partners) : claimed_(claimed) {
    geometry::DisjointSets sets(claimed + truth);
    const auto number = [](std::size_t m) { return static_cast<std::uint32_t>(m); };
    for (const auto& [i, k] : partners) sets.unite(number(i), number(claimed + k));
    for (std::size_t m = 0; m < claimed + truth; ++m) members_[sets.find(number(m))].push_back(m);
    for (const auto& [i, k] : partners) partners_[sets.find(number(i))].emplace_back(i, k);
  }

  // Calls visit(places of claimed groups, places of true groups, pairs of them) for each set.
  template <typename Visit>
  void visit_all(const Visit& visit) const {
    const Partners none;
    for (const auto& [root, members] : members_) {
      std::vector<std::size_t> of_claimed, of_truth;
      for (const std::size_t m : members)
        (m < claimed_ ? of_claimed : of_truth).push_back(m < claimed_ ? m : m - claimed_);
      const auto partners = partners_.find(root);
      visit(of_claimed, of_truth, partners == partners_.end() ? none : partners->second);
    }
  }

 private:
  std::size_t claimed_;
  std::map<std::uint32_t, std::vector<std::size_t>> members_;
  std::map<std::uint32_t, Partners> partners_;
};

// ---- What is left over ----

struct LeftOver {
  std::vector<ClaimedPair> claimed, truth;  // each as often as it has no partner
};

Groups at_places(const Groups& groups, const std::vector<std::size_t>& places) {
  Groups chosen;
  chosen.reserve(places.size());
  for (const std::size_t place : places) chosen.push_back(groups[place]);
  return chosen;
}

void append_left(const Groups& groups, const std::vector<std::size_t>& left, std::vector<ClaimedPair>& pairs) {
  for (std::size_t k = 0; k < groups.size(); ++k) pairs.insert(pairs.end(), left[k], groups[k].pair);
}

LeftOver left_over(Groups claimed, Groups truth, double tolerance) {
  const Closeness closeness(tolerance);
  const bool is_exact = std::ranges::all_of(claimed, &PairGroup::is_exact);
  // A claim without decimals has all pairs, however short they are.
  for (PairGroup& group : claimed) group.needs_partner = group.is_exact() || !closeness.is_short(group.pair);
  for (PairGroup& group : truth) group.needs_partner = is_exact || !closeness.is_short(group.pair);
  const PartnerSearch search(truth, closeness, tolerance);
  Partners partners;
  for (std::size_t i = 0; i < claimed.size(); ++i) search.add_partners(claimed, i, partners);
  LeftOver left;
  const PartnerSets sets(claimed.size(), truth.size(), partners);
  sets.visit_all([&](const auto& of_claimed, const auto& of_truth, const Partners& near) {
    const Groups a = at_places(claimed, of_claimed), b = at_places(truth, of_truth);
    PartnerFlow from_claimed(a, b), from_truth(b, a);
    const auto place_in = [](const std::vector<std::size_t>& places, std::size_t place) {
      return static_cast<std::size_t>(std::ranges::lower_bound(places, place) - places.begin());
    };
    for (const auto& [i, k] : near) {
      from_claimed.connect(place_in(of_claimed, i), place_in(of_truth, k));
      from_truth.connect(place_in(of_truth, k), place_in(of_claimed, i));
    }
    append_left(a, from_claimed.without_partner(), left.claimed);
    append_left(b, from_truth.without_partner(), left.truth);
  });
  return left;
}

// ---- In words ----

// What is wrong with a cycle that is claimed of a pair (FC-CLAIM-25).
const std::map<std::string, const char*> kCycleSentences = {
    {"born-earlier", "This loop stands for a tunnel that is born earlier."},
    {"dependent", "This cycle stands for nothing beside other cycles of the claim."},
    {"dies-earlier", "This loop is filled before the death."},
    {"dies-later", "This loop is not filled at the death."},
    {"edge-too-long", "This loop leaves the balls that there are at its level."},
    {"malformed", "The claim contradicts itself."},
    {"not-a-cycle", "This is no cycle, because it is not closed."},
    {"surface-boundary", "This surface does not fill the loop."},
    {"triangle-too-large", "This surface leaves the balls that there are at its level."},
    {"wrong-components", "These are not the components that come together there."},
    {"wrong-counts", "The claim counts other pairs than there are."},
    {"wrong-void", "This is not the void of the pair at this level."},
};

std::string number_words(const ClaimedNumber& number, bool in_doubles) {
  const std::optional<double> nearest = nearest_double(number.value);
  std::string text = in_doubles && nearest ? fmt::format("{}", *nearest) : to_text(number.value);
  return shortened(std::move(text), kLongestPairNumber);
}

// In each dimension, the first pair of one list goes with the first pair of the other, and so on.
std::vector<PairDifference> differences_of(const LeftOver& left, bool in_doubles, bool by_rounding) {
  const auto words = [&](const std::vector<ClaimedPair>& pairs, std::size_t k) -> std::string {
    if (k >= pairs.size()) return "no such pair";
    const ClaimedPair& pair = pairs[k];
    return fmt::format("dimension {}, birth {}, death {}", pair.dimension, number_words(pair.birth, in_doubles),
                       pair.death ? number_words(*pair.death, in_doubles) : "inf");
  };
  std::vector<PairDifference> differences;
  for (int dimension = 0; dimension < kPairDimensions; ++dimension) {
    std::vector<ClaimedPair> a, b;
    const auto is_of = [&](const ClaimedPair& pair) { return pair.dimension == dimension; };
    std::ranges::copy_if(left.claimed, std::back_inserter(a), is_of);
    std::ranges::copy_if(left.truth, std::back_inserter(b), is_of);
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
      const bool is_claimed = k < a.size(), is_true = k < b.size();
      differences.push_back({words(a, k), words(b, k), by_rounding ? kRounding : kWrongPair, dimension, is_claimed,
                             is_true, is_claimed ? a[k].line : 0});
    }
  }
  return differences;
}

}  // namespace

std::vector<ListedPair> listed_pairs(const FlowComplex& complex) {
  const geometry::IeeeDoubles ieee;
  std::vector<ListedPair> pairs;
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    pairs.push_back({pair.dimension, complex.sphere(pair.birth).squared_radius, std::nullopt});
    if (pair.death) pairs.back().death = complex.sphere(*pair.death).squared_radius;
  }
  return pairs;
}

bool is_right_value(const ClaimedNumber& claimed, const Rational& truth, const Rational& tolerance) {
  if (claimed.value == truth) return true;
  if (claimed.is_exact) return false;
  if (rounds_alike(claimed.value, truth)) return true;
  return abs(Rational(claimed.value - truth)) <= tolerance * abs(truth);
}

std::string sentence_of(const PairDifference& difference) {
  if (!difference.sentence.empty()) return difference.sentence;
  constexpr const char* kNames[] = {"component", "tunnel", "void"};
  const std::string name = kNames[difference.dimension];
  if (difference.reason == kRounding) {
    return "It is right but for rounding. This is a convention: decimals may be rounded; exact numbers may not.";
  }
  if (const auto sentence = kCycleSentences.find(difference.reason); sentence != kCycleSentences.end()) {
    return sentence->second + std::string(" This is a bug.");
  }
  if (!difference.is_true) return "There is no such " + name + ". This is a bug.";
  if (!difference.is_claimed) return "You missed this " + name + ". This is a bug.";
  return "This " + name + " has another birth or death. This is a bug.";
}

std::array<std::size_t, kPairDimensions> pair_counts(const std::vector<ClaimedPair>& pairs) {
  std::array<std::size_t, kPairDimensions> counts{};
  for (const ClaimedPair& pair : pairs) {
    if (pair.death && pair.death->value == pair.birth.value) continue;
    ++counts.at(static_cast<std::size_t>(pair.dimension));
  }
  return counts;
}

std::array<std::size_t, kPairDimensions> pair_counts(const std::vector<ListedPair>& pairs) {
  return pair_counts(as_claimed(pairs));
}

std::vector<PairDifference> pair_differences(const std::vector<ClaimedPair>& claimed,
                                             const std::vector<ListedPair>& truth, double tolerance) {
  const geometry::IeeeDoubles ieee;
  const Groups a = groups_of(claimed), b = groups_of(as_claimed(truth));
  const LeftOver left = left_over(a, b, tolerance);
  if (left.claimed.empty() && left.truth.empty()) return {};
  const LeftOver rounded = left_over(a, b, std::max(tolerance, kRoundingPart));
  const bool by_rounding = rounded.claimed.empty() && rounded.truth.empty();
  return differences_of(left, !std::ranges::all_of(a, &PairGroup::is_exact), by_rounding);
}

}  // namespace flowcert
