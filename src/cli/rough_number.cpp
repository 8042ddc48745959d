// Where a double is near and is not rounded to few digits, it is printed. Otherwise its logarithm is.
#include "cli/rough_number.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

namespace flowcert::cli {

namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

// The number is mantissa * 4^half, and the mantissa is near 1.
struct Scaled {
  double mantissa = 0;
  int half = 0;
};

Scaled scaled(const Rational& number) {
  const auto bits = [](const Integer& part) { return static_cast<int>(boost::multiprecision::msb(part)); };
  const int half = (bits(numerator(number)) - bits(denominator(number))) / 2;
  const Integer power = Integer(1) << 2 * std::abs(half);
  const Rational mantissa = half < 0 ? Rational(number * power) : Rational(number / power);
  return {nearest_double(mantissa).value(), half};
}

std::string text_of(double mantissa, int power_of_two) {
  const double number = std::ldexp(mantissa, power_of_two);
  if (std::isnormal(number)) return fmt::format("{:.6g}", number);
  const double logarithm = std::log10(mantissa) + power_of_two * std::log10(2.0);
  const double exponent = std::floor(logarithm);
  return fmt::format("{:.5f}e{:+03.0f}", std::pow(10, logarithm - exponent), exponent);
}

}  // namespace

std::string rough_text(const Rational& number) {
  if (number == 0) return "0";
  if (number < 0) return '-' + rough_text(-number);
  const auto [mantissa, half] = scaled(number);
  return text_of(mantissa, 2 * half);
}

std::string rough_root_text(const Rational& square) {
  if (square == 0) return "0";
  const auto [mantissa, half] = scaled(square);
  return text_of(std::sqrt(mantissa), half);
}

}  // namespace flowcert::cli
