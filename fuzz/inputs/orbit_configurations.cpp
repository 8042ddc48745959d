// Configurations whose orbits are long, or run into what orbits rarely meet: Voronoi vertices, and Voronoi
// edges of right triangles.
//
// Guarantees: see configurations.h. Rings: seen from the axis point of height z, ring k is at the squared
// distance z² - 2 z z_k + (r_k² + z_k²), and r_k² + k² is strictly convex in k: so of any choice of rings
// each is nearest somewhere, in turn. Two of them are equally far at a height above both iff r_j² - r_i² >
// (j-i)², which holds for all i < j.
#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/sphere_points.h"

namespace flowcert::fuzz {
namespace {

using RawIndices = std::vector<std::size_t>;

// Squared radii of the rings at heights 0, 1, ...
constexpr std::array<Integer, 7> kRings{1, 5, 10, 25, 50, 85, 130};

// So many heights of rings as there are raw indices, ascending.
std::vector<Integer> heights_at(const RawIndices& raw) {
  IntegerPoints all;
  for (std::size_t k = 0; k < kRings.size(); ++k) {
    all.push_back({static_cast<Integer>(k), 0, 0});
  }
  std::vector<Integer> heights;
  for (const auto& [height, unused, also_unused] : at_raw_indices(all, raw)) {
    heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

Integer ring_norm(Integer height) { return kRings[static_cast<std::size_t>(height)]; }

void append_at_height(IntegerPoints& points, const IntegerPoints& flat, Integer height) {
  for (const IntegerPoint& point : flat) {
    points.push_back({point[0], point[1], height});
  }
}

IntegerPoints opposite_points(Integer norm, std::size_t raw) {
  const IntegerPoint a = at_raw_index(circle_points(norm), raw);
  return {a, times(-1, a)};
}

// What a ring is made of: which height, which first point, which other one.
using Ring = std::array<std::size_t, 3>;

rc::Gen<std::vector<Ring>> rings(std::size_t least, std::size_t most) {
  const auto ring = rc::gen::apply(
      [](std::size_t height, std::size_t first, std::size_t other) {
        return Ring{height, first, other};
      },
      raw_index(), raw_index(), raw_index());
  return list_of(least, most, ring);
}

std::vector<Integer> heights_of(const std::vector<Ring>& rings) {
  RawIndices raw;
  for (const Ring& ring : rings) {
    raw.push_back(ring[0]);
  }
  return heights_at(raw);
}

// A circle about (x, y, 0) around the origin, and half the length of an edge whose ends see all of it, and
// see a point of it at an obtuse angle.
struct OffCentre {
  Integer norm;
  Integer x;
  Integer y;
  Integer h;
};

Integer squared_length(const IntegerPoint& point) { return dot(point, point); }

IntegerPoints shifted_circle(Integer norm, Integer x, Integer y) {
  IntegerPoints points = circle_points(norm);
  for (IntegerPoint& point : points) {
    point = plus(point, {x, y, 0});
  }
  std::stable_sort(points.begin(), points.end(), [](const IntegerPoint& a, const IntegerPoint& b) {
    return squared_length(a) < squared_length(b);
  });
  return points;
}

// A line that a circle's point q is good for touches an ellipse, so it is no other's, if h² + |c|² < R²: see
// large_configurations.cpp.
std::vector<OffCentre> all_off_centre() {
  std::vector<OffCentre> all;
  for (const Integer norm : {25, 50, 65, 85, 130}) {
    for (Integer x = 1; x <= 5; ++x) {
      for (Integer y = 0; y <= x; ++y) {
        for (Integer h = 1; h * h + x * x + y * y < norm; ++h) {
          if (squared_length(shifted_circle(norm, x, y).front()) < h * h) {
            all.push_back({norm, x, y, h});
          }
        }
      }
    }
  }
  return all;
}

rc::Gen<OffCentre> off_centre() {
  static const std::vector<OffCentre> all = all_off_centre();
  return rc::gen::map(raw_index(), [](std::size_t raw) { return all[raw % all.size()]; });
}

// The circle's point next to the origin is always in.
IntegerPoints neighbours(const OffCentre& circle, const RawIndices& raw) {
  IntegerPoints points{{0, 0, -circle.h}, {0, 0, circle.h}};
  IntegerPoints all = shifted_circle(circle.norm, circle.x, circle.y);
  points.push_back(all.front());
  all.erase(all.begin());
  for (const IntegerPoint& point : at_raw_indices(all, raw)) {
    points.push_back(point);
  }
  return points;
}

rc::Gen<RawIndices> further_neighbours() { return list_of(3, 9, raw_index()); }

constexpr Integer kSteps = 8;  // a parameter 1 of a circle, a quarter of it, is so many steps

// Half of a sphere is i² + j² <= kSteps².
IntegerPoint half_sphere(Integer radius, Integer i, Integer j) {
  const Integer denominator = kSteps * kSteps + i * i + j * j;
  return {nearest_integer(radius * 2 * kSteps * i, denominator),
          nearest_integer(radius * 2 * kSteps * j, denominator),
          nearest_integer(radius * (denominator - 2 * kSteps * kSteps), denominator)};
}

// Half of a cylinder is |j| <= kSteps.
IntegerPoint half_cylinder(Integer radius, Integer i, Integer j) {
  const Integer denominator = kSteps * kSteps + j * j;
  return {2 * i, nearest_integer(radius * 2 * kSteps * j, denominator),
          nearest_integer(-radius * (kSteps * kSteps - j * j), denominator)};
}

IntegerPoint paraboloid(Integer flatness, Integer i, Integer j) {
  return {i, j, nearest_integer(i * i + 2 * j * j, flatness)};
}

template <typename Sample>
rc::Gen<IntegerPoints> samples(Integer least_form, Integer most_form, const Sample& sample) {
  return rc::gen::apply(
      [sample](const IntegerPoints& parameters, Integer form) {
        IntegerPoints points;
        for (const auto& [i, j, noise] : parameters) {
          points.push_back(plus(sample(form, i, j), {0, 0, noise / 4}));
        }
        return points;
      },
      list_of(4, 12, integer_point(-5, 5)), whole(least_form, most_form));
}

}  // namespace

rc::Gen<IntegerPoints> rings_of_right_triangles() {
  return rc::gen::map(rings(2, 4), [](const std::vector<Ring>& rings) {
    IntegerPoints points;
    const std::vector<Integer> heights = heights_of(rings);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const Integer norm = ring_norm(heights[k]);
      IntegerPoints triangle = opposite_points(norm, rings[k][1]);
      const IntegerPoints side = on_positive_side(circle_points(norm), quarter_turn(triangle.front()));
      triangle.push_back(at_raw_index(side, rings[k][2]));
      append_at_height(points, triangle, heights[k]);
    }
    return points;
  });
}

rc::Gen<IntegerPoints> rings_of_pairs() {
  return rc::gen::map(rings(3, 5), [](const std::vector<Ring>& rings) {
    IntegerPoints points;
    const std::vector<Integer> heights = heights_of(rings);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const auto& [unused, first, other] = rings[k];
      const Integer norm = ring_norm(heights[k]);
      const IntegerPoints ring = k == 0 ? polygon_around_origin(norm, first, other / 2, other % 2 == 0)
                                        : opposite_points(norm, first);
      append_at_height(points, ring, heights[k]);
    }
    return points;
  });
}

rc::Gen<IntegerPoints> mirrored_points() {
  const auto quarter = rc::gen::apply(
      [](Integer x, Integer y, Integer z) {
        return IntegerPoint{x, y, z};
      },
      whole(0, 4), whole(0, 4), whole(-4, 4));
  return rc::gen::map(list_of(2, 3, quarter), [](const IntegerPoints& some) {
    IntegerPoints points;
    for (const auto& [x, y, z] : some) {
      for (const IntegerPoint& image : {IntegerPoint{x, y, z}, {-x, y, z}, {x, -y, z}, {-x, -y, z}}) {
        points.push_back(image);
      }
    }
    return points;
  });
}

rc::Gen<IntegerPoints> neighbours_on_a_circle() {
  return rc::gen::apply(neighbours, off_centre(), further_neighbours());
}

// Eight times as large, and all but the first three points off by one or not.
rc::Gen<IntegerPoints> neighbours_near_a_circle() {
  constexpr std::size_t kMost = 9;
  return rc::gen::apply(
      [](const OffCentre& circle, const RawIndices& raw, const IntegerPoints& noise) {
        IntegerPoints points = neighbours(circle, raw);
        for (std::size_t k = 0; k < points.size(); ++k) {
          points[k] = plus(times(8, points[k]), k < 3 ? IntegerPoint{0, 0, 0} : noise[k - 3]);
        }
        return points;
      },
      off_centre(), further_neighbours(), rc::gen::container<IntegerPoints>(kMost, integer_point(-1, 1)));
}

rc::Gen<IntegerPoints> opening_combs() {
  using Tooth = std::pair<Integer, Integer>;  // the step to it, and its height
  return rc::gen::apply(
      [](const std::vector<Tooth>& teeth, Integer start, Integer slope, Integer closed) {
        IntegerPoints points;
        Integer t = start;
        for (const auto& [step, height] : teeth) {
          t += step;
          points.push_back({t, points.size() % 2 == 0 ? slope * t : -slope * t, height});
        }
        if (closed % 2 == 1) {
          const Integer foremost = points.front()[0];
          points.push_back({foremost, 0, slope * foremost * 9 / 8 + 1});
        }
        if (closed >= 2) {
          points.push_back({2 * (1 + slope * slope) * t, 0, 0});
        }
        return points;
      },
      list_of(6, 10, rc::gen::pair(whole(1, 3), whole(-1, 1))), whole(1, 8), whole(1, 3), whole(0, 3));
}

rc::Gen<IntegerPoints> open_shell() {
  return rc::gen::oneOf(samples(4, 9, half_sphere), samples(4, 9, half_cylinder), samples(2, 6, paraboloid));
}

}  // namespace flowcert::fuzz
