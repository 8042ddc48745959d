// The oracle's stable sets against its flow, on small inputs of all families. All points that a skeleton
// stands for flow to its stationary point. Points on skeletons, near them and anywhere are in exactly the set
// of the point at which their orbit ends. Clauses that say the same in other words are checked too: signs,
// trees, boundary walks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace oracle::oracle_stable_families_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;

std::size_t below(rc::Random& random, std::size_t bound) { return static_cast<std::size_t>(random.next() % bound); }

long between(rc::Random& random, long low, long high) {
  return low + static_cast<long>(below(random, static_cast<std::size_t>(high - low + 1)));
}

// A small input, with the stable sets of all its stationary points but the maxima.
struct Subject {
  explicit Subject(const Rows& rows) : set(rows), all(stationary_points(rows).stationary) {
    for (const StationaryPoint& z : all) {
      if (z.face_dimension < 3) sets.emplace_back(z, stable_set(set, z));
    }
  }
  const Point& point(std::size_t name) const { return set.points[places_of(set, {name}).front()]; }

  PointSet set;
  std::vector<StationaryPoint> all;
  std::vector<std::pair<StationaryPoint, StableSet>> sets;
};

constexpr std::size_t kMostRows = 12;

// There are fewer rows where the run is scaled down, as for sanitizers: the oracle's time grows fast with them.
std::size_t most_rows_of_run() { return flowcert::property::scale_of_run() < 1 ? 8 : kMostRows; }

// Calls visit(subject, random) for inputs of at most so many rows: `seeds` of each family, and `made` of each
// family that is made for stable sets.
template <typename Visit>
void for_each_subject(std::uint64_t seeds, std::uint64_t made, const Visit& visit,
                      std::size_t most_rows = most_rows_of_run()) {
  const auto more = static_cast<std::uint64_t>(std::max(1.0, flowcert::property::scale_of_run()));
  flowcert_tests::for_each_drawn_set({more * seeds, more * made, most_rows}, [&](const Rows& rows, std::uint64_t seed) {
    rc::Random random(seed);
    if (!rows.empty()) visit(Subject(rows), random);
  });
}

// A random point in the relative interior of the points' convex hull.
Point mixture(const std::vector<Point>& points, rc::Random& random) {
  Rational sum = 0;
  Point mixed;
  for (const Point& p : points) {
    const Rational weight = between(random, 1, 9);
    sum += weight;
    mixed = moved(mixed, weight, p);
  }
  return {mixed[0] / sum, mixed[1] / sum, mixed[2] / sum};
}

// Returns where the orbit of x ends. That point's stable set contains x, and no other one does. No set
// contains x if the orbit ends at a maximum or at infinity.
std::optional<StationaryPoint> expect_sets_agree_with_flow(const Subject& subject, const Point& x) {
  auto limit = orbit(subject.set, x).limit;
  for (const auto& [z, stable] : subject.sets) {
    EXPECT_EQ(contains(subject.set, stable, x), limit == z)
        << x[0] << ' ' << x[1] << ' ' << x[2] << " and the set of " << ::testing::PrintToString(z.contact);
  }
  return limit;
}

// A piece of a skeleton: points whose convex hull is its closure, and the samples of its cones.
struct Piece {
  std::vector<Point> hull;
  Names apexes;
};

std::vector<Piece> pieces_of(const StableSet& stable) {
  std::vector<Piece> pieces;
  pieces.reserve(stable.points.size() + stable.segments.size());
  for (const SkeletonPoint& w : stable.points) pieces.push_back({{w.position}, w.contact});
  const auto add = [&](const std::vector<Corner>& corners, const Names& apexes) {
    Piece& piece = pieces.emplace_back(Piece{{}, apexes});
    for (const Corner& corner : corners) piece.hull.push_back(corner.position);
  };
  for (const BackwardSegment& s : stable.segments) add({s.front, s.back}, {s.samples[0], s.samples[1]});
  for (const EdgePart& i : stable.intervals) add({i.front, i.back}, i.polygon);
  for (const EdgePart& i : stable.crossed) add({i.front, i.back}, i.polygon);
  for (const Region& s : stable.sectors) add(s.corners, {s.samples[0], s.samples[1]});
  return pieces;
}

TEST(OracleStableFamilies, WhatASkeletonStandsForFlowsToItsPoint) {
  CITES("FC-STAB-01", "FC-STAB-02", "FC-STAB-04", "FC-STAB-05");
  for_each_subject(1, 2, [](const Subject& subject, rc::Random& random) {
    for (const auto& [z, stable] : subject.sets) {
      if (z.face_dimension == 0) continue;
      for (const Piece& piece : pieces_of(stable)) {
        const Point x = mixture(piece.hull, random);
        EXPECT_EQ(contact_set(subject.set, x), piece.apexes);
        EXPECT_EQ(expect_sets_agree_with_flow(subject, x), z);
        std::vector<Point> cone = piece.hull;
        cone.push_back(subject.point(piece.apexes[below(random, piece.apexes.size())]));
        EXPECT_EQ(expect_sets_agree_with_flow(subject, mixture(cone, random)), z);
      }
    }
  });
}

