// The critical points of the distance from balls, min over balls of |x - p| - r, with values of 0 or more.
//
// Guarantees: exact, on every input: each point once, with its index, its value, and all balls that are as near.
// Source: spec clauses FC-BALL-03 to FC-BALL-06.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/keep_unique.h"
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

// The visible contacts of a point, and the hidden balls that are as near, ascending.
template <class IsAsNear>
[[nodiscard]] std::vector<std::uint32_t> with_hidden(const BallSet& balls, std::vector<std::uint32_t> contacts,
                                                     const IsAsNear& is_as_near) {
  for (std::size_t k = 0, count = contacts.size(); k < count; ++k) {
    for (const std::uint32_t id : balls.tangent_inside(contacts[k])) {
      if (is_as_near(id)) contacts.push_back(id);
    }
  }
  geometry::keep_unique(contacts);
  return contacts;
}

// They come in the order of their carriers, whatever the number of threads. O(faces of the diagram), and what exact
// numbers take at ties.
[[nodiscard]] std::vector<BallCriticalPoint> ball_critical_points(const BallDiagram& diagram, unsigned threads = 1);

}  // namespace flowcert::morse
