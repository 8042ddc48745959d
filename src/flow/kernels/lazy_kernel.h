// The construction kernel of the paper (sections 5.2 and 6): CGAL's Exact_predicates_exact_constructions_kernel. A
// constructed point is an interval, and remembers what it was constructed from. If the intervals do not decide a
// sign, all of that is computed again in rationals.
//
// Guarantees: exact. It includes CGAL, so only the files in flow/ that need it include it. One construction is one
// node of CGAL's history. CGAL has no node for the crossing of a facet, but Lazy_rep_n takes any functor that
// computes both in intervals and in rationals.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "flow/kernels/kernel.h"
#include "geometry/contract.h"

namespace flowcert::flow {

// Rational and double coordinates as integers over one common denominator, for polynomials that are homogeneous in
// them. A sum or product of rationals needs a greatest common divisor; on the long numbers of a cascade that is nearly
// all of their cost. Integers need none.
class CommonDenominator {
 public:
  void include(const mpq_class& value) {
    const mpz_class& d = value.get_den();
    if (d != denominator_) mpz_lcm(denominator_.get_mpz_t(), denominator_.get_mpz_t(), d.get_mpz_t());
  }
  void include(double value) {
    if (value == 0) return;
    int exponent = 0;
    std::frexp(value, &exponent);
    // A double is an integer of 53 bits times 2^(exponent - 53).
    if (exponent >= kBits) return;
    const auto shift = static_cast<mp_bitcnt_t>(kBits - exponent);
    const mp_bitcnt_t present = mpz_scan1(denominator_.get_mpz_t(), 0);
    if (present < shift) denominator_ <<= shift - present;
  }

  [[nodiscard]] const mpz_class& value() const { return denominator_; }

  // The value times the denominator; it must have been included.
  [[nodiscard]] mpz_class scaled(const mpq_class& value) const {
    FLOWCERT_REQUIRES(mpz_divisible_p(denominator_.get_mpz_t(), value.get_den_mpz_t()) != 0);
    mpz_class factor;
    mpz_divexact(factor.get_mpz_t(), denominator_.get_mpz_t(), value.get_den_mpz_t());
    return mpz_class(value.get_num() * factor);
  }
  [[nodiscard]] mpz_class scaled(double value) const {
    int exponent = 0;
    // GMP takes the double itself: 53 bits are more than a long has on some systems.
    mpz_class product(std::ldexp(std::frexp(value, &exponent), kBits));
    product *= denominator_;
    if (exponent >= kBits) return mpz_class(product << static_cast<mp_bitcnt_t>(exponent - kBits));
    return mpz_class(product >> static_cast<mp_bitcnt_t>(kBits - exponent));
  }

 private:
  static constexpr int kBits = 53;
  mpz_class denominator_ = 1;
};

class LazyKernel {
  using Cgal = CGAL::Exact_predicates_exact_constructions_kernel;
  using Intervals = Cgal::Approximate_kernel;
  using Rationals = Cgal::Exact_kernel;
  using Interval = Intervals::FT;
  static_assert(std::is_same_v<Rationals::FT, mpq_class>, "what CGAL's CMake target chooses");
  using Node = CGAL::Lazy_rep<Intervals::Point_3, Rationals::Point_3, Cgal::E2A>;

 public:
  // A longer chain is computed exactly, and its history is dropped. CGAL walks a history by recursion, and the stack
  // ends somewhere beyond 20,000.
  static constexpr std::size_t kLongestChain = 1000;
  explicit LazyKernel(KernelTally& tally) : tally_(tally) {}