// The centre of some of the points, of at most so many.
Point random_centre(const std::vector<Point>& points, std::size_t most, rc::Random& random) {
  std::vector<Point> chosen;
  const std::size_t size = 1 + below(random, most);
  chosen.reserve(size);
  for (std::size_t k = 0; k < size; ++k) chosen.push_back(points[below(random, points.size())]);
  return circumcentre(spanning_subset(chosen))->center;
}

TEST(OracleStableFamilies, NothingNearASkeletonIsMissing) {
  CITES("FC-STAB-02", "FC-STAB-03");
  // A step leads from a point of the skeleton towards a centre of some of its contact points, or away from
  // it. A short step ends in one of the Voronoi faces around the point.
  for_each_subject(1, 2, [](const Subject& subject, rc::Random& random) {
    for (const auto& [z, stable] : subject.sets) {
      for (const Piece& piece : pieces_of(stable)) {
        const Point y = mixture(piece.hull, random);
        for (int k = 0; k < 2; ++k) {
          const Point aim = random_centre(select(subject.set.points, places_of(subject.set, piece.apexes)), 3, random);
          const Rational step(k == 0 ? -1 : 1, 1 << between(random, 1, 6));
          expect_sets_agree_with_flow(subject, moved(y, step, minus(aim, y)));
        }
      }
    }
  });
}

TEST(OracleStableFamilies, PointsAnywhereAreInTheSetOfTheirLimit) {
  CITES("FC-STAB-01", "FC-STAB-02");
  // The points are centres of random subsets, often on Voronoi vertices, edges and facets, and points in line
  // with two such centres.
  std::size_t points = 0, in_a_set = 0;
  for_each_subject(2, 20, [&](const Subject& subject, rc::Random& random) {
    for (int k = 0; k < 12; ++k) {
      const Point a = random_centre(subject.set.points, 4, random), b = random_centre(subject.set.points, 4, random);
      const Rational time = k % 3 == 0 ? Rational(0) : Rational(between(random, -1, 7), 3);
      const auto limit = expect_sets_agree_with_flow(subject, moved(a, time, minus(b, a)));
      ++points;
      if (limit && limit->face_dimension < 3) ++in_a_set;
    }
  });
  std::printf("%zu points, %zu of them in a stable set\n", points, in_a_set);
  EXPECT_GT(in_a_set * 5, points);
}

TEST(OracleStableFamilies, BesideATriangle) {
  CITES("FC-STAB-04", "FC-STAB-06");
  for_each_subject(1, 2, [](const Subject& subject, rc::Random& random) {
    for (const auto& [z, stable] : subject.sets) {
      if (!stable.intervals.empty()) continue;
      for (const auto& [p, front, back] : triangles(subject.set, stable)) {
        const Point normal = cross(minus(front, p), minus(back, p));
        const Point x = mixture({p, front, back}, random);
        const Rational step = Rational(1, 1 << 20) / (1 + dot(normal, normal));
        for (const Rational& side : {Rational(1), Rational(-1)}) {
          expect_sets_agree_with_flow(subject, moved(x, side * step, normal));
        }
      }
    }
  });
}

bool is_voronoi_vertex(const Subject& subject, const SkeletonPoint& y) {
  return affine_dimension(select(subject.set.points, places_of(subject.set, y.contact))) == 3;
}

// The polygons of conv C(y), for a Voronoi vertex y: the largest subsets of C(y) that lie in a plane with all
// other points on one side.
std::set<Names> polygons_at(const Subject& subject, const Names& contact) {
  std::set<Names> polygons;
  for_each_subset(contact.size(), 3, [&](const std::vector<std::size_t>& chosen) {
    if (chosen.size() < 3) return;
    const Point& a = subject.point(contact[chosen[0]]);
    const Point normal =
        cross(minus(subject.point(contact[chosen[1]]), a), minus(subject.point(contact[chosen[2]]), a));
    Names in_plane;
    std::set<int> sides;
    for (const std::size_t name : contact) {
      const int side = dot(normal, minus(subject.point(name), a)).sign();
      side == 0 ? in_plane.push_back(name) : void(sides.insert(side));
    }
    if (sides.size() == 1) polygons.insert(in_plane);
  });
  return polygons;
}

