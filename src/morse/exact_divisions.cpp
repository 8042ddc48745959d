#include "morse/exact_divisions.h"

#include "flow/kernels/steering.h"

namespace flowcert::morse {

namespace {

using Kind = DivisionPoint::Kind;

}  // namespace

Vector3<Rational> ExactDivisions::at(VertexIndex v) const { return exact_vector(diagram_.point(v)); }

// The point that it comes from is a centre, or its parameter is known.
Rational ExactDivisions::crossing(const DivisionPoint& point) {
  const auto sample = [this](VertexIndex v) { return at(v); };
  const Vector3<Rational> p0 = at(point.facet.v0), e = at(point.facet.v1) - p0, d = at(point.far_apex) - p0;
  Rational r = 0;
  const DivisionPoint& from = partition_.point(point.from);
  if (from.kind == Kind::kVertex) {
    const auto far = vertex_parameter(ApexPair<Rational>(e, d, at(point.other) - p0), d);
    r = far.num / far.den;
  } else if (from.kind == Kind::kCrossing) {
    r = parameters_.at(point.from) *
        parameter_ratio<Rational>(sample, from.samples(), {point.facet.v0, point.facet.v1, point.far_apex});
  }
  const auto near = crossed_parameter(ApexPair<Rational>(e, d, at(point.apex) - p0), r);
  return near.num / near.den;
}

const Rational& ExactDivisions::parameter(PointOfDivision number) {
  pending_.clear();
  for (PointOfDivision next = number; !parameters_.contains(next); next = partition_.point(next).from) {
    if (partition_.point(next).kind != Kind::kCrossing) break;
    pending_.push_back(next);
  }
  while (!pending_.empty()) {
    const PointOfDivision next = pending_.back();
    pending_.pop_back();
    parameters_.emplace(next, crossing(partition_.point(next)));
  }
  return parameters_[number];  // 0 for a centre
}

RationalPoint ExactDivisions::position(PointOfDivision number) {
  const DivisionPoint& point = partition_.point(number);
  if (point.kind != Kind::kCrossing) return position_of_face(point);
  const Vector3<Rational> p0 = at(point.facet.v0);
  return exact_position(p0 + offset_of_parameter(at(point.facet.v1) - p0, at(point.apex) - p0, parameter(number)));
}

RationalPoint ExactDivisions::position_of_face(const DivisionPoint& point) const {
  if (point.kind == Kind::kVertex) {
    const auto& v = diagram_.delaunay().vertices(point.from);
    return exact_position(circumcenter(at(v[0]), at(v[1]), at(v[2]), at(v[3])));
  }
  const auto [a, b, c] = diagram_.corners(PolygonRef::unpacked(point.from));
  if (point.kind == Kind::kCenter) return exact_position(circumcenter(at(a), at(b), at(c)));
  const Vector3<Rational> outward = cross(at(b) - at(a), at(c) - at(a));
  return exact_position(Rational(point.apex == 1 ? 1 : -1) * outward);
}

}  // namespace flowcert::morse
