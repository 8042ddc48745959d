// What flows to infinity, by the oracle, on small inputs of all families.
//
// The flow is one judge: of points on pieces, near them and anywhere. Exact sums are another. The sectors of all sets
// tile each bounded Voronoi facet, whose area is found from its Voronoi vertices. Shares fill each bounded cell. The
// hull is full iff nothing in it flows to infinity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "oracle/orbit.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace oracle::oracle_infinity_families_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;
using Names = std::vector<std::size_t>;
using Edge = std::array<std::size_t, 2>;

struct Subject {
  explicit Subject(const Rows& rows) : set(rows), infinity(stable_set_of_infinity(set)) {
    for (const StationaryPoint& z : stationary_points(set).stationary) sets.emplace_back(z, stable_set(set, z));
  }
  const Point& point(std::size_t name) const { return set.points[places_of(set, {name}).front()]; }
  bool spans_space() const { return affine_dimension(set.points) == 3; }

  PointSet set;
  StableSet infinity;
  std::vector<std::pair<StationaryPoint, StableSet>> sets;
};

struct Count {
  std::array<std::size_t, 4> dimensions{};   // of inputs
  std::map<std::string, std::size_t> kinds;  // of pieces
  std::size_t pieces = 0, points = 0, to_infinity = 0, facets = 0, cells = 0, full = 0, not_full = 0;
};

// A tetrahedron around all points, with its corners at four times their greatest coordinate, or somewhat farther away.
void enclose(Rows& rows) {
  double greatest = 1;
  for (const auto& row : rows) {
    for (const double x : row) greatest = std::max(greatest, std::fabs(x));
  }
  int exponent = 0;
  (void)std::frexp(greatest, &exponent);
  const double far = std::ldexp(1, std::min(exponent + 2, 1023));
  for (const auto& corner : Rows{{far, far, far}, {far, -far, -far}, {-far, far, -far}, {-far, -far, far}}) {
    rows.push_back(corner);
  }
}

template <typename Visit>
void for_each_drawn(std::uint64_t seeds, bool is_enclosed, const Visit& visit) {
  SCOPED_TRACE(is_enclosed ? "enclosed" : "as drawn");
  const std::uint64_t scaled = flowcert_tests::scaled_seeds(seeds);
  const std::size_t most = is_enclosed ? 5 : flowcert::property::scale_of_run() < 1 ? 6 : 8;
  constexpr int kGrowth = 16;
  flowcert_tests::for_each_drawn_set({scaled, scaled, most, kGrowth}, [&](Rows rows, std::uint64_t seed) {
    rc::Random random(seed);
    if (is_enclosed) enclose(rows);
    if (!rows.empty()) visit(Subject(rows), random);
  });
}

std::size_t below(rc::Random& random, std::size_t bound) { return static_cast<std::size_t>(random.next() % bound); }

Rational weight(rc::Random& random) { return Rational(static_cast<long>(1 + below(random, 9))); }

// A point in the relative interior of the region of these corners.
Point inside(const std::vector<Corner>& corners, rc::Random& random) {
  Rational sum = 0;
  Point mixed, away;
  for (const Corner& corner : corners) {
    const Rational part = weight(random);
    if (corner.at_infinity) away = moved(away, part, corner.position);
    if (!corner.at_infinity) mixed = moved(mixed, part, corner.position);
    if (!corner.at_infinity) sum += part;
  }
  return moved({mixed[0] / sum, mixed[1] / sum, mixed[2] / sum}, 1, away);
}

// x is in the set of its limit, and in no other one. Returns whether its limit is infinity.
bool expect_in_one_set(const Subject& subject, const Point& x) {
  const auto limit = orbit(subject.set, x).limit;
  EXPECT_EQ(flows_to_infinity(subject.set, subject.infinity, x), !limit) << x[0] << ' ' << x[1] << ' ' << x[2];
  for (const auto& [z, stable] : subject.sets) {
    EXPECT_EQ(contains(subject.set, stable, x), limit == z) << x[0] << ' ' << x[1] << ' ' << x[2];
  }
  return !limit;
}

