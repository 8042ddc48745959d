// The construction kernel for cascades: a point is a recipe, and its direction from the facet that it is about to
// cross is carried along with one bound on its angle. Four precisions decide a sign, one after the other: doubles, two
// longer floating-point types, and integers.
//
// Guarantees: exact. A sign that a floating-point type decides is beyond its proven bound (src/flow/cascades.md);
// integers decide the others. A direction that a higher precision had to compute is handed down to the lower ones, so
// that what follows begins anew with a small error. Recipes are replayed in a loop, so that no length of a cascade
// exhausts the stack. What flows over this kernel also includes cascade_moving_point.h.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "flow/kernels/crossing_sphere.h"
#include "flow/kernels/direction_rung.h"
#include "flow/kernels/kernel.h"

namespace flowcert::flow {

// Which precisions between doubles and integers are asked for signs. A benchmark leaves some out; answers stay.
// The longer one is asked from so many crossings on: the integers of a shorter recipe are short, and cost less.
struct MiddleRungs {
  bool doubled = true;
  bool extended = true;
  std::uint32_t extended_from = 8;
};

class CascadeKernel {
 public:
  explicit CascadeKernel(KernelTally& tally, MiddleRungs rungs = {}) : tally_(tally), rungs_(rungs) {}

  [[nodiscard]] PointNumber add(const RationalPoint& x) {
    Kept point;
    point.kind = Kind::kGiven;
    point.refined = std::make_unique<RefinedDirections>();
    point.refined->given = x;
    return points_.keep(std::move(point));
  }

  [[nodiscard]] PointNumber add_crossing(PointNumber from, const Point& p0, const Point& p1, const Point& q) {
    ++tally_[FlowPrimitive::kCrossing].calls;
    // Within a Voronoi cell there is no facet. Only a given start crosses one.
    if (&p0 == &p1) return add(exact_crossing(from, {&p0, &p1}, q));
    const Direction<double> arrival = direction_in_doubles(from, {&p0, &p1});
    const std::uint32_t depth = points_[from].depth + 1;
    deepest_ = std::max<std::size_t>(deepest_, depth);
    if (!arrival.is_known()) ++tally_[FlowPrimitive::kCrossing].failures;
    Kept& point = points_.add();
    point.kind = Kind::kCrossing;
    point.depth = depth;
    point.from = from;
    point.samples = {&p0, &p1, &q, nullptr};
    point.arrival = arrival;
    return points_.kept() - 1;
  }

  [[nodiscard]] PointNumber add_circumcenter(std::span<const Point* const> simplex, Stay stay) {
    ++tally_[FlowPrimitive::kCircumcenter].calls;
    Kept point;
    point.kind = simplex.size() == 3 ? Kind::kCircle : Kind::kSphere;
    point.depth = 1;
    std::copy(simplex.begin(), simplex.end(), point.samples.begin());
    return points_.keep(std::move(point), stay);
  }

  class MovingPoint;

  template <class Query>
  [[nodiscard]] Sign sign(const Query& query) {
    ++tally_[Query::kPrimitive].calls;
    if (const MaybeSign sign = sign_in<double>(query)) return *sign;
    return sign_beyond_doubles(query);
  }
  [[nodiscard]] MaybeSign sign_on_rung(const auto& query, KernelRung rung) {
    if (rung == KernelRung::kFilter) return sign_in<double>(query);
    if (rung == KernelRung::kDoubled) return sign_in<DoubleDouble>(query);
    if (rung == KernelRung::kExtended) return sign_in<Extended>(query);
    return sign_in_integers(query);
  }

  [[nodiscard]] RationalPoint exact(PointNumber number) {
    const Kept& x = points_[number];
    const auto& p = x.samples;
    if (x.kind == Kind::kGiven) return x.refined->given;
    if (x.kind != Kind::kCrossing) {
      const auto construct = [](const auto&... v) { return circumcenter(v...); };
      const std::span<const Point* const> simplex = std::span(p).first(x.kind == Kind::kCircle ? 3 : 4);
      return exact_position(center_of(simplex, InRationals{*this}, construct));
    }
    return exact_crossing(x.from, {p[0], p[1]}, *p[2]);
  }
  // The nearest doubles to a point's coordinates, and to its squared distance from the samples that it was made of.
  // Nothing if no floating-point type decides them all.
  [[nodiscard]] std::optional<RoundedSphere> rounded(PointNumber number) {
    const auto sphere = rounded_on_rung(number, KernelRung::kDoubled);
    return sphere ? sphere : rounded_on_rung(number, KernelRung::kExtended);
  }
  [[nodiscard]] std::optional<RoundedSphere> rounded_on_rung(PointNumber number, KernelRung rung) {
    const Kept& x = points_[number];
    if (x.kind != Kind::kCrossing) {
      if (x.kind == Kind::kGiven || rung != KernelRung::kDoubled) return std::nullopt;
      return decided_sphere(geometry::bounded_sphere(std::span(x.samples).first(x.kind == Kind::kCircle ? 3 : 4)));
    }
    const FacetEdge facet = x.crossed();
    const PointNumber from = x.from;
    const auto decided = [facet, &q = *x.samples[2]](const auto& direction) {
      return decided_sphere(sphere_at_crossing(direction, facet, q));
    };
    if (rung == KernelRung::kDoubled) return decided(refined_direction<InFloat<DoubleDouble>>(from, facet));
    return rung == KernelRung::kExtended ? decided(refined_direction<InFloat<Extended>>(from, facet)) : std::nullopt;
  }
  // How many bytes the components of the integer direction take, where it was needed.
  [[nodiscard]] std::optional<std::array<std::size_t, 3>> exact_bytes(PointNumber number) const {
    const Kept& x = points_[number];
    if (!x.refined || !x.refined->has_integers) return std::nullopt;
    const auto bytes = [](const BigInteger& value) { return (mpz_sizeinbase(value.backend().data(), 2) + 7) / 8; };
    const IntegerDirection& u = x.refined->integers;
    return std::array{bytes(u.x), bytes(u.y), bytes(u.z)};
  }
  // The number of crossings in a recipe, and its start.
  [[nodiscard]] std::size_t deepest() const { return deepest_; }

