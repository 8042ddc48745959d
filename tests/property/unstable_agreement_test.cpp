// The unstable manifolds of all index-2 critical points, shared and alone, against the oracle's orbits.
//
// Guarantees: orbits are compared with the oracle's, exactly: all of them, or, where there are many saddles, those of
// some saddles spread over the list. An orbit's first segment is judged from the definitions too, and limits are
// compared with the list of stationary points. The statistics are counted again from all orbits. The test fails too
// when no orbit has shared anything, or none has ended at infinity or at a regular stationary point.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_statistics.h"
#include "flowcert/stationary_points.h"
#include "flowcert/unstable_manifolds.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/orbit_comparison.h"
#include "oracle/orbit.h"
#include "tests/cites.h"
#include "tests/property/orbit_census.h"
#include "tests/property/orbit_inputs.h"
#include "tests/property/orbit_laws.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::unstable_agreement_test {
namespace {

constexpr int kInputsPerFamily = 25;
constexpr int kLargerInputs = 1;
constexpr std::size_t kSaddlesByOracle = 60;  // at most so many of an input

constexpr FlowOptions kLazyBinary = {ConstructionKernel::kLazy, FacetSearch::kBinary};
constexpr FlowOptions kCascadeBinary = {ConstructionKernel::kCascade, FacetSearch::kBinary};
constexpr FlowOptions kCascadeLinear = {ConstructionKernel::kCascade, FacetSearch::kLinear};
constexpr FlowOptions kExactLinear = {ConstructionKernel::kExact, FacetSearch::kLinear};

// Each orbit by itself.
constexpr FlowOptions unshared(FlowOptions options) {
  options.share = false;
  return options;
}

// All orbits of an input, computed in one way.
struct Answer {
  std::vector<std::size_t> saddles;
  std::vector<std::array<OrbitRecord, 2>> orbits;
  std::vector<std::array<std::optional<std::size_t>, 2>> limits;
  FlowStatistics statistics;
};

Answer answer_of(const Subject& subject, const StationaryPoints& stationary, const FlowOptions& options) {
  UnstableManifolds manifolds(subject.complex.diagram(), stationary, options);
  Answer answer;
  answer.statistics = manifolds.statistics();
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    answer.saddles.push_back(manifolds.saddle(i));
    answer.orbits.push_back({record_of(manifolds.orbit(i, 0)), record_of(manifolds.orbit(i, 1))});
    answer.limits.push_back({manifolds.limit(i, 0), manifolds.limit(i, 1)});
  }
  return answer;
}

