#include "flow/direction_lanes.h"

namespace flowcert::flow {

namespace {

constexpr double kRoundoff = Precision<double>::kRoundoff;

using Vector = Vector3<double>;

[[gnu::always_inline]] inline Vector select(bool condition, const Vector& yes, const Vector& no) {
  return {condition ? yes.x : no.x, condition ? yes.y : no.y, condition ? yes.z : no.z};
}
// Conditions are numbers, because && is a branch.
[[gnu::always_inline]] inline int is_in_range(double square) {
  return static_cast<int>(square >= 1e-50) & static_cast<int>(square <= 1e50);
}

}  // namespace

// direction_behind() of direction_across.h without its branches.
inline void DirectionLanes::cross_lanes() {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const bool keeps_p0 = keeps_p0_[k] != 0;
    const Vector p0 = p0_.at(k), p1 = p1_.at(k), q = q_.at(k), u = u_.at(k);
    const Vector a = q - p0, b = q - p1, e = p1 - p0;
    const double h = dot(a, b), squared_size = 2 * (dot(a, a) + dot(b, b)), approach = dot(u, a + b);
    // The corner that is left behind is the other end of the edge.
    const Vector next = select(keeps_p0, a, b), from_corner = select(keeps_p0, b, a);
    const double ee = dot(e, e), next_ee = dot(next, next);

    const double size = std::sqrt(squared_size), angle_bound = kAngleFormBound * kRoundoff * squared_size;
    const double approach_bound = (error_[k] + kExitBound * kRoundoff) * size;
    const int is_forward = static_cast<int>(approach > approach_bound) | static_cast<int>(h > angle_bound);
    const int is_backward = static_cast<int>(approach < -approach_bound) | static_cast<int>(h < -angle_bound);

    const Vector y = approach * (-1.0 * from_corner) + 2 * h * u;
    const double inverse = 1 / std::sqrt(dot(y, y));
    const double rounding = kCrossingBound * kRoundoff * squared_size * inverse;
    const double scaling = std::sqrt(next_ee / ee);
    const double height = (std::abs(dot(from_corner, e)) + kHeightBound * kRoundoff * squared_size) * scaling;
    const double angle = std::abs(h) + angle_bound;
    const double turn = 4 * angle * height * inverse * inverse;
    const double norm = 2 * (angle < height ? height : angle) * inverse;
    const double slack = (turn + norm) * error_[k] + rounding;
    const int is_known = static_cast<int>(error_[k] < 1) & is_in_range(squared_size) & is_in_range(ee) &
                         is_in_range(next_ee) & (is_forward | is_backward) & static_cast<int>(inverse > 0) &
                         static_cast<int>(slack < 0.0625);
    const double factor = is_forward != 0 ? inverse : -inverse;
    behind_.put(k, factor * (y - (dot(y, next) / next_ee) * next));
    error_behind_[k] = (turn * error_[k] + rounding) * (1 + 8 * slack);
    is_known_[k] = is_known != 0 ? 1 : 0;
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

// order_sign() of direction.h.
inline void DirectionLanes::order_lanes() {
  for (std::size_t k = 0; k < kLanes; ++k) {
    const Vector p0 = p0_.at(k), p1 = p1_.at(k), i = i_.at(k), j = j_.at(k), u = u_.at(k);
    const Vector ia = i - p0, ib = i - p1, ja = j - p0, jb = j - p1;
    const double i_size = 2 * (dot(ia, ia) + dot(ib, ib)), j_size = 2 * (dot(ja, ja) + dot(jb, jb));
    const double value = dot(ja, jb) * dot(u, ia + ib) - dot(ia, ib) * dot(u, ja + jb);
    const double part = 0.25 * error_[k] + kOrderBound * kRoundoff, factor = 2 * part * part;
    const double bound = factor * (i_size * j_size * (i_size + j_size));
    // Nothing of this is true of a NaN.
    const int is_certain = static_cast<int>(error_[k] < 1) & static_cast<int>(value * value > bound) &
                           is_in_range(i_size) & is_in_range(j_size);
    const double sign = value > 0 ? 1 : -1;
    sign_[k] = is_certain != 0 ? sign : 0;
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
