// Exact numbers of the public interface: GMP rationals, always canonical (reduced, positive denominator).
// Source: spec clause FC-NUM-02.
#pragma once

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace flowcert {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using RationalPoint = std::array<Rational, 3>;

// "-3/4", "5": reduced, no "/1".
[[nodiscard]] std::string to_text(const Rational& value);

// The double nearest to the value, ties to even, subnormals included; nothing where that would overflow.
[[nodiscard]] std::optional<double> nearest_double(const Rational& value);
// The same, or an infinity of its sign.
[[nodiscard]] double nearest_or_infinity(const Rational& value);

}  // namespace flowcert
