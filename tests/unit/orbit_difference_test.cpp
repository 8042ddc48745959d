// Claimed orbits: how they are read, and where they differ from the right one (spec/formats/orbit.md).
//
// One thing is changed at a time, in the text of an orbit made by hand.
#include "certify/orbit_difference.h"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "certify/orbit_claim.h"
#include "certify/truth.h"
#include "geometry/rational_point.h"
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

// The orbit above that ends at a regular stationary point is one of these: the middle of 0 and 2 is as far from 1. From
// there the Voronoi facet of 0 and 2 leads to the middle of 2 and 3, which is as far from 0.
const std::vector<Point> kPoints = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {-6, 8, 0}};

Kind kind_of(const Json& claim, const Json& truth) {
  const PointSet points(kPoints);
  const std::unique_ptr<Truth> flow = fast_truth(points);
  try {
    const auto found = path_difference(read(claim), read(truth), points, *flow);
    return !found ? Kind::kSame : found->is_permitted ? Kind::kPermitted : Kind::kWrong;
  } catch (const InvalidInput&) {
    return Kind::kUnreadable;
  }
}

// With another value at a JSON pointer.
Kind changed(bool is_regular, const char* pointer, const Json& value) {
  const Json truth = orbit(is_regular);
  Json claim = truth;
  claim[Json::json_pointer(pointer)] = value;
  return kind_of(claim, truth);
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
// way.
TEST(OrbitDifference, OnlyTheArrivalAtARegularPointIsFree) {
  CITES("FC-CLAIM-07", "FC-CLAIM-08", "FC-FILE-27");
  EXPECT_EQ(changed(true, "/segments/1/type", "F-F-V"), Kind::kPermitted);
  for (const char* type : {"F-E-E", "F-F-F", "F-F-C", "F-F-Q", "F-F-inf", "F-F-", "F-F-EV"}) {
    EXPECT_EQ(changed(true, "/segments/1/type", type), Kind::kWrong) << type;
  }
  EXPECT_EQ(changed(true, "/segments/0/type", "C-C-E"), Kind::kWrong) << "not there yet";
  EXPECT_EQ(changed(true, "/segments/1/end_contact", {0, 1}), Kind::kPermitted);
  EXPECT_EQ(changed(true, "/segments/1/end_contact", {0, 2}), Kind::kWrong) << "without what it crosses";
  EXPECT_EQ(changed(true, "/segments/1/end_contact", {0, 1, 2, 3}), Kind::kWrong);
  EXPECT_EQ(changed(false, "/segments/1/type", "F-F-V"), Kind::kWrong);
  // All of the limit is right.
  EXPECT_EQ(changed(true, "/limit/kind", "infinity"), Kind::kWrong);
  EXPECT_EQ(changed(true, "/limit/squared_distance", "999"), Kind::kWrong);
  EXPECT_EQ(changed(true, "/limit/contact", {0, 2}), Kind::kWrong);
  EXPECT_EQ(changed(true, "/limit/index", {1, 3}), Kind::kWrong);
  EXPECT_EQ(changed(true, "/limit/kind", "critical"), Kind::kWrong);
  for (const bool is_regular : {false, true}) {
    EXPECT_EQ(changed(is_regular, "/segments", Json::array({orbit(false)["segments"][0]})), Kind::kWrong) << "cut";
    EXPECT_EQ(changed(is_regular, "/segments", Json::array()), Kind::kWrong);
  }
}

// With segments beyond the regular stationary point, and another limit; then with another value at a JSON pointer.
Kind gone_on(const std::vector<Json>& segments, const Json& limit, const char* pointer = nullptr,
             const Json& value = nullptr) {
  Json claim = orbit(true);
  for (const Json& segment : segments) claim["segments"].push_back(segment);
  claim["limit"] = limit;
  if (pointer != nullptr) claim[Json::json_pointer(pointer)] = value;
  return kind_of(claim, orbit(true));
}

TEST(OrbitDifference, AnOrbitGoesOnAsTheFlowDoes) {
  CITES("FC-CLAIM-07", "FC-CLAIM-08", "FC-FILE-27");
  const Json along_facet = Json::parse(R"({"type": "E-F-E", "driver": ["2","3/2","0"], "end": ["-1","11/2","0"],
    "start_contact": [0,1,2], "crossed_contact": [0,2], "end_contact": [0,2,3]})");
  const Json there = Json::parse(R"({"kind": "regular", "index": [1,2], "position": ["-1","11/2","0"],
    "contact": [0,2,3], "squared_distance": "125/4"})");
  const auto expect = [&](Kind kind, const char* pointer, const Json& value) {
    EXPECT_EQ(gone_on({along_facet}, there, pointer, value), kind) << pointer << " " << value;
  };
  EXPECT_EQ(gone_on({along_facet}, there), Kind::kPermitted);
  expect(Kind::kPermitted, "/segments/1/type", "F-F-V");
  expect(Kind::kWrong, "/segments/1/type", "F-F-Q");
  expect(Kind::kPermitted, "/segments/2/type", "E-F-V");
  for (const char* type : {"E-E-V", "E-F-F", "F-F-E", "Q", ""}) expect(Kind::kWrong, "/segments/2/type", type);
  expect(Kind::kWrong, "/segments/2/driver", {"0", "0", "0"});
  expect(Kind::kWrong, "/segments/2/end", {"1/2", "7/2", "0"});
  expect(Kind::kWrong, "/segments/2/end", {"-1", "11/2", "1"});
  expect(Kind::kWrong, "/segments/2/end", {"2", "3/2", "0"});
  expect(Kind::kWrong, "/segments/2/start_contact", {0, 2});
  expect(Kind::kWrong, "/segments/2/crossed_contact", {0, 1, 2});
  expect(Kind::kWrong, "/segments/2/end_contact", {0, 3});
  expect(Kind::kPermitted, "/segments/2/end_contact", nullptr);
  expect(Kind::kWrong, "/limit/squared_distance", "999");
  expect(Kind::kWrong, "/limit/contact", {0, 1, 2});
  expect(Kind::kWrong, "/limit/position", {"2", "3/2", "0"});
  expect(Kind::kWrong, "/limit", {{"kind", "infinity"}});
  EXPECT_EQ(gone_on({}, there), Kind::kWrong);
  // The first segment is whole.
  const Json half = Json::parse(R"({"type": "E-F-F", "driver": ["2","3/2","0"], "end": ["1/2","7/2","0"]})");
  const Json rest = Json::parse(R"({"type": "F-F-E", "driver": ["2","3/2","0"], "end": ["-1","11/2","0"]})");
  EXPECT_EQ(gone_on({half, rest}, there), Kind::kWrong);
  // From the second one to infinity; in which direction is not known.
  const Json infinity = {{"kind", "infinity"}};
  const Json away = Json::parse(R"({"type": "E-F-inf", "driver": ["-1","11/2","0"], "end": null,
    "start_contact": [0,2,3], "end_contact": null})");
  const auto expect_away = [&](Kind kind, const char* pointer, const Json& value) {
    EXPECT_EQ(gone_on({along_facet, away}, infinity, pointer, value), kind) << pointer << " " << value;
  };
  EXPECT_EQ(gone_on({along_facet, away}, infinity), Kind::kPermitted);
  expect_away(Kind::kPermitted, "/segments/3/type", "E-E-inf");
  for (const char* type : {"F-F-inf", "E-F-V", "E-Q-inf", "inf"}) expect_away(Kind::kWrong, "/segments/3/type", type);
  expect_away(Kind::kWrong, "/segments/3/driver", {"2", "3/2", "0"});
  expect_away(Kind::kWrong, "/segments/3/start_contact", {0, 2});
  expect_away(Kind::kWrong, "/segments/3/end_contact", {0, 2});
  expect_away(Kind::kWrong, "/segments/2/driver", {"0", "0", "0"});
  EXPECT_EQ(gone_on({along_facet, away}, there), Kind::kWrong);
  EXPECT_EQ(gone_on({along_facet, away, away}, infinity), Kind::kWrong);
  // From nowhere else.
  Json claim = orbit(false);
  claim["segments"].push_back(along_facet);
  claim["limit"] = there;
  EXPECT_EQ(kind_of(claim, orbit(false)), Kind::kWrong);
}

