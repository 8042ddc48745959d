#include "flowcert/length_bound.h"

#include "geometry/floating_point.h"
#include "io/layer.h"
#include "io/line_reader.h"
#include "io/number_text.h"
#include "morse/log_histogram.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::string_view kAutomatic = "auto", kSpacing = "spacing", kSquaredSpacing = "spacing^2";

}  // namespace

LengthBound LengthBound::of(std::string_view text, const std::string& option, std::size_t ordinal) {
  const geometry::IeeeDoubles ieee;
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

LengthThreshold LengthBound::threshold(const ValueOrder& lengths, const std::optional<Rational>& squared_spacing,
                                       const std::optional<Rational>& same_within) const {
  const geometry::IeeeDoubles ieee;
  switch (unit) {
    case Unit::kInput:
    case Unit::kSpacing:
      if (number < 0) return {};
      return {number * number * (unit == Unit::kInput ? Rational(1) : squared_spacing.value_or(0)), {}};
    case Unit::kQuantile: {
      const std::size_t shorter = lengths.size() - part_of(lengths.size(), 1 - number);
      return {shorter > 0 ? std::optional(lengths.square_from_above(shorter - 1)) : std::nullopt, {}};
    }
    case Unit::kValley:
      break;
  }
  if (!squared_spacing) return {std::nullopt, AutomaticThreshold{}};
  const ValueOrder counted = same_within ? lengths.from_above_once(*same_within) : lengths;
  const auto found = placed_valley(counted, *squared_spacing);
  if (!found) return {std::nullopt, AutomaticThreshold{}};
  return {counted.square_from_above(found->last_below), AutomaticThreshold{found->valley}};
}

}  // namespace flowcert
