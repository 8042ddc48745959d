// A double, and the size that its rounding errors are a small share of: three times faster than BoundedDouble.
//
// Guarantees: the size grows as the sum of the absolute values of all terms. A result whose terms go through n
// roundings, those of all factors added, is wrong by n 2^-53 of its size, and less than a hundredth of that more, also
// where some factors are inverses as inverse_of() makes them. kSizedDoubleShare is enough for n = 120. Underflow is not
// counted: numbers have to be far from it.
#pragma once

#include <cmath>

#include "geometry/bounded_double.h"

namespace flowcert::geometry {

inline constexpr double kSizedDoubleShare = 0x1p-46;
// Where a number is less than this share of its size, it is not divided by.
inline constexpr double kSizedDoubleDivisor = 0x1p-36;

// Both are in one register.
class SizedDouble {
 public:
  SizedDouble() = default;
  SizedDouble(double number) : pair_{number, std::fabs(number)} {}  // NOLINT: a double is such a number
  SizedDouble(double number, double size) : pair_{number, size} {}

  [[nodiscard]] double value() const { return pair_[0]; }
  [[nodiscard]] double size() const { return pair_[1]; }
  [[nodiscard]] BoundedDouble bounded() const { return {value(), kSizedDoubleShare * size()}; }

  friend SizedDouble operator+(const SizedDouble& x, const SizedDouble& y) { return SizedDouble(x.pair_ + y.pair_); }
  friend SizedDouble operator-(const SizedDouble& x, const SizedDouble& y) {
    return SizedDouble(x.pair_ + y.pair_ * Pair{-1, 1});
  }
  friend SizedDouble operator*(const SizedDouble& x, const SizedDouble& y) { return SizedDouble(x.pair_ * y.pair_); }

 private:
  using Pair = double __attribute__((vector_size(16)));
  explicit SizedDouble(Pair pair) : pair_(pair) {}

  Pair pair_{0, 0};
};

}  // namespace flowcert::geometry
