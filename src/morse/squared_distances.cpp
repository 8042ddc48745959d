// The bounds are those of filter_bounds.h: u is the unit roundoff, and the vectors go from the first sample to others.
#include "flowcert/squared_distances.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "flowcert/sphere.h"
#include "geometry/bounded_number.h"
#include "geometry/congruence_key.h"
#include "geometry/filter_bounds.h"
#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "geometry/prefetch.h"
#include "geometry/sort_in_parts.h"
#include "geometry/value_range.h"
#include "geometry/vector3.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

namespace {

using Approximation = SquaredDistances::Approximation;
using RoundedVector = Vector3<double>;

// ---- Constants of the bounds, in units of kUnitRoundoff ----

constexpr double kEdgeBound = 8;  // |a|^2 / 4: a square has 5.1
// |a|^2 |b|^2 |b-a|^2 / (4 |a x b|^2). The cross product has an error of 5.7 u |a||b|, so its square has a relative one
// of 12 u S with S = |a||b| / |a x b|, and of a few u more. The three squares and the operations add 24 u. Times S.
constexpr double kCircleBound = 40;
// The circumsphere's numerator has an error of 13.8 u T, and its determinant one of 9.8 u |a||b||c|.
constexpr double kNumeratorBound = 14, kDeterminantBound = 10;
// The relative error of a square is twice that of the number, and somewhat more. The operations add less than 16 u.
constexpr double kSquareShare = 2.5, kQuotientBound = 16;

// A value that is known less well than this is computed exactly.
constexpr double kLargestError = 0x1p-20;
// Squares of degree 8 and 6 in lengths may leave the range of doubles where the lengths do not.
constexpr double kLeastSquare = 1e-280, kGreatestSquare = 1e300;

std::optional<Approximation> with_relative_error(double value, double error) {
  if (!(error < kLargestError)) return std::nullopt;
  return Approximation{value, value * error};
}

bool is_in_range(double norm) { return norm >= kSmallestNorm && norm <= kLargestNorm; }

// |a|^2 / 4.
std::optional<Approximation> of_edge(const RoundedVector& a) {
  const double square = dot(a, a);
  if (!is_in_range(std::sqrt(square))) return std::nullopt;
  return with_relative_error(square / 4, kEdgeBound * kUnitRoundoff);
}

// |a|^2 |b|^2 |b-a|^2 / (4 |a x b|^2).
std::optional<Approximation> of_circle(const RoundedVector& a, const RoundedVector& b, const RoundedVector& c) {
  const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  if (!is_in_range(std::sqrt(std::min({aa, bb, cc}))) || !is_in_range(std::sqrt(std::max({aa, bb, cc})))) {
    return std::nullopt;
  }
  const RoundedVector n = cross(a, b);
  const double nn = dot(n, n);
  return with_relative_error(aa * bb * cc / (4 * nn), kCircleBound * kUnitRoundoff * std::sqrt(aa * bb / nn));
}

// |N|^2 / (4 det^2), with the circumsphere's numerator N and determinant.
std::optional<Approximation> of_sphere(const RoundedVector& a, const RoundedVector& b, const RoundedVector& c) {
  const double na = std::sqrt(dot(a, a)), nb = std::sqrt(dot(b, b)), nc = std::sqrt(dot(c, c));
  if (!is_in_range(std::min({na, nb, nc})) || !is_in_range(std::max({na, nb, nc}))) return std::nullopt;
  const auto sphere = circumsphere(a, b, c);
  const double product = na * nb * nc, square = dot(sphere.numerator, sphere.numerator);
  const double determinant = std::fabs(sphere.determinant);
  if (!(square > kLeastSquare && square < kGreatestSquare && determinant * determinant > kLeastSquare)) {
    return std::nullopt;
  }
  const double error =
      kNumeratorBound * product * (na + nb + nc) / std::sqrt(square) + kDeterminantBound * product / determinant;
  return with_relative_error(square / (4 * determinant * determinant),
                             (kSquareShare * error + kQuotientBound) * kUnitRoundoff);
}

// Any three points of a circle determine it, and any four of a sphere that are not coplanar.
std::optional<Approximation> approximation_of(const PointSet& points, StationaryIndex index,
                                              std::span<const PointId> contact) {
  const auto point = [&](std::size_t k) -> const Point& { return points.at_row(contact[k]); };
  const auto from_first = [&](std::size_t k) { return vector_between(point(0), point(k)); };
  switch (index.hull_dimension) {
    case 0:
      return Approximation{};
    case 1:
      return of_edge(from_first(1));
    case 2:
      return of_circle(from_first(1), from_first(2), vector_between(point(1), point(2)));
    default:
      return of_sphere(from_first(1), from_first(2), from_first(3));
  }
}

// The nearest double, with half a unit in its last place, or the whole range where there is none.
Approximation rounded(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  constexpr double kLargest = std::numeric_limits<double>::max();
  if (!nearest) return {kLargest, std::numeric_limits<double>::infinity()};
  return {*nearest, *nearest * kUnitRoundoff + std::numeric_limits<double>::denorm_min()};
}

ValueRange range_of(const Approximation& value) { return range_around(value.value, value.error); }

// A float is rounded by 2^-24 of itself.
constexpr double kFloatSlack = 1 + 0x1p-20;
// Products above this are normal doubles.
constexpr double kLeastLowEnd = 1e-290;

// Sorted and compared without a look at the value itself, which lies elsewhere.
struct KeyedRecord {
  std::uint64_t key = 0;  // the lower end of its range: doubles that are not negative ascend as their bits do
  std::uint32_t record = 0;
  float width = 0;  // the upper end is at most 1 + this times the lower end

