// Blocks of items whose memory is asked for first: each item once, in order, and nothing is used before its block was
// asked for.
#include "geometry/prefetch.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "tests/cites.h"

namespace flowcert::geometry::prefetch_test {
namespace {

TEST(Prefetch, BlocksAreAskedForBeforeTheyAreUsed) {
  CITES("FC-NUM-01");
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 128U, 1000U}) {
    std::vector<std::size_t> items(count), first, second, used;
    std::iota(items.begin(), items.end(), std::size_t{5});
    in_blocks(
        std::span<const std::size_t>(items),
        [&](std::size_t item) {
          used.push_back(item);
          EXPECT_GE(first.size(), used.size());
          EXPECT_GE(second.size(), used.size());
        },
        [&](std::size_t item) { first.push_back(item); },
        [&](std::size_t item) {
          second.push_back(item);
          EXPECT_GE(first.size(), second.size());
        });
    EXPECT_EQ(first, items);
    EXPECT_EQ(second, items);
    EXPECT_EQ(used, items);
  }
}

}  // namespace
}  // namespace flowcert::geometry::prefetch_test
