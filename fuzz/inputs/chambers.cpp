#include "fuzz/inputs/chambers.h"

#include <rapidcheck.h>

#include <utility>

namespace flowcert::fuzz {

std::vector<Row> chambers(std::uint64_t seed) {
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

std::vector<Row> face_centred_cell(std::uint64_t seed) {
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

Input input_with_pockets(std::uint64_t seed) { return {seed % 6 == 0 ? face_centred_cell(seed) : chambers(seed)}; }

}  // namespace flowcert::fuzz
