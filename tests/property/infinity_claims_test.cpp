// Claims of what flows to infinity, on every family of inputs: right ones, and right ones with one thing made wrong.
//
// Guarantees: what compute writes of it reads back equal, and conforms exactly. Vectors of other lengths, decimals and
// corners in another order conform, too. Each mutant fails on level 5, in its line. The test fails too when some kind
// of mutant was hardly ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/write_stationary_points.h"
#include "fuzz/inputs/input.h"
#include "fuzz/inputs/stable_configurations.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::infinity_claims_test {
namespace {

constexpr int kInputsPerFamily = 3;

Claim claim_of(const ClaimSubject& subject) {
  Claim claim;
  claim.format = "exchange";
  claim.indices = ClaimedIndices{};
  claim.infinity = infinity_of(subject.truth->stable_set(std::nullopt));
  claim.infinity->line = kFirstLine;
  return claim;
}

// ---- What is written reads back.

std::string words_of(const ClaimedPosition& x) {
  std::string words;
  for (const ClaimedNumber& number : x) words += number.value.str() + (number.is_exact ? " " : "~ ");
  return words;
}
std::string words_of(const std::vector<PointId>& ids) {
  std::string words;
  for (const PointId id : ids) words += std::to_string(id) + ' ';
  return words;
}
std::string words_of(const std::array<PointId, 2>& ids) { return words_of(std::vector(ids.begin(), ids.end())); }
std::string words_of(const std::optional<std::vector<PointId>>& ids) { return ids ? words_of(*ids) : "no ids"; }
std::string words_of(const std::optional<bool>& flag) { return !flag ? "none" : *flag ? "true" : "false"; }

std::string words_of(const Corner<ClaimedPosition>& corner) {
  return (corner.at_infinity ? ", along " : ", ") + words_of(corner.position);
}

// All that is claimed of infinity, piece by piece.
std::vector<std::string> words_of(const ClaimedInfinity& infinity) {
  std::vector<std::string> all;
  for (const auto* part : {&infinity.bounded, &infinity.unbounded}) {
    const std::string which = part == &infinity.bounded ? "" : "unbounded ";
    for (const auto& s : part->segments) {
      all.push_back(which + "segment " + words_of(s.samples) + words_of(s.front) + words_of(s.back) +
                    words_of(s.front_contact) + words_of(s.back_contact) +
                    (s.back_kind ? back_kind_text(*s.back_kind) : ""));
    }
    for (const auto& i : part->intervals) {
      all.push_back(which + "interval " + words_of(i.polygon) + words_of(i.front) + words_of(i.back) +
                    words_of(i.back_is_stationary));
    }
    for (const auto& s : part->sectors) {
      all.push_back(which + "sector " + words_of(s.samples));
      for (const auto& corner : s.corners) all.back() += words_of(corner);
    }
  }
  return all;
}

TEST(InfinityClaims, WhatIsWrittenReadsBackEqualAndConforms) {
  CITES("FC-STAB-08", "FC-OUT-01", "FC-CLAIM-16");
  std::size_t pieces = 0;
  on_all_families<ClaimSubject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    std::ostringstream out;
    write_stationary_points(out, subject.complex, {.u2 = true, .s2 = true, .skeletons = true, .all = true});
    const Claim read = read_claim_from(out.str(), "claim");
    const CheckReport report = check(subject.points, read, *subject.truth);
    const auto expected = words_of(*claim_of(subject).infinity);
    require(subject, read.infinity && words_of(*read.infinity) == expected, "read back", report);
    require(subject, read.infinity->line == read.points.size() + 2, "another line", report);
    require(subject, report.verdict == Verdict::kConforms && report.not_judged.empty(), "what is written", report);
    const CheckReport alone = check(subject.points, claim_of(subject), *subject.truth);
    require(subject, alone.verdict == Verdict::kConforms && alone.is_exact && alone.conforms[4], "alone", alone);
    pieces += expected.size();
  });
  std::printf("%zu pieces\n", pieces);
  if (scale_of_run() >= 1) {
    EXPECT_GT(pieces, 3300U);
  }
}

// ---- Claims that vary where they may.

// Calls use(corner) for all corners.
template <typename Use>
void for_all_corners(ClaimedInfinity& infinity, const Use& use) {
  for (auto* part : {&infinity.bounded, &infinity.unbounded}) {
    for (auto& s : part->segments) use(s.front), use(s.back);
    for (auto& i : part->intervals) use(i.front), use(i.back);
    for (auto& s : part->sectors) std::ranges::for_each(s.corners, use);
  }
}

Claim in_another_order(Claim claim) {
  ClaimedInfinity& infinity = *claim.infinity;
  for_all_corners(infinity, [](Corner<ClaimedPosition>& corner) {
    if (!corner.at_infinity) return;
    for (ClaimedNumber& coordinate : corner.position) coordinate.value *= 7;
  });
  const auto turn = [](auto& corners) {
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(below(corners.size())), corners.end());
    if (below(2) == 0) std::reverse(corners.begin(), corners.end());
  };
  for (auto& sector : infinity.bounded.sectors) turn(sector.corners);
  for (auto& sector : infinity.unbounded.sectors) turn(sector.corners);
  std::ranges::reverse(infinity.unbounded.segments);
  std::ranges::reverse(infinity.bounded.segments);
  return claim;
}

Claim in_decimals(Claim claim) {
  for_all_corners(*claim.infinity, [](Corner<ClaimedPosition>& corner) {
    for (ClaimedNumber& number : corner.position) {
      if (const auto nearest = nearest_double(number.value)) number = {Rational(*nearest), false};
    }
  });
  return claim;
}

