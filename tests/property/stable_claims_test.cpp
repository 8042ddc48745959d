// Claims of stable sets, right ones and right ones with one thing made wrong, on every family of inputs,
// those made for stable sets too; and boundary walks against the oracle's.
//
// Guarantees: a claim made of the answer itself conforms exactly. A claim with what FC-CLAIM-09 and 10 permit
// (ties broken otherwise, what lies beyond Voronoi vertices left out, decimals) never fails. Each mutant
// fails, on the level and the line where it was made wrong. The test fails too when some kind of mutant, or
// of permitted variation, was hardly ever made.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certify/boundaries.h"
#include "fuzz/inputs/input.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/subject.h"
#include "oracle/fast/point_set.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/property/claim_properties.h"
#include "tests/property/stable_skeleton.h"
#include "tests/true_claims.h"

namespace flowcert::property::stable_claims_test {

using namespace certify;
namespace {

constexpr int kInputsPerFamily = 20;
constexpr std::size_t kMostByOracle = 120;  // stationary points of an input

using Subject = ClaimSubject;

// ---- Claims that vary where they may.

void round_off(ClaimedPosition& x) {
  for (ClaimedNumber& number : x) {
    const std::optional<double> nearest = nearest_double(number.value);
    if (nearest) number = {Rational(*nearest), false};
  }
}

Claim claim_in_decimals(Claim claim) {
  for (ClaimedPoint& point : claim.points) {
    if (point.skeleton) {
      for (auto& segment : point.skeleton->segments) {
        round_off(segment.front.position);
        round_off(segment.back.position);
      }
      for (auto& interval : point.skeleton->intervals) {
        round_off(interval.front.position);
        round_off(interval.back.position);
      }
      for (auto& sector : point.skeleton->sectors) {
        for (auto& corner : sector.corners) round_off(corner.position);
        std::ranges::reverse(sector.corners);
      }
      std::ranges::reverse(point.skeleton->segments);
      if (point.orbits) {
        for (auto& chain : *point.orbits) {
          for (std::size_t& place : chain) place = point.skeleton->segments.size() - 1 - place;
        }
      }
    }
    if (!point.surface) continue;
    for (ClaimedPosition& vertex : point.surface->vertices) round_off(vertex);
    for (auto& triangle : point.surface->triangles) std::swap(triangle[0], triangle[2]);
  }
  return claim;
}

// Breaks ties at random, and counts the boundaries that came out otherwise.
Claim with_other_ties(const Subject& subject, Claim claim, std::size_t& differing) {
  const StableManifolds other(subject.complex.diagram(), subject.complex.stationary(), {.seed = 1 + below(1000000)});
  for (std::size_t k = 0; k < other.size(); ++k) {
    ClaimedPoint& point = claim.points[other.record(k)];
    if (point.hull_dimension) continue;
    std::vector<std::vector<PointId>> boundary;
    for (const std::uint32_t record : other.boundary(k)) boundary.push_back(subject.contact(record));
    differing += boundary != *point.stable->boundary ? 1 : 0;
    point.stable->boundary = boundary;
  }
  return claim;
}

// Leaves out some of what is reached through Voronoi vertices.
Claim without_what_is_beyond(const Subject& subject, Claim claim, std::size_t& left_out) {
  for (std::size_t i = 0; i < claim.points.size(); ++i) {
    ClaimedPoint& point = claim.points[i];
    if (!point.skeleton || !point.stable->has_vertex.value_or(false)) continue;
    point.surface.reset();
    point.skeleton->intervals.clear();
    point.skeleton->sectors.clear();
    point.orbits.reset();  // they name segments by their places
    const StableSet<> set = subject.truth->stable_set(i);
    std::erase_if(point.skeleton->segments, [&](const BackwardSegment<ClaimedPosition>& segment) {
      const auto is_vertex = [&](const BackwardSegment<>& s) {
        return s.back_kind == BackKind::kVertex && s.back_contact == *segment.front_contact;
      };
      const bool leaves_vertex = std::ranges::any_of(set.segments, is_vertex);
      left_out += leaves_vertex ? 1 : 0;
      return leaves_vertex;
    });
  }
  return claim;
}

// ---- Mutants.

struct Mutant {
  Claim claim;
  int level = 0;
  std::size_t line = 0;
};
using Mutation = std::function<std::optional<Mutant>(const Subject&, const Claim&)>;

bool is_surface(const ClaimedPoint& point) { return point.surface && !point.surface->triangles.empty(); }
bool is_saddle(const ClaimedPoint& point) { return point.stable && point.stable->boundary; }
bool has_segments(const ClaimedPoint& point) { return point.skeleton && !point.skeleton->segments.empty(); }

// A cycle with one edge more or less is no cycle.
std::optional<Mutant> other_boundary(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, is_saddle);
  const auto edge = some_point(claim, [](const ClaimedPoint& point) { return point.index == 1; });
  if (!k || !edge) return std::nullopt;
  Mutant mutant{claim, 4, kFirstLine + *k};
  auto& boundary = *mutant.claim.points[*k].stable->boundary;
  const std::vector<PointId> names = subject.contact(*edge);
  if (std::erase(boundary, names) == 0) boundary.push_back(names);
  return mutant;
}

// The claimed boundary is a cycle, but that of another point.
std::optional<Mutant> boundary_of_another(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [&](const ClaimedPoint& point) {
    return is_saddle(point) && !has_tie(*subject.truth, point.line - kFirstLine);
  });
  const auto other = some_point(claim, is_saddle);
  if (!k || *k == *other || *claim.points[*other].stable->boundary == *claim.points[*k].stable->boundary) {
    return std::nullopt;
  }
  Mutant mutant{claim, 4, kFirstLine + *k};
  mutant.claim.points[*k].stable->boundary = claim.points[*other].stable->boundary;
  return mutant;
}

