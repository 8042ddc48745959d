// The oracle's judge of witnesses: those of the library are right, whatever ties it broke how, and changed ones are
// wrong where the list of all boundaries says so.
//
// Guarantees: what a changed witness has to be refused for comes from the library's boundaries of all index-2 points,
// while the oracle looks for the ones that matter by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "flowcert/flow_complex.h"
#include "flowcert/loops.h"
#include "fuzz/properties/input_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/stable_pieces.h"
#include "oracle/witness.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"
#include "tests/unit/portable_random.h"

namespace flowcert::oracle_witness_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Records = std::vector<std::uint32_t>;
using oracle::Contact;

const Rows kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
// FC-CHAIN-01, FC-CHAIN-02.
const Rows kTwoTriangles = {{0, 0, 0}, {8, 0, 0}, {4, 7, 0}, {4, -2, 0}};
const Rows kTieBelow = {{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}};

// Two cubes and the centres of their faces.
Rows face_centred_cubes() {
  Rows rows;
  for (int x = 0; x <= 4; ++x) {
    for (int y = 0; y <= 2; ++y) {
      for (int z = 0; z <= 2; ++z) {
        if ((x + y + z) % 2 == 0) rows.push_back({double(x), double(y), double(z)});
      }
    }
  }
  return rows;
}

struct Seen {
  std::size_t right = 0, met = 0, ties = 0, open = 0;
  std::map<std::string, std::size_t> faults;
};

class Witnesses {
 public:
  Witnesses(const Rows& rows, std::uint64_t seed, Seen& seen)
      : complex_(PointSet(property::rows_of(fuzz::Input{.rows = rows})), {.seed = seed}),
        set_(rows),
        values_(complex_.persistence().squared_distances()),
        loops_(complex_.stationary(), complex_.links(), complex_.persistence()),
        random_(seed),
        seen_(seen) {
    const auto& counts = complex_.stationary().critical_counts();
    for (std::size_t k = 0; k < counts[1] + counts[2]; ++k) {
      (k < counts[1] ? edges_ : saddles_).push_back(static_cast<std::uint32_t>(counts[0] + k));
    }
  }

  // The boundaries of the library are among those that FC-CHAIN-02 permits, and the points above an edge are all that
  // have it in their boundaries.
  void expect_boundaries() {
    std::map<std::uint32_t, std::set<Contact>> above;
    oracle::Rational beyond = 0;
    for (const std::uint32_t saddle : saddles_) {
      const oracle::StationaryPoint x = point(saddle);
      beyond = std::max<oracle::Rational>(beyond, x.squared_distance + 1);
      const auto [chain, ties] = oracle::boundary(set_, x);
      const std::vector<Contact> lower = contacts(lower_of(saddle));
      const oracle::Chain difference = oracle::sum(chain, {lower.begin(), lower.end()});
      EXPECT_TRUE(oracle::is_sum_of(difference, ties));
      seen_.ties += oracle::has_tie(oracle::stable_set(set_, x)) ? 1 : 0;
      seen_.open += ties.empty() ? 0 : 1;
      for (const std::uint32_t edge : lower_of(saddle)) above[edge].insert(contact(saddle));
    }
    for (const std::uint32_t edge : edges_) {
      std::set<Contact> found;
      for (const auto& x : oracle::saddles_above(set_, {point(edge)}, beyond)) found.insert(x.contact);
      EXPECT_TRUE(std::ranges::includes(found, above[edge]));
    }
  }

  // Of so many pairs, those that last longest in the order of all values.
  void expect_verdicts(std::size_t most_pairs) {
    std::vector<PersistencePair> pairs;
    for (const PersistencePair& pair : complex_.persistence().pairs()) {
      if (pair.dimension == 1) pairs.push_back(pair);
    }
    const auto values_between = [&](const PersistencePair& pair) {
      return values_.rank(*pair.death) - values_.rank(pair.birth);
    };
    std::ranges::stable_sort(pairs, std::greater<>(), values_between);
    if (pairs.size() > most_pairs) pairs.resize(most_pairs);
    for (const PersistencePair& pair : pairs) {
      const LoopWitness parts = loops_.witness(pair);
      const oracle::Witness right = {contact(pair.birth),     contact(*pair.death),    contacts(parts.loop),
                                     contacts(parts.surface), contacts(parts.cocycle), contacts(parts.met)};
      expect_fault(right, "");
      ++seen_.right;
      seen_.met += parts.met.size();
      Records later;
      std::ranges::copy_if(edges_, std::back_inserter(later),
                           [&](std::uint32_t edge) { return values_.rank(edge) >= values_.rank(pair.birth); });
      for (const bool is_added : {false, true}) {
        expect_refused_loop(right, parts, is_added);
        expect_verdict_of_surface(right, parts, pair, is_added);
        expect_verdict_of_cocycle(right, parts, pair, is_added ? later : edges_, is_added);
      }
      expect_verdict_of_cocycle(right, parts, pair, edges_, true);
      expect_refused_whole(right, parts, pair);
    }
  }

