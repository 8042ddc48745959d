#include "tests/proofs/direction_terms.h"

#include <array>
#include <string>

#include "flow/kernels/direction.h"
#include "flow/kernels/direction_across.h"
#include "tests/proofs/recorded_function.h"
#include "tests/proofs/recorded_number.h"

namespace flowcert::proofs {

namespace {

// Their places in this list are their numbers in the terms.
constexpr std::array<Point, 6> kPoints{};

geometry::Vector3<RecordedDouble> position(const Point& point) {
  return recorded_vector<Width::kDouble>(static_cast<std::size_t>(&point - kPoints.data()));
}

}  // namespace

}  // namespace flowcert::proofs

namespace flowcert::flow {

template <>
struct Precision<proofs::RecordedDouble> : DoublePrecision<proofs::RecordedDouble> {};

template <>
Vector3<proofs::RecordedDouble> difference<proofs::RecordedDouble>(const Point& from, const Point& to) {
  return geometry::vector_between(proofs::position(from), proofs::position(to));
}

}  // namespace flowcert::flow

namespace flowcert::proofs {

namespace {

using namespace flow;
using Number = RecordedDouble;

constexpr const Point &p0 = kPoints[0], &p1 = kPoints[1], &q = kPoints[2], &r = kPoints[3], &s = kPoints[4];
constexpr FacetEdge kFacet{&p0, &p1};
constexpr std::size_t kDirection = 6, kError = 21;

Vector3<Number> vector(std::size_t number) { return recorded_vector<Width::kDouble>(number); }
Number variable(std::size_t number) { return Number::variable(number); }

CoqModule sign_module(const std::string& name, const auto& sign) {
  CoqModule module(name);
  module.define("sign", recorded_function([&] { return CoqAnswer(sign()); }));
  return module;
}

CoqModule direction_module(const std::string& name, const MaybeDirection<Number>& x) {
  CoqModule module(name);
  const auto& [u, error] = x.if_known;
  module.define(std::vector<CoqModule::Named>{
      {"u_x", u.x.term()}, {"u_y", u.y.term()}, {"u_z", u.z.term()}, {"error", error.term()}});
  module.define("is_known", recorded_function([&] {
                  return CoqAnswer(x.is_known ? geometry::MaybeSign(Sign::kPositive) : std::nullopt);
                }));
  return module;
}

// The direction is vector 0, and its error is variable 3. What the bisector and the passage have are the variables
// after them, and the edges are vectors 6 and 7.
MaybeDirection<Number> direction_behind_variables() {
  const Bisector<Number> seen{{}, {}, vector(2), variable(9), variable(10)};
  const Passage<Number> way{vector(4), variable(15), variable(16), variable(17)};
  return direction_behind<Number>({vector(0), variable(3)}, seen, way, vector(6), vector(7));
}

}  // namespace

std::vector<CoqModule> direction_modules() {
  const Direction<Number> x{vector(kDirection), variable(kError)};
  return {sign_module("Approach", [&] { return approach_sign<Number>(x, kFacet, q); }),
          sign_module("Order", [&] { return order_sign<Number>(x, kFacet, q, r); }),
          sign_module("Normal", [&] { return normal_sign<Number>(x, q, r, s); }),
          // The vector is vector 0, the edge is vector 1, and the bound is variable 6.
          direction_module("OfVector", direction_of_vector<Number>(vector(0), variable(6), vector(1))),
          direction_module("StartAtVertex", start_at_vertex<Number>({&q, &r, &s, &kPoints[5]}, kFacet)),
          direction_module("StartAtSide", start_at_side<Number>(q, kFacet)),
          direction_module("StartAtCircle", start_at_circle<Number>({&q, &r, &s}, kFacet)),
          direction_module("Behind", direction_behind_variables()),
          // The next edge has q, or one end of the edge before it, or neither.
          direction_module("AcrossTriangle", step_across<Number>(x, kFacet, q, {&p0, &q})),
          direction_module("AcrossCorner", step_across<Number>(x, kFacet, q, {&p0, &r})),
          direction_module("AcrossPolygon", step_across<Number>(x, kFacet, q, {&r, &s}))};
}

}  // namespace flowcert::proofs
