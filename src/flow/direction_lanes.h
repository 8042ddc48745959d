// The directions of several moving points side by side, in doubles (direction.h). Loops without branches over all lanes
// compute them, so that one instruction serves two lanes, or four where the processor has AVX2.
//
// Guarantees: each sign and each direction is to the bit what order_sign() and direction_across() give, with the same
// bounds, on every processor. What a lane gives does not depend on the lanes beside it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "flow/kernels/direction_across.h"
#include "geometry/lane_rows.h"

namespace flowcert::flow {

class DirectionLanes {
 public:
  static constexpr std::size_t kLanes = 16;

  // A direction seen from a facet that is about to be crossed.
  void set(std::size_t lane, const Direction<double>& direction, FacetEdge facet) {
    p0_.put(lane, *facet.p0);
    p1_.put(lane, *facet.p1);
    u_.put(lane, direction.u);
    error_[lane] = direction.error;
    is_crossing_[lane] = 0;
  }
  [[nodiscard]] Direction<double> direction(std::size_t lane) const { return {u_.at(lane), error_[lane]}; }
  [[nodiscard]] bool is_known(std::size_t lane) const { return error_[lane] < 1; }

  // The lane's point leaves its facet by the bisector of q. The next facet's edge has q, and one end of this facet's.
  // Then the crossing needs the triangle of the three alone.
  void ask_crossing(std::size_t lane, bool keeps_p0, const Point& q, bool ends_at_q) {
    q_.put(lane, q);
    keeps_p0_[lane] = keeps_p0 ? 1 : 0;
    ends_at_q_[lane] = ends_at_q ? 1 : 0;
    is_crossing_[lane] = 1;
  }
  // Makes all crossings that were asked for.
  void cross();

  // OrderOfExits of two samples, in the lane's facet.
  void ask_order(std::size_t lane, const Point& qi, const Point& qj) {
    i_.put(lane, qi);
    j_.put(lane, qj);
  }
  // Answers what was asked of any lane.
  void order();
  // 1, -1, or 0 where nothing is certain.
  [[nodiscard]] int sign(std::size_t lane) const { return static_cast<int>(sign_[lane]); }

  // For tests: without it the best that the processor has is used.
  void use_wide_instructions(bool use) { has_wide_ = use && processor_has_wide(); }
  [[nodiscard]] static bool processor_has_wide();

 private:
  using Row = geometry::LaneRow<kLanes>;
  using Rows = geometry::LaneRows<kLanes>;

  [[gnu::always_inline]] inline void cross_lanes();
  [[gnu::always_inline]] inline void order_lanes();
  void cross_wide();
  void order_wide();

  Rows p0_, p1_, u_;
  Row error_{};
  Rows q_;
  Row keeps_p0_{}, ends_at_q_{}, is_crossing_{};  // 0 or 1
  Rows behind_;                                   // what a crossing gives
  Row error_behind_{}, is_known_{};
  Rows i_, j_;
  Row sign_{};
  bool has_wide_ = processor_has_wide();
};

}  // namespace flowcert::flow
