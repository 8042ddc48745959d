// Text to what a claim can hold: numbers exact or decimal, ids, indices, counts.
//
// Guarantees: a number is the number that is written, not a double near it. What could grow beyond its text
// (1e999999999) is refused. Throws InvalidInput with the place. Source: spec clauses FC-IN-01, FC-NUM-02,
// FC-OUT-01.
#pragma once

#include <cstddef>
#include <string_view>

#include "flowcert/claim.h"
#include "io/line_reader.h"

namespace flowcert::io {

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

}  // namespace flowcert::io
