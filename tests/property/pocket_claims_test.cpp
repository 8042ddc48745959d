// Claims of pockets: right ones, and right ones with one thing made wrong.
//
// Guarantees: what the fast implementation writes reads back and conforms, by the fast implementation and by the
// oracle, also with pockets in another order and numbers in decimals. Each mutant fails on the level that it should,
// by both. The test fails too when some kind of mutant was hardly ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/judge/oracle_truth.h"
#include "fuzz/properties/input_points.h"
#include "geometry/difference_of_roots.h"
#include "io/write_pockets.h"
#include "tests/chambers.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::pocket_claims_test {
namespace {

constexpr std::uint64_t kInputs = 20;
// The oracle's time grows with a high power of the number of points.
constexpr std::size_t kMostRowsForOracle = 14, kClaimsForOracle = 4;
constexpr int kTrials = 8;  // so many pockets are looked at for one that a mutation can change

std::string written(const ClaimSubject& subject, const Rational& squared_persistence, bool has_exact_volumes = true) {
  std::ostringstream out;
  const Pockets pockets(subject.complex.merge_trees(), squared_persistence);
  const std::optional<Rational> widest =
      pockets.widest_path() ? std::optional(pockets.squared_distances().exact(pockets.widest_path()->gates.front()))
                            : std::nullopt;
  write_pockets(out, {subject.complex, pockets, Probe{widest.value_or(1) / 2}, has_exact_volumes});
  return out.str();
}

// So many claims are judged by the oracle, too. At least one is.
std::size_t claims_for_oracle() {
  const double scaled = static_cast<double>(kClaimsForOracle) * std::min(scale_of_run(), 1.0);
  return std::max<std::size_t>(static_cast<std::size_t>(scaled), 1);
}

Rational square_of_depth(const Pockets& all, const Pocket& pocket) {
  const SquaredDistances& values = all.squared_distances();
  return geometry::square_from_above({values.exact(pocket.peaks.front()), values.exact(pocket.highest_mouth)});
}

// Calls the property on inputs, each at a few squared persistences: 0, that of a depth, and more than all.
template <typename Property>
void on_pockets(std::uint64_t inputs, Property&& property) {
  const auto count = static_cast<std::uint64_t>(static_cast<double>(inputs) * scale_of_run());
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const fuzz::Input input = fuzz::input_with_pockets(seed);
    const bool is_right = expect_holds("pocket claims", parameters_of_one_input(), [&] {
      const ClaimSubject subject(input);
      const Pockets all(subject.complex.merge_trees(), 0);
      std::vector<Rational> squares = {0};
      if (all.size() > 0) squares.push_back(square_of_depth(all, all[all.size() / 2]));
      if (seed % 8 == 0) squares.emplace_back(1000000);
      for (const Rational& square : squares) property(subject, square);
    });
    if (!is_right) return;
  }
}

// ---- Right claims ----

template <typename Change>
void for_each_number(ClaimedPockets& pockets, const Change& change) {
  const auto witness = [&](ClaimedWitness& one) {
    if (one.center) std::ranges::for_each(*one.center, change);
    if (one.squared_radius) change(*one.squared_radius);
  };
  for (ClaimedPocket& pocket : pockets.pockets) {
    std::ranges::for_each(*pocket.peaks, witness);
    for (ClaimedMouth& mouth : *pocket.mouths) witness(mouth.at);
    std::ranges::for_each(pocket.widest_path->witnesses, witness);
    change(*pocket.difference_of_squares);
    if (pocket.volume->number) change(*pocket.volume->number);
  }
}

// The pocket that was k is then the one at to[k].
void renumber(ClaimedPockets& pockets, const std::vector<std::size_t>& to) {
  std::vector<ClaimedPocket> moved(pockets.pockets.size());
  const auto rename = [&to](std::vector<std::int64_t>& numbers) {
    for (std::int64_t& number : numbers) {
      if (number >= 0) number = static_cast<std::int64_t>(to[static_cast<std::size_t>(number)]);
    }
    std::ranges::reverse(numbers);
  };
  for (std::size_t k = 0; k < moved.size(); ++k) {
    ClaimedPocket& pocket = moved[to[k]] = pockets.pockets[k];
    rename(*pocket.neighbours);
    for (ClaimedMouth& mouth : *pocket.mouths) rename(*mouth.between);
    std::ranges::reverse(*pocket.mouths);
    std::ranges::reverse(*pocket.cell);
    std::ranges::reverse(pocket.maxima);
    for (auto& contact : pocket.maxima) std::ranges::reverse(contact);
  }
  pockets.pockets = std::move(moved);
}

