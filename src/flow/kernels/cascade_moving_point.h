// The moving point of the cascade kernel, which keeps no points while doubles decide.
//
// Guarantees: as CascadeKernel. The operator over this kernel needs this file, too.
#pragma once

#include "flow/kernels/cascade_kernel.h"

namespace flowcert::flow {

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

static_assert(HasMovingPoint<CascadeKernel>);

}  // namespace flowcert::flow
