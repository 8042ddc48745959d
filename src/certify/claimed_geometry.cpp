#include "certify/claimed_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/contract.h"
#include "geometry/enclosing_ball.h"
#include "geometry/integer_grid.h"
#include "geometry/predicates.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

// ---- Contact sets ----

namespace {

Sign orientation(const PointSet& points, std::span<const PointId> plane, PointId q) {
  FilterTally unused;
  return exact_sign(
      Orientation{sample(points, plane[0]), sample(points, plane[1]), sample(points, plane[2]), sample(points, q)},
      unused);
}

}  // namespace

const Point& sample(const PointSet& points, PointId name) { return points.at_row(name); }

bool all_on_sphere(const PointSet& points, std::span<const PointId> names, const ExactSphere& sphere) {
  return std::all_of(names.begin(), names.end(), [&](PointId name) {
    return squared_distance(sphere.center, sample(points, name)) == sphere.squared_radius;
  });
}

int affine_dimension(const PointSet& points, std::span<const PointId> names) {
  FLOWCERT_REQUIRES(!names.empty());
  if (names.size() < 4) return static_cast<int>(names.size()) - 1;
  const bool is_flat = std::all_of(names.begin() + 3, names.end(),
                                   [&](PointId name) { return orientation(points, names, name) == Sign::kZero; });
  return is_flat ? 2 : 3;
}

std::vector<PointId> supported_face(const PointSet& points, std::span<const PointId> plane,
                                    std::span<const PointId> of) {
  FLOWCERT_REQUIRES(plane.size() >= 3);
  std::vector<PointId> face;
  Sign side = Sign::kZero;
  for (const PointId name : of) {
    const Sign sign = orientation(points, plane, name);
    if (sign == Sign::kZero) {
      face.push_back(name);
    } else if (side == Sign::kZero) {
      side = sign;
    } else if (sign != side) {
      return {};
    }
  }
  return face;
}

bool turn_alike(const PointSet& points, std::span<const PointId> a, std::span<const PointId> b) {
  FLOWCERT_REQUIRES(a.size() >= 3 && b.size() >= 3);
  const auto normal = [&points](std::span<const PointId> names) {
    const auto at = [&](std::size_t k) { return exact_position(sample(points, names[k])); };
    return normal_of(at(0), at(1), at(2));
  };
  return dot(normal(a), normal(b)) > 0;
}

// It is then the centre of the smallest ball that encloses them iff it lies in their hull.
bool has_in_hull(const PointSet& points, std::span<const PointId> names, const RationalPoint& center) {
  std::vector<Point> coordinates;
  coordinates.reserve(names.size());
  for (const PointId name : names) coordinates.push_back(sample(points, name));
  return enclosing_ball_center(coordinates) == center;
}

// ---- Values ----

double as_double(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  if (nearest) return *nearest;
  return std::numeric_limits<double>::max() * (value > 0 ? 1 : -1);
}

std::array<double, 3> as_doubles(const RationalPoint& position) {
  return {as_double(position[0]), as_double(position[1]), as_double(position[2])};
}

namespace {

// Avoids the difference of rationals, which costs most: exact values must be equal, and decimals must round to the
// same double.
bool matches_at_once(const ClaimedPosition& claimed, const RationalPoint& truth) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational& value = claimed[axis].value;
    if (claimed[axis].is_exact ? value != truth[axis] : !rounds_alike(value, truth[axis])) return false;
  }
  return true;
}

ValueMatch wrong(bool by_rounding) { return by_rounding ? ValueMatch::kRounding : ValueMatch::kOff; }

}  // namespace

bool rounds_alike(const Rational& a, const Rational& b) {
  const std::optional<double> x = nearest_double(a), y = nearest_double(b);
  return x && y && *x == *y;
}

namespace {

// The square of the larger of the radius and the largest coordinate.
Rational squared_extent(const ExactSphere& sphere) {
  const Rational coordinate = greatest_coordinate(sphere.center);
  return std::max(sphere.squared_radius, Rational(coordinate * coordinate));
}

// Whether the roots d and r of two numbers differ by no more than a length t: iff d^2 + r^2 - t^2 <= 2 d r.
bool roots_are_within(const Rational& a, const Rational& b, const Rational& squared_length) {
  const Rational left = a + b - squared_length;
  return left <= 0 || left * left <= 4 * a * b;
}

}  // namespace

double rounding_length(const ExactSphere& sphere) {
  // A square can be beyond the doubles where its root is none of these.
  const Rational square = squared_extent(sphere);
  if (square == 0) return 0;
  const auto bits = [](const geometry::BigInteger& x) { return static_cast<int>(boost::multiprecision::msb(x)); };
  const int half = (bits(numerator(square)) - bits(denominator(square))) / 2;
  const geometry::BigInteger scale = geometry::BigInteger(1) << (2 * std::abs(half));
  const Rational scaled = half < 0 ? Rational(square * scale) : Rational(square / scale);
  return std::min(std::ldexp(std::sqrt(as_double(scaled)), half), std::numeric_limits<double>::max());
}