  [[nodiscard]] PointNumber kept() const { return points_.kept(); }
  // Numbers of points begin anew, so that nothing may be remembered of the old ones.
  void drop_from(PointNumber x) {
    points_.drop_from(x);
    if (x == 0) forget_integers();
  }
  void drop_all() {
    points_.drop_all();
    forget_integers();
    deepest_ = 0;
  }

  // How many signs each rung decided. Doubles decided all that are not here.
  [[nodiscard]] std::uint64_t decided_beyond_doubles(KernelRung rung) const {
    return decided_[static_cast<std::size_t>(rung)];
  }

  // What each precision knows of the direction of a point from the midpoint of a facet, up to a positive factor.
  [[nodiscard]] const Direction<double>& direction_in_doubles(PointNumber number, FacetEdge facet) {
    Kept& x = points_.at(number);
    if (x.facing == facet) return x.direction;
    if (x.kind == Kind::kGiven) {
      x.direction = rounded_direction<double>(start_of_recipe<InFloat<Extended>>(number, facet));
    } else {
      x.direction = first_direction<double>(x, facet);
    }
    x.facing = facet;
    return x.direction;
  }
  template <class Number>
  [[nodiscard]] decltype(auto) direction_in(PointNumber number, FacetEdge facet) {
    if constexpr (std::is_same_v<Number, double>) {
      return direction_in_doubles(number, facet);
    } else {
      return refined_direction<InFloat<Number>>(number, facet);
    }
  }
  [[nodiscard]] IntegerDirection direction_in_integers(PointNumber number, FacetEdge facet) {
    return refined_direction<InIntegers>(number, facet);
  }

 private:
  using Kept = CascadePoint;
  using Kind = CascadePoint::Kind;

  template <class Query>
  [[nodiscard]] Sign sign_beyond_doubles(const Query& query) {
    ++tally_[Query::kPrimitive].failures;
    const auto decided_by = [this](KernelRung rung, Sign sign) {
      ++decided_[static_cast<std::size_t>(rung)];
      return sign;
    };
    if (rungs_.doubled) {
      if (const MaybeSign sign = sign_in<DoubleDouble>(query)) return decided_by(KernelRung::kDoubled, *sign);
    }
    if (rungs_.extended && points_[query.x].depth >= rungs_.extended_from) {
      if (const MaybeSign sign = sign_in<Extended>(query)) return decided_by(KernelRung::kExtended, *sign);
    }
    return decided_by(KernelRung::kExact, sign_in_integers(query));
  }

  // A facet that was left, and by whose bisector.
  struct Crossed {
    FacetEdge facet;
    const Point* q;
  };
  // The direction of a given point begins as integers in every precision.
  template <class Rung>
  [[nodiscard]] typename Rung::Value start_of_recipe(PointNumber number, FacetEdge facet) {
    Kept& x = points_.at(number);
    if (x.kind != Kind::kGiven) return Rung::start(x, facet);
    if (Rung::cached(x, facet) == nullptr) keep<InIntegers>(number, facet, InIntegers::start(x, facet));
    return *Rung::cached(x, facet);
  }
  template <class Rung>
  void keep(PointNumber number, FacetEdge facet, const typename Rung::Value& value) {
    Kept& x = points_.at(number);
    if (!x.refined) x.refined = std::make_unique<RefinedDirections>();
    if (Rung::kIsLong && !x.refined->has_integers) limit_integers(number);
    const Direction<double> lower = Rung::keep(*x.refined, facet, value);
    if (lower.is_known()) {
      x.direction = lower;
      x.facing = facet;
    }
  }
  // Goes back along the recipe to a point whose direction is there, and then forth again.
  template <class Rung>
  [[nodiscard]] typename Rung::Value refined_direction(PointNumber number, FacetEdge facet) {
    replay_.clear();
    FacetEdge edge = facet;
    PointNumber at = number;
    const typename Rung::Value* there = Rung::cached(points_[at], edge);
    while (there == nullptr && points_[at].kind == Kind::kCrossing) {
      replay_.push_back(at);
      edge = points_[at].crossed();
      at = points_[at].from;
      there = Rung::cached(points_[at], edge);
    }
    if (there != nullptr && at == number) return *there;
    typename Rung::Value value = there != nullptr ? *there : start_of_recipe<Rung>(at, edge);
    while (!replay_.empty()) {
      const Kept& passed = points_[replay_.back()];
      replay_.pop_back();
      const FacetEdge next = replay_.empty() ? facet : points_[replay_.back()].crossed();
      value = Rung::across(value, passed.crossed(), *passed.samples[2], next);
    }
    keep<Rung>(number, facet, value);
    return value;
  }

