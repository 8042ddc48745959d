// Claims of λ-lists, connections and volumes, on every family of inputs: right ones, and right ones with one thing made
// wrong.
//
// Guarantees: what compute writes of the whole complex reads back equal, and conforms exactly. Lists that begin
// elsewhere, vectors of other lengths and decimals conform, too. Each mutant fails on level 5, in its line. Whether
// infinity is above an index-1 point is what the oracle says. The test fails too when some kind of mutant was hardly
// ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/write_stationary_points.h"
#include "fuzz/inputs/input.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/subject.h"
#include "oracle/unstable_set.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"

namespace flowcert::property::direction_claims_test {
namespace {

constexpr int kInputsPerFamily = 10;

struct Subject : ClaimSubject {
  using ClaimSubject::ClaimSubject;

  // All of the claim that this test is about. Point k is record k.
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
    add_directions_and_volumes(claim, *truth);
    return claim;
  }
};

// ---- What is written reads back.

bool are_equal(const ClaimedTarget& a, const ClaimedTarget& b) {
  return a.is_infinity == b.is_infinity && a.contact == b.contact;
}
bool are_equal(const ClaimedNumber& a, const ClaimedNumber& b) {
  return a.is_exact == b.is_exact &&
         (a.is_exact ? a.value == b.value : nearest_double(a.value) == nearest_double(b.value));
}
template <typename Part, std::size_t N>
bool are_equal(const std::array<Part, N>& a, const std::array<Part, N>& b);
template <typename Part>
bool are_equal(const std::vector<Part>& a, const std::vector<Part>& b);
bool are_equal(const ClaimedDirection& a, const ClaimedDirection& b);
bool are_equal(const ClaimedLambdaList& a, const ClaimedLambdaList& b);
bool are_equal(const ClaimedConnection& a, const ClaimedConnection& b) {
  return are_equal(a.to, b.to) && a.orbits == b.orbits && a.families == b.families;
}
bool are_equal(const ClaimedShare& a, const ClaimedShare& b);
template <typename Part>
bool are_equal(const Boxed<Part>& a, const Boxed<Part>& b) {
  return a.has_value() == b.has_value() && (!a || are_equal(*a, *b));
}
template <typename Part>
bool are_equal(const std::optional<Part>& a, const std::optional<Part>& b) {
  return a.has_value() == b.has_value() && (!a || are_equal(*a, *b));
}
template <typename Part>
bool are_equal(const std::vector<Part>& a, const std::vector<Part>& b) {
  return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return are_equal(x, y); });
}
template <typename Part, std::size_t N>
bool are_equal(const std::array<Part, N>& a, const std::array<Part, N>& b) {
  return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return are_equal(x, y); });
}
bool are_equal(const ClaimedShare& a, const ClaimedShare& b) {
  return a.sample == b.sample && are_equal(a.volume, b.volume);
}
bool are_equal(const ClaimedDirection& a, const ClaimedDirection& b) {
  return are_equal(a.limit, b.limit) && a.is_vector == b.is_vector && are_equal(a.exit, b.exit) &&
         are_equal(a.rounded_exit, b.rounded_exit);
}
bool are_equal(const ClaimedLambdaList& a, const ClaimedLambdaList& b) {
  return are_equal(a.directions, b.directions) && are_equal(a.arcs, b.arcs);
}

// The first difference, in words; empty if there is none.
std::string difference(const Claim& a, const Claim& b) {
  if (a.morse_smale != b.morse_smale) return "morse_smale";
  if (!are_equal(a.hull_volume, b.hull_volume)) return "hull_volume";
  if (a.points.size() != b.points.size()) return "the number of points";
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    const ClaimedPoint &x = a.points[k], &y = b.points[k];
    const std::string where = " of point " + std::to_string(k);
    if (x.contact != y.contact) return "contact" + where;
    if (!are_equal(x.lambda, y.lambda)) return "lambda" + where;
    if (!are_equal(x.connections, y.connections)) return "connections" + where;
    if (!are_equal(x.volume, y.volume)) return "volume" + where;
    if (x.has_rounded_volume != y.has_rounded_volume) return "whether there is a volume_double" + where;
    if (!are_equal(x.rounded_volume, y.rounded_volume)) return "volume_double" + where;
    if (!are_equal(x.shares, y.shares)) return "shares" + where;
  }
  return "";
}