// A piece of the skeleton of infinity, with the samples of its cones.
struct Piece {
  std::vector<Corner> corners;
  Names apexes;
};

std::vector<Piece> pieces_of(const StableSet& infinity) {
  std::vector<Piece> pieces;
  pieces.reserve(infinity.points.size() + infinity.segments.size());
  const auto both = [](const Edge& samples) { return Names{samples[0], samples[1]}; };
  for (const auto& w : infinity.points) pieces.push_back({{w.position}, w.contact});
  for (const auto& s : infinity.segments) pieces.push_back({{s.front, s.back}, both(s.samples)});
  for (const auto& i : infinity.intervals) pieces.push_back({{i.front, i.back}, i.polygon});
  for (const auto& i : infinity.crossed) pieces.push_back({{i.front, i.back}, i.polygon});
  for (const auto& s : infinity.sectors) pieces.push_back({s.corners, both(s.samples)});
  return pieces;
}

void add_kinds(const PointSet& set, const StableSet& infinity, Count& count) {
  for (const auto& s : infinity.segments) {
    ++count
          .kinds[s.front.at_infinity ? "ray from " + std::to_string(static_cast<int>(s.back_kind)) : "bounded segment"];
  }
  for (const auto& i : infinity.intervals) {
    const std::string from = flow_segment(set, i.back.position) ? "a vertex" : "a stationary point";
    ++count.kinds[i.front.at_infinity ? "ray on an edge, from " + from : "bounded interval"];
  }
  for (const auto& i : infinity.crossed) ++count.kinds[i.back.at_infinity ? "crossed ray" : "crossed interval"];
  for (const auto& s : infinity.sectors) {
    const auto far = std::ranges::count_if(s.corners, [](const Corner& c) { return c.at_infinity; });
    const std::string size = std::to_string(far) + " of " + std::to_string(s.corners.size());
    ++count.kinds[far > 0 ? "sector with " + size + " far" : "bounded sector"];
  }
}

Point random_centre(const std::vector<Point>& points, std::size_t most, rc::Random& random) {
  std::vector<Point> chosen;
  const std::size_t size = 1 + below(random, most);
  chosen.reserve(size);
  for (std::size_t k = 0; k < size; ++k) chosen.push_back(points[below(random, points.size())]);
  return circumcentre(spanning_subset(chosen))->center;
}

TEST(OracleInfinityFamilies, ItsPiecesFlowThereAndNothingNearThemIsMissing) {
  CITES("FC-STAB-01", "FC-STAB-02", "FC-STAB-08");
  Count count;
  for_each_drawn(1, false, [&](const Subject& subject, rc::Random& random) {
    ++count.dimensions[static_cast<std::size_t>(affine_dimension(subject.set.points))];
    add_kinds(subject.set, subject.infinity, count);
    const std::vector<Piece> pieces = pieces_of(subject.infinity);
    // Some of the pieces, spread over the list.
    for (std::size_t i = below(random, 13); i < pieces.size(); i += 13) {
      const Piece& piece = pieces[i];
      const Point x = inside(piece.corners, random);
      EXPECT_EQ(contact_set(subject.set, x), piece.apexes);
      EXPECT_TRUE(expect_in_one_set(subject, x));
      const Point& p = subject.point(piece.apexes[below(random, piece.apexes.size())]);
      EXPECT_TRUE(expect_in_one_set(subject, moved(p, Rational(1, 3), minus(x, p))));
      // A step towards a centre of some of the nearest samples, or away from it.
      const Point aim = random_centre(select(subject.set.points, places_of(subject.set, piece.apexes)), 3, random);
      const Rational step(below(random, 2) == 0 ? -1 : 1, 1 << (1 + below(random, 6)));
      expect_in_one_set(subject, moved(x, step, minus(aim, x)));
      ++count.pieces;
    }
  });
  std::printf("%zu pieces; inputs by dimension: %zu %zu %zu %zu\n", count.pieces, count.dimensions[0],
              count.dimensions[1], count.dimensions[2], count.dimensions[3]);
  const double scale = flowcert::property::scale_of_run();
  for (const auto& [kind, number] : count.kinds) std::printf("%8zu  %s\n", number, kind.c_str());
  EXPECT_GT(count.pieces, 75 * scale);
  if (scale >= 1) {
    for (const char* kind : {"ray from 0", "ray from 1", "ray from 2", "ray on an edge, from a vertex",
                             "ray on an edge, from a stationary point", "crossed ray", "sector with 1 of 3 far",
                             "sector with 1 of 4 far", "sector with 2 of 3 far", "sector with 2 of 4 far",
                             "bounded segment", "bounded interval", "crossed interval", "bounded sector"}) {
      EXPECT_GT(count.kinds[kind], 0U) << kind;
    }
    EXPECT_GT(std::ranges::min(count.dimensions), 0U);
  }
}

