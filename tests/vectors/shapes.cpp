// Random numbers are the raw output of std::mt19937_64, which the standard fixes.
#include "tests/vectors/shapes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"

namespace oracle::vectors {

Rows grid(int a, int b, int c) {
  Rows rows;
  for (int x = 0; x < a; ++x) {
    for (int y = 0; y < b; ++y) {
      for (int z = 0; z < c; ++z) {
        rows.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return rows;
}

Rows sphere(int norm, std::size_t most) {
  return first_of(flowcert::fuzz::to_input(flowcert::fuzz::sphere_points(norm)).rows, most);
}

Rows circle(int norm, double height) {
  return shifted(flowcert::fuzz::to_input(flowcert::fuzz::circle_points(norm)).rows, {0, 0, height});
}

Rows scattered(std::size_t count, std::uint64_t width, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  Rows rows;
  while (rows.size() < count) {
    Row row{};
    for (double& coordinate : row) coordinate = static_cast<double>(engine() % width);
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
  }
  return rows;
}

Rows general(std::size_t count, std::uint64_t seed) {
  return scaled(scattered(count, std::uint64_t{1} << 53, seed), -53);
}

Rows joined(Rows some, const Rows& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

Rows shifted(Rows rows, const Row& offset) {
  for (Row& row : rows) {
    for (std::size_t axis = 0; axis < 3; ++axis) row[axis] += offset[axis];
  }
  return rows;
}

Rows scaled(Rows rows, int exponent) {
  for (Row& row : rows) {
    for (double& coordinate : row) coordinate = std::ldexp(coordinate, exponent);
  }
  return rows;
}

Rows nudged(Rows rows, std::size_t row, std::size_t axis, int steps) {
  rows[row][axis] = flowcert::fuzz::nudged(rows[row][axis], steps);
  return rows;
}

Rows first_of(Rows rows, std::size_t count) {
  if (rows.size() > count) rows.resize(count);
  return rows;
}

}  // namespace oracle::vectors
