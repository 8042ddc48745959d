// See rational_text.h. The digits of a fraction are checked here: Boost would take "1/0" and leave "2/4" as
// it is.
#include "io/rational_text.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <string>
#include <vector>

#include "flowcert/point_set.h"
#include "io/number_text.h"

namespace flowcert::io {

namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

// signs: those that it may begin with.
Integer parse_integer(std::string_view text, std::string_view signs) {
  const bool has_sign = !text.empty() && signs.find(text.front()) != std::string_view::npos;
  const bool negative = has_sign && text.front() == '-';
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

Rational parse_fraction(std::string_view text, std::size_t slash, std::string_view signs_above,
                        std::string_view signs_below) {
  const Integer numerator = parse_integer(text.substr(0, slash), signs_above);
  const Integer denominator = parse_integer(text.substr(slash + 1), signs_below);
  if (denominator == 0) throw InvalidInput("the denominator is zero: " + in_quotes(text));
  return Rational(numerator) / Rational(denominator);
}

}  // namespace

Rational parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    const NumberText number = parse_number(text);
    if (number.fault != nullptr) throw InvalidInput(number.fault + (": " + in_quotes(text)));
    return Rational(number.value);
  }
  return parse_fraction(text, slash, "+-", "");
}

Rational exact_rational(std::string_view text) {
  try {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return Rational(parse_integer(text, "-"));
    return parse_fraction(text, slash, "-", "-");
  } catch (const InvalidInput&) {
    throw InvalidInput("no rational: " + in_quotes(text));
  }
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

}  // namespace flowcert::io
