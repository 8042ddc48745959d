// Orbits of the fast implementation against the oracle's, on every family of inputs and from starts of every
// kind.
//
// Guarantees: all is equal, segment by segment, for lazy constructions with binary search and for the other
// five ways to compute orbits. Single steps are compared too. The test fails too when the run has met fewer
// orbits than it should, starts on too few Voronoi vertices, edges or facets, or not every type of Table 1. A
// failure is shrunk, input and start alike, and printed with both orbits.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "flowcert/orbit.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/orbit_comparison.h"
#include "fuzz/properties/orbit_starts.h"
#include "oracle/orbit.h"
#include "tests/cites.h"
#include "tests/property/orbit_census.h"
#include "tests/property/orbit_inputs.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::orbit_agreement_test {
namespace {

constexpr int kInputsPerFamily = 35;
constexpr std::size_t kStartsPerInput = 5;
constexpr int kLargerInputs = 6;
constexpr std::size_t kLeastOrbits = 4500;

struct Variant {
  const char* name;
  FlowOptions options;
};
constexpr std::array<Variant, 6> kVariants = {{
    {"lazy, binary", {ConstructionKernel::kLazy, FacetSearch::kBinary}},
    {"lazy, linear", {ConstructionKernel::kLazy, FacetSearch::kLinear}},
    {"cascade, binary", {ConstructionKernel::kCascade, FacetSearch::kBinary}},
    {"cascade, linear", {ConstructionKernel::kCascade, FacetSearch::kLinear}},
    {"exact, binary", {ConstructionKernel::kExact, FacetSearch::kBinary}},
    {"exact, linear", {ConstructionKernel::kExact, FacetSearch::kLinear}},
}};

// What a run has met.
struct Seen {
  std::size_t inputs = 0;
  std::size_t orbits = 0;
  std::size_t longest = 0;
  TypeCensus types;

  void add(const OrbitRecord& orbit) {
    ++orbits;
    longest = std::max(longest, orbit.segments.size());
    for (const SegmentRecord& segment : orbit.segments) {
      ++types[segment.type];
    }
  }
  void add(const Seen& other) {
    inputs += other.inputs;
    orbits += other.orbits;
    longest = std::max(longest, other.longest);
    for (const auto& [type, count] : other.types) {
      types[type] += count;
    }
  }
};

void print_head() {
  std::printf("FLOWCERT_PROPERTY_SEED=%llu, segments by type:\n", static_cast<unsigned long long>(seed_of_run()));
  std::printf("%-22s %6s %6s %7s", "family", "inputs", "orbits", "longest");
  for (const std::string& type : kTableOne) {
    std::printf(" %7s", type.c_str());
  }
  std::printf("\n");
}

void print_row(const std::string& name, const Seen& seen) {
  std::printf("%-22s %6zu %6zu %7zu", name.c_str(), seen.inputs, seen.orbits, seen.longest);
  for (const std::string& type : kTableOne) {
    const auto found = seen.types.find(type);
    std::printf(" %7zu", found == seen.types.end() ? 0 : found->second);
  }
  std::printf("\n");
}

// The flows of one input: each remembers facets from one start to the next.
class Flows {
 public:
  explicit Flows(const VoronoiDiagram& diagram) {
    for (const Variant& variant : kVariants) {
      flows_.emplace_back(diagram, variant.options);
    }
  }
  Flow& operator[](std::size_t variant) { return flows_[variant]; }