 private:
  [[nodiscard]] Contact contact(std::uint32_t record) const {
    const auto names = complex_.stationary().contact(record);
    return {names.begin(), names.end()};
  }
  [[nodiscard]] std::vector<Contact> contacts(std::span<const std::uint32_t> records) const {
    std::vector<Contact> result;
    for (const std::uint32_t record : records) result.push_back(contact(record));
    return result;
  }
  [[nodiscard]] oracle::StationaryPoint point(std::uint32_t record) const {
    const oracle::Places places = oracle::places_of(set_, contact(record));
    const auto samples = oracle::select(set_.points, places);
    return oracle::stationary_point(set_, oracle::circumcentre(oracle::spanning_subset(samples))->center, places);
  }
  [[nodiscard]] std::span<const std::uint32_t> lower_of(std::uint32_t saddle) const {
    return complex_.links().lower(saddle - saddles_.front());
  }

  void expect_fault(const oracle::Witness& witness, const std::string& expected) {
    EXPECT_EQ(oracle::fault(set_, witness), expected);
    ++seen_.faults[expected];
  }

  // The list without one of its members, or with one of the others.
  [[nodiscard]] Records changed(Records list, const Records& all, bool is_added, std::uint32_t& member) {
    Records others;
    std::ranges::set_difference(all, list, std::back_inserter(others));
    const Records& from = is_added && !others.empty() ? others : list;
    member = from[random_.below(from.size())];
    Records result;
    std::ranges::set_symmetric_difference(list, Records{member}, std::back_inserter(result));
    return result;
  }

  void expect_refused_loop(oracle::Witness witness, const LoopWitness& parts, bool is_added) {
    std::uint32_t member = 0;
    witness.loop = contacts(changed(parts.loop, edges_, is_added, member));
    expect_fault(witness, "not-a-cycle");
  }

  // A point whose boundary is zero, up to ties, may be in a surface or not.
  void expect_verdict_of_surface(oracle::Witness witness, const LoopWitness& parts, const PersistencePair& pair,
                                 bool is_added) {
    std::uint32_t member = 0;
    const Records surface = changed(parts.surface, saddles_, is_added, member);
    witness.surface = contacts(surface);
    if (values_.rank(member) > values_.rank(*pair.death)) return expect_fault(witness, "surface-too-late");
    std::vector<oracle::Chain> ties;
    for (const std::uint32_t saddle : surface) {
      const std::vector<oracle::Chain> more = oracle::boundary(set_, point(saddle)).ties;
      ties.insert(ties.end(), more.begin(), more.end());
    }
    const std::vector<Contact> lower = contacts(lower_of(member));
    const bool is_zero = oracle::is_sum_of({lower.begin(), lower.end()}, ties);
    expect_fault(witness, is_zero ? "" : "surface-boundary");
  }

  void expect_verdict_of_cocycle(oracle::Witness witness, const LoopWitness& parts, const PersistencePair& pair,
                                 const Records& all, bool is_added) {
    std::uint32_t member = 0;
    const Records cocycle = changed(parts.cocycle, all, is_added, member);
    witness.cocycle = contacts(cocycle);
    witness.met.clear();
    const auto common = [&](std::span<const std::uint32_t> chain) {
      return std::ranges::count_if(chain, [&](auto edge) { return std::ranges::binary_search(cocycle, edge); });
    };
    bool is_odd = false;
    for (const std::uint32_t saddle : saddles_) {
      if (values_.rank(saddle) >= values_.rank(*pair.death)) continue;
      if (common(lower_of(saddle)) > 0) witness.met.push_back(contact(saddle));
      is_odd = is_odd || common(lower_of(saddle)) % 2 == 1;
    }
    if (values_.rank(member) < values_.rank(pair.birth)) return expect_fault(witness, "cocycle-too-early");
    if (common(parts.loop) % 2 == 0) return expect_fault(witness, "even-on-loop");
    expect_fault(witness, is_odd ? "odd-boundary" : "");
  }

