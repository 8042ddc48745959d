// The bounds of direction.h against those that src/flow/cascades.md derives, without a diagram: starts of each kind,
// and chains of crossings through triangles and larger polygons.
//
// Guarantees: a known direction is compared with the integer one exactly, in both precisions. Its error is also at
// least what the derivation gives, which is computed here in another way. A filter of a sign must leave the sign open
// where the value is within the derived error. Random inputs seldom have rounding errors near the worst case, so a
// bound ten times too small hardly ever contradicts the integers; here it fails at once. Each test counts what it has
// met.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flow/kernels/cascade_kernel.h"
#include "geometry/predicates.h"
#include "tests/cites.h"
#include "tests/unit/exact_directions.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"

namespace flowcert::flow::direction_bounds_test {
namespace {

using flowcert_tests::draw_tuple;
using flowcert_tests::exact_vector;
using flowcert_tests::is_zero;
using flowcert_tests::PortableRandom;
using flowcert_tests::RationalVector;
using flowcert_tests::rounded_number;
using flowcert_tests::squared;
using flowcert_tests::TupleKind;

// ---- Scenes: the samples of a chain ----

// The points of an integer sphere, turned and scaled by one quaternion of large integers. They have about 50 bits, and
// many lie on one circle exactly.
struct Scene {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> lattice;  // of the first points, which lie on the sphere
};

void add_turned_sphere(Scene& scene, PortableRandom& random) {
  const auto part = [&] { return static_cast<double>(random.between(-(1 << 20), 1 << 20)); };
  const double a = part(), b = part(), c = part(), d = part();
  constexpr int kSquaredRadius = 41;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (int z = -6; z <= 6; ++z) {
        if (x * x + y * y + z * z != kSquaredRadius) continue;
        scene.lattice.push_back({x, y, z});
        scene.points.push_back(
            {(a * a + b * b - c * c - d * d) * x + 2 * (b * c - a * d) * y + 2 * (b * d + a * c) * z,
             2 * (b * c + a * d) * x + (a * a - b * b + c * c - d * d) * y + 2 * (c * d - a * b) * z,
             2 * (b * d - a * c) * x + 2 * (c * d + a * b) * y + (a * a - b * b - c * c + d * d) * z});
      }
    }
  }
}

constexpr std::size_t kTupleSize = 8;

Scene scene_of(TupleKind kind, double scale, double flatness, PortableRandom& random) {
  Scene scene;
  for (const Point& p : draw_tuple<kTupleSize>(kind, random)) {
    scene.points.push_back({scale * p.x, scale * p.y, scale * flatness * p.z});
  }
  return scene;
}

Scene scene_on_a_sphere(PortableRandom& random) {
  Scene scene;
  add_turned_sphere(scene, random);
  for (std::size_t k = 0; k < 4; ++k) {
    scene.points.push_back({random.coordinate() * 0x1p44, random.coordinate() * 0x1p44, random.coordinate() * 0x1p44});
  }
  return scene;
}

// ---- The derivation, in numbers that are rounded once ----

template <class Number>
Number root(const Rational& square) {
  using std::sqrt;
  return sqrt(rounded_number<Number>(square));
}

RationalVector between(const Point& from, const Point& to) { return exact_vector(to) - exact_vector(from); }
RationalVector twice_midpoint(FacetEdge edge) { return exact_vector(*edge.p0) + exact_vector(*edge.p1); }