Claim in_other_order(Claim claim) {
  std::vector<std::size_t> to(claim.pockets->pockets.size());
  std::iota(to.rbegin(), to.rend(), 0U);
  renumber(*claim.pockets, to);
  return claim;
}

Claim in_decimals(Claim claim) {
  for_each_number(*claim.pockets, [](ClaimedNumber& number) {
    if (const std::optional<double> nearest = nearest_double(number.value)) number = {Rational(*nearest), false};
  });
  return claim;
}

TEST(PocketClaims, WhatIsWrittenConforms) {
  CITES("FC-CLAIM-18", "FC-CLAIM-05", "FC-POCK-11");
  std::size_t claims = 0, pockets = 0, by_oracle = 0;
  on_pockets(kInputs, [&](const ClaimSubject& subject, const Rational& squared_persistence) {
    const Claim read = read_claim_from(written(subject, squared_persistence), "claim");
    const auto conforms = [&](const Claim& claim, bool is_exact, const std::string& what) {
      const CheckReport report = check(subject.points, claim, *subject.truth, {.tolerance = is_exact ? 0 : 1e-12});
      require(subject, report.verdict == Verdict::kConforms && report.is_exact == is_exact, what, report);
    };
    const bool is_empty = read.pockets->pockets.empty();
    conforms(read, true, "what is written");
    conforms(in_other_order(read), true, "in another order");
    conforms(in_decimals(read), is_empty, "in decimals");
    conforms(read_claim_from(written(subject, squared_persistence, false), "claim"), is_empty, "volumes in doubles");
    ++claims;
    pockets += read.pockets->pockets.size();
    if (subject.input.rows.size() > kMostRowsForOracle || by_oracle >= claims_for_oracle()) return;
    const auto oracle = judge::oracle_truth(rows_of(subject.input));
    const CheckReport report = check(subject.points, read, *oracle, {.tolerance = 0});
    require(subject, report.verdict == Verdict::kConforms, "by the oracle", report);
    ++by_oracle;
  });
  std::printf("%zu claims with %zu pockets, %zu also by the oracle\n", claims, pockets, by_oracle);
  if (scale_of_run() >= 1) {
    EXPECT_GT(claims, 30U);
    EXPECT_GT(pockets, 50U);
    EXPECT_EQ(by_oracle, kClaimsForOracle);
  }
}

// ---- Mutants ----
// A change of one pocket returns false where there is nothing to change.

using Change = std::function<bool(ClaimedPockets&, ClaimedPocket&)>;

template <typename Part>
bool drop_one(std::vector<Part>& parts) {
  if (parts.empty()) return false;
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(below(parts.size())));
  return true;
}
template <typename Part>
bool repeat_one(std::vector<Part>& parts) {
  if (parts.empty()) return false;
  parts.push_back(parts[below(parts.size())]);
  return true;
}
void add_a_little(ClaimedNumber& number) { number.value += Rational(1, 1000000); }
bool add_a_little(std::optional<ClaimedDouble>& claimed) {
  if (!claimed->number) return false;
  add_a_little(*claimed->number);
  return true;
}
ClaimedPocket* other_than(ClaimedPockets& all, const ClaimedPocket& pocket) {
  for (ClaimedPocket& other : all.pockets) {
    if (&other != &pocket) return &other;
  }
  return nullptr;
}

