// Loops, voids and components by the fast implementation against the oracle, on all families (FC-CYC).
//
// Guarantees: loops at birth and at four levels are judged by the Čech filtration, which has neither flow nor
// triangulation, with ties broken in five ways; voids are compared with parts of the oracle's merge tree. Wrong loops
// are made of right ones, and the oracle has to say what is wrong with them. The test fails too when too few inputs had
// ties, loops of several surfaces, or a fault of each sort.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/loops.h"
#include "flowcert/voids.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/loops.h"
#include "oracle/voids.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::cycle_agreement_test {
namespace {

// `./dev test` has 300 inputs, and `--slow`, which draws four times as many, 2,000.
constexpr int kInputsPerFamily = 9, kMoreInputsPerFamily = 14;
constexpr std::size_t kMostRows = 10;
// The oracle takes long to find the maxima above all points. So voids are compared on fewer and smaller inputs.
constexpr std::size_t kInputsToVoids = 9, kMostRowsWithVoids = 9;
constexpr std::uint64_t kSeeds[] = {0, 1, 2, 3, 20};

struct Totals {
  std::size_t inputs = 0, with_ties = 0, loops = 0, several = 0, voids = 0, joined = 0;
  std::map<std::string, std::size_t> faults;

  void add(const Totals& part) {
    inputs += part.inputs;
    with_ties += part.with_ties;
    loops += part.loops;
    several += part.several;
    voids += part.voids;
    joined += part.joined;
    for (const auto& [fault, count] : part.faults) faults[fault] += count;
  }
  void print_row(const std::string& name) const {
    std::printf("%-22s %5zu inputs, %5zu with ties; %6zu loops, %5zu of several surfaces; %5zu voids, %5zu joined\n",
                name.c_str(), inputs, with_ties, loops, several, voids, joined);
  }
};

oracle::Rational rational(const Rational& value) { return oracle::Rational(value); }

// The loops of one complex, by the oracle's places of samples.
class LoopsOfPairs {
 public:
  LoopsOfPairs(const fuzz::Input& input, const FlowComplex& complex, const oracle::PointSet& set,
               const oracle::CechTunnels& tunnels, Totals& totals)
      : input_(input),
        complex_(complex),
        set_(set),
        tunnels_(tunnels),
        values_(complex.persistence().squared_distances()),
        loops_(complex.stationary(), complex.links(), complex.persistence()),
        totals_(totals) {
    for (const PersistencePair& pair : complex.persistence().pairs()) {
      if (pair.dimension == 1) by_death_[values_.exact(*pair.death)].push_back(pair);
    }
  }

  void require_right() {
    for (const auto& [death, pairs] : by_death_) {
      std::set<Rational> births, levels;
      for (const PersistencePair& pair : pairs) births.insert(values_.exact(pair.birth));
      for (const Rational& birth : births) {
        require_right_at_birth(birth, death, pairs);
        for (const Rational& share : {Rational(0), Rational(1, 4), Rational(1, 2), Rational(9, 10)}) {
          levels.insert(birth + share * (death - birth));
        }
      }
      for (const Rational& level : levels) require_right_at(level, death, pairs);
    }
  }
  // Each of these has a fault that the oracle names.
  void require_faults() {
    for (const auto& [death, pairs] : by_death_) {
      for (const PersistencePair& pair : pairs) {
        const Rational birth = values_.exact(pair.birth);
        require_faults_at_birth(birth, death, pairs);
        require_faults_at(birth + (death - birth) / 4, death, pairs);
      }
    }
  }

 private:
  [[nodiscard]] oracle::Loop loop_at(const PersistencePair& pair, const Rational& level) const {
    oracle::Loop loop;
    const std::vector<std::uint32_t> surface = loops_.surface(pair, level);
    totals_.several += surface.size() > 1 ? 1 : 0;
    for (const std::uint32_t edge : loops_.boundary(surface)) {
      const auto ends = complex_.stationary().contact(edge);
      const auto places = oracle::places_of(set_, {ends[0], ends[1]});
      loop.push_back({std::min(places[0], places[1]), std::max(places[0], places[1])});
    }
    ++totals_.loops;
    return loop;
  }

