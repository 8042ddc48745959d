// Numbers between two doubles, whose order the doubles decide but where they overlap.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace flowcert::geometry {

// A number that is not negative lies between these.
struct ValueRange {
  double low = 0, high = 0;
};

// A sum, a product, a quotient or a root of two doubles is rounded by at most 2^-53 of itself where it does not
// underflow. Of four in a row, and the product that adds this share, all errors are less than 2^-50.
inline constexpr double kRoundingShare = 0x1p-50;

// |value - number| <= error.
[[nodiscard]] inline ValueRange range_around(double value, double error) {
  return {std::max(0.0, (value - error) * (1 - kRoundingShare)), (value + error) * (1 + kRoundingShare)};
}

// The items ascend by the lower ends of their ranges. Calls use(first, last) for each run of them, places from `first`
// until before `last`, whose ranges overlap: the order of the runs is certain, that within a run is not.
template <typename Item, typename RangeOf, typename Use>
void for_each_overlap(std::span<const Item> items, const RangeOf& range_of, const Use& use) {
  for (std::size_t first = 0, last = 0; first < items.size(); first = last) {
    double top = range_of(items[first]).high;
    for (last = first + 1; last < items.size() && range_of(items[last]).low <= top; ++last) {
      top = std::max(top, range_of(items[last]).high);
    }
    use(first, last);
  }
}

}  // namespace flowcert::geometry
