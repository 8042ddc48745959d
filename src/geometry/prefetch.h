// Going through memory in another order than that in which it lies: what is needed later is asked for early, so that
// the waits for it overlap.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace flowcert::geometry {

// To be called at step k of a loop of `count` steps: calls prefetch(later) for the step whose memory should be on its
// way by now, unless the loop ends before it.
[[gnu::always_inline]] inline void prefetch_ahead(std::size_t k, std::size_t count, const auto& prefetch) {
  constexpr std::size_t kAhead = 32;
  if (k + kAhead < count) prefetch(k + kAhead);
}

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
