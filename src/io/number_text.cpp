// std::from_chars reads decimals, correctly rounded. This file adds what it leaves open: whether "out of range" means
// too large or too small, and exponents with so many digits that it stops counting. Hexadecimal floats are assembled
// here. from_chars would round one with more bits than a double, but the spec takes them exactly.
#include "io/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <charconv>
#include <cmath>
#include <locale>
#include <system_error>
#include <vector>

#include "flowcert/sphere.h"
#include "io/foreign_text.h"

// CMake says where the C++ library reads no doubles. fast_float does the same, but may read 1e999 as infinity.
#ifdef FLOWCERT_FAST_FLOAT
#include <fast_float/fast_float.h>
namespace flowcert::io::doubles {
using fast_float::from_chars;
}
#else
namespace flowcert::io::doubles {
using std::from_chars;
}
#endif

namespace flowcert::io {

// ---- Doubles ----

namespace {

constexpr const char* kNotANumber = "not a number";
constexpr const char* kNotFinite = "not a finite number";
constexpr const char* kOutOfRange = "out of range of a double";
constexpr const char* kNotExact = "not exactly a double";

// from_chars stops counting an exponent at 2^16. Only a text longer than this can have a larger exponent and still be
// in range.
constexpr std::size_t kLong = 60000;

// A message shows at most this much of a text.
constexpr std::size_t kLongestQuote = 40;

// Exponents are counted up to here. No text that fits into memory has enough digits to bring a larger one into range.
constexpr std::int64_t kExponentLimit = std::int64_t{1} << 50;

// An exponent: an optional sign and digits, all of `text`. It saturates at the limit.
std::optional<std::int64_t> exponent_of(std::string_view text, std::int64_t limit) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (!is_integer(text)) return std::nullopt;
  std::int64_t magnitude = 0;
  for (const char c : text) magnitude = std::min(magnitude * 10 + (c - '0'), limit);
  return is_negative ? -magnitude : magnitude;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// mantissa * 2^exponent. If `more`, the value is larger by something below 2^exponent.
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
  if (text[k] != 'p' && text[k] != 'P') return false;
  const std::optional<std::int64_t> written = exponent_of(text.substr(k + 1), kExponentLimit);
  value.exponent += written.value_or(0);
  return written.has_value();
}

NumberText parse_hex(std::string_view text, bool negative) {
  HexValue value;
  if (!parse_hex_value(text, value)) return {.value = 0, .fault = kNotANumber};
  if (value.mantissa == 0) return {.value = negative ? -0.0 : 0.0, .fault = nullptr};
  const int trailing = std::countr_zero(value.mantissa);
  value.mantissa >>= trailing;
  value.exponent += trailing;
  const int bits = 64 - std::countl_zero(value.mantissa);
  if (bits + value.exponent > 1024) return {.value = 0, .fault = kOutOfRange, .is_finite = false};
  // A double has 53 bits, and no bit below 2^-1074.
  if (value.more || bits > 53 || value.exponent < -1074) return {.value = 0, .fault = kNotExact};
  const double magnitude = std::ldexp(static_cast<double>(value.mantissa), static_cast<int>(value.exponent));
  return {.value = negative ? -magnitude : magnitude, .fault = nullptr};
}

// A well-formed decimal as d.ddd… times 10^power, with these significant digits.
struct DecimalShape {
  std::string digits;
  std::int64_t power = 0;
};

DecimalShape shape_of(std::string_view text) {
  DecimalShape shape;
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  const std::int64_t exponent = mark < text.size() ? exponent_of(text.substr(mark + 1), kExponentLimit).value() : 0;
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

// Reads the rare decimals for which from_chars said "out of range" without saying which end, or may have lost count
// of the exponent.
NumberText parse_far_decimal(std::string_view text, bool negative) {
  const NumberText too_large = {.value = 0, .fault = kOutOfRange, .is_finite = false};
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
  const auto result = doubles::from_chars(scientific.data(), scientific.data() + scientific.size(), value);
  if (result.ec == std::errc::result_out_of_range || !std::isfinite(value)) {
    return shape.power > 0 ? too_large : zero;
  }
  return {.value = negative ? -value : value, .fault = nullptr};
}

}  // namespace

NumberText parse_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  // from_chars would take this minus sign, although it is the second sign.
  if (text.empty() || text[0] == '-') return {.value = 0, .fault = kNotANumber};
  if (text[0] == '0' && text.size() > 1 && (text[1] == 'x' || text[1] == 'X')) {
    return parse_hex(text.substr(2), negative);
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto result = doubles::from_chars(text.data(), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) {
    return {.value = 0, .fault = kNotANumber};
  }
  const bool is_decimal = text[0] == '.' || (text[0] >= '0' && text[0] <= '9');
  if (!is_decimal) return {.value = 0, .fault = kNotFinite, .is_finite = false};
  if (result.ec == std::errc::result_out_of_range || !std::isfinite(value) || text.size() > kLong) {
    return parse_far_decimal(text, negative);
  }
  return {.value = negative ? -value : value, .fault = nullptr};
}

std::string in_quotes(std::string_view text) {
  const std::string shown = on_one_line(front_of(text, kLongestQuote));
  const std::string_view front = front_of(shown, kLongestQuote);
  return fmt::format("'{}{}", front, text.size() > kLongestQuote || front.size() < shown.size() ? "...'" : "'");
}

// ---- Rationals ----
// The digits of a fraction are checked here: Boost would take "1/0" and leave "2/4" as it is.
namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

enum class Sign { kNone, kMayBe };

Integer parse_integer(std::string_view text, Sign sign) {
  const bool has_sign = sign == Sign::kMayBe && (text.starts_with('-') || text.starts_with('+'));
  const bool negative = has_sign && text.front() == '-';
  const std::string digits(text.substr(has_sign ? 1 : 0));
  if (!is_integer(digits)) throw InvalidInput("not a number: " + in_quotes(text));
  // A leading zero would mean octal to Boost.
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  const Integer value(digits.substr(first));
  return negative ? Integer(-value) : value;
}

Rational parse_fraction(std::string_view text, std::size_t slash) {
  const Integer numerator = parse_integer(text.substr(0, slash), Sign::kMayBe);
  const Integer denominator = parse_integer(text.substr(slash + 1), Sign::kNone);
  if (denominator == 0) throw InvalidInput("the denominator is zero: " + in_quotes(text));
  return Rational(numerator) / Rational(denominator);
}

// A fraction or a hexadecimal float, if it is a number.
bool is_exact_form(std::string_view text) {
  if (text.find('/') != std::string_view::npos) return true;
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text.starts_with("0x") || text.starts_with("0X");
}

}  // namespace

