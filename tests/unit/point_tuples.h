// Tuples of points to try predicates on, of the kinds on which inexact geometry fails: generic points,
// degenerate ones, and degenerate ones up to rounding or one ulp. Other kinds are far from the origin, at the
// ends of the range of doubles, or at the limit of the fixed-size integers.
//
// Guarantees: a function of the random numbers given; all coordinates are finite. Points may coincide.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "flowcert/point_set.h"
#include "geometry/integer_grid.h"
#include "geometry/predicates.h"
#include "tests/unit/portable_random.h"

namespace flowcert_tests {

enum class TupleKind {
  kGeneric,     // 53 random bits a coordinate
  kLattice,     // coordinates -2 to 2: flat, right-angled, cospherical
  kSpherical,   // signed permutations of one integer vector, moved: always cospherical, half cocircular
  kRounded,     // spherical ones, scaled, turned and moved in doubles
  kOneUlp,      // lattice and spherical ones, one coordinate of one point moved by one ulp
  kFarOff,      // a lattice around a point 10^15 away
  kMagnitudes,  // coordinates of exponents from -1000 to 1000
  kSubnormal,   // a lattice at the smallest subnormal, or across the border to the normal doubles
  kNearRight,   // a right angle up to rounding, of three generic points; the others generic too
  kWidest,      // coordinates that span kWideBits bits on their grid, or one more
  kNarrow,      // the same with kNarrowBits
  kSmall,       // the same with kSmallBits
};
inline constexpr std::array kTupleKinds = {TupleKind::kGeneric,    TupleKind::kLattice,   TupleKind::kSpherical,
                                           TupleKind::kRounded,    TupleKind::kOneUlp,    TupleKind::kFarOff,
                                           TupleKind::kMagnitudes, TupleKind::kSubnormal, TupleKind::kNearRight,
                                           TupleKind::kWidest,     TupleKind::kNarrow,    TupleKind::kSmall};

inline double& coordinate_of(flowcert::Point& p, std::size_t k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

template <std::size_t N>
std::array<flowcert::Point, N> spherical_tuple(PortableRandom& random) {
  const std::array<double, 3> vector = {double(random.between(0, 9)), double(random.between(0, 9)),
                                        double(random.between(1, 9))};
  const flowcert::Point center{double(random.between(-40, 40)), double(random.between(-40, 40)),
                               double(random.between(-40, 40))};
  const bool on_circle = random.coin();
  std::array<flowcert::Point, N> points;
  for (flowcert::Point& p : points) {
    const std::size_t turn = on_circle ? 0 : random.below(3);
    const bool swapped = random.coin();
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = vector[(k + turn) % 3];
      coordinate_of(p, k) = random.coin() && !(on_circle && k == 2) ? -value : value;
    }
    if (swapped) std::swap(p.x, p.y);
    p = {p.x + center.x, p.y + center.y, p.z + center.z};
  }
  return points;
}

template <std::size_t N>
std::array<flowcert::Point, N> scaled_lattice_tuple(PortableRandom& random, int width, double unit, double offset) {
  std::array<flowcert::Point, N> points;
  for (flowcert::Point& p : points) {
    for (std::size_t k = 0; k < 3; ++k) coordinate_of(p, k) = offset + unit * random.between(-width, width);
  }
  return points;
}

// Turns, shrinks and moves the point, rounded at each step. Points that were cospherical, or cocircular in a
// plane of constant z, are so no more, by a few ulps.
inline flowcert::Point rounded_image(const flowcert::Point& p, bool is_level, double offset) {
  const double x = 0.8 * p.x - 0.6 * p.y, y = 0.6 * p.x + 0.8 * p.y;
  const double u = is_level ? x : 0.28 * x - 0.96 * p.z, w = is_level ? p.z : 0.96 * x + 0.28 * p.z;
  return {offset + 0.1 * u, 0.3 + 0.1 * y, offset + 0.1 * w};
}

template <std::size_t N>
std::array<flowcert::Point, N> draw_tuple(TupleKind kind, PortableRandom& random) {
  std::array<flowcert::Point, N> points;
  switch (kind) {
    case TupleKind::kGeneric:
      for (flowcert::Point& p : points) p = {random.coordinate(), random.coordinate(), random.coordinate()};
      break;
    case TupleKind::kLattice:
      points = scaled_lattice_tuple<N>(random, 2, 1.0, 0.0);
      break;
    case TupleKind::kSpherical:
      points = spherical_tuple<N>(random);
      break;
    case TupleKind::kRounded: {
      points = random.coin() ? spherical_tuple<N>(random) : scaled_lattice_tuple<N>(random, 2, 1.0, 0.0);
      const double offset = random.coin() ? 0.7 : 1e6;
      const bool is_level = random.coin();
      for (flowcert::Point& p : points) p = rounded_image(p, is_level, offset);
      break;
    }
    case TupleKind::kOneUlp: {
      points = random.coin() ? spherical_tuple<N>(random) : scaled_lattice_tuple<N>(random, 2, 1.0, 4.0);
      const double far = random.coin() ? 1e300 : -1e300;
      double& moved = coordinate_of(points[random.below(N)], random.below(3));
      moved = std::nextafter(moved, far);
      break;
    }
    case TupleKind::kFarOff:
      points = scaled_lattice_tuple<N>(random, 2, 0.125, 1e15);
      break;
    case TupleKind::kMagnitudes:
      for (flowcert::Point& p : points) {
        for (std::size_t k = 0; k < 3; ++k) {
          coordinate_of(p, k) = std::ldexp(random.coordinate(), random.between(-1000, 1000));
        }
      }
      break;
    case TupleKind::kSubnormal:
      points = scaled_lattice_tuple<N>(random, 2, random.coin() ? std::numeric_limits<double>::denorm_min() : 0x1p-1023,
                                       0.0);
      break;
    case TupleKind::kNearRight: {
      points = draw_tuple<N>(TupleKind::kGeneric, random);
      const flowcert::Point u = points[0], w = points[2], corner = points[1];
      points[0] = {corner.x + u.x, corner.y + u.y, corner.z + u.z};
      points[2] = {corner.x + (u.y * w.z - u.z * w.y), corner.y + (u.z * w.x - u.x * w.z),
                   corner.z + (u.x * w.y - u.y * w.x)};
      break;
    }
    case TupleKind::kWidest:
    case TupleKind::kNarrow: {
      // The numbers (2^53 - k) 2^(bits - 53) are the largest ones below 2^bits. One coordinate 1 fixes the grid.
      const int bits = kind == TupleKind::kWidest ? flowcert::geometry::kWideBits : flowcert::geometry::kNarrowBits;
      const int top = bits - 53 + random.between(0, 1);
      for (flowcert::Point& p : points) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double value = std::ldexp(0x1p53 - random.between(1, 3), top);
          coordinate_of(p, k) = random.coin() ? value : -value;
        }
      }
      coordinate_of(points[random.below(N)], random.below(3)) = random.coin() ? 1.0 : -1.0;
      break;
    }
    case TupleKind::kSmall: {
      const double beyond = std::ldexp(1.0, flowcert::geometry::kSmallBits + random.between(0, 1));
      for (flowcert::Point& p : points) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double value = beyond - random.between(1, 3);
          coordinate_of(p, k) = random.coin() ? value : -value;
        }
      }
      coordinate_of(points[random.below(N)], random.below(3)) = random.coin() ? 1.0 : -1.0;
      break;
    }
  }
  return points;
}

