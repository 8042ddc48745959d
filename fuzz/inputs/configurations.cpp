// Lattice, cospherical, cocircular and right-angled configurations, and those whose orbits are long.
//
// Guarantees: those of configurations.h.
#include "fuzz/inputs/configurations.h"

#include <algorithm>
#include <array>
#include <utility>

namespace flowcert::fuzz {

// ---- Cospherical and cocircular ----

namespace {

using RawIndices = std::vector<std::size_t>;

// Bits 0 to 2 of the code are signs, the rest says which of the six orders.
IntegerPoint signed_permutation(IntegerPoint vector, std::size_t code) {
  std::sort(vector.begin(), vector.end());
  for (std::size_t step = (code / 8) % 6; step > 0; --step) {
    std::next_permutation(vector.begin(), vector.end());
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((code >> axis & 1U) != 0) {
      vector[axis] = -vector[axis];
    }
  }
  return vector;
}

IntegerPoints lattice(Integer width) {
  IntegerPoints all;
  for (Integer code = 0; code < width * width * width; ++code) {
    all.push_back({code / (width * width), code / width % width, code % width});
  }
  return all;
}

IntegerPoints lifted(IntegerPoints flat, Integer height) {
  for (IntegerPoint& point : flat) {
    point[2] = height;
  }
  return flat;
}

}  // namespace

rc::Gen<IntegerPoints> lattice_points(Integer width, std::size_t least, std::size_t most) {
  const IntegerPoints all = lattice(width);
  return rc::gen::map(list_of(least, most, raw_index()),
                      [all](const RawIndices& raw) { return at_raw_indices(all, raw); });
}

rc::Gen<IntegerPoints> signed_permutations(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](const RawIndices& codes, const IntegerPoint& vector) {
        IntegerPoints points;
        for (const std::size_t code : codes) {
          points.push_back(signed_permutation(vector, code));
        }
        return points;
      },
      list_of(least, most, raw_index()), integer_point(0, 7));
}

rc::Gen<IntegerPoints> points_of_a_sphere(std::size_t least, std::size_t most) {
  return rc::gen::apply([](const RawIndices& raw, Integer norm) { return at_raw_indices(sphere_points(norm), raw); },
                        list_of(least, most, raw_index()), sphere_norm());
}

rc::Gen<IntegerPoints> box_corners(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](IntegerPoints corners, const IntegerPoint& sides) {
        for (auto& [x, y, z] : corners) {
          x *= sides[0];
          y *= sides[1];
          z *= sides[2];
        }
        return corners;
      },
      lattice_points(2, least, most), integer_point(1, 6));
}

rc::Gen<IntegerPoints> points_of_a_circle(std::size_t least, std::size_t most) {
  return rc::gen::apply([](const RawIndices& raw, Integer norm) { return at_raw_indices(circle_points(norm), raw); },
                        list_of(least, most, raw_index()), circle_norm());
}

rc::Gen<IntegerPoints> points_of_two_circles(std::size_t least, std::size_t most) {
  return rc::gen::apply(
      [](const std::pair<RawIndices, RawIndices>& raw, Integer lower_norm, Integer upper_norm, Integer height) {
        return joined(at_raw_indices(circle_points(lower_norm), raw.first),
                      lifted(at_raw_indices(circle_points(upper_norm), raw.second), height));
      },
      rc::gen::pair(list_of(least, most, raw_index()), list_of(least, most, raw_index())), circle_norm(), circle_norm(),
      whole(1, 8));
}

rc::Gen<IntegerPoints> any_configuration() {
  const auto any = rc::gen::oneOf(lattice_points(2, 4, 8), lattice_points(3, 4, 8), signed_permutations(4, 8),
                                  points_of_a_sphere(4, 8), box_corners(4, 8), points_of_two_circles(2, 4),
                                  right_angles_12(), right_angles_23(), right_angles_13());
  return rc::gen::map(placed(any), distinct);
}

