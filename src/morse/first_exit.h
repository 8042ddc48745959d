// Through which of several planes a ray leaves a convex set first.
//
// Guarantees: bounds prove the answer. Where they leave it open, that is said.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "geometry/bounded_number.h"
#include "morse/layer.h"

namespace flowcert::morse {

using geometry::BoundedNumber;
using geometry::Sign;

// A plane that a ray may leave a convex set through: at the parameter room / speed, if the speed is positive.
struct Wall {
  BoundedNumber room, speed;
};

// The wall that the ray meets first, and at which parameter. The bounds prove both.
struct Exit {
  std::size_t wall;
  BoundedNumber parameter;
};
enum class ExitKind : std::uint8_t { kThroughWall, kNowhere, kOpen };

// The ray starts on the inner side of all walls that it comes nearer to. So a wall that it does not come nearer to
// passes the same comparison, whatever room it has.
[[nodiscard]] inline ExitKind first_exit(std::span<const Wall> walls, Exit& exit) {
  double most = 0;
  std::size_t best = walls.size();
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const double speed = walls[k].speed.value.high();
    if (!(speed > 0)) continue;
    const double rate = speed / walls[k].room.value.high();
    if (best < walls.size() && !(rate > most)) continue;
    most = rate, best = k;
  }
  if (best == walls.size()) {
    const bool is_sure =
        std::ranges::all_of(walls, [](const Wall& wall) { return decided_sign(wall.speed) == Sign::kNegative; });
    return is_sure ? ExitKind::kNowhere : ExitKind::kOpen;
  }
  const Wall& first = walls[best];
  if (decided_sign(first.speed) != Sign::kPositive) return ExitKind::kOpen;
  if (decided_sign(first.room) != Sign::kPositive) return ExitKind::kOpen;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (k == best) continue;
    const BoundedNumber lead = walls[k].room * first.speed - first.room * walls[k].speed;
    if (decided_sign(lead) != Sign::kPositive) return ExitKind::kOpen;
  }
  exit = {best, first.room / first.speed};
  return ExitKind::kThroughWall;
}

}  // namespace flowcert::morse
