// See claim_numbers.h. Decimals are assembled from their digits and a power of ten.
#include "io/claims/claim_numbers.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>

#include "io/number_text.h"
#include "io/rational_text.h"

namespace flowcert::io {
namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

constexpr std::size_t kLongestDecimal = 2000;
constexpr std::size_t kLongestFraction = 1000000;
constexpr int kLargestExponent = 700;
constexpr PointId kLargestId = 2147483646;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The digits, without leading zeros (none for zero), of which `decimals` are after the point, times
// 10^exponent.
struct Decimal {
  bool is_negative = false;
  bool is_integer = true;  // neither a point nor an exponent
  std::string digits;
  int decimals = 0;
  int exponent = 0;
};

// The optional sign and digits of an exponent, all of `text`, saturated beyond the largest that is taken.
std::optional<int> exponent_of(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) return std::nullopt;
  int magnitude = 0;
  for (const char c : text) magnitude = std::min(magnitude * 10 + (c - '0'), kLargestExponent + 1);
  return is_negative ? -magnitude : magnitude;
}

// None where the text is no decimal.
std::optional<Decimal> split_decimal(std::string_view text) {
  Decimal decimal;
  decimal.is_negative = text.starts_with('-');
  if (decimal.is_negative || text.starts_with('+')) text.remove_prefix(1);
  bool any_digit = false;
  bool after_point = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (is_digit(text[k])) {
      any_digit = true;
      if (after_point) ++decimal.decimals;
      if (text[k] != '0' || !decimal.digits.empty()) decimal.digits += text[k];
    } else if (text[k] == '.' && !after_point) {
      after_point = true;
      decimal.is_integer = false;
    } else {
      const std::optional<int> exponent =
          text[k] == 'e' || text[k] == 'E' ? exponent_of(text.substr(k + 1)) : std::nullopt;
      if (!exponent || !any_digit) return std::nullopt;
      decimal.is_integer = false;
      decimal.exponent = *exponent;
      return decimal;
    }
  }
  return any_digit ? std::optional(decimal) : std::nullopt;
}

Rational value_of(const Decimal& decimal) {
  if (decimal.digits.empty()) return 0;
  const Integer digits(decimal.digits);
  const int power = decimal.exponent - decimal.decimals;
  const Integer scale =
      boost::multiprecision::pow(Integer(10), static_cast<unsigned>(power < 0 ? -power : power));
  Rational value = power < 0 ? Rational(digits, scale) : Rational(Integer(digits * scale));
  if (decimal.is_negative) value = -value;
  return value;
}

bool is_exact_form(std::string_view text) {
  if (text.find('/') != std::string_view::npos) return true;
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text.starts_with("0x") || text.starts_with("0X");
}

}  // namespace

ClaimedNumber claimed_number(std::string_view text, PlainInteger plain, const LinePlace& place) {
  // An integer among rationals is a fraction whose denominator is left out.
  const std::size_t longest =
      is_exact_form(text) || plain == PlainInteger::kExact ? kLongestFraction : kLongestDecimal;
  if (text.size() > longest) place.reject("a number of too many digits: " + in_quotes(text));
  if (is_exact_form(text)) {
    try {
      return {.value = parse_rational(text), .is_exact = true};
    } catch (const InvalidInput& error) {
      place.reject(error.what());
    }
  }
  const std::optional<Decimal> decimal = split_decimal(text);
  if (!decimal) {
    const char* const fault = parse_number(text).fault;
    place.reject((fault == nullptr ? "not a number" : fault) + (": " + in_quotes(text)));
  }
  const bool is_exact = decimal->is_integer && plain == PlainInteger::kExact;
  if (!is_exact && text.size() > kLongestDecimal)
    place.reject("a number of too many digits: " + in_quotes(text));
  if (decimal->exponent > kLargestExponent || decimal->exponent < -kLargestExponent)
    place.reject("an exponent too large: " + in_quotes(text));
  return {.value = value_of(*decimal), .is_exact = is_exact};
}

ClaimedNumber claimed_distance(std::string_view text, PlainInteger plain, const LinePlace& place) {
  ClaimedNumber number = claimed_number(text, plain, place);
  if (number.value < 0) place.reject("a negative distance: " + in_quotes(text));
  return number;
}

PointId claimed_id(std::string_view text, const LinePlace& place) {
  PointId id = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, id);
  if (result.ptr != end || result.ec == std::errc::invalid_argument)
    place.reject("not an id: " + in_quotes(text));
  if (result.ec == std::errc::result_out_of_range || id > kLargestId)
    place.reject("an id beyond 2147483646: " + in_quotes(text));
  return id;
}

int claimed_index(std::string_view text, const LinePlace& place) {
  if (text.size() != 1 || text[0] < '0' || text[0] > '3')
    place.reject("not an index, 0 to 3: " + in_quotes(text));
  return text[0] - '0';
}

std::size_t claimed_count(std::string_view text, const LinePlace& place) {
  std::size_t count = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, count);
  if (result.ptr != end || result.ec != std::errc()) place.reject("not a count: " + in_quotes(text));
  return count;
}

}  // namespace flowcert::io
