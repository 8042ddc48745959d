#include "flow/direction_lanes.h"

namespace flowcert::flow {

namespace {

using Vector = Vector3<double>;

[[gnu::always_inline]] inline Vector select(bool condition, const Vector& yes, const Vector& no) {
  return {condition ? yes.x : no.x, condition ? yes.y : no.y, condition ? yes.z : no.z};
}

}  // namespace

inline void DirectionLanes::cross_lanes() {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const bool keeps_p0 = keeps_p0_[k] != 0;
    const Vector p0 = p0_.at(k), p1 = p1_.at(k), q = q_.at(k);
    const Bisector<double> seen = bisector<double>(q - p0, q - p1);
    // The corner that is left behind is the other end of the edge.
    const Vector kept = select(keeps_p0, p0, p1), corner = select(keeps_p0, p1, p0), drop = corner - q;
    const Passage<double> way{drop, dot(drop, corner - kept), seen.squared_size};
    const MaybeDirection<double> behind = direction_behind<double>({u_.at(k), error_[k]}, seen, way, p1 - p0, q - kept);
    behind_.put(k, behind.if_known.u);
    error_behind_[k] = behind.if_known.error;
    is_known_[k] = behind.is_known != 0 ? 1 : 0;
  }
  // What was asked for is taken over.
  for (std::size_t k = 0; k < kLanes; ++k) {
    const bool is_crossing = is_crossing_[k] != 0, ends_at_q = ends_at_q_[k] != 0, is_known = is_known_[k] != 0;
    const Vector p0 = p0_.at(k), p1 = p1_.at(k), q = q_.at(k), kept = select(keeps_p0_[k] != 0, p0, p1);
    p0_.put(k, select(is_crossing, select(ends_at_q, kept, q), p0));
    p1_.put(k, select(is_crossing, select(ends_at_q, q, kept), p1));
    u_.put(k, select(is_crossing, behind_.at(k), u_.at(k)));
    const double error = is_known ? error_behind_[k] : 1;
    error_[k] = is_crossing ? error : error_[k];
    is_crossing_[k] = 0;
  }
}

inline void DirectionLanes::order_lanes() {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Vector p0 = p0_.at(k), p1 = p1_.at(k), i = i_.at(k), j = j_.at(k);
    const Direction<double> x{u_.at(k), error_[k]};
    const OrderForm<double> form =
        order_form<double>(x, order_factor(x), bisector<double>(i - p0, i - p1), bisector<double>(j - p0, j - p1));
    const double sign = form.value > 0 ? 1 : -1;
    sign_[k] = form.is_certain != 0 ? sign : 0;
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void DirectionLanes::cross_wide() { cross_lanes(); }
[[gnu::target("avx2")]] void DirectionLanes::order_wide() { order_lanes(); }
bool DirectionLanes::processor_has_wide() { return __builtin_cpu_supports("avx2") != 0; }
#else
void DirectionLanes::cross_wide() { cross_lanes(); }
void DirectionLanes::order_wide() { order_lanes(); }
bool DirectionLanes::processor_has_wide() { return false; }
#endif

void DirectionLanes::cross() {
  if (has_wide_) return cross_wide();
  cross_lanes();
}
void DirectionLanes::order() {
  if (has_wide_) return order_wide();
  order_lanes();
}

}  // namespace flowcert::flow
