// Square roots of exact numbers: exact where they are rational, and otherwise cut off behind so many binary digits.
#pragma once

#include <boost/multiprecision/integer.hpp>
#include <optional>

#include "flowcert/rational.h"
#include "geometry/integer_grid.h"

namespace flowcert::geometry {

[[nodiscard]] inline std::optional<BigInteger> exact_root(const BigInteger& square) {
  const BigInteger root = sqrt(square);
  return root * root == square ? std::optional(root) : std::nullopt;
}

[[nodiscard]] inline std::optional<Rational> exact_root(const Rational& square) {
  const auto top = exact_root(BigInteger(numerator(square)));
  if (!top) return std::nullopt;
  const auto bottom = exact_root(BigInteger(denominator(square)));
  return bottom ? std::optional(Rational(*top, *bottom)) : std::nullopt;
}

// floor(sqrt(value) 2^digits)
[[nodiscard]] inline BigInteger scaled_root(const Rational& value, unsigned digits) {
  return sqrt(BigInteger((BigInteger(numerator(value)) << (2 * digits)) / BigInteger(denominator(value))));
}

}  // namespace flowcert::geometry