// Beyond a regular stationary point an orbit is followed to where it ends.
class FurtherOrbit : public testing::Test {
 protected:
  // From the middle of 0 and 1, along the Voronoi edge of 0, 1 and 2, and then as the flow takes it.
  FurtherOrbit() : end_({0, 0, 4}) {
    claimed_.segments.push_back({"E-E-V", {0, 0, 0}, end_, {{0, 1, 2}}, {{0, 1, 2}}, {{0, 1, 2, 3}}});
    const TruePath further = flow_->orbit(end_);
    RationalPoint start = end_;
    for (const TrueSegment& segment : further.segments) {
      RationalPoint inside;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        inside[axis] = segment.end ? (start[axis] + (*segment.end)[axis]) / 2 : 2 * start[axis] - segment.driver[axis];
      }
      claimed_.segments.push_back(
          {segment.type, segment.driver, segment.end, contact_of(start), contact_of(inside), {}});
      if (!segment.end) continue;
      start = *segment.end;
      claimed_.segments.back().end_contact = contact_of(start);
    }
    if (!further.limit) return;
    const auto contact = flow_->contact(*further.limit);
    const ExactSphere sphere = flow_->sphere(*further.limit);
    claimed_.limit = PathLimit{"critical",
                               std::to_string(flow_->index(*further.limit).face_dimension),
                               sphere.center,
                               {contact.begin(), contact.end()},
                               sphere.squared_radius};
  }

  [[nodiscard]] std::vector<PointId> contact_of(const RationalPoint& x) const {
    std::vector<PointId> contact;
    std::optional<Rational> least;
    for (PointId k = 0; k < rows_.size(); ++k) {
      const Rational square = geometry::squared_distance(x, rows_[k]);
      if (least && square > *least) continue;
      if (!least || square < *least) contact.clear();
      least = square;
      contact.push_back(k);
    }
    return contact;
  }

  template <typename Change>
  [[nodiscard]] bool is_permitted(const Change& change) {
    OrbitPath path = claimed_;
    change(path);
    const OrbitPath stays{{}, PathLimit{"regular", "[1,2]", {0, 0, 0}, {0, 1, 2}, 9}};
    const auto found = path_difference(path, stays, points_, *flow_);
    EXPECT_TRUE(found.has_value());
    return found && found->is_permitted;
  }

  std::vector<Point> rows_ = {{3, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {0, 3, 8}, {1, -9, 2}};
  PointSet points_{rows_};
  std::unique_ptr<Truth> flow_ = fast_truth(points_);
  RationalPoint end_;
  OrbitPath claimed_;
};