std::optional<Mutant> other_incidence(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [](const ClaimedPoint& point) { return point.successors.has_value(); });
  const auto saddle = some_point(claim, [&](const ClaimedPoint& point) {
    return is_saddle(point) && !has_tie(*subject.truth, point.line - kFirstLine);
  });
  if (!k || !saddle) return std::nullopt;
  Mutant mutant{claim, 4, kFirstLine + *k};
  auto& successors = *mutant.claim.points[*k].successors;
  const std::vector<PointId> names = subject.contact(*saddle);
  const auto is_it = [&](const ClaimedTarget& target) { return target.contact == names; };
  if (std::erase_if(successors, is_it) == 0) successors.push_back({false, names});
  return mutant;
}

// The least of all ways to write down a closed walk.
std::vector<PointId> least_walk(std::vector<PointId> walk) {
  std::vector<PointId> least = walk;
  for (std::size_t turn = 0; turn < 2 * walk.size(); ++turn) {
    std::rotate(walk.begin(), walk.begin() + 1, walk.end());
    if (turn + 1 == walk.size()) std::ranges::reverse(walk);
    least = std::min(least, walk);
  }
  return least;
}

std::optional<Mutant> broken_walk(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [&](const ClaimedPoint& point) {
    return point.stable && point.stable->walk && !has_tie(*subject.truth, point.line - kFirstLine);
  });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  std::vector<PointId>& walk = *mutant.claim.points[*k].stable->walk;
  const std::vector<PointId> right = least_walk(walk);
  const std::size_t at = below(walk.size());
  switch (below(3)) {
    case 0:
      walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      walk[at] = subject.points.name(below(subject.points.size()));
      break;
    default:
      std::swap(walk[at], walk[below(walk.size())]);
  }
  if (least_walk(walk) == right) return std::nullopt;
  return mutant;
}

bool move(ClaimedPosition& x) {
  Rational& coordinate = x[below(3)].value;
  const std::optional<double> nearest = nearest_double(coordinate);
  if (!nearest) return false;
  const Rational rounded(*nearest);
  coordinate = rounded != coordinate ? rounded : Rational(fuzz::nudged(*nearest, below(2) == 0 ? 1 : -1));
  return true;
}

std::optional<Mutant> moved_skeleton(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, has_segments);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& segments = mutant.claim.points[*k].skeleton->segments;
  BackwardSegment<ClaimedPosition>& segment = segments[below(segments.size())];
  if (!move(below(2) == 0 ? segment.front.position : segment.back.position)) return std::nullopt;
  return mutant;
}