std::string written(const Subject& subject, const RecordsToWrite& wanted) {
  std::ostringstream out;
  write_stationary_points(out, subject.complex, wanted);
  return out.str();
}

TEST(DirectionClaims, WhatIsWrittenReadsBackEqualAndConforms) {
  CITES("FC-UNST-02", "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02", "FC-OUT-01", "FC-NUM-02");
  std::size_t lists = 0, vectors = 0, shares = 0;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim truth = subject.claim();
    const Claim read = read_claim_from(
        written(subject, {.u2 = true, .s2 = true, .all = true, .volumes = WrittenVolumes::kExact}), "claim");
    const CheckReport report = check(subject.points, read, *subject.truth);
    require(subject, difference(read, truth).empty(), "read back: " + difference(read, truth), report);
    require(subject, report.verdict == Verdict::kConforms && report.is_exact && report.not_judged.empty(),
            "what is written", report);
    for (const ClaimedPoint& point : read.points) {
      shares += point.shares ? point.shares->size() : 0;
      if (!point.lambda) continue;
      ++lists;
      vectors +=
          static_cast<std::size_t>(std::ranges::count(point.lambda->directions, true, &ClaimedDirection::is_vector));
    }
    for (const auto centers : {WrittenCenters::kDouble, WrittenCenters::kNone}) {
      const std::string text = written(
          subject, {.u2 = true, .s2 = true, .centers = centers, .all = true, .volumes = WrittenVolumes::kShares});
      const CheckReport doubles = check(subject.points, read_claim_from(text, "claim"), *subject.truth);
      require(subject, doubles.verdict == Verdict::kConforms, "what is written in doubles", doubles);
    }
  });
  std::printf("%zu lists, %zu vectors, %zu shares\n", lists, vectors, shares);
  if (scale_of_run() >= 1) {
    EXPECT_GT(lists, 1650U);
    EXPECT_GT(vectors, 150U);
    EXPECT_GT(shares, 300U);
  }
}

// ---- Claims that vary where they may.

bool is_cycle(const ClaimedPoint& point) { return point.index == 1 && !point.hull_dimension; }

Claim begun_elsewhere(Claim claim) {
  for (ClaimedPoint& point : claim.points) {
    if (!point.lambda) continue;
    auto& [directions, arcs] = *point.lambda;
    for (ClaimedDirection& one : directions) {
      one.rounded_exit.reset();
      if (!one.is_vector) continue;
      for (ClaimedNumber& coordinate : *one.exit) coordinate.value *= 3;
    }
    if (!is_cycle(point) || directions.empty()) continue;
    const auto turn = static_cast<std::ptrdiff_t>(below(directions.size()));
    std::rotate(directions.begin(), directions.begin() + turn, directions.end());
    std::rotate(arcs.begin(), arcs.begin() + turn, arcs.end());
  }
  return claim;
}

void round(ClaimedNumber& number) {
  if (const std::optional<double> nearest = nearest_double(number.value)) number = {Rational(*nearest), false};
}

Claim in_decimals(Claim claim) {
  round(*claim.hull_volume);
  for (ClaimedPoint& point : claim.points) {
    round(*point.volume);
    point.has_rounded_volume = false;
    if (point.shares) {
      for (ClaimedShare& share : *point.shares) round(*share.volume);
    }
    if (!point.lambda) continue;
    for (ClaimedDirection& one : point.lambda->directions) {
      for (ClaimedNumber& coordinate : *one.exit) round(coordinate);
      one.rounded_exit.reset();
    }
  }
  return claim;
}

