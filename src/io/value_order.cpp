#include "io/value_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace flowcert::io {

ValueOrder::ValueOrder(std::vector<ValueRange> ranges, std::vector<std::uint64_t> keys, Exact exact)
    : ranges_(std::move(ranges)), keys_(std::move(keys)), exact_(std::move(exact)), order_(ranges_.size()) {
  std::iota(order_.rbegin(), order_.rend(), std::size_t{0});
  std::ranges::stable_sort(order_, {}, [this](std::size_t i) { return ranges_[i].low; });
  for (std::size_t first = 0, last = 0; first < order_.size(); first = last) {
    double top = ranges_[order_[first]].high;
    for (last = first + 1; last < order_.size() && ranges_[order_[last]].low <= top; ++last) {
      top = std::max(top, ranges_[order_[last]].high);
    }
    if (last > first + 1) sort_exactly(first, last);
  }
}

// Numbers of different keys may be equal, too.
void ValueOrder::sort_exactly(std::size_t first, std::size_t last) {
  std::unordered_map<std::uint64_t, Rational> made;
  std::vector<std::pair<const Rational*, std::size_t>> run;
  for (std::size_t place = first; place < last; ++place) {
    const std::size_t i = order_[place];
    const auto [known, is_new] = made.try_emplace(keys_[i]);
    if (is_new) known->second = exact_(i);
    run.emplace_back(&known->second, i);
  }
  std::ranges::sort(run, [](const auto& a, const auto& b) {
    if (a.first != b.first && *a.first != *b.first) return *a.first < *b.first;
    return a.second > b.second;
  });
  for (std::size_t k = 0; k < run.size(); ++k) order_[first + k] = run[k].second;
}

std::size_t ValueOrder::count_below(const Rational& bound) const {
  const auto end = std::ranges::partition_point(order_, [&](std::size_t i) { return exact_(i) < bound; });
  return static_cast<std::size_t>(end - order_.begin());
}

std::size_t ValueOrder::count_up_to(const Rational& bound) const {
  const auto end = std::ranges::partition_point(order_, [&](std::size_t i) { return exact_(i) <= bound; });
  return static_cast<std::size_t>(end - order_.begin());
}

// The quotients are rounded. A unit in the last place covers that, where they do not underflow.
ValueRange ValueOrder::ratio_behind(std::size_t place) const {
  const ValueRange &less = ranges_[order_[place]], &greater = ranges_[order_[place + 1]];
  const double low = greater.low / less.high, high = greater.high / less.low;
  return {greater.low > 0 && std::isfinite(low) ? low * (1 - 0x1p-51) : 0,
          less.low > 0 && high >= 1 ? high * (1 + 0x1p-51) : HUGE_VAL};
}

std::optional<std::size_t> ValueOrder::widest_gap(std::size_t from, std::size_t to) const {
  double least = 1;
  for (std::size_t place = from; place < to; ++place) least = std::max(least, ratio_behind(place).low);
  std::optional<std::size_t> widest;
  Rational ratio = 1;
  for (std::size_t place = from; place < to; ++place) {
    if (ratio_behind(place).high < least || keys_[order_[place]] == keys_[order_[place + 1]]) continue;
    const Rational candidate = exact(place + 1) / exact(place);
    if (candidate <= ratio) continue;
    ratio = candidate;
    widest = place;
  }
  return widest;
}

}  // namespace flowcert::io