// The least error that a start may claim, by the length of the vector that it is made of.
template <class Number>
Number vertex_error(const std::array<const Point*, 4>& v, FacetEdge facet) {
  const RationalVector a = between(*v[0], *v[1]), b = between(*v[0], *v[2]), c = between(*v[0], *v[3]);
  const RationalVector w0 = between(*facet.p0, *v[0]), w1 = between(*facet.p1, *v[0]);
  const auto sphere = geometry::circumsphere(a, b, c);
  const Number na = root<Number>(squared(a)), nb = root<Number>(squared(b)), nc = root<Number>(squared(c));
  const Number sum = na + nb + nc, other = root<Number>(squared(w0)) + root<Number>(squared(w1));
  const RationalVector y = sphere.numerator + sphere.determinant * (w0 + w1);
  return Number(Precision<Number>::kRoundoff) * na * nb * nc * (Number(21.42) * sum + Number(20.42) * other) /
         root<Number>(squared(y));
}
template <class Number>
Number circle_error(const std::array<const Point*, 3>& v, FacetEdge facet) {
  const RationalVector a = between(*v[0], *v[1]), b = between(*v[0], *v[2]), n = cross(a, b);
  const RationalVector w0 = between(*facet.p0, *v[0]), w1 = between(*facet.p1, *v[0]);
  const Rational aa = squared(a), bb = squared(b);
  const RationalVector y = squared(n) * (w0 + w1) + cross(aa * b - bb * a, n);
  const Number sizes = root<Number>(aa) + root<Number>(bb) + root<Number>(squared(w0)) + root<Number>(squared(w1));
  return Number(23.84 * Precision<Number>::kRoundoff) * rounded_number<Number>(aa * bb) * sizes /
         root<Number>(squared(y));
}
template <class Number>
Number side_error(const Point& c, FacetEdge facet) {
  const RationalVector e = between(*facet.p0, *facet.p1), a = between(*facet.p0, c);
  const RationalVector y = squared(e) * a - dot(a, e) * e;
  return Number(23.2 * Precision<Number>::kRoundoff) * rounded_number<Number>(squared(e)) * root<Number>(squared(a)) /
         root<Number>(squared(y));
}

RationalVector circle_center(const Point& p, const Point& q, const Point& r) {
  return circumcenter(exact_vector(p), exact_vector(q), exact_vector(r));
}

bool is_end(const Point* p, FacetEdge edge) { return p == edge.p0 || p == edge.p1; }
bool shares_an_end(FacetEdge from, FacetEdge to) { return is_end(to.p0, from) || is_end(to.p1, from); }
bool is_triangle(FacetEdge from, const Point& q, FacetEdge to) { return is_end(&q, to) && shares_an_end(from, to); }

// What is known after a crossing, if only the crossing's own rounding is added. The map stretches the plane's part
// away from the centre z of the polygon by 2 h, and the part towards z by 2 h |z-m'| / |z-m|.
template <class Number>
Number crossing_error(const Direction<Number>& x, FacetEdge from, const Point& q, FacetEdge to) {
  const RationalVector a = between(*from.p0, q), b = between(*from.p1, q), u = exact_vector(x.u);
  const Rational h = dot(a, b), approach = dot(u, a + b);
  const RationalVector d0 = between(*to.p0, *from.p0), d1 = between(*to.p1, *from.p1);
  const RationalVector y = approach * (d0 + d1) + Rational(2 * h) * u;
  const RationalVector z = circle_center(*from.p0, *from.p1, q);
  const auto distance_from_center = [&](FacetEdge edge) { return squared(Rational(2) * z - twice_midpoint(edge)); };
  const Number ratio = root<Number>(distance_from_center(to) / distance_from_center(from));
  const Number length = root<Number>(squared(y)), size = root<Number>(2 * (squared(a) + squared(b)));
  Number drop(0);
  if (!is_triangle(from, q, to)) {
    drop = shares_an_end(from, to) ? root<Number>(squared(d0 + d1))
                                   : root<Number>(squared(d0)) + root<Number>(squared(d1));
  }
  const Number height = rounded_number<Number>(abs(h));
  const Number kappa = 4 * height * height * ratio / (length * length);
  const Number tau = 2 * height * std::max(Number(1), ratio) / length;
  const Number r = Number(36 * Precision<Number>::kRoundoff) * (size + drop) * (size + drop) / length;
  const Number t = x.error;
  return (kappa * t * (1 + r) + r * (1 + tau * t)) / ((1 - tau * t) * (1 - r) - kappa * t * r);
}

// ---- Chains ----

// All three are carried along without help from the integers.
struct Known {
  IntegerDirection exact;
  Direction<double> doubles;
  Direction<Extended> extended;
  Direction<DoubleDouble> doubled;
};

// By branch: how many directions were known and compared, in each precision.
using Met = std::map<std::string, std::array<std::size_t, 3>>;

template <class Number>
void expect_bound(const std::string& branch, const Direction<Number>& x, const Number& derived,
                  const IntegerDirection& truth, FacetEdge facet, Met& met) {
  ++met[branch][std::is_same_v<Number, double> ? 0 : std::is_same_v<Number, Extended> ? 1 : 2];
  EXPECT_EQ(flowcert_tests::broken_bound(x, truth, facet), "") << branch;
  EXPECT_GE(x.error, derived) << branch;
}

