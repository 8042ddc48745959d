#include "flowcert/saddle_radii.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "io/value_order.h"

namespace flowcert {

using namespace io;

namespace {

// ---- The spacing ----

// For each sample: the critical point of index 1 that is nearest to it.
std::optional<Rational> squared_spacing_of(const FlowComplex& complex, const SquaredDistances& values) {
  const PointSet& points = complex.points();
  const StationaryPoints& stationary = complex.stationary();
  if (points.size() < 2) return std::nullopt;
  constexpr std::uint32_t kNone = 0xffffffffu;
  struct Nearest {
    std::uint32_t rank = kNone;
    std::size_t record = 0;
  };
  std::vector<Nearest> nearest(points.size());
  const std::size_t first = stationary.critical_counts()[0], last = first + stationary.critical_counts()[1];
  for (std::size_t record = first; record < last; ++record) {
    for (const PointId name : stationary.contact(record)) {
      Nearest& of_sample = nearest[points.ordinal_of_row(name)];
      if (values.rank(record) < of_sample.rank) of_sample = {values.rank(record), record};
    }
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>((nearest.size() - 1) / 2);
  std::ranges::nth_element(nearest, middle, {}, &Nearest::rank);
  return 4 * values.exact(middle->record);
}

// ---- The histogram ----

constexpr std::size_t kMostRadiusBins = 30;

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

// ---- The order ----

struct SaddleRadii::Parts {
  Parts(const FlowComplex& complex, SquaredDistances&& distances)
      : values(std::move(distances)), spacing(squared_spacing_of(complex, values)), order(order_of(complex)) {}

  [[nodiscard]] ValueOrder order_of(const FlowComplex& complex) const {
    const auto& counts = complex.stationary().critical_counts();
    const std::size_t first = counts[0] + counts[1];
    std::vector<ValueRange> ranges;
    std::vector<std::uint64_t> ranks;
    for (std::size_t record = first; record < first + counts[2]; ++record) {
      const auto& [value, error] = values.approximation(record);
      // The sums are rounded.
      ranges.push_back({std::max(0.0, value - error - value * 0x1p-51), value + error + value * 0x1p-51});
      ranks.push_back(values.rank(record));
    }
    return {std::move(ranges), std::move(ranks), [this, first](std::size_t i) { return values.exact(first + i); }};
  }

  SquaredDistances values;
  std::optional<Rational> spacing;
  ValueOrder order;
};

std::optional<Rational> squared_spacing(const FlowComplex& complex) {
  return squared_spacing_of(complex, SquaredDistances(complex.points(), complex.stationary()));
}

SaddleRadii::SaddleRadii(const FlowComplex& complex)
    : parts_(std::make_unique<Parts>(complex, SquaredDistances(complex.points(), complex.stationary()))) {}
SaddleRadii::~SaddleRadii() = default;
SaddleRadii::SaddleRadii(SaddleRadii&&) noexcept = default;
SaddleRadii& SaddleRadii::operator=(SaddleRadii&&) noexcept = default;

std::size_t SaddleRadii::size() const { return parts_->order.size(); }
Rational SaddleRadii::squared_radius(std::size_t place) const { return parts_->order.exact(place); }
std::size_t SaddleRadii::number(std::size_t place) const { return parts_->order.at(place); }
std::size_t SaddleRadii::count_below(const Rational& squared_bound) const {
  return parts_->order.count_below(squared_bound);
}
std::optional<std::size_t> SaddleRadii::widest_gap() const {
  if (size() < 2) return std::nullopt;
  const std::size_t median = (size() - 1) / 2;
  // The numbers in the order are squares.
  constexpr int kRange = kWidestGapRange * kWidestGapRange;
  const std::size_t end = parts_->order.count_up_to(kRange * squared_radius(median));
  return parts_->order.widest_gap(median, std::min(end, size() - 1));
}
const std::optional<Rational>& SaddleRadii::squared_spacing() const { return parts_->spacing; }

std::vector<RadiusBin> radius_histogram(const SaddleRadii& radii) {
  if (radii.size() == 0) return {};
  // Where there is a circle, there are several samples.
  const Rational unit = radii.squared_spacing().value();
  const Rational least = radii.squared_radius(0) / unit, most = radii.squared_radius(radii.size() - 1) / unit;
  const std::int64_t least_power = power_below(least), most_power = power_below(most);
  std::vector<RadiusBin> bins;
  for (const EdgeSeries& series : edge_series()) {
    const std::int64_t first = series.below(least, least_power), last = series.below(most, most_power);
    if (last - first >= static_cast<std::int64_t>(kMostRadiusBins)) continue;
    for (std::int64_t k = first; k <= last; ++k) {
      const Rational from = series.edge(k), to = series.edge(k + 1);
      bins.push_back({from, to, radii.count_below(to * to * unit) - radii.count_below(from * from * unit)});
    }
    break;
  }
  return bins;
}

}  // namespace flowcert
