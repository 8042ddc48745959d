#include "io/pair_lengths.h"

#include <algorithm>
#include <utility>

namespace flowcert::io {

namespace {

using geometry::RootDifference;

ValueRange range_of(const SquaredDistances::Approximation& length) {
  // The sums are rounded.
  const auto& [value, error] = length;
  return {std::max(0.0, (value - error) * (1 - 0x1p-51)), (value + error) * (1 + 0x1p-51)};
}

// The first record is a sample.
constexpr std::size_t kSample = 0;

}  // namespace

ValueOrder length_order(const SquaredDistances& values, std::vector<PairEnds> pairs) {
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> keys;
  for (const PairEnds& pair : pairs) {
    ranges.push_back(range_of(values.length(pair.birth, pair.death)));
    keys.push_back(std::uint64_t{values.rank(pair.birth)} << 32 | values.rank(pair.death));
  }
  return {std::move(ranges), std::move(keys), [&values, ends = std::move(pairs)](std::size_t i) {
            return RootDifference{values.exact(ends[i].death), values.exact(ends[i].birth)};
          }};
}

ValueOrder radius_order(const SquaredDistances& values, std::vector<std::size_t> records) {
  std::vector<ValueRange> ranges;
  std::vector<std::uint64_t> ranks;
  ranges.reserve(records.size());
  ranks.reserve(records.size());
  for (const std::size_t record : records) {
    ranges.push_back(range_of(values.length(kSample, record)));
    ranks.push_back(values.rank(record));
  }
  return {std::move(ranges), std::move(ranks),
          [&values, all = std::move(records)](std::size_t i) { return RootDifference{values.exact(all[i])}; }};
}

}  // namespace flowcert::io