 private:
  std::vector<Flow> flows_;
};

void require_steps(const Subject& subject, Flow& flow, const OrbitRecord& orbit) {
  OrbitRecord steps{orbit.start, {}, orbit.limit};
  for (const SegmentRecord& segment : orbit.segments) {
    const FlowSegment step = flow.step(segment.start);
    steps.segments.push_back(record_of(step));
    RC_ASSERT(!step.stays());
  }
  require_same(subject.input, "single steps against the orbit", steps, orbit);
}

// A step from a limit stays there, for example as V-V-V, and an orbit from a limit has no segments.
void require_stays(const Subject& subject, Flow& flow, const LimitRecord& limit) {
  const FlowSegment step = flow.step(limit.position);
  const std::string letter(1, oracle::face_letter(subject.set, limit.contact));
  const SegmentRecord stay{letter + "-" + letter + "-" + letter,
                           limit.position,
                           limit.position,
                           limit.contact,
                           limit.contact,
                           limit.position,
                           limit.contact};
  require_none(subject.input, difference(record_of(step), stay), "the step: " + to_text(record_of(step)));
  RC_ASSERT(step.stays());
  require_same(subject.input, "orbit from the limit", record_of(flow.orbit(limit.position)),
               {limit.position, {}, limit});
}

OrbitRecord compared_orbit(const Subject& subject, Flows& flows, const RationalPoint& start) {
  const OrbitRecord truth = record_of(subject.set, start, oracle::orbit(subject.set, start));
  OrbitRecord fast = record_of(flows[0].orbit(start));
  require_same(subject.input, "the fast orbit against the oracle's", fast, truth);
  for (std::size_t variant = 1; variant < kVariants.size(); ++variant) {
    require_same(subject.input, std::string(kVariants[variant].name) + " against lazy, binary",
                 record_of(flows[variant].orbit(start)), fast);
  }
  for (std::size_t variant = 0; variant < kVariants.size(); ++variant) {
    require_steps(subject, flows[variant], fast);
    if (fast.limit) {
      require_stays(subject, flows[variant], *fast.limit);
    }
  }
  return fast;
}

bool agrees_on(const fuzz::Family& family, const rc::detail::TestParams& parameters, Seen& seen, StartCensus& starts) {
  const rc::Gen<fuzz::Input> generator = family.generate();
  return expect_holds(family.name, parameters, [&] {
    const fuzz::Input input = *generator;
    const auto choices = *start_choices(kStartsPerInput).as("starts");
    const Subject subject(input);
    Flows flows(subject.complex.diagram());
    if (subject.complex.points().empty()) {
      RC_ASSERT_THROWS_AS((void)flows[0].orbit({}), InvalidInput);
      RC_ASSERT_THROWS_AS((void)flows[0].step({}), InvalidInput);
      return;
    }
    ++seen.inputs;
    for (const StartChoice& choice : choices) {
      const RationalPoint start = start_of(subject.set, choice);
      seen.add(compared_orbit(subject, flows, start));
      starts.add(subject.set, choice.kind, start);
    }
  });
}

// The bounds are far below the usual shares of all starts, and below those of each kind, so that neither
// another seed nor a new family fails.
void expect_starts_everywhere(const StartCensus& starts) {
  EXPECT_GE(starts.percent('V'), 5);
  EXPECT_GE(starts.percent('E'), 5);
  EXPECT_GE(starts.percent('F'), 5);
  EXPECT_GE(starts.percent('C'), 20);
  EXPECT_GE(starts.percent(StartKind::kVertex, 'V'), 60);
  EXPECT_GE(starts.percent(StartKind::kEdge, 'E'), 60);
  EXPECT_GE(starts.percent(StartKind::kFacet, 'F'), 80);
  EXPECT_GE(starts.percent(StartKind::kAimed, 'F'), 20);
  EXPECT_GE(starts.percent(StartKind::kNearby, 'C'), 80);
}

struct Outcome {
  Seen seen;
  StartCensus starts;
  // A run that was cut short, by a failure or on purpose, says nothing about numbers.
  bool complete = false;
};

// Shrinks only the first failure, and that one only if `shrinks` is true.
Outcome run_of(const std::vector<fuzz::Family>& families, int inputs, bool shrinks) {
  Outcome run;
  bool agreed = true;
  print_head();
  for (const fuzz::Family& family : families) {
    Seen seen;
    agreed = agrees_on(family, parameters_of_run(inputs, shrinks && agreed), seen, run.starts) && agreed;
    print_row(family.name, seen);
    run.seen.add(seen);
  }
  print_row("all", run.seen);
  run.starts.print();
  run.complete = agreed && scale_of_run() >= 1;
  return run;
}

TEST(OrbitAgreement, FastOrbitIsTheOracles) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-04", "FC-FLOW-05", "FC-DIST-01", "FC-DIST-02", "FC-NUM-01");
  const Outcome run = run_of(fuzz::families(), kInputsPerFamily, true);
  if (run.complete) {
    EXPECT_GE(run.seen.orbits, kLeastOrbits);
    expect_starts_everywhere(run.starts);
    for (const std::string& type : kTableOne) {
      EXPECT_TRUE(run.seen.types.contains(type)) << type;
    }
    EXPECT_EQ(run.seen.types.size(), kTableOne.size());
  }
}

TEST(OrbitAgreement, FastOrbitIsTheOraclesOnLargerInputs) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-05", "FC-NUM-01");
  const Outcome run = run_of(larger_families(), kLargerInputs, false);
  if (run.complete) {
    EXPECT_GE(run.seen.longest, 10U);
  }
}

}  // namespace
}  // namespace flowcert::property::orbit_agreement_test
