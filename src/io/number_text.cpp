// Decimals go to std::from_chars, which is correctly rounded; around it is what it leaves open: which side of
// the range "out of range" is, and exponents of so many digits that it gives up counting them. Hexadecimal
// floats are assembled here, because from_chars would round one that has more bits than a double, and the
// spec takes them exactly.
#include "io/number_text.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace flowcert::io {
namespace {

constexpr const char* kNotANumber = "not a number";
constexpr const char* kNotFinite = "not a finite number";
constexpr const char* kOutOfRange = "out of range of a double";
constexpr const char* kNotExact = "not exactly a double";

// from_chars stops counting an exponent at 2^16; only a text longer than this could bring such a one back
// into range.
constexpr std::size_t kLong = 60000;

// As much of a text as a message shows.
constexpr std::size_t kLongestQuote = 40;

// Exponents are counted up to here: beyond what any number of digits that fits into memory could bring back.
constexpr std::int64_t kExponentLimit = std::int64_t{1} << 50;

// The optional sign and digits of an exponent, all of `text`, saturated. False if that is not what it is.
bool parse_exponent(std::string_view text, std::int64_t& exponent) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty()) return false;
  std::int64_t magnitude = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
    magnitude = std::min(magnitude * 10 + (c - '0'), kExponentLimit);
  }
  exponent = negative ? -magnitude : magnitude;
  return true;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// mantissa * 2^exponent; with `more`, plus something positive below 2^exponent.
struct HexValue {
  std::uint64_t mantissa = 0;
  std::int64_t exponent = 0;
  bool more = false;
};

bool parse_hex_value(std::string_view text, HexValue& value) {
  bool any_digit = false;
  bool after_point = false;
  std::size_t k = 0;
  for (; k < text.size(); ++k) {
    if (text[k] == '.' && !after_point) {
      after_point = true;
      continue;
    }
    const int digit = hex_digit(text[k]);
    if (digit < 0) break;
    any_digit = true;
    if (value.mantissa >> 60 == 0) {
      value.mantissa = value.mantissa << 4 | static_cast<std::uint64_t>(digit);
      if (after_point) value.exponent -= 4;
    } else {
      value.more = value.more || digit != 0;
      if (!after_point) value.exponent += 4;
    }
  }
  if (!any_digit) return false;
  if (k == text.size()) return true;
  std::int64_t written = 0;
  if ((text[k] != 'p' && text[k] != 'P') || !parse_exponent(text.substr(k + 1), written)) return false;
  value.exponent += written;
  return true;
}

NumberText parse_hex(std::string_view text, bool negative) {
  HexValue value;
  if (!parse_hex_value(text, value)) return {.value = 0, .fault = kNotANumber};
  if (value.mantissa == 0) return {.value = negative ? -0.0 : 0.0, .fault = nullptr};
  const int trailing = std::countr_zero(value.mantissa);
  value.mantissa >>= trailing;
  value.exponent += trailing;
  const int bits = 64 - std::countl_zero(value.mantissa);
  if (bits + value.exponent > 1024) return {.value = 0, .fault = kOutOfRange};
  // The lowest bit of a double is 2^-1074; above that, a double has 53 of them.
  if (value.more || bits > 53 || value.exponent < -1074) return {.value = 0, .fault = kNotExact};
  const double magnitude = std::ldexp(static_cast<double>(value.mantissa), static_cast<int>(value.exponent));
  return {.value = negative ? -magnitude : magnitude, .fault = nullptr};
}

// For a decimal that is known to be well-formed: its value is d.ddd… times 10^power, with these significant
// digits.
struct DecimalShape {
  std::string digits;
  std::int64_t power = 0;
};

DecimalShape shape_of(std::string_view text) {
  DecimalShape shape;
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  std::int64_t exponent = 0;
  if (mark < text.size()) parse_exponent(text.substr(mark + 1), exponent);
  const std::string_view body = text.substr(0, mark);
  std::int64_t place = static_cast<std::int64_t>(std::min(body.find('.'), body.size()));
  for (const char c : body) {
    if (c == '.') continue;
    --place;
    if (shape.digits.empty()) {
      if (c == '0') continue;
      shape.power = place + exponent;
    }
    shape.digits += c;
  }
  return shape;
}

// The rare decimals: from_chars said "out of range" without saying which end, or could have lost count of the
// exponent.
NumberText parse_far_decimal(std::string_view text, bool negative) {
  const NumberText too_large = {.value = 0, .fault = kOutOfRange};
  const NumberText zero = {.value = negative ? -0.0 : 0.0, .fault = nullptr};
  const DecimalShape shape = shape_of(text);
  if (shape.digits.empty() || shape.power < -400) return zero;
  if (shape.power > 400) return too_large;
  std::string scientific(1, shape.digits.front());
  scientific += '.';
  scientific.append(shape.digits, 1);
  scientific += 'e';
  scientific += std::to_string(shape.power);
  double value = 0;
  const auto result = std::from_chars(scientific.data(), scientific.data() + scientific.size(), value);
  if (result.ec == std::errc::result_out_of_range || !std::isfinite(value)) {
    return shape.power > 0 ? too_large : zero;
  }
  return {.value = negative ? -value : value, .fault = nullptr};
}

}  // namespace

NumberText parse_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  // from_chars takes a minus sign by itself, and this one would be the second.
  if (text.empty() || text[0] == '-') return {.value = 0, .fault = kNotANumber};
  if (text[0] == '0' && text.size() > 1 && (text[1] == 'x' || text[1] == 'X')) {
    return parse_hex(text.substr(2), negative);
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) {
    return {.value = 0, .fault = kNotANumber};
  }
  const bool is_decimal = text[0] == '.' || (text[0] >= '0' && text[0] <= '9');
  if (!is_decimal) return {.value = 0, .fault = kNotFinite};
  if (result.ec == std::errc::result_out_of_range || !std::isfinite(value) || text.size() > kLong) {
    return parse_far_decimal(text, negative);
  }
  return {.value = negative ? -value : value, .fault = nullptr};
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, kLongestQuote)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    result += control ? '?' : c;
  }
  if (text.size() > kLongestQuote) result += "...";
  return result + "'";
}

}  // namespace flowcert::io