  void forget_integers() {
    with_integers_.clear();
    oldest_integers_ = 0;
  }
  // Long integers are kept of the latest points alone: those of 10,000 crossings in a row take a gigabyte.
  void limit_integers(PointNumber number) {
    constexpr std::size_t kMost = 16;
    if (with_integers_.size() < kMost) {
      with_integers_.push_back(number);
      return;
    }
    PointNumber& oldest = with_integers_[oldest_integers_++ % kMost];
    if (points_.has(oldest) && points_[oldest].refined) {
      points_.at(oldest).refined->integers = {};
      points_.at(oldest).refined->has_integers = false;
    }
    oldest = number;
  }

  [[nodiscard]] RationalPoint exact_crossing(PointNumber from, FacetEdge facet, const Point& q) {
    const IntegerDirection u = direction_in_integers(from, facet);
    const ExactBisector seen(facet, q);
    const Rational scale =
        Rational(std::ldexp(1.0, seen.grid.exponent())) * Rational(seen.h, BigInteger(dot(u, seen.g)));
    const auto at = [&](double one, double other, const BigInteger& part) {
      return Rational((Rational(one) + Rational(other)) / 2 + scale * Rational(part));
    };
    return {at(facet.p0->x, facet.p1->x, u.x), at(facet.p0->y, facet.p1->y, u.y), at(facet.p0->z, facet.p1->z, u.z)};
  }

  // ---- Signs ----

  // A direction decides these; other queries are about starts that were given, and go to exact positions.
  template <class Number>
  [[nodiscard]] MaybeSign sign_in(const RayAtInfinity& k) {
    return approach_sign<Number>(direction_in<Number>(k.x, {&k.p0, &k.p1}), {&k.p0, &k.p1}, k.q);
  }
  template <class Number>
  [[nodiscard]] MaybeSign sign_in(const OrderOfExits& k) {
    return order_sign<Number>(direction_in<Number>(k.x, {&k.p0, &k.p1}), {&k.p0, &k.p1}, k.qi, k.qj);
  }
  template <class Number>
  [[nodiscard]] MaybeSign sign_in(const AlongEdge& k) {
    const Kept& x = points_[k.x];
    if (x.kind != Kind::kCrossing) return std::nullopt;
    if constexpr (std::is_same_v<Number, double>) {
      return normal_sign(x.arrival, k.a, k.b, k.c);
    } else {
      const PointNumber from = x.from;
      return normal_sign<Number>(direction_in<Number>(from, x.crossed()), k.a, k.b, k.c);
    }
  }
  template <class Number>
  [[nodiscard]] MaybeSign sign_in(const auto&) {
    return std::nullopt;
  }

  [[nodiscard]] Sign sign_in_integers(const RayAtInfinity& k) {
    return exact_approach_sign(direction_in_integers(k.x, {&k.p0, &k.p1}), {&k.p0, &k.p1}, k.q);
  }
  [[nodiscard]] Sign sign_in_integers(const OrderOfExits& k) {
    return exact_order_sign(direction_in_integers(k.x, {&k.p0, &k.p1}), {&k.p0, &k.p1}, k.qi, k.qj);
  }
  [[nodiscard]] Sign sign_in_integers(const AlongEdge& k) {
    const Kept& x = points_[k.x];
    if (x.kind != Kind::kCrossing) return sign_of_form(k);
    const PointNumber from = x.from;
    return exact_normal_sign(direction_in_integers(from, x.crossed()), k.a, k.b, k.c);
  }
  [[nodiscard]] Sign sign_in_integers(const auto& query) { return sign_of_form(query); }

  struct InRationals {
    CascadeKernel& kernel;

    Vector3<Rational> operator()(PointNumber x) const { return exact_vector(kernel.exact(x)); }
    Vector3<Rational> operator()(const Point& p) const { return exact_vector(p); }
  };
  [[nodiscard]] Sign sign_of_form(const auto& query) {
    const InRationals in{*this};
    return geometry::sign_of(query.form(in)(in(query.x)));
  }

  KernelTally& tally_;
  MiddleRungs rungs_;
  std::array<std::uint64_t, 4> decided_{};  // by KernelRung
  PointStorage<Kept> points_;
  std::size_t deepest_ = 0;
  std::vector<Crossed> trail_;              // of the moving point
  std::vector<PointNumber> replay_;         // scratch
  std::vector<PointNumber> with_integers_;  // the latest points that have them
  std::size_t oldest_integers_ = 0;
};

static_assert(ConstructsPoints<CascadeKernel>);

}  // namespace flowcert::flow
