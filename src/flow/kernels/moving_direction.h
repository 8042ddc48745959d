// The direction of a moving point in doubles, while it crosses one facet after another (direction.h). What one sign
// has computed of a sample serves the next signs and the crossing.
//
// Guarantees: each sign and each direction is to the bit what order_sign(), approach_sign() and direction_across()
// give, with the same bounds.
#pragma once

#include <cmath>

#include "flow/kernels/direction_across.h"

namespace flowcert::flow {

// A sample as it is seen from the facet that the point is about to cross.
struct SeenSample {
  const Point* q;
  double h;             // <a,b>, for a = q-p0 and b = q-p1
  double squared_size;  // 2 (|a|^2 + |b|^2)
  double along;         // <u,a+b>
};

class MovingDirection {
 public:
  void begin(const Direction<double>& direction, FacetEdge facet) {
    facet_ = facet;
    e_ = difference<double>(*facet.p0, *facet.p1);
    ee_ = dot(e_, e_);
    set(direction);
  }

  [[nodiscard]] bool is_known() const { return direction_.is_known(); }
  [[nodiscard]] const Direction<double>& direction() const { return direction_; }
  [[nodiscard]] FacetEdge facet() const { return facet_; }

  [[nodiscard, gnu::always_inline]] SeenSample see(const Point& q) const {
    const Bisector<double> seen = bisector<double>(facet_, q);
    return {&q, seen.h, seen.squared_size, dot(direction_.u, seen.g)};
  }

  // OrderOfExits.
  [[nodiscard, gnu::always_inline]] geometry::MaybeSign order(const SeenSample& i, const SeenSample& j) const {
    const double value = j.h * i.along - i.h * j.along;
    const double bound = factor_ * (i.squared_size * j.squared_size * (i.squared_size + j.squared_size));
    const bool is_certain = value * value > bound && Precision<double>::is_in_range(i.squared_size) &&
                            Precision<double>::is_in_range(j.squared_size);
    if (!is_certain) return std::nullopt;
    return value > 0 ? Sign::kPositive : Sign::kNegative;
  }
  // RayAtInfinity.
  [[nodiscard]] geometry::MaybeSign approach(const Point& q) const { return approach_sign(direction_, facet_, q); }

  // Leaves the facet by the bisector of q, which has just been seen, and enters the next one. Most often q is an end of
  // the next one's edge, and so is p0 or p1. Then the triangle of the three tells all that the crossing needs.
  void cross(const SeenSample& seen, FacetEdge to) {
    const bool keeps_p0 = to.p0 == facet_.p0 || to.p1 == facet_.p0;
    const bool ends_at_q = to.p1 == seen.q;
    const Point* const kept = keeps_p0 ? facet_.p0 : facet_.p1;
    if ((ends_at_q ? to.p0 : to.p1) != kept || (ends_at_q ? to.p1 : to.p0) != seen.q) {
      return begin(direction_across(direction_, facet_, *seen.q, to), to);
    }
    // The corner that is left behind is the other end of the edge.
    const Vector3<double> next = difference<double>(*kept, *seen.q);
    const Vector3<double> from_corner = difference<double>(keeps_p0 ? *facet_.p1 : *facet_.p0, *seen.q);
    const double next_ee = dot(next, next);
    Passage<double> way;
    way.drop = -1.0 * from_corner;
    way.height = dot(from_corner, keeps_p0 ? -1.0 * e_ : e_);
    way.squared_size = seen.squared_size;
    set(direction_behind(direction_, seen.along, seen.h, seen.squared_size, way, ee_, next, next_ee));
    facet_ = to;
    e_ = ends_at_q ? next : -1.0 * next;
    ee_ = next_ee;
  }

 private:
  void set(const Direction<double>& direction) {
    direction_ = direction;
    factor_ = order_factor(direction_);
  }

  FacetEdge facet_;
  Vector3<double> e_{};  // p1-p0
  double ee_ = 0;        // its squared length
  Direction<double> direction_;
  double factor_ = HUGE_VAL;  // order_factor(direction_)
};

}  // namespace flowcert::flow
