// What every stable set of the fast implementation keeps, whatever the input: against the oracle's flow,
// which follows orbits with scans over all points and knows nothing of stable sets.
//
// Guarantees: exact; the points that are flowed from are chosen in exact numbers, also those just beside a
// surface. Both kernels take turns. A run fails too when too few surfaces, Voronoi vertices, intervals or
// connecting orbits were met. The laws of chains and of persistence are in persistence_test.cpp.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "flowcert/stable_manifolds.h"
#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/orbit_starts.h"
#include "fuzz/properties/stable_pieces.h"
#include "fuzz/properties/subject.h"
#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/property/orbit_census.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"
#include "tests/property/stable_skeleton.h"

namespace flowcert::property::stable_invariants_test {
namespace {

using oracle::Point;
using oracle::StationaryPoint;
using oracle::Triangle;

constexpr std::size_t kSetsOfAnInput = 16;    // at most so many are flowed to, chosen at random
constexpr std::size_t kTrianglesOfASet = 6;   // at most so many, chosen at random
constexpr std::size_t kPointsOfAnInput = 8;   // anywhere
constexpr std::size_t kPiecesOfAnInput = 12;  // from which a point is taken
constexpr int kHalvings = 60;

// A stable set, as the fast implementation says, and as the oracle's functions want it.
struct FastSet {
  std::size_t number = 0;
  StationaryPoint z;
  StableSet<> pieces;
  oracle::StableSet skeleton;

  [[nodiscard]] bool is_surface() const { return pieces.intervals.empty(); }
};

struct FastSets {
  FastSets(const Subject& of, ConstructionKernel kernel)
      : subject(of),
        stationary(subject.complex.stationary()),
        manifolds(subject.complex.diagram(), stationary, {.kernel = kernel}) {
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
      const StationaryPoint z = oracle_point(subject.complex.points(), stationary, manifolds.record(i));
      const StableSet<> set = manifolds.set(i);
      sets.push_back({i, z, set, skeleton_of(subject.set, z, set)});
    }
  }
  [[nodiscard]] const Point& point(std::size_t name) const {
    return subject.set.points[oracle::places_of(subject.set, {name}).front()];
  }
  void require(bool holds, const std::string& complaint, const FastSet& set) const {
    if (holds) return;
    require_none(subject.input, complaint + ", in the set of " + text_of(set.z.contact), text_of(set.pieces));
  }

  const Subject& subject;
  StationaryPoints stationary;
  StableManifolds manifolds;
  std::vector<FastSet> sets;
};

std::size_t below(rc::Random& random, std::size_t bound) { return static_cast<std::size_t>(random.next() % bound); }

// At most so many of them, chosen at random, in their order.
template <typename T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most, rc::Random& random) {
  std::vector<T> chosen;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t wanted = most - chosen.size(), left = all.size() - k;
    if (wanted >= left || below(random, left) < wanted) chosen.push_back(all[k]);
  }
  return chosen;
}

// A random point in the relative interior of the points' convex hull.
Point mixture(const std::vector<Point>& points, rc::Random& random) {
  Rational sum = 0;
  Point mixed;
  for (const Point& p : points) {
    const Rational weight = 1 + below(random, 9);
    sum += weight;
    mixed = oracle::moved(mixed, weight, p);
  }
  return {mixed[0] / sum, mixed[1] / sum, mixed[2] / sum};
}

using Law = std::function<void(const FastSets&, rc::Random&)>;

// Returns whether the law held for so many inputs of each family, three times as many of stable families.
bool holds_for_inputs(int inputs, const Law& law) {
  bool held = true;
  const std::size_t common = fuzz::families().size();
  const std::vector<fuzz::Family> families = fuzz::families_and_stable_ones();
  for (std::size_t k = 0; k < families.size(); ++k) {
    const fuzz::Family& family = families[k];
    const rc::Gen<fuzz::Input> generator = family.generate();
    const auto property = [&] {
      const fuzz::Input input = *generator;
      rc::Random random(static_cast<std::uint64_t>(*fuzz::whole(0, 1'000'000).as("dice")));
      const Subject subject(input);
      if (subject.complex.points().empty()) return;
      constexpr std::array kKernels = {ConstructionKernel::kCascade, ConstructionKernel::kLazy,
                                       ConstructionKernel::kExact};
      law(FastSets(subject, kKernels[below(random, kKernels.size())]), random);
    };
    held = expect_holds(family.name, parameters_of_run(k < common ? inputs : 3 * inputs, held), property) && held;
  }
  return held;
}