TEST(OracleInfinityFamilies, PointsAnywhereAreInTheSetOfTheirLimit) {
  CITES("FC-STAB-01", "FC-STAB-02", "FC-STAB-08");
  Count count;
  for_each_drawn(1, false, [&](const Subject& subject, rc::Random& random) {
    for (int k = 0; k < 9; ++k) {
      const Point a = random_centre(subject.set.points, 4, random), b = random_centre(subject.set.points, 4, random);
      const long time = static_cast<long>(below(random, 10)) - 2;
      count.to_infinity +=
          expect_in_one_set(subject, moved(a, Rational(k % 3 == 0 ? 0 : time, 3), minus(b, a))) ? 1 : 0;
      ++count.points;
    }
  });
  std::printf("%zu points, %zu of them flow to infinity\n", count.points, count.to_infinity);
  EXPECT_GT(count.to_infinity * 5, count.points);
  EXPECT_GT((count.points - count.to_infinity) * 5, count.points);
}

// A plane with samples on it and none on its outer side.
struct HullPlane {
  Point normal;  // outwards
  std::vector<Point> points;

  [[nodiscard]] bool has(const Point& x) const { return std::ranges::find(points, x) != points.end(); }
};

// Those of points that span space.
std::vector<HullPlane> hull_planes(const std::vector<Point>& points) {
  std::map<std::vector<Point>, Point> normals;
  for_each_subset(points.size(), 3, [&](const Places& t) {
    if (t.size() < 3) return;
    Point normal = cross(minus(points[t[1]], points[t[0]]), minus(points[t[2]], points[t[0]]));
    if (normal == Point{}) return;
    std::set<int> sides;
    std::vector<Point> on_plane;
    for (const Point& x : points) {
      const int side = dot(normal, minus(x, points[t[0]])).sign();
      side == 0 ? on_plane.push_back(x) : void(sides.insert(side));
    }
    if (sides.size() != 1) return;
    if (*sides.begin() > 0) normal = {-normal[0], -normal[1], -normal[2]};
    normals.emplace(on_plane, normal);
  });
  std::vector<HullPlane> planes;
  planes.reserve(normals.size());
  for (const auto& [on_plane, normal] : normals) planes.push_back({normal, on_plane});
  return planes;
}

// Twice the area of the convex hull of points of a plane, as a normal vector. The sum is over the edges ab of the hull:
// all other points are on their left, or between a and b.
Point doubled_area(const std::vector<Point>& points, const Point& normal) {
  Point sum;
  for (const Point& a : points) {
    for (const Point& b : points) {
      const Point ab = minus(b, a);
      const bool is_edge = a != b && std::ranges::all_of(points, [&](const Point& c) {
                             const Point ac = minus(c, a);
                             const int side = dot(normal, cross(ab, ac)).sign();
                             return side > 0 || (side == 0 && dot(ab, ac) >= 0 && dot(ab, ac) <= dot(ab, ab));
                           });
      if (is_edge) sum = moved(sum, 1, cross(minus(a, points[0]), minus(b, points[0])));
    }
  }
  return sum;
}