  void expect_refused_whole(const oracle::Witness& right, const LoopWitness& parts, const PersistencePair& pair) {
    oracle::Witness witness = right;
    std::swap(witness.birth, witness.death);
    expect_fault(witness, "no-critical-point");
    witness = right;
    witness.loop.push_back(witness.loop.front());
    expect_fault(witness, "repeated");
    witness = right;
    witness.surface = {right.death};
    witness.loop = contacts(lower_of(*pair.death));
    const auto is_later = [&](std::uint32_t edge) { return values_.rank(edge) > values_.rank(pair.birth); };
    if (std::ranges::any_of(lower_of(*pair.death), is_later)) expect_fault(witness, "born-later");
    if (!parts.met.empty() && oracle::boundary(set_, point(parts.met.back())).ties.empty()) {
      witness = right;
      witness.met.pop_back();
      expect_fault(witness, "met");
    }
    witness = right;
    witness.met.push_back(right.death);
    expect_fault(witness, "met");
    expect_refused_ends(right, pair);
  }

  // No pair has another birth or death with this loop and cocycle.
  void expect_refused_ends(const oracle::Witness& right, const PersistencePair& pair) {
    oracle::Witness witness = right;
    const std::uint32_t edge = edges_[random_.below(edges_.size())];
    witness.birth = contact(edge);
    if (values_.rank(edge) < values_.rank(pair.birth)) expect_fault(witness, "born-later");
    if (values_.rank(edge) > values_.rank(pair.birth)) expect_fault(witness, "cocycle-too-early");
    witness = right;
    const std::uint32_t saddle = saddles_[random_.below(saddles_.size())];
    witness.death = contact(saddle);
    if (values_.rank(saddle) < values_.rank(*pair.death)) expect_fault(witness, "surface-too-late");
    if (values_.rank(saddle) > values_.rank(*pair.death)) expect_fault(witness, "odd-boundary");
  }

  FlowComplex complex_;
  oracle::fast::PointSet set_;
  const SquaredDistances& values_;
  Loops loops_;
  flowcert_tests::PortableRandom random_;
  Seen& seen_;
  Records edges_, saddles_;
};

// All faults that there are.
void expect_all_faults(const Seen& seen) {
  for (const char* fault : {"", "born-later", "cocycle-too-early", "even-on-loop", "met", "no-critical-point",
                            "not-a-cycle", "odd-boundary", "repeated", "surface-boundary", "surface-too-late"}) {
    EXPECT_TRUE(seen.faults.contains(fault)) << fault;
  }
}

TEST(OracleWitness, IsToldFromChangedOnesOfSmallSets) {
  CITES("FC-CYC-08", "FC-CHAIN-01", "FC-CHAIN-02");
  Seen seen;
  for (const Rows& rows : {kSquare, kTwoTriangles, kTieBelow, face_centred_cubes()}) {
    for (const std::uint64_t seed : {0U, 1U}) {
      Witnesses witnesses(rows, seed, seen);
      witnesses.expect_boundaries();
      witnesses.expect_verdicts(3);
    }
  }
  expect_all_faults(seen);
  EXPECT_GT(seen.open, 0U);
}

TEST(OracleWitness, IsToldFromChangedOnesOfDegenerateSets) {
  CITES("FC-CYC-08", "FC-CHAIN-01", "FC-CHAIN-02");
  Seen seen;
  const flowcert_tests::DrawnSets sets{.seeds = 1, .made = 4, .most_rows = 16};
  flowcert_tests::for_each_drawn_set(sets, [&](const Rows& rows, std::uint64_t seed) {
    Witnesses witnesses(rows, seed, seen);
    witnesses.expect_boundaries();
    witnesses.expect_verdicts(1);
  });
  flowcert_tests::for_each_grid([&](const Rows& rows) {
    Witnesses witnesses(Rows(rows.begin(), rows.begin() + 30), 3, seen);
    witnesses.expect_verdicts(1);
  });
  expect_all_faults(seen);
  EXPECT_GT(seen.met, 20U);
  EXPECT_GT(seen.ties, 10U);
  EXPECT_GT(seen.open, 0U);
}

}  // namespace
}  // namespace flowcert::oracle_witness_test