// What the statistics say of the orbits, apart from how they were computed.
struct Counts {
  Distribution n_u2;
  Distribution n_wcc;
  TypeCensus census;
  std::size_t to_critical = 0;
  std::size_t to_regular = 0;
  std::size_t to_infinity = 0;

  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts_of(const FlowStatistics& statistics) {
  Counts counts{statistics.n_u2,        statistics.n_wcc,      {},
                statistics.to_critical, statistics.to_regular, statistics.to_infinity};
  for (const auto& [type, count] : statistics.census) {
    counts.census[type_text(type)] = count;
  }
  return counts;
}

bool ends_at_constructed_point(const SegmentRecord& segment) { return segment.type.substr(1) == "-F-E"; }

// The lengths of the maximal runs of segments ?-F-E.
void add_runs(const OrbitRecord& orbit, Distribution& lengths) {
  std::size_t run = 0;
  for (const SegmentRecord& segment : orbit.segments) {
    if (ends_at_constructed_point(segment)) {
      ++run;
    } else if (run > 0) {
      lengths.add(run);
      run = 0;
    }
  }
  if (run > 0) {
    lengths.add(run);
  }
}

Counts counted_again(const Answer& answer) {
  Counts counts;
  for (const auto& both : answer.orbits) {
    for (const OrbitRecord& orbit : both) {
      counts.n_u2.add(orbit.segments.size());
      add_runs(orbit, counts.n_wcc);
      for (const SegmentRecord& segment : orbit.segments) {
        ++counts.census[segment.type];
      }
      const bool critical = orbit.limit && orbit.limit->face_dimension == orbit.limit->hull_dimension;
      ++(!orbit.limit ? counts.to_infinity : critical ? counts.to_critical : counts.to_regular);
    }
  }
  return counts;
}

std::string text_of(const Distribution& distribution) {
  std::string text;
  for (const auto& [value, times] : distribution.times()) {
    text += ' ' + std::to_string(value) + " (" + std::to_string(times) + ")";
  }
  return text + '\n';
}

std::string text_of(const Counts& counts) {
  std::string text = "n_u2" + text_of(counts.n_u2) + "n_wcc" + text_of(counts.n_wcc) + "census";
  for (const auto& [type, count] : counts.census) {
    text += ' ' + type + ' ' + std::to_string(count);
  }
  return text + "\nto critical, regular, infinity: " + std::to_string(counts.to_critical) + ' ' +
         std::to_string(counts.to_regular) + ' ' + std::to_string(counts.to_infinity) + '\n';
}

void require_same_counts(const Subject& subject, const std::string& what, const Counts& a, const Counts& b) {
  require_none(subject.input, a == b ? "" : what, "the first:\n" + text_of(a) + "the second:\n" + text_of(b));
}

// The list's index-2 critical points, in its order.
std::vector<std::size_t> saddles_of(const StationaryPoints& stationary) {
  std::vector<std::size_t> saddles;
  for (std::size_t k = 0; k < stationary.size(); ++k) {
    if (stationary.index(k) == StationaryIndex{2, 2}) {
      saddles.push_back(k);
    }
  }
  return saddles;
}

oracle::StationaryPoint stationary_point(const Subject& subject, const StationaryPoints& stationary, std::size_t k) {
  const auto contact = stationary.contact(k);
  const ExactSphere sphere = exact_sphere(subject.complex.points(), contact);
  return {sphere.center,
          sphere.squared_radius,
          {contact.begin(), contact.end()},
          stationary.index(k).face_dimension,
          stationary.index(k).hull_dimension};
}

oracle::Point cross(const oracle::Point& a, const oracle::Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The first segment runs along the line of equal distance, to the side that (b-a) x (c-a) points to, or to
// the other. It ends where the contact set is larger than the saddle's, or goes to infinity if no point is on
// that side of the plane.
std::string broken_first_segment(const oracle::PointSet& set, const oracle::StationaryPoint& saddle, std::size_t side,
                                 const SegmentRecord& segment) {
  const auto contact = points_of(set, saddle.contact);
  const oracle::Point normal = cross(oracle::minus(contact[1], contact[0]), oracle::minus(contact[2], contact[0]));
  const auto height = [&](const oracle::Point& x) {
    const Rational above = oracle::dot(normal, oracle::minus(x, contact[0]));
    return side == 1 ? above : Rational(-above);
  };
  if (segment.start != saddle.center || segment.driver != saddle.center || segment.start_contact != saddle.contact ||
      segment.crossed_contact != saddle.contact) {
    return "the first segment does not leave the saddle along its Voronoi edge";
  }
  if (!segment.end) {
    const bool free =
        std::all_of(set.points.begin(), set.points.end(), [&](const oracle::Point& q) { return height(q) <= 0; });
    return free && segment.type == "E-E-inf" ? "" : "the first segment does not go to infinity";
  }
  if (segment.type != "E-E-V" || height(*segment.end) <= 0 ||
      cross(normal, oracle::minus(*segment.end, saddle.center)) != oracle::Point{}) {
    return "the first segment leaves the Voronoi edge, or on the wrong side";
  }
  return oracle::contact_set(set, *segment.end) == segment.end_contact &&
                 segment.end_contact.size() > saddle.contact.size() &&
                 std::includes(segment.end_contact.begin(), segment.end_contact.end(), saddle.contact.begin(),
                               saddle.contact.end())
             ? ""
             : "the first segment does not end in the vertex of the Voronoi edge";
}

void require_right_limit(const Subject& subject, const StationaryPoints& stationary, const OrbitRecord& orbit,
                         std::optional<std::size_t> limit) {
  if (!limit || !orbit.limit) {
    require_none(subject.input, limit.has_value() == orbit.limit.has_value() ? "" : "limit() is wrong", to_text(orbit));
    return;
  }
  RC_ASSERT(*limit < stationary.size());
  const oracle::StationaryPoint point = stationary_point(subject, stationary, *limit);
  const bool right =
      *orbit.limit == LimitRecord{point.center, point.face_dimension, point.hull_dimension, point.contact};
  require_none(subject.input, right ? "" : "limit() is another stationary point", to_text(orbit));
}

// One of the two orbits of a saddle.
void require_right_orbit(const Subject& subject, const oracle::StationaryPoint& saddle, std::size_t side,
                         const OrbitRecord& orbit) {
  RC_ASSERT(!orbit.segments.empty());
  require_none(subject.input, broken_first_segment(subject.set, saddle, side, orbit.segments.front()),
               "side " + std::to_string(side) + ", " + to_text(orbit));
  require_same(
      subject.input, "side " + std::to_string(side) + " against the oracle's", orbit,
      record_of(subject.set, saddle.center, oracle::unstable_orbit(subject.set, saddle, static_cast<int>(side))));
  const auto& end = orbit.segments.front().end;
  if (end) {
    OrbitRecord rest = orbit;
    rest.start = *end;
    rest.segments.erase(rest.segments.begin());
    require_same(subject.input, "after the first segment, against the oracle's orbit from there", rest,
                 record_of(subject.set, *end, oracle::orbit(subject.set, *end)));
  }
}

void require_same_answer(const Subject& subject, const std::string& what, const Answer& a, const Answer& b) {
  require_none(subject.input, a.saddles == b.saddles ? "" : what + ": other saddles", "");
  for (std::size_t i = 0; i < a.orbits.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      require_same(subject.input, what, a.orbits[i].at(side), b.orbits[i].at(side));
    }
    require_none(subject.input, a.limits[i] == b.limits[i] ? "" : what + ": other limits",
                 to_text(a.orbits[i][0]) + to_text(a.orbits[i][1]));
  }
  require_same_counts(subject, what + ": other statistics", counts_of(a.statistics), counts_of(b.statistics));
}

std::size_t segments_of(const Counts& counts) {
  std::size_t segments = 0;
  for (const auto& [length, times] : counts.n_u2.times()) {
    segments += length * times;
  }
  return segments;
}

// What a run has met.
struct Seen {
  std::size_t saddles = 0;
  std::size_t segments = 0;
  std::size_t computed = 0;  // of the segments, with sharing
  std::size_t longest = 0;
  std::size_t longest_cascade = 0;
  std::size_t to_critical = 0;
  std::size_t to_regular = 0;
  std::size_t to_infinity = 0;