Rational hull_volume(const std::vector<Point>& points) {
  if (affine_dimension(points) < 3) return 0;
  Rational sum = 0;
  for (const HullPlane& plane : hull_planes(points)) {
    sum += abs(dot(doubled_area(plane.points, plane.normal), minus(points[0], plane.points[0])));
  }
  return sum / 6;
}

// The Voronoi vertices of an input that spans space, with their contact sets.
std::map<Point, Names> voronoi_vertices(const PointSet& set) {
  std::map<Point, Names> vertices;
  for_each_subset(set.points.size(), 4, [&](const Places& subset) {
    if (subset.size() < 4) return;
    const auto centre = circumcentre(select(set.points, subset));
    if (!centre) return;
    const Places nearest = set.nearest_places(centre->center);
    if (std::ranges::binary_search(nearest, subset[0])) vertices.emplace(centre->center, select(set.names, nearest));
  });
  return vertices;
}

// The Voronoi vertices with all of these samples.
std::vector<Point> with_samples(const std::map<Point, Names>& vertices, const Names& samples) {
  std::vector<Point> found;
  for (const auto& [x, contact] : vertices) {
    if (std::ranges::includes(contact, samples)) found.push_back(x);
  }
  return found;
}

// The area of all sectors in a facet, times twice the distance of its samples.
std::map<Edge, Rational> sector_areas(const Subject& subject) {
  std::map<Edge, Rational> areas;
  const auto add = [&](const StableSet& stable) {
    for (const Region& sector : stable.sectors) {
      if (is_unbounded(sector)) continue;
      std::vector<Point> corners;
      for (const Corner& corner : sector.corners) corners.push_back(corner.position);
      const Point axis = minus(subject.point(sector.samples[1]), subject.point(sector.samples[0]));
      areas[sector.samples] += abs(dot(doubled_area(corners, axis), axis));
    }
  };
  for (const auto& [z, stable] : subject.sets) add(stable);
  add(subject.infinity);
  return areas;
}

void expect_tiled_facets(const Subject& subject, const std::vector<HullPlane>& planes,
                         const std::map<Point, Names>& vertices, Count& count) {
  std::map<Edge, Rational> areas = sector_areas(subject);
  for_each_subset(subject.set.points.size(), 2, [&](const Places& pair) {
    if (pair.size() < 2) return;
    const Point &p = subject.set.points[pair[0]], &q = subject.set.points[pair[1]];
    const Edge names = {subject.set.names[pair[0]], subject.set.names[pair[1]]};
    const bool is_unbounded =
        std::ranges::any_of(planes, [&](const HullPlane& plane) { return plane.has(p) && plane.has(q); });
    if (is_unbounded) return;
    const std::vector<Point> corners = with_samples(vertices, {names[0], names[1]});
    const Point axis = minus(q, p);
    const Rational area = corners.empty() ? Rational(0) : abs(dot(doubled_area(corners, axis), axis));
    EXPECT_EQ(areas[names], area) << names[0] << ' ' << names[1];
    if (area == 0) return;
    ++count.facets;
  });
}

void expect_filled_cells(const Subject& subject, const std::vector<HullPlane>& planes,
                         const std::map<Point, Names>& vertices, Count& count) {
  std::vector<Rational> sum = shares(subject.set, subject.infinity);
  for (const auto& [z, stable] : subject.sets) {
    const std::vector<Rational> parts = shares(subject.set, stable);
    Rational sum_of_parts = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) {
      EXPECT_GE(parts[k], 0);
      sum[k] += parts[k];
      sum_of_parts += parts[k];
    }
    EXPECT_EQ(sum_of_parts, volume(subject.set, stable));
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const Point& p = subject.set.points[k];
    if (std::ranges::any_of(planes, [&](const HullPlane& plane) { return plane.has(p); })) continue;
    EXPECT_EQ(sum[k], hull_volume(with_samples(vertices, {subject.set.names[k]})));
    ++count.cells;
  }
}

