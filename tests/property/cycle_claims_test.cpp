// The judge of cycles against the oracle's, on changed loops of all families (FC-CLAIM-25).
//
// Guarantees: a right loop is changed at random, by edges between any samples, by other loops and by triangles, and
// both judges give the same reason for it at three levels, or none. Sets of loops, surfaces and voids are changed, too.
// The test fails when too few changes gave some reason.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/cycle_differences.h"
#include "flowcert/loops.h"
#include "flowcert/voids.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/loops.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::cycle_claims_test {
namespace {

constexpr int kInputsPerFamily = 6;
constexpr std::size_t kMostRows = 10;
constexpr int kChangesOfALoop = 12, kInputsOfOneDeath = 300;

using Totals = std::map<std::string, std::size_t>;
using Edges = std::vector<SampleEdge>;

oracle::Rational rational(const Rational& value) { return oracle::Rational(value); }
// The same with every standard library, unlike its distributions.
std::size_t below(std::size_t bound, std::mt19937_64& random) { return random() % bound; }
ClaimedNumber exact(const Rational& value) { return {value, true}; }

class ChangedLoops {
 public:
  ChangedLoops(const fuzz::Input& input, std::mt19937_64& random, Totals& totals)
      : input_(input),
        random_(random),
        complex_(point_set_of(input)),
        set_(input.rows),
        tunnels_(set_),
        values_(complex_.persistence().squared_distances()),
        loops_(complex_.stationary(), complex_.links(), complex_.persistence()),
        classes_(complex_),
        totals_(totals) {
    for (const PersistencePair& pair : complex_.persistence().pairs()) {
      if (pair.dimension == 1) pairs_.push_back(pair);
    }
  }

  void require_same_reasons() {
    for (const PersistencePair& pair : pairs_) {
      const Rational birth = birth_of(pair), death = values_.exact(*pair.death);
      for (const int share : {0, 1, 3}) {
        const Rational level = birth + share * (death - birth) / 4;
        for (int k = 0; k < kChangesOfALoop; ++k) {
          const PersistencePair& other = pairs_[below(pairs_.size(), random_)];
          require_same_reason(changed(loop_at(below(2, random_) == 0 ? pair : other, level)), pair, level);
        }
      }
      for (const PersistencePair& other : pairs_) {
        if (values_.rank(*other.death) != values_.rank(*pair.death)) continue;
        require_same_sets(pair);
        // At its birth, what is born earlier does not stand for the pair.
        for (int k = 0; k < 4; ++k) {
          const Edges loop = loop_at(other, birth_of(pair));
          require_same_reason(k < 2 ? loop : changed(loop), pair, birth_of(pair));
        }
      }
      require_right_surfaces(pair);
    }
    require_right_voids();
  }

 private:
  [[nodiscard]] Rational birth_of(const PersistencePair& pair) const { return values_.exact(pair.birth); }
  [[nodiscard]] Edges edges_of(const std::vector<std::uint32_t>& records) const {
    Edges edges;
    for (const std::uint32_t record : records) {
      const auto ends = complex_.stationary().contact(record);
      edges.push_back({ends[0], ends[1]});
    }
    return edges;
  }
  // At its birth, if it is born later.
  [[nodiscard]] Edges loop_at(const PersistencePair& pair, const Rational& level) const {
    const Rational birth = values_.exact(pair.birth), death = values_.exact(*pair.death);
    const Rational at = level < birth || level >= death ? birth : level;
    return edges_of(loops_.boundary(loops_.surface(pair, at)));
  }
  [[nodiscard]] PointId any_row() { return static_cast<PointId>(below(input_.rows.size(), random_)); }

  [[nodiscard]] Edges changed(Edges loop) {
    for (std::size_t times = below(3, random_); times-- > 0;) {
      switch (below(5, random_)) {
        case 0:  // without an edge
          if (!loop.empty()) loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(below(loop.size(), random_)));
          break;
        case 1: {  // an edge by way of another sample
          if (loop.empty()) break;
          const std::size_t k = below(loop.size(), random_);
          const auto [p, q] = loop[k];
          const PointId r = any_row();
          loop[k] = {p, r};
          loop.push_back({r, q});
          break;
        }
        case 2: {
          const PointId p = any_row(), q = any_row(), r = any_row();
          loop.insert(loop.end(), {{p, q}, {q, r}, {r, p}});
          break;
        }
        default: {
          const PersistencePair& other = pairs_[below(pairs_.size(), random_)];
          const Edges more = loop_at(other, values_.exact(other.birth));
          loop.insert(loop.end(), more.begin(), more.end());
        }
      }
    }
    return loop;
  }