void expect_all(const std::string& branch, const Known& x, FacetEdge facet, const auto& derived, Met& met) {
  if (x.doubles.is_known()) expect_bound(branch, x.doubles, derived(x.doubles), x.exact, facet, met);
  if (x.extended.is_known()) expect_bound(branch, x.extended, derived(x.extended), x.exact, facet, met);
  if (x.doubled.is_known()) expect_bound(branch, x.doubled, derived(x.doubled), x.exact, facet, met);
}

bool is_nothing(const IntegerDirection& u) { return u.x == 0 && u.y == 0 && u.z == 0; }
bool are_collinear(const Point& p, const Point& q, const Point& r) {
  return is_zero(cross(between(p, q), between(p, r)));
}

class Chain {
 public:
  Chain(const Scene& scene, PortableRandom& random, Met& met) : scene_(scene), random_(random), met_(met) {}

  // Each returns whether there is such a start, or such a crossing.
  bool start() {
    facet_ = {&any(), &any()};
    if (is_zero(between(*facet_.p0, *facet_.p1))) return false;
    switch (random_.below(4)) {
      case 0:
        return start_at_vertex();
      case 1:
        return start_at_side();
      case 2:
        return start_at_circle();
      default:
        return start_at_position();
    }
  }

  bool cross_a_facet() {
    const Point& q = any();
    if (are_collinear(*facet_.p0, *facet_.p1, q)) return false;
    const ExactBisector seen(facet_, q);
    const BigInteger approach = dot(x_.exact, seen.g);
    if (approach == 0 || seen.h == 0 || (approach > 0) != (seen.h > 0)) return false;
    const std::optional<FacetEdge> to = side_beyond(q);
    if (!to) return false;
    const Known before = x_;
    x_ = {exact_direction_across(before.exact, facet_, q, *to), direction_across(before.doubles, facet_, q, *to),
          direction_across(before.extended, facet_, q, *to), direction_across(before.doubled, facet_, q, *to)};
    if (is_nothing(x_.exact)) return false;
    const auto derived = [&]<class Number>(const Direction<Number>&) {
      if constexpr (std::is_same_v<Number, double>) {
        return crossing_error(before.doubles, facet_, q, *to);
      } else if constexpr (std::is_same_v<Number, DoubleDouble>) {
        return crossing_error(before.doubled, facet_, q, *to);
      } else {
        return crossing_error(before.extended, facet_, q, *to);
      }
    };
    const char* branch = is_triangle(facet_, q, *to)  ? "triangle"
                         : shares_an_end(facet_, *to) ? "polygon sharing a vertex"
                                                      : "polygon sharing none";
    expect_all(branch, x_, *to, derived, met_);
    facet_ = *to;
    return true;
  }

 private:
  const Point& any() { return scene_.points[random_.below(scene_.points.size())]; }
  const Point& any_on_sphere() { return scene_.points[random_.below(scene_.lattice.size())]; }