std::optional<Mutant> moved_corner(const Subject&, const Claim& claim) {
  const auto k =
      some_point(claim, [](const ClaimedPoint& point) { return point.skeleton && !point.skeleton->sectors.empty(); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& sectors = mutant.claim.points[*k].skeleton->sectors;
  auto& corners = sectors[below(sectors.size())].corners;
  if (!move(corners[below(corners.size())].position)) return std::nullopt;
  return mutant;
}

std::optional<Mutant> moved_interval(const Subject&, const Claim& claim) {
  const auto k =
      some_point(claim, [](const ClaimedPoint& point) { return point.skeleton && !point.skeleton->intervals.empty(); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& intervals = mutant.claim.points[*k].skeleton->intervals;
  BackwardInterval<ClaimedPosition>& interval = intervals[below(intervals.size())];
  if (!move(below(2) == 0 ? interval.front.position : interval.back.position)) return std::nullopt;
  return mutant;
}

std::optional<Mutant> moved_triangle(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, is_surface);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& vertices = mutant.claim.points[*k].surface->vertices;
  if (!move(vertices[below(vertices.size())])) return std::nullopt;
  return mutant;
}

// Leaves out a segment of the stationary point's own. None of these is beyond a Voronoi vertex.
std::optional<Mutant> segment_less(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [](const ClaimedPoint& point) { return point.index == 2 && is_saddle(point); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& segments = mutant.claim.points[*k].skeleton->segments;
  const auto own = std::ranges::find_if(segments, [&](const BackwardSegment<ClaimedPosition>& segment) {
    return *segment.front_contact == subject.contact(*k);
  });
  segments.erase(own);
  mutant.claim.points[*k].orbits.reset();  // they name segments by their places
  return mutant;
}

std::optional<Mutant> piece_twice(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, has_segments);
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  ClaimedPoint& point = mutant.claim.points[*k];
  auto& segments = point.skeleton->segments;
  // Where a back is regular, a piece nearer to the samples may be one that a perturbation adds.
  if (std::ranges::any_of(segments, [](const auto& segment) { return segment.back_kind == BackKind::kRegular; })) {
    return std::nullopt;
  }
  if (point.surface && below(2) == 0) {
    auto& triangles = point.surface->triangles;
    triangles.push_back(triangles[below(triangles.size())]);
  } else {
    segments.push_back(segments[below(segments.size())]);
  }
  return mutant;
}

std::optional<Mutant> triangle_less(const Subject& subject, const Claim& claim) {
  const auto k = some_point(claim, [&](const ClaimedPoint& point) {
    return is_surface(point) && !*point.stable->has_vertex &&
           subject.truth->index(point.line - kFirstLine).hull_dimension == 2;
  });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& triangles = mutant.claim.points[*k].surface->triangles;
  triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(below(triangles.size())));
  return mutant;
}

std::optional<Mutant> other_orbits(const Subject&, const Claim& claim) {
  const auto k = some_point(
      claim, [](const ClaimedPoint& point) { return point.skeleton && point.orbits && !point.orbits->empty(); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  auto& orbits = *mutant.claim.points[*k].orbits;
  const std::size_t at = below(orbits.size());
  switch (below(4)) {
    case 0:
      orbits.erase(orbits.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      orbits.push_back(orbits[at]);
      break;
    case 2:
      orbits[at].pop_back();
      break;
    default:
      orbits[at].push_back(orbits[at].front());
  }
  return mutant;
}

// A claim may have more segments beyond a regular back, and fewer beyond a Voronoi vertex.
std::optional<Mutant> other_summary(const Subject&, const Claim& claim) {
  const auto k = some_point(claim, [](const ClaimedPoint& point) { return point.stable.has_value(); });
  if (!k) return std::nullopt;
  Mutant mutant{claim, 5, kFirstLine + *k};
  ClaimedStable& stable = *mutant.claim.points[*k].stable;
  const bool has_regular_back = std::ranges::any_of(
      mutant.claim.points[*k].skeleton->segments,
      [](const BackwardSegment<ClaimedPosition>& segment) { return segment.back_kind == BackKind::kRegular; });
  switch (below(3)) {
    case 0:
      if (has_regular_back && *stable.has_vertex) return std::nullopt;
      stable.segments = has_regular_back ? *stable.segments - 1 : *stable.segments + 1;
      return mutant;
    case 1:
      if (*stable.has_vertex) return std::nullopt;
      stable.has_vertex = true;
      return mutant;
    default:
      if (*stable.has_interval) return std::nullopt;
      stable.has_interval = true;
      return mutant;
  }
}

const std::map<std::string, Mutation>& mutations() {
  static const std::map<std::string, Mutation> all = {
      {"other boundary", other_boundary},   {"boundary of another", boundary_of_another},
      {"other incidence", other_incidence}, {"broken walk", broken_walk},
      {"moved skeleton", moved_skeleton},   {"moved corner", moved_corner},
      {"moved interval", moved_interval},   {"moved triangle", moved_triangle},
      {"segment less", segment_less},       {"piece twice", piece_twice},
      {"triangle less", triangle_less},     {"other summary", other_summary},
      {"other orbits", other_orbits}};
  return all;
}

// ---- Properties.

TEST(StableClaims, RightClaimsNeverFail) {
  CITES("FC-CLAIM-06", "FC-CLAIM-09", "FC-CLAIM-10");
  std::size_t differing = 0, left_out = 0;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = stable_claim(subject.points, *subject.truth, kFirstLine);
    const CheckReport exact = check(subject.points, claim, *subject.truth);
    require(subject, exact.verdict == Verdict::kConforms && exact.findings.empty() && exact.is_exact, "the full claim",
            exact);
    const CheckReport decimals = check(subject.points, claim_in_decimals(claim), *subject.truth);
    require(subject, decimals.verdict == Verdict::kConforms, "the claim in decimals", decimals);
    const CheckReport ties = check(subject.points, with_other_ties(subject, claim, differing), *subject.truth);
    require(subject, ties.verdict != Verdict::kFails, "ties broken otherwise", ties);
    const CheckReport less = check(subject.points, without_what_is_beyond(subject, claim, left_out), *subject.truth);
    require(subject, less.verdict != Verdict::kFails, "without what is beyond Voronoi vertices", less);
  });
  std::printf("%zu boundaries by other ties, %zu segments beyond Voronoi vertices left out\n", differing, left_out);
  if (scale_of_run() >= 1) {
    EXPECT_GT(differing, 3U);
    EXPECT_GT(left_out, 16U);
  }
}

TEST(StableClaims, MutantsFailWhereTheyAreWrong) {
  CITES("FC-CLAIM-06", "FC-CLAIM-09", "FC-CLAIM-10", "FC-STAB-04", "FC-STAB-07", "FC-CHAIN-01");
  std::map<std::string, std::size_t> made;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const Claim claim = stable_claim(subject.points, *subject.truth, kFirstLine);
    for (const auto& [name, mutation] : mutations()) {
      const std::optional<Mutant> mutant = mutation(subject, claim);
      if (!mutant) continue;
      ++made[name];
      const CheckReport report = check(subject.points, mutant->claim, *subject.truth);
      const bool found = std::ranges::any_of(report.findings, [&](const Finding& finding) {
        return !finding.is_variation && finding.level == mutant->level && finding.line == mutant->line;
      });
      require(subject, report.verdict == Verdict::kFails && found,
              name + ": not found in line " + std::to_string(mutant->line), report);
    }
  });
  for (const auto& [name, mutation] : mutations()) {
    std::printf("%-20s %6zu mutants\n", name.c_str(), made[name]);
    EXPECT_GT(made[name], scale_of_run() >= 1 ? 40U : 0U) << name;
  }
}

TEST(StableClaims, WalksAreTheOracles) {
  CITES("FC-STAB-07");
  std::size_t walks = 0, replaced = 0, regular = 0, none = 0;
  on_all_families<Subject>(fuzz::families_and_stable_ones(), kInputsPerFamily, [&](const Subject& subject) {
    const oracle::fast::PointSet set(subject.input.rows);
    const std::size_t step = 1 + subject.truth->size() / kMostByOracle;
    for (std::size_t i = below(step); i < subject.truth->size(); i += step) {
      const StationaryIndex index = subject.truth->index(i);
      if (index != StationaryIndex{2, 2} && index.is_critical()) continue;
      const std::vector<PointId> contact = subject.contact(i);
      const auto z = oracle_point(subject.points, subject.complex.stationary(), i);
      const auto walk = boundary_walk(subject.truth->stable_set(i), index, contact);
      const oracle::StableSet stable = oracle::stable_set(set, z);
      const bool has_walk = index.hull_dimension == 2 && !stable.has_vertex;
      RC_ASSERT(walk.has_value() == has_walk);
      if (!has_walk) {
        ++none;
        continue;
      }
      const auto right = oracle::boundary_walk(set, z, stable);
      RC_ASSERT(std::vector<std::size_t>(walk->begin(), walk->end()) == right);
      ++walks;
      replaced += right.size() > contact.size() ? 1 : 0;
      regular += index.is_critical() ? 0 : 1;
    }
  });
  std::printf("%zu walks, %zu with sides replaced, %zu of regular points; %zu sets without one\n", walks, replaced,
              regular, none);
  if (scale_of_run() >= 1) {
    EXPECT_GT(walks, 300U);
    EXPECT_GT(replaced, 30U);
    EXPECT_GT(regular, 16U);
    EXPECT_GT(none, 16U);
  }
}

}  // namespace
}  // namespace flowcert::property::stable_claims_test
