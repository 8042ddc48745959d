// See rational_text.h. The digits of a fraction are checked here: Boost would take "1/0" and leave "2/4" as
// it is.
#include "io/rational_text.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <string>
#include <vector>

#include "flowcert/point_set.h"
#include "io/number_text.h"

namespace flowcert {

namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

Integer parse_integer(std::string_view text, bool may_have_sign) {
  const bool negative = may_have_sign && !text.empty() && text.front() == '-';
  const bool has_sign = negative || (may_have_sign && !text.empty() && text.front() == '+');
  const std::string digits(text.substr(has_sign ? 1 : 0));
  if (digits.empty() ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    throw InvalidInput("not a number: " + in_quotes(text));
  }
  // A leading zero would mean octal to Boost.
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  const Integer value(digits.substr(first));
  return negative ? Integer(-value) : value;
}

}  // namespace

Rational parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    const NumberText number = parse_number(text);
    if (number.fault != nullptr) throw InvalidInput(number.fault + (": " + in_quotes(text)));
    return Rational(number.value);
  }
  const Integer numerator = parse_integer(text.substr(0, slash), true);
  const Integer denominator = parse_integer(text.substr(slash + 1), false);
  if (denominator == 0) throw InvalidInput("the denominator is zero: " + in_quotes(text));
  return Rational(numerator) / Rational(denominator);
}

RationalPoint parse_rational_point(std::string_view text) {
  std::vector<std::string> parts;
  const std::string trimmed = boost::trim_copy(std::string(text));
  boost::split(parts, trimmed, boost::is_any_of(", \t"), boost::token_compress_on);
  if (parts.size() != 3) {
    throw InvalidInput("a position has three coordinates X,Y,Z, this has " +
                       std::to_string(trimmed.empty() ? 0 : parts.size()) + ": " + in_quotes(text));
  }
  return {parse_rational(parts[0]), parse_rational(parts[1]), parse_rational(parts[2])};
}

}  // namespace flowcert
