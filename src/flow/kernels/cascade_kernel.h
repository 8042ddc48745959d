// The construction kernel for cascades: a point is a recipe, and its direction from the facet that it is about to
// cross is carried along with one bound on its angle. Four precisions decide a sign, one after the other: doubles, two
// longer floating-point types, and integers.
//
// Guarantees: exact. A sign that a floating-point type decides is beyond its proven bound (spec/cascades.md); integers
// decide the others. A direction that a higher precision had to compute is handed down
// to the lower ones, so that what follows begins anew with a small error. Recipes are replayed in a loop, so that no
// length of a cascade exhausts the stack.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "flow/kernels/crossing_sphere.h"
#include "flow/kernels/direction.h"
#include "flow/kernels/exact_direction.h"
#include "flow/kernels/kernel.h"

namespace flowcert::flow {

class CascadeKernel {
 public:
  explicit CascadeKernel(KernelTally& tally) : tally_(tally) {}

  [[nodiscard]] PointNumber add(const RationalPoint& x) {
    Kept point;
    point.kind = Kind::kGiven;
    point.refined = std::make_unique<Refined>();
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
  template <class Query>
  [[nodiscard]] MaybeSign sign_on_rung(const Query& query, KernelRung rung) {
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
      const Vector3<Rational> center = center_of(simplex, InRationals{*this}, construct);
      return {center.x, center.y, center.z};
    }
    return exact_crossing(x.from, {p[0], p[1]}, *p[2]);
  }
  // The nearest doubles to a point's coordinates, and to its squared distance from the samples that it was made of.
  // Nothing if no floating-point type decides them all.
  [[nodiscard]] std::optional<RoundedSphere> rounded(PointNumber number) {
    for (const KernelRung rung : {KernelRung::kDoubled, KernelRung::kExtended}) {
      if (const auto sphere = rounded_on_rung(number, rung)) return sphere;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<RoundedSphere> rounded_on_rung(PointNumber number, KernelRung rung) {
    const Kept& x = points_[number];
    if (x.kind != Kind::kCrossing) {
      if (x.kind == Kind::kGiven || rung != KernelRung::kDoubled) return std::nullopt;
      return decided_sphere(geometry::bounded_sphere(std::span(x.samples).first(x.kind == Kind::kCircle ? 3 : 4)));
    }
    const FacetEdge facet = x.crossed();
    const PointNumber from = x.from;
    const Point& q = *x.samples[2];
    if (rung == KernelRung::kDoubled) {
      return decided_sphere(sphere_at_crossing(direction_in_doubled(from, facet), facet, q));
    }
    if (rung == KernelRung::kExtended) {
      return decided_sphere(sphere_at_crossing(direction_in_extended(from, facet), facet, q));
    }
    return std::nullopt;
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
  void drop_from(PointNumber x) { points_.drop_from(x); }
  void drop_all() {
    points_.drop_all();
    with_integers_.clear();
    deepest_ = 0;
  }

  // What each precision knows of the direction of a point from the midpoint of a facet, up to a positive factor.
  [[nodiscard]] const Direction<double>& direction_in_doubles(PointNumber number, FacetEdge facet) {
    Kept& x = points_.at(number);
    if (x.facing == facet) return x.direction;
    x.direction = first_direction<double>(x, facet);
    x.facing = facet;
    return x.direction;
  }
  [[nodiscard]] Direction<DoubleDouble> direction_in_doubled(PointNumber number, FacetEdge facet) {
    return refined_direction<InFloat<DoubleDouble>>(number, facet);
  }
  [[nodiscard]] Direction<Extended> direction_in_extended(PointNumber number, FacetEdge facet) {
    return refined_direction<InFloat<Extended>>(number, facet);
  }
  [[nodiscard]] IntegerDirection direction_in_integers(PointNumber number, FacetEdge facet) {
    return refined_direction<InIntegers>(number, facet);
  }

 private:
  template <class Query>
  [[nodiscard]] Sign sign_beyond_doubles(const Query& query) {
    ++tally_[Query::kPrimitive].failures;
    if (const MaybeSign sign = sign_in<DoubleDouble>(query)) return *sign;
    if (const MaybeSign sign = sign_in<Extended>(query)) return *sign;
    return sign_in_integers(query);
  }

  enum class Kind : std::uint8_t { kGiven, kCircle, kSphere, kCrossing };

  // A facet that was left, and by whose bisector.
  struct Crossed {
    FacetEdge facet;
    const Point* q;
  };
  // What higher precisions know of a point. Few points have it.
  template <class Number>
  struct Seen {
    FacetEdge facing;
    Direction<Number> direction;
  };
  struct Refined {
    RationalPoint given;  // kGiven
    Seen<DoubleDouble> doubled;
    Seen<Extended> extended;
    FacetEdge integer_facing;
    IntegerDirection integers;
    bool has_integers = false;

    template <class Number>
    [[nodiscard]] Seen<Number>& seen() {
      if constexpr (std::is_same_v<Number, Extended>) {
        return extended;
      } else {
        return doubled;
      }
    }
  };
  struct Kept {
    Kind kind = Kind::kGiven;
    std::uint32_t depth = 0;
    PointNumber from = kNoPoint;            // kCrossing
    std::array<const Point*, 4> samples{};  // of a crossing: p0, p1, q
    FacetEdge facing;                       // `direction` is seen from here
    Direction<double> direction;
    Direction<double> arrival;  // of a crossing: the direction before it
    std::unique_ptr<Refined> refined;

    [[nodiscard]] FacetEdge crossed() const { return {samples[0], samples[1]}; }
    [[nodiscard]] std::array<const Point*, 3> circle() const { return {samples[0], samples[1], samples[2]}; }
  };

  // ---- Doubles ----

  // For a point that is not a crossing, and for a crossing whose arrival is known in this precision.
  template <class Number>
  [[nodiscard]] static Direction<Number> first_direction(const Kept& x, FacetEdge facet) {
    switch (x.kind) {
      case Kind::kGiven:
        return rounded<Number>(exact_direction_from_position(x.refined->given, facet));
      case Kind::kCircle:
        return direction_from_circle<Number>(x.circle(), facet);
      case Kind::kSphere:
        return direction_from_vertex<Number>(x.samples, facet);
      case Kind::kCrossing:
        break;
    }
    if constexpr (std::is_same_v<Number, double>) {
      return direction_across(x.arrival, x.crossed(), *x.samples[2], facet);
    }
    return {};
  }

  // ---- Higher precisions ----

  // An integer direction in floating point. Dropping what lies 300 bits below the longest component changes it by far
  // less than the bound.
  template <class Number>
  [[nodiscard]] static Direction<Number> rounded(const IntegerDirection& u) {
    std::size_t bits = 0;
    for (const BigInteger* part : {&u.x, &u.y, &u.z}) {
      if (*part != 0) bits = std::max(bits, mpz_sizeinbase(part->backend().data(), 2));
    }
    if (bits == 0) return {};
    constexpr std::size_t kKeptBits = 300;
    const std::size_t shift = bits > kKeptBits ? bits - kKeptBits : 0;
    const auto part = [shift](const BigInteger& value) { return Extended(BigInteger(value >> shift)); };
    const Vector3<Extended> v{part(u.x), part(u.y), part(u.z)};
    return rounded<Number>(Direction<Extended>{Extended(1 / length(v)) * v, 0});
  }
  // The components are rounded once more.
  template <class Number>
  [[nodiscard]] static Direction<Number> rounded(const Direction<Extended>& x) {
    if (!x.is_known()) return {};
    const Extended error = x.error + Extended(kGivenStartBound * Precision<Number>::kRoundoff);
    return {{nearest<Number>(x.u.x), nearest<Number>(x.u.y), nearest<Number>(x.u.z)}, nearest<Number>(error)};
  }
  template <class Number>
  [[nodiscard]] static Number nearest(const Extended& value) {
    if constexpr (std::is_same_v<Number, DoubleDouble>) {
      const auto high = static_cast<double>(value);
      return Number::sum(high, static_cast<double>(Extended(value - high)));
    } else {
      return static_cast<Number>(value);
    }
  }

  template <class Number>
  struct InFloat {
    using Value = Direction<Number>;
    static Value start(const Kept& x, FacetEdge facet) { return first_direction<Number>(x, facet); }
    static Value across(const Value& u, FacetEdge from, const Point& q, FacetEdge to) {
      return direction_across(u, from, q, to);
    }
    static const Value* cached(const Kept& x, FacetEdge facet) {
      if (!x.refined) return nullptr;
      const Seen<Number>& seen = x.refined->template seen<Number>();
      return seen.facing == facet ? &seen.direction : nullptr;
    }
    static void keep(CascadeKernel&, PointNumber, Refined& refined, FacetEdge facet, const Value& value) {
      refined.template seen<Number>() = {facet, value};
      if constexpr (std::is_same_v<Number, Extended>) refined.doubled = {facet, rounded<DoubleDouble>(value)};
    }
    static Direction<double> handed_down(const Value& value) {
      if constexpr (std::is_same_v<Number, Extended>) {
        return rounded<double>(value);
      } else {
        if (!value.is_known()) return {};
        return {{value.u.x.high(), value.u.y.high(), value.u.z.high()},
                value.error.high() + kGivenStartBound * Precision<double>::kRoundoff};
      }
    }
  };
  struct InIntegers {
    using Value = IntegerDirection;
    static Value start(const Kept& x, FacetEdge facet) {
      if (x.kind == Kind::kGiven) return exact_direction_from_position(x.refined->given, facet);
      if (x.kind == Kind::kSphere) return exact_direction_from_vertex(x.samples, facet);
      return exact_direction_from_circle(x.circle(), facet);
    }
    static Value across(const Value& u, FacetEdge from, const Point& q, FacetEdge to) {
      return exact_direction_across(u, from, q, to);
    }
    static const Value* cached(const Kept& x, FacetEdge facet) {
      const bool is_there = x.refined && x.refined->has_integers && x.refined->integer_facing == facet;
      return is_there ? &x.refined->integers : nullptr;
    }
    static void keep(CascadeKernel& kernel, PointNumber number, Refined& refined, FacetEdge facet, const Value& value) {
      if (!refined.has_integers) kernel.limit_integers(number);
      refined.integers = value;
      refined.integer_facing = facet;
      refined.has_integers = true;
      refined.extended = {facet, rounded<Extended>(value)};
      refined.doubled = {facet, rounded<DoubleDouble>(value)};
    }
    static Direction<double> handed_down(const Value& value) { return rounded<double>(value); }
  };

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
    typename Rung::Value value = there != nullptr ? *there : Rung::start(points_[at], edge);
    while (!replay_.empty()) {
      const Kept& passed = points_[replay_.back()];
      replay_.pop_back();
      const FacetEdge next = replay_.empty() ? facet : points_[replay_.back()].crossed();
      value = Rung::across(value, passed.crossed(), *passed.samples[2], next);
    }
    Kept& x = points_.at(number);
    if (!x.refined) x.refined = std::make_unique<Refined>();
    Rung::keep(*this, number, *x.refined, facet, value);
    const Direction<double> lower = Rung::handed_down(value);
    if (lower.is_known()) {
      x.direction = lower;
      x.facing = facet;
    }
    return value;
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

  template <class Number>
  [[nodiscard]] decltype(auto) direction_in(PointNumber x, FacetEdge facet) {
    if constexpr (std::is_same_v<Number, double>) {
      return direction_in_doubles(x, facet);
    } else {
      return refined_direction<InFloat<Number>>(x, facet);
    }
  }

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
  template <class Number, class Query>
  [[nodiscard]] MaybeSign sign_in(const Query&) {
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
  template <class Query>
  [[nodiscard]] Sign sign_in_integers(const Query& query) {
    return sign_of_form(query);
  }

  struct InRationals {
    CascadeKernel& kernel;

    Vector3<Rational> operator()(PointNumber x) const {
      const RationalPoint p = kernel.exact(x);
      return {p[0], p[1], p[2]};
    }
    Vector3<Rational> operator()(const Point& p) const { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
  };
  template <class Query>
  [[nodiscard]] Sign sign_of_form(const Query& query) {
    const InRationals in{*this};
    return geometry::sign_of(query.form(in)(in(query.x)));
  }

  KernelTally& tally_;
  PointStorage<Kept> points_;
  std::size_t deepest_ = 0;
  std::vector<Crossed> trail_;              // of the moving point
  std::vector<PointNumber> replay_;         // scratch
  std::vector<PointNumber> with_integers_;  // the latest points that have them
  std::size_t oldest_integers_ = 0;
};

// A point that moves on in doubles alone, as long as they decide. Then it is kept like others, with all points on its
// way, and moves on from there. A kernel has one moving point at a time.
class CascadeKernel::MovingPoint {
 public:
  MovingPoint(CascadeKernel& kernel, PointNumber start, const Point& p0, const Point& p1)
      : kernel_(kernel), start_(start), facet_{&p0, &p1} {
    kernel_.trail_.clear();
    look();
  }
  MovingPoint(const MovingPoint&) = delete;
  MovingPoint& operator=(const MovingPoint&) = delete;
  ~MovingPoint() { count(); }

  void leave(const Point& q) { kernel_.trail_.push_back({facet_, &q}); }
  void enter(const Point& p0, const Point& p1) {
    const Crossed& last = kernel_.trail_.back();
    facet_ = {&p0, &p1};
    direction_ = direction_across(direction_, last.facet, *last.q, facet_);
    factor_ = order_factor(direction_);
    if (!direction_.is_known()) {
      (void)number();
      look();
    }
  }

  // Keeps the points on the way.
  [[nodiscard]] PointNumber number() {
    const std::vector<Crossed> trail(kernel_.trail_);
    kernel_.trail_.clear();
    for (const Crossed& crossed : trail) {
      start_ = kernel_.add_crossing(start_, *crossed.facet.p0, *crossed.facet.p1, *crossed.q);
    }
    return start_;
  }

  [[nodiscard]] Sign sign_of_order(const Point& qi, const Point& qj) {
    if (const MaybeSign sign = order_sign(direction_, factor_, facet_, qi, qj))
      return counted(OrderOfExits::kPrimitive, *sign);
    return beyond_doubles(OrderOfExits{number(), *facet_.p0, *facet_.p1, qi, qj});
  }
  [[nodiscard]] Sign sign_of_ray_at_infinity(const Point& q) {
    if (const MaybeSign sign = approach_sign(direction_, facet_, q)) return counted(RayAtInfinity::kPrimitive, *sign);
    return beyond_doubles(RayAtInfinity{number(), *facet_.p0, *facet_.p1, q});
  }
  [[nodiscard]] Sign sign_along_edge(const Point& a, const Point& b, const Point& c) {
    if (const MaybeSign sign = normal_sign(direction_, a, b, c)) return counted(AlongEdge::kPrimitive, *sign);
    return kernel_.sign(AlongEdge{number(), a, b, c});
  }

 private:
  void look() {
    direction_ = kernel_.direction_in_doubles(start_, facet_);
    factor_ = order_factor(direction_);
  }
  [[nodiscard]] Sign counted(FlowPrimitive primitive, Sign sign) {
    ++kernel_.tally_[primitive].calls;
    return sign;
  }
  // What a higher precision found of the direction helps from here on.
  template <class Query>
  [[nodiscard]] Sign beyond_doubles(const Query& query) {
    ++kernel_.tally_[Query::kPrimitive].calls;
    const Sign sign = kernel_.sign_beyond_doubles(query);
    look();
    return sign;
  }
  void count() {
    kernel_.tally_[FlowPrimitive::kCrossing].calls += kernel_.trail_.size();
    if (!kernel_.trail_.empty()) {
      kernel_.deepest_ = std::max(kernel_.deepest_, kernel_.points_[start_].depth + kernel_.trail_.size());
    }
  }

  CascadeKernel& kernel_;
  PointNumber start_;  // the last point that is kept
  FacetEdge facet_;
  Direction<double> direction_;
  double factor_ = 0;  // order_factor(direction_)
};

static_assert(ConstructsPoints<CascadeKernel>);
static_assert(HasMovingPoint<CascadeKernel>);

}  // namespace flowcert::flow