bool is_closed_triangle_around(const Triangle& triangle, const Point& x) {
  const auto weights = oracle::barycentric({triangle[0], triangle[1], triangle[2]}, x);
  return weights && std::all_of(weights->begin(), weights->end(), [](const Rational& w) { return w >= 0; });
}

Point normal_of(const Triangle& t) { return oracle::cross(oracle::minus(t[1], t[0]), oracle::minus(t[2], t[0])); }

Rational largest_coordinate(const Point& a) {
  return std::max({Rational(abs(a[0])), Rational(abs(a[1])), Rational(abs(a[2]))});
}

// Whether the segment from x to y might meet the closed triangle, on which x is not. It does not if both ends
// are strictly on one side of the triangle's plane, or if the segment leaves the plane at x.
bool might_meet(const Triangle& triangle, const Point& x, const Point& y) {
  const Point normal = normal_of(triangle);
  const int at_x = oracle::dot(normal, oracle::minus(x, triangle[0])).sign();
  const int at_y = oracle::dot(normal, oracle::minus(y, triangle[0])).sign();
  return at_y == 0 || at_x * at_y < 0;
}

// A point straight above or below x, which is inside the k-th triangle. It is as far off as the triangle is
// large, or half of that, and so on, until the way there meets nothing else of the surface.
std::optional<Point> beside(const std::vector<Triangle>& surface, std::size_t k, const Point& x, int side) {
  const Point normal = normal_of(surface[k]);
  Rational step = side * largest_coordinate(oracle::minus(surface[k][1], surface[k][0])) / largest_coordinate(normal);
  for (int halvings = 0; halvings < kHalvings; ++halvings, step /= 2) {
    const Point y = oracle::moved(x, step, normal);
    bool is_free = true;
    for (std::size_t other = 0; other < surface.size() && is_free; ++other) {
      is_free = other == k || !might_meet(surface[other], x, y);
    }
    if (is_free) return y;
  }
  return std::nullopt;  // along the plane of another triangle
}

struct SurfacesSeen {
  std::size_t surfaces = 0, of_regular = 0, with_vertex = 0, triangles = 0, beside = 0, given_up = 0;
};

void require_flow_to_surface(const FastSets& all, const FastSet& set, rc::Random& random, SurfacesSeen& seen) {
  const oracle::PointSet& points = all.subject.set;
  const std::vector<Triangle> surface = oracle::triangles(points, set.skeleton);
  std::vector<std::size_t> places(surface.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  for (const std::size_t k : some_of(places, kTrianglesOfASet, random)) {
    const Point x = mixture({surface[k].begin(), surface[k].end()}, random);
    all.require(oracle::orbit(points, x).limit == set.z, text_of(x) + " of a triangle flows elsewhere", set);
    const auto around = std::count_if(surface.begin(), surface.end(),
                                      [&](const Triangle& t) { return is_closed_triangle_around(t, x); });
    all.require(around == 1, text_of(x) + " is on several triangles", set);
    ++seen.triangles;
    for (const int side : {1, -1}) {
      const std::optional<Point> y = beside(surface, k, x, side);
      ++(y ? seen.beside : seen.given_up);
      if (!y) continue;
      all.require(oracle::orbit(points, *y).limit != set.z, text_of(*y) + " beside the surface flows to it", set);
      all.require(!oracle::contains(points, set.skeleton, *y), text_of(*y) + " is beside and in it", set);
    }
  }
}

TEST(StableInvariants, SurfacesFlowToTheirPointAndWhatIsBesideThemDoesNot) {
  CITES("FC-STAB-01", "FC-STAB-04", "FC-STAB-06");
  SurfacesSeen seen;
  const bool held = holds_for_inputs(4, [&](const FastSets& all, rc::Random& random) {
    for (const FastSet& set : some_of(all.sets, kSetsOfAnInput, random)) {
      if (!set.is_surface()) continue;
      require_flow_to_surface(all, set, random, seen);
      ++seen.surfaces;
      seen.of_regular += set.z.face_dimension < set.z.hull_dimension ? 1 : 0;
      seen.with_vertex += set.skeleton.has_vertex ? 1 : 0;
    }
  });
  std::printf(
      "%zu surfaces, %zu of regular points, %zu with a Voronoi vertex; %zu triangles, %zu points beside "
      "them, "
      "%zu given up\n",
      seen.surfaces, seen.of_regular, seen.with_vertex, seen.triangles, seen.beside, seen.given_up);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.surfaces, 150U);
  EXPECT_GE(seen.of_regular, 35U);
  EXPECT_GE(seen.with_vertex, 7U);
  EXPECT_GE(seen.triangles, 1150U);
  EXPECT_LE(seen.given_up * 10, seen.beside);
}

