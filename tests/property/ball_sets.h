// Random sets of balls that are degenerate: integer centres, few radii, symmetric sets, cages, balls that touch or hide
// each other, and equal ones; and sets that are degenerate but for 2^-60, with values that have one nearest double.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "flowcert/ball_set.h"

namespace flowcert::property {

struct DegenerateBalls {
  std::string family;
  std::vector<Ball> balls;
};

// The same set for the same number, on every system. At most ten balls.
[[nodiscard]] DegenerateBalls degenerate_balls(std::uint64_t number);

}  // namespace flowcert::property
