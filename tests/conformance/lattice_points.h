// Points of {0, ..., side-1}^3, as a file of points: the smaller the side, the more degenerate.
//
// Guarantees: the same in every run and with every standard library.
#pragma once

#include <random>
#include <string>

namespace flowcert::conformance {

inline std::string lattice_points(unsigned seed, int count, unsigned side) {
  std::mt19937 random(seed);
  std::string text;
  for (int k = 0; k < 3 * count; ++k) {
    text += std::to_string(random() % side) + (k % 3 < 2 ? " " : "\n");
  }
  return text;
}

}  // namespace flowcert::conformance