using Side = std::array<Point, 2>;  // ascending

std::set<Side> sides_on_an_odd_number(const std::vector<Triangle>& surface) {
  std::set<Side> odd;
  for (const Triangle& t : surface) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      const Side side{a, b};
      if (!odd.insert(side).second) odd.erase(side);
    }
  }
  return odd;
}

struct BoundariesSeen {
  std::size_t surfaces = 0, with_vertex = 0, edges = 0, regular_edges = 0, inner_sides = 0, at_vertices = 0;
};

// The samples p, q that are nearest to m and have m as their midpoint. Then m is critical of index 1, or
// regular stationary, and pm and mq are S1 or would be. Nothing for another point.
std::vector<std::size_t> diameter_at(const FastSets& all, const Point& m, const Point& p) {
  const Point opposite = oracle::moved(m, 1, oracle::minus(m, p));
  std::vector<std::size_t> ends;
  for (const std::size_t name : oracle::contact_set(all.subject.set, m)) {
    if (all.point(name) == p || all.point(name) == opposite) ends.push_back(name);
  }
  return ends.size() == 2 ? ends : std::vector<std::size_t>{};
}

// The edges, by samples, that the sides on an odd number of triangles make up. A side from a sample to a
// Voronoi vertex is among them too, if only one edge with this sample leads to the vertex.
std::set<Ids> boundary_of(const FastSets& all, const FastSet& set, BoundariesSeen& seen) {
  const oracle::PointSet& points = all.subject.set;
  const std::vector<Triangle> surface = oracle::triangles(points, set.skeleton);
  const std::set<Side> odd = sides_on_an_odd_number(surface);
  std::set<Ids> edges;
  for (const auto& [a, b] : odd) {
    // One of the two is a sample.
    const bool a_is_sample = oracle::contact_set(points, a).size() == 1;
    const Point &p = a_is_sample ? a : b, &m = a_is_sample ? b : a;
    const std::vector<std::size_t> contact = oracle::contact_set(points, m);
    all.require(oracle::contact_set(points, p).size() == 1, "a side without sample is on one triangle", set);
    const std::vector<std::size_t> ends = diameter_at(all, m, p);
    const int dimension = oracle::affine_dimension(oracle::select(points.points, places_of(points, contact)));
    seen.at_vertices += ends.empty() ? 1 : 0;
    all.require(!ends.empty() || (set.skeleton.has_vertex && dimension == 3),
                "a side of one triangle is neither of S1 nor at a Voronoi vertex", set);
    if (ends.empty()) continue;
    const Point& q = all.point(all.point(ends[0]) == p ? ends[1] : ends[0]);
    const auto [low, high] = std::minmax(q, m);
    all.require(odd.contains({low, high}), "only one half of an edge is on the boundary", set);
    edges.insert(ends);
    seen.regular_edges += contact.size() > 2 ? 1 : 0;
  }
  seen.inner_sides += surface.size() * 3 - odd.size();
  seen.edges += edges.size();
  return edges;
}

// Without a tie all edges that are left are critical, and they are the boundary in the chain complex.
void require_chain_of(const FastSets& all, const FastSet& set, const std::set<Ids>& edges) {
  if (oracle::has_tie(set.skeleton) || set.z.face_dimension < set.z.hull_dimension) return;
  std::set<Ids> chain;
  for (const std::uint32_t record : all.manifolds.boundary(set.number)) {
    chain.insert(ids(all.stationary.contact(record)));
  }
  all.require(chain == edges, "boundary() is not the boundary of the triangles", set);
}