// h > 0 at all points of the polygon but p and q (FC-SIGN-01).
bool is_acute(const Subject& subject, const Names& polygon, std::size_t p, std::size_t q) {
  return std::all_of(polygon.begin(), polygon.end(), [&](std::size_t name) {
    const Point& x = subject.point(name);
    return name == p || name == q || dot(minus(x, subject.point(p)), minus(x, subject.point(q))) > 0;
  });
}

// Whether p q leads to the point with these polygons. It must be a side of two of them, or of the only one,
// and acute in each. A chord that is no side sees points of its polygon on both sides, and not all of them
// see it at acute angles.
bool leads_by_sign(const Subject& subject, const std::set<Names>& polygons, std::size_t p, std::size_t q) {
  std::size_t around = 0;
  for (const Names& polygon : polygons) {
    if (!std::binary_search(polygon.begin(), polygon.end(), p)) continue;
    if (!std::binary_search(polygon.begin(), polygon.end(), q)) continue;
    if (!is_acute(subject, polygon, p, q)) return false;
    ++around;
  }
  return around == (polygons.size() == 1 ? 1 : 2);
}

// Whether the polygon leads to o: s(o,f) > 0, and f contains z(f).
bool leads_by_sign(const Subject& subject, const SkeletonPoint& o, const Names& polygon) {
  const std::vector<Point> corners = select(subject.set.points, places_of(subject.set, polygon));
  const Point normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  const auto side = [&](const Point& x) { return dot(normal, minus(x, corners[0])).sign(); };
  const auto inside = std::find_if(o.contact.begin(), o.contact.end(),
                                   [&](std::size_t name) { return side(subject.point(name)) != 0; });
  return side(o.position) == side(subject.point(*inside)) &&
         face_dimension(corners, circumcentre({corners[0], corners[1], corners[2]})->center);
}

void expect_leads_as_signs_say(const Subject& subject, const StableSet& stable, const SkeletonPoint& y) {
  const bool is_vertex = is_voronoi_vertex(subject, y);
  const std::set<Names> polygons = is_vertex ? polygons_at(subject, y.contact) : std::set<Names>{y.contact};
  for_each_subset(y.contact.size(), 2, [&](const std::vector<std::size_t>& chosen) {
    if (chosen.size() < 2) return;
    const std::array<std::size_t, 2> g = {y.contact[chosen[0]], y.contact[chosen[1]]};
    const bool found = std::any_of(stable.segments.begin(), stable.segments.end(), [&](const BackwardSegment& segment) {
      return segment.front == y.position && segment.samples == g;
    });
    EXPECT_EQ(found, leads_by_sign(subject, polygons, g[0], g[1]));
  });
  for (const Names& polygon : polygons) {
    const bool found = std::any_of(stable.intervals.begin(), stable.intervals.end(), [&](const EdgePart& interval) {
      return interval.front == y.position && interval.polygon == polygon;
    });
    EXPECT_EQ(found, is_vertex && leads_by_sign(subject, y, polygon));
  }
}

TEST(OracleStableFamilies, WhatLeadsToAPointIsToldBySigns) {
  CITES("FC-STAB-03");
  for_each_subject(2, 20, [](const Subject& subject, rc::Random&) {
    for (const auto& [z, stable] : subject.sets) {
      if (z.hull_dimension < 2) continue;
      for (const SkeletonPoint& y : stable.points) expect_leads_as_signs_say(subject, stable, y);
    }
  });
}

TEST(OracleStableFamilies, WithoutVerticesAndIntervalsTheSegmentsFormATree) {
  CITES("FC-STAB-06");
  for_each_subject(2, 20, [](const Subject& subject, rc::Random&) {
    for (const auto& [z, stable] : subject.sets) {
      if (z.hull_dimension != 2 || stable.has_vertex) continue;
      EXPECT_TRUE(stable.intervals.empty());  // these begin at Voronoi vertices
      for (const SkeletonPoint& y : stable.points) {
        const auto begin = stable.segments.begin(), end = stable.segments.end();
        const auto on = std::count_if(begin, end, [&](const auto& s) { return s.front == y.position; });
        const auto in = std::count_if(begin, end, [&](const auto& s) { return s.back == y.position; });
        const bool all_sides = y.position == z.center && z.face_dimension == 2;
        EXPECT_EQ(in, y.position == z.center ? 0 : 1);
        EXPECT_EQ(on, static_cast<long>(y.contact.size()) - (all_sides ? 0 : 1));
      }
    }
  });
}

using Edge = std::array<std::size_t, 2>;

// Puts the member in, or takes it out. What is left was put in an odd number of times.
template <typename T>
void toggle(std::set<T>& odd, const T& member) {
  if (!odd.insert(member).second) odd.erase(member);
}