TEST(DirectionClaims, RightClaimsConform) {
  CITES("FC-CLAIM-13", "FC-CLAIM-14", "FC-CLAIM-15");
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = subject.claim();
    const CheckReport turned = check(subject.points, begun_elsewhere(claim), *subject.truth);
    require(subject, turned.verdict == Verdict::kConforms && turned.is_exact, "lists that begin elsewhere", turned);
    const CheckReport decimals = check(subject.points, in_decimals(claim), *subject.truth, {.tolerance = 0});
    require(subject, decimals.verdict == Verdict::kConforms, "the nearest doubles", decimals);
  });
}

// ---- Mutants.

struct Mutant {
  Claim claim;
  std::optional<std::size_t> line;  // none: of the whole
};
using Mutation = std::function<std::optional<Mutant>(const Claim&)>;

bool has_arcs(const ClaimedPoint& point) { return point.lambda && !point.lambda->arcs.empty(); }
bool has_directions(const ClaimedPoint& point) { return point.lambda && !point.lambda->directions.empty(); }

// Calls change(point) for a random point that qualifies. The change returns false if it changes nothing.
template <typename Qualifies, typename Change>
Mutation changed_point(Qualifies qualifies, Change change) {
  return [qualifies, change](const Claim& claim) -> std::optional<Mutant> {
    const auto k = some_point(claim, qualifies);
    if (!k) return std::nullopt;
    Mutant mutant{claim, kFirstLine + *k};
    if (!change(claim, mutant.claim.points[*k])) return std::nullopt;
    return mutant;
  };
}

template <typename Part>
Part& some_of(std::vector<Part>& parts) {
  return parts[below(parts.size())];
}

// Another stationary point, or infinity.
bool rename(const Claim& claim, ClaimedTarget& target) {
  const std::size_t k = below(claim.points.size() + 1);
  const ClaimedTarget other =
      k < claim.points.size() ? ClaimedTarget{false, claim.points[k].contact} : ClaimedTarget{true, {}};
  if (are_equal(other, target)) return false;
  target = other;
  return true;
}

bool other_arc(const Claim& claim, ClaimedPoint& point) { return rename(claim, some_of(point.lambda->arcs)); }
bool other_direction(const Claim& claim, ClaimedPoint& point) {
  return rename(claim, some_of(point.lambda->directions).limit);
}

bool moved_direction(const Claim&, ClaimedPoint& point) {
  ClaimedDirection& one = some_of(point.lambda->directions);
  if (one.is_vector) {
    for (ClaimedNumber& coordinate : *one.exit) coordinate.value = -coordinate.value;
    return true;
  }
  Rational& x = one.exit->at(below(3)).value;
  const std::optional<double> nearest = nearest_double(x);
  if (!nearest) return false;
  x = Rational(*nearest) == x ? Rational(fuzz::nudged(*nearest, 1)) : Rational(*nearest);
  return true;
}

bool moved_double(const Claim&, ClaimedPoint& point) {
  ClaimedDirection& one = some_of(point.lambda->directions);
  if (one.is_vector) {
    for (auto& coordinate : *one.rounded_exit) coordinate->value = -coordinate->value;
    return true;
  }
  std::optional<ClaimedNumber>& x = one.rounded_exit->at(below(3));
  if (!x) return false;
  x->value += 1 + 2 * abs(x->value);
  return true;
}

bool swapped_exits(const Claim&, ClaimedPoint& point) {
  auto& directions = point.lambda->directions;
  if (directions.size() < (is_cycle(point) ? 3U : 2U)) return false;
  const std::size_t a = below(directions.size()), b = (a + 1) % directions.size();
  std::swap(directions[a].exit, directions[b].exit);
  std::swap(directions[a].rounded_exit, directions[b].rounded_exit);
  std::swap(directions[a].is_vector, directions[b].is_vector);
  return true;
}

