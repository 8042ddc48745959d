// Claims of unstable sets of dimension 2, on every family of inputs: right ones, and right ones with one thing made
// wrong.
//
// Guarantees: what compute writes reads back equal, and conforms exactly. Parts in any order, and decimals, conform,
// too, whatever the tolerance. Each mutant fails on level 5, in its line. The test fails too when some kind of mutant
// was hardly ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/write_stationary_points.h"
#include "fuzz/inputs/input.h"
#include "fuzz/inputs/stable_configurations.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::unstable_claims_test {
namespace {

constexpr int kInputsPerFamily = 8;
constexpr int kTrials = 8;  // so many sets are looked at for one that a mutation can change

struct Subject : ClaimSubject {
  using ClaimSubject::ClaimSubject;

  // All unstable sets. Point k is record k.
  [[nodiscard]] Claim claim() const {
    Claim claim;
    claim.format = "exchange";
    for (std::size_t i = 0; i < truth->size(); ++i) {
      const StationaryIndex index = truth->index(i);
      ClaimedPoint point;
      point.line = kFirstLine + i;
      point.index = index.face_dimension;
      if (!index.is_critical()) point.hull_dimension = index.hull_dimension;
      point.contact = contact(i);
      claim.points.push_back(std::move(point));
    }
    add_unstable_sets(claim, *truth);
    return claim;
  }
};

using Surface = UnstableSurface<ClaimedPosition>;

// ---- What is written reads back.

bool are_equal(const ClaimedPosition& a, const ClaimedPosition& b) {
  return values_of(a) == values_of(b) && is_exact(a) == is_exact(b);
}
bool are_equal(const Corner<ClaimedPosition>& a, const Corner<ClaimedPosition>& b) {
  return a.at_infinity == b.at_infinity && are_equal(a.position, b.position);
}
template <typename Part>
bool are_equal(const std::vector<Part>& a, const std::vector<Part>& b);
bool are_equal(const EdgePart<ClaimedPosition>& a, const EdgePart<ClaimedPosition>& b) {
  return a.polygon == b.polygon && are_equal(a.front, b.front) && are_equal(a.back, b.back);
}
bool are_equal(const Region<ClaimedPosition>& a, const Region<ClaimedPosition>& b) {
  return a.samples == b.samples && are_equal(a.corners, b.corners);
}
bool are_equal(const Crossing<ClaimedPosition>& a, const Crossing<ClaimedPosition>& b) {
  return a.samples == b.samples && are_equal(a.front, b.front) && are_equal(a.back, b.back);
}
template <typename Part>
bool are_equal(const std::vector<Part>& a, const std::vector<Part>& b) {
  return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return are_equal(x, y); });
}
bool are_equal(const Surface& a, const Surface& b) {
  return are_equal(a.vertices, b.vertices) && are_equal(a.traces, b.traces) && are_equal(a.runs, b.runs) &&
         are_equal(a.sheets, b.sheets) && are_equal(a.segments, b.segments);
}

// The first difference, in words; empty if there is none.
std::string difference(const Claim& a, const Claim& b) {
  if (a.points.size() != b.points.size()) return "the number of points";
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    const auto &x = a.points[k].u1, &y = b.points[k].u1;
    if (a.points[k].contact != b.points[k].contact) return "contact of point " + std::to_string(k);
    if (x.has_value() != y.has_value() || (x && !are_equal(*x, *y))) return "u1 of point " + std::to_string(k);
  }
  return "";
}

TEST(UnstableClaims, WhatIsWrittenReadsBackEqualAndConforms) {
  CITES("FC-UNST-04", "FC-OUT-01", "FC-NUM-02");
  std::size_t sets = 0, parts = 0;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    std::ostringstream out;
    write_stationary_points(out, subject.complex, {.sheets = true});
    const Claim read = read_claim_from(out.str(), "claim");
    const CheckReport report = check(subject.points, read, *subject.truth);
    const std::string found = difference(read, subject.claim());
    require(subject, found.empty(), "read back: " + found, report);
    require(subject, report.verdict == Verdict::kConforms && report.is_exact && report.not_judged.empty(),
            "what is written", report);
    for (const ClaimedPoint& point : read.points) {
      if (!point.u1) continue;
      ++sets;
      parts += point.u1->traces.size() + point.u1->sheets.size();
    }
  });
  std::printf("%zu sets, %zu traces and sheets\n", sets, parts);
  if (scale_of_run() >= 1) {
    EXPECT_GT(sets, 1000U);
    EXPECT_GT(parts, 3300U);
  }
}

