// Rationals as the public interface shows them: canonical text, the nearest double, and numbers in text.
//
// nearest_double is compared with its definition, exactly: no other double is nearer, and of two that are
// equally near it is the even one. Both ends of the range are tested too, and powers of two, where the
// neighbours are not equally far.
#include "flowcert/rational.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "flowcert/point_set.h"
#include "io/number_text.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::rational_test {

using namespace io;
namespace {

using flowcert_tests::PortableRandom;
using BigInt = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

Rational power_of_two(int exponent) {
  const BigInt power = BigInt(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(1) / Rational(power) : Rational(power);
}

Rational distance_of(const Rational& a, const Rational& b) { return a < b ? Rational(b - a) : Rational(a - b); }

bool is_even(double value) { return (std::bit_cast<std::uint64_t>(value) & 1) == 0; }

// Checks the definition. For rounding, the number next beyond the largest double is 2^1024.
void expect_nearest(const Rational& value) {
  const std::optional<double> got = nearest_double(value);
  const Rational beyond = power_of_two(1024);
  const Rational overflow = (beyond + Rational(kLargest)) / 2;  // a tie, and 2^1024 is the even one
  if (value >= overflow || value <= -overflow) {
    EXPECT_EQ(got, std::nullopt) << to_text(value).substr(0, 80);
    return;
  }
  ASSERT_TRUE(got.has_value()) << to_text(value).substr(0, 80);
  ASSERT_FALSE(*got == 0 && std::signbit(*got)) << "no negative zero";
  const Rational distance = distance_of(value, Rational(*got));
  for (const double toward : {-HUGE_VAL, HUGE_VAL}) {
    const double neighbor = std::nextafter(*got, toward);
    const Rational position = std::isfinite(neighbor) ? Rational(neighbor) : neighbor > 0 ? beyond : Rational(-beyond);
    const Rational other = distance_of(value, position);
    ASSERT_LE(distance, other) << to_text(value).substr(0, 80);
    if (distance == other) {
      ASSERT_TRUE(is_even(*got)) << to_text(value).substr(0, 80);
    }
  }
}

BigInt random_bits(PortableRandom& random, std::size_t bits) {
  BigInt value = 1;
  for (std::size_t done = 0; done < bits; done += 64) value = (value << 64) + random.next();
  return value >> (64 - bits % 64);
}

TEST(NearestDoubleTest, OfRandomRationalsInAllSizes) {
  CITES("FC-NUM-02");
  PortableRandom random(11);
  int subnormal = 0, overflown = 0;
  for (int k = 0; k < 40000; ++k) {
    const BigInt top = random_bits(random, 1 + random.below(200)), bottom = random_bits(random, 1 + random.below(200));
    Rational value = Rational(top) / Rational(bottom) * power_of_two(random.between(-1200, 1150));
    if (random.coin()) value = -value;
    expect_nearest(value);
    if (HasFatalFailure()) return;
    const auto got = nearest_double(value);
    subnormal += got && *got != 0 && std::fabs(*got) < std::numeric_limits<double>::min() ? 1 : 0;
    overflown += got ? 0 : 1;
  }
  EXPECT_GT(subnormal, 300);
  EXPECT_GT(overflown, 300);
}

// Doubles themselves, the middles between neighbours, and what is just beside the middles.
TEST(NearestDoubleTest, OfDoublesAndOfTies) {
  CITES("FC-NUM-02");
  PortableRandom random(12);
  const Rational hair = power_of_two(-1300);
  for (int k = 0; k < 20000; ++k) {
    const double value = std::bit_cast<double>(random.next());
    if (!std::isfinite(value)) continue;
    const double next = std::nextafter(value, HUGE_VAL);
    if (!std::isfinite(next)) continue;
    EXPECT_EQ(nearest_double(Rational(value)), value);
    const Rational middle = (Rational(value) + Rational(next)) / 2;
    EXPECT_EQ(nearest_double(middle), is_even(value) ? value : next);
    EXPECT_EQ(nearest_double(middle - hair), value);
    EXPECT_EQ(nearest_double(middle + hair), next);
  }
}

TEST(NearestDoubleTest, BetweenPowersOfTwo) {
  CITES("FC-NUM-02");
  for (int exponent = -1074; exponent <= 1023; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    for (const double neighbor : {std::nextafter(power, 0.0), std::nextafter(power, HUGE_VAL)}) {
      const Rational gap = Rational(neighbor) - Rational(power);
      for (int quarter = 0; quarter <= 4; ++quarter) {
        expect_nearest(Rational(power) + gap * Rational(quarter) / 4);
        expect_nearest(-Rational(power) - gap * Rational(quarter) / 4);
      }
    }
  }
}

TEST(NearestDoubleTest, AtTheUpperEnd) {
  CITES("FC-NUM-02");
  const Rational half_way = power_of_two(1024) - power_of_two(970);
  const Rational hair = power_of_two(-2000);
  EXPECT_EQ(nearest_double(Rational(kLargest)), kLargest);
  EXPECT_EQ(nearest_double(half_way - hair), kLargest);
  EXPECT_EQ(nearest_double(half_way), std::nullopt);
  EXPECT_EQ(nearest_double(half_way + hair), std::nullopt);
  EXPECT_EQ(nearest_double(-half_way + hair), -kLargest);
  EXPECT_EQ(nearest_double(-half_way), std::nullopt);
  EXPECT_EQ(nearest_double(power_of_two(1024)), std::nullopt);
  EXPECT_EQ(nearest_double(power_of_two(1025) - 1), std::nullopt);
  EXPECT_EQ(nearest_double(-power_of_two(100000)), std::nullopt);
  EXPECT_EQ(nearest_double(Rational(2) * Rational(kLargest) / Rational(3)), kLargest / 3 * 2);
}

TEST(NearestDoubleTest, AtTheLowerEnd) {
  CITES("FC-NUM-02");
  const Rational smallest(kSmallest);
  EXPECT_EQ(nearest_double(smallest), kSmallest);
  EXPECT_EQ(nearest_double(smallest / 2), 0.0);
  EXPECT_EQ(nearest_double(smallest / 2 + power_of_two(-3000)), kSmallest);
  EXPECT_EQ(nearest_double(smallest * 3 / 2), 2 * kSmallest);
  EXPECT_EQ(nearest_double(smallest * 5 / 2), 2 * kSmallest);
  EXPECT_EQ(nearest_double(power_of_two(-1022) - smallest / 2), std::numeric_limits<double>::min());
  for (const Rational& tiny : {Rational(0), Rational(-smallest / 2), Rational(-power_of_two(-5000))}) {
    const auto got = nearest_double(tiny);
    ASSERT_EQ(got, 0.0);
    EXPECT_FALSE(std::signbit(*got));
  }
  EXPECT_EQ(nearest_double(-smallest), -kSmallest);
}

TEST(NearestDoubleTest, OfKnownFractions) {
  CITES("FC-NUM-02");
  EXPECT_EQ(nearest_double(Rational(1) / 3), 1.0 / 3.0);
  EXPECT_EQ(nearest_double(Rational(-2) / 3), -2.0 / 3.0);
  EXPECT_EQ(nearest_double(Rational(1) / 10), 0.1);
  EXPECT_EQ(nearest_double(Rational(7)), 7.0);
  EXPECT_EQ(nearest_double(power_of_two(53) + 1), 0x1p53);
  EXPECT_EQ(nearest_double(power_of_two(53) + 3), 0x1p53 + 4);
}

TEST(RationalTextTest, IsCanonical) {
  CITES("FC-NUM-02");
  EXPECT_EQ(to_text(Rational(0)), "0");
  EXPECT_EQ(to_text(Rational(5)), "5");
  EXPECT_EQ(to_text(Rational(-5)), "-5");
  EXPECT_EQ(to_text(Rational(6) / Rational(4)), "3/2");
  EXPECT_EQ(to_text(Rational(6) / Rational(-4)), "-3/2");
  EXPECT_EQ(to_text(Rational(-8) / Rational(-4)), "2");
  EXPECT_EQ(to_text(Rational(-0.0)), "0");
  EXPECT_EQ(to_text(Rational(0.75)), "3/4");
  EXPECT_EQ(to_text(Rational(1) / 3 + Rational(2) / 3), "1");
  EXPECT_EQ(to_text(Rational(1) / 3 - Rational(1) / 3), "0");
  EXPECT_EQ(to_text(Rational(1e22)), "10000000000000000000000");
  EXPECT_EQ(to_text(Rational(0x1p-60)), "1/1152921504606846976");
}

TEST(RationalTextTest, ReadsBackTheSame) {
  CITES("FC-NUM-02");
  PortableRandom random(13);
  for (int k = 0; k < 5000; ++k) {
    const BigInt top = random_bits(random, 1 + random.below(120)), bottom = random_bits(random, 1 + random.below(120));
    Rational value = Rational(top) / Rational(bottom);
    if (random.coin()) value = -value;
    const std::string text = to_text(value);
    // A whole number of more than 53 bits would be read as a decimal, that is, rounded.
    if (text.find('/') != std::string::npos) {
      ASSERT_EQ(parse_rational(text), value);
      ASSERT_EQ(to_text(parse_rational(text)), text);
    }
    const BigInt factor = random_bits(random, 1 + random.below(20));
    std::string unreduced = value < 0 ? "-" : "";
    unreduced += BigInt(top * factor).str();
    unreduced += '/';
    unreduced += BigInt(bottom * factor).str();
    ASSERT_EQ(to_text(parse_rational(unreduced)), text);
  }
}

TEST(ParseRationalTest, FractionsAreReduced) {
  CITES("FC-NUM-02");
  EXPECT_EQ(to_text(parse_rational("2/4")), "1/2");
  EXPECT_EQ(to_text(parse_rational("-3/6")), "-1/2");
  EXPECT_EQ(to_text(parse_rational("+3/6")), "1/2");
  EXPECT_EQ(to_text(parse_rational("6/3")), "2");
  EXPECT_EQ(to_text(parse_rational("0/7")), "0");
  EXPECT_EQ(to_text(parse_rational("-0/7")), "0");
  EXPECT_EQ(to_text(parse_rational("010/012")), "5/6") << "ten twelfths, not octal";
  EXPECT_EQ(to_text(parse_rational("123456789012345678901234567890/10")), "12345678901234567890123456789");
}

TEST(ParseRationalTest, DecimalsAreTheNearestDoubles) {
  CITES("FC-IN-02");
  EXPECT_EQ(parse_rational("0.1"), Rational(0.1));
  EXPECT_NE(parse_rational("0.1"), parse_rational("1/10"));
  EXPECT_EQ(parse_rational("-2.5e-3"), Rational(-2.5e-3));
  EXPECT_EQ(parse_rational("9007199254740993"), Rational(0x1p53));
  EXPECT_EQ(parse_rational("1e-400"), Rational(0));
  EXPECT_EQ(parse_rational("-0.0"), Rational(0));
  EXPECT_EQ(parse_rational("7"), Rational(7));
}

TEST(ParseRationalTest, HexadecimalFloatsAreExact) {
  CITES("FC-IN-02");
  EXPECT_EQ(parse_rational("0x1.8p1"), Rational(3));
  EXPECT_EQ(parse_rational("-0x1p-1074"), -power_of_two(-1074));
  EXPECT_THROW((void)parse_rational("0x1.00000000000001p0"), InvalidInput);
  EXPECT_THROW((void)parse_rational("0x1p-1075"), InvalidInput);
}

TEST(ParseRationalTest, RefusesWhatIsNoNumber) {
  CITES("FC-IN-01");
  for (const char* text :
       {"1/0",    "-1/0", "0/0", "1/-2", "1/+2", "nan", "-nan", "inf",   "-inf",  "infinity", "1e400",
        "-1e400", "",     "/",   "1/",   "/2",   "-/2", "1//2", "1/2/3", "1.5/2", "1/2.0",    "1e1/2",
        "0x1/2",  " 1",   "1 ",  "1 /2", "--1",  "+-1", "one",  "1/2x",  "nan/1"}) {
    EXPECT_THROW((void)parse_rational(text), InvalidInput) << '\'' << text << '\'';
  }
  try {
    (void)parse_rational("5/00");
    ADD_FAILURE() << "5/00 was read";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "the denominator is zero: '5/00'");
  }
}

TEST(ParseRationalTest, PositionsHaveThreeCoordinates) {
  CITES("FC-IN-02", "FC-NUM-02");
  const RationalPoint expected = {Rational(1) / 2, Rational(-3), Rational(0.25)};
  for (const char* text : {"1/2,-3,0.25", "1/2 -3 0.25", "2/4, -3 ,\t0.25", "  1/2,-3,0.25  "}) {
    EXPECT_EQ(parse_rational_point(text), expected) << text;
  }
  for (const char* text : {"", "  ", "1", "1,2", "1,2,3,4", "1,2,", ",1,2", "1,2,x", "1,2,1/0", "1;2;3"}) {
    EXPECT_THROW((void)parse_rational_point(text), InvalidInput) << '\'' << text << '\'';
  }
  try {
    (void)parse_rational_point("1,2");
    ADD_FAILURE() << "two coordinates were read";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "a position has three coordinates X,Y,Z, this has 2: '1,2'");
  }
}

}  // namespace
}  // namespace flowcert::rational_test
