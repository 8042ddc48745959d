// check() on boundary walks, skeletons and surfaces (level 5): each claim is true but for one change, and the whole
// report is compared, word for word.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::stable_findings_test {
namespace {

template <typename Change>
std::string said_of_skeleton(const Truly& truly, const Ids& contact, const Change& change) {
  return said_of(truly, contact, [&](ClaimedPoint& point) {
    const std::size_t before = point.skeleton->segments.size();
    change(*point.skeleton);
    // Orbits are claimed by the places of their segments.
    if (point.skeleton->segments.size() < before) point.orbits.reset();
  });
}

RationalPoint values(const ClaimedPosition& x) { return {x[0].value, x[1].value, x[2].value}; }

const std::string kAddedIsNotJudged =
    "\nnot judged: which pieces of a stable set a perturbation adds beyond a regular stationary point";

// ---- What a stable set is made of

TEST(StableFindings, OfItsSize) {
  CITES("FC-CLAIM-10");
  const Truly points(kTetrahedron), arch(kArch);
  const auto alone = [](const Truly& truly, const Ids& contact, const ClaimedStable& stable) {
    return said_of(truly, contact, [&](ClaimedPoint& point) {
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
    return said_of(points, kTriangle, [&](ClaimedPoint& point) { point.stable->walk = walk; });
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
    return said_of(truly, contact, [&](ClaimedPoint& point) { point.stable->walk = walk; });
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
    return said_of(truly, contact, [&](ClaimedPoint& point) { point.stable->walk = walk; });
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
    return said_of_skeleton(points, kTriangle,
                            [&](StableSet<ClaimedPosition>& skeleton) { change(skeleton.segments[0]); });
  };
  using Segment = BackwardSegment<ClaimedPosition>;
  const std::string start = "FC-CLAIM-10: index 2, contact set 0 1 2, a segment of ";
  const std::string end = "; no such segment is part of it (in all 1 such claims)";
  const std::string as_it_is = "0 1 from 2/3 1/3 1/3 back to 1/2 1/2 0";
  const std::string wrong = "fails\n5 wrong-surface " + start;
  EXPECT_EQ(changed([](Segment& segment) {
              segment.front_contact.reset();
              segment.back_contact.reset();
              segment.back_kind.reset();
            }),
            "conforms");
  EXPECT_EQ(changed([](Segment& segment) { segment.samples = {0, 3}; }),
            wrong + "0 3 from 2/3 1/3 1/3 back to 1/2 1/2 0" + end);
  EXPECT_EQ(changed([](Segment& segment) { segment.front_contact = {{0, 1, 3}}; }), wrong + as_it_is + end);
  EXPECT_EQ(changed([](Segment& segment) { segment.back_contact = {{0, 2}}; }), wrong + as_it_is + end);
  EXPECT_EQ(changed([](Segment& segment) { segment.back_kind = BackKind::kEdge; }), wrong + as_it_is + end);
  EXPECT_EQ(changed([](Segment& segment) { shift(segment.front.position); }),
            wrong + "0 1 from 19/24 1/3 1/3 back to 1/2 1/2 0" + end);
  EXPECT_EQ(changed([](Segment& segment) { shift(segment.back.position); }),
            wrong + "0 1 from 2/3 1/3 1/3 back to 5/8 1/2 0" + end);
  EXPECT_EQ(changed([](Segment& segment) { nudge(segment.back.position); }),
            "fails\n5 rounding " + start + "0 1 from 2/3 1/3 1/3 back to ~0.5000000000000002 1/2 0" + end);
}

TEST(SkeletonFindings, OfConnectingOrbits) {
  CITES("FC-CLAIM-10", "FC-STAB-06");
  const Truly points(kTetrahedron), arch(kArch);
  using Chains = std::vector<std::vector<std::size_t>>;
  const auto claiming = [](const Truly& truly, const Ids& contact, const auto& change) {
    return said_of(truly, contact, [&](ClaimedPoint& point) { change(*point.orbits); });
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
  const std::string less = said_of(arch, kSaddleOfArch, [&](ClaimedPoint& point) {
    StableSet<ClaimedPosition>& skeleton = *point.skeleton;
    const std::size_t none = skeleton.segments.size();
    std::vector<std::size_t> place;  // after the segments from a Voronoi vertex are gone
    std::vector<BackwardSegment<ClaimedPosition>> kept;
    for (const BackwardSegment<ClaimedPosition>& segment : skeleton.segments) {
      const bool is_kept = segment.front_contact->size() != 4;
      place.push_back(is_kept ? kept.size() : none);
      if (is_kept) kept.push_back(segment);
    }
    std::erase_if(*point.orbits, [&](const auto& chain) {
      return std::ranges::any_of(chain, [&](std::size_t k) { return place[k] == none; });
    });
    for (auto& chain : *point.orbits) {
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
  EXPECT_EQ(said_of_skeleton(points, kTriangle,
                             [](StableSet<ClaimedPosition>& skeleton) { std::ranges::reverse(skeleton.segments); }),
            "conforms");
  EXPECT_EQ(
      said_of_skeleton(points, kTriangle, [](StableSet<ClaimedPosition>& skeleton) { skeleton.segments.resize(1); }),
      start + "too few; 2 segments are missing");
  EXPECT_EQ(said_of_skeleton(points, kTriangle,
                             [](StableSet<ClaimedPosition>& skeleton) {
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
                             [](StableSet<ClaimedPosition>& skeleton) {
                               std::erase_if(skeleton.segments,
                                             [](const auto& segment) { return segment.front_contact->size() == 4; });
                             }),
            left_out("5 segment"));
  EXPECT_EQ(
      said_of_skeleton(arch, kSaddleOfArch, [](StableSet<ClaimedPosition>& skeleton) { skeleton.intervals.clear(); }),
      left_out("2 interval"));
  EXPECT_EQ(
      said_of_skeleton(arch, kSaddleOfArch, [](StableSet<ClaimedPosition>& skeleton) { skeleton.sectors.resize(5); }),
      left_out("1 sector"));
  // The point's own segments are not beyond the vertex.
  EXPECT_EQ(said_of_skeleton(arch, kSaddleOfArch,
                             [](StableSet<ClaimedPosition>& skeleton) {
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
    return said_of_skeleton(arch, kSaddleOfArch,
                            [&](StableSet<ClaimedPosition>& skeleton) { change(skeleton.intervals[0]); });
  };
  const std::string no_interval = "; no such interval is part of it (in all 1 such claims)";
  EXPECT_EQ(interval([](BackwardInterval<ClaimedPosition>& one) { one.back_is_stationary.reset(); }), "conforms");
  EXPECT_EQ(interval([](BackwardInterval<ClaimedPosition>& one) { one.back_is_stationary = false; }),
            start + "an interval of 0 1 2" + no_interval);
  EXPECT_EQ(interval([](BackwardInterval<ClaimedPosition>& one) { one.polygon = {0, 1, 4}; }),
            start + "an interval of 0 1 4" + no_interval);
  EXPECT_EQ(interval([](BackwardInterval<ClaimedPosition>& one) { shift(one.front.position); }),
            start + "an interval of 0 1 2" + no_interval);
  EXPECT_EQ(interval([](BackwardInterval<ClaimedPosition>& one) { nudge(one.back.position); }),
            "fails\n5 rounding FC-CLAIM-10: index 2, contact set 0 3 4, an interval of 0 1 2" + no_interval);
  const auto sector = [&](const auto& change) {
    return said_of_skeleton(arch, kSaddleOfArch,
                            [&](StableSet<ClaimedPosition>& skeleton) { change(skeleton.sectors[0]); });
  };
  const std::string no_sector = "a sector of 0 1; no such sector is part of it (in all 1 such claims)";
  EXPECT_EQ(sector([](Region<ClaimedPosition>& one) { std::ranges::reverse(one.corners); }), "conforms");
  EXPECT_EQ(sector([](Region<ClaimedPosition>& one) { one.corners.pop_back(); }), start + no_sector);
  EXPECT_EQ(sector([](Region<ClaimedPosition>& one) { one.corners.clear(); }), start + no_sector);
  EXPECT_EQ(sector([](Region<ClaimedPosition>& one) { shift(one.corners[1].position); }), start + no_sector);
  EXPECT_EQ(sector([](Region<ClaimedPosition>& one) { one.samples = {1, 3}; }),
            start + "a sector of 1 3; no such sector is part of it (in all 1 such claims)");
}

// Pieces may be added only beyond a regular back, nearer to their samples than it is, and only if no other
// piece is left out.
TEST(SkeletonFindings, BeyondARegularPoint) {
  CITES("FC-CLAIM-10");
  const Truly points(kRegularBack), none(kTetrahedron);
  const Ids saddle = {0, 1, 3};
  const auto added = [](const Truly& truly, const Ids& contact, const RationalPoint& front, std::size_t kept) {
    return said_of_skeleton(truly, contact, [&](StableSet<ClaimedPosition>& skeleton) {
      skeleton.segments.resize(kept);
      skeleton.segments.push_back(
          {{{0, 2}, {exactly(front)}, {exactly(RationalPoint{2, 1, Rational(1, 2)})}}, {}, {}, {}});
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
  const std::string up = said_of_skeleton(points, saddle, [&](StableSet<ClaimedPosition>& skeleton) {
    skeleton.segments.push_back(
        {{{0, 2}, {exactly(RationalPoint{2, 1, Rational(1, 2)})}, {exactly(near)}}, {}, {}, {}});
  });
  EXPECT_TRUE(up.starts_with("fails\n5 wrong-surface ")) << up;
}

// In decimals, with a large tolerance and in any order, a right claim conforms.
TEST(SkeletonFindings, OfOrbitsAlongSegmentsInAnyOrder) {
  CITES("FC-CLAIM-10", "FC-CLAIM-24");
  const Truly arch(kArch);
  Claimed truth = arch.whole_claim();
  truth.of(kSaddleOfArch).surface.reset();
  const std::size_t count = truth.of(kSaddleOfArch).skeleton->segments.size();
  std::vector<std::size_t> place(count);
  std::iota(place.begin(), place.end(), std::size_t{0});
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    Claimed claimed = truth;
    StableSet<ClaimedPosition>& skeleton = *claimed.of(kSaddleOfArch).skeleton;
    std::ranges::shuffle(place, random);
    for (std::size_t k = 0; k < count; ++k) {
      BackwardSegment<ClaimedPosition> segment = truth.of(kSaddleOfArch).skeleton->segments[k];
      segment = {
          {segment.samples, {decimals(values(segment.front.position))}, {decimals(values(segment.back.position))}},
          {},
          {},
          {}};
      skeleton.segments[place[k]] = segment;
    }
    for (auto& chain : *claimed.of(kSaddleOfArch).orbits) {
      for (std::size_t& k : chain) k = place[k];
    }
    ASSERT_EQ(text(arch.check(claimed)), "conforms");
    const CheckReport report = arch.check(claimed, {.tolerance = 1});
    ASSERT_EQ(report.verdict, Verdict::kConforms) << text(report);
  }
}

// ---- Surfaces

TEST(SurfaceFindings, OfTriangles) {
  CITES("FC-CLAIM-10", "FC-STAB-04");
  const Truly points(kTetrahedron);
  const auto changed = [&](const auto& change) {
    return said_of(points, kTriangle, [&](ClaimedPoint& point) { change(*point.surface); });
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

// What is there already is not what a perturbation adds.
TEST(SurfaceFindings, NothingIsAddedThatIsThere) {
  CITES("FC-CLAIM-10", "FC-CLAIM-24");
  const Truly points(kRegularBack);
  const Ids saddle = {0, 1, 3};
  Claimed truth = points.whole_claim();
  for (std::size_t k = 0; k < truth.of(saddle).surface->triangles.size(); ++k) {
    const std::string twice = said_of(
        points, saddle, [&](ClaimedPoint& point) { point.surface->triangles.push_back(point.surface->triangles[k]); });
    EXPECT_EQ(twice.find("fails\n"), 0U) << k << twice;
  }
  for (std::size_t k = 0; k < truth.of(saddle).skeleton->segments.size(); ++k) {
    const std::string twice = said_of(
        points, saddle, [&](ClaimedPoint& point) { point.skeleton->segments.push_back(point.skeleton->segments[k]); });
    EXPECT_EQ(twice.find("fails\n"), 0U) << k << twice;
  }
}

TEST(SurfaceFindings, BeyondVerticesAndRegularPoints) {
  CITES("FC-CLAIM-10");
  const Truly points(kRegularBack), arch(kArch);
  const auto added = [&](const RationalPoint& third) {
    return said_of(points, {0, 1, 3}, [&](ClaimedPoint& point) {
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
  EXPECT_EQ(said_of(arch, kSaddleOfArch, [](ClaimedPoint& point) { point.surface.emplace(); }),
            "conforms\nnot judged: surfaces of stable sets that have parts of dimension 3");
}

}  // namespace
}  // namespace flowcert::stable_findings_test
