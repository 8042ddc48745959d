// Going through memory in another order than that in which it lies: what is needed later is asked for early, so that
// the waits for it overlap.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace flowcert::geometry {

// Prefetched so many steps ahead, it mostly is there in time.
inline constexpr std::size_t kPrefetchAhead = 32;

// Calls use(item) for one item after the other, and before that, for a block of them, each of the others. One of these
// prefetches what the next one reads, and the last one what `use` reads.
template <typename Item>
void in_blocks(std::span<const Item> items, const auto& use, const auto&... prefetch) {
  constexpr std::size_t kBlock = 64;
  for (; !items.empty(); items = items.subspan(std::min(kBlock, items.size()))) {
    const auto block = items.first(std::min(kBlock, items.size()));
    const auto for_each = [&](const auto& call) {
      for (const Item& item : block) call(item);
    };
    (for_each(prefetch), ...);
    for_each(use);
  }
}

}  // namespace flowcert::geometry
