// Claimed orbits: how they are read, and where they differ from the right one (spec/formats/orbit.md).
//
// One thing is changed at a time, in the text of an orbit made by hand.
#include "flowcert/orbit_difference.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "flowcert/orbit_claim.h"
#include "tests/cites.h"

namespace flowcert::orbit_difference_test {
namespace {

using Json = nlohmann::json;

// An orbit with two segments. It ends at a regular stationary point, or else at a maximum.
Json orbit(bool is_regular) {
  Json object = Json::parse(R"({"segments": [
    {"type": "C-C-F", "driver": ["0","0","0"], "end": ["2","1","0"], "start_contact": [0], "crossed_contact": [0],
     "end_contact": [0,1]},
    {"type": "F-F-E", "driver": ["2","0","0"], "end": ["2","3/2","0"], "start_contact": [0,1],
     "crossed_contact": [0,1], "end_contact": [0,1,2]}],
    "limit": {"kind": "critical", "index": 3, "position": ["2","3/2","0"], "contact": [0,1,2],
              "squared_distance": "25/4"}})");
  if (is_regular) {
    object["limit"]["kind"] = "regular";
    object["limit"]["index"] = {1, 2};
  }
  return object;
}

OrbitPath read(const Json& object) { return claimed_orbit_of(object.dump(), "claim"); }

enum class Kind { kSame, kPermitted, kWrong, kUnreadable };

// With another value at a JSON pointer.
Kind changed(bool is_regular, const char* pointer, const Json& value) {
  const Json truth = orbit(is_regular);
  Json claim = truth;
  claim[Json::json_pointer(pointer)] = value;
  try {
    const auto found = path_difference(read(claim), read(truth));
    return !found ? Kind::kSame : found->is_permitted ? Kind::kPermitted : Kind::kWrong;
  } catch (const InvalidInput&) {
    return Kind::kUnreadable;
  }
}

TEST(OrbitDifference, WhatIsTheSameInOtherWords) {
  CITES("FC-FLOW-01", "FC-NUM-02");
  EXPECT_EQ(changed(false, "/segments/1/end_contact", {2, 0, 1}), Kind::kSame) << "ids in any order";
  EXPECT_EQ(changed(false, "/limit/contact", {1, 2, 0}), Kind::kSame);
  EXPECT_EQ(changed(false, "/limit/squared_distance", "50/8"), Kind::kSame);
  EXPECT_EQ(changed(false, "/segments/0/start_contact", nullptr), Kind::kSame) << "not claimed";
  EXPECT_EQ(changed(false, "/colour", "green"), Kind::kSame);
}

TEST(OrbitDifference, EachPartIsCompared) {
  CITES("FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03");
  for (const bool is_regular : {false, true}) {
    EXPECT_EQ(changed(is_regular, "/segments/0/type", "C-C-E"), Kind::kWrong);
    EXPECT_EQ(changed(is_regular, "/segments/0/driver", {"0", "0", "1/9"}), Kind::kWrong);
    EXPECT_EQ(changed(is_regular, "/segments/0/end", {"2", "1", "1/9"}), Kind::kWrong);
    EXPECT_EQ(changed(is_regular, "/segments/0/end", nullptr), Kind::kWrong);
    EXPECT_EQ(changed(is_regular, "/segments/0/start_contact", {1}), Kind::kWrong);
    EXPECT_EQ(changed(is_regular, "/segments/0/end_contact", {0, 1, 1}), Kind::kWrong) << "an id twice";
    EXPECT_EQ(changed(is_regular, "/segments/1/crossed_contact", {0}), Kind::kWrong) << "a part of it";
    EXPECT_EQ(changed(is_regular, "/segments/1/end", {"2", "2", "0"}), Kind::kWrong);
  }
  EXPECT_EQ(changed(false, "/segments/1/end_contact", {0, 1}), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/kind", "regular"), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/index", 2), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/position", {"2", "3/2", "1"}), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/contact", {0, 1, 3}), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/squared_distance", "25/2"), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/kind", "infinity"), Kind::kWrong);
}

// FC-CLAIM-07: where the right orbit ends at a regular stationary point, a perturbation may let it arrive in another
// way, and go on.
TEST(OrbitDifference, OnlyTheArrivalAtARegularPointIsFree) {
  CITES("FC-CLAIM-07");
  EXPECT_EQ(changed(true, "/segments/1/type", "F-F-V"), Kind::kPermitted);
  EXPECT_EQ(changed(true, "/segments/1/type", "F-E-E"), Kind::kWrong);
  EXPECT_EQ(changed(true, "/segments/1/end_contact", {0, 1}), Kind::kPermitted);
  EXPECT_EQ(changed(true, "/limit/kind", "infinity"), Kind::kPermitted);
  EXPECT_EQ(changed(false, "/segments/1/type", "F-F-V"), Kind::kWrong);
  const Json more = Json::parse(R"({"type": "E-E-inf", "driver": ["2","3/2","0"], "end": null})");
  EXPECT_EQ(changed(true, "/segments/2", more), Kind::kPermitted);
  EXPECT_EQ(changed(false, "/segments/2", more), Kind::kWrong);
  for (const bool is_regular : {false, true}) {
    EXPECT_EQ(changed(is_regular, "/segments", Json::array({orbit(false)["segments"][0]})), Kind::kWrong) << "cut";
    EXPECT_EQ(changed(is_regular, "/segments", Json::array()), Kind::kWrong);
  }
}

TEST(OrbitDifference, WhatIsNoOrbitIsRefused) {
  CITES("FC-IN-05", "FC-NUM-02");
  EXPECT_EQ(changed(false, "/segments", "none"), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/segments/0/driver", {"0", "0"}), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/segments/0/driver", {"0", "0", 0.5}), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/segments/0/start_contact", {-1}), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/segments/0/start_contact", {4294967296}), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/limit/squared_distance", "1/0"), Kind::kUnreadable);
  const Json indices[] = {3.0, 4, -1, "3", nullptr, {1}, {1, 2, 3}, {1, "2"}, {1, 2.0}};
  for (const Json& index : indices) EXPECT_EQ(changed(false, "/limit/index", index), Kind::kUnreadable) << index;
  EXPECT_EQ(changed(false, "/limit", nullptr), Kind::kUnreadable);
  EXPECT_THROW((void)claimed_orbit_of("{", "claim"), InvalidInput);
}

TEST(OrbitDifference, NumbersAreThoseOfClaims) {
  CITES("FC-FILE-47");
  for (const char* number : {"+50/8", "0x1.9p2", "050/08"}) {
    EXPECT_EQ(changed(false, "/limit/squared_distance", number), Kind::kSame) << number;
  }
  for (const char* number : {"6.25", "-50/-8", "50/-8", "50/00", "25/4 ", "\u0665"}) {
    EXPECT_EQ(changed(false, "/limit/squared_distance", number), Kind::kUnreadable) << number;
  }
  EXPECT_EQ(changed(false, "/limit/contact", {0, 1, 2147483646}), Kind::kWrong);
  EXPECT_EQ(changed(false, "/limit/contact", {0, 1, 2147483647}), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/limit/contact", {0, 1, 2.0}), Kind::kUnreadable);
  EXPECT_EQ(changed(false, "/limit/contact", {0, 1, "2"}), Kind::kUnreadable);
  const std::string text = orbit(false).dump();
  EXPECT_THROW((void)claimed_orbit_of(text + std::string("\0", 1), "claim"), InvalidInput);
}

}  // namespace
}  // namespace flowcert::orbit_difference_test