  void require(const std::string& found, const std::string& expected, const std::string& what) const {
    if (found == expected) return;
    require_none(input_, what + ": \"" + found + "\" and not \"" + expected + '"', "");
  }
  void require_fault(const std::string& found, const std::string& expected) const {
    require(found, expected, "a wrong loop");
    ++totals_.faults[found];
  }

  void require_right_at_birth(const Rational& birth, const Rational& death, const std::vector<PersistencePair>& pairs) {
    std::vector<oracle::Loop> loops;
    for (const PersistencePair& pair : pairs) {
      if (values_.exact(pair.birth) == birth) loops.push_back(loop_at(pair, birth));
    }
    require(tunnels_.fault_at_birth(loops, rational(birth), rational(death)), "", "loops at birth");
  }
  void require_faults_at_birth(const Rational& birth, const Rational& death,
                               const std::vector<PersistencePair>& pairs) {
    for (const PersistencePair& pair : pairs) {
      const Rational earlier = values_.exact(pair.birth);
      if (earlier >= birth) continue;
      require_fault(tunnels_.fault_at_birth({loop_at(pair, earlier)}, rational(birth), rational(death)),
                    "born-earlier");
    }
  }

  [[nodiscard]] std::vector<oracle::Loop> loops_at(const Rational& level,
                                                   const std::vector<PersistencePair>& pairs) const {
    std::vector<oracle::Loop> loops;
    for (const PersistencePair& pair : pairs) {
      if (values_.exact(pair.birth) <= level) loops.push_back(loop_at(pair, level));
    }
    return loops;
  }
  void require_right_at(const Rational& level, const Rational& death, const std::vector<PersistencePair>& pairs) {
    require(tunnels_.fault_at_level(loops_at(level, pairs), rational(level), rational(death)), "", "loops at a level");
  }
  void require_faults_at(const Rational& level, const Rational& death, const std::vector<PersistencePair>& pairs) {
    const std::vector<oracle::Loop> loops = loops_at(level, pairs);
    const auto fault = [&](const std::vector<oracle::Loop>& some, const Rational& at) {
      return tunnels_.fault_at_level(some, rational(at), rational(death));
    };
    std::vector<oracle::Loop> changed = loops;
    changed.back().pop_back();
    require_fault(fault(changed, level), "not-a-cycle");
    changed = loops;
    changed.pop_back();
    require_fault(fault(changed, level), "too-few");
    changed.assign(2, loops.front());
    require_fault(fault(changed, level), "dependent");
    Rational longest = 0;
    for (const oracle::Edge& edge : loops.front()) {
      longest = std::max(longest, Rational(tunnels_.values[tunnels_.edge_place.at(edge)]));
    }
    require_fault(fault({loops.front()}, longest * Rational(99, 100)), "edge-too-long");
    for (const auto& [other_death, others] : by_death_) {
      if (other_death == death || values_.exact(others.front().birth) > level || level >= other_death) continue;
      require_fault(fault({loop_at(others.front(), level)}, level),
                    other_death > death ? "dies-later" : "dies-earlier");
    }
  }

