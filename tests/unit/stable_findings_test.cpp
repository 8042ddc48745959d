// check() on polylines, boundary walks, skeletons and surfaces (level 5): each claim is true but for one
// change, and the whole report is compared, word for word.
#include <gtest/gtest.h>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::stable_findings_test {
namespace {

const Ids kTriangle = {0, 1, 2};
const Ids kSaddleOfArch = {0, 3, 4};

// The report on a claim that is true but for one change to the point of this contact set.
template <typename Change>
std::string said(const Truly& truly, const Ids& contact, const Change& change) {
  Claimed claimed = truly.whole_claim();
  change(claimed.of(contact));
  return text(truly.check(claimed));
}

template <typename Change>
std::string said_of_skeleton(const Truly& truly, const Ids& contact, const Change& change) {
  return said(truly, contact, [&](ClaimedPoint& point) {
    const std::size_t before = point.skeleton->segments.size();
    change(*point.skeleton);
    // Orbits are claimed by the places of their segments.
    if (point.skeleton->segments.size() < before) point.skeleton->orbits.reset();
  });
}

// Moves the position by less than rounding may.
void nudge(ClaimedPosition& x) { x[0].value += Rational(1) / (Rational(1 << 30) * Rational(1 << 22)); }
void shift(ClaimedPosition& x) { x[0].value += Rational(1, 8); }

const std::string kAddedIsNotJudged =
    "\nnot judged: which pieces of a stable set a perturbation adds beyond a regular stationary point";

// ---- Polylines

TEST(PolylineFindings, OfEachPartOfASegment) {
  CITES("FC-CLAIM-08");
  const Truly points(kTetrahedron);
  const auto side = points.truth->limits(10).at(0) ? 0U : 1U;
  ASSERT_EQ(contact_of(*points.truth, 10), kTriangle);
  const std::string start = "index 2, contact set 0 1 2, side " + std::to_string(side) + ", ";
  const auto changed = [&](const auto& change) {
    return said(points, kTriangle, [&](ClaimedPoint& point) { change((*point.u2)[side]); });
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
    return said(points, kTriangle, [&](ClaimedPoint& point) { change((*point.u2)[side]); });
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
    const std::string on = said(arch, kTriangle, [&](ClaimedPoint& point) { go_on(point, 1, beyond, limit); });
    EXPECT_NE(on.find("\n5 symbolic-perturbation FC-CLAIM-07: index 2, contact set 0 1 2, side 1, 3 segments; 2 "
                      "segments, to a critical point of index 2, contact set 0 3 4"),
              std::string::npos)
        << on;
    EXPECT_EQ(on.find("perturbed\n4 "), 0U) << on;
    // The limit contradicts the polyline.
    const std::string other =
        said(arch, kTriangle, [&](ClaimedPoint& point) { go_on(point, 1, beyond, to({0, 3, 4})); });
    EXPECT_NE(other.find(start + "the limit 0 3 4; the polyline goes to a critical point of index 3"),
              std::string::npos)
        << other;
    // A segment beyond the maximum.
    const std::string more = said(arch, kTriangle, [&](ClaimedPoint& point) {
      go_on(point, 1, beyond, limit);
      (*point.u2)[1].push_back({});
    });
    EXPECT_NE(more.find(start + "4 segments; 3 segments, to "), std::string::npos) << more;
  }
  EXPECT_EQ(said(arch, kTriangle, [](ClaimedPoint& point) { (*point.u2)[1].push_back({}); }).find("fails\n" + start),
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
  [[nodiscard]] std::string said_of(const ClaimedSegment& first, const RationalPoint& from) const {
    return said(truly, saddle, [&](ClaimedPoint& point) {
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
    const std::string on = beyond->said_of({type, std::nullopt, exactly(end)}, end);
    EXPECT_EQ(on.find("perturbed\n"), 0U) << on;
    EXPECT_NE(on.find("5 symbolic-perturbation FC-CLAIM-07"), std::string::npos) << on;
    EXPECT_EQ(on.find("of a polyline lies beyond"), std::string::npos) << on;
    // The type, the end and what follows must be right.
    const auto fails_with = [&](const ClaimedSegment& first, const RationalPoint& from, const std::string& words) {
      const std::string wrong = beyond->said_of(first, from);
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
      const std::string unjudged = said(beyond->truly, beyond->saddle, [&](ClaimedPoint& point) {
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
    const std::string on = said(arch, kTriangle, [&](ClaimedPoint& point) {
      for (const TrueSegment& segment : arch.truth->polyline(saddle, side)) {
        (*point.u2)[1].push_back({segment.type, in_decimals(segment.driver), in_decimals(*segment.end)});
      }
      const auto contact = arch.truth->contact(*limit);
      (*point.successors)[1] = to({contact.begin(), contact.end()});
    });
    EXPECT_EQ(on.find("perturbed\n"), 0U) << on;
  }
}

// ---- What a stable set is made of

TEST(StableFindings, OfItsSize) {
  CITES("FC-CLAIM-10");
  const Truly points(kTetrahedron), arch(kArch);
  const auto alone = [](const Truly& truly, const Ids& contact, const ClaimedStable& stable) {
    return said(truly, contact, [&](ClaimedPoint& point) {
      point.stable = stable;
      point.skeleton.reset();
      point.surface.reset();
    });
  };
  const std::string start = "fails\n5 wrong-surface FC-CLAIM-10: index 2, contact set 0 1 2, ";
  EXPECT_EQ(alone(points, kTriangle, {3, {}, {}, {}, {}}), "conforms");
  EXPECT_EQ(alone(points, kTriangle, {{}, {}, false, {}, {}}), "conforms");
  EXPECT_EQ(alone(points, kTriangle, {4, {}, {}, {}, {}}), start + "4 segments; it has 3 segments");
  EXPECT_EQ(alone(points, kTriangle, {{}, true, {}, {}, {}}), start + "a Voronoi vertex; it has none");
  EXPECT_EQ(alone(points, kTriangle, {{}, {}, true, {}, {}}), start + "an interval; it has none");
  // A claim may leave out what lies beyond a Voronoi vertex, and add nothing.
  const std::string of_arch = " FC-CLAIM-10: index 2, contact set 0 3 4, ";
  EXPECT_EQ(alone(arch, kSaddleOfArch, {3, false, false, {}, {}}),
            "perturbed\n5 symbolic-perturbation" + of_arch + "3 segments; it has 8 segments" +
                "\n5 symbolic-perturbation" + of_arch + "no Voronoi vertex; it has one" + "\n5 symbolic-perturbation" +
                of_arch + "no interval; it has one");
  EXPECT_EQ(alone(arch, kSaddleOfArch, {2, {}, {}, {}, {}}),
            "fails\n5 wrong-surface" + of_arch + "2 segments; it has 8 segments");
  EXPECT_EQ(alone(arch, kSaddleOfArch, {777, {}, {}, {}, {}}),
            "fails\n5 wrong-surface" + of_arch + "777 segments; it has 8 segments");
  // It may add segments beyond a regular back.
  const Truly back(kRegularBack);
  const std::size_t count = back.truth->stable_summary(8).segments;
  EXPECT_EQ(alone(back, {0, 1, 3}, {count + 1, {}, {}, {}, {}}).find("perturbed\n5 "), 0U);
}

// ---- Walks

TEST(WalkFindings, WithoutATie) {
  CITES("FC-CLAIM-10", "FC-STAB-07");
  const Truly points(kTetrahedron);
  const auto walking = [&](const Ids& walk) {
    return said(points, kTriangle, [&](ClaimedPoint& point) { point.stable->walk = walk; });
  };
  const std::string start = "fails\n5 wrong-surface FC-CLAIM-10: index 2, contact set 0 1 2, walk ";
  for (const Ids& right : {Ids{1, 2, 0}, Ids{2, 1, 0}, Ids{0, 2, 1}}) EXPECT_EQ(walking(right), "conforms");
  EXPECT_EQ(walking({0, 1, 3}), start + "0 1 3; the walk is 0 1 2");
  EXPECT_EQ(walking({0, 1, 2, 3}), start + "0 1 2 3; the walk is 0 1 2");
  EXPECT_EQ(walking({}), start + "; the walk is 0 1 2");
}

TEST(WalkFindings, WhereThereIsATie) {
  CITES("FC-CLAIM-09", "FC-CLAIM-10");
  const Truly arch(kArch), regular(kRegularBack);
  const auto walking = [](const Truly& truly, const Ids& contact, const Ids& walk) {
    return said(truly, contact, [&](ClaimedPoint& point) { point.stable->walk = walk; });
  };
  const std::string start = "index 2, contact set 0 3 4, walking along ";
  EXPECT_EQ(walking(arch, kSaddleOfArch, {0, 1, 4, 3}), "conforms");
  EXPECT_EQ(walking(arch, kSaddleOfArch, {0, 2, 4, 3}), "conforms where determined\n5 tie-break FC-CLAIM-09: " + start +
                                                            "0 2, 2 4, 4 3, 3 0; another way to break ties");
  // This walk goes to a sample and back along the same edge.
  EXPECT_EQ(walking(arch, kSaddleOfArch, {0, 2, 0, 1, 4, 3}), "conforms");
  const std::string wrong = "fails\n5 wrong-surface FC-CHAIN-01: " + start;
  EXPECT_EQ(walking(arch, kSaddleOfArch, {0, 1, 2}), wrong + "0 1, 1 2, 2 0; no way to break ties gives this boundary");
  EXPECT_EQ(walking(arch, kSaddleOfArch, {0, 1, 2, 3}), wrong + "0 1, 1 2, 2 3, 3 0; 2 3 does not lie below it");
  EXPECT_EQ(walking(arch, kSaddleOfArch, {0, 0}), wrong + "0 0, 0 0; 0 0 is no critical point of index 1");
  // A walk may go through the hypotenuse of the right angle 0 2 3, or along its sides.
  EXPECT_EQ(walking(regular, {0, 1, 3}, {0, 2, 3, 1}), "conforms");
}

TEST(WalkFindings, OfRegularPoints) {
  CITES("FC-CLAIM-10", "FC-STAB-07");
  const Truly triangle(kRightTriangle), vertex(kKind13);
  const auto walking = [](const Truly& truly, const Ids& contact, const Ids& walk) {
    return said(truly, contact, [&](ClaimedPoint& point) { point.stable->walk = walk; });
  };
  EXPECT_EQ(walking(triangle, kTriangle, {0, 1}),
            "fails\n5 wrong-surface FC-CLAIM-10: regular, kind 1-2, contact set 0 1 2, walk 0 1; the walk is "
            "0 1 2");
  EXPECT_EQ(walking(vertex, {0, 1, 2, 3}, {0, 1}),
            "conforms\nnot judged: boundary walks of regular stationary points that are Voronoi vertices");
}

// ---- Skeletons

TEST(SkeletonFindings, OfEachPartOfASegment) {
  CITES("FC-CLAIM-10", "FC-STAB-04");
  const Truly points(kTetrahedron);
  const auto changed = [&](const auto& change) {
    return said_of_skeleton(points, kTriangle, [&](ClaimedSkeleton& skeleton) { change(skeleton.segments[0]); });
  };
  using Segment = ClaimedBackwardSegment;
  const std::string start = "FC-CLAIM-10: index 2, contact set 0 1 2, a segment of ";
  const std::string end = "; no such segment is part of it (in all 1 such claims)";
  const std::string as_it_is = "0 1 from 2/3 1/3 1/3 back to 1/2 1/2 0";
  const std::string wrong = "fails\n5 wrong-surface " + start;
  EXPECT_EQ(changed([](Segment& segment) {
              segment.front_contact.reset();
              segment.back_contact.reset();
              segment.back_kind.clear();
            }),
            "conforms");
  EXPECT_EQ(changed([](Segment& segment) { segment.samples = {0, 3}; }),
            wrong + "0 3 from 2/3 1/3 1/3 back to 1/2 1/2 0" + end);
  EXPECT_EQ(changed([](Segment& segment) { segment.front_contact = {{0, 1, 3}}; }), wrong + as_it_is + end);
  EXPECT_EQ(changed([](Segment& segment) { segment.back_contact = {{0, 2}}; }), wrong + as_it_is + end);
  EXPECT_EQ(changed([](Segment& segment) { segment.back_kind = "edge"; }), wrong + as_it_is + end);
  EXPECT_EQ(changed([](Segment& segment) { shift(segment.front); }),
            wrong + "0 1 from 19/24 1/3 1/3 back to 1/2 1/2 0" + end);
  EXPECT_EQ(changed([](Segment& segment) { shift(segment.back); }),
            wrong + "0 1 from 2/3 1/3 1/3 back to 5/8 1/2 0" + end);
  EXPECT_EQ(changed([](Segment& segment) { nudge(segment.back); }),
            "fails\n5 rounding " + start + "0 1 from 2/3 1/3 1/3 back to ~0.5000000000000002 1/2 0" + end);
}

TEST(SkeletonFindings, OfConnectingOrbits) {
  CITES("FC-CLAIM-10", "FC-STAB-06");
  const Truly points(kTetrahedron), arch(kArch);
  using Chains = std::vector<std::vector<std::size_t>>;
  const auto claiming = [](const Truly& truly, const Ids& contact, const auto& change) {
    return said_of_skeleton(truly, contact, [&](ClaimedSkeleton& skeleton) { change(*skeleton.orbits); });
  };
  const std::string start = "fails\n5 wrong-surface FC-CLAIM-10: index 2, contact set 0 1 2, ";
  EXPECT_EQ(claiming(points, kTriangle, [](Chains& chains) { std::swap(chains[0], chains[2]); }), "conforms");
  EXPECT_EQ(claiming(points, kTriangle, [](Chains& chains) { chains.pop_back(); }),
            start + "2 connecting orbits; 1 more go along the segments that are claimed");
  EXPECT_EQ(claiming(points, kTriangle, [](Chains& chains) { chains.push_back(chains[0]); }),
            start + "an orbit along the segments 0; that is no connecting orbit, or it is there twice");
  EXPECT_EQ(claiming(points, kTriangle, [](Chains& chains) { chains[1] = {1, 2}; }),
            start + "an orbit along the segments 1 2; that is no connecting orbit, or it is there twice");
  EXPECT_EQ(claiming(points, kTriangle, [](Chains& chains) { chains[1].clear(); }),
            start + "an orbit along the segments of no number; that is no connecting orbit, or it is there twice");
  EXPECT_NE(claiming(points, kTriangle, [](Chains& chains) { chains[1].assign(1, 3); })
                .find("1 malformed FC-CLAIM-01: index 2, contact set 0 1 2; of a stable set: an orbit along a segment "
                      "that is not there\n"),
            std::string::npos);
  // An orbit through a segment that is left out is left out, too.
  const std::string less = said(arch, kSaddleOfArch, [&](ClaimedPoint& point) {
    ClaimedSkeleton& skeleton = *point.skeleton;
    const std::size_t none = skeleton.segments.size();
    std::vector<std::size_t> place;  // after the segments from a Voronoi vertex are gone
    std::vector<ClaimedBackwardSegment> kept;
    for (const ClaimedBackwardSegment& segment : skeleton.segments) {
      const bool is_kept = segment.front_contact->size() != 4;
      place.push_back(is_kept ? kept.size() : none);
      if (is_kept) kept.push_back(segment);
    }
    std::erase_if(*skeleton.orbits, [&](const auto& chain) {
      return std::ranges::any_of(chain, [&](std::size_t k) { return place[k] == none; });
    });
    for (auto& chain : *skeleton.orbits) {
      for (std::size_t& k : chain) k = place[k];
    }
    skeleton.segments = kept;
  });
  EXPECT_EQ(less,
            "perturbed\n5 symbolic-perturbation FC-CLAIM-10: index 2, contact set 0 3 4; 5 segments beyond a Voronoi "
            "vertex are left out");
}

TEST(SkeletonFindings, OfPiecesTooFewOrTooMany) {
  CITES("FC-CLAIM-10");
  const Truly points(kTetrahedron);
  const std::string start = "fails\n5 wrong-surface FC-CLAIM-10: index 2, contact set 0 1 2, ";
  EXPECT_EQ(
      said_of_skeleton(points, kTriangle, [](ClaimedSkeleton& skeleton) { std::ranges::reverse(skeleton.segments); }),
      "conforms");
  EXPECT_EQ(said_of_skeleton(points, kTriangle, [](ClaimedSkeleton& skeleton) { skeleton.segments.resize(1); }),
            start + "too few; 2 segments are missing");
  EXPECT_EQ(said_of_skeleton(points, kTriangle,
                             [](ClaimedSkeleton& skeleton) {
                               skeleton.segments.push_back(skeleton.segments[1]);
                               skeleton.segments.push_back(skeleton.segments[2]);
                             }),
            start +
                "a segment of 0 2 from 2/3 1/3 1/3 back to 1/2 0 1/2; no such segment is part of it (in "
                "all 2 such claims)");
}

TEST(SkeletonFindings, BeyondAVoronoiVertex) {
  CITES("FC-CLAIM-10");
  const Truly arch(kArch);
  const std::string start = "index 2, contact set 0 3 4";
  const auto left_out = [&](const std::string& what) {
    return "perturbed\n5 symbolic-perturbation FC-CLAIM-10: " + start + "; " + what +
           "s beyond a Voronoi vertex are left out";
  };
  EXPECT_EQ(said_of_skeleton(arch, kSaddleOfArch,
                             [](ClaimedSkeleton& skeleton) {
                               std::erase_if(skeleton.segments,
                                             [](const auto& segment) { return segment.front_contact->size() == 4; });
                             }),
            left_out("5 segment"));
  EXPECT_EQ(said_of_skeleton(arch, kSaddleOfArch, [](ClaimedSkeleton& skeleton) { skeleton.intervals.clear(); }),
            left_out("2 interval"));
  EXPECT_EQ(said_of_skeleton(arch, kSaddleOfArch, [](ClaimedSkeleton& skeleton) { skeleton.sectors.resize(5); }),
            left_out("1 sector"));
  // The point's own segments are not beyond the vertex.
  EXPECT_EQ(said_of_skeleton(arch, kSaddleOfArch,
                             [](ClaimedSkeleton& skeleton) {
                               std::erase_if(skeleton.segments,
                                             [](const auto& segment) { return segment.front_contact->size() == 3; });
                             }),
            "fails\n5 wrong-surface FC-CLAIM-10: " + start + ", too few; 3 segments are missing");
}

TEST(SkeletonFindings, OfIntervalsAndSectors) {
  CITES("FC-CLAIM-10", "FC-STAB-05");
  const Truly arch(kArch);
  const std::string start = "fails\n5 wrong-surface FC-CLAIM-10: index 2, contact set 0 3 4, ";
  const auto interval = [&](const auto& change) {
    return said_of_skeleton(arch, kSaddleOfArch, [&](ClaimedSkeleton& skeleton) { change(skeleton.intervals[0]); });
  };
  const std::string no_interval = "; no such interval is part of it (in all 1 such claims)";
  EXPECT_EQ(interval([](ClaimedInterval& one) { one.back_is_stationary.reset(); }), "conforms");
  EXPECT_EQ(interval([](ClaimedInterval& one) { one.back_is_stationary = false; }),
            start + "an interval of 0 1 2" + no_interval);
  EXPECT_EQ(interval([](ClaimedInterval& one) { one.polygon = {0, 1, 4}; }),
            start + "an interval of 0 1 4" + no_interval);
  EXPECT_EQ(interval([](ClaimedInterval& one) { shift(one.front); }), start + "an interval of 0 1 2" + no_interval);
  EXPECT_EQ(interval([](ClaimedInterval& one) { nudge(one.back); }),
            "fails\n5 rounding FC-CLAIM-10: index 2, contact set 0 3 4, an interval of 0 1 2" + no_interval);
  const auto sector = [&](const auto& change) {
    return said_of_skeleton(arch, kSaddleOfArch, [&](ClaimedSkeleton& skeleton) { change(skeleton.sectors[0]); });
  };
  const std::string no_sector = "a sector of 0 1; no such sector is part of it (in all 1 such claims)";
  EXPECT_EQ(sector([](ClaimedSector& one) { std::ranges::reverse(one.corners); }), "conforms");
  EXPECT_EQ(sector([](ClaimedSector& one) { one.corners.pop_back(); }), start + no_sector);
  EXPECT_EQ(sector([](ClaimedSector& one) { one.corners.clear(); }), start + no_sector);
  EXPECT_EQ(sector([](ClaimedSector& one) { shift(one.corners[1]); }), start + no_sector);
  EXPECT_EQ(sector([](ClaimedSector& one) { one.samples = {1, 3}; }),
            start + "a sector of 1 3; no such sector is part of it (in all 1 such claims)");
}

// Pieces may be added only beyond a regular back, nearer to their samples than it is, and only if no other
// piece is left out.
TEST(SkeletonFindings, BeyondARegularPoint) {
  CITES("FC-CLAIM-10");
  const Truly points(kRegularBack), none(kTetrahedron);
  const Ids saddle = {0, 1, 3};
  const auto added = [](const Truly& truly, const Ids& contact, const RationalPoint& front, std::size_t kept) {
    return said_of_skeleton(truly, contact, [&](ClaimedSkeleton& skeleton) {
      skeleton.segments.resize(kept);
      skeleton.segments.push_back({{0, 2}, exactly(front), exactly(RationalPoint{2, 1, Rational(1, 2)}), {}, {}, ""});
    });
  };
  const RationalPoint near = {Rational(3, 2), 1, Rational(1, 2)}, far = {0, 1, Rational(1, 2)};
  const std::string found = "FC-CLAIM-10: index 2, contact set 0 1 3";
  EXPECT_EQ(added(points, saddle, near, 3), "perturbed\n5 symbolic-perturbation " + found +
                                                "; 1 segments beyond a regular stationary point" + kAddedIsNotJudged);
  const std::string end = " 1 1/2 back to 2 1 1/2; no such segment is part of it (in all 1 such claims)";
  EXPECT_EQ(added(points, saddle, far, 3), "fails\n5 wrong-surface " + found + ", a segment of 0 2 from 0" + end);
  EXPECT_EQ(added(points, saddle, near, 2), "fails\n5 wrong-surface " + found + ", a segment of 0 2 from 3/2" + end);
  EXPECT_EQ(added(none, kTriangle, near, 3),
            "fails\n5 wrong-surface FC-CLAIM-10: index 2, contact set 0 1 2, a segment of 0 2 from 3/2" + end);
  // The segment goes up if it is the other way round.
  const std::string up = said_of_skeleton(points, saddle, [&](ClaimedSkeleton& skeleton) {
    skeleton.segments.push_back({{0, 2}, exactly(RationalPoint{2, 1, Rational(1, 2)}), exactly(near), {}, {}, ""});
  });
  EXPECT_TRUE(up.starts_with("fails\n5 wrong-surface ")) << up;
}

// ---- Surfaces

TEST(SurfaceFindings, OfTriangles) {
  CITES("FC-CLAIM-10", "FC-STAB-04");
  const Truly points(kTetrahedron);
  const auto changed = [&](const auto& change) {
    return said(points, kTriangle, [&](ClaimedPoint& point) { change(*point.surface); });
  };
  const std::string start = "FC-CLAIM-10: index 2, contact set 0 1 2, ";
  EXPECT_EQ(changed([](ClaimedSurface& surface) { std::swap(surface.triangles[0][0], surface.triangles[0][2]); }),
            "conforms");
  EXPECT_EQ(changed([](ClaimedSurface& surface) { surface.triangles.pop_back(); }),
            "fails\n5 wrong-surface " + start + "too few; 1 triangles are missing");
  EXPECT_EQ(changed([](ClaimedSurface& surface) { surface.triangles.push_back(surface.triangles[0]); }),
            "fails\n5 wrong-surface " + start +
                "a triangle 0 0 0 2/3 1/3 1/3 1/2 1/2 0; no such triangle is part of it (in all 1 such claims)");
  EXPECT_EQ(changed([](ClaimedSurface& surface) { shift(surface.vertices[0]); }),
            "fails\n5 wrong-surface " + start +
                "a triangle 1/8 0 0 2/3 1/3 1/3 1/2 1/2 0; no such triangle is part of it (in all 1 such claims)");
  EXPECT_EQ(changed([](ClaimedSurface& surface) { nudge(surface.vertices[2]); }),
            "fails\n5 rounding " + start +
                "a triangle 0 0 0 2/3 1/3 1/3 ~0.5000000000000002 1/2 0; no such triangle is part of it (in all "
                "1 such claims)");
}

// With a large tolerance, each triangle is near its neighbours. Those that come first do not take their places.
TEST(SurfaceFindings, OfTrianglesNearSeveralTrueOnes) {
  CITES("FC-CLAIM-10", "FC-CLAIM-24");
  const Truly points(kTetrahedron);
  const Claimed truth = points.whole_claim();
  for (const double tolerance : {0.5, 0.75, 0.9, 1.0}) {
    std::array<std::size_t, 6> order = {0, 1, 2, 3, 4, 5};
    do {
      Claimed claimed = truth;
      ClaimedSurface& surface = *claimed.of(kTriangle).surface;
      ASSERT_EQ(surface.triangles.size(), order.size());
      for (ClaimedPosition& vertex : surface.vertices) {
        for (ClaimedNumber& x : vertex) x.is_exact = false;
      }
      std::ranges::transform(order, surface.triangles.begin(),
                             [&](std::size_t k) { return std::array<std::size_t, 3>{3 * k, 3 * k + 1, 3 * k + 2}; });
      ASSERT_EQ(text(points.check(claimed, {.tolerance = tolerance})), "conforms");
    } while (std::ranges::next_permutation(order).found);
  }
}

TEST(SurfaceFindings, BeyondVerticesAndRegularPoints) {
  CITES("FC-CLAIM-10");
  const Truly points(kRegularBack), arch(kArch);
  const auto added = [&](const RationalPoint& third) {
    return said(points, {0, 1, 3}, [&](ClaimedPoint& point) {
      ClaimedSurface& surface = *point.surface;
      const std::size_t first = surface.vertices.size();
      for (const RationalPoint& x : {RationalPoint{2, 0, 1}, RationalPoint{2, 1, Rational(1, 2)}, third}) {
        surface.vertices.push_back(exactly(x));
      }
      surface.triangles.push_back({first, first + 1, first + 2});
    });
  };
  const std::string found = "FC-CLAIM-10: index 2, contact set 0 1 3";
  EXPECT_EQ(added({Rational(3, 2), 1, Rational(1, 2)}), "perturbed\n5 symbolic-perturbation " + found +
                                                            "; 1 triangles beyond a regular stationary point" +
                                                            kAddedIsNotJudged);
  EXPECT_EQ(added({-1, 1, Rational(1, 2)}),
            "fails\n5 wrong-surface " + found +
                ", a triangle 2 0 1 2 1 1/2 -1 1 1/2; no such triangle is part of it (in all 1 such claims)");
  EXPECT_EQ(said(arch, kSaddleOfArch, [](ClaimedPoint& point) { point.surface.emplace(); }),
            "conforms\nnot judged: surfaces of stable sets that have parts of dimension 3");
}

}  // namespace
}  // namespace flowcert::stable_findings_test
