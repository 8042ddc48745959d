// Random numbers that are the same on every machine and with every standard library: the raw output of
// std::mt19937_64, which the standard fixes, and none of its distributions, which it leaves open.
//
// Guarantees: a function of the seed. (The tiny bias of the remainder does not matter to tests.)
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace flowcert_tests {

class PortableRandom {
 public:
  explicit PortableRandom(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t next() { return engine_(); }
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low) + 1)); }
  bool coin() { return (engine_() & 1) != 0; }
  // A number in (-1, 1), on the grid of 2^-53.
  double coordinate() {
    const double value = static_cast<double>(engine_() >> 11) * 0x1p-53;
    return coin() ? -value : value;
  }
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[below(k)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace flowcert_tests