  KeyedRecord() = default;
  KeyedRecord(const Approximation& value, std::uint32_t number) : record(number) {
    const ValueRange range = range_of(value);
    key = std::bit_cast<std::uint64_t>(range.low);
    // The quotient and the difference are rounded by less than the products add.
    width = static_cast<float>((range.high / range.low * (1 + kRoundingShare) - 1) * kFloatSlack);
  }
  // Nothing is known of the upper end where the products leave the doubles.
  [[nodiscard]] ValueRange range() const {
    const auto low = std::bit_cast<double>(key);
    const double high = low * (1.0 + static_cast<double>(width)) * (1 + kRoundingShare);
    return {low, std::isfinite(high) && low > kLeastLowEnd ? high : HUGE_VAL};
  }
};

// The records behind the first `samples` ones, by the lower ends of their values.
std::vector<KeyedRecord> sorted_by_low_end(const std::vector<Approximation>& values, std::size_t samples,
                                           unsigned threads) {
  std::vector<KeyedRecord> keyed;
  keyed.reserve(values.size() - samples);
  for (std::size_t record = samples; record < values.size(); ++record) {
    keyed.emplace_back(values[record], static_cast<std::uint32_t>(record));
  }
  geometry::sort_in_parts(keyed, threads, [](const KeyedRecord& one) { return one.key; });
  return keyed;
}

// Sorts records whose bounds overlap. Of those that are congruent, one alone has its exact value made.
class OverlapSorter {
 public:
  OverlapSorter(const PointSet& points, const StationaryPoints& stationary)
      : points_(points), stationary_(stationary) {}

  // By value, and then by number. rank is that of the least value, and then the next one.
  void sort(std::span<std::uint32_t> records, std::uint32_t& rank, std::vector<std::uint32_t>& rank_of) {
    find_congruent(records);
    std::vector<std::size_t> by_value(values_.size());
    std::iota(by_value.begin(), by_value.end(), std::size_t{0});
    std::ranges::sort(by_value, {}, [this](std::size_t k) -> const Rational& { return values_[k].value; });
    auto next = records.begin();
    for (std::size_t k = 0; k < by_value.size();) {
      const auto first = next;
      const Rational& value = values_[by_value[k]].value;
      for (; k < by_value.size() && values_[by_value[k]].value == value; ++k) {
        for (const Alike& one : values_[by_value[k]].records) {
          rank_of[one.record] = rank;
          *next++ = one.record;
        }
      }
      std::sort(first, next);
      ++rank;
    }
  }

 private:
  struct Alike {
    std::optional<geometry::CongruenceKey> key;
    std::uint32_t record;
  };
  struct Value {
    Rational value;
    std::span<const Alike> records;
  };

  void find_congruent(std::span<const std::uint32_t> records) {
    alike_.clear();
    values_.clear();
    for (const std::uint32_t record : records) alike_.push_back({key_of(record), record});
    std::ranges::sort(alike_, {}, &Alike::key);
    for (std::size_t first = 0, last = 0; first < alike_.size(); first = last) {
      const auto& key = alike_[first].key;
      for (last = first + 1; key && last < alike_.size() && alike_[last].key == key;) ++last;
      values_.push_back({exact_squared_radius(points_, stationary_.contact(alike_[first].record)),
                         std::span<const Alike>(alike_).subspan(first, last - first)});
    }
  }

  // Any three points of a circle determine it.
  [[nodiscard]] std::optional<geometry::CongruenceKey> key_of(std::uint32_t record) const {
    const std::size_t dimension = stationary_.index(record).hull_dimension;
    if (dimension != 1 && dimension != 2) return std::nullopt;
    std::array<const Point*, 3> points{};
    for (std::size_t k = 0; k <= dimension; ++k) points[k] = &points_.at_row(stationary_.contact(record)[k]);
    return geometry::congruence_key(std::span(points).first(dimension + 1));
  }