// ---- For orbits ----
// Configurations whose orbits are long, or run into what orbits rarely meet: Voronoi vertices, and Voronoi edges of
// right triangles.
//
// Rings: the point of height z on the axis has squared distance z² - 2 z z_k + (r_k² + z_k²) to ring k, and
// r_k² + k² is strictly convex in k. So each ring of any choice is nearest somewhere, in turn. Two rings are equally
// far at a height above both iff r_j² - r_i² > (j-i)², which holds for all i < j.
namespace {

// Squared radii of the rings at heights 0, 1, ...
constexpr std::array<Integer, 7> kRings{1, 5, 10, 25, 50, 85, 130};

Integer ring_norm(Integer height) { return kRings[static_cast<std::size_t>(height)]; }

IntegerPoints opposite_points(Integer norm, std::size_t raw) {
  const IntegerPoint a = at_raw_index(circle_points(norm), raw);
  return {a, times(-1, a)};
}

// What a ring is made of: raw indices of its height, its first point and its other one.
using Ring = std::array<std::size_t, 3>;

rc::Gen<std::vector<Ring>> rings(std::size_t least, std::size_t most) {
  const auto ring = rc::gen::apply(
      [](std::size_t height, std::size_t first, std::size_t other) { return Ring{height, first, other}; }, raw_index(),
      raw_index(), raw_index());
  return list_of(least, most, ring);
}

// As many heights as there are rings, ascending.
std::vector<Integer> heights_of(const std::vector<Ring>& rings) {
  IntegerPoints all;
  for (std::size_t k = 0; k < kRings.size(); ++k) {
    all.push_back({static_cast<Integer>(k), 0, 0});
  }
  RawIndices raw;
  for (const Ring& ring : rings) {
    raw.push_back(ring[0]);
  }
  std::vector<Integer> heights;
  for (const auto& [height, unused, also_unused] : at_raw_indices(all, raw)) {
    heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

// A circle around the origin with centre (x, y, 0), and half the length h of an edge whose midpoint is the origin.
// All points of the circle give sides of the edge's Voronoi facet, and one of them is obtuse.
struct OffCentre {
  Integer norm;
  Integer x;
  Integer y;
  Integer h;
};

IntegerPoints shifted_circle(Integer norm, Integer x, Integer y) {
  IntegerPoints points = circle_points(norm);
  for (IntegerPoint& point : points) {
    point = plus(point, {x, y, 0});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const IntegerPoint& a, const IntegerPoint& b) { return dot(a, a) < dot(b, b); });
  return points;
}

// If h² + |c|² < R², the line of each point of the circle touches an ellipse, and no other point has the same
// line: see large_configurations.cpp.
std::vector<OffCentre> all_off_centre() {
  std::vector<OffCentre> all;
  for (const Integer norm : {25, 50, 65, 85, 130}) {
    for (Integer x = 1; x <= 5; ++x) {
      for (Integer y = 0; y <= x; ++y) {
        for (Integer h = 1; h * h + x * x + y * y < norm; ++h) {
          const IntegerPoint nearest = shifted_circle(norm, x, y).front();
          if (dot(nearest, nearest) < h * h) all.push_back({norm, x, y, h});
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

// The circle's point nearest to the origin is always in.
IntegerPoints neighbours(const OffCentre& circle, const RawIndices& raw) {
  IntegerPoints all = shifted_circle(circle.norm, circle.x, circle.y);
  const IntegerPoints points{{0, 0, -circle.h}, {0, 0, circle.h}, all.front()};
  all.erase(all.begin());
  return joined(points, at_raw_indices(all, raw));
}

rc::Gen<RawIndices> further_neighbours() { return list_of(3, 9, raw_index()); }

constexpr Integer kSteps = 8;  // the parameter 1 of a circle, a quarter, is so many steps

// Half of a sphere is i² + j² <= kSteps².
IntegerPoint half_sphere(Integer radius, Integer i, Integer j) {
  const Integer denominator = kSteps * kSteps + i * i + j * j;
  return {nearest_integer(radius * 2 * kSteps * i, denominator), nearest_integer(radius * 2 * kSteps * j, denominator),
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
      points = joined(std::move(points), lifted(triangle, heights[k]));
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
      const IntegerPoints ring =
          k == 0 ? polygon_around_origin(norm, first, other / 2, other % 2 == 0) : opposite_points(norm, first);
      points = joined(std::move(points), lifted(ring, heights[k]));
    }
    return points;
  });
}

rc::Gen<IntegerPoints> mirrored_points() {
  const auto quarter = rc::gen::apply([](Integer x, Integer y, Integer z) { return IntegerPoint{x, y, z}; },
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

// The configuration is eight times as large, and all but the first three points may be off by one.
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

// ---- With right angles ----
// Configurations with a regular stationary point at the origin. They are built and not searched for, because the
// kinds (2,3) and (1,3) are rare among random integer points.
//
// All boundary points have norm N and all others a norm above N, so the
// open ball is empty and the contact set of the origin is the boundary points.
namespace {

// The boundary points, and the others, which are pushed out of the ball if they are in it.
IntegerPoints with_far_points(IntegerPoints boundary, const IntegerPoints& others, Integer norm) {
  for (IntegerPoint point : others) {
    while (dot(point, point) <= norm) {
      point = point == IntegerPoint{0, 0, 0} ? IntegerPoint{1, 0, 0} : times(2, point);
    }
    boundary.push_back(point);
  }
  return boundary;
}

rc::Gen<IntegerPoints> further_points(std::size_t least) { return list_of(least, 4, integer_point(-12, 12)); }

// A vector that is orthogonal to this one, and not zero.
IntegerPoint any_normal(const IntegerPoint& point) {
  const IntegerPoint normal = cross(point, {0, 0, 1});
  return normal == IntegerPoint{0, 0, 0} ? IntegerPoint{1, 0, 0} : normal;
}

}  // namespace

rc::Gen<IntegerPoints> right_angles_12() {
  return rc::gen::apply(
      [](Integer norm, std::size_t first, const RawIndices& others, const IntegerPoints& far) {
        const IntegerPoint a = at_raw_index(circle_points(norm), first);
        const IntegerPoints side = on_positive_side(circle_points(norm), quarter_turn(a));
        return with_far_points(joined({a, times(-1, a)}, at_raw_indices(side, others)), far, norm);
      },
      circle_norm(), raw_index(), list_of(1, 3, raw_index()), further_points(1));
}

rc::Gen<IntegerPoints> right_angles_23() {
  return rc::gen::apply(
      [](Integer norm, const std::pair<std::size_t, std::size_t>& corners, bool square, const RawIndices& others,
         const IntegerPoints& far) {
        const IntegerPoints polygon = polygon_around_origin(norm, corners.first, corners.second, square);
        const IntegerPoints side = on_positive_side(sphere_points(norm), {0, 0, 1});
        return with_far_points(joined(polygon, at_raw_indices(side, others)), far, norm);
      },
      circle_norm(), rc::gen::pair(raw_index(), raw_index()),
      rc::gen::map(whole(0, 2), [](Integer dice) { return dice == 2; }), list_of(1, 3, raw_index()), further_points(0));
}

rc::Gen<IntegerPoints> right_angles_13() {
  return rc::gen::apply(
      [](Integer norm, std::size_t first, const RawIndices& others, const IntegerPoints& far) {
        const IntegerPoint a = at_raw_index(sphere_points(norm), first);
        const IntegerPoints side = on_positive_side(sphere_points(norm), any_normal(a));
        return with_far_points(joined({a, times(-1, a)}, at_raw_indices(side, others)), far, norm);
      },
      sphere_norm(), raw_index(), list_of(2, 4, raw_index()), further_points(0));
}

}  // namespace flowcert::fuzz
