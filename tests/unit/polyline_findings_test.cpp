// check() on polylines (level 5): each claim is true but for one change, and the whole report is compared, word for
// word.
#include <gtest/gtest.h>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::polyline_findings_test {
namespace {

TEST(PolylineFindings, OfEachPartOfASegment) {
  CITES("FC-CLAIM-08");
  const Truly points(kTetrahedron);
  const auto side = points.truth->limits(10).at(0) ? 0U : 1U;
  ASSERT_EQ(contact_of(*points.truth, 10), kTriangle);
  const std::string start = "index 2, contact set 0 1 2, side " + std::to_string(side) + ", ";
  const auto changed = [&](const auto& change) {
    return said_of(points, kTriangle, [&](ClaimedPoint& point) { change((*point.u2)[side]); });
  };
  const std::string wrong = "fails\n5 wrong-polyline FC-CLAIM-08: " + start;
  const std::string rounding = "fails\n5 rounding FC-CLAIM-08: " + start;
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line[0].type.clear(); }), "conforms");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line[0].driver.reset(); }), "conforms");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line[0].type = "V-V-V"; }),
            wrong + "segment 1: type V-V-V; type E-E-V");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { shift(*line[0].driver); }),
            wrong + "segment 1: driver 19/24 1/3 1/3; driver 2/3 1/3 1/3");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { nudge(*line[0].driver); }),
            rounding + "segment 1: driver ~0.6666666666666669 1/3 1/3; driver 2/3 1/3 1/3");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { shift(*line[0].end); }),
            wrong + "segment 1: end 5/8 1/2 1/2; end 1/2 1/2 1/2");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { nudge(*line[0].end); }),
            rounding + "segment 1: end ~0.5000000000000002 1/2 1/2; end 1/2 1/2 1/2");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line[0].end.reset(); }),
            wrong + "segment 1: end infinity; end 1/2 1/2 1/2");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line.clear(); }), wrong + "0 segments; 1 segments, to 1/2 1/2 1/2");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line.push_back(line[0]); }),
            wrong + "2 segments; 1 segments, to 1/2 1/2 1/2");
}

TEST(PolylineFindings, ToInfinity) {
  CITES("FC-CLAIM-08");
  const Truly points(kTetrahedron);
  const auto side = points.truth->limits(10).at(0) ? 1U : 0U;
  const std::string start =
      "fails\n5 wrong-polyline FC-CLAIM-08: index 2, contact set 0 1 2, side " + std::to_string(side) + ", ";
  const auto changed = [&](const auto& change) {
    return said_of(points, kTriangle, [&](ClaimedPoint& point) { change((*point.u2)[side]); });
  };
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line[0].end = exactly(RationalPoint{1, 2, 3}); }),
            start + "segment 1: end 1 2 3; end infinity");
  EXPECT_EQ(changed([](ClaimedPolyline& line) { line.push_back(line[0]); }),
            start + "2 segments; 1 segments, to infinity");
}

// The claimed polyline of one side, and the limit there, go on beyond the end of the true orbit.
void go_on(ClaimedPoint& point, std::size_t side, const TruePath& path, const ClaimedTarget& limit) {
  for (const TrueSegment& segment : path.segments) {
    ClaimedSegment& claimed = (*point.u2)[side].emplace_back();
    claimed = {segment.type, exactly(segment.driver), std::nullopt};
    if (segment.end) claimed.end = exactly(*segment.end);
  }
  (*point.successors)[side] = limit;
}

// A polyline that goes to infinity, as it should, beside a limit that is a point: both levels say so.
TEST(PolylineFindings, ToInfinityAndALimit) {
  CITES("FC-CLAIM-06", "FC-FLOW-07");
  const Truly points(kTetrahedron);
  Claimed claimed = points.whole_claim();
  ClaimedPoint& saddle = claimed.of({0, 1, 2});
  const std::size_t side = saddle.successors->at(0).is_infinity ? 0 : 1;
  saddle.successors->at(side) = to({0, 1, 2, 3});
  const CheckReport report = points.check(claimed);
  EXPECT_EQ(count(report, FindingReason::kWrongIncidence), 1U) << text(report);
  EXPECT_EQ(count(report, FindingReason::kWrongPolyline), 1U) << text(report);
}