  const fuzz::Input& input_;
  const FlowComplex& complex_;
  const oracle::PointSet& set_;
  const oracle::CechTunnels& tunnels_;
  const SquaredDistances& values_;
  Loops loops_;
  std::map<Rational, std::vector<PersistencePair>> by_death_;
  Totals& totals_;
};

std::vector<std::size_t> places_of(const std::vector<std::uint32_t>& records) {
  return {records.begin(), records.end()};
}

void require_same_voids(fuzz::Input input, Totals& totals) {
  if (input.rows.size() > kMostRowsWithVoids) input.rows.resize(kMostRowsWithVoids);
  const FlowComplex complex(point_set_of(input));
  const oracle::fast::PointSet set(input.rows);
  const std::vector<oracle::StationaryPoint> all = oracle::stationary_points(set).stationary;
  const oracle::MergeTree tree = oracle::superlevel_tree(set, all), below = oracle::sublevel_tree(set, all);
  const oracle::PeaksAbove above = oracle::peaks_above(set, all);
  const Voids voids(complex.merge_trees());
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    if (pair.dimension == 2) {
      const Rational birth = complex.persistence().squared_value(pair.birth);
      const Rational death = complex.persistence().squared_value(*pair.death);
      for (const Rational& share : {Rational(0), Rational(1, 4), Rational(1, 2), Rational(9, 10)}) {
        const Rational level = birth + share * (death - birth);
        const Void fast = voids.at(*pair.death, level);
        const oracle::Void truth = oracle::void_at(all, tree, above, *pair.death, rational(level));
        const oracle::Void same{places_of(fast.maxima), places_of(fast.cell), places_of(fast.walls)};
        require_none(input, same == truth ? "" : "another void", "");
        ++totals.voids;
      }
    }
    if (pair.dimension == 0 && pair.death) {
      const auto fast = components_at(complex.merge_trees(), *pair.death);
      const auto truth = oracle::components_at(set, below, all[*pair.death]);
      const bool is_same = places_of(fast[0]) == truth[0] && places_of(fast[1]) == truth[1];
      require_none(input, is_same ? "" : "other components", "");
      ++totals.joined;
    }
  }
}

void require_right(const fuzz::Input& input, Totals& totals) {
  const PointSet points = point_set_of(input);
  const oracle::fast::PointSet set(input.rows);
  const oracle::CechTunnels tunnels(set);
  std::vector<PersistencePair> pairs;
  for (const std::uint64_t seed : kSeeds) {
    const FlowComplex complex(points, {.seed = seed});
    if (seed == 0) pairs = complex.persistence().pairs();
    require_none(input, pairs == complex.persistence().pairs() ? "" : "pairs that depend on the seed", "");
    LoopsOfPairs loops(input, complex, set, tunnels, totals);
    loops.require_right();
    if (seed != 0) continue;
    loops.require_faults();
    if (totals.inputs % kInputsToVoids == 0) require_same_voids(input, totals);
    totals.with_ties += complex.stable().statistics().broken_ties > 0 ? 1 : 0;
  }
  ++totals.inputs;
}

TEST(CycleAgreement, LoopsAndVoidsAreTheOracles) {
  CITES("FC-CYC-01", "FC-CYC-02", "FC-CYC-03", "FC-CYC-04", "FC-CYC-06", "FC-CYC-07", "FC-CHAIN-02");
  Totals all;
  bool agreed = true;
  for (const fuzz::Family& family : fuzz::families()) {
    Totals totals;
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds("cycles, " + family.name,
                          parameters_of_run(scale_of_run() > 1 ? kMoreInputsPerFamily : kInputsPerFamily, agreed),
                          [&] {
                            fuzz::Input input = *generator;
                            const fuzz::Input more = *generator;
                            input.rows.insert(input.rows.end(), more.rows.begin(), more.rows.end());
                            if (input.rows.size() > kMostRows) input.rows.resize(kMostRows);
                            require_right(input, totals);
                          }) &&
             agreed;
    totals.print_row(family.name);
    all.add(totals);
  }
  all.print_row("all");
  for (const auto& [fault, count] : all.faults) std::printf("%-22s %6zu wrong loops\n", fault.c_str(), count);
  if (!agreed || scale_of_run() < 1) return;
  EXPECT_GE(all.inputs, 300U);
  EXPECT_GE(all.with_ties, 50U);
  EXPECT_GE(all.several, 1000U);
  EXPECT_GE(all.voids, 40U);
  for (const char* fault :
       {"not-a-cycle", "edge-too-long", "born-earlier", "dies-earlier", "dies-later", "dependent", "too-few"}) {
    EXPECT_GE(all.faults[fault], 10U) << fault;
  }
}

}  // namespace
}  // namespace flowcert::property::cycle_agreement_test