  [[nodiscard]] PointNumber add(const RationalPoint& x) {
    using Leaf = CGAL::Lazy_rep_0<Intervals::Point_3, Rationals::Point_3, Cgal::E2A>;
    const auto number = [](const Rational& value) { return mpq_class(value.backend().data()); };
    auto* leaf = new Leaf(Rationals::Point_3(number(x[0]), number(x[1]), number(x[2])));
    return points_.keep({Cgal::Point_3(leaf), 0, leaf});
  }  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): CGAL's handle owns the leaf
  [[nodiscard]] PointNumber add_crossing(PointNumber from, const Point& p0, const Point& p1, const Point& q) {
    using Crossed = CGAL::Lazy_rep_n<Intervals::Point_3, Rationals::Point_3, CrossingInIntervals, CrossingExactly,
                                     Cgal::E2A, false, Cgal::Point_3>;
    const Kept& x = points_[from];
    const bool is_long = x.depth >= kLongestChain;
    if (is_long) (void)CGAL::exact(x.value);
    Node* node = nullptr;
    {
      const CGAL::Protect_FPU_rounding<true> upward;
      node = new Crossed(CrossingInIntervals{p0, p1, q}, CrossingExactly{p0, p1, q}, x.value);
    }
    return points_.keep(counted(FlowPrimitive::kCrossing, {Cgal::Point_3(node), (is_long ? 0 : x.depth) + 1, node}));
  }
  [[nodiscard]] PointNumber add_circumcenter(std::span<const Point* const> simplex, Stay stay) {
    const auto leaf = [](const Point& v) { return Cgal::Point_3(v.x, v.y, v.z); };
    const Cgal::Point_3 center = center_of(simplex, leaf, Cgal().construct_circumcenter_3_object());
    return points_.keep(counted(FlowPrimitive::kCircumcenter, {center, 1, nullptr}), stay);
  }

  template <class Query>
  [[nodiscard]] Sign sign(const Query& query) {
    ++tally_[Query::kPrimitive].calls;
    if (const MaybeSign sign = sign_in_intervals(query)) return *sign;
    ++tally_[Query::kPrimitive].failures;
    return sign_in_integers(query);
  }
  [[nodiscard]] MaybeSign sign_on_rung(const auto& query, KernelRung rung) {
    if (rung == KernelRung::kFilter) return sign_in_intervals(query);
    if (rung != KernelRung::kExact) return std::nullopt;
    return sign_in_integers(query);
  }

  [[nodiscard]] RationalPoint exact(PointNumber x) const {
    const Rationals::Point_3& p = CGAL::exact(points_[x].value);
    const auto canonical = [](mpq_class value) {
      value.canonicalize();
      return Rational(value.get_mpq_t());
    };
    return {canonical(p.x()), canonical(p.y()), canonical(p.z())};
  }
  // How many bytes a coordinate's numerator and denominator take, as they are held, if they have been computed.
  [[nodiscard]] std::optional<std::array<std::size_t, 3>> exact_bytes(PointNumber number) const {
    const Kept& x = points_[number];
    if (x.node == nullptr || x.node->is_lazy()) return std::nullopt;
    const Rationals::Point_3& p = CGAL::exact(x.value);
    const auto bytes = [](const mpz_class& integer) { return (mpz_sizeinbase(integer.get_mpz_t(), 2) + 7) / 8; };
    const auto both = [&](const mpq_class& value) { return bytes(value.get_num()) + bytes(value.get_den()); };
    return std::array{both(p.x()), both(p.y()), both(p.z())};
  }
  [[nodiscard]] std::size_t deepest() const { return deepest_; }

  [[nodiscard]] PointNumber kept() const { return points_.kept(); }
  void drop_from(PointNumber x) { points_.drop_from(x); }
  void drop_all() {
    points_.drop_all();
    deepest_ = 0;
  }

 private:
  struct Kept {
    Cgal::Point_3 value;
    std::size_t depth = 0;       // constructions between an input point and this one
    const Node* node = nullptr;  // the value's, where it is ours: CGAL does not say whether a value is exact
  };
  using Points = PointStorage<Kept>;

  // A form is asked in intervals first, then in integers over a common denominator. A first pass over the form
  // gathers that denominator.
  struct InIntervals {
    const Points* points = nullptr;

    Vector3<Interval> operator()(const Point& p) const { return {Interval(p.x), Interval(p.y), Interval(p.z)}; }
    Vector3<Interval> operator()(const Intervals::Point_3& p) const { return {p.x(), p.y(), p.z()}; }
    Vector3<Interval> operator()(PointNumber x) const { return (*this)(CGAL::approx((*points)[x].value)); }
  };
  struct Include {
    CommonDenominator& common;
    const Points* points = nullptr;

    Vector3<mpz_class> operator()(const Point& p) const {
      common.include(p.x), common.include(p.y), common.include(p.z);
      return {};
    }
    Vector3<mpz_class> operator()(const Rationals::Point_3& p) const {
      common.include(p.x()), common.include(p.y()), common.include(p.z());
      return {};
    }
    Vector3<mpz_class> operator()(PointNumber x) const { return (*this)(CGAL::exact((*points)[x].value)); }
  };
  struct Scaled {
    const CommonDenominator& common;
    const Points* points = nullptr;