// The part of a convex cone with n . v <= 0. A cone is given by its rays, in cyclic order.
std::vector<Point> below_plane(const std::vector<Point>& cone, const Point& n) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < cone.size(); ++i) {
    const Point &a = cone[i], &b = cone[(i + 1) % cone.size()];
    const Rational at_a = dot(n, a), at_b = dot(n, b);
    if (at_a <= 0) result.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
      const Rational time = at_a / (at_a - at_b);
      result.push_back(moved(a, time, minus(b, a)));
    }
  }
  return result;
}

// A point inside of the hull that flows to infinity. A cone over a sector, with a sample as apex, has such points iff
// it has some near the apex, where only the hull's planes through the apex count.
std::optional<Point> witness(const Subject& subject, const std::vector<HullPlane>& planes, const Piece& piece) {
  for (const std::size_t name : piece.apexes) {
    const Point& p = subject.point(name);
    std::vector<Point> cone;
    cone.reserve(piece.corners.size());
    for (const Corner& c : piece.corners) cone.push_back(c.at_infinity ? c.position : minus(c.position, p));
    for (const HullPlane& plane : planes) {
      if (plane.has(p)) cone = below_plane(cone, plane.normal);
    }
    cone.push_back({});
    if (affine_dimension(cone) < 3) continue;
    Point way;
    for (const Point& v : cone) way = moved(way, 1, v);
    const auto is_outside = [&](const Point& x) {
      return std::ranges::any_of(
          planes, [&](const HullPlane& plane) { return dot(plane.normal, minus(x, plane.points[0])) >= 0; });
    };
    Rational time = 1;
    while (is_outside(moved(p, time, way)) || contact_set(subject.set, moved(p, time, way)) != Names{name}) time /= 2;
    return moved(p, time, way);
  }
  return std::nullopt;
}

void expect_full_hull(const Subject& subject, const std::vector<HullPlane>& planes, Count& count) {
  Rational sum = 0;
  for (const auto& [z, stable] : subject.sets) sum += volume(subject.set, stable);
  const Rational hull = hull_volume(subject.set.points);
  EXPECT_LE(sum, hull);
  std::optional<Point> x;
  for (const Piece& piece : pieces_of(subject.infinity)) {
    const bool is_sector = piece.corners.size() > 2;
    if (is_sector && !x) x = witness(subject, planes, piece);
  }
  EXPECT_EQ(sum < hull, x.has_value());
  if (x) {
    EXPECT_FALSE(orbit(subject.set, *x).limit);
  }
  ++(x ? count.not_full : count.full);
}

void expect_exact_sums(const Subject& subject, Count& count) {
  if (!subject.spans_space()) {
    for (const auto& [z, stable] : subject.sets) EXPECT_EQ(volume(subject.set, stable), 0);
    EXPECT_TRUE(std::ranges::all_of(subject.infinity.sectors, is_unbounded));
    return;
  }
  const std::vector<HullPlane> planes = hull_planes(subject.set.points);
  const std::map<Point, Names> vertices = voronoi_vertices(subject.set);
  expect_tiled_facets(subject, planes, vertices, count);
  expect_filled_cells(subject, planes, vertices, count);
  expect_full_hull(subject, planes, count);
}

TEST(OracleInfinityFamilies, SectorsOfAllSetsTileEachFacetAndFillEachCellAndTheHull) {
  CITES("FC-STAB-05", "FC-STAB-08", "FC-VOL-01", "FC-VOL-02");
  Count count;
  for_each_drawn(1, false, [&](const Subject& subject, rc::Random&) { expect_exact_sums(subject, count); });
  for_each_drawn(1, true, [&](const Subject& subject, rc::Random&) { expect_exact_sums(subject, count); });
  std::printf("%zu bounded facets, %zu bounded cells; %zu full hulls, %zu others\n", count.facets, count.cells,
              count.full, count.not_full);
  const double scale = flowcert::property::scale_of_run();
  EXPECT_GT(count.facets, 150 * scale);
  EXPECT_GT(count.cells, 25 * scale);
  EXPECT_GT(count.not_full, 5 * scale);
  if (scale >= 1) {
    EXPECT_GT(count.full, 2U);
  }
}

}  // namespace
}  // namespace oracle::oracle_infinity_families_test