// ---- Claims that vary where they may.

// The order in which parts, ends and corners are told.
template <typename Parts>
void turn(Parts& parts) {
  if (parts.empty()) return;
  std::rotate(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(below(parts.size())), parts.end());
  if (*rc::gen::arbitrary<bool>()) std::ranges::reverse(parts);
}

// Calls change(corner) for all corners and ends of a set.
template <typename Change>
void for_each_corner(Surface& set, const Change& change) {
  for (auto* intervals : {&set.traces, &set.runs}) {
    for (EdgePart<ClaimedPosition>& interval : *intervals) change(interval.front), change(interval.back);
  }
  for (Region<ClaimedPosition>& sheet : set.sheets) std::ranges::for_each(sheet.corners, change);
  for (Crossing<ClaimedPosition>& segment : set.segments) change(segment.front);
}

Claim in_other_order(Claim claim) {
  for (ClaimedPoint& point : claim.points) {
    if (!point.u1) continue;
    turn(point.u1->vertices);
    for (auto* intervals : {&point.u1->traces, &point.u1->runs}) {
      turn(*intervals);
      for (EdgePart<ClaimedPosition>& interval : *intervals) {
        if (*rc::gen::arbitrary<bool>()) std::swap(interval.front, interval.back);
        std::ranges::reverse(interval.polygon);
      }
    }
    turn(point.u1->sheets);
    for (Region<ClaimedPosition>& sheet : point.u1->sheets) turn(sheet.corners), turn(sheet.samples);
    turn(point.u1->segments);
    for_each_corner(*point.u1, [](Corner<ClaimedPosition>& corner) {
      for (ClaimedNumber& x : corner.position) x.value *= corner.at_infinity ? 3 : 1;
    });
  }
  return claim;
}

void round(ClaimedPosition& position) {
  for (ClaimedNumber& x : position) {
    if (const std::optional<double> nearest = nearest_double(x.value)) x = {Rational(*nearest), false};
  }
}

Claim in_decimals(Claim claim) {
  for (ClaimedPoint& point : claim.points) {
    if (!point.u1) continue;
    std::ranges::for_each(point.u1->vertices, round);
    for (Crossing<ClaimedPosition>& segment : point.u1->segments) round(segment.back.position);
    for_each_corner(*point.u1, [](Corner<ClaimedPosition>& corner) { round(corner.position); });
  }
  return claim;
}

TEST(UnstableClaims, RightClaimsConform) {
  CITES("FC-CLAIM-17", "FC-CLAIM-05");
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = subject.claim();
    const CheckReport turned = check(subject.points, in_other_order(claim), *subject.truth);
    require(subject, turned.verdict == Verdict::kConforms && turned.is_exact, "parts in another order", turned);
    // With a large tolerance many true parts are near one that is claimed.
    for (const double tolerance : {0.0, 0.25}) {
      const CheckReport decimals =
          check(subject.points, in_other_order(in_decimals(claim)), *subject.truth, {.tolerance = tolerance});
      require(subject, decimals.verdict == Verdict::kConforms, "the nearest doubles", decimals);
    }
  });
}

// ---- Mutants.

struct Mutant {
  Claim claim;
  std::size_t line;
};
// Changes the set, or returns false.
using Change = std::function<bool(Surface&)>;

bool has_set(const ClaimedPoint& point) { return point.u1.has_value(); }

Claim without_sets(Claim claim) {
  for (ClaimedPoint& point : claim.points) point.u1.reset();
  return claim;
}