// Moves the points into one plane, exactly. Small integers may come into a plane that is tilted against all axes.
template <std::size_t N>
void flatten(std::array<flowcert::Point, N>& t, PortableRandom& random) {
  const bool is_small = std::all_of(t.begin(), t.end(), [](const flowcert::Point& p) {
    const auto small = [](double c) { return c == std::floor(c) && std::fabs(c) < 1e6; };
    return small(p.x) && small(p.y) && small(p.z);
  });
  const double level = t[0].z;
  const std::size_t way = random.below(is_small ? 5 : 4);
  for (flowcert::Point& p : t) {
    const double x = p.x, y = p.y;
    if (way == 0) p = {x, y, level};
    if (way == 1) p = {y, level, x};
    if (way == 2) p = {level, x, y};
    if (way == 3) p = {x, y, -x};
    // Along (1,2,2) and (2,1,-2), which are orthogonal and of one length: circles stay circles.
    if (way == 4) p = {x + 2 * y, 2 * x + y, 2 * x - 2 * y};
  }
}

// The first four points are positively oriented and not flat, as in a cell.
template <std::size_t N>
std::array<flowcert::Point, N> draw_cell(TupleKind kind, PortableRandom& random) {
  using flowcert::geometry::Orientation, flowcert::geometry::Sign;
  for (;;) {
    std::array<flowcert::Point, N> points = draw_tuple<N>(kind, random);
    const Sign orientation =
        flowcert::geometry::unfiltered_sign(Orientation{points[0], points[1], points[2], points[3]});
    if (orientation == Sign::kZero) continue;
    if (orientation == Sign::kNegative) std::swap(points[2], points[3]);
    return points;
  }
}

}  // namespace flowcert_tests
