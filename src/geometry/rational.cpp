// GMP's own mpq_get_d truncates, hence the rounding here.
#include "flowcert/rational.h"

#include <cmath>
#include <limits>

#include "geometry/floating_point.h"

namespace flowcert {

namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

// floor(numerator / denominator * 2^shift), with the last bit set if anything was cut off ("sticky").
Integer scaled_quotient(Integer numerator, Integer denominator, int shift) {
  if (shift >= 0) {
    numerator <<= static_cast<unsigned>(shift);
  } else {
    denominator <<= static_cast<unsigned>(-shift);
  }
  Integer quotient, remainder;
  divide_qr(numerator, denominator, quotient, remainder);
  if (remainder != 0) bit_set(quotient, 0);
  return quotient;
}

int bit_length(const Integer& value) { return value == 0 ? 0 : static_cast<int>(msb(value)) + 1; }

}  // namespace

std::string to_text(const Rational& value) { return value.str(); }

std::optional<double> nearest_double(const Rational& value) {
  const geometry::IeeeDoubles ieee;
  if (value == 0) return 0.0;
  const bool negative = value < 0;
  const Integer top = abs(numerator(value));
  const Integer bottom = denominator(value);

  // The quotient goes at least two bits below the last one that a double of this size keeps; subnormals keep fewer.
  // It fits 64 bits and its last bit is sticky, so rounding it to the kept bits rounds the exact value.
  const int magnitude = bit_length(top) - bit_length(bottom);  // value is in (2^(magnitude-1), 2^(magnitude+1))
  const int last_kept = std::max(magnitude - 1 - 53, -1074);
  const int shift = 3 - last_kept;
  if (magnitude > 1025) return std::nullopt;
  const Integer quotient = scaled_quotient(top, bottom, shift);
  // The exponent of the last kept bit, now that the quotient's real length is known.
  const int kept = std::max(bit_length(quotient) - shift - 53, -1074);
  const unsigned cut = static_cast<unsigned>(kept + shift);
  Integer mantissa = quotient >> cut;
  const Integer rest = quotient - (mantissa << cut);
  const Integer half = Integer(1) << (cut - 1);
  if (rest > half || (rest == half && bit_test(mantissa, 0))) ++mantissa;
  const double result = std::ldexp(mantissa.convert_to<double>(), kept);
  if (!std::isfinite(result)) return std::nullopt;
  return negative && result != 0 ? -result : result;  // no negative zero: FC-IN-02
}

}  // namespace flowcert