const std::map<std::string, Change>& changes() {
  using All = ClaimedPockets;
  using One = ClaimedPocket;
  static const std::map<std::string, Change> all = {
      {"pocket left out",
       [](All& all_pockets, One& pocket) {
         const auto place = &pocket - all_pockets.pockets.data();
         all_pockets.pockets.erase(all_pockets.pockets.begin() + place);
         for (One& other : all_pockets.pockets) {
           other.neighbours.reset();
           for (ClaimedMouth& mouth : *other.mouths) mouth.between.reset();
         }
         return true;
       }},
      {"pocket twice",
       [](All& all_pockets, One& pocket) {
         const One copy = pocket;  // NOLINT(performance-unnecessary-copy-initialization): it is in the vector
         all_pockets.pockets.push_back(copy);
         return true;
       }},
      {"maximum of another pocket",
       [](All& all_pockets, One& pocket) {
         const One* other = other_than(all_pockets, pocket);
         if (other == nullptr) return false;
         pocket.maxima.push_back(other->maxima.front());
         return true;
       }},
      {"maximum left out", [](All&, One& pocket) { return pocket.maxima.size() > 1 && drop_one(pocket.maxima); }},
      {"maximum twice", [](All&, One& pocket) { return repeat_one(pocket.maxima); }},
      {"maximum that is a mouth",
       [](All&, One& pocket) {
         pocket.maxima.front() = pocket.mouths->front().at.contact;
         return true;
       }},
      {"outside with a maximum",
       [](All& all_pockets, One& pocket) {
         all_pockets.outside->push_back(pocket.maxima.front());
         return true;
       }},
      {"peak left out", [](All&, One& pocket) { return drop_one(*pocket.peaks); }},
      {"peak twice", [](All&, One& pocket) { return repeat_one(*pocket.peaks); }},
      {"moved peak",
       [](All&, One& pocket) {
         add_a_little(pocket.peaks->front().center->at(below(3)));
         return true;
       }},
      {"peak with a larger radius", [](All&, One& pocket) { return add_a_little(pocket.peaks->front().radius); }},
      {"peak with a larger square",
       [](All&, One& pocket) {
         add_a_little(*pocket.peaks->front().squared_radius);
         return true;
       }},
      {"difference of squares",
       [](All&, One& pocket) {
         add_a_little(*pocket.difference_of_squares);
         return true;
       }},
      {"depth", [](All&, One& pocket) { return add_a_little(pocket.depth); }},
      {"depth that is no double",
       [](All&, One& pocket) {
         pocket.depth->number.reset();
         return true;
       }},
      {"one sample more in the lining",
       [](All&, One& pocket) {
         pocket.lining->push_back(0);
         return true;
       }},
      {"one sample less in the lining",
       [](All&, One& pocket) {
         pocket.lining->pop_back();
         return true;
       }},
      {"volume", [](All&, One& pocket) { return add_a_little(pocket.volume); }},
      {"volume that is no double",
       [](All&, One& pocket) {
         pocket.volume->number.reset();
         return true;
       }},
      {"cell with less", [](All&, One& pocket) { return drop_one(*pocket.cell); }},
      {"cell with something twice", [](All&, One& pocket) { return repeat_one(*pocket.cell); }},
      {"cell with another index",
       [](All&, One& pocket) {
         ClaimedCellPart& part = pocket.cell->front();
         const bool is_saddle = part.index == 2 && !part.hull_dimension;
         part = {is_saddle ? 3 : 2, std::nullopt, part.contact};
         return true;
       }},
      {"mouth left out", [](All&, One& pocket) { return drop_one(*pocket.mouths); }},
      {"mouth twice", [](All&, One& pocket) { return repeat_one(*pocket.mouths); }},
      {"mouth with a larger area", [](All&, One& pocket) { return add_a_little(pocket.mouths->front().area); }},
      {"mouth with a larger radius", [](All&, One& pocket) { return add_a_little(pocket.mouths->front().at.radius); }},
      {"mouth between fewer", [](All&, One& pocket) { return drop_one(*pocket.mouths->back().between); }},
      {"neighbour left out", [](All&, One& pocket) { return drop_one(*pocket.neighbours); }},
      {"neighbour twice", [](All&, One& pocket) { return repeat_one(*pocket.neighbours); }},
      {"gate left out",
       [](All&, One& pocket) {
         return pocket.widest_path->witnesses.size() > 1 && drop_one(pocket.widest_path->witnesses);
       }},
      {"gate that is a maximum",
       [](All&, One& pocket) {
         pocket.widest_path->witnesses.front().contact = pocket.maxima.front();
         return true;
       }},
      {"wider path",
       [](All&, One& pocket) {
         add_a_little(*pocket.widest_path->squared_radius);
         return true;
       }},
      {"something else for the probe",
       [](All&, One& pocket) {
         pocket.passage = pocket.passage == "cavity" ? "channel" : "cavity";
         return true;
       }},
      {"no pore limiting radius",
       [](All& all_pockets, One&) {
         all_pockets.pore_limiting_radius->radius.reset();
         return true;
       }},
      {"other largest ball",
       [](All& all_pockets, One&) { return repeat_one(all_pockets.largest_cavity_radius->radius->witnesses); }},
      {"larger cavity radius",
       [](All& all_pockets, One&) { return add_a_little(all_pockets.largest_cavity_radius->radius->radius); }},
  };
  return all;
}