  bool begin(const char* branch, Known x, const auto& derived) {
    x_ = std::move(x);
    if (is_nothing(x_.exact)) return false;
    expect_all(branch, x_, facet_, derived, met_);
    return true;
  }
  // On a sphere, of any four of its points.
  bool start_at_vertex() {
    std::array<const Point*, 4> v = {facet_.p0, facet_.p1, &any(), &any()};
    if (!scene_.lattice.empty() && random_.coin()) {
      v = {&any_on_sphere(), &any_on_sphere(), &any_on_sphere(), &any_on_sphere()};
      facet_ = {&any_on_sphere(), &any_on_sphere()};
      if (facet_.p0 == facet_.p1) return false;
    }
    const auto volume = dot(between(*v[0], *v[1]), cross(between(*v[0], *v[2]), between(*v[0], *v[3])));
    if (volume == 0) return false;
    if (volume < 0) std::swap(v[2], v[3]);
    return begin("vertex",
                 {exact_direction_from_vertex(v, facet_), direction_from_vertex<double>(v, facet_),
                  direction_from_vertex<Extended>(v, facet_), direction_from_vertex<DoubleDouble>(v, facet_)},
                 [&]<class Number>(const Direction<Number>&) { return vertex_error<Number>(v, facet_); });
  }
  bool start_at_side() {
    std::array<const Point*, 3> v = {facet_.p0, facet_.p1, &any()};
    if (are_collinear(*v[0], *v[1], *v[2])) return false;
    const Point& c = *v[2];
    std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(random_.below(3)), v.end());
    return begin("side", known_at_circle(v),
                 [&]<class Number>(const Direction<Number>&) { return side_error<Number>(c, facet_); });
  }
  // The edge is another chord of the circle.
  bool start_at_circle() {
    if (scene_.lattice.empty()) return false;
    std::array<const Point*, 3> v{};
    std::vector<const Point*> circle;
    while (circle.size() < 5) {
      v = {&any_on_sphere(), &any_on_sphere(), &any_on_sphere()};
      if (are_collinear(*v[0], *v[1], *v[2])) continue;
      circle = circle_of(*v[0], *v[1], *v[2]);
    }
    const auto is_corner = [&](const Point* p) { return std::find(v.begin(), v.end(), p) != v.end(); };
    do {
      facet_ = {circle[random_.below(circle.size())], circle[random_.below(circle.size())]};
    } while (facet_.p0 == facet_.p1 || (is_corner(facet_.p0) && is_corner(facet_.p1)));
    return begin("circle", known_at_circle(v),
                 [&]<class Number>(const Direction<Number>&) { return circle_error<Number>(v, facet_); });
  }
  Known known_at_circle(const std::array<const Point*, 3>& v) const {
    return {exact_direction_from_circle(v, facet_), direction_from_circle<double>(v, facet_),
            direction_from_circle<Extended>(v, facet_), direction_from_circle<DoubleDouble>(v, facet_)};
  }
  // A position in the facet's plane. It is rounded once, in each coordinate.
  bool start_at_position() {
    const RationalVector e = between(*facet_.p0, *facet_.p1);
    const auto third = [&] { return Rational(random_.between(-1000, 1000)) / 3; };
    const RationalVector x =
        Rational(1) / 2 * twice_midpoint(facet_) + cross(RationalVector{third(), third(), third()}, e);
    KernelTally tally;
    CascadeKernel kernel(tally);
    const PointNumber number = kernel.add({x.x, x.y, x.z});
    return begin("position",
                 {kernel.direction_in_integers(number, facet_), kernel.direction_in_doubles(number, facet_),
                  kernel.direction_in<Extended>(number, facet_), kernel.direction_in<DoubleDouble>(number, facet_)},
                 []<class Number>(const Direction<Number>&) { return Number(2 * Precision<Number>::kRoundoff); });
  }

  // All samples on the circle of three of the sphere.
  [[nodiscard]] std::vector<const Point*> circle_of(const Point& p, const Point& q, const Point& r) const {
    const auto place = [&](const Point& of) {
      const auto [x, y, z] = scene_.lattice[static_cast<std::size_t>(&of - scene_.points.data())];
      return Vector3<int>{x, y, z};
    };
    std::vector<const Point*> circle;
    const Vector3<int> normal = cross(place(q) - place(p), place(r) - place(p));
    for (std::size_t k = 0; k < scene_.lattice.size(); ++k) {
      const Point& other = scene_.points[k];
      if (dot(normal, place(other) - place(p)) == 0) circle.push_back(&other);
    }
    return circle;
  }
  [[nodiscard]] bool is_on_sphere(const Point* p) const {
    return p >= scene_.points.data() && p < scene_.points.data() + scene_.lattice.size();
  }

  // Another side of the polygon of the facet's edge and q.
  std::optional<FacetEdge> side_beyond(const Point& q) {
    std::vector<const Point*> polygon = {facet_.p0, facet_.p1, &q};
    if (is_on_sphere(facet_.p0) && is_on_sphere(facet_.p1) && is_on_sphere(&q)) {
      polygon = circle_of(*facet_.p0, *facet_.p1, q);
    }
    const FacetEdge to{polygon[random_.below(polygon.size())], polygon[random_.below(polygon.size())]};
    if (to.p0 == to.p1 || (is_end(to.p0, facet_) && is_end(to.p1, facet_))) return std::nullopt;
    return to;
  }

  const Scene& scene_;
  PortableRandom& random_;
  Met& met_;
  FacetEdge facet_;
  Known x_;
};

