#include "morse/value_order.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>

#include "flowcert/sphere.h"
#include "geometry/prefetch.h"

namespace flowcert::morse {

ValueOrder::ValueOrder(std::vector<ValueRange> ranges, std::vector<std::uint64_t> keys, Exact exact)
    : ranges_(std::move(ranges)), keys_(std::move(keys)), exact_(std::move(exact)), order_(ranges_.size()) {
  std::iota(order_.rbegin(), order_.rend(), std::size_t{0});
  std::ranges::stable_sort(order_, {}, [this](std::size_t i) { return ranges_[i].low; });
  const auto range_of = [this](std::size_t i) { return ranges_[i]; };
  for_each_overlap(std::span<const std::size_t>(order_), range_of, [this](std::size_t first, std::size_t last) {
    if (last > first + 1) sort_exactly(std::span(order_).subspan(first, last - first));
  });
}

// Numbers of different keys may be equal, too.
void ValueOrder::sort_exactly(std::span<std::size_t> run) {
  std::unordered_map<std::uint64_t, RootDifference> made;
  for (const std::size_t i : run) {
    if (const auto [known, is_new] = made.try_emplace(keys_[i]); is_new) known->second = exact_(i);
  }
  std::ranges::sort(run, [&](std::size_t i, std::size_t j) {
    const auto order = keys_[i] == keys_[j] ? std::strong_ordering::equal : made.at(keys_[i]) <=> made.at(keys_[j]);
    return order == 0 ? i > j : order < 0;
  });
}

std::size_t ValueOrder::count_below(const Rational& squared_bound) const {
  const RootDifference bound{squared_bound};
  const auto end = std::ranges::partition_point(order_, [&](std::size_t i) { return exact_(i) < bound; });
  return static_cast<std::size_t>(end - order_.begin());
}

std::size_t ValueOrder::count_up_to(const Rational& squared_bound) const {
  const RootDifference bound{squared_bound};
  const auto end = std::ranges::partition_point(order_, [&](std::size_t i) { return exact_(i) <= bound; });
  return static_cast<std::size_t>(end - order_.begin());
}

// The quotients are rounded, and so are numbers from above.
ValueRange ValueOrder::ratio_behind(std::size_t place) const {
  const ValueRange &less = ranges_[order_[place]], &greater = ranges_[order_[place + 1]];
  const double low = greater.low / less.high, high = greater.high / less.low;
  return {greater.low > 0 && std::isfinite(low) ? low * (1 - kRoundingShare) : 0,
          less.low > 0 && high >= 1 ? high * (1 + kRoundingShare) : HUGE_VAL};
}

std::optional<std::size_t> ValueOrder::widest_gap(std::size_t from, std::size_t to) const {
  double least = 1;
  for (std::size_t place = from; place < to; ++place) least = std::max(least, ratio_behind(place).low);
  std::optional<std::size_t> widest;
  Rational ratio = 1;
  for (std::size_t place = from; place < to; ++place) {
    if (ratio_behind(place).high < least || keys_[order_[place]] == keys_[order_[place + 1]]) continue;
    const Rational candidate = square_from_above(place + 1) / square_from_above(place);
    if (candidate <= ratio) continue;
    ratio = candidate;
    widest = place;
  }
  return widest;
}

ValueOrder ValueOrder::from_above() const {
  std::vector<ValueRange> ranges = ranges_;
  for (ValueRange& range : ranges) range.high *= 1 + kRoundingShare;
  return {std::move(ranges), keys_,
          [exact = exact_](std::size_t i) { return RootDifference{geometry::square_from_above(exact(i))}; }};
}

ValueOrder ValueOrder::from_above_once(const Rational& width) const {
  const ValueOrder all = from_above();
  const double near_width = nearest_or_infinity(width);
  const auto is_wide = [&](std::size_t first, std::size_t second) {
    const ValueRange &less = all.ranges_[first], &greater = all.ranges_[second];
    const double slack = kRoundingShare * (greater.high + near_width);
    if (greater.low - less.high > near_width + slack) return true;
    if (greater.high - less.low < near_width - slack) return false;
    const RootDifference difference{all.exact_(second).square, all.exact_(first).square};
    return difference > RootDifference{width * width};
  };
  std::vector<std::size_t> chosen;
  for (const std::size_t i : all.order_) {
    if (chosen.empty() || is_wide(chosen.back(), i)) chosen.push_back(i);
  }
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> keys;
  for (const std::size_t i : chosen) {
    ranges.push_back(all.ranges_[i]);
    keys.push_back(keys_[i]);
  }
  return {std::move(ranges), std::move(keys),
          [exact = all.exact_, chosen = std::move(chosen)](std::size_t k) { return exact(chosen[k]); }};
}

std::size_t part_of(std::size_t count, const Rational& share) {
  const Rational part = share * count;
  return static_cast<std::size_t>(boost::multiprecision::mpz_int(numerator(part) / denominator(part)));
}

// ---- Lengths and radii ----

namespace {

// The first record is a sample.
constexpr std::size_t kSample = 0;

ValueRange length_range(const SquaredDistances& values, const PairEnds& pair) {
  const auto [value, error] = values.length(pair.birth, pair.death);
  return range_around(value, error);
}

}  // namespace

ValueOrder length_order(const SquaredDistances& values, std::vector<PairEnds> pairs) {
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> keys;
  for (const PairEnds& pair : pairs) {
    ranges.push_back(length_range(values, pair));
    keys.push_back(std::uint64_t{values.rank(pair.birth)} << 32 | values.rank(pair.death));
  }
  return {std::move(ranges), std::move(keys), [&values, ends = std::move(pairs)](std::size_t i) {
            return RootDifference{values.exact(ends[i].death), values.exact(ends[i].birth)};
          }};
}

// A pair whose length is certainly less than `count` others is none of the longest. Few pairs are kept on the way.
std::vector<PairEnds> perhaps_longest(const SquaredDistances& values, std::vector<PairEnds> pairs, std::size_t count) {
  if (count == 0 || pairs.size() <= count) return pairs;
  std::priority_queue<double, std::vector<double>, std::greater<>> lows;  // the `count` greatest
  std::vector<PairEnds> kept;
  const auto is_too_short = [&](double high) { return lows.size() == count && high < lows.top(); };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    geometry::prefetch_ahead(k, pairs.size(), [&](std::size_t later) { values.prefetch(pairs[later].death); });
    const auto [low, high] = length_range(values, pairs[k]);
    if (is_too_short(high)) continue;
    kept.push_back(pairs[k]);
    lows.push(low);
    if (lows.size() > count) lows.pop();
  }
  std::erase_if(kept, [&](const PairEnds& pair) { return is_too_short(length_range(values, pair).high); });
  return kept;
}

ValueOrder radius_order(const SquaredDistances& values, std::vector<std::size_t> records) {
  std::vector<PairEnds> pairs;
  for (const std::size_t record : records) pairs.push_back({kSample, record});
  return length_order(values, std::move(pairs));
}

}  // namespace flowcert::morse
