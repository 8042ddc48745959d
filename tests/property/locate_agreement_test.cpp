// Where points flow to, by FlowLocator, against the oracle's orbits, on all families.
//
// Guarantees: limits and nearest samples are compared exactly, for positions of every kind, and again for the doubles
// nearest to them. The test fails too when too few positions were found without following their orbits.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdio>
#include <string>
#include <vector>

#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/orbit_starts.h"
#include "fuzz/properties/subject.h"
#include "morse/flow_locator.h"
#include "oracle/orbit.h"
#include "tests/cites.h"
#include "tests/property/orbit_census.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::locate_agreement_test {
namespace {

constexpr int kInputsPerFamily = 30;
constexpr std::size_t kPositionsPerInput = 6;

struct LocateTotals {
  std::size_t inputs = 0, positions = 0, to_infinity = 0, followed = 0;
};

void require_same_place(const Subject& subject, const RationalPoint& x, const FlowPlace& place) {
  const OrbitRecord truth = record_of(subject.set, x, oracle::orbit(subject.set, x));
  const std::vector<std::size_t>& nearest =
      truth.segments.empty() ? truth.limit->contact : truth.segments.front().start_contact;
  const std::string at = " of " + to_text(x);
  require_none(subject.input,
               std::vector<std::size_t>(place.nearest.begin(), place.nearest.end()) == nearest
                   ? ""
                   : "other nearest samples" + at,
               to_text(truth));
  require_none(subject.input, place.limit.has_value() == truth.limit.has_value() ? "" : "infinity or not" + at,
               to_text(truth));
  if (!place.limit) return;
  const auto contact = subject.complex.stationary().contact(*place.limit);
  require_none(
      subject.input,
      std::vector<std::size_t>(contact.begin(), contact.end()) == truth.limit->contact ? "" : "another limit" + at,
      to_text(truth));
}

// FC-LOC-03, for the ray through x from each sample that is nearest to it. The cell is convex.
void require_same_limit_along_rays(const Subject& subject, const RationalPoint& x, const FlowPlace& place,
                                   FlowLocator& locator) {
  for (const PointId name : place.nearest) {
    const Point& p = subject.complex.points()[subject.complex.points().ordinal_of_row(name)];
    const RationalPoint sample = {Rational(p.x), Rational(p.y), Rational(p.z)};
    if (x == sample) continue;
    RationalPoint nearer;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      nearer.at(axis) = sample.at(axis) + (x.at(axis) - sample.at(axis)) / 3;
    }
    RC_ASSERT(locator.locate(nearer).limit == place.limit);
  }
}

void require_right_places(const Subject& subject, const std::vector<StartChoice>& choices, LocateTotals& totals) {
  FlowLocator locator(subject.complex.diagram(), subject.complex.stationary(), subject.complex.limits());
  if (subject.complex.points().empty()) {
    RC_ASSERT_THROWS_AS((void)locator.locate(RationalPoint{}), InvalidInput);
    return;
  }
  ++totals.inputs;
  for (const StartChoice& choice : choices) {
    const RationalPoint x = start_of(subject.set, choice);
    const FlowPlace place = locator.locate(x);
    require_same_place(subject, x, place);
    require_same_limit_along_rays(subject, x, place, locator);
    ++totals.positions;
    totals.to_infinity += place.limit ? 0U : 1U;
    const auto a = nearest_double(x[0]), b = nearest_double(x[1]), c = nearest_double(x[2]);
    if (!a || !b || !c) continue;
    const Point rounded{*a, *b, *c};
    require_same_place(subject, {Rational(*a), Rational(*b), Rational(*c)}, locator.locate(rounded));
    ++totals.positions;
  }
  totals.followed += locator.followed();
}

void print_row(const std::string& name, const LocateTotals& totals) {
  std::printf("%-24s %6zu inputs, %6zu positions, %5zu to infinity, %6zu by their orbits\n", name.c_str(),
              totals.inputs, totals.positions, totals.to_infinity, totals.followed);
}

TEST(LocateAgreement, PlacesAreTheOracles) {
  CITES("FC-LOC-01", "FC-LOC-03", "FC-FLOW-05", "FC-DIST-01");
  LocateTotals all;
  bool agreed = true;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    LocateTotals totals;
    const rc::Gen<fuzz::Input> generator = family.generate();
    agreed = expect_holds("places, " + family.name, parameters_of_run(kInputsPerFamily),
                          [&] {
                            const fuzz::Input input = *generator;
                            const auto choices = *start_choices(kPositionsPerInput).as("positions");
                            require_right_places(Subject(input), choices, totals);
                          }) &&
             agreed;
    print_row(family.name, totals);
    all.inputs += totals.inputs, all.positions += totals.positions;
    all.to_infinity += totals.to_infinity, all.followed += totals.followed;
  }
  print_row("all", all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 1000U);
    EXPECT_GE(all.positions - all.followed, 1500U);
    EXPECT_GE(all.followed, 1500U);
    EXPECT_GE(all.to_infinity, 500U);
  }
}

}  // namespace
}  // namespace flowcert::property::locate_agreement_test