// Of the mutant's sets, there is only the one that is changed. `bare` is the claim without sets.
std::optional<Mutant> changed(const Claim& claim, const Claim& bare, const Change& change) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto k = some_point(claim, has_set);
    if (!k) return std::nullopt;
    Mutant mutant{bare, kFirstLine + *k};
    mutant.claim.points[*k].u1 = claim.points[*k].u1;
    if (change(*mutant.claim.points[*k].u1)) return mutant;
  }
  return std::nullopt;
}

template <typename Part>
Part& some_of(std::vector<Part>& parts) {
  return parts[below(parts.size())];
}

bool move(ClaimedPosition& position) {
  Rational& x = position.at(below(3)).value;
  const std::optional<double> nearest = nearest_double(x);
  if (!nearest) return false;
  x = Rational(*nearest) == x ? Rational(fuzz::nudged(*nearest, 1)) : Rational(*nearest);
  return true;
}

bool move(Corner<ClaimedPosition>& corner) {
  if (!corner.at_infinity) return move(corner.position);
  for (ClaimedNumber& x : corner.position) x.value = -x.value;
  return true;
}

// These are for the parts of one sort.
template <auto kParts>
bool fewer(Surface& set) {
  auto& parts = set.*kParts;
  if (parts.empty()) return false;
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(below(parts.size())));
  return true;
}
template <auto kParts>
bool one_twice(Surface& set) {
  auto& parts = set.*kParts;
  if (parts.empty()) return false;
  parts.push_back(some_of(parts));
  return true;
}
template <auto kIntervals>
bool moved_end(Surface& set) {
  auto& intervals = set.*kIntervals;
  if (intervals.empty()) return false;
  EdgePart<ClaimedPosition>& one = some_of(intervals);
  return move(*rc::gen::arbitrary<bool>() ? one.front : one.back);
}
template <auto kFrom, auto kTo>
bool of_another_sort(Surface& set) {
  if ((set.*kFrom).empty()) return false;
  (set.*kTo).push_back(some_of(set.*kFrom));
  return fewer<kFrom>(set);
}

bool moved_vertex(Surface& set) { return !set.vertices.empty() && move(some_of(set.vertices)); }

bool swapped_polygons(Surface& set) {
  if (set.traces.empty()) return false;
  EdgePart<ClaimedPosition>&a = some_of(set.traces), &b = some_of(set.traces);
  if (a.polygon == b.polygon || (are_equal(a.front, b.front) && are_equal(a.back, b.back))) return false;
  std::swap(a.polygon, b.polygon);
  return true;
}

bool moved_corner(Surface& set) {
  Region<ClaimedPosition>& sheet = some_of(set.sheets);
  return !sheet.corners.empty() && move(some_of(sheet.corners));
}
bool fewer_corners(Surface& set) {
  Region<ClaimedPosition>& sheet = some_of(set.sheets);
  if (sheet.corners.empty()) return false;
  sheet.corners.pop_back();
  return true;
}
// Of three corners each order is the same ring.
bool swapped_corners(Surface& set) {
  Region<ClaimedPosition>& sheet = some_of(set.sheets);
  if (sheet.corners.size() < 4) return false;
  const std::size_t at = below(sheet.corners.size() - 1);
  std::swap(sheet.corners[at], sheet.corners[at + 1]);
  return true;
}
bool swapped_samples(Surface& set) {
  Region<ClaimedPosition>&a = some_of(set.sheets), &b = some_of(set.sheets);
  if (a.samples == b.samples || are_equal(a.corners, b.corners)) return false;
  std::swap(a.samples, b.samples);
  return true;
}

bool moved_start(Surface& set) { return !set.segments.empty() && move(some_of(set.segments).back.position); }
bool moved_end_of_segment(Surface& set) { return !set.segments.empty() && move(some_of(set.segments).front); }