  [[nodiscard]] oracle::Loop of_oracle(const Edges& loop) const {
    oracle::Loop edges;
    for (const SampleEdge& edge : odd_edges(complex_.points(), loop)) {
      const auto places = oracle::places_of(set_, {edge[0], edge[1]});
      edges.push_back({std::min(places[0], places[1]), std::max(places[0], places[1])});
    }
    return edges;
  }
  [[nodiscard]] std::string oracle_reason(const std::vector<oracle::Loop>& loops, const PersistencePair& pair,
                                          const Rational& level) const {
    const Rational birth = values_.exact(pair.birth), death = values_.exact(*pair.death);
    const std::string fault = level == birth ? tunnels_.fault_at_birth(loops, rational(birth), rational(death))
                                             : tunnels_.fault_at_level(loops, rational(level), rational(death));
    return fault == "too-few" ? "" : fault;
  }

  void require_same_reason(const Edges& loop, const PersistencePair& pair, const Rational& level) {
    const std::string fault = oracle_reason({of_oracle(loop)}, pair, level);
    const std::string found = reason_text(classes_.of(loop, pair, level).fault);
    require_none(input_, found == fault ? "" : '"' + found + "\" of a loop, and not \"" + fault + '"', "");
    ++totals_[found];
  }

  // Several loops at one level, as a claim of pairs with one birth and death, or one death.
  void require_same_sets(const PersistencePair& pair) {
    const Rational birth = values_.exact(pair.birth), death = values_.exact(*pair.death);
    const Rational level = birth + static_cast<int>(below(2, random_)) * (death - birth) / 4;
    CycleClaim claim;
    std::vector<oracle::Loop> loops;
    Edges sum;
    for (const PersistencePair& other : pairs_) {
      if (values_.rank(*other.death) != values_.rank(*pair.death) || values_.exact(other.birth) > level) continue;
      if (level == birth && values_.rank(other.birth) != values_.rank(pair.birth)) continue;
      ClaimedCycle cycle;
      cycle.birth.squared_distance = exact(values_.exact(other.birth));
      cycle.death.squared_distance = exact(death);
      cycle.squared_level = exact(level);
      cycle.edges = loop_at(other, level);
      // Sometimes the sum of all before it.
      if (below(2, random_) == 0 && !sum.empty()) cycle.edges = sum;
      sum.insert(sum.end(), cycle.edges.begin(), cycle.edges.end());
      loops.push_back(of_oracle(cycle.edges));
      claim.cycles.push_back(std::move(cycle));
    }
    auto differences = cycle_differences(complex_, claim, 1e-9);
    // The oracle looks at each loop by itself first.
    std::ranges::stable_sort(differences, {}, [](const PairDifference& one) { return one.reason == "dependent"; });
    const std::string found = differences.empty() ? "" : differences.front().reason;
    const std::string fault = oracle_reason(loops, pair, level);
    require_none(input_, found == fault ? "" : '"' + found + "\" of loops, and not \"" + fault + '"', "");
    if (found == "dependent") ++totals_[found];
    // The last one once more.
    if (!fault.empty() || claim.cycles.empty() || claim.cycles.size() > 1) return;
    claim.cycles.push_back(claim.cycles.back());
    for (const PairDifference& difference : cycle_differences(complex_, claim, 1e-9)) ++totals_[difference.reason];
  }

  [[nodiscard]] ClaimedCycle claimed(const PersistencePair& pair, const Rational& level) const {
    ClaimedCycle cycle;
    const auto birth = complex_.stationary().contact(pair.birth), death = complex_.stationary().contact(*pair.death);
    cycle.birth.contact.assign(birth.begin(), birth.end());
    cycle.death.contact.assign(death.begin(), death.end());
    cycle.squared_level = exact(level);
    return cycle;
  }
  void require_reason(int dimension, ClaimedCycle cycle, const std::string& reason) {
    CycleClaim claim;
    claim.dimension = dimension;
    claim.cycles.push_back(std::move(cycle));
    const auto differences = cycle_differences(complex_, claim, 1e-9);
    const std::string found = differences.empty() ? "" : differences.front().reason;
    require_none(input_, found == reason ? "" : '"' + found + "\" and not \"" + reason + '"', "");
    ++totals_[found];
  }
  template <class Index>
  void toggle_any(std::vector<std::vector<PointId>>& contacts, Index index) {
    std::vector<std::vector<PointId>> all;
    for (std::size_t i = 0; i < complex_.stationary().size(); ++i) {
      if (complex_.stationary().index(i) != index) continue;
      const auto contact = complex_.stationary().contact(i);
      all.emplace_back(contact.begin(), contact.end());
    }
    const auto& one = all[below(all.size(), random_)];
    if (std::erase(contacts, one) == 0) contacts.push_back(one);
  }