void run_chains(const Scene& scene, int chains, PortableRandom& random, Met& met) {
  for (int k = 0; k < chains; ++k) {
    Chain chain(scene, random, met);
    bool is_started = false;
    for (int tries = 0; tries < 5 && !is_started; ++tries) is_started = chain.start();
    if (!is_started) continue;
    for (int tries = 0; tries < 40; ++tries) (void)chain.cross_a_facet();
  }
}

TEST(DirectionBounds, ContainTheIntegerDirectionsAlongRandomChains) {
  CITES("FC-NUM-01");
  PortableRandom random(3);
  Met met;
  for (int k = 0; k < 4; ++k) run_chains(scene_on_a_sphere(random), 50, random, met);
  for (const TupleKind kind : flowcert_tests::kTupleKinds) {
    for (int k = 0; k < 3; ++k) run_chains(scene_of(kind, 1, 1, random), 12, random, met);
  }
  // Flat scenes have slivers.
  for (const double flatness : {1e-3, 1e-7, 1e-12, 0.0}) {
    for (int k = 0; k < 3; ++k) run_chains(scene_of(TupleKind::kGeneric, 1, flatness, random), 15, random, met);
  }
  for (const auto& [branch, known] : met) {
    std::printf("%-26s %6zu in doubles, %6zu in the longer precision\n", branch.c_str(), known[0], known[1]);
    EXPECT_GT(known[0], 30U) << branch;
    EXPECT_GT(known[1], 30U) << branch;
    EXPECT_GT(known[2], 30U) << branch;
  }
  EXPECT_EQ(met.size(), 7U) << "four starts and three crossings";
}

// Beyond the range of doubles whose powers are doubles, the longer precision alone knows a direction.
TEST(DirectionBounds, OutOfRangeTheLongerPrecisionKnows) {
  CITES("FC-NUM-01");
  PortableRandom random(4);
  for (const double scale : {0x1p120, 0x1p-120, 0x1p500, 0x1p-500, 0x1p-1040}) {
    Met met;
    for (int k = 0; k < 3; ++k) run_chains(scene_of(TupleKind::kGeneric, scale, 1, random), 30, random, met);
    for (const auto& [branch, known] : met) {
      // A position is rounded from its exact direction, which has no size.
      EXPECT_EQ(known[0] == 0, branch != "position") << branch << ' ' << scale;
      EXPECT_GT(known[1], 10U) << branch << ' ' << scale;
    }
    EXPECT_EQ(met.size(), 4U);
  }
}

// Lengths that are not checked may be so large that the square of a vector is infinite.
TEST(DirectionBounds, WithoutALengthNothingIsKnown) {
  CITES("FC-NUM-01");
  constexpr double kSide = 0x1p80, kFar = 0x1p500;
  const std::array<Point, 5> p = {Point{0, 0, 0}, Point{kSide, 0, 0}, Point{0, kSide, 0}, Point{0, 0, kSide},
                                  Point{kSide, 1, 1}};
  const Point far{kFar, 0, 0}, beside{kFar, 0, kSide};
  EXPECT_FALSE(direction_from_vertex<double>({&p[0], &p[1], &p[2], &p[3]}, {&far, &beside}).is_known());
  EXPECT_FALSE(direction_from_circle<double>({&p[0], &p[1], &p[2]}, {&far, &beside}).is_known());
  const Direction<double> up{{0, 0, 1}, 0};
  EXPECT_FALSE(direction_across(up, {&p[0], &p[4]}, p[3], {&far, &beside}).is_known());
}

// ---- Filters of signs ----

// The facet's edge lies along the z axis, and the direction along the x axis.
constexpr Point kBelow{0, 0, -1}, kAbove{0, 0, 1};
constexpr FacetEdge kUpright{&kBelow, &kAbove};

template <class Number>
Direction<Number> along_x(const Number& error) {
  return {{Number(1), Number(0), Number(0)}, error};
}
template <class Number>
Number distance(const Point& from, const Point& to) {
  return length(difference<Number>(from, to));
}
// G of a neighbour of the upright edge.
template <class Number>
Number size_of(const Point& q) {
  using std::sqrt;
  const Number below = distance<Number>(kBelow, q), above = distance<Number>(kAbove, q);
  return sqrt(Number(2 * (below * below + above * above)));
}
Point generic_point(PortableRandom& random) {
  const auto part = [&] { return (random.coin() ? 1 : -1) * (1.5 + random.coordinate()); };
  return {0, part(), part()};
}