Rational squared_rounding(const ExactSphere& sphere) {
  const Rational part(kRoundingPart);
  return part * part * squared_extent(sphere);
}

bool is_rounding(const Rational& squared_a, const Rational& squared_b, const Rational& squared_rounding) {
  return roots_are_within(squared_a, squared_b, squared_rounding);
}

Rational ValueScale::squared_allowance() const {
  const Rational squared_length = sphere_.squared_radius == 0 ? squared_extent(sphere_) : sphere_.squared_radius;
  const Rational exact_tolerance(tolerance_);
  return exact_tolerance * exact_tolerance * squared_length;
}

Rational ValueScale::squared_rounding() const { return certify::squared_rounding(sphere_); }

ValueMatch match_volume(const ClaimedNumber& claimed, const Rational& truth, double tolerance) {
  if (claimed.value == truth) return claimed.is_exact ? ValueMatch::kEqual : ValueMatch::kWithin;
  const Rational off = abs(Rational(claimed.value - truth));
  const bool is_near = !claimed.is_exact && (rounds_alike(claimed.value, truth) || off <= Rational(tolerance) * truth);
  if (is_near) return ValueMatch::kWithin;
  return off <= Rational(kRoundingPart) * truth ? ValueMatch::kRounding : ValueMatch::kOff;
}

bool is_exact(const ClaimedPosition& claimed) {
  return claimed[0].is_exact && claimed[1].is_exact && claimed[2].is_exact;
}

RationalPoint values_of(const ClaimedPosition& claimed) {
  return {claimed[0].value, claimed[1].value, claimed[2].value};
}

ValueMatch match_position(const ClaimedPosition& claimed, const RationalPoint& truth, const ValueScale& scale) {
  if (matches_at_once(claimed, truth)) return is_exact(claimed) ? ValueMatch::kEqual : ValueMatch::kWithin;
  Rational off_exactly = 0, off_by_decimals = 0;  // squared
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational difference = claimed[axis].value - truth[axis];
    if (difference == 0) continue;
    (claimed[axis].is_exact ? off_exactly : off_by_decimals) += difference * difference;
  }
  if (off_exactly == 0 && off_by_decimals <= scale.squared_allowance()) return ValueMatch::kWithin;
  return wrong(is_rounding(off_exactly + off_by_decimals, 0, scale.squared_rounding()));
}

ValueMatch match_double(const std::optional<ClaimedNumber>& claimed, const Rational& truth, const ValueScale& scale) {
  if (claimed.has_value() != nearest_double(truth).has_value()) return ValueMatch::kOff;
  const ClaimedNumber zero{0, true};
  return claimed ? match_position({*claimed, zero, zero}, {truth, 0, 0}, scale) : ValueMatch::kEqual;
}

ValueMatch match_vector(const ClaimedPosition& claimed, const RationalPoint& truth, double tolerance) {
  const auto is_zero = [](const ClaimedNumber& coordinate) { return coordinate.value == 0; };
  if (std::ranges::all_of(claimed, is_zero)) return ValueMatch::kOff;
  const RationalPoint a = as_direction(values_of(claimed)), b = as_direction(truth);
  if (a == b) return is_exact(claimed) ? ValueMatch::kEqual : ValueMatch::kWithin;
  Rational most = 0;
  bool is_near = !is_exact(claimed);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational off = abs(Rational(a[axis] - b[axis]));
    is_near = is_near && (off <= Rational(tolerance) || rounds_alike(a[axis], b[axis]));
    most = std::max(most, off);
  }
  if (is_near) return ValueMatch::kWithin;
  return most <= Rational(kRoundingPart) ? ValueMatch::kRounding : ValueMatch::kOff;
}

ValueMatch match_distance(const ClaimedNumber& claimed, const Rational& squared_radius, const ValueScale& scale) {
  if (claimed.value < 0) return ValueMatch::kOff;
  return match_squared_distance({claimed.value * claimed.value, claimed.is_exact}, squared_radius, scale);
}

ValueMatch match_squared_distance(const ClaimedNumber& claimed, const Rational& squared_radius,
                                  const ValueScale& scale) {
  const Rational& square = claimed.value;
  if (square < 0) return ValueMatch::kOff;
  if (square == squared_radius) return claimed.is_exact ? ValueMatch::kEqual : ValueMatch::kWithin;
  if (!claimed.is_exact) {
    if (rounds_alike(square, squared_radius)) return ValueMatch::kWithin;
    if (roots_are_within(square, squared_radius, scale.squared_allowance())) return ValueMatch::kWithin;
  }
  return wrong(is_rounding(square, squared_radius, scale.squared_rounding()));
}

}  // namespace flowcert::certify