    Vector3<mpz_class> operator()(const Point& p) const {
      return {common.scaled(p.x), common.scaled(p.y), common.scaled(p.z)};
    }
    Vector3<mpz_class> operator()(const Rationals::Point_3& p) const {
      return {common.scaled(p.x()), common.scaled(p.y()), common.scaled(p.z())};
    }
    Vector3<mpz_class> operator()(PointNumber x) const { return (*this)(CGAL::exact((*points)[x].value)); }
  };

  [[nodiscard]] MaybeSign sign_in_intervals(const auto& query) const {
    const CGAL::Protect_FPU_rounding<true> upward;
    const InIntervals in{&points_};
    const auto sign = CGAL::sign(query.form(in)(in(query.x)));
    if (!CGAL::is_certain(sign)) return std::nullopt;
    return static_cast<Sign>(CGAL::get_certain(sign));
  }
  [[nodiscard]] Sign sign_in_integers(const auto& query) const {
    CommonDenominator common;
    const Include include{common, &points_};
    (void)query.form(include);
    (void)include(query.x);
    const Scaled in{common, &points_};
    return sign_of(query.form(in)(in(query.x)));
  }

  // The two ways to compute a node.
  struct CrossingInIntervals {
    Point p0, p1, q;

    Intervals::Point_3 operator()(const Intervals::Point_3& x) const {
      const InIntervals in;
      const Vector3<Interval> end = crossing(in(x), in(p0), in(p1), in(q));
      return {end.x, end.y, end.z};
    }
  };
  struct CrossingExactly {
    Point p0, p1, q;

    Rationals::Point_3 operator()(const Rationals::Point_3& x) const {
      CommonDenominator grid;
      const Include include{grid};
      include(p0), include(p1), include(q);
      const Scaled on_grid{grid};
      CommonDenominator common = grid;
      Include{common}(x);
      const mpz_class weight = common.value() / grid.value();
      const WeightedPoint<mpz_class> end =
          weighted_crossing(Scaled{common}(x), weight, on_grid(p0), on_grid(p1), on_grid(q));
      return over_common_denominator(end.numerator, end.denominator * grid.value());
    }
  };

  // The point is reduced as a whole, by the greatest common divisor of all four numbers. The three denominators stay
  // equal, which spares the next polynomial their least common multiple. The single coordinates may not be canonical.
  // Here only CommonDenominator, CGAL's conversion to intervals and exact() read them.
  static Rationals::Point_3 over_common_denominator(const Vector3<mpz_class>& numerator, const mpz_class& denominator) {
    mpz_class divisor = gcd(denominator, numerator.x);
    divisor = gcd(divisor, numerator.y);
    divisor = gcd(divisor, numerator.z);
    if (denominator < 0) divisor = -divisor;
    const mpz_class reduced = denominator / divisor;
    const auto quotient = [&](const mpz_class& part) {
      mpq_class value;
      mpz_divexact(value.get_num_mpz_t(), part.get_mpz_t(), divisor.get_mpz_t());
      value.get_den() = reduced;
      return value;
    };
    return {quotient(numerator.x), quotient(numerator.y), quotient(numerator.z)};
  }

  // An interval without bounds decides nothing, so it counts as a failure. Its exact value mends that.
  Kept counted(FlowPrimitive primitive, const Kept& point) {
    ++tally_[primitive].calls;
    // A Voronoi vertex counts as soon as a point is constructed from it.
    if (primitive == FlowPrimitive::kCrossing) deepest_ = std::max(deepest_, point.depth);
    const Intervals::Point_3& p = CGAL::approx(point.value);
    const auto is_bounded = [](const Interval& i) { return std::isfinite(i.inf()) && std::isfinite(i.sup()); };
    if (!is_bounded(p.x()) || !is_bounded(p.y()) || !is_bounded(p.z())) {
      ++tally_[primitive].failures;
      (void)CGAL::exact(point.value);
    }
    return point;
  }

  KernelTally& tally_;
  Points points_;
  std::size_t deepest_ = 0;
};

static_assert(ConstructsPoints<LazyKernel>);

}  // namespace flowcert::flow
