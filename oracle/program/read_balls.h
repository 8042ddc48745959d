// Reads balls for the oracle: one a line, x y z r. Numbers are taken exactly, not as doubles: decimals and fractions
// p/q.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "oracle/balls.h"

namespace oracle {

// A decimal like -1.25 or 5e-1, or a fraction like -5/4, without rounding. `where` opens the message of an
// UnusableInput.
Rational exact_number(const std::string& word, const std::string& where);

// Blank lines, and what follows a #, are left out. `name` is for messages only. Throws UnusableInput for other text,
// and for a radius of 0 or below.
std::vector<Ball> read_balls(std::istream& in, const std::string& name);

std::vector<Ball> read_ball_file(const std::string& path);

}  // namespace oracle