TEST(PolylineFindings, BeyondASaddle) {
  CITES("FC-CLAIM-07", "FC-CLAIM-08");
  const Truly arch(kArch);
  const std::size_t saddle = arch.record_of(kSaddleOfArch);
  const std::string start = "5 wrong-polyline FC-CLAIM-08: index 2, contact set 0 1 2, side 1, ";
  for (std::size_t side = 0; side < 2; ++side) {
    const TruePath beyond = {arch.truth->polyline(saddle, side), arch.truth->limits(saddle).at(side)};
    const auto contact = arch.truth->contact(*beyond.limit);
    const ClaimedTarget limit = to({contact.begin(), contact.end()});
    const std::string on = said_of(arch, kTriangle, [&](ClaimedPoint& point) { go_on(point, 1, beyond, limit); });
    EXPECT_NE(on.find("\n5 symbolic-perturbation FC-CLAIM-07: index 2, contact set 0 1 2, side 1, 3 segments; 2 "
                      "segments, to a critical point of index 2, contact set 0 3 4"),
              std::string::npos)
        << on;
    EXPECT_EQ(on.find("perturbed\n4 "), 0U) << on;
    // The limit contradicts the polyline.
    const std::string other =
        said_of(arch, kTriangle, [&](ClaimedPoint& point) { go_on(point, 1, beyond, to({0, 3, 4})); });
    EXPECT_NE(other.find(start + "the limit 0 3 4; the polyline goes to a critical point of index 3"),
              std::string::npos)
        << other;
    // A segment beyond the maximum.
    const std::string more = said_of(arch, kTriangle, [&](ClaimedPoint& point) {
      go_on(point, 1, beyond, limit);
      (*point.u2)[1].push_back({});
    });
    EXPECT_NE(more.find(start + "4 segments; 3 segments, to "), std::string::npos) << more;
  }
  EXPECT_EQ(said_of(arch, kTriangle, [](ClaimedPoint& point) { (*point.u2)[1].push_back({}); }).find("fails\n" + start),
            0U);
}

// From the saddle 0 2 3 an orbit goes to a regular stationary point of kind 2-3. Beyond it, the Voronoi edge of 0 3 4
// comes to a Voronoi vertex, because of the last sample.
const std::vector<Point> kBeyond23 = {{0, 0, 3}, {1, 3, 1}, {0, 2, 2}, {1, 0, 2}, {0, 0, 1}, {-6, 3, 5}};
// From the saddle 0 1 2 an orbit goes to a regular stationary point of kind 1-3, at 1/2 5/2 3/2. Beyond it is the
// Voronoi facet of 0 3. In the direction 1 4 1 it ends because of the last sample.
const std::vector<Point> kBeyond13 = {{0, 3, 0}, {0, 2, 3}, {2, 2, 1}, {1, 2, 3}, {6, 14.5, 4.5}};

struct Beyond {
  Beyond(const std::vector<Point>& rows, Ids from, RationalPoint position)
      : truly(rows), saddle(std::move(from)), end(std::move(position)) {}

  // What check() says if the polyline goes on with this segment and then as the orbit of its end.
  [[nodiscard]] std::string said(const ClaimedSegment& first, const RationalPoint& from) const {
    return said_of(truly, saddle, [&](ClaimedPoint& point) {
      const std::size_t side = (*point.successors)[0].is_infinity ? 1 : 0;
      const TruePath rest = truly.truth->orbit(from);
      (*point.u2)[side].push_back(first);
      ClaimedTarget limit = kInfinity;
      if (rest.limit) limit = to({truly.truth->contact(*rest.limit).begin(), truly.truth->contact(*rest.limit).end()});
      go_on(point, side, rest, limit);
    });
  }

  Truly truly;
  Ids saddle;
  RationalPoint end;  // of a segment that leaves the regular point
};

