// The critical points of the distance from balls, min over balls of |x - p| - r, with values of 0 or more.
//
// Guarantees: exact, on every input: each point once, with its index, its value, and all balls that are as near.
// Source: spec clauses FC-BALL-03 to FC-BALL-06.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "morse/ball_level.h"
#include "voronoi/ball_diagram.h"

namespace flowcert::morse {

struct BallCriticalPoint {
  std::uint8_t index = 0;                // 1 to 3
  std::vector<std::uint32_t> contacts;   // ascending, hidden balls, too
  std::array<std::uint32_t, 4> carrier;  // the point is inside of this simplex, of `corners` balls
  std::uint8_t corners = 0;
  BallLevel value;
};

// They come in the order of their carriers, whatever the number of threads. O(faces of the diagram), and what exact numbers take at ties.
[[nodiscard]] std::vector<BallCriticalPoint> ball_critical_points(const BallDiagram& diagram, unsigned threads = 1);

}  // namespace flowcert::morse
