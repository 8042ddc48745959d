// The oracle's chambers between balls in JSON.
#pragma once

#include "oracle/pores.h"
#include "oracle/program/answer_fields.h"

namespace oracle {

// polynomial, root, double. The coefficients are text. The double is null where it would overflow.
Json number_field(const Quadratic& x);

// points, chambers, vestibules, windows, cavities. The outside is "outside", as an end and as a room.
Json pores_field(const Pores& pores);

// A list of gate and peak. A gate below 0 is null.
Json cavities_field(const std::vector<Cavity>& cavities);

struct PoresQuestion {
  std::vector<Ball> balls;
  Rational depth;
  std::optional<Rational> probe;
};
// All that the program prints: what was asked for, the fields of pores_field(), the nerve's cavities, and with a probe
// cavities_at_probe, a list of the balls that line each.
Json pores_answer(const PoresQuestion& asked);

}  // namespace oracle
