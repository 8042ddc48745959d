// Each configuration is built around the point where its stable set is cut off.
#include "fuzz/inputs/stable_configurations.h"

namespace flowcert::fuzz {

namespace {

constexpr Integer kReach = 12;

// The integer points below y = 0 of the sphere about (0,t,0) through (-a,0,0).
IntegerPoints lower_sphere_points(Integer a, Integer t) {
  IntegerPoints sphere;
  for (Integer x = -kReach; x <= kReach; ++x) {
    for (Integer y = -kReach; y < 0; ++y) {
      for (Integer z = -kReach; z <= kReach; ++z) {
        if (x * x + (y - t) * (y - t) + z * z == a * a + t * t) sphere.push_back({x, y, z});
      }
    }
  }
  return sphere;
}

// The least c > t with (0,c,0) outside of that sphere.
Integer least_top(Integer a, Integer t) {
  Integer c = t + 1;
  while ((c - t) * (c - t) <= a * a + t * t) ++c;
  return c;
}

bool is_obtuse(const IntegerPoint& at, const IntegerPoint& p, const IntegerPoint& q) {
  return dot(plus(p, times(-1, at)), plus(q, times(-1, at))) < 0;
}

struct Star {
  Integer a;
  Integer t;
  IntegerPoint p;
  IntegerPoint q;
};

void append_stars(Integer a, Integer t, std::vector<Star>& stars) {
  const IntegerPoint left{-a, 0, 0}, right{a, 0, 0};
  const IntegerPoints sphere = lower_sphere_points(a, t);
  for (const IntegerPoint& p : sphere) {
    for (const IntegerPoint& q : sphere) {
      if (is_obtuse(p, left, right) && is_obtuse(q, left, right) && is_obtuse(q, left, p) && is_obtuse(q, right, p)) {
        stars.push_back({a, t, p, q});
      }
    }
  }
}

const std::vector<Star>& stars() {
  static const std::vector<Star> all = [] {
    std::vector<Star> stars;
    for (Integer a = 3; a <= 10; ++a) {
      for (Integer t = 1; t <= 12; ++t) append_stars(a, t, stars);
    }
    return stars;
  }();
  return all;
}

// Three of the points, which may repeat. None if the list is empty.
rc::Gen<IntegerPoints> three_of(const IntegerPoints& points) {
  if (points.empty()) return rc::gen::just(IntegerPoints{});
  return rc::gen::container<IntegerPoints>(3, one_of(points));
}

rc::Gen<IntegerPoint> point_well_below(Integer a) {
  return rc::gen::apply([](Integer x, Integer y, Integer z) { return IntegerPoint{x, y, z}; }, whole(-2 * a, 2 * a),
                        whole(-4 * a, -2 * a), whole(-a, a));
}

rc::Gen<IntegerPoints> aimed_points_of(Integer a, Integer t) {
  return rc::gen::apply(
      [a, t](Integer lift, const IntegerPoints& sphere, const IntegerPoints& others) {
        return joined(joined({{-a, 0, 0}, {a, 0, 0}, {0, least_top(a, t) + lift, 0}}, sphere), others);
      },
      whole(0, 2), three_of(lower_sphere_points(a, t)), list_of(0, 4, point_well_below(a)));
}

const std::vector<IntegerPoints>& cores() {
  static const std::vector<IntegerPoints> all = {{{20, 0, 0}, {-12, 16, 0}, {-12, -16, 0}, {0, 0, 20}},
                                                 {{20, 0, 0}, {-16, 12, 0}, {-16, -12, 0}, {12, 0, 16}},
                                                 {{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, 0, 20}},
                                                 {{20, 0, 0}, {-20, 0, 0}, {12, 16, 0}, {0, -12, 16}}};
  return all;
}

// All integer points with 20^2 < |p|^2 <= 25^2.
const IntegerPoints& shell() {
  static const IntegerPoints all = [] {
    IntegerPoints points;
    for (Integer x = -25; x <= 25; ++x) {
      for (Integer y = -25; y <= 25; ++y) {
        for (Integer z = -25; z <= 25; ++z) {
          const Integer norm = x * x + y * y + z * z;
          if (norm > 400 && norm <= 625) points.push_back({x, y, z});
        }
      }
    }
    return points;
  }();
  return all;
}

}  // namespace

rc::Gen<IntegerPoints> aimed_points() {
  return rc::gen::mapcat(whole(3, 8), [](Integer a) {
    return rc::gen::mapcat(whole(1, a), [a](Integer t) { return aimed_points_of(a, t); });
  });
}

rc::Gen<IntegerPoints> aimed_at_a_star() {
  return rc::gen::mapcat(one_of(stars()), [](const Star& star) {
    return rc::gen::apply(
        [star](Integer lift, const IntegerPoints& others) {
          const IntegerPoint top{0, least_top(star.a, star.t) + lift, 0};
          return joined({{-star.a, 0, 0}, {star.a, 0, 0}, top, star.p, star.q}, others);
        },
        whole(0, 2), list_of(0, 4, point_well_below(star.a)));
  });
}

rc::Gen<IntegerPoints> crowded_points() {
  return rc::gen::apply(joined, one_of(cores()), list_of(4, 8, one_of(shell())));
}

// ---- Families ----

const std::vector<Family>& stable_families() {
  static const std::vector<Family> families = {
      {"aimed-at-vertices",
       "a side of a triangle, and points below it that make a Voronoi vertex on the branch of S2 there",
       [] { return placed_distinct(aimed_points()); },
       {.four_points = 90, .degenerate = 10}},
      {"aimed-at-stars",
       "the same, where three edges lead to the Voronoi vertex that have one of its samples in common",
       [] { return placed_distinct(aimed_at_a_star()); },
       {.four_points = 100}},
      {"crowded-sectors",
       "four points around a regular stationary centre, and others that cut off its sectors",
       [] { return placed_distinct(crowded_points()); },
       {.four_points = 100, .degenerate = 100}}};
  return families;
}

std::vector<Family> families_and_stable_ones() {
  std::vector<Family> all = families();
  all.insert(all.end(), stable_families().begin(), stable_families().end());
  return all;
}

}  // namespace flowcert::fuzz
