#include "io/pair_lengths.h"

#include <algorithm>
#include <utility>

namespace flowcert::io {

namespace {

// What is taken away and added covers the rounding of the sums.
ValueRange length_range(const SquaredDistances& values, const PairEnds& pair) {
  const auto &birth = values.approximation(pair.birth), &death = values.approximation(pair.death);
  const double length = death.value - birth.value;
  const double error = death.error + birth.error + (death.value + birth.value) * 0x1p-50;
  return {std::max(0.0, length - error), length + error};
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
            return Rational(values.exact(ends[i].death) - values.exact(ends[i].birth));
          }};
}

ValueOrder radius_order(const SquaredDistances& values, std::vector<std::size_t> records) {
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> ranks;
  ranges.reserve(records.size());
  ranks.reserve(records.size());
  for (const std::size_t record : records) {
    const auto& [value, error] = values.approximation(record);
    // The sums are rounded.
    ranges.push_back({std::max(0.0, value - error - value * 0x1p-51), value + error + value * 0x1p-51});
    ranks.push_back(values.rank(record));
  }
  return {std::move(ranges), std::move(ranks),
          [&values, all = std::move(records)](std::size_t i) { return values.exact(all[i]); }};
}

}  // namespace flowcert::io