TEST(PolylineFindings, BeyondARegularPoint) {
  CITES("FC-CLAIM-07", "FC-CLAIM-08");
  const Rational t(361, 226);
  const Beyond of_23(kBeyond23, {0, 2, 3}, {Rational(-97, 24), Rational(3, 4), 2});
  const Beyond of_13(kBeyond13, {0, 1, 2}, {Rational(1, 2) + t, Rational(5, 2) + 4 * t, Rational(3, 2) + t});
  for (const Beyond* beyond : {&of_23, &of_13}) {
    const RationalPoint& end = beyond->end;
    const std::string type = beyond == &of_23 ? "V-E-V" : "V-F-E";
    const std::string on = beyond->said({type, std::nullopt, exactly(end)}, end);
    EXPECT_EQ(on.find("perturbed\n"), 0U) << on;
    EXPECT_NE(on.find("5 symbolic-perturbation FC-CLAIM-07"), std::string::npos) << on;
    EXPECT_EQ(on.find("of a polyline lies beyond"), std::string::npos) << on;
    // The type, the end and what follows must be right.
    const auto fails_with = [&](const ClaimedSegment& first, const RationalPoint& from, const std::string& words) {
      const std::string wrong = beyond->said(first, from);
      EXPECT_EQ(wrong.find("fails\n"), 0U) << wrong;
      EXPECT_NE(wrong.find(words), std::string::npos) << wrong;
    };
    fails_with({"V-E-E", std::nullopt, exactly(end)}, end, "segment 2: type V-E-E; type " + type);
    fails_with({"", exactly(end), exactly(end)}, end, "segment 2: driver ");
    const std::string no_way = "no perturbation lets the orbit go there from the regular stationary point";
    const RationalPoint farther = {2 * end[0], 2 * end[1], 2 * end[2]};
    fails_with({"", std::nullopt, exactly(farther)}, farther, no_way);
    const RationalPoint y = beyond == &of_23 ? RationalPoint{0, Rational(3, 4), 2}
                                             : RationalPoint{Rational(1, 2), Rational(5, 2), Rational(3, 2)};
    const RationalPoint beyond_it = {2 * end[0] - y[0], 2 * end[1] - y[1], 2 * end[2] - y[2]};
    fails_with({"", std::nullopt, exactly(beyond_it)}, beyond_it, no_way);
    // The Voronoi edge of the saddle comes to y. Nothing flows back along it, to its other end.
    const std::size_t record = beyond->truly.record_of(beyond->saddle);
    for (std::size_t side = 0; side < 2; ++side) {
      const auto back = beyond->truly.truth->polyline(record, side).front().end;
      if (back && *back != y) fails_with({"", std::nullopt, exactly(*back)}, *back, no_way);
    }
    const RationalPoint half = {(y[0] + end[0]) / 2, (y[1] + end[1]) / 2, (y[2] + end[2]) / 2};
    fails_with({"", std::nullopt, exactly(half)}, half, no_way);
    fails_with({"", std::nullopt, exactly(y)}, y, no_way);
    fails_with({"", std::nullopt, exactly(end)}, y, "segments");
    // A position in decimals does not tell where it goes on, nor does infinity.
    for (const ClaimedSegment& first : {ClaimedSegment{"", std::nullopt, decimals(end)}, ClaimedSegment{}}) {
      const std::string unjudged = said_of(beyond->truly, beyond->saddle, [&](ClaimedPoint& point) {
        (*point.u2)[(*point.successors)[0].is_infinity ? 1 : 0].push_back(first);
      });
      EXPECT_EQ(unjudged.find("perturbed\n"), 0U) << unjudged;
      EXPECT_NE(unjudged.find("not judged: what of a polyline lies beyond a regular stationary point"),
                std::string::npos);
      // Its driver is known all the same, and so are the first and the last letter of its type.
      ClaimedSegment driven = first;
      driven.driver = exactly(end);
      fails_with(driven, end, "segment 2: driver ");
      ClaimedSegment typed = first;
      typed.type = first.end ? "V-F-inf" : "V-F-E";
      fails_with(typed, end, "segment 2: type ");
    }
    fails_with(ClaimedSegment{}, end, "segment 2: end infinity; nothing comes after it");
  }
}