  void add(const FlowStatistics& shared) {
    saddles += shared.n_u2.count() / 2;
    segments += segments_of(counts_of(shared));
    computed += shared.segments_computed;
    longest = std::max(longest, shared.n_u2.max());
    longest_cascade = std::max(longest_cascade, shared.n_wcc.max());
    to_critical += shared.to_critical;
    to_regular += shared.to_regular;
    to_infinity += shared.to_infinity;
  }
};

void print_head() {
  std::printf("FLOWCERT_PROPERTY_SEED=%llu, both orbits of each saddle:\n",
              static_cast<unsigned long long>(seed_of_run()));
  std::printf("%-22s %7s %8s %8s %7s %7s %8s %7s %8s\n", "family", "saddles", "segments", "computed", "longest",
              "cascade", "critical", "regular", "infinity");
}

void print_row(const std::string& name, const Seen& seen) {
  std::printf("%-22s %7zu %8zu %8zu %7zu %7zu %8zu %7zu %8zu\n", name.c_str(), seen.saddles, seen.segments,
              seen.computed, seen.longest, seen.longest_cascade, seen.to_critical, seen.to_regular, seen.to_infinity);
}

// Compares the shared orbits with the oracle's, with those computed alone, and with those of the other kernels and
// searches.
FlowStatistics compared_statistics(const Subject& subject) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const Answer shared = answer_of(subject, stationary, kLazyBinary);
  const Answer alone = answer_of(subject, stationary, unshared(kLazyBinary));
  require_none(subject.input, shared.saddles == saddles_of(stationary) ? "" : "not the list's saddles", "");
  for (std::size_t i = 0; i < shared.saddles.size(); i += 1 + shared.saddles.size() / kSaddlesByOracle) {
    const auto saddle = stationary_point(subject, stationary, shared.saddles[i]);
    for (std::size_t side = 0; side < 2; ++side) {
      const OrbitRecord& orbit = shared.orbits[i].at(side);
      require_right_orbit(subject, saddle, side, orbit);
      require_right_limit(subject, stationary, orbit, shared.limits[i].at(side));
    }
  }
  require_same_answer(subject, "shared against alone", shared, alone);
  require_same_answer(subject, "lazy and binary against exact and linear", shared,
                      answer_of(subject, stationary, kExactLinear));
  require_same_answer(subject, "lazy and binary against cascade and binary", shared,
                      answer_of(subject, stationary, kCascadeBinary));
  require_same_answer(subject, "lazy and binary against cascade and linear, each alone", shared,
                      answer_of(subject, stationary, unshared(kCascadeLinear)));
  const Counts counts = counted_again(shared);
  require_same_counts(subject, "statistics against the orbits counted again", counts_of(shared.statistics), counts);
  RC_ASSERT(alone.statistics.segments_computed == segments_of(counts));
  RC_ASSERT(shared.statistics.segments_computed <= segments_of(counts));
  return shared.statistics;
}