Rational parse_rational(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    const NumberText number = parse_number(text);
    if (number.fault != nullptr) throw InvalidInput(number.fault + (": " + in_quotes(text)));
    return Rational(number.value);
  }
  return parse_fraction(text, slash);
}

Rational exact_rational(std::string_view text) {
  try {
    if (is_exact_form(text)) return parse_rational(text);
    return Rational(parse_integer(text, Sign::kMayBe));
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

LengthBound length_bound_of(std::string_view text, const std::string& option, std::size_t ordinal) {
  using Unit = LengthBound::Unit;
  constexpr std::string_view kSpacing = "spacing", kSquaredSpacing = "spacing^2";
  const LinePlace place = {option, ordinal};
  const auto number_of = [&](std::string_view digits) {
    return claimed_number(digits, PlainInteger::kExact, place).value;
  };
  if (text == "auto") return {Unit::kValley, 0};
  if (text.ends_with(kSquaredSpacing))
    place.reject("a length is a multiple of spacing, not of its square: " + in_quotes(text));
  if (text.ends_with(kSpacing)) return {Unit::kSpacing, number_of(text.substr(0, text.size() - kSpacing.size()))};
  if (!text.starts_with('q')) return {Unit::kInput, number_of(text)};
  const Rational share = number_of(text.substr(1));
  if (share < 0 || share > 1) place.reject("no quantile from 0 to 1: " + in_quotes(text));
  return {Unit::kQuantile, share};
}

Rational length_of_option(const std::string& text, const char* option) {
  const Rational length = claimed_number(text, PlainInteger::kExact, {option, 1}).value;
  if (length < 0) throw InvalidInput(fmt::format("{}: not 0 or more: {}", option, text));
  return length;
}

// ---- What a claim can hold ----

namespace {

constexpr std::size_t kLongestDecimal = 2000;
constexpr std::size_t kLongestFraction = 1000000;
constexpr std::int64_t kLargestExponent = 700;

// The digits times 10^exponent. They have no leading zeros, so zero has none; `decimals` of them are after the point.
struct Decimal {
  bool is_negative = false;
  bool is_integer = true;  // neither a point nor an exponent
  std::string digits;
  std::int64_t decimals = 0, exponent = 0;
};

// None if the text is no decimal.
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
      const std::optional<std::int64_t> exponent =
          text[k] == 'e' || text[k] == 'E' ? exponent_of(text.substr(k + 1), kLargestExponent + 1) : std::nullopt;
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
  const std::int64_t power = decimal.exponent - decimal.decimals;
  const Integer scale = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(power < 0 ? -power : power));
  Rational value = power < 0 ? Rational(digits, scale) : Rational(Integer(digits * scale));
  if (decimal.is_negative) value = -value;
  return value;
}

}  // namespace