// The claim with one pocket changed. Nothing if there is none that can be changed.
std::optional<Claim> changed(const Claim& claim, const Change& change) {
  if (claim.pockets->pockets.empty()) return std::nullopt;
  for (int trial = 0; trial < kTrials; ++trial) {
    Claim mutant = claim;
    ClaimedPocket& pocket = mutant.pockets->pockets[below(claim.pockets->pockets.size())];
    if (change(*mutant.pockets, pocket)) return mutant;
  }
  return std::nullopt;
}

bool fails_on_level_5(const CheckReport& report) {
  return report.verdict == Verdict::kFails && report.conforms[4] == false && report.conforms[2] == true;
}

TEST(PocketClaims, MutantsFail) {
  CITES("FC-CLAIM-18");
  std::map<std::string, std::size_t> made;
  std::size_t by_oracle = 0;
  on_pockets(kInputs, [&](const ClaimSubject& subject, const Rational& squared_persistence) {
    const Claim claim = read_claim_from(written(subject, squared_persistence), "claim");
    const bool is_small = subject.input.rows.size() <= kMostRowsForOracle && by_oracle < claims_for_oracle();
    by_oracle += is_small ? 1 : 0;
    const auto oracle = is_small ? judge::oracle_truth(rows_of(subject.input)) : nullptr;
    for (const auto& [name, change] : changes()) {
      const std::optional<Claim> mutant = changed(claim, change);
      if (!mutant) continue;
      ++made[name];
      const CheckReport report = check(subject.points, *mutant, *subject.truth, {.tolerance = 1e-12});
      require(subject, fails_on_level_5(report), name, report);
      if (!is_small) continue;
      const CheckReport other = check(subject.points, *mutant, *oracle, {.tolerance = 1e-12});
      require(subject, fails_on_level_5(other) && other.findings.size() == report.findings.size(),
              name + ", by the oracle", other);
    }
  });
  for (const auto& [name, change] : changes()) {
    std::printf("%-34s %6zu mutants\n", name.c_str(), made[name]);
    if (scale_of_run() >= 1) {
      EXPECT_GE(made[name], 3U) << name;
    }
  }
}

// A claim at another persistence has other pockets.
TEST(PocketClaims, AtAnotherPersistenceFail) {
  CITES("FC-CLAIM-18", "FC-POCK-02");
  std::size_t made = 0;
  on_pockets(kInputs, [&](const ClaimSubject& subject, const Rational& squared_persistence) {
    Claim claim = read_claim_from(written(subject, 0), "claim");
    if (Pockets(subject.complex.merge_trees(), squared_persistence).size() == claim.pockets->pockets.size()) return;
    claim.pockets->squared_persistence = squared_persistence;
    const CheckReport report = check(subject.points, claim, *subject.truth);
    require(subject, fails_on_level_5(report), "at another persistence", report);
    ++made;
  });
  if (scale_of_run() >= 1) {
    EXPECT_GE(made, 10U);
  }
}

}  // namespace
}  // namespace flowcert::property::pocket_claims_test
