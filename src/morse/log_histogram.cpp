#include "morse/log_histogram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flowcert::morse {

// ---- The histogram ----

namespace {

constexpr std::size_t kMostBins = 30;

Rational power_of_ten(std::int64_t exponent) {
  const Rational power = pow(boost::multiprecision::mpz_int(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? 1 / power : power;
}

std::int64_t floor_of_quotient(std::int64_t dividend, std::int64_t divisor) {
  return dividend >= 0 ? dividend / divisor : -((divisor - 1 - dividend) / divisor);
}

// Numbers between which bins lie: several in each power of ten, or one in several powers.
struct EdgeSeries {
  std::vector<Rational> in_power;
  std::int64_t powers = 1;

  [[nodiscard]] Rational edge(std::int64_t number) const {
    const std::int64_t size = static_cast<std::int64_t>(in_power.size()), power = floor_of_quotient(number, size);
    return in_power[static_cast<std::size_t>(number - power * size)] * power_of_ten(power * powers);
  }
  // The number of the last edge that is not beyond the root.
  [[nodiscard]] std::int64_t below(const Rational& square, std::int64_t power) const {
    std::int64_t number = floor_of_quotient(power, powers) * static_cast<std::int64_t>(in_power.size());
    for (Rational next = edge(number + 1); next * next <= square; next = edge(number + 1)) ++number;
    return number;
  }
};

std::vector<EdgeSeries> edge_series() {
  const auto hundredths = [](std::initializer_list<int> numbers) {
    std::vector<Rational> edges;
    for (const int number : numbers) edges.emplace_back(number, 100);
    return edges;
  };
  std::vector<EdgeSeries> all = {{hundredths({100, 125, 160, 200, 250, 315, 400, 500, 630, 800})},
                                 {hundredths({100, 200, 500})}};
  // The doubles have 632 powers of ten.
  for (const std::int64_t powers : {1, 2, 5, 10, 20, 50, 100}) all.push_back({{Rational(1)}, powers});
  return all;
}

// The greatest power of ten that is not beyond the root.
std::int64_t power_below(const Rational& square) {
  std::int64_t power = 0;
  for (Rational at = power_of_ten(power); at * at > square; at = power_of_ten(power)) --power;
  for (Rational next = power_of_ten(power + 1); next * next <= square; next = power_of_ten(power + 1)) ++power;
  return power;
}

}  // namespace

std::vector<HistogramBin> log_histogram(const ValueOrder& roots, const Rational& squared_unit) {
  const std::size_t zeros = roots.count_up_to(0);
  if (zeros == roots.size()) return {};
  const Rational least = roots.square_from_above(zeros) / squared_unit,
                 most = roots.square_from_above(roots.size() - 1) / squared_unit;
  const std::int64_t least_power = power_below(least), most_power = power_below(most);
  std::vector<HistogramBin> bins;
  for (const EdgeSeries& series : edge_series()) {
    const std::int64_t first = series.below(least, least_power), last = series.below(most, most_power);
    if (last - first >= static_cast<std::int64_t>(kMostBins)) continue;
    std::size_t below = zeros;
    for (std::int64_t k = first; k <= last; ++k) {
      const Rational from = series.edge(k), to = series.edge(k + 1);
      const std::size_t up_to = roots.count_below(to * to * squared_unit);
      bins.push_back({from, to, up_to - below});
      below = up_to;
    }
    break;
  }
  return bins;
}

// ---- The valley ----

namespace {

// Counts vary by their roots. The difference of two varies by the root of their sum.
bool stands_out(std::size_t high, std::size_t low) {
  if (high < 2 * low || high == low) return false;
  const boost::multiprecision::mpz_int difference = high - low, sum = high + low;
  return difference * difference > 9 * sum;
}

}  // namespace

std::optional<std::size_t> valley_of(const std::vector<HistogramBin>& bins) {
  const auto highest = std::ranges::max_element(bins, {}, &HistogramBin::count);
  std::optional<std::size_t> least;
  for (auto bin = highest == bins.end() ? highest : highest + 1; bin != bins.end(); ++bin) {
    const auto place = static_cast<std::size_t>(bin - bins.begin());
    if (!least || bin->count < bins[*least].count) {
      least = place;
    } else if (stands_out(bin->count, bins[*least].count)) {
      return least;
    }
  }
  return std::nullopt;
}

std::optional<PlacedValley> placed_valley(const ValueOrder& roots, const Rational& squared_unit) {
  const std::vector<HistogramBin> bins = log_histogram(roots, squared_unit);
  const std::optional<std::size_t> least = valley_of(bins);
  if (!least) return std::nullopt;
  const HistogramBin& bin = bins[*least];
  // There are numbers on both sides.
  const std::size_t before = roots.count_below(bin.from * bin.from * squared_unit);
  const std::size_t behind = roots.count_below(bin.to * bin.to * squared_unit);
  const std::size_t gap = *roots.widest_gap(before - 1, behind);
  return PlacedValley{{bin, gap + 1, roots.size() - gap - 1}, gap};
}

// ---- Thresholds ----

LengthThreshold threshold_of(const LengthBound& bound, const ValueOrder& lengths,
                             const std::optional<Rational>& squared_spacing,
                             const std::optional<Rational>& same_within) {
  const auto& [unit, number] = bound;
  switch (unit) {
    case LengthBound::Unit::kInput:
    case LengthBound::Unit::kSpacing:
      if (number < 0) return {};
      return {number * number * (unit == LengthBound::Unit::kInput ? Rational(1) : squared_spacing.value_or(0)), {}};
    case LengthBound::Unit::kQuantile: {
      const std::size_t shorter = lengths.size() - part_of(lengths.size(), 1 - number);
      return {shorter > 0 ? std::optional(lengths.square_from_above(shorter - 1)) : std::nullopt, {}};
    }
    case LengthBound::Unit::kValley:
      break;
  }
  if (!squared_spacing) return {std::nullopt, AutomaticThreshold{}};
  const ValueOrder counted = same_within ? lengths.from_above_once(*same_within) : lengths;
  const auto found = placed_valley(counted, *squared_spacing);
  if (!found) return {std::nullopt, AutomaticThreshold{}};
  return {counted.square_from_above(found->last_below), AutomaticThreshold{found->valley}};
}

}  // namespace flowcert::morse