bool shorter(const Claim&, ClaimedPoint& point) {
  auto& [directions, arcs] = *point.lambda;
  const std::size_t at = below(directions.size());
  directions.erase(directions.begin() + static_cast<std::ptrdiff_t>(at));
  if (at < arcs.size()) arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(at));
  return true;
}

bool reversed(const Claim&, ClaimedPoint& point) {
  auto& [directions, arcs] = *point.lambda;
  const std::size_t n = directions.size();
  if (n < 2 || (n == 2 && is_cycle(point) && are_equal(arcs[0], arcs[1]))) return false;
  std::ranges::reverse(directions);
  std::reverse(arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(std::min(n - 1, arcs.size())));
  return true;
}

Rational last_bit_more(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest || *nearest == 0) return value + Rational(std::numeric_limits<double>::min());
  return value + Rational(fuzz::nudged(*nearest, 1)) - Rational(*nearest);
}

bool larger_volume(const Claim&, ClaimedPoint& point) {
  point.volume->value = last_bit_more(point.volume->value);
  return true;
}
bool larger_double(const Claim&, ClaimedPoint& point) {
  if (!point.rounded_volume) return false;
  Rational& value = point.rounded_volume->value;
  value += value == 0 ? Rational(1) / 1000 : Rational(value / 100000000);
  return true;
}
bool swapped_shares(const Claim&, ClaimedPoint& point) {
  // Two shares of one volume are often the case, so the second one is looked for.
  ClaimedShare& a = some_of(*point.shares);
  const auto b = std::ranges::find_if(*point.shares,
                                      [&](const ClaimedShare& one) { return one.volume->value != a.volume->value; });
  if (b == point.shares->end()) return false;
  std::swap(a.volume, b->volume);
  return true;
}
bool fewer_shares(const Claim&, ClaimedPoint& point) {
  point.shares->erase(point.shares->begin() + static_cast<std::ptrdiff_t>(below(point.shares->size())));
  return true;
}
bool other_number(const Claim&, ClaimedPoint& point) {
  ClaimedConnection& one = some_of(*point.connections);
  ++(*rc::gen::arbitrary<bool>() ? one.orbits : one.families);
  return true;
}
bool fewer_connections(const Claim&, ClaimedPoint& point) {
  point.connections->erase(point.connections->begin() + static_cast<std::ptrdiff_t>(below(point.connections->size())));
  return true;
}
bool other_connection(const Claim& claim, ClaimedPoint& point) { return rename(claim, some_of(*point.connections).to); }
bool connection_twice(const Claim&, ClaimedPoint& point) {
  point.connections->push_back(some_of(*point.connections));
  return true;
}

std::optional<Mutant> other_flag(const Claim& claim) {
  Mutant mutant{claim, std::nullopt};
  mutant.claim.morse_smale = !*claim.morse_smale;
  return mutant;
}
std::optional<Mutant> other_hull(const Claim& claim) {
  Mutant mutant{claim, std::nullopt};
  mutant.claim.hull_volume->value = last_bit_more(claim.hull_volume->value);
  return mutant;
}

