// The matching of claimed things with true ones: against all matchings of small graphs, and on chains that are long.
#include "certify/matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <numeric>
#include <random>

#include "tests/cites.h"

namespace flowcert::matching_test {
namespace {

using certify::Candidates;
using certify::IsRightOf;
using certify::Matching;
using certify::maximum_matching;

// A claimed thing is right of the true ones in its list.
struct Graph {
  explicit Graph(std::vector<std::vector<std::size_t>> lists) {
    for (auto& list : lists) all.push_back({std::move(list), 0});
    for (Candidates& one : all) candidates.push_back(&one);
  }

  std::deque<Candidates> all;
  std::vector<Candidates*> candidates;
};

bool is_right_of_all(std::size_t, std::size_t) { return true; }

std::size_t size_of(const Matching& matching) {
  for (std::size_t k = 0; k < matching.of_claimed.size(); ++k) {
    if (matching.of_claimed[k]) {
      EXPECT_EQ(matching.of_truth.at(*matching.of_claimed[k]), k);
    }
  }
  const auto has_partner = [](const auto& partner) { return partner.has_value(); };
  const auto size = std::ranges::count_if(matching.of_claimed, has_partner);
  EXPECT_EQ(size, std::ranges::count_if(matching.of_truth, has_partner));
  return static_cast<std::size_t>(size);
}

// The most pairs, and the most owed true things in a matching of that many pairs. Owed are those below `owed`.
using Most = std::pair<std::size_t, std::size_t>;
Most most(const Graph& graph, std::size_t owed, std::size_t k, std::vector<bool>& is_taken) {
  if (k == graph.all.size()) return {0, 0};
  Most best = most(graph, owed, k + 1, is_taken);
  for (const std::size_t place : graph.all[k].places) {
    if (is_taken[place]) continue;
    is_taken[place] = true;
    const Most rest = most(graph, owed, k + 1, is_taken);
    best = std::max(best, {rest.first + 1, rest.second + (place < owed ? 1 : 0)});
    is_taken[place] = false;
  }
  return best;
}

TEST(MatchingTest, HasAsManyPairsAsThereCanBe) {
  CITES("FC-CLAIM-24");
  std::mt19937 random(1);
  const auto below = [&random](std::size_t n) { return std::size_t{random()} % n; };
  for (int round = 0; round < 3000; ++round) {
    const std::size_t claimed = below(6), truth = 1 + below(5), owed = below(truth + 1);
    std::vector<std::vector<std::size_t>> lists(claimed);
    for (auto& list : lists) {
      for (std::size_t place = 0; place < truth; ++place) {
        if (below(5) < 2) list.push_back(place);
      }
    }
    Graph graph(lists);
    Matching matching = maximum_matching(graph.candidates, truth, is_right_of_all);
    const auto is_owed = [owed](std::size_t place) { return place < owed; };
    certify::prefer_owed(matching, graph.candidates, is_right_of_all, is_owed);
    std::vector<bool> is_taken(truth, false);
    const auto [pairs, of_owed] = most(graph, owed, 0, is_taken);
    ASSERT_EQ(size_of(matching), pairs);
    if (of_owed < owed) continue;  // such a claim is wrong, and only that is certain
    for (std::size_t place = 0; place < owed; ++place) ASSERT_TRUE(matching.of_truth[place].has_value());
  }
}

TEST(MatchingTest, WhatIsSharedIsAskedOnceInOrder) {
  CITES("FC-CLAIM-24");
  constexpr std::size_t kCount = 100'000;
  Candidates all{std::vector<std::size_t>(kCount), 0};
  std::iota(all.places.begin(), all.places.end(), std::size_t{0});
  std::size_t questions = 0;
  const IsRightOf is_same = [&questions](std::size_t k, std::size_t place) {
    ++questions;
    return k == place;
  };
  EXPECT_EQ(size_of(maximum_matching(std::vector<Candidates*>(kCount, &all), kCount, is_same)), kCount);
  EXPECT_EQ(questions, kCount);
}

TEST(MatchingTest, ChainsOfExchangesAreAsLongAsTheClaim) {
  CITES("FC-CLAIM-24");
  constexpr std::size_t kCount = 300'000;
  std::vector<std::vector<std::size_t>> lists;
  for (std::size_t k = 0; k < kCount; ++k) lists.push_back({k, k + 1});
  lists.push_back({0});
  Graph graph(lists);
  const Matching matching = maximum_matching(graph.candidates, kCount + 1, is_right_of_all);
  EXPECT_EQ(size_of(matching), kCount + 1);
  EXPECT_EQ(matching.of_claimed.back(), 0U);
}

// Many claims of one thing: what leads to nothing free is not tried again for each of them.
TEST(MatchingTest, WhatWasTriedInVainIsNotTriedAgain) {
  CITES("FC-CLAIM-24");
  constexpr std::size_t kTruth = 300, kClaimed = 3000;
  Candidates all{std::vector<std::size_t>(kTruth), 0};
  std::iota(all.places.begin(), all.places.end(), std::size_t{0});
  std::size_t questions = 0;
  const IsRightOf is_right = [&questions](std::size_t, std::size_t) {
    ++questions;
    return true;
  };
  EXPECT_EQ(size_of(maximum_matching(std::vector<Candidates*>(kClaimed, &all), kTruth, is_right)), kTruth);
  EXPECT_LT(questions, 3 * kTruth);
  Graph none({{}, {0}});
  none.candidates[0] = nullptr;
  EXPECT_EQ(size_of(maximum_matching(none.candidates, 1, is_right_of_all)), 1U);
}

}  // namespace
}  // namespace flowcert::matching_test
