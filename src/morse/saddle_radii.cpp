#include "morse/saddle_radii.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "morse/log_histogram.h"

namespace flowcert::morse {

// For each sample: the critical point of index 1 that is nearest to it.
std::optional<Rational> squared_spacing(const FlowComplex& complex, const SquaredDistances& values) {
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

namespace {

ValueOrder order_of(const FlowComplex& complex, const SquaredDistances& values) {
  const auto& counts = complex.stationary().critical_counts();
  std::vector<std::size_t> records(counts[2]);
  std::iota(records.begin(), records.end(), std::size_t{counts[0] + counts[1]});
  return radius_order(values, std::move(records));
}

}  // namespace

std::optional<Rational> squared_spacing(const FlowComplex& complex) {
  return squared_spacing(complex, SquaredDistances(complex.points(), complex.stationary()));
}

SaddleRadii::SaddleRadii(const FlowComplex& complex)
    : values_(complex.points(), complex.stationary()),
      spacing_(morse::squared_spacing(complex, values_)),
      order_(order_of(complex, values_)) {}

// Where there is a circle, there are several samples.
std::vector<HistogramBin> SaddleRadii::histogram() const {
  return size() == 0 ? std::vector<HistogramBin>() : log_histogram(order_, spacing_.value());
}

std::optional<HistogramValley> SaddleRadii::valley() const {
  if (size() == 0) return std::nullopt;
  const auto found = placed_valley(order_, spacing_.value());
  return found ? std::optional(found->valley) : std::nullopt;
}

}  // namespace flowcert::morse