TEST(StableInvariants, OnlyEdgesOfS1AreOnOneTriangle) {
  CITES("FC-STAB-06", "FC-STAB-07", "FC-CHAIN-01");
  BoundariesSeen seen;
  const bool held = holds_for_inputs(25, [&](const FastSets& all, rc::Random&) {
    for (const FastSet& set : all.sets) {
      if (!set.is_surface()) continue;
      ++seen.surfaces;
      seen.with_vertex += set.skeleton.has_vertex ? 1 : 0;
      require_chain_of(all, set, boundary_of(all, set, seen));
    }
  });
  std::printf(
      "%zu surfaces, %zu with a Voronoi vertex; their boundaries have %zu edges, %zu halves of them at a "
      "regular point, and %zu sides at Voronoi vertices; %zu inner sides\n",
      seen.surfaces, seen.with_vertex, seen.edges, seen.regular_edges, seen.at_vertices, seen.inner_sides);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.surfaces, 1150U);
  EXPECT_GE(seen.with_vertex, 35U);
  EXPECT_GE(seen.edges, 3050U);
  EXPECT_GE(seen.regular_edges, 150U);
  EXPECT_GE(seen.at_vertices, 35U);
}

struct PlacesSeen {
  std::size_t points = 0, in_critical = 0, in_regular = 0, elsewhere = 0;
};

// x is in the set of its limit, if that has index 2 or is regular, and in no other such set.
void require_right_set(const FastSets& all, const Point& x, PlacesSeen& seen) {
  const auto limit = oracle::orbit(all.subject.set, x).limit;
  bool is_in_one = false;
  for (const FastSet& set : all.sets) {
    const bool is_inside = oracle::contains(all.subject.set, set.skeleton, x);
    all.require(is_inside == (limit == set.z), text_of(x) + (is_inside ? " is" : " is not"), set);
    if (is_inside) ++(set.z.face_dimension == set.z.hull_dimension ? seen.in_critical : seen.in_regular);
    is_in_one = is_in_one || is_inside;
  }
  const bool wants_one = limit && (limit->face_dimension != limit->hull_dimension || limit->face_dimension == 2);
  require_none(all.subject.input, is_in_one == wants_one ? "" : text_of(x) + " is in no set", "");
  ++seen.points;
  seen.elsewhere += is_in_one ? 0 : 1;
}

// The hulls of a skeleton's pieces, or of the cones over them to one of their samples.
std::vector<std::vector<Point>> hulls_of(const FastSets& all, const FastSet& set, rc::Random& random) {
  std::vector<std::vector<Point>> hulls;
  const auto add = [&](std::vector<Point> base, const auto& apexes) {
    if (below(random, 2) == 0) base.push_back(all.point(apexes[below(random, apexes.size())]));
    hulls.push_back(base);
  };
  for (const auto& w : set.skeleton.points) add({w.position}, w.contact);
  for (const auto& s : set.skeleton.segments) add({s.front.position, s.back.position}, s.samples);
  for (const auto* parts : {&set.skeleton.intervals, &set.skeleton.crossed}) {
    for (const auto& i : *parts) add({i.front.position, i.back.position}, i.polygon);
  }
  for (const auto& s : set.skeleton.sectors) {
    std::vector<Point> base;
    for (const auto& corner : s.corners) base.push_back(corner.position);
    add(base, s.samples);
  }
  return hulls;
}

TEST(StableInvariants, EveryPointIsInTheSetOfItsLimitAndInNoOther) {
  CITES("FC-STAB-01", "FC-STAB-02");
  PlacesSeen anywhere, on_skeletons;
  StartCensus census;
  const bool held = holds_for_inputs(5, [&](const FastSets& all, rc::Random& random) {
    for (std::size_t k = 0; k < kPointsOfAnInput; ++k) {
      StartChoice choice{static_cast<StartKind>(below(random, kStartKindCount)), {}};
      for (int n = 0; n < 12; ++n) choice.numbers.push_back(static_cast<std::uint32_t>(below(random, 65536)));
      const Point x = start_of(all.subject.set, choice);
      census.add(all.subject.set, choice.kind, x);
      require_right_set(all, x, anywhere);
    }
    std::vector<std::vector<Point>> hulls;
    for (const FastSet& set : all.sets) {
      for (const auto& hull : hulls_of(all, set, random)) hulls.push_back(hull);
    }
    for (const auto& hull : some_of(hulls, kPiecesOfAnInput, random)) {
      require_right_set(all, mixture(hull, random), on_skeletons);
    }
  });
  census.print();
  for (const PlacesSeen* seen : {&anywhere, &on_skeletons}) {
    std::printf("%zu points: %zu in sets of index-2 points, %zu in those of regular ones, %zu in neither\n",
                seen->points, seen->in_critical, seen->in_regular, seen->elsewhere);
  }
  if (!held || scale_of_run() < 1) return;
  for (const char letter : {'V', 'E', 'F'}) EXPECT_GE(census.percent(letter), 5);
  EXPECT_GE(anywhere.in_critical + anywhere.in_regular, 55U);
  EXPECT_GE(anywhere.elsewhere, 350U);
  EXPECT_GE(on_skeletons.in_critical, 750U);
  EXPECT_GE(on_skeletons.in_regular, 150U);
}

