#include "flowcert/saddle_radii.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "geometry/floating_point.h"
#include "morse/log_histogram.h"

namespace flowcert {

using namespace morse;

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

}  // namespace

// ---- The order ----

struct SaddleRadii::Parts {
  Parts(const FlowComplex& complex, SquaredDistances&& distances)
      : values(std::move(distances)), spacing(squared_spacing_of(complex, values)), order(order_of(complex)) {}

  [[nodiscard]] ValueOrder order_of(const FlowComplex& complex) const {
    const auto& counts = complex.stationary().critical_counts();
    std::vector<std::size_t> records(counts[2]);
    std::iota(records.begin(), records.end(), std::size_t{counts[0] + counts[1]});
    return radius_order(values, std::move(records));
  }

  SquaredDistances values;
  std::optional<Rational> spacing;
  ValueOrder order;
};

std::optional<Rational> squared_spacing(const FlowComplex& complex) {
  const geometry::IeeeDoubles ieee;
  return squared_spacing_of(complex, SquaredDistances(complex.points(), complex.stationary()));
}

SaddleRadii::SaddleRadii(const FlowComplex& complex)
    : parts_(geometry::in_ieee_doubles([&] {
        return std::make_unique<Parts>(complex, SquaredDistances(complex.points(), complex.stationary()));
      })) {}
SaddleRadii::~SaddleRadii() = default;
SaddleRadii::SaddleRadii(SaddleRadii&&) noexcept = default;
SaddleRadii& SaddleRadii::operator=(SaddleRadii&&) noexcept = default;

std::size_t SaddleRadii::size() const { return parts_->order.size(); }
Rational SaddleRadii::squared_radius(std::size_t place) const { return parts_->order.exact(place).square; }
std::size_t SaddleRadii::number(std::size_t place) const { return parts_->order.at(place); }
std::size_t SaddleRadii::count_below(const Rational& squared_bound) const {
  const geometry::IeeeDoubles ieee;
  return parts_->order.count_below(squared_bound);
}
std::vector<HistogramBin> SaddleRadii::histogram() const {
  const geometry::IeeeDoubles ieee;
  // Where there is a circle, there are several samples.
  return size() == 0 ? std::vector<HistogramBin>() : log_histogram(parts_->order, parts_->spacing.value());
}
const std::optional<Rational>& SaddleRadii::squared_spacing() const { return parts_->spacing; }

std::optional<HistogramValley> SaddleRadii::valley() const {
  const geometry::IeeeDoubles ieee;
  if (size() == 0) return std::nullopt;
  const auto found = placed_valley(parts_->order, parts_->spacing.value());
  return found ? std::optional(found->valley) : std::nullopt;
}

}  // namespace flowcert