// A position with the coordinates of a vector, or the other way around.
bool not_at_infinity(Surface& set) {
  bool is_done = false;
  for_each_corner(set, [&](Corner<ClaimedPosition>& corner) {
    if (is_done || !corner.at_infinity) return;
    corner.at_infinity = false;
    is_done = true;
  });
  return is_done;
}
bool at_infinity(Surface& set) {
  bool is_done = false;
  for_each_corner(set, [&](Corner<ClaimedPosition>& corner) {
    if (is_done || corner.at_infinity || values_of(corner.position) == RationalPoint{}) return;
    corner.at_infinity = is_done = true;
  });
  return is_done;
}

const std::map<std::string, Change>& changes() {
  static const std::map<std::string, Change> all = {
      {"fewer vertices", fewer<&Surface::vertices>},
      {"fewer traces", fewer<&Surface::traces>},
      {"fewer runs", fewer<&Surface::runs>},
      {"fewer sheets", fewer<&Surface::sheets>},
      {"fewer segments", fewer<&Surface::segments>},
      {"vertex twice", one_twice<&Surface::vertices>},
      {"trace twice", one_twice<&Surface::traces>},
      {"run twice", one_twice<&Surface::runs>},
      {"sheet twice", one_twice<&Surface::sheets>},
      {"segment twice", one_twice<&Surface::segments>},
      {"moved vertex", moved_vertex},
      {"moved end of a trace", moved_end<&Surface::traces>},
      {"moved end of a run", moved_end<&Surface::runs>},
      {"trace as a run", of_another_sort<&Surface::traces, &Surface::runs>},
      {"run as a trace", of_another_sort<&Surface::runs, &Surface::traces>},
      {"swapped polygons", swapped_polygons},
      {"moved corner", moved_corner},
      {"fewer corners", fewer_corners},
      {"swapped corners", swapped_corners},
      {"swapped samples", swapped_samples},
      {"moved start", moved_start},
      {"moved end of a segment", moved_end_of_segment},
      {"not at infinity", not_at_infinity},
      {"at infinity", at_infinity}};
  return all;
}

// The set of another point.
std::optional<Mutant> of_another_point(const Claim& claim, const Claim& bare) {
  const auto a = some_point(claim, has_set), b = some_point(claim, has_set);
  if (!a || *a == *b) return std::nullopt;
  Mutant mutant{bare, kFirstLine + *a};
  mutant.claim.points[*a].u1 = claim.points[*b].u1;
  return mutant;
}

void require_found(const Subject& subject, const Mutant& mutant, const std::string& name) {
  const CheckReport report = check(subject.points, mutant.claim, *subject.truth, {.tolerance = 0});
  const bool found = std::ranges::any_of(report.findings, [&](const Finding& finding) {
    return !finding.is_variation && finding.level == 5 && finding.line == mutant.line && finding.clause == "FC-UNST-04";
  });
  require(subject, report.verdict == Verdict::kFails && found,
          name + ": not found in line " + std::to_string(mutant.line), report);
}

TEST(UnstableClaims, MutantsFailWhereTheyAreWrong) {
  CITES("FC-CLAIM-17", "FC-UNST-04");
  const std::string other_set = "set of another point";
  std::map<std::string, std::size_t> made;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = subject.claim(), bare = without_sets(claim);
    for (const auto& [name, change] : changes()) {
      const std::optional<Mutant> mutant = changed(claim, bare, change);
      if (!mutant) continue;
      ++made[name];
      require_found(subject, *mutant, name);
    }
    if (const std::optional<Mutant> mutant = of_another_point(claim, bare)) {
      ++made[other_set];
      require_found(subject, *mutant, other_set);
    }
  });
  std::vector<std::string> names = {other_set};
  for (const auto& [name, change] : changes()) names.push_back(name);
  for (const std::string& name : names) {
    std::printf("%-24s %6zu mutants\n", name.c_str(), made[name]);
    // A run at a small scale makes a handful of each, or none of a rare one.
    if (scale_of_run() >= 1) {
      EXPECT_GE(made[name], 16U) << name;
    }
  }
}

}  // namespace
}  // namespace flowcert::property::unstable_claims_test