// Where the flow goes on from a point of the skeleton: the front of the piece that has the point as its back.
// There is none in the end, nor where a sector is next.
std::optional<Point> next_front(const FastSets& all, const FastSet& set, const Point& y) {
  std::vector<Point> fronts;
  for (const auto& s : set.pieces.segments) {
    if (s.back.position == y) fronts.push_back(s.front.position);
  }
  for (const auto& i : set.pieces.intervals) {
    if (i.back.position == y) fronts.push_back(i.front.position);
  }
  all.require(fronts.size() <= 1, "two ways on from " + text_of(y), set);
  return fronts.empty() ? std::nullopt : std::optional(fronts.front());
}

struct OrbitsSeen {
  std::size_t orbits = 0, several_steps = 0, through_vertices = 0, longest = 0, from_regular = 0;
};

void require_connecting_orbit(const FastSets& all, const FastSet& set, const BackwardSegment<>& last,
                              rc::Random& random, OrbitsSeen& seen) {
  std::vector<Point> fronts = {last.front.position};
  while (fronts.back() != set.z.center) {
    const std::optional<Point> next = next_front(all, set, fronts.back());
    if (!next) break;
    fronts.push_back(*next);
    all.require(fronts.size() <= set.pieces.segments.size() + set.pieces.intervals.size(), "the way up goes round",
                set);
  }
  const bool is_whole = fronts.back() == set.z.center;
  all.require(is_whole || !set.is_surface(), "no way on from " + text_of(fronts.back()), set);
  const Point x = mixture({last.front.position, last.back.position}, random);
  const oracle::Orbit orbit = oracle::orbit(all.subject.set, x);
  all.require(orbit.limit == set.z, text_of(x) + " of a segment flows elsewhere", set);
  const bool same_length = orbit.segments.size() == fronts.size();
  all.require(is_whole ? same_length : orbit.segments.size() > fronts.size(),
              "the orbit of " + text_of(x) + " has another number of steps", set);
  for (std::size_t k = 0; k < fronts.size(); ++k) {
    all.require(orbit.segments[k].end == fronts[k], "the flow does not pass " + text_of(fronts[k]), set);
    const bool is_vertex = oracle::face_letter(all.subject.set, orbit.segments[k].end_contact) == 'V';
    seen.through_vertices += is_vertex && k + 1 < fronts.size() ? 1 : 0;
  }
  ++seen.orbits;
  seen.several_steps += fronts.size() > 1 ? 1 : 0;
  seen.from_regular += last.back_kind == BackKind::kRegular ? 1 : 0;
  seen.longest = std::max(seen.longest, fronts.size());
}

TEST(StableInvariants, ConnectingOrbitsPassTheFrontsOfTheirSegments) {
  CITES("FC-STAB-03", "FC-STAB-04", "FC-STAB-06");
  OrbitsSeen seen;
  const bool held = holds_for_inputs(12, [&](const FastSets& all, rc::Random& random) {
    for (const FastSet& set : some_of(all.sets, kSetsOfAnInput, random)) {
      for (const BackwardSegment<>& s : set.pieces.segments) {
        const bool is_last = s.back_kind == BackKind::kCritical || s.back_kind == BackKind::kRegular;
        if (is_last) require_connecting_orbit(all, set, s, random, seen);
      }
    }
  });
  std::printf(
      "%zu orbits, %zu of them of several steps, the longest of %zu; %zu passes of Voronoi vertices; %zu "
      "from "
      "regular points\n",
      seen.orbits, seen.several_steps, seen.longest, seen.through_vertices, seen.from_regular);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.orbits, 1900U);
  EXPECT_GE(seen.several_steps, 150U);
  EXPECT_GE(seen.through_vertices, 150U);
  EXPECT_GE(seen.longest, 4U);
  EXPECT_GE(seen.from_regular, 75U);
}

}  // namespace
}  // namespace flowcert::property::stable_invariants_test
