// Small inputs with several pockets: chambers with mouths between them, and cells of the face-centred lattice.
//
// Guarantees: the same input for the same seed, on every machine; few different distances, so that many are equal; at
// most 18 points.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "fuzz/inputs/input.h"

namespace flowcert::fuzz {

// Triangles and squares around the z axis, of three sizes, some of them turned or moved, and often closed at the ends.
// Each chamber between them has a maximum or several.
inline std::vector<Row> chambers(std::uint64_t seed) {
  rc::Random random(seed);
  const auto below = [&](std::uint64_t count) { return static_cast<int>(random.next() % count); };
  std::vector<Row> rows;
  double z = 0;
  for (int ring = 0; ring < 4; ++ring, z += 1 + below(3)) {
    const double half = 1 + below(3), moved = below(4) == 0 ? 0.5 : 0;
    if (below(3) == 0) {
      for (const auto& [x, y] : {std::pair(half, 0.0), std::pair(-half, half), std::pair(-half, -half)})
        rows.push_back({x + moved, y, z});
    } else {
      const bool is_turned = below(4) == 0;
      for (const double a : {-half, half}) {
        for (const double b : {-half, half})
          rows.push_back({(is_turned ? a + b : a) + moved, is_turned ? a - b : b, z});
      }
    }
  }
  if (below(3) > 0) rows.push_back({0, 0, -1.0 - below(2)});
  if (below(3) > 0) rows.push_back({0, 0, z});
  return rows;
}

// A cell of the face-centred lattice with some corners left out or added. Its shallow holes lead to several others at
// once.
inline std::vector<Row> face_centred_cell(std::uint64_t seed) {
  rc::Random random(seed);
  std::vector<Row> rows = {{2, 2, 0}, {2, 2, 4}, {2, 0, 2}, {2, 4, 2}, {0, 2, 2}, {4, 2, 2}};
  const auto dropped = random.next() % 12;
  for (std::uint64_t corner = 0; corner < 8; ++corner) {
    if (corner == dropped) continue;
    const auto side = [corner](int axis) { return (corner >> axis) % 2 == 0 ? 0.0 : 4.0; };
    rows.push_back({side(0), side(1), side(2)});
  }
  if (random.next() % 3 == 0) rows.push_back({2, 2, 6});
  return rows;
}

// The one or the other.
inline Input input_with_pockets(std::uint64_t seed) {
  return {seed % 6 == 0 ? face_centred_cell(seed) : chambers(seed)};
}

}  // namespace flowcert::fuzz
