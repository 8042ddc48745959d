// The construction kernel of plain rationals: every constructed point is computed at once, every sign from
// its value. Slow on long orbits; it tests the others.
//
// Guarantees: exact; no filter, so its tally counts calls and no failures.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "flowcert/rational.h"
#include "geometry/flow_predicates.h"

namespace flowcert::geometry {

class ExactKernel {
 public:
  using Point = Vector3<Rational>;

  explicit ExactKernel(KernelTally& tally) : tally_(tally) {}

  [[nodiscard]] static Point point(const RationalPoint& x) { return {x[0], x[1], x[2]}; }
  [[nodiscard]] Point circumcenter(const std::array<const flowcert::Point*, 4>& p) {
    ++tally_[FlowPrimitive::kCircumcenter].calls;
    return geometry::circumcenter(kIn(*p[0]), kIn(*p[1]), kIn(*p[2]), kIn(*p[3]));
  }
  [[nodiscard]] Point circumcenter(const std::array<const flowcert::Point*, 3>& p) {
    ++tally_[FlowPrimitive::kCircumcenter].calls;
    return geometry::circumcenter(kIn(*p[0]), kIn(*p[1]), kIn(*p[2]));
  }
  [[nodiscard]] Point crossing(const Point& x, const flowcert::Point& p0, const flowcert::Point& p1,
                               const flowcert::Point& q) {
    ++tally_[FlowPrimitive::kCrossing].calls;
    return geometry::crossing(x, kIn(p0), kIn(p1), kIn(q));
  }

  [[nodiscard]] static RationalPoint exact(const Point& x) { return {x.x, x.y, x.z}; }
  // What a coordinate's numerator and denominator take.
  [[nodiscard]] static std::optional<std::array<std::size_t, 3>> exact_bytes(const Point& x) {
    const auto bytes = [](mpz_srcptr integer) { return (mpz_sizeinbase(integer, 2) + 7) / 8; };
    const auto both = [&](const Rational& value) {
      return bytes(mpq_numref(value.backend().data())) + bytes(mpq_denref(value.backend().data()));
    };
    return std::array{both(x.x), both(x.y), both(x.z)};
  }
  // There is no history.
  [[nodiscard]] static std::size_t depth(const Point&) { return 0; }

  template <class Polynomial>
  [[nodiscard]] Sign decide(FlowPrimitive primitive, const Polynomial& polynomial) {
    ++tally_[primitive].calls;
    return sign_of(polynomial(kIn));
  }

 private:
  struct In {
    const Point& operator()(const Point& x) const { return x; }
    Point operator()(const flowcert::Point& p) const { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
  };
  static constexpr In kIn{};

  KernelTally& tally_;
};

}  // namespace flowcert::geometry
