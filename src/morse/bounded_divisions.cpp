#include "morse/bounded_divisions.h"

#include <algorithm>
#include <cmath>

#include "geometry/bounded_number.h"
#include "morse/polygon_turn.h"

namespace flowcert::morse {

namespace {

using Kind = DivisionPoint::Kind;

using geometry::doubled;

// Every term here is a sum of products of at most five differences: fewer than 64 roundings of the product of the sizes.
constexpr double kShare = 64 * DoubleDouble::kRoundoff;
constexpr double kUnderflow = geometry::kBoundedUnderflow;

double length_of(const Vector3<DoubleDouble>& v) {
  return std::sqrt(v.x.high() * v.x.high() + v.y.high() * v.y.high() + v.z.high() * v.z.high()) *
         geometry::kBoundedSlack;
}

// The terms of an ApexPair with their bounds.
struct BoundedPair {
  BoundedPair(const Vector3<DoubleDouble>& e, const Vector3<DoubleDouble>& d, const Vector3<DoubleDouble>& d_other)
      : pair(e, d, d_other), length_e(length_of(e)), length_d(length_of(d)), length_other(length_of(d_other)) {}

  [[nodiscard]] BoundedNumber length() const { return {pair.length, kShare * length_e * length_e + kUnderflow}; }
  [[nodiscard]] BoundedNumber height() const {
    return {pair.height, kShare * length_d * (length_d + length_e) + kUnderflow};
  }
  [[nodiscard]] BoundedNumber height_other() const {
    return {pair.height_other, kShare * length_other * (length_other + length_e) + kUnderflow};
  }
  [[nodiscard]] BoundedNumber det() const {
    return {pair.det, kShare * length_e * length_d * length_other + kUnderflow};
  }
  [[nodiscard]] BoundedNumber gram() const {
    return {pair.gram, kShare * length_e * length_e * length_d * length_other + kUnderflow};
  }