ClaimedNumber claimed_number(std::string_view text, PlainInteger plain, const LinePlace& place) {
  // Among rationals, an integer is a fraction without its denominator.
  const std::size_t longest = is_exact_form(text) || plain == PlainInteger::kExact ? kLongestFraction : kLongestDecimal;
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
  if (!is_exact && text.size() > kLongestDecimal) place.reject("a number of too many digits: " + in_quotes(text));
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
  if (result.ptr != end || result.ec == std::errc::invalid_argument) place.reject("not an id: " + in_quotes(text));
  if (result.ec == std::errc::result_out_of_range || id > kLargestId)
    place.reject("an id beyond 2147483646: " + in_quotes(text));
  return id;
}

int claimed_index(std::string_view text, const LinePlace& place) {
  if (text.size() != 1 || text[0] < '0' || text[0] > '3') place.reject("not an index, 0 to 3: " + in_quotes(text));
  return text[0] - '0';
}

// ---- Counts ----

namespace {

template <class Number>
Number count_in(std::string_view text, const LinePlace& place) {
  Number count = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, count);
  if (result.ptr != end || result.ec != std::errc()) place.reject("not a count: " + in_quotes(text));
  return count;
}

struct Commas : std::numpunct<char> {
 protected:
  [[nodiscard]] char do_thousands_sep() const override { return ','; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

}  // namespace

std::uint64_t written_count(std::string_view text, const LinePlace& place) {
  return count_in<std::uint64_t>(text, place);
}
std::size_t written_size(std::string_view text, const LinePlace& place) { return count_in<std::size_t>(text, place); }

std::string with_commas(unsigned long long value) {
  static const std::locale commas(std::locale::classic(), new Commas);
  return fmt::format(commas, "{:L}", value);
}

std::string counted(unsigned long long count, const std::string& what) {
  return with_commas(count) + ' ' + what + (count == 1 ? "" : "s");
}

// ---- To doubles ----

BeyondDoubles::BeyondDoubles()
    : InvalidInput(
          "a coordinate or squared distance is beyond the largest double, which an exported file cannot "
          "say; compute -o has it exactly") {}

double rounded(const Rational& value) { return finite(nearest_or_infinity(value)); }

Point rounded(const RationalPoint& position) { return finite(rounded_point(position)); }

double finite(double value) {
  if (!std::isfinite(value)) throw BeyondDoubles();
  return value;
}

Point finite(const Point& position) {
  if (!position.is_finite()) throw BeyondDoubles();
  return position;
}

// ---- Bytes ----

std::optional<StoredType> stored_type(char kind, std::uint64_t size) {
  const bool is_small = size == 1 || size == 2;
  if ((kind != 'f' && kind != 'i' && kind != 'u') || (size != 4 && size != 8 && !is_small)) return std::nullopt;
  if (kind == 'f' && is_small) return std::nullopt;
  return StoredType{kind, static_cast<std::size_t>(size)};
}

std::uint64_t stored_bits(const char* bytes, std::size_t size, bool is_big_endian) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t place = is_big_endian ? size - 1 - k : k;
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * place);
  }
  return bits;
}

std::optional<double> stored_number(const char* bytes, StoredType type, bool is_big_endian) {
  const std::uint64_t bits = stored_bits(bytes, type.size, is_big_endian);
  if (type == kFloat) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (type.kind == 'f') return std::bit_cast<double>(bits);
  const bool is_negative = type.kind == 'i' && (bits >> (8 * type.size - 1)) != 0;
  const std::size_t unused = 64 - 8 * type.size;
  const std::uint64_t magnitude = is_negative ? (0 - bits) << unused >> unused : bits;
  const auto value = static_cast<double>(magnitude);
  if (value >= 0x1p64 || static_cast<std::uint64_t>(value) != magnitude) return std::nullopt;
  return is_negative ? -value : value;
}

}  // namespace flowcert::io
