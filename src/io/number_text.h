// Numbers as text, exactly as the spec reads them, and as the doubles that files hold.
//
// Guarantees: a decimal becomes the nearest double, ties to even, however long it is; what is too small for
// the smallest subnormal becomes zero. A hexadecimal float (0x…) is taken exactly or refused. NaN, infinities
// and whatever would round to an infinity are refused. Does not look at the locale. Source: spec clauses
// FC-IN-01 and FC-IN-02.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "flowcert/claim.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert::io {

// ---- Doubles ----

struct NumberText {
  double value = 0;
  // Why the text is refused; null when it is a number.
  const char* fault = nullptr;
};

// All of `text` must be the number. A leading '+' is accepted.
[[nodiscard]] NumberText parse_number(std::string_view text);

// `text` for a message: in single quotes, on one line and not long, whatever it holds.
[[nodiscard]] std::string in_quotes(std::string_view text);

// ---- Rationals ----
// Text to an exact coordinate, as commands take it: a decimal is the nearest double (so that a pasted row of
// a file hits the sample), a hexadecimal float or a fraction p/q is taken exactly.
// Throws InvalidInput, one line, for what is no number.
[[nodiscard]] Rational parse_rational(std::string_view text);

// "-3/4", "5": an integer is exact, however large it is. Decimals are refused, as all else, with
// InvalidInput.
[[nodiscard]] Rational exact_rational(std::string_view text);

// Three numbers that parse_rational takes, separated by commas or blanks.
[[nodiscard]] RationalPoint parse_rational_point(std::string_view text);

// ---- What a claim can hold ----
// Numbers exact or decimal, ids, indices, counts.
//
// Guarantees: a number is the number that is written, not a double near it. What could grow beyond its text
// (1e999999999) is refused. Throws InvalidInput with the place. Source: spec clauses FC-IN-01, FC-NUM-02,
// FC-OUT-01.
// What an integer without a denominator is: "5" among rationals is exact, and among decimals it may be a
// rounded 5.0000001.
enum class PlainInteger { kExact, kDecimal };

// A fraction p/q or a hexadecimal float (both exact), or a decimal, of at most 2,000 characters and with an
// exponent of at most 700 (the square of a double has 617). Fractions have at most a million characters.
[[nodiscard]] ClaimedNumber claimed_number(std::string_view text, PlainInteger plain, const LinePlace& place);

// The same for a distance or a squared distance, which cannot be negative.
[[nodiscard]] ClaimedNumber claimed_distance(std::string_view text, PlainInteger plain,
                                             const LinePlace& place);

// A row of some input: digits alone, at most 2^31 - 2.
[[nodiscard]] PointId claimed_id(std::string_view text, const LinePlace& place);

// 0, 1, 2 or 3.
[[nodiscard]] int claimed_index(std::string_view text, const LinePlace& place);

// Digits alone.
[[nodiscard]] std::size_t claimed_count(std::string_view text, const LinePlace& place);

// ---- To doubles ----
// Exact positions and squared distances as the doubles nearest to them, for files that hold nothing else.
class BeyondDoubles : public InvalidInput {
 public:
  BeyondDoubles();
};

// Both throw BeyondDoubles where a number would overflow.
[[nodiscard]] double rounded(const Rational& value);
[[nodiscard]] Point rounded(const RationalPoint& position);

// ---- Bytes ----
// Numbers as the bytes that binary files hold.
//
// Guarantees: little endian, whatever the machine.
template <std::unsigned_integral Bits>
void append_little_endian(std::string& bytes, Bits bits) {
  for (std::size_t k = 0; k < sizeof(Bits); ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xffU);
}
inline void append_little_endian(std::string& bytes, double value) {
  append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}
template <std::signed_integral Number>
void append_little_endian(std::string& bytes, Number value) {
  append_little_endian(bytes, static_cast<std::make_unsigned_t<Number>>(value));
}

}  // namespace flowcert::io
