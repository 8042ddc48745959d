#include "cli/fixed_decimals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flowcert/sphere.h"

namespace flowcert::cli {

namespace {

std::string text_of(double value, const std::optional<int>& decimals) {
  std::string text = decimals ? fmt::format("{:.{}f}", value, *decimals) : fmt::format("{:.4g}", value);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return text;
}

}  // namespace

FixedDecimals::FixedDecimals(const std::optional<Rational>& squared_spacing) {
  constexpr int kLargestPower = 6;
  const double square = squared_spacing ? nearest_or_infinity(*squared_spacing) : 0;
  if (!(square > 0) || !std::isfinite(square)) return;
  const int power = static_cast<int>(std::floor(std::log10(square) / 2));
  if (std::abs(power) > kLargestPower) return;
  decimals_ = std::max(0, 3 - power);
  of_volumes_ = std::max(0, 1 - 3 * power);
}

std::string FixedDecimals::length(double value) const { return text_of(value, decimals_); }

std::string FixedDecimals::volume(double value) const { return text_of(value, of_volumes_); }

std::string FixedDecimals::position(const Point& point) const {
  return fmt::format("{} {} {}", length(point.x), length(point.y), length(point.z));
}

}  // namespace flowcert::cli