TEST(InfinityClaims, RightClaimsConform) {
  CITES("FC-CLAIM-16");
  on_all_families<ClaimSubject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    const Claim claim = claim_of(subject);
    const CheckReport turned = check(subject.points, in_another_order(claim), *subject.truth);
    require(subject, turned.verdict == Verdict::kConforms && turned.is_exact, "in another order", turned);
    const CheckReport decimals = check(subject.points, in_decimals(claim), *subject.truth, {.tolerance = 0});
    require(subject, decimals.verdict == Verdict::kConforms, "the nearest doubles", decimals);
    require(subject, decimals.is_exact == words_of(*claim.infinity).empty(), "decimals that are graded exact",
            decimals);
  });
}

// ---- Mutants.

// Changes the claim, or returns false where there is nothing to change.
using Mutation = std::function<bool(ClaimedInfinity&)>;

template <typename Piece>
bool left_out(std::vector<Piece>& pieces) {
  if (pieces.empty()) return false;
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(below(pieces.size())));
  return true;
}
template <typename Piece>
bool twice(std::vector<Piece>& pieces) {
  if (pieces.empty()) return false;
  const Piece again = pieces[below(pieces.size())];
  pieces.push_back(again);
  return true;
}

bool moved_position(ClaimedInfinity& infinity) {
  std::vector<ClaimedPosition*> all;
  for_all_corners(infinity, [&](Corner<ClaimedPosition>& corner) {
    if (!corner.at_infinity) all.push_back(&corner.position);
  });
  if (all.empty()) return false;
  Rational& x = all[below(all.size())]->at(below(3)).value;
  x += x == 0 ? Rational(1) : Rational(x / 1000000);
  return true;
}

bool turned_vector(ClaimedInfinity& infinity) {
  std::vector<ClaimedPosition*> all;
  for_all_corners(infinity, [&](Corner<ClaimedPosition>& corner) {
    if (corner.at_infinity) all.push_back(&corner.position);
  });
  if (all.empty()) return false;
  ClaimedPosition& vector = *all[below(all.size())];
  const std::size_t axis = below(3);
  // One coordinate alone is moved, so that another one must not be zero.
  if (vector.at((axis + 1) % 3).value == 0 && vector.at((axis + 2) % 3).value == 0) return false;
  vector.at(axis).value += 1;
  return true;
}

const std::map<std::string, Mutation>& mutations() {
  static const std::map<std::string, Mutation> all = {
      {"a segment left out", [](ClaimedInfinity& x) { return left_out(x.bounded.segments); }},
      {"an interval left out", [](ClaimedInfinity& x) { return left_out(x.bounded.intervals); }},
      {"a sector left out", [](ClaimedInfinity& x) { return left_out(x.bounded.sectors); }},
      {"an unbounded segment left out", [](ClaimedInfinity& x) { return left_out(x.unbounded.segments); }},
      {"an unbounded interval left out", [](ClaimedInfinity& x) { return left_out(x.unbounded.intervals); }},
      {"an unbounded sector left out", [](ClaimedInfinity& x) { return left_out(x.unbounded.sectors); }},
      {"an unbounded segment twice", [](ClaimedInfinity& x) { return twice(x.unbounded.segments); }},
      {"an unbounded interval twice", [](ClaimedInfinity& x) { return twice(x.unbounded.intervals); }},
      {"an unbounded sector twice", [](ClaimedInfinity& x) { return twice(x.unbounded.sectors); }},
      {"a position moved", moved_position},
      {"a vector turned", turned_vector},
      {"another kind of back",
       [](ClaimedInfinity& x) {
         if (x.unbounded.segments.empty()) return false;
         auto& kind = x.unbounded.segments[below(x.unbounded.segments.size())].back_kind;
         kind = kind == BackKind::kEdge ? BackKind::kCritical : BackKind::kEdge;
         return true;
       }},
      {"another contact set at the back",
       [](ClaimedInfinity& x) {
         if (x.unbounded.segments.empty()) return false;
         x.unbounded.segments[below(x.unbounded.segments.size())].back_contact->pop_back();
         return true;
       }},
      {"an interval from elsewhere",
       [](ClaimedInfinity& x) {
         if (x.unbounded.intervals.empty()) return false;
         auto& flag = x.unbounded.intervals[below(x.unbounded.intervals.size())].back_is_stationary;
         flag = !*flag;
         return true;
       }},
      {"a vector for a position", [](ClaimedInfinity& x) {
         if (x.unbounded.sectors.empty()) return false;
         bool& at_infinity = x.unbounded.sectors[below(x.unbounded.sectors.size())].corners.front().at_infinity;
         at_infinity = !at_infinity;
         return true;
       }}};
  return all;
}

TEST(InfinityClaims, MutantsFail) {
  CITES("FC-CLAIM-16");
  std::map<std::string, std::size_t> made;
  on_all_families<ClaimSubject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const ClaimSubject& subject) {
    for (const auto& [name, mutation] : mutations()) {
      Claim claim = claim_of(subject);
      if (!mutation(*claim.infinity)) continue;
      const CheckReport report = check(subject.points, claim, *subject.truth);
      const bool is_found = report.verdict == Verdict::kFails && report.findings.size() == 1 &&
                            report.findings[0].level == 5 && report.findings[0].line == kFirstLine;
      require(subject, is_found, name, report);
      ++made[name];
    }
  });
  for (const auto& [name, mutation] : mutations()) {
    std::printf("%6zu  %s\n", made[name], name.c_str());
    if (scale_of_run() >= 1) {
      EXPECT_GE(made[name], 30U) << name;
    }
  }
}

}  // namespace
}  // namespace flowcert::property::infinity_claims_test