struct Outcome {
  Seen seen;
  bool complete = false;
};

// Shrinks only the first failure, and that one only if `shrinks` is true.
Outcome run_of(const std::vector<fuzz::Family>& families, int inputs, bool shrinks) {
  Outcome run;
  bool agreed = true;
  print_head();
  Seen& all = run.seen;
  for (const fuzz::Family& family : families) {
    Seen seen;
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds(family.name, parameters_of_run(inputs, shrinks && agreed),
                          [&] {
                            const fuzz::Input input = *generator;
                            const FlowStatistics statistics = compared_statistics(Subject(input));
                            seen.add(statistics);
                            all.add(statistics);
                          }) &&
             agreed;
    print_row(family.name, seen);
  }
  print_row("all", all);
  run.complete = agreed && scale_of_run() >= 1;
  return run;
}

TEST(UnstableAgreement, OrbitsAreTheOraclesSharedOrNot) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07", "FC-FLOW-08", "FC-CRIT-02", "FC-STAT-01");
  const Outcome run = run_of(fuzz::families(), kInputsPerFamily, true);
  if (run.complete) {
    EXPECT_GE(run.seen.saddles, 1000U);
    EXPECT_GT(run.seen.to_critical, 0U);
    EXPECT_GT(run.seen.to_regular, 0U);
    EXPECT_GT(run.seen.to_infinity, 0U);
    EXPECT_LT(run.seen.computed, run.seen.segments);
  }
}

TEST(UnstableAgreement, OrbitsOfLargerInputsAreTheOracles) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07", "FC-FLOW-08");
  const Outcome run = run_of(larger_families(), kLargerInputs, false);
  if (run.complete) {
    EXPECT_GE(run.seen.longest, 10U);
    EXPECT_GE(run.seen.longest_cascade, 3U);
    EXPECT_LT(run.seen.computed, run.seen.segments);
  }
}

TEST(UnstableAgreement, AskingForOrbitsLeavesTheStatistics) {
  CITES("FC-FLOW-08");
  const fuzz::Input input{{{1, 0, 2}, {2, 1, 0}, {0, 3, 1}, {3, 3, 3}, {1, 1, 1}, {0, 0, 0}}};
  const Subject subject(input);
  const StationaryPoints& stationary = subject.complex.stationary();
  for (const bool share : {true, false}) {
    UnstableManifolds manifolds(subject.complex.diagram(), stationary, share ? kLazyBinary : unshared(kLazyBinary));
    // The copy has what they were before.
    const FlowStatistics before = manifolds.statistics();  // NOLINT(performance-unnecessary-copy-initialization)
    EXPECT_GT(before.n_u2.max(), 1U);
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
      (void)manifolds.orbit(i, 0);
      (void)manifolds.orbit(i, 1);
    }
    EXPECT_TRUE(counts_of(manifolds.statistics()) == counts_of(before)) << share;
    EXPECT_EQ(manifolds.statistics().segments_computed, before.segments_computed) << share;
  }
}

TEST(UnstableAgreement, NothingToComputeForFewPoints) {
  CITES("FC-FLOW-07", "FC-IN-04");
  for (std::size_t n = 0; n <= 3; ++n) {
    fuzz::Input input;
    for (std::size_t k = 0; k < n; ++k) {
      input.rows.push_back({static_cast<double>(k), 0, 0});
    }
    const Subject subject(input);
    const UnstableManifolds& manifolds = subject.complex.unstable();
    EXPECT_EQ(manifolds.size(), 0U);
    EXPECT_TRUE(counts_of(manifolds.statistics()) == Counts{});
  }
}

}  // namespace
}  // namespace flowcert::property::unstable_agreement_test
