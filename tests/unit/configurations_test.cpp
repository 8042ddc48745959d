// The generators' configurations, small and large: that each has the geometry that it is named for.
//
// Guarantees: exact, in integers of any size, by geometry that is written down here.
#include "fuzz/inputs/configurations.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/large_configurations.h"

namespace flowcert::fuzz::configurations_test {
namespace {

constexpr std::uint64_t kSeeds = 60;

bool is_integer(double value) { return value == std::floor(value); }

std::size_t distinct_rows(const Input& input) { return std::set<Row>(input.rows.begin(), input.rows.end()).size(); }

TEST(RightAngles, HaveAnEmptyBallWithItsCentreOnAFace) {
  for (const auto& configuration : {right_angles_12(), right_angles_23(), right_angles_13()}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const IntegerPoints points = configuration(rc::Random(seed), 100).value();
      const Integer norm = dot(points.front(), points.front());
      EXPECT_GE(std::count_if(points.begin(), points.end(), [&](const auto& p) { return dot(p, p) == norm; }), 3);
      EXPECT_TRUE(std::all_of(points.begin(), points.end(), [&](const auto& p) { return dot(p, p) >= norm; }));
    }
  }
}

// Integers of any size.
using Number = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using NumberPoint = std::array<Number, 3>;

std::vector<NumberPoint> to_numbers(const Input& input) {
  std::vector<NumberPoint> points;
  for (const Row& row : input.rows) {
    EXPECT_TRUE(std::all_of(row.begin(), row.end(), is_integer));
    points.push_back({Number(row[0]), Number(row[1]), Number(row[2])});
  }
  return points;
}

NumberPoint operator-(const NumberPoint& a, const NumberPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
NumberPoint operator+(const NumberPoint& a, const NumberPoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
NumberPoint operator*(const Number& factor, const NumberPoint& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
Number inner(const NumberPoint& a, const NumberPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The sign of the angle at q over an edge: positive acute, zero right, negative obtuse.
Number angle_sign(const NumberPoint& q, const NumberPoint& p0, const NumberPoint& p1) { return inner(q - p0, q - p1); }

struct Fraction {
  Number numerator;
  Number denominator;  // positive

  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};

struct Facet {
  std::size_t sides = 0;
  bool is_bounded = true;
};

// The facet { v : 2<v,q> <= |q|² - h² for all q } of the edge from (0,0,-h) to (0,0,h), the first two rows.
// Each further row gives the facet a side, unless its line is redundant.
Facet facet_of(const std::vector<NumberPoint>& points) {
  const auto bound = [&](const NumberPoint& q) { return angle_sign(q, points[0], points[1]); };
  Facet facet;
  for (std::size_t i = 2; i < points.size(); ++i) {
    // The points of row i's line are v = (bound <q,q> + t (-q_y, q_x)) / 2 <q,q>.
    const auto& [x, y, unused] = points[i];
    const Number norm = x * x + y * y;
    std::optional<Fraction> first;
    std::optional<Fraction> last;
    bool cut_off = false;
    for (std::size_t j = 2; j < points.size(); ++j) {
      const auto& [other_x, other_y, also_unused] = points[j];
      const Number slope = x * other_y - y * other_x;
      const Number room = bound(points[j]) * norm - bound(points[i]) * (x * other_x + y * other_y);
      if (slope > 0) {
        last = std::min(last.value_or(Fraction{room, slope}), Fraction{room, slope});
      } else if (slope < 0) {
        first = std::max(first.value_or(Fraction{-room, -slope}), Fraction{-room, -slope});
      } else if (j != i) {
        cut_off = cut_off || room <= 0;
      }
    }
    if (!cut_off && (!first || !last || *first < *last)) {
      facet.sides += 1;
      facet.is_bounded = facet.is_bounded && first && last;
    }
  }
  return facet;
}

bool has_obtuse_neighbour(const std::vector<NumberPoint>& points) {
  return std::any_of(points.begin() + 2, points.end(),
                     [&](const NumberPoint& q) { return angle_sign(q, points[0], points[1]) < 0; });
}

// All other points lie outside of the ball whose diameter the edge is.
bool is_critical_edge(const std::vector<NumberPoint>& points, const NumberPoint& p0, const NumberPoint& p1) {
  return std::all_of(points.begin(), points.end(),
                     [&](const NumberPoint& q) { return q == p0 || q == p1 || angle_sign(q, p0, p1) > 0; });
}

// The triangle is acute, and all other points lie outside of the ball around its centre through its corners.
// The centre's barycentric coordinates are as the corners' cosines times the squares of the opposite sides.
bool is_critical_triangle(const std::vector<NumberPoint>& points, const std::array<NumberPoint, 3>& corners) {
  Number weight_sum = 0;
  NumberPoint weighted_sum{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const NumberPoint& p0 = corners[(k + 1) % 3];
    const NumberPoint& p1 = corners[(k + 2) % 3];
    const Number cosine = angle_sign(corners[k], p0, p1);
    if (cosine <= 0) {
      return false;
    }
    const Number weight = cosine * inner(p1 - p0, p1 - p0);
    weight_sum += weight;
    weighted_sum = weighted_sum + weight * corners[k];
  }
  return std::all_of(points.begin(), points.end(), [&](const NumberPoint& q) {
    const NumberPoint& p = corners[0];
    const bool is_corner = std::find(corners.begin(), corners.end(), q) != corners.end();
    return is_corner || weight_sum * inner(q - p, q + p) > 2 * inner(q - p, weighted_sum);
  });
}

// All rows from the third on are on one circle of the plane z = 0.
bool are_cocircular(const std::vector<NumberPoint>& points) {
  const auto lifted = [&](std::size_t k) -> NumberPoint {
    const NumberPoint d = points[k] - points[2];
    return {d[0], d[1], inner(d, d)};
  };
  for (std::size_t k = 5; k < points.size(); ++k) {
    const NumberPoint u = lifted(3);
    const NumberPoint v = lifted(4);
    const NumberPoint w = lifted(k);
    if (points[k][2] != 0 ||
        u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]) !=
            0) {
      return false;
    }
  }
  return true;
}

// How many facets the flow from the midpoint of the first two rows crosses in this direction, before it
// reaches infinity or a side whose triangle is not obtuse. u is x - m, times something. At the side of q,
// whose triangle is obtuse at q', an end of the edge, the flow enters the facet of q and the other end, and u
// becomes <u,2q-p0-p1> (q' - q) + 2 h(q) u.
std::size_t facets_crossed(const std::vector<NumberPoint>& points, const NumberPoint& direction) {
  NumberPoint p0 = points[0];
  NumberPoint p1 = points[1];
  const NumberPoint edge = p1 - p0;
  NumberPoint u = inner(edge, edge) * direction - inner(direction, edge) * edge;
  for (std::size_t crossed = 1;; ++crossed) {
    std::optional<Fraction> nearest;
    NumberPoint exit;
    for (const NumberPoint& q : points) {
      const Fraction time{angle_sign(q, p0, p1), inner(u, q - p0 + (q - p1))};
      if (time.numerator > 0 && time.denominator > 0 && (!nearest || time < *nearest)) {
        nearest = time;
        exit = q;
      }
    }
    if (!nearest) {
      return crossed;
    }
    NumberPoint dropped;
    if (angle_sign(p0, exit, p1) < 0) {
      dropped = std::exchange(p0, exit);
    } else if (angle_sign(p1, exit, p0) < 0) {
      dropped = std::exchange(p1, exit);
    } else {
      return crossed;
    }
    u = nearest->denominator * (dropped - exit) + 2 * nearest->numerator * u;
  }
}

TEST(OrbitConfigurations, NeighboursOnACircleAreAllGoodForASide) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto exact = to_numbers(to_input(neighbours_on_a_circle()(rc::Random(seed), 100).value()));
    const auto perturbed = to_numbers(to_input(neighbours_near_a_circle()(rc::Random(seed), 100).value()));
    EXPECT_TRUE(are_cocircular(exact));
    EXPECT_EQ(facet_of(exact).sides, exact.size() - 2);
    for (const auto& points : {exact, perturbed}) {
      EXPECT_EQ(points[0], (NumberPoint{0, 0, -points[1][2]}));
      EXPECT_LT(angle_sign(points[2], points[0], points[1]), 0);
    }
  }
}

TEST(OrbitConfigurations, CombsAreCrossedToothByTooth) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto points = to_numbers(to_input(opening_combs()(rc::Random(seed), 100).value()));
    const auto teeth = std::count_if(points.begin(), points.end(), [](const auto& p) { return p[1] != 0; });
    EXPECT_GE(teeth, 6);
    EXPECT_GE(facets_crossed(points, {1, 0, 0}), static_cast<std::size_t>(teeth) - 1);
  }
}

