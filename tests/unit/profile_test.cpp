// The profile of a claim and of a program (FC-CLAIM-22): which parts it names, and which statement.
#include "flowcert/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::profile_test {
namespace {

using Words = std::vector<std::string>;

std::string statement(const CheckReport& report, double tolerance = kDefaultTolerance) {
  return conformity_text(report.verdict, report.profile, tolerance).value_or("nothing");
}

std::string why_none(const CheckReport& report, double tolerance) {
  return no_conformity_text(report.verdict, report.profile, tolerance).value_or("nothing");
}

// All parts that a claim about points can have.
Claimed all_of(const Truly& truly) {
  Claimed claimed = truly.whole_claim();
  add_directions_and_volumes(claimed.claim, *truly.truth);
  add_unstable_sets(claimed.claim, *truly.truth);
  claimed.claim.infinity = infinity_of(truly.truth->stable_set(std::nullopt));
  return claimed;
}

TEST(Profile, NamesWhatIsToldOfAllPoints) {
  CITES("FC-CLAIM-22");
  const Truly cube(kCube);
  EXPECT_EQ(cube.check(cube.claim()).profile.parts(), Words{"points"});
  const Claimed whole = all_of(cube);
  const CheckReport report = cube.check(whole);
  EXPECT_EQ(report.profile.parts(), (Words{"points", "U2", "S2", "polylines", "skeletons", "lambda-lists",
                                           "connections", "volumes", "U1", "infinity"}));
  EXPECT_EQ(statement(report).substr(0, 33), "conforms to 1.2, points + U2 + S2") << text(report);
  // One point of which it is not told is enough.
  Claimed less = whole;
  less.of({0, 1, 2, 3}).successors.reset();
  less.of({0, 1, 4, 5}).skeleton.reset();
  less.of({0, 1}).lambda.reset();
  less.of({0, 1, 2, 3, 4, 5, 6, 7}).volume.reset();
  less.claim.infinity.reset();
  EXPECT_EQ(cube.check(less).profile.parts(), (Words{"points", "S2", "polylines", "connections", "U1"}));
  // Volumes are told of critical points of both indices.
  Claimed flat = whole;
  flat.of({0, 1, 2, 3}).volume.reset();
  EXPECT_EQ(cube.check(flat).profile.parts(),
            (Words{"points", "U2", "S2", "polylines", "skeletons", "lambda-lists", "connections", "U1", "infinity"}));
}

TEST(Profile, HasNoPartAboveTheLevelsOrOfOtherIndices) {
  CITES("FC-CLAIM-22", "FC-CLAIM-12", "FC-CLAIM-19");
  const Truly cube(kCube);
  const Claimed whole = all_of(cube);
  EXPECT_EQ(cube.check(whole, {.highest_level = 4}).profile.parts(), (Words{"points", "U2", "S2"}));
  EXPECT_EQ(cube.check(whole, {.highest_level = 3}).profile.parts(), Words{"points"});
  EXPECT_EQ(statement(cube.check(whole, {.highest_level = 2})), "nothing");
  const CheckReport some = cube.check(whole, {.indices = {true, false, false, true}});
  EXPECT_EQ(some.profile.parts(), Words{"points of index 0, 3"});
  const CheckReport none = cube.check(whole, {.indices = {false, false, false, false}});
  EXPECT_EQ(none.profile.parts(), Words{});
}

TEST(Profile, SaysHowTheVerdictIs) {
  CITES("FC-CLAIM-22", "FC-CLAIM-20", "FC-CLAIM-05");
  const Truly triangle(kRightTriangle);
  EXPECT_EQ(statement(triangle.check(triangle.claim())), "conforms to 1.2, points, exact");
  Claimed perturbed = triangle.claim();
  perturbed.add(1, {1, 2}).add(2, {0, 1, 2});
  EXPECT_EQ(statement(triangle.check(perturbed)), "is perturbed under 1.2, points, exact");
  EXPECT_EQ(statement(triangle.check(Claimed())), "does not conform to 1.2");
  const Truly cube(kCube);
  Claimed part = cube.claim();
  part.of({0, 1, 2, 3}).contact = {0, 1, 2};
  EXPECT_EQ(statement(cube.check(part)), "conforms where determined to 1.2, points, exact");
  Claimed near = cube.claim_without({{0, 1}});
  near.at(1, decimals({Rational(1, 2), Rational(0), Rational(0)}));
  EXPECT_EQ(statement(cube.check(near)), "conforms to 1.2, points, approximate within 1e-09");
}

// With the largest tolerance there is a statement, and with the next double there is none.
TEST(Profile, StatesDecimalsWithASmallToleranceAlone) {
  CITES("FC-CLAIM-23", "FC-CLAIM-22");
  const double above = std::nextafter(1e-6, 1);
  const Truly cube(kCube);
  Claimed near = cube.claim_without({{0, 1}});
  near.at(1, decimals({Rational(1, 2), Rational(0), Rational(0)}));
  const CheckReport approximate = cube.check(near, {.tolerance = 1e-3});
  EXPECT_EQ(approximate.verdict, Verdict::kConforms);
  for (const auto& [tolerance, text] : {std::pair(0.0, "0"), std::pair(2.5e-12, "2.5e-12"), std::pair(1e-6, "1e-06")}) {
    EXPECT_EQ(statement(approximate, tolerance), std::string("conforms to 1.2, points, approximate within ") + text);
    EXPECT_EQ(why_none(approximate, tolerance), "nothing");
  }
  for (const double tolerance : {above, 1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(statement(approximate, tolerance), "nothing") << tolerance;
  }
  EXPECT_EQ(why_none(approximate, above),
            "no statement: the tolerance 1.0000000000000002e-06 is above 1e-06 (FC-CLAIM-23)");
  EXPECT_EQ(why_none(approximate, 1e-3), "no statement: the tolerance 0.001 is above 1e-06 (FC-CLAIM-23)");
  // Other verdicts, exact claims, and what has no part.
  Claimed determined = near;
  determined.of({0, 1, 2, 3}).contact = {0, 1, 2};
  EXPECT_EQ(statement(cube.check(determined), 1e-6),
            "conforms where determined to 1.2, points, approximate within 1e-06");
  EXPECT_EQ(statement(cube.check(determined), above), "nothing");
  near.at(1, decimals({Rational(1, 2), Rational(1), Rational(0)}));
  EXPECT_EQ(statement(cube.check(near), 1e-3), "does not conform to 1.2");
  EXPECT_EQ(why_none(cube.check(near), 1e-3), "nothing");
  EXPECT_EQ(statement(cube.check(cube.claim(), {.tolerance = 1e-3}), 1e-3), "conforms to 1.2, points, exact");
  EXPECT_EQ(why_none(cube.check(cube.claim()), 1e-3), "nothing");
  EXPECT_EQ(why_none(cube.check(determined, {.highest_level = 2}), 1e-3), "nothing");
}

// What differs by the tolerance times the radius is right, and by any more is not. The radius is 1, and the tolerance
// is the double: it is a little less than 10^-6.
TEST(Profile, TheToleranceIsTheLargestThatIsRight) {
  CITES("FC-CLAIM-23", "FC-CLAIM-05");
  const Truly two(std::vector<Point>{{0, 0, 0}, {2, 0, 0}});
  const Rational tiny = Rational(1) / Rational(1'000'000'000) / Rational(1'000'000'000'000'000'000);
  const auto verdict = [&](const Rational& off, double tolerance) {
    Claimed claimed = two.claim_without({{0, 1}});
    claimed.at(1, decimals({1 + off, Rational(0), Rational(0)}));
    return two.check(claimed, {.tolerance = tolerance}).verdict;
  };
  for (const double tolerance : {1e-9, 1e-6}) {
    EXPECT_EQ(verdict(Rational(tolerance), tolerance), Verdict::kConforms) << tolerance;
    EXPECT_EQ(verdict(-Rational(tolerance), tolerance), Verdict::kConforms) << tolerance;
    EXPECT_EQ(verdict(Rational(tolerance) + tiny, tolerance), Verdict::kFails) << tolerance;
    EXPECT_EQ(verdict(-Rational(tolerance) - tiny, tolerance), Verdict::kFails) << tolerance;
  }
  EXPECT_EQ(verdict(Rational(0), 0), Verdict::kConforms);
  EXPECT_EQ(verdict(Rational(1) / 1'000'000, 0), Verdict::kFails);
}

// Two points have no critical point of index 2, so that nothing is left out by telling no limits of them.
TEST(Profile, OfAProgramHasWhatNoAnswerLeavesOut) {
  CITES("FC-CLAIM-22");
  const Truly two(std::vector<Point>{{0, 0, 0}, {1, 0, 0}}), cube(kCube);
  const Profile of_two = two.check(two.claim()).profile;
  EXPECT_EQ(of_two.parts(), Words{"points"});
  const Profile of_cube = cube.check(cube.whole_claim(), {.highest_level = 4}).profile;
  Profile joined;
  EXPECT_EQ(joined.parts(), Words{});
  joined.join(of_two);
  joined.join(of_cube);
  EXPECT_EQ(joined.parts(), (Words{"points", "U2", "S2"}));
  Profile pairs;
  pairs.set(ProfilePart::kPersistence, Profile::State::kCovered);
  pairs.set_exact(false);
  joined.join(pairs);
  EXPECT_EQ(conformity_text(Verdict::kConforms, joined, 1e-7),
            "conforms to 1.2, points + U2 + S2 + persistence, approximate within 1e-07");
  Profile other_way = pairs;
  other_way.join(of_cube);
  other_way.join(of_two);
  EXPECT_EQ(other_way, joined);
  joined.join(cube.check(cube.claim()).profile);
  EXPECT_EQ(joined.parts(), (Words{"points", "persistence"}));
  joined.join(cube.check(cube.claim(), {.indices = {false, true, true, true}}).profile);
  EXPECT_EQ(joined.parts(), (Words{"points of index 1, 2, 3", "persistence"}));
}

TEST(Profile, OfAProgramKeepsInfinityWhereThereIsNoSample) {
  CITES("FC-CLAIM-22");
  const Truly nothing(std::vector<Point>{}), cube(kCube);
  Profile joined = nothing.check(nothing.claim()).profile;
  joined.join(cube.check(all_of(cube)).profile);
  EXPECT_EQ(joined.parts().back(), "infinity");
  joined.join(cube.check(cube.claim()).profile);
  EXPECT_EQ(joined.parts(), Words{"points"});
}

}  // namespace
}  // namespace flowcert::profile_test