  ApexPair<DoubleDouble> pair;
  double length_e, length_d, length_other;
};

// vertex_parameter()
BoundedNumber bounded_vertex(const BoundedPair& pair, const Vector3<DoubleDouble>& d) {
  const DoubleDouble square = pair.pair.length * dot(d, d) - pair.pair.along * pair.pair.along;
  const double sizes = pair.length_e * pair.length_d;
  const BoundedNumber squares{square, kShare * sizes * sizes + kUnderflow};
  return (squares * pair.height_other() - pair.height() * pair.gram()) / doubled(pair.det());
}

// crossed_parameter()
BoundedNumber bounded_crossing(const BoundedPair& pair, const BoundedNumber& r) {
  const BoundedNumber twice = doubled(r);
  const BoundedNumber den = pair.height() * pair.gram() + twice * pair.det();
  const BoundedNumber away = pair.height() * pair.length() * pair.det();
  return pair.height_other() * (twice * pair.gram() - away) / doubled(den);
}

}  // namespace

BoundedDivisions::BoundedDivisions(const VoronoiDiagram& diagram, const LimitPartition& partition)
    : diagram_(diagram), partition_(partition) {
  double largest = 0;
  for (const Point& p : diagram.delaunay().points) {
    largest = std::max(largest, greatest_coordinate(p));
  }
  // Numbers near the ends of the exponents cannot be scaled; exact ones decide then.
  unit_ = largest > 0 ? std::clamp(std::ilogb(largest), -960, 960) : 0;
  scale_ = std::ldexp(1.0, -unit_);
  parameters_.reserve(partition.point_count());
  for (PointOfDivision number = 0; number < partition.point_count(); ++number) {
    const DivisionPoint& point = partition.point(number);
    parameters_.push_back(point.kind == Kind::kCrossing ? crossing(point) : BoundedNumber{0, 0});
  }
}

BoundedDivisions::Vector BoundedDivisions::between(VertexIndex from, VertexIndex to) const {
  const Point &p = diagram_.point(from), &q = diagram_.point(to);
  const auto scaled = [this](double a, double b) { return DoubleDouble::sum(a * scale_, -(b * scale_)); };
  return {scaled(q.x, p.x), scaled(q.y, p.y), scaled(q.z, p.z)};
}

// A point comes from points with lesser numbers.
BoundedNumber BoundedDivisions::crossing(const DivisionPoint& point) const {
  const VertexIndex v0 = point.facet.v0;
  const Vector e = between(v0, point.facet.v1), d = between(v0, point.far_apex);
  BoundedNumber r{0, 0};
  const DivisionPoint& from = partition_.point(point.from);
  if (from.kind == Kind::kVertex) {
    r = bounded_vertex(BoundedPair(e, d, between(v0, point.other)), d);
  } else if (from.kind == Kind::kCrossing) {
    const int turn = turn_of_same(from.samples(), {v0, point.facet.v1, point.far_apex});
    // Polygons with more than three samples are left to exact numbers.
    if (turn == 0) return {};
    r = parameters_[point.from];
    if (turn < 0) r.value = -r.value;
  }
  return bounded_crossing(BoundedPair(e, d, between(v0, point.apex)), r);
}

BoundedNumber BoundedDivisions::parameter_of_sphere(VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex w) const {
  const Vector e = between(a, b), d = between(a, c);
  return bounded_vertex(BoundedPair(e, d, between(a, w)), d);
}

std::optional<double> BoundedDivisions::in_input(const BoundedNumber& number) const {
  const auto in_units = decided_double(number);
  if (!in_units) return std::nullopt;
  const double value = std::ldexp(*in_units, unit_);
  const bool is_exact = value == 0 || (std::isnormal(value) && std::ldexp(value, -unit_) == *in_units);
  return is_exact ? std::optional(value) : std::nullopt;
}

// offset_of_parameter()
std::optional<Point> BoundedDivisions::rounded_crossing(const DivisionPoint& point, const BoundedNumber& r) const {
  const Vector e = between(point.facet.v0, point.facet.v1), d = between(point.facet.v0, point.apex), n = cross(e, d);
  const double length_e = length_of(e), length_d = length_of(d), area = length_e * length_d;
  const BoundedNumber square{dot(n, n), kShare * area * area + kUnderflow};
  const BoundedNumber height{dot(d, d) - dot(e, d), kShare * length_d * (length_d + length_e) + kUnderflow};
  const BoundedNumber across = height / doubled(square), along = r / square;
  const Vector out = cross(n, e);
  const auto coordinate = [&](double origin, const DoubleDouble& e_i, const DoubleDouble& out_i,
                              const DoubleDouble& n_i) {
    const BoundedNumber middle{DoubleDouble(origin * scale_) + e_i * DoubleDouble(0.5),
                               geometry::kBoundedRoundoff * (std::fabs(origin * scale_) + length_e) + kUnderflow};
    const BoundedNumber far = across * BoundedNumber{out_i, kShare * area * length_e + kUnderflow};
    return in_input(middle + (far + along * BoundedNumber{n_i, kShare * area + kUnderflow}));
  };
  const Point& p0 = diagram_.point(point.facet.v0);
  const auto x = coordinate(p0.x, e.x, out.x, n.x), y = coordinate(p0.y, e.y, out.y, n.y),
             z = coordinate(p0.z, e.z, out.z, n.z);
  return x && y && z ? std::optional(Point{*x, *y, *z}) : std::nullopt;
}

std::optional<Point> BoundedDivisions::rounded(PointOfDivision number) const {
  const DivisionPoint& point = partition_.point(number);
  return point.kind == Kind::kCrossing ? rounded_crossing(point, parameters_[number]) : rounded_face(point);
}

std::optional<Point> BoundedDivisions::rounded_face(const DivisionPoint& point) const {
  std::array<const Point*, 4> samples{};
  std::size_t count = 0;
  const auto add = [&](VertexIndex v) { samples[count++] = &diagram_.point(v); };
  if (point.kind == Kind::kVertex) {
    std::ranges::for_each(diagram_.delaunay().vertices(point.from), add);
  } else {
    std::ranges::for_each(diagram_.corners(PolygonRef::unpacked(point.from)), add);
  }
  const auto sphere = decided_sphere(geometry::bounded_sphere(std::span(samples).first(count)));
  return sphere ? std::optional(sphere->center) : std::nullopt;
}

std::array<BoundedNumber, 3> BoundedDivisions::parts_of_corners(const BoundedNumber& number,
                                                                const std::array<VertexIndex, 3>& triangle) const {
  const auto bounded_dot = [](const Vector& u, const Vector& v) {
    return BoundedNumber{dot(u, v), kShare * length_of(u) * length_of(v) + kUnderflow};
  };
  std::array<BoundedNumber, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexIndex p = triangle[i], q = triangle[(i + 1) % 3], r = triangle[(i + 2) % 3];
    const Vector opposite = between(q, r);
    weights[i] = bounded_dot(opposite, opposite) * bounded_dot(between(p, q), between(p, r));
  }
  const BoundedNumber all = doubled(weights[0] + (weights[1] + weights[2]));
  std::array<BoundedNumber, 3> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    parts[i] = number * ((weights[(i + 1) % 3] + weights[(i + 2) % 3]) / all);
  }
  return parts;
}

BoundedNumber BoundedDivisions::determinant(const std::array<VertexIndex, 4>& v) const {
  const Vector a = between(v[0], v[1]), b = between(v[0], v[2]), c = between(v[0], v[3]);
  return {dot(a, cross(b, c)), kShare * length_of(a) * length_of(b) * length_of(c) + kUnderflow};
}

}  // namespace flowcert::morse