// `query(x, by)` asks for the sign of a value that has this error at most, and is `by` times the error. The filter
// must leave it open up to 1, and need not beyond 2.
template <class Number, class Query>
void expect_open_within_the_error(PortableRandom& random, const Query& query) {
  const Number roundoff(Precision<Number>::kRoundoff);
  for (const double times : {0.0, 1.0, 100.0, 1e9}) {
    const Direction<Number> x = along_x<Number>(Number(times) * roundoff);
    for (int k = 0; k < 200; ++k) {
      const double by = 0.999 * random.coordinate();
      EXPECT_EQ(query(x, by), std::nullopt) << by << " of the error, " << times;
      EXPECT_EQ(query(x, 2.0), Sign::kPositive) << times;
      EXPECT_EQ(query(x, -2.0), Sign::kNegative) << times;
    }
  }
}

// <U,g> is 2 q.x. The direction's error, 12 of what leaves the plane, 5.2 of rounding.
template <class Number>
void expect_approach_bound(PortableRandom& random) {
  expect_open_within_the_error<Number>(random, [&](const Direction<Number>& x, double by) {
    Point q = generic_point(random);
    const Number error = (x.error + Number(17.2 * Precision<Number>::kRoundoff)) * size_of<Number>(q);
    q.x = by * static_cast<double>(error) / 2;
    return approach_sign(x, kUpright, q);
  });
}

// With q_i.x = 0 the value is -2 h_i q_j.x. 3 of what leaves the plane, 3.3 of rounding. Squares are compared, so that
// |h| <= G^2 / 4 and (G_i + G_j)^2 <= 2 (G_i^2 + G_j^2) are in the bound.
template <class Number>
void expect_order_bound(PortableRandom& random) {
  expect_open_within_the_error<Number>(random, [&](const Direction<Number>& x, double by) {
    const Point qi = generic_point(random);
    Point qj = generic_point(random);
    const auto height = [](const Point& q) { return q.y * q.y + q.z * q.z - 1; };
    const Number gi = size_of<Number>(qi), gj = size_of<Number>(qj);
    using std::sqrt;
    const Number both = sqrt(Number(Number(2) * (gi * gi + gj * gj)));
    const Number error = (Number(0.25) * x.error + Number(6.3 * Precision<Number>::kRoundoff)) * gi * gj * both;
    qj.x = -by * static_cast<double>(error) / (2 * height(qi));
    return order_sign(x, kUpright, qi, qj);
  });
}

// <U,n> is the part of n along x. 12 of what leaves the plane, 5.7 and 3.1 of rounding.
template <class Number>
void expect_normal_bound(PortableRandom& random) {
  expect_open_within_the_error<Number>(random, [&](const Direction<Number>& x, double by) {
    const Point a{0, 0, 0}, b{1.5 + random.coordinate(), 1, 0};
    Point c{1.5 + random.coordinate(), random.coordinate(), 0};
    const Number error =
        (x.error + Number(20.8 * Precision<Number>::kRoundoff)) * distance<Number>(a, b) * distance<Number>(a, c);
    c.z = by * static_cast<double>(error);
    return normal_sign(x, a, b, c);
  });
}

TEST(DirectionBounds, OfTheSigns) {
  CITES("FC-NUM-01");
  PortableRandom random(5);
  expect_approach_bound<double>(random);
  expect_approach_bound<DoubleDouble>(random);
  expect_approach_bound<Extended>(random);
  expect_order_bound<double>(random);
  expect_order_bound<DoubleDouble>(random);
  expect_order_bound<Extended>(random);
  expect_normal_bound<double>(random);
  expect_normal_bound<DoubleDouble>(random);
  expect_normal_bound<Extended>(random);
}