// In decimals the first ends of both orbits of the saddle 0 3 4 are near each other. The nearer one is meant.
TEST(PolylineFindings, BeyondASaddleInDecimals) {
  CITES("FC-CLAIM-05", "FC-CLAIM-08");
  const double x = 1.0801234498;  // the two maxima are 1.3e-10 apart
  const Truly arch({{0, 5, 0}, {-x, 0, -2}, {x, 0, -2}, {0, 0, 12}, {0, -5, 0}});
  const std::size_t saddle = arch.record_of(kSaddleOfArch);
  const auto in_decimals = [](const RationalPoint& at) {
    return decimals(
        {Rational(*nearest_double(at[0])), Rational(*nearest_double(at[1])), Rational(*nearest_double(at[2]))});
  };
  for (std::size_t side = 0; side < 2; ++side) {
    const auto limit = arch.truth->limits(saddle).at(side);
    ASSERT_TRUE(limit.has_value());
    const std::string on = said_of(arch, kTriangle, [&](ClaimedPoint& point) {
      for (const TrueSegment& segment : arch.truth->polyline(saddle, side)) {
        (*point.u2)[1].push_back({segment.type, in_decimals(segment.driver), in_decimals(*segment.end)});
      }
      const auto contact = arch.truth->contact(*limit);
      (*point.successors)[1] = to({contact.begin(), contact.end()});
    });
    EXPECT_EQ(on.find("perturbed\n"), 0U) << on;
  }
}

// The orbit of a saddle comes along a Voronoi facet to a regular stationary point of kind 1-2.
TEST(PolylineFindings, TheArrivalWhereItGoesOn) {
  CITES("FC-CLAIM-08", "FC-FLOW-02");
  const Truly points({{2, -2, 0}, {-1, 1, 2}, {-1, 1, -2}, {-2, 2, -1}, {2, 2, 2}, {-2, 0, 0}, {-1, 0, 2}});
  const Ids saddle = {2, 3, 5};
  const auto types = [&](const std::string& arriving, const std::optional<std::string>& leaving) {
    return said_of(points, saddle, [&](ClaimedPoint& point) {
      ClaimedPolyline& line = point.u2->at(1);
      ASSERT_EQ(line.size(), 2U);
      ASSERT_EQ(line[1].type, "V-F-E");
      line[1].type = arriving;
      if (!leaving) return;
      line.push_back({*leaving, std::nullopt, std::nullopt});
      point.successors->at(1) = kInfinity;
    });
  };
  EXPECT_EQ(types("V-F-E", std::nullopt), "conforms");
  const std::string start = "5 wrong-polyline FC-CLAIM-08: index 2, contact set 2 3 5, side 1, ";
  const auto expect_wrong = [&](const std::string& found, const std::string& words) {
    EXPECT_EQ(found.find("fails\n"), 0U) << found;
    EXPECT_NE(found.find(start + words), std::string::npos) << found;
  };
  expect_wrong(types("V-F-V", std::nullopt), "segment 2: type V-F-V; type V-F-E");
  for (const char* type : {"V-F-E", "V-F-V"}) {
    for (const char* leaving : {"E-F-inf", "E-E-inf", ""}) {
      const std::string on = types(type, leaving);
      EXPECT_EQ(on.find("perturbed\n"), 0U) << on;
    }
    expect_wrong(types(type, "E-Q-inf"), "segment 3: type E-Q-inf; there is no such type (FC-FLOW-02)");
    expect_wrong(types(type, "E-F-V"), "segment 3: type E-F-V; it begins with E and ends with inf");
  }
  for (const std::string type : {"V-F-F", "V-F-Q", "V-F-inf", "V-E-V", "F-F-E"}) {
    expect_wrong(types(type, "E-F-inf"), "segment 2: type " + type + "; type V-F-E");
  }
}

}  // namespace
}  // namespace flowcert::polyline_findings_test
