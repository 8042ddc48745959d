// Claims of persistence pairs, right and with one thing made wrong, on every family of inputs.
//
// Guarantees: the pairs as they are conform, and so do their decimals of 17 and of 12 digits. Each mutant is found. The
// test fails too when some kind of mutant was hardly ever made.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "certify/pair_differences.h"
#include "fuzz/inputs/input.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::pair_claims_test {
namespace {

constexpr int kInputsPerFamily = 20;
constexpr double kTolerance = 1e-9;

// A value that no double has stays exact.
ClaimedNumber with_digits(const Rational& value, int digits) {
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest) return {value, true};
  // std::stod refuses the smallest doubles.
  return {Rational(std::strtod(fmt::format("{:.{}g}", *nearest, digits).c_str(), nullptr)), false};
}

std::vector<ClaimedPair> claimed(const std::vector<ListedPair>& truth, int digits) {
  std::vector<ClaimedPair> pairs;
  for (const ListedPair& pair : truth) {
    pairs.push_back({pair.dimension, with_digits(pair.birth, digits), std::nullopt});
    if (pair.death) pairs.back().death = with_digits(*pair.death, digits);
  }
  return pairs;
}

// Long enough that a change by a millionth is far from everything that is permitted.
bool is_long(const ClaimedPair& pair) {
  return !pair.death || pair.death->value > pair.birth.value + pair.death->value / 1000;
}

// Whether a change by a millionth is larger than the steps between doubles, which the smallest ones are not.
bool has_near_doubles(const Rational& value) {
  return value > Rational(4000000) * Rational(std::numeric_limits<double>::denorm_min());
}

// Nothing where the mutant might be right.
std::optional<std::vector<ClaimedPair>> mutant(const std::string& kind, std::vector<ClaimedPair> pairs) {
  if (pairs.empty()) return std::nullopt;
  std::size_t at = below(pairs.size());
  for (std::size_t k = 0; k < pairs.size() && kind == "other birth" && pairs[at].birth.value == 0; ++k) {
    at = (at + 1) % pairs.size();
  }
  ClaimedPair& pair = pairs[at];
  if (!is_long(pair)) return std::nullopt;
  const Rational more = 1 + Rational(1) / 1000000;
  if (kind == "dropped") {
    pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(at));
  } else if (kind == "twice") {
    pairs.push_back(ClaimedPair(pair));
  } else if (kind == "other dimension") {
    pair.dimension = (pair.dimension + 1) % kPairDimensions;
  } else if (kind == "other death") {
    if (!pair.death || !has_near_doubles(pair.death->value)) return std::nullopt;
    pair.death->value *= more;
  } else if (kind == "other birth") {
    if (!has_near_doubles(pair.birth.value)) return std::nullopt;
    pair.birth.value *= more;
  } else {
    pair.death = pair.death ? std::nullopt : std::optional(ClaimedNumber{Rational(1) / 3, false});
  }
  return pairs;
}

// A change by a millionth can hit another pair of an input, such as one that is moved by some last bits.
bool has_near_pairs(const std::vector<ListedPair>& truth) {
  const auto near = [](const Rational& a, const Rational& b) { return a != b && abs(a - b) * 100000 < a + b; };
  for (const ListedPair& a : truth) {
    for (const ListedPair& b : truth) {
      if (near(a.birth, b.birth) || (a.death && b.death && near(*a.death, *b.death))) return true;
    }
  }
  return false;
}

TEST(PairClaims, AreJudged) {
  CITES("FC-CLAIM-11", "FC-PERS-01");
  const std::vector<std::string> kinds = {"dropped",     "twice",       "other dimension",
                                          "other death", "other birth", "other end"};
  std::map<std::string, std::size_t> made;
  on_all_families<ClaimSubject>(fuzz::families(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    const std::vector<ListedPair> truth = listed_pairs(subject.complex);
    std::ostringstream text;
    text << subject.input;
    for (const int digits : {17, 12}) {
      const auto differences = pair_differences(claimed(truth, digits), truth, kTolerance);
      if (!differences.empty()) RC_FAIL(text.str() + differences[0].claimed + "; " + differences[0].truth);
    }
    if (has_near_pairs(truth)) return;
    for (const std::string& kind : kinds) {
      const auto changed = mutant(kind, claimed(truth, 17));
      if (!changed) continue;
      ++made[kind];
      if (pair_differences(*changed, truth, kTolerance).empty()) RC_FAIL(kind + " is not found\n" + text.str());
    }
  });
  if (scale_of_run() < 1) return;
  for (const std::string& kind : kinds) EXPECT_GT(made[kind], 50U) << kind;
}

}  // namespace
}  // namespace flowcert::property::pair_claims_test
