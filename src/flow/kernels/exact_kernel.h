// The construction kernel of plain rationals. It computes every constructed point at once, and every sign from the
// points' values. It is slow on long orbits; it tests the others.
//
// Guarantees: exact. It has no filter, so its tally counts calls and no failures.
#pragma once

#include "flow/kernels/kernel.h"
#include "geometry/rational_point.h"

namespace flowcert::flow {

class ExactKernel {
 public:
  explicit ExactKernel(KernelTally& tally) : tally_(tally) {}

  [[nodiscard]] PointNumber add(const RationalPoint& x) { return points_.keep(exact_vector(x)); }
  [[nodiscard]] PointNumber add_crossing(PointNumber x, const Point& p0, const Point& p1, const Point& q) {
    ++tally_[FlowPrimitive::kCrossing].calls;
    return points_.keep(crossing(points_[x], in(p0), in(p1), in(q)));
  }
  [[nodiscard]] PointNumber add_circumcenter(std::span<const Point* const> simplex, Stay stay) {
    ++tally_[FlowPrimitive::kCircumcenter].calls;
    const auto construct = [](const auto&... v) { return circumcenter(v...); };
    return points_.keep(center_of(simplex, in, construct), stay);
  }

  template <class Query>
  [[nodiscard]] Sign sign(const Query& query) {
    ++tally_[Query::kPrimitive].calls;
    return *sign_on_rung(query, KernelRung::kExact);
  }
  [[nodiscard]] MaybeSign sign_on_rung(const auto& query, KernelRung rung) {
    if (rung != KernelRung::kExact) return std::nullopt;
    return sign_of(query.form(In{points_})(points_[query.x]));
  }

  [[nodiscard]] RationalPoint exact(PointNumber x) const { return exact_position(points_[x]); }
  // How many bytes a coordinate's numerator and denominator take.
  [[nodiscard]] std::optional<std::array<std::size_t, 3>> exact_bytes(PointNumber x) const {
    const auto bytes = [](mpz_srcptr integer) { return (mpz_sizeinbase(integer, 2) + 7) / 8; };
    const auto both = [&](const Rational& value) {
      return bytes(mpq_numref(value.backend().data())) + bytes(mpq_denref(value.backend().data()));
    };
    const Vector3<Rational>& p = points_[x];
    return std::array{both(p.x), both(p.y), both(p.z)};
  }
  // There is no history.
  [[nodiscard]] std::size_t deepest() const { return 0; }

  [[nodiscard]] PointNumber kept() const { return points_.kept(); }
  void drop_from(PointNumber x) { points_.drop_from(x); }
  void drop_all() { points_.drop_all(); }

 private:
  struct In {
    const PointStorage<Vector3<Rational>>& points;

    const Vector3<Rational>& operator()(PointNumber x) const { return points[x]; }
    Vector3<Rational> operator()(const Point& p) const { return in(p); }
  };
  static Vector3<Rational> in(const Point& p) { return exact_vector(p); }

  KernelTally& tally_;
  PointStorage<Vector3<Rational>> points_;
};

static_assert(ConstructsPoints<ExactKernel>);

}  // namespace flowcert::flow
