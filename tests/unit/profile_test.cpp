// The profile of a claim and of a program (FC-CLAIM-22): which parts it names, and which statement.
#include "flowcert/profile.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::profile_test {
namespace {

using Words = std::vector<std::string>;

std::string statement(const CheckReport& report) {
  return conformity_text(report.verdict, report.profile).value_or("nothing");
}

// All parts that a claim about points can have.
Claimed all_of(const Truly& truly) {
  Claimed claimed = truly.whole_claim();
  add_directions_and_volumes(claimed.claim, *truly.truth);
  add_unstable_sets(claimed.claim, *truly.truth);
  claimed.claim.infinity = infinity_of(truly.truth->set_of_infinity());
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
  EXPECT_EQ(statement(report).substr(0, 33), "conforms to 1.1, points + U2 + S2") << text(report);
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
  EXPECT_EQ(statement(triangle.check(triangle.claim())), "conforms to 1.1, points, exact");
  Claimed perturbed = triangle.claim();
  perturbed.add(1, {1, 2}).add(2, {0, 1, 2});
  EXPECT_EQ(statement(triangle.check(perturbed)), "is perturbed under 1.1, points, exact");
  EXPECT_EQ(statement(triangle.check(Claimed())), "does not conform to 1.1");
  const Truly cube(kCube);
  Claimed part = cube.claim();
  part.of({0, 1, 2, 3}).contact = {0, 1, 2};
  EXPECT_EQ(statement(cube.check(part)), "conforms where determined to 1.1, points, exact");
  Claimed near = cube.claim_without({{0, 1}});
  near.at(1, decimals({Rational(1, 2), Rational(0), Rational(0)}));
  EXPECT_EQ(statement(cube.check(near)), "conforms to 1.1, points, approximate");
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
  pairs.set(ProfilePart::kPersistence, Profile::State::kTold);
  pairs.set_exact(false);
  joined.join(pairs);
  EXPECT_EQ(conformity_text(Verdict::kConforms, joined),
            "conforms to 1.1, points + U2 + S2 + persistence, approximate");
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