const std::map<std::string, Mutation>& mutations() {
  const auto has_volume = [](const ClaimedPoint& point) { return point.volume.has_value(); };
  const auto has_positive = [](const ClaimedPoint& point) { return point.shares.has_value(); };
  const auto has_connections = [](const ClaimedPoint& point) { return point.connections.has_value(); };
  static const std::map<std::string, Mutation> all = {
      {"other arc", changed_point(has_arcs, other_arc)},
      {"other direction", changed_point(has_directions, other_direction)},
      {"moved direction", changed_point(has_directions, moved_direction)},
      {"moved double", changed_point(has_directions, moved_double)},
      {"swapped exits", changed_point(has_directions, swapped_exits)},
      {"shorter list", changed_point(has_directions, shorter)},
      {"reversed list", changed_point(has_directions, reversed)},
      {"larger volume", changed_point(has_volume, larger_volume)},
      {"positive volume", changed_point(has_positive, larger_volume)},
      {"larger double", changed_point(has_volume, larger_double)},
      {"swapped shares", changed_point(has_positive, swapped_shares)},
      {"fewer shares", changed_point(has_positive, fewer_shares)},
      {"other number", changed_point(has_connections, other_number)},
      {"fewer connections", changed_point(has_connections, fewer_connections)},
      {"other connection", changed_point(has_connections, other_connection)},
      {"connection twice", changed_point(has_connections, connection_twice)},
      {"other flag", other_flag},
      {"other hull", other_hull}};
  return all;
}

TEST(DirectionClaims, MutantsFailWhereTheyAreWrong) {
  CITES("FC-CLAIM-13", "FC-CLAIM-14", "FC-CLAIM-15");
  std::map<std::string, std::size_t> made;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = subject.claim();
    for (const auto& [name, mutation] : mutations()) {
      const std::optional<Mutant> mutant = mutation(claim);
      if (!mutant) continue;
      ++made[name];
      const CheckReport report = check(subject.points, mutant->claim, *subject.truth, {.tolerance = 0});
      const bool found = std::ranges::all_of(report.findings, [&](const Finding& finding) {
        return !finding.is_variation && finding.level == 5 && finding.line == mutant->line;
      });
      require(subject, report.verdict == Verdict::kFails && found,
              name + ": not found alone in line " + std::to_string(mutant->line.value_or(0)), report);
    }
  });
  for (const auto& [name, mutation] : mutations()) {
    std::printf("%-20s %6zu mutants\n", name.c_str(), made[name]);
    // A run at a small scale makes a handful of each, or none of a rare one.
    if (scale_of_run() >= 1) {
      EXPECT_GT(made[name], 25U) << name;
    }
  }
}

// ---- Infinity above an index-1 point.

TEST(DirectionClaims, InfinityIsAboveAnEdgeWhereTheOracleFindsIt) {
  CITES("FC-CLAIM-06", "FC-CLAIM-07", "FC-UNST-02");
  std::map<Verdict, std::size_t> verdicts;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim stable = stable_claim(subject.points, *subject.truth, kFirstLine);
    Claim claim = stable;
    for (ClaimedPoint& point : claim.points) {
      point.successors.reset();
      point.stable.reset();
      point.skeleton.reset();
      point.surface.reset();
    }
    const auto k =
        some_point(stable, [](const ClaimedPoint& point) { return point.successors && point.successors->empty(); });
    if (!k) return;
    claim.points[*k].successors = {{ClaimedTarget{true, {}}}};
    const CheckReport report = check(subject.points, claim, *subject.truth);
    const oracle::PointSet set(subject.input.rows);
    bool is_there = false, is_open = false;
    for (const auto& entry : oracle::lambda_list(set, oracle_point(subject.points, subject.complex.stationary(), *k))) {
      is_there = is_there || !entry.limit;
      is_open = is_open || (entry.limit && entry.limit->hull_dimension != 3) ||
                (entry.limit && entry.limit->face_dimension != 3);
    }
    const bool is_right =
        is_there ? report.verdict == Verdict::kConforms : is_open || report.verdict == Verdict::kFails;
    require(subject, is_right, "infinity above point " + std::to_string(*k), report);
    ++verdicts[report.verdict];
  });
  std::printf("conforms %zu, perturbed %zu, fails %zu\n", verdicts[Verdict::kConforms], verdicts[Verdict::kPerturbed],
              verdicts[Verdict::kFails]);
  EXPECT_GT(verdicts[Verdict::kConforms], scale_of_run() >= 1 ? 50U : 0U);
}

}  // namespace
}  // namespace flowcert::property::direction_claims_test
