#include "flowcert/length_bound.h"

#include "geometry/floating_point.h"
#include "io/layer.h"
#include "io/line_reader.h"
#include "io/log_histogram.h"
#include "io/number_text.h"
#include "io/value_order.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::string_view kAutomatic = "auto";

// The greatest integer that is not greater; the number is not negative.
std::size_t whole_part(const Rational& number) {
  return static_cast<std::size_t>(boost::multiprecision::mpz_int(numerator(number) / denominator(number)));
}

}  // namespace

LengthBound LengthBound::of(std::string_view text, std::string_view spacing, const std::string& option,
                            std::size_t ordinal) {
  const geometry::IeeeDoubles ieee;
  const LinePlace place = {option, ordinal};
  const auto number_of = [&](std::string_view digits) {
    return claimed_number(digits, PlainInteger::kExact, place).value;
  };
  if (text == kAutomatic) return {Unit::kValley, 0};
  if (text.ends_with(spacing)) return {Unit::kSpacing, number_of(text.substr(0, text.size() - spacing.size()))};
  if (!text.starts_with('q')) return {Unit::kInput, number_of(text)};
  const Rational share = number_of(text.substr(1));
  if (share < 0 || share > 1) place.reject("no quantile from 0 to 1: " + in_quotes(text));
  return {Unit::kQuantile, share};
}

LengthThreshold LengthBound::threshold(const ValueOrder& order, const std::optional<Rational>& squared_spacing) const {
  const geometry::IeeeDoubles ieee;
  switch (unit) {
    case Unit::kInput:
      return {number, {}};
    case Unit::kSpacing:
      return {number * squared_spacing.value_or(0), {}};
    case Unit::kQuantile: {
      const std::size_t shorter = order.size() - whole_part((1 - number) * order.size());
      return {shorter > 0 ? std::optional(order.exact(shorter - 1)) : std::nullopt, {}};
    }
    case Unit::kValley:
      break;
  }
  const auto found = squared_spacing ? placed_valley(order, *squared_spacing) : std::nullopt;
  if (!found) return {std::nullopt, AutomaticThreshold{}};
  return {order.exact(found->last_below), AutomaticThreshold{found->valley}};
}

}  // namespace flowcert