// Between two consecutive rings the axis has a point, above both, that is equally near to all their points,
// and nearer to them than to any other.
TEST(OrbitConfigurations, RingsTakeTurnsAlongTheirAxis) {
  for (const auto& configuration : {rings_of_right_triangles(), rings_of_pairs()}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const IntegerPoints points = configuration(rc::Random(seed), 100).value();
      std::set<Integer> heights;
      for (const IntegerPoint& point : points) {
        heights.insert(point[2]);
      }
      for (auto low = heights.begin(); std::next(low) != heights.end(); ++low) {
        const Integer high = *std::next(low);
        const auto at = [&](Integer height) {
          return *std::find_if(points.begin(), points.end(),
                               [&](const IntegerPoint& point) { return point[2] == height; });
        };
        // The height is meeting / (2 (high - low)).
        const Integer meeting = dot(at(high), at(high)) - dot(at(*low), at(*low));
        EXPECT_GT(meeting, 2 * (high - *low) * high);
        const auto distance = [&](const IntegerPoint& point) {
          return (high - *low) * dot(point, point) - meeting * point[2];
        };
        for (const IntegerPoint& point : points) {
          if (point[2] == *low || point[2] == high) {
            EXPECT_EQ(distance(point), distance(at(high)));
          } else {
            EXPECT_GT(distance(point), distance(at(high)));
          }
        }
      }
    }
  }
}

