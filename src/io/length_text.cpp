#include "io/length_text.h"

#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

namespace {

constexpr std::string_view kAutomatic = "auto", kSpacing = "spacing", kSquaredSpacing = "spacing^2";

}  // namespace

LengthBound length_bound_of(std::string_view text, const std::string& option, std::size_t ordinal) {
  using Unit = LengthBound::Unit;
  const LinePlace place = {option, ordinal};
  const auto number_of = [&](std::string_view digits) {
    return claimed_number(digits, PlainInteger::kExact, place).value;
  };
  if (text == kAutomatic) return {Unit::kValley, 0};
  if (text.ends_with(kSquaredSpacing))
    place.reject("a length is a multiple of spacing, not of its square: " + in_quotes(text));
  if (text.ends_with(kSpacing)) return {Unit::kSpacing, number_of(text.substr(0, text.size() - kSpacing.size()))};
  if (!text.starts_with('q')) return {Unit::kInput, number_of(text)};
  const Rational share = number_of(text.substr(1));
  if (share < 0 || share > 1) place.reject("no quantile from 0 to 1: " + in_quotes(text));
  return {Unit::kQuantile, share};
}

}  // namespace flowcert::io
