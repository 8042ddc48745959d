// The smallest change that a coordinate can have.
#pragma once

namespace flowcert::fuzz {

// The neighbouring double upwards (steps = 1) or downwards (-1), the same one for 0. Finite for every value
// below the largest double in magnitude; next to 0 is the smallest subnormal.
double nudged(double value, int steps);

}  // namespace flowcert::fuzz