// The map is the one forward or the one backward. Where neither <U,g> nor h is certain, nothing is known behind the
// facet.
TEST(DirectionBounds, OfTheWayThroughAFacet) {
  CITES("FC-NUM-01");
  PortableRandom random(6);
  constexpr double u = Precision<double>::kRoundoff;  // NOLINT(readability-identifier-naming): as in formulas
  std::size_t within = 0;
  for (int k = 0; k < 2000; ++k) {
    const Direction<double> x = along_x<double>(0x1p-20);
    // On the sphere around the edge, up to rounding, and near one end. (Elsewhere the error alone is too large.)
    const double turn = 0.01 + 0.01 * random.coordinate();
    const double size = std::sqrt(8), far = 2.5 * x.error * size / 2;
    const double near = 0.99 * random.coordinate() * (x.error + 17.2 * u) * size / 2;
    const auto q_at = [&](double across) {
      const double radius = std::sqrt((1 - across) * (1 + across));
      return Point{across, radius * std::sin(turn), radius * std::cos(turn)};
    };
    Point q = q_at(near);
    const FacetEdge to{random.coin() ? &kBelow : &kAbove, &q};
    const double h = q.x * q.x + q.y * q.y + (q.z - 1) * (q.z + 1);
    const bool is_open = std::fabs(h) <= 1.3 * u * size * size;
    within += is_open ? 1 : 0;
    EXPECT_FALSE(is_open && direction_across(x, kUpright, q, to).is_known()) << q.x;
    q = q_at(far);
    EXPECT_TRUE(direction_across(x, kUpright, q, to).is_known()) << q.x;
  }
  EXPECT_GT(within, 500U);
}

// The centre of a circle lies on the side of c iff the angle at c is acute. Where that sign is not certain, nothing is
// known.
TEST(DirectionBounds, OfTheSideOfACentre) {
  CITES("FC-NUM-01");
  PortableRandom random(7);
  constexpr double u = Precision<double>::kRoundoff;  // NOLINT(readability-identifier-naming): as in formulas
  std::size_t within = 0;
  for (int k = 0; k < 2000; ++k) {
    const double turn = 1.5 + random.coordinate(), across = 0.5 * random.coordinate();
    const double radius = std::sqrt((1 - across) * (1 + across));
    const Point c{across, radius * std::sin(turn), radius * std::cos(turn)};
    const auto a = difference<double>(kBelow, c), b = difference<double>(kAbove, c);
    const bool is_open = std::fabs(dot(a, b)) <= 5.1 * u * length(a) * length(b);
    within += is_open ? 1 : 0;
    EXPECT_FALSE(is_open && direction_from_circle<double>({&kBelow, &kAbove, &c}, kUpright).is_known());
    const Point outside{2 * c.x, 2 * c.y, 2 * c.z};
    EXPECT_TRUE(direction_from_circle<double>({&kBelow, &kAbove, &outside}, kUpright).is_known());
  }
  EXPECT_GT(within, 1000U);
}

// From flatter and flatter tetrahedra: the error grows until nothing is known, and is never more than small.
TEST(DirectionBounds, WhatIsKnownHasASmallError) {
  CITES("FC-NUM-01");
  PortableRandom random(8);
  std::size_t known = 0, unknown = 0;
  for (int k = 0; k < 100; ++k) {
    const std::array<Point, 4> generic = draw_tuple<4>(TupleKind::kGeneric, random);
    for (int exponent = 30; exponent < 60; ++exponent) {
      std::array<Point, 4> p = generic;
      // The last sample comes near to the circle of the others: y becomes small.
      const RationalVector center = circle_center(p[0], p[1], p[2]), to = exact_vector(p[2]) - center;
      const double little = std::ldexp(1.0, -exponent);
      p[3] = {static_cast<double>(Rational(center.x - to.x)), static_cast<double>(Rational(center.y - to.y)),
              static_cast<double>(Rational(center.z - to.z)) + little};
      const auto volume = dot(between(p[0], p[1]), cross(between(p[0], p[2]), between(p[0], p[3])));
      if (volume == 0) continue;
      std::array<const Point*, 4> v = {&p[0], &p[1], &p[2], &p[3]};
      if (volume < 0) std::swap(v[2], v[3]);
      const Direction<double> x = direction_from_vertex<double>(v, {&p[0], &p[1]});
      ++(x.is_known() ? known : unknown);
      EXPECT_LE(x.is_known() ? x.error : 0, 0.0625 * 1.125);
    }
  }
  EXPECT_GT(known, 300U);
  EXPECT_GT(unknown, 300U);
}

}  // namespace
}  // namespace flowcert::flow::direction_bounds_test