  const PointSet& points_;
  const StationaryPoints& stationary_;
  std::vector<Alike> alike_;
  std::vector<Value> values_;
};

}  // namespace

Rational SquaredDistances::exact(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  return exact_squared_radius(*points_, stationary_->contact(record));
}

namespace {

// Nothing where the bounds overlap. The difference is rounded.
std::optional<std::strong_ordering> order_by_bounds(const Approximation& one, const Approximation& other) {
  const double all_errors =
      one.error + other.error + kRoundingShare * (one.value + std::fabs(other.value)) + geometry::kBoundedUnderflow;
  if (one.value - other.value > all_errors) return std::strong_ordering::greater;
  if (other.value - one.value > all_errors) return std::strong_ordering::less;
  return std::nullopt;
}

}  // namespace

// The number is cut to a double.
std::strong_ordering SquaredDistances::compare(std::size_t record, const Rational& number) const {
  const geometry::IeeeDoubles ieee;
  if (const auto order = order_by_bounds(approximate_[record], {number.convert_to<double>(), 0})) return *order;
  return exact(record).compare(number) <=> 0;
}

std::strong_ordering SquaredDistances::compare(std::size_t record, const SquaredLevel& level) const {
  const geometry::IeeeDoubles ieee;
  if (level.values_ == this && level.number_ == 0) return rank(record) <=> rank(level.from_);
  if (const auto order = order_by_bounds(approximate_[record], level.approximate_)) return *order;
  return exact(record).compare(level.exact()) <=> 0;
}

SquaredLevel::SquaredLevel(const Rational& number) : number_(number) {
  const geometry::IeeeDoubles ieee;
  approximate_.value = number.convert_to<double>();
}

// The share is cut to a double, and there are three operations.
SquaredLevel::SquaredLevel(const SquaredDistances& values, std::size_t from, std::size_t to, const Rational& share)
    : values_(&values), from_(from), to_(to), number_(share) {
  const geometry::IeeeDoubles ieee;
  const auto &low = values.approximation(from), &high = values.approximation(to);
  approximate_ = {low.value + share.convert_to<double>() * (high.value - low.value),
                  low.error + high.error + kRoundingShare * (low.value + high.value)};
}

Rational SquaredLevel::exact() const {
  if (values_ == nullptr) return number_;
  const Rational low = values_->exact(from_);
  return number_ == 0 ? low : low + number_ * (values_->exact(to_) - low);
}

// |sqrt(x) - sqrt(v)| <= |x - v| / sqrt(v), and at most the root of |x - v|. The roots and sums are rounded.
Approximation SquaredDistances::length(std::size_t birth, std::size_t death) const {
  const geometry::IeeeDoubles ieee;
  const auto root = [this](std::size_t record) {
    const auto& [square, error] = approximate_[record];
    const double value = std::sqrt(square);
    return Approximation{value, error == 0 ? 0 : value > 0 ? error / value : std::sqrt(error)};
  };
  const Approximation from = root(birth), to = root(death);
  return {to.value - from.value, from.error + to.error + (from.value + to.value) * kRoundingShare};
}

SquaredDistances::SquaredDistances(const PointSet& points, const StationaryPoints& stationary, unsigned threads)
    : points_(&points), stationary_(&stationary), rank_(stationary.size()), ascending_(stationary.size()) {
  const geometry::IeeeDoubles ieee;
  approximate_.resize(stationary.size());
  constexpr std::size_t kPortion = geometry::portion_size(4096);
  geometry::in_portions(threads, stationary.size(), kPortion, {}, [&](std::size_t, std::size_t record) {
    geometry::prefetch_ahead(record, stationary.size(),
                             [&](std::size_t later) { points.prefetch(stationary.contact(later)); });
    const auto approximate = approximation_of(points, stationary.index(record), stationary.contact(record));
    approximate_[record] = approximate ? *approximate : rounded(exact(record));
  });
  // The samples come first, and their rank is 0.
  std::iota(ascending_.begin(), ascending_.end(), std::uint32_t{0});
  const std::size_t samples = stationary.critical_counts()[0];
  const auto others = std::span(ascending_).subspan(samples);
  const std::vector<KeyedRecord> keyed = sorted_by_low_end(approximate_, samples, threads);
  std::ranges::transform(keyed, others.begin(), &KeyedRecord::record);
  OverlapSorter overlap(points, stationary);
  std::uint32_t rank = 1;
  const auto range = [](const KeyedRecord& one) { return one.range(); };
  for_each_overlap(std::span<const KeyedRecord>(keyed), range, [&](std::size_t first, std::size_t last) {
    if (last == first + 1) {
      rank_[others[first]] = rank++;
    } else {
      overlap.sort(others.subspan(first, last - first), rank, rank_);
    }
  });
}

}  // namespace flowcert