TEST(OrbitConfigurations, MirroredPointsAre) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const IntegerPoints points = mirrored_points()(rc::Random(seed), 100).value();
    for (const auto& [x, y, z] : points) {
      EXPECT_EQ(std::count(points.begin(), points.end(), IntegerPoint{-x, y, z}),
                std::count(points.begin(), points.end(), IntegerPoint{x, -y, z}));
      EXPECT_NE(std::find(points.begin(), points.end(), IntegerPoint{-x, y, z}), points.end());
      EXPECT_NE(std::find(points.begin(), points.end(), IntegerPoint{x, -y, z}), points.end());
    }
  }
}

TEST(LargeConfigurations, AreFunctionsOfTheirArguments) {
  const std::vector<std::function<Input(std::uint64_t)>> all{
      [](std::uint64_t seed) { return high_degree_facet(1000, false, seed); },
      [](std::uint64_t seed) { return high_degree_facet(1000, true, seed); },
      [](std::uint64_t seed) { return half_shell(1002, seed); },
      [](std::uint64_t seed) { return long_cascade(1002, seed); }};
  for (const auto& made : all) {
    const Input input = made(1);
    EXPECT_EQ(input.rows.size(), 1002U);
    EXPECT_EQ(distinct_rows(input), input.rows.size());
    EXPECT_EQ(input, made(1));
    EXPECT_NE(input, made(2));
    for (const Row& row : input.rows) {
      for (const double x : row) {
        EXPECT_TRUE(is_integer(x) && std::abs(x) < 0x1p51);
      }
    }
  }
}

TEST(LargeConfigurations, RefuseWhatTheyCannotServe) {
  EXPECT_THROW(high_degree_facet(9, false, 1), std::invalid_argument);
  EXPECT_THROW(high_degree_facet(100'001, true, 1), std::invalid_argument);
  EXPECT_THROW(long_cascade(7, 1), std::invalid_argument);
  EXPECT_TRUE(half_shell(0, 1).rows.empty());
}

TEST(LargeConfigurations, FacetsHaveTheirDegree) {
  for (const bool perturbed : {false, true}) {
    for (const std::size_t degree : {10U, 11U, 37U, 200U}) {
      for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto points = to_numbers(high_degree_facet(degree, perturbed, seed));
        ASSERT_EQ(points.size(), degree + 2);
        EXPECT_EQ(points[0], (NumberPoint{0, 0, -points[1][2]}));
        const Facet facet = facet_of(points);
        EXPECT_EQ(facet.sides, degree) << perturbed << ' ' << seed;
        EXPECT_TRUE(facet.is_bounded) << degree << ' ' << perturbed << ' ' << seed;
        EXPECT_TRUE(has_obtuse_neighbour(points)) << degree << ' ' << perturbed << ' ' << seed;
        EXPECT_EQ(are_cocircular(points), !perturbed);
      }
    }
  }
  EXPECT_EQ(distinct_rows(high_degree_facet(100'000, false, 1)), 100'002U);
}

TEST(LargeConfigurations, CascadesCrossAllTeeth) {
  for (const std::size_t rows : {8U, 9U, 50U, 300U}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      const auto points = to_numbers(long_cascade(rows, seed));
      EXPECT_TRUE(is_critical_edge(points, points[0], points[1])) << rows;
      EXPECT_TRUE(is_critical_triangle(points, {points[0], points[1], points[2]})) << rows;
      EXPECT_TRUE(is_critical_triangle(points, {points[rows - 2], points[rows - 1], points[3]})) << rows;
      // A facet between the first two teeth, and another one for each tooth that follows.
      EXPECT_GE(facets_crossed(points, {1, 0, 0}), rows - 3) << seed;
    }
  }
}

}  // namespace
}  // namespace flowcert::fuzz::configurations_test
