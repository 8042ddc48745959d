// The sign of an exact number. A filter that cannot tell answers std::nullopt, never a guess (spec clause
// FC-NUM-01).
#pragma once

#include <cstdint>
#include <optional>

namespace flowcert::geometry {

enum class Sign : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1 };

// What a filter rung answers: a sign that is certain, or nothing.
using MaybeSign = std::optional<Sign>;

template <class Number>
[[nodiscard]] Sign sign_of(const Number& value) {
  if (value > 0) return Sign::kPositive;
  return value < 0 ? Sign::kNegative : Sign::kZero;
}

// The sign of a double known up to an absolute error. False for NaN on either side: then nothing is certain.
[[nodiscard]] inline MaybeSign sign_beyond(double value, double error) {
  if (value > error) return Sign::kPositive;
  if (value < -error) return Sign::kNegative;
  return std::nullopt;
}

}  // namespace flowcert::geometry
