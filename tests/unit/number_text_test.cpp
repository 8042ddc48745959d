// Numbers in text, against exact rational arithmetic: decimals at random, at midpoints of doubles and at both
// ends of the range; hexadecimal floats; and what is not a number.
#include "io/number_text.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <string>

#include "tests/cites.h"

namespace flowcert::number_text_test {

using namespace io;
namespace {

// The numbers have no expression templates, which clang's analyzer takes for dangling references.
namespace mp = boost::multiprecision;
using Integer = mp::number<mp::cpp_int_backend<>, mp::et_off>;
using Rational = mp::number<mp::rational_adaptor<mp::cpp_int_backend<>>, mp::et_off>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

double value_of(const std::string& text) {
  const NumberText number = parse_number(text);
  EXPECT_EQ(number.fault, nullptr) << text.substr(0, 60) << ": " << number.fault;
  return number.value;
}

std::string fault_of(const std::string& text) {
  const NumberText number = parse_number(text);
  return number.fault == nullptr ? "none" : number.fault;
}

Rational exactly(double value) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(mantissa, power) : Rational(Integer(mantissa) * power);
}

// digits * 10^exponent
Rational decimal(const Integer& digits, int exponent) {
  const Integer power = mp::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(digits, power) : Rational(digits * power);
}

Rational distance_of(const Rational& a, const Rational& b) {
  if (a < b) return b - a;
  return a - b;
}

// Whether no double is nearer to `value` than `candidate`, and in a tie `candidate` is the even one. `value`
// is below the midpoint of the largest double and 2^1024.
bool is_nearest_even(double candidate, const Rational& value) {
  const Rational distance = distance_of(exactly(candidate), value);
  for (const double toward : {-kInfinity, kInfinity}) {
    const double neighbour = std::nextafter(candidate, toward);
    if (std::isinf(neighbour)) continue;
    const Rational other = distance_of(exactly(neighbour), value);
    if (other < distance) return false;
    if (other == distance && (std::bit_cast<std::uint64_t>(candidate) & 1) != 0) return false;
  }
  return true;
}

TEST(NumberText, RandomDecimalsAreTheNearestDouble) {
  CITES("FC-IN-02");
  std::mt19937_64 random(20240607);
  for (int round = 0; round < 20000; ++round) {
    const bool extreme = round % 4 == 0;
    const std::uint64_t digits = random() >> (random() % 60);
    const int exponent = extreme ? static_cast<int>(random() % 640) - 345 : static_cast<int>(random() % 40) - 20;
    if (decimal(digits, exponent) >= exactly(kLargest)) continue;
    const std::string text = std::to_string(digits) + "e" + std::to_string(exponent);
    EXPECT_TRUE(is_nearest_even(value_of(text), decimal(digits, exponent))) << text;
    EXPECT_EQ(value_of("-" + text), -value_of(text)) << text;
  }
}

TEST(NumberText, MidpointsOfDoublesRoundToEvenAndTheirNeighboursToTheNearest) {
  CITES("FC-IN-02");
  std::mt19937_64 random(7);
  for (int round = 0; round < 2000; ++round) {
    // Anything from the subnormals to 2^64, so that the midpoint's decimal has at most some 1,100 digits.
    const double low = std::bit_cast<double>(random() % std::bit_cast<std::uint64_t>(0x1p64));
    const double high = std::nextafter(low, kInfinity);
    const Rational middle = (exactly(low) + exactly(high)) / 2;
    const auto places = static_cast<unsigned>(mp::msb(denominator(middle)));
    const Integer digits = numerator(middle) * mp::pow(Integer(5), places);
    const std::string end = "e-" + std::to_string(places);
    const double even = (std::bit_cast<std::uint64_t>(low) & 1) == 0 ? low : high;
    EXPECT_EQ(value_of(digits.str() + end), even);
    EXPECT_EQ(value_of(digits.str() + ".000000000000000000001" + end), high);
    EXPECT_EQ(value_of(Integer(digits - 1).str() + ".9999999999999999" + end), low);
  }
}

TEST(NumberText, KnownDecimals) {
  CITES("FC-IN-02");
  EXPECT_EQ(value_of("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(value_of("9007199254740993.0000000000000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(value_of("9007199254740995"), 9007199254740996.0);
  EXPECT_EQ(value_of("-0.0378297"), -0.0378297);
  EXPECT_EQ(value_of("+1.5"), 1.5);
  EXPECT_EQ(value_of(".5"), 0.5);
  EXPECT_EQ(value_of("-5."), -5.0);
  EXPECT_EQ(value_of("1E+2"), 100.0);
  EXPECT_EQ(value_of("007e-0"), 7.0);
  EXPECT_TRUE(std::signbit(value_of("-0")));
}

TEST(NumberText, TheEdgesOfTheRange) {
  CITES("FC-IN-01", "FC-IN-02");
  EXPECT_EQ(value_of("5e-324"), kSmallest);
  EXPECT_EQ(value_of("4.9406564584124654e-324"), kSmallest);
  EXPECT_EQ(value_of("3e-324"), kSmallest);
  EXPECT_EQ(value_of("2.5e-324"), kSmallest);
  EXPECT_EQ(value_of("2.4e-324"), 0.0);
  EXPECT_EQ(value_of("2.2250738585072011e-308"), 0x0.fffffffffffffp-1022);
  EXPECT_EQ(value_of("1e-400"), 0.0);
  EXPECT_EQ(value_of("-1e-999999999999999999999"), 0.0);
  EXPECT_EQ(value_of("0e999999999999999999999"), 0.0);
  EXPECT_EQ(value_of("1.7976931348623157e308"), kLargest);
  EXPECT_EQ(value_of("1.7976931348623158e308"), kLargest);
  EXPECT_EQ(fault_of("1.7976931348623159e308"), "out of range of a double");
  EXPECT_EQ(fault_of("1e309"), "out of range of a double");
  EXPECT_EQ(fault_of("-1e999999999999999999999"), "out of range of a double");
  // The midpoint of the largest double and 2^1024 is rounded to 2^1024, which is even. A number just below it
  // is rounded to the largest double.
  const Integer midpoint = (Integer(1) << 1024) - (Integer(1) << 970);
  EXPECT_EQ(fault_of(midpoint.str()), "out of range of a double");
  EXPECT_EQ(value_of(Integer(midpoint - 1).str()), kLargest);
}

TEST(NumberText, ManyDigitsAreBroughtBackByManyExponents) {
  CITES("FC-IN-02");
  const std::string zeros(700000, '0');
  EXPECT_EQ(value_of("0." + zeros + "1e700001"), 1.0);
  EXPECT_EQ(value_of("1" + zeros + "e-700000"), 1.0);
  EXPECT_EQ(value_of("-0." + zeros + "15e+700001"), -1.5);
  EXPECT_EQ(value_of("1" + zeros + "e-701000"), 0.0);
  EXPECT_EQ(fault_of("1" + zeros), "out of range of a double");
  EXPECT_EQ(value_of("0." + zeros), 0.0);
  EXPECT_EQ(value_of("0x0." + zeros + "1p2800004"), 1.0);
  EXPECT_EQ(value_of("0x1" + zeros + "p-2800000"), 1.0);
}

TEST(NumberText, HexadecimalFloatsAreExactOrRefused) {
  CITES("FC-IN-01", "FC-IN-02");
  EXPECT_EQ(value_of("0x1.8p+1"), 3.0);
  EXPECT_EQ(value_of("-0X1.8P1"), -3.0);
  EXPECT_EQ(value_of("+0x10"), 16.0);
  EXPECT_EQ(value_of("0x.8"), 0.5);
  EXPECT_EQ(value_of("0x1p-1074"), kSmallest);
  EXPECT_EQ(value_of("0x10p-1078"), kSmallest);
  EXPECT_EQ(value_of("0x1.fffffffffffffp+1023"), kLargest);
  EXPECT_EQ(value_of("0x1.00000000000010000000000000p0"), std::nextafter(1.0, 2.0) + 0x0p0);
  EXPECT_EQ(value_of("0x0p999999999999999999999"), 0.0);
  EXPECT_TRUE(std::signbit(value_of("-0x0p0")));
  EXPECT_EQ(fault_of("0x1p1024"), "out of range of a double");
  EXPECT_EQ(fault_of("0x1p99999999999999999999"), "out of range of a double");
  for (const char* text : {"0x1p-1075", "0x3p-1075", "0x1.00000000000008p0", "0x1.fffffffffffff8p+1023",
                           "0x1.0000000000000000000000001", "0x20000000000001", "0x1p-99999999999999999999"}) {
    EXPECT_EQ(fault_of(text), "not exactly a double") << text;
  }
  for (const char* text : {"0x", "0xp1", "0x.", "0x1p", "0x1p+", "0x1.8.0", "0xg", "0x1p1.0", "0x-1", "0x1p 1"}) {
    EXPECT_EQ(fault_of(text), "not a number") << text;
  }
}

TEST(NumberText, HexadecimalFloatsGiveBackEveryDouble) {
  CITES("FC-IN-02");
  std::mt19937_64 random(3);
  for (int round = 0; round < 20000; ++round) {
    const double value = std::bit_cast<double>(random() >> (round % 3 == 0 ? 12 : 0));
    if (!std::isfinite(value)) continue;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%a", value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value_of(text.data())), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(NumberText, WhatIsNotANumber) {
  CITES("FC-IN-01", "FC-IN-05");
  for (const char* text : {"",    "+",   "-",   ".",  "e5", "abc", "1e",  "1e+",  "1e5x", "1..2",    "--1",  "+-1",
                           "-+1", "1,5", "1d0", "1 ", " 1", "1/2", "one", "-.e1", "nano", "infinit", "--inf"}) {
    EXPECT_EQ(fault_of(text), "not a number") << text;
  }
  for (const char* text : {"nan", "NaN", "-nan", "inf", "+INF", "-Infinity", "infinity"}) {
    EXPECT_EQ(fault_of(text), "not a finite number") << text;
  }
  EXPECT_EQ(fault_of(std::string("1\0", 2)), "not a number");
}

struct DecimalComma : std::numpunct<char> {
 protected:
  [[nodiscard]] char do_decimal_point() const override { return ','; }
};

// C++'s streams always see the comma, C's functions only where such a locale is installed.
TEST(NumberText, DoesNotLookAtTheLocale) {
  CITES("FC-IN-02");
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  }
  std::ostringstream shown;
  shown << 1.5;
  EXPECT_EQ(shown.str(), "1,5");  // the comma is in force
  EXPECT_EQ(value_of("1.5"), 1.5);
  EXPECT_EQ(value_of("1.5e-400"), 0.0);
  EXPECT_EQ(fault_of("1,5"), "not a number");
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
}

// ---- Claims ----

constexpr LinePlace kPlace = {.file = "a", .line = 7};

// "3/2 exact", "3/2 near" or "refused"
std::string claimed(const std::string& text, PlainInteger plain) {
  try {
    const ClaimedNumber number = claimed_number(text, plain, kPlace);
    return to_text(number.value) + (number.is_exact ? " exact" : " near");
  } catch (const InvalidInput& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("a:7: ")) << error.what();
    return "refused";
  }
}

struct GrammarRow {
  std::string text;
  std::string value;  // or "refused"
};

TEST(ClaimedNumber, DecimalsAreWrittenInOneWay) {
  CITES("FC-FILE-47", "FC-FILE-18");
  const GrammarRow rows[] = {{"5", "5 near"},
                             {"+5", "5 near"},
                             {"-5", "-5 near"},
                             {"005", "5 near"},
                             {".5", "1/2 near"},
                             {"-.5", "-1/2 near"},
                             {"+.5", "1/2 near"},
                             {"5.", "5 near"},
                             {"5.25", "21/4 near"},
                             {"5e2", "500 near"},
                             {"5E2", "500 near"},
                             {"5E+5", "500000 near"},
                             {"5e-1", "1/2 near"},
                             {".5e1", "5 near"},
                             {"5.e1", "50 near"},
                             {"-0", "0 near"},
                             {"1e+007", "10000000 near"},
                             {"", "refused"},
                             {".", "refused"},
                             {"+", "refused"},
                             {"-.", "refused"},
                             {"e5", "refused"},
                             {".e5", "refused"},
                             {"5e", "refused"},
                             {"5e+", "refused"},
                             {"5e1.0", "refused"},
                             {"5e+-1", "refused"},
                             {"--5", "refused"},
                             {"+-5", "refused"},
                             {"5..", "refused"},
                             {"5.0.0", "refused"},
                             {"5,5", "refused"},
                             {" 5", "refused"},
                             {"5 ", "refused"},
                             {"5d2", "refused"},
                             {"5*^2", "refused"},
                             {"1_000", "refused"},
                             {"5f", "refused"},
                             {"nan", "refused"},
                             {"inf", "refused"},
                             {"1.#INF", "refused"},
                             {"\u0665", "refused"},
                             {"\uff15", "refused"},
                             {"5\u0665", "refused"},
                             {"\u22125", "refused"},
                             {std::string("5\0", 2), "refused"}};
  for (const GrammarRow& row : rows) {
    EXPECT_EQ(claimed(row.text, PlainInteger::kDecimal), row.value) << row.text;
    // Among rationals, digits alone are exact.
    const bool is_integer = row.text.find_first_of(".eE") == std::string::npos && row.value.ends_with(" near");
    const std::string among = is_integer ? row.value.substr(0, row.value.size() - 4) + "exact" : row.value;
    EXPECT_EQ(claimed(row.text, PlainInteger::kExact), among) << row.text;
  }
}

TEST(ClaimedNumber, FractionsAndHexadecimalFloatsAreWrittenInOneWay) {
  CITES("FC-FILE-47", "FC-FILE-18");
  const GrammarRow rows[] = {{"3/2", "3/2"},
                             {"-3/2", "-3/2"},
                             {"+3/2", "3/2"},
                             {"06/04", "3/2"},
                             {"0/1", "0"},
                             {"3/-2", "refused"},
                             {"3/+2", "refused"},
                             {"-3/-2", "refused"},
                             {"3/0", "refused"},
                             {"3/00", "refused"},
                             {"3/", "refused"},
                             {"/2", "refused"},
                             {"3//2", "refused"},
                             {"3/2/1", "refused"},
                             {"3 /2", "refused"},
                             {"1.5/2", "refused"},
                             {"3/2e1", "refused"},
                             {"0x3/2", "refused"},
                             {"3/\u0662", "refused"},
                             {"0x1.8", "3/2"},
                             {"0X1.8P0", "3/2"},
                             {"-0x.8p+1", "-1"},
                             {"+0x3.p-1", "3/2"},
                             {"0xaB", "171"},
                             {"0x10p-04", "1"},
                             {"0x0p9999999", "0"},
                             {"0x", "refused"},
                             {"0x.", "refused"},
                             {"0xp1", "refused"},
                             {"0x1p", "refused"},
                             {"0x1p+", "refused"},
                             {"0x1.8.0", "refused"},
                             {"0xg", "refused"},
                             {"0x-1", "refused"},
                             {"x1", "refused"},
                             {"0x1e+5", "refused"},
                             {"0x1p1024", "refused"},
                             {"0x1p-1075", "refused"},
                             {"0x20000000000001", "refused"}};
  for (const GrammarRow& row : rows) {
    const std::string value = row.value == "refused" ? row.value : row.value + " exact";
    EXPECT_EQ(claimed(row.text, PlainInteger::kDecimal), value) << row.text;
    EXPECT_EQ(claimed(row.text, PlainInteger::kExact), value) << row.text;
    // Orbits and pairs in JSON have the exact ones.
    if (row.value == "refused") {
      EXPECT_THROW((void)exact_rational(row.text), InvalidInput) << row.text;
    } else {
      EXPECT_EQ(to_text(exact_rational(row.text)), row.value) << row.text;
    }
  }
  EXPECT_EQ(to_text(exact_rational("+007")), "7");
  EXPECT_EQ(to_text(exact_rational("-7")), "-7");
  for (const char* text : {"", "7.", ".5", "1e2", "--7", "7 ", "nan", "\u0667"}) {
    EXPECT_THROW((void)exact_rational(text), InvalidInput) << text;
  }
}

TEST(ClaimedNumber, IdsCountsAndIndicesAreDigitsAlone) {
  CITES("FC-FILE-47", "FC-FILE-18");
  EXPECT_EQ(claimed_id("0", kPlace), 0U);
  EXPECT_EQ(claimed_id("007", kPlace), 7U);
  EXPECT_EQ(claimed_id("2147483646", kPlace), 2147483646U);
  EXPECT_EQ(written_count("0018", kPlace), 18U);
  EXPECT_EQ(written_count("18446744073709551615", kPlace), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(claimed_index("3", kPlace), 3);
  for (const char* text :
       {"", "+1", "-1", "-0", "1.", "1.0", "1e0", "0x1", " 1", "1 ", "\u0661", "18446744073709551616"}) {
    EXPECT_THROW((void)claimed_id(text, kPlace), InvalidInput) << text;
    EXPECT_THROW((void)written_count(text, kPlace), InvalidInput) << text;
    EXPECT_THROW((void)claimed_index(text, kPlace), InvalidInput) << text;
  }
  EXPECT_THROW((void)claimed_id("2147483647", kPlace), InvalidInput);
  for (const char* text : {"4", "01", "00", "9"}) EXPECT_THROW((void)claimed_index(text, kPlace), InvalidInput) << text;
}

// What is exact may be long, and so may no decimal.
TEST(ClaimedNumber, LengthsAreBounded) {
  CITES("FC-FILE-18");
  const std::string digits(2000, '7');
  EXPECT_TRUE(claimed(digits, PlainInteger::kDecimal).ends_with(" near"));
  EXPECT_EQ(claimed(digits + "7", PlainInteger::kDecimal), "refused");
  EXPECT_TRUE(claimed(digits + "7", PlainInteger::kExact).ends_with(" exact"));
  EXPECT_EQ(claimed(digits + ".", PlainInteger::kExact), "refused");
  EXPECT_TRUE(claimed(digits + "/1", PlainInteger::kDecimal).ends_with(" exact"));
  EXPECT_EQ(claimed("0x" + std::string(999'997, '0') + "1", PlainInteger::kDecimal), "1 exact");
  EXPECT_EQ(claimed("0x" + std::string(999'998, '0') + "1", PlainInteger::kDecimal), "refused");
  EXPECT_EQ(claimed(std::string(999'999, '0') + "1", PlainInteger::kExact), "1 exact");
  EXPECT_EQ(claimed(std::string(1'000'000, '0') + "1", PlainInteger::kExact), "refused");
  for (const char* exponent : {"700", "-700", "+0700"}) {
    EXPECT_TRUE(claimed("1e" + std::string(exponent), PlainInteger::kDecimal).ends_with(" near")) << exponent;
  }
  for (const char* exponent : {"701", "-701", "99999999999999999999"}) {
    EXPECT_EQ(claimed("1e" + std::string(exponent), PlainInteger::kDecimal), "refused") << exponent;
  }
}

TEST(NumberText, QuotesOnOneLine) {
  CITES("FC-IN-05");
  EXPECT_EQ(in_quotes("abc"), "'abc'");
  EXPECT_EQ(in_quotes("a\x1b[1m\n"), R"('a\x1b[1m\n')");
  EXPECT_EQ(in_quotes(std::string(1000, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace flowcert::number_text_test