  void require_right_surfaces(const PersistencePair& pair) {
    const Rational birth = values_.exact(pair.birth), death = values_.exact(*pair.death);
    for (const int share : {0, 1, 2}) {
      const Rational level = birth + share * (death - birth) / 4;
      ClaimedCycle cycle = claimed(pair, level);
      cycle.edges = loop_at(pair, level);
      cycle.saddles.emplace();
      for (const std::uint32_t saddle : loops_.surface(pair, level)) {
        const auto contact = complex_.stationary().contact(saddle);
        cycle.saddles->emplace_back(contact.begin(), contact.end());
      }
      require_reason(1, cycle, "");
      // Without ties, no boundary of an index-2 point is zero but that of one above a void.
      if (complex_.stable().statistics().broken_ties > 0) continue;
      toggle_any(*cycle.saddles, StationaryIndex{2, 2});
      require_reason(1, cycle, "surface-boundary");
    }
  }

  void require_right_voids() {
    const Voids voids(complex_.merge_trees());
    for (const PersistencePair& pair : complex_.persistence().pairs()) {
      if (pair.dimension != 2) continue;
      const Rational birth = values_.exact(pair.birth), death = values_.exact(*pair.death);
      for (int share = 0; share < 6; ++share) {
        const Rational level = birth + share * (death - birth) / 6;
        ClaimedCycle cycle = claimed(pair, level);
        cycle.maxima.emplace();
        for (const std::uint32_t maximum : voids.at(*pair.death, level).maxima) {
          const auto contact = complex_.stationary().contact(maximum);
          cycle.maxima->emplace_back(contact.begin(), contact.end());
        }
        if (share % 3 == 0) require_reason(2, cycle, "");
        toggle_any(*cycle.maxima, StationaryIndex{3, 3});
        require_reason(2, cycle, "wrong-void");
      }
    }
  }

  const fuzz::Input& input_;
  std::mt19937_64& random_;
  FlowComplex complex_;
  oracle::fast::PointSet set_;
  oracle::CechTunnels tunnels_;
  const SquaredDistances& values_;
  Loops loops_;
  LoopClasses classes_;
  std::vector<PersistencePair> pairs_;
  Totals& totals_;
};

// Rectangles in circles of one radius, far from each other: their loops are born at different values, and die at one.
fuzz::Input of_one_death(std::mt19937_64& random) {
  using Sides = std::vector<std::array<int, 2>>;
  static const std::vector<Sides> kCircles = {{{1, 7}, {5, 5}},   {{1, 8}, {4, 7}},  {{2, 9}, {6, 7}},
                                              {{2, 11}, {5, 10}}, {{3, 11}, {7, 9}}, {{1, 18}, {6, 17}, {10, 15}}};
  fuzz::Input input;
  int height = 0;
  for (const auto& [a, b] : kCircles[below(kCircles.size(), random)]) {
    height += 100 + static_cast<int>(below(10, random));
    for (const int x : {-a, a}) {
      for (const int y : {-b, b})
        input.rows.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(height)});
    }
  }
  return input;
}

TEST(CycleClaims, AreJudgedAsTheOracleDoes) {
  CITES("FC-CLAIM-25", "FC-CYC-01", "FC-CYC-02", "FC-CYC-03", "FC-CYC-06");
  Totals totals;
  std::mt19937_64 random(47);
  bool agreed = true;
  for (const fuzz::Family& family : fuzz::families()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds("cycles, " + family.name, parameters_of_run(kInputsPerFamily, agreed),
                          [&] {
                            fuzz::Input input = *generator;
                            const fuzz::Input more = *generator;
                            input.rows.insert(input.rows.end(), more.rows.begin(), more.rows.end());
                            if (input.rows.size() > kMostRows) input.rows.resize(kMostRows);
                            ChangedLoops(input, random, totals).require_same_reasons();
                          }) &&
             agreed;
  }
  for (int k = 0; k < kInputsOfOneDeath; ++k) {
    const fuzz::Input input = of_one_death(random);
    ChangedLoops(input, random, totals).require_same_reasons();
  }
  for (const auto& [reason, count] : totals) std::printf("%-18s %6zu\n", reason.c_str(), count);
  if (!agreed || scale_of_run() < 1) return;
  for (const char* reason : {"", "not-a-cycle", "edge-too-long", "born-earlier", "dies-earlier", "dies-later",
                             "dependent", "surface-boundary", "wrong-void"}) {
    EXPECT_GE(totals[reason], 1000U) << reason;
  }
}

}  // namespace
}  // namespace flowcert::property::cycle_claims_test