TEST_F(FurtherOrbit, IsTheOnlyOne) {
  CITES("FC-CLAIM-08", "FC-FLOW-05", "FC-FILE-27");
  ASSERT_GE(claimed_.segments.size(), 2U);
  ASSERT_EQ(contact_of(end_), (std::vector<PointId>{0, 1, 2, 3}));
  EXPECT_TRUE(is_permitted([](OrbitPath&) {}));
  EXPECT_FALSE(is_permitted([](OrbitPath& path) { path.segments.pop_back(); }));
  EXPECT_FALSE(is_permitted([](OrbitPath& path) { path.segments.push_back(path.segments.back()); }));
  for (std::size_t k = 1; k < claimed_.segments.size(); ++k) {
    const auto with = [&](const auto& change) {
      return is_permitted([&](OrbitPath& path) { change(path.segments[k]); });
    };
    const bool is_finite = claimed_.segments[k].end.has_value();
    EXPECT_FALSE(with([](PathSegment& one) { one.type = "Q"; }));
    for (const char letter : {'V', 'E', 'F'}) {
      if (!is_finite || claimed_.segments[k].type.back() == letter) continue;
      EXPECT_FALSE(with([letter](PathSegment& one) { one.type.back() = letter; })) << k << " " << letter;
    }
    EXPECT_FALSE(with([](PathSegment& one) { one.driver[0] += 1; }));
    EXPECT_FALSE(with([](PathSegment& one) { one.start_contact = {{4}}; }));
    EXPECT_FALSE(with([](PathSegment& one) { one.crossed_contact = {{4}}; }));
    EXPECT_FALSE(with([](PathSegment& one) { one.end_contact = {{4}}; }));
    EXPECT_TRUE(with([](PathSegment& one) { one.end_contact = one.crossed_contact = one.start_contact = {}; }));
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