TEST(OracleStableFamilies, TheBoundaryWalkIsTheBoundaryOfTheTriangles) {
  CITES("FC-STAB-07");
  for_each_subject(2, 20, [](const Subject& subject, rc::Random&) {
    for (const auto& [z, stable] : subject.sets) {
      if (z.hull_dimension != 2 || stable.has_vertex) continue;
      std::set<std::set<Point>> sides;
      for (const auto& [p, front, back] : triangles(subject.set, stable)) {
        for (const std::set<Point>& side : {std::set{p, front}, std::set{p, back}, std::set{front, back}}) {
          toggle(sides, side);
        }
      }
      std::set<Edge> edges;
      const Names walk = boundary_walk(subject.set, z, stable);
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const auto [p, q] = std::minmax(walk[i], walk[(i + 1) % walk.size()]);
        EXPECT_LT(p, q);
        const Point m = moved(subject.point(p), Rational(1, 2), minus(subject.point(q), subject.point(p)));
        EXPECT_TRUE(std::any_of(subject.all.begin(), subject.all.end(),
                                [&](const auto& s) { return s.center == m && s.face_dimension == 1; }));
        toggle(edges, Edge{p, q});
        toggle(sides, {subject.point(p), m});
        toggle(sides, {subject.point(q), m});
      }
      EXPECT_TRUE(sides.empty());
      EXPECT_EQ(boundary_edges(stable), std::vector<Edge>(edges.begin(), edges.end()));
    }
  });
}

// Whether w is a Voronoi vertex of the skeleton that is no back of a segment or interval, nor z. Such a
// vertex was found between two sides through which a sector's rays leave.
bool is_within_a_sector(const Subject& subject, const StableSet& stable, const StationaryPoint& z,
                        const SkeletonPoint& w) {
  const auto is_back = [&](const auto& piece) { return piece.back == w.position; };
  return w.position != z.center && is_voronoi_vertex(subject, w) &&
         std::none_of(stable.segments.begin(), stable.segments.end(), is_back) &&
         std::none_of(stable.intervals.begin(), stable.intervals.end(), is_back) &&
         std::none_of(stable.crossed.begin(), stable.crossed.end(), is_back);
}

TEST(OracleStableFamilies, AllKindsOfPiecesAreMetAndNoneTwice) {
  CITES("FC-STAB-04", "FC-STAB-05");
  std::map<std::string, int> seen;
  const auto strictly_ascending = [](const auto& list, const auto& key) {
    return std::adjacent_find(list.begin(), list.end(),
                              [&](const auto& a, const auto& b) { return !(key(a) < key(b)); }) == list.end();
  };
  const auto position = [](const SkeletonPoint& y) { return y.position; };
  const auto way = [](const BackwardSegment& s) { return std::pair(s.samples, s.front); };
  for_each_subject(
      3, 40,
      [&](const Subject& subject, rc::Random&) {
        for (const auto& [z, stable] : subject.sets) {
          EXPECT_TRUE(strictly_ascending(stable.points, position) && strictly_ascending(stable.segments, way));
          EXPECT_TRUE(strictly_ascending(stable.intervals, std::identity{}) &&
                      strictly_ascending(stable.crossed, std::identity{}) &&
                      strictly_ascending(stable.sectors, std::identity{}));
          const std::string kind = std::to_string(z.face_dimension) + std::to_string(z.hull_dimension);
          ++seen["set of " + kind + (stable.intervals.empty() ? "" : ", intervals")];
          for (const auto& s : stable.segments) ++seen["segment " + std::to_string(static_cast<int>(s.back_kind))];
          for (const auto& i : stable.intervals) {
            ++seen[flow_segment(subject.set, i.back.position) ? "interval from a vertex" : "interval from a centre"];
          }
          seen["crossed interval"] += static_cast<int>(stable.crossed.size());
          for (const auto& s : stable.sectors) ++seen["sector of " + std::to_string(s.corners.size()) + " corners"];
          for (const auto& w : stable.points) {
            if (is_within_a_sector(subject, stable, z, w)) ++seen["vertex within a sector"];
          }
        }
      },
      kMostRows);
  for (const auto& [what, count] : seen) std::printf("%6d  %s\n", count, what.c_str());
  for (const char* what :
       {"segment 0", "segment 1", "segment 2", "segment 3", "interval from a centre", "interval from a vertex",
        "crossed interval", "sector of 3 corners", "sector of 4 corners", "vertex within a sector", "set of 12",
        "set of 13", "set of 13, intervals", "set of 22", "set of 22, intervals", "set of 23, intervals"}) {
    EXPECT_GT(seen[what], 0) << what;
  }
}

}  // namespace
}  // namespace oracle::oracle_stable_families_test
