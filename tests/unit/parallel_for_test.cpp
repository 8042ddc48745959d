// The one parallel loop and the portions that its threads take: each number once, and exceptions come out.
#include "geometry/parallel_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/portions.h"
#include "io/ordered_text.h"
#include "tests/cites.h"

namespace flowcert::geometry::parallel_for_test {
namespace {

TEST(ParallelFor, CallsEachPartOnce) {
  CITES("FC-NUM-01");
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, threads, [&](std::size_t k) { ++calls[k]; });
      EXPECT_TRUE(std::ranges::all_of(calls, [](const auto& times) { return times == 1; })) << threads << ' ' << count;
    }
  }
}

TEST(ParallelFor, OneThreadIsTheCallersAndGoesInOrder) {
  CITES("FC-NUM-01");
  std::vector<std::size_t> order;
  const auto here = std::this_thread::get_id();
  parallel_for(50, 1, [&](std::size_t k) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    order.push_back(k);
  });
  EXPECT_EQ(order.size(), 50U);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

TEST(ParallelFor, HandsOutAnException) {
  CITES("FC-NUM-01");
  for (const unsigned threads : {1U, 2U, 8U}) {
    const auto fail = [](std::size_t k) {
      if (k == 17) throw std::runtime_error("part 17");
    };
    EXPECT_THROW(parallel_for(100, threads, fail), std::runtime_error);
  }
}

TEST(Portions, HandOutEachNumberOnceAndTellInOrder) {
  CITES("FC-NUM-01");
  static constexpr std::size_t kCount = 10007;
  for (const unsigned threads : {1U, 3U}) {
    std::vector<std::size_t> told;
    const Progress tell = [&told](std::size_t begun, std::size_t) { told.push_back(begun); };
    Portions portions(kCount, 100, tell);
    std::vector<std::atomic<int>> calls(kCount);
    parallel_for(threads, threads, [&](std::size_t) {
      for (auto [at, end] = portions.next(); at != end; std::tie(at, end) = portions.next()) {
        for (; at != end; ++at) ++calls[at];
      }
    });
    EXPECT_TRUE(std::ranges::all_of(calls, [](const auto& times) { return times == 1; }));
    EXPECT_EQ(told.size(), 101U);
    EXPECT_TRUE(std::ranges::is_sorted(told));
  }
}

TEST(Portions, AreOverAfterAProgressThatThrows) {
  CITES("FC-NUM-01");
  const Progress tell = [](std::size_t begun, std::size_t) {
    if (begun == 20) throw std::runtime_error("stop");
  };
  Portions portions(1000, 10, tell);
  EXPECT_EQ(portions.next(), (std::pair<std::size_t, std::size_t>(0, 10)));
  EXPECT_EQ(portions.next(), (std::pair<std::size_t, std::size_t>(10, 20)));
  EXPECT_THROW((void)portions.next(), std::runtime_error);
  const auto [first, last] = portions.next();
  EXPECT_EQ(first, last);
}

TEST(OrderedText, IsTheSameForAnyNumberOfThreads) {
  CITES("FC-OUT-02");
  static constexpr std::size_t kCount = 20011;
  const auto text_with = [](unsigned threads) {
    std::string all;
    std::size_t last = 0;
    io::write_in_order(
        kCount, io::kShortRecords, threads,
        [](std::size_t first, std::size_t end, std::string& text) {
          for (std::size_t k = first; k < end; ++k) text += std::to_string(k) + '\n';
        },
        [&](const std::string& text, std::size_t done) {
          EXPECT_GT(done, last);
          last = done;
          all += text;
          return true;
        });
    EXPECT_EQ(last, kCount);
    return all;
  };
  std::string expected;
  for (std::size_t k = 0; k < kCount; ++k) expected += std::to_string(k) + '\n';
  for (const unsigned threads : {1U, 2U, 3U, 8U}) EXPECT_EQ(text_with(threads), expected);
}

TEST(OrderedText, StopsWhereWritingFails) {
  CITES("FC-OUT-02");
  std::size_t written = 0;
  io::write_in_order(
      5000, io::kShortRecords, 2, [](std::size_t, std::size_t, std::string& text) { text += 'x'; },
      [&written](const std::string&, std::size_t) { return ++written < 3; });
  EXPECT_EQ(written, 3U);
}

}  // namespace
}  // namespace flowcert::geometry::parallel_for_test
