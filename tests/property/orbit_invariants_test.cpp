// What every orbit of the fast implementation keeps, whatever the input and the start: the laws of spec
// section 8, and equivariance under permutations of the rows, signed permutations of the axes, scalings by
// powers of two and translations, where they are exact on the doubles.
//
// Guarantees: exact. The larger inputs have long orbits, and the test fails if they do not; it fails too when
// hardly any transformation was other than the identity.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/orbit.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/transformations.h"
#include "fuzz/properties/orbit_comparison.h"
#include "fuzz/properties/orbit_starts.h"
#include "tests/cites.h"
#include "tests/property/orbit_census.h"
#include "tests/property/orbit_inputs.h"
#include "tests/property/orbit_laws.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"
#include "tests/property/transformed_answers.h"
#include "tests/transformed_inputs.h"

namespace flowcert::property::orbit_invariants_test {
namespace {

constexpr int kInputsPerFamily = 25;
constexpr int kLargerInputs = 4;
constexpr std::size_t kStartsPerInput = 4;

struct Seen {
  std::size_t orbits = 0;
  std::size_t longest = 0;
  std::size_t to_critical = 0;
  std::size_t to_regular = 0;
  std::size_t to_infinity = 0;

  void add(const OrbitRecord& orbit) {
    ++orbits;
    longest = std::max(longest, orbit.segments.size());
    const bool critical = orbit.limit && orbit.limit->face_dimension == orbit.limit->hull_dimension;
    ++(!orbit.limit ? to_infinity : critical ? to_critical : to_regular);
  }
};

// Returns whether all orbits keep the laws.
bool keeps_laws(const fuzz::Family& family, const rc::detail::TestParams& parameters, Seen& seen) {
  const rc::Gen<fuzz::Input> generator = family.generate();
  return expect_holds(family.name, parameters, [&] {
    const fuzz::Input input = *generator;
    const auto choices = *start_choices(kStartsPerInput).as("starts");
    const Subject subject(input);
    if (subject.complex.points().empty()) {
      return;
    }
    Flow flow(subject.complex.diagram());
    for (const StartChoice& choice : choices) {
      const RationalPoint start = start_of(subject.set, choice);
      const OrbitRecord orbit = record_of(flow.orbit(start));
      RC_ASSERT(orbit.start == start);
      require_none(input, broken_law(subject.set, orbit), to_text(orbit));
      seen.add(orbit);
    }
  });
}

void print_seen(const char* what, const Seen& seen) {
  std::printf(
      "%s, FLOWCERT_PROPERTY_SEED=%llu: %zu orbits, the longest of %zu segments; %zu end at a critical "
      "point, %zu at a regular stationary one, %zu at infinity\n",
      what, static_cast<unsigned long long>(seed_of_run()), seen.orbits, seen.longest, seen.to_critical,
      seen.to_regular, seen.to_infinity);
}

TEST(OrbitInvariants, OrbitsKeepTheLaws) {
  CITES("FC-DIST-01", "FC-DIST-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-04", "FC-FLOW-05", "FC-FLOW-09", "FC-CRIT-01",
        "FC-CRIT-03", "FC-STAB-08", "FC-STAB-09");
  Seen seen;
  bool kept = true;
  for (const fuzz::Family& family : fuzz::families()) {
    kept = keeps_laws(family, parameters_of_run(kInputsPerFamily, kept), seen) && kept;
  }
  print_seen("families", seen);
  if (kept && scale_of_run() >= 1) {
    EXPECT_GT(seen.to_critical, 0U);
    EXPECT_GT(seen.to_regular, 0U);
    EXPECT_GT(seen.to_infinity, 0U);
  }
}

TEST(OrbitInvariants, OrbitsOfLargerInputsKeepTheLaws) {
  CITES("FC-DIST-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-04", "FC-FLOW-05", "FC-FLOW-09", "FC-STAB-09");
  Seen seen;
  bool kept = true;
  for (const fuzz::Family& family : larger_families()) {
    kept = keeps_laws(family, parameters_of_run(kLargerInputs, false), seen) && kept;
  }
  print_seen("larger inputs", seen);
  if (kept && scale_of_run() >= 1) {
    EXPECT_GE(seen.longest, 10U);
  }
}

// An input and the orbits from a few starts.
struct Orbits {
  fuzz::Input input;
  std::vector<OrbitRecord> orbits;
};

using Move = std::function<RationalPoint(const RationalPoint&)>;

// The moved starts of `original` have the moved and renamed orbits on the transformed input.
void require_equivariant(const Orbits& original, const fuzz::Input& transformed, const Move& move,
                         const std::vector<std::size_t>& names = {}) {
  const auto rename = [&names](std::vector<std::size_t>& contact) {
    for (std::size_t& name : contact) {
      name = names.empty() ? name : names[name];
    }
    std::sort(contact.begin(), contact.end());
  };
  const Subject subject(transformed);
  Flow flow(subject.complex.diagram());
  for (OrbitRecord expected : original.orbits) {
    expected.start = move(expected.start);
    for (SegmentRecord& segment : expected.segments) {
      segment.start = move(segment.start);
      segment.driver = move(segment.driver);
      if (segment.end) {
        segment.end = move(*segment.end);
      }
      for (auto* contact : {&segment.start_contact, &segment.crossed_contact, &segment.end_contact}) {
        rename(*contact);
      }
    }
    if (expected.limit) {
      expected.limit->position = move(expected.limit->position);
      rename(expected.limit->contact);
    }
    require_same(transformed, "orbit of the transformed start against the transformed orbit",
                 record_of(flow.orbit(expected.start)), expected);
  }
}

class OrbitEquivariance : public ::testing::Test {
 protected:
  // relation(orbits) draws a transformation and returns whether it was other than the identity.
  static void expect_for_orbits(const std::function<bool(const Orbits&)>& relation) {
    constexpr int kInputs = 8;
    constexpr std::size_t kStarts = 2;
    int other_than_identity = 0;
    bool held = true;
    for (const fuzz::Family& family : fuzz::families()) {
      const rc::Gen<fuzz::Input> generator = family.generate();
      held = expect_holds(family.name, parameters_of_run(kInputs, held),
                          [&] {
                            Orbits original{*generator, {}};
                            const auto choices = *start_choices(kStarts).as("starts");
                            const Subject subject(original.input);
                            if (subject.complex.points().empty()) {
                              return;
                            }
                            Flow flow(subject.complex.diagram());
                            for (const StartChoice& choice : choices) {
                              original.orbits.push_back(record_of(flow.orbit(start_of(subject.set, choice))));
                            }
                            other_than_identity += relation(original) ? 1 : 0;
                          }) &&
             held;
    }
    if (held && scale_of_run() >= 1) {
      EXPECT_GE(other_than_identity, kInputs * static_cast<int>(fuzz::families().size()) / 3);
    }
  }
};

TEST_F(OrbitEquivariance, PermutedRowsPermuteNames) {
  CITES("FC-FLOW-06", "FC-INV-04", "FC-IN-03", "FC-VOR-04");
  expect_for_orbits([](const Orbits& original) {
    const auto order = *fuzz::row_orders(original.input.rows.size());
    require_equivariant(
        original, fuzz::permuted(original.input, order), [](const RationalPoint& x) { return x; },
        names_after(original.input, order));
    return !std::is_sorted(order.begin(), order.end());
  });
}

TEST_F(OrbitEquivariance, SignedAxisPermutationMovesOrbits) {
  CITES("FC-FLOW-06", "FC-INV-04");
  expect_for_orbits([](const Orbits& original) {
    const fuzz::AxisMap map = *fuzz::axis_maps().as("axes");
    require_equivariant(original, fuzz::mapped(original.input, map),
                        [&map](const RationalPoint& x) { return image_of(x, map); });
    const fuzz::AxisMap identity;
    return map.axis != identity.axis || map.sign != identity.sign;
  });
}

TEST_F(OrbitEquivariance, PowerOfTwoScalesOrbits) {
  CITES("FC-FLOW-06", "FC-INV-04");
  expect_for_orbits([](const Orbits& original) {
    const int exponent = *fuzz::exact_scalings(original.input).as("exponent");
    const Rational factor = power_of_two(exponent);
    require_equivariant(original, fuzz::scaled(original.input, exponent).value(),
                        [&factor](const RationalPoint& x) { return scaled_by(x, factor); });
    return exponent != 0;
  });
}

TEST_F(OrbitEquivariance, ExactTranslationMovesOrbits) {
  CITES("FC-FLOW-06", "FC-INV-04");
  expect_for_orbits([](const Orbits& original) {
    const fuzz::Row offset = *fuzz::exact_translations(original.input).as("offset");
    require_equivariant(original, fuzz::translated(original.input, offset).value(),
                        [&offset](const RationalPoint& x) { return translated_by(x, offset); });
    return offset != fuzz::Row{0, 0, 0};
  });
}

}  // namespace
}  // namespace flowcert::property::orbit_invariants_test
