// Numbers as text, exactly as the spec reads them, and as the doubles that files hold.
//
// Guarantees: a decimal of any length becomes the nearest double, ties to even. A number too small for a subnormal
// becomes zero. A hexadecimal float (0x…) is taken exactly or refused. NaN, infinities and whatever would round to an
// infinity are refused. The locale has no influence. Source: spec clauses FC-IN-01 and FC-IN-02.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "flowcert/claimed_number.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "io/layer.h"
#include "io/line_reader.h"
#include "morse/length_bound.h"

namespace flowcert::io {

// ---- Doubles ----

struct NumberText {
  double value = 0;
  // Why the text is refused; null when it is a number.
  const char* fault = nullptr;
  // False for NaN, an infinity, and what overflows. These are refused, too.
  bool is_finite = true;

  // Whether it is one, finite or not.
  [[nodiscard]] bool is_number() const { return fault == nullptr || !is_finite; }
};

// All of `text` must be the number. A leading '+' is accepted.
[[nodiscard]] NumberText parse_number(std::string_view text);

// `text` for a message, in single quotes. Whatever it holds, the result is one short line.
[[nodiscard]] std::string in_quotes(std::string_view text);

// ---- Rationals ----
// Reads a coordinate as commands take it. A decimal means the nearest double, so that a pasted row of a file gives
// the sample. A hexadecimal float or a fraction p/q is taken exactly. Throws InvalidInput, one line, for anything
// that is no number.
[[nodiscard]] Rational parse_rational(std::string_view text);

// "-3/4", "5", "0x1p-1": an integer is exact, however large it is. Decimals and anything else throw InvalidInput.
[[nodiscard]] Rational exact_rational(std::string_view text);

// Three numbers that parse_rational takes, separated by commas or blanks.
[[nodiscard]] RationalPoint parse_rational_point(std::string_view text);

// A bound on lengths or radii: "X", in units of the input; "3spacing", a multiple of the samples' spacing; "q0.9", a
// quantile of all lengths; "auto", the length below the valley of their histogram. Numbers are read exactly. Throws
// InvalidInput for anything else: the message begins with the option, and which one of these it is, from 1.
[[nodiscard]] LengthBound length_bound_of(std::string_view text, const std::string& option, std::size_t ordinal);

// An exact length of 0 or more. Throws InvalidInput; the message begins with the option.
[[nodiscard]] Rational length_of_option(const std::string& text, const char* option);

// ---- What a claim can hold ----
// Numbers exact or decimal, ids, indices, counts.
//
// Guarantees: a number is the number that is written, not a double near it. A number that could grow far beyond its
// text (1e999999999) is refused. Throws InvalidInput with the place. Source: spec clauses FC-IN-01, FC-NUM-02,
// FC-OUT-01, FC-FILE-47.

// Whether an integer without a denominator is exact. "5" is exact among rationals. Among decimals it may be a
// rounded 5.0000001.
enum class PlainInteger { kExact, kDecimal };

// A fraction p/q or a hexadecimal float (both exact), or a decimal. A fraction has at most a million characters. A
// decimal has at most 2,000, and an exponent of at most 700 (the square of a double has 617).
[[nodiscard]] ClaimedNumber claimed_number(std::string_view text, PlainInteger plain, const LinePlace& place);

// The same for a distance or a squared distance, which cannot be negative.
[[nodiscard]] ClaimedNumber claimed_distance(std::string_view text, PlainInteger plain, const LinePlace& place);

// The id of a row: digits alone, at most 2^31 - 2.
inline constexpr PointId kLargestId = 2147483646;
[[nodiscard]] PointId claimed_id(std::string_view text, const LinePlace& place);

// 0, 1, 2 or 3.
[[nodiscard]] int claimed_index(std::string_view text, const LinePlace& place);

// ---- Counts ----

// Digits alone; anything else is refused.
[[nodiscard]] std::uint64_t written_count(std::string_view text, const LinePlace& place);
// A count of what is in memory. A browser, with 32 bits of it, refuses larger ones.
[[nodiscard]] std::size_t written_size(std::string_view text, const LinePlace& place);

// As people read them: "34,835".
[[nodiscard]] std::string with_commas(unsigned long long value);
// "1 case", "1,200 cases"
[[nodiscard]] std::string counted(unsigned long long count, const std::string& what);

// ---- To doubles ----
// Exact positions and squared distances as the doubles nearest to them, for files that hold nothing else.
class BeyondDoubles : public InvalidInput {
 public:
  BeyondDoubles();
};

// All throw BeyondDoubles where a number would overflow. A number that was rounded before is infinite then.
[[nodiscard]] double rounded(const Rational& value);
[[nodiscard]] Point rounded(const RationalPoint& position);
[[nodiscard]] double finite(double value);
[[nodiscard]] Point finite(const Point& position);

// ---- Bytes ----
// Numbers as the bytes that binary files hold.

// Little endian, whatever the machine.
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

// A number as files store it: kind 'f' is an IEEE float of 4 or 8 bytes; 'i', with a sign, and 'u' are integers of 1, 2,
// 4 or 8 bytes.
struct StoredType {
  char kind = 'f';
  std::size_t size = 8;

  friend bool operator==(const StoredType&, const StoredType&) = default;
};
inline constexpr StoredType kFloat = {'f', 4};

// Nothing where there is no such type.
[[nodiscard]] std::optional<StoredType> stored_type(char kind, std::uint64_t size);

// At most 8 bytes as one number.
[[nodiscard]] std::uint64_t stored_bits(const char* bytes, std::size_t size, bool is_big_endian);

// The number at `bytes`, exactly. Nothing where no double has the value, which only large 64-bit integers lack.
[[nodiscard]] std::optional<double> stored_number(const char* bytes, StoredType type, bool is_big_endian);

}  // namespace flowcert::io
