// How failing cases are made small, with judges whose smallest failing case is known.
#include "fuzz/campaign/shrinking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/large_configurations.h"

namespace flowcert::fuzz::shrinking_test {
namespace {

using property::Disagreement;
using property::StartChoice;
using property::Trial;

constexpr std::size_t kBudget = 5000;

Disagreement of_kind(const std::string& kind) { return {kind, "", "", "", "", "", ""}; }

Input many_rows() {
  Input input;
  for (int k = 0; k < 12; ++k) input.rows.push_back({1000.0 + k, 17.25 * k, -3.0 * k});
  return input;
}

TEST(Shrinking, LeavesOutAllRowsThatAreNotNeeded) {
  const auto is_needed = [](const Row& row) { return row[2] == -9.0 || row[2] == -24.0; };
  std::size_t asked = 0;
  const Judge judge = [&](const Trial& trial) -> std::optional<Disagreement> {
    ++asked;
    const auto needed = std::count_if(trial.input.rows.begin(), trial.input.rows.end(), is_needed);
    return needed == 2 ? std::optional(of_kind("a")) : std::nullopt;
  };
  const Shrunk small = shrunk({many_rows(), StartChoice{}}, of_kind("a"), judge, kBudget);
  EXPECT_EQ(small.trial.input.rows.size(), 2U);
  EXPECT_EQ(asked, small.judged);
  EXPECT_FALSE(small.is_budget_up);
  EXPECT_TRUE(judge(small.trial).has_value());
}

TEST(Shrinking, FindsTheFewRowsOfThousandsThatAreNeeded) {
  const Input large = lattice_piece(5000, 3);
  for (const auto& numbers : {std::array{100, 200}, std::array{2499, 2500}, std::array{0, 4999}}) {
    const Judge judge = [&](const Trial& trial) -> std::optional<Disagreement> {
      const auto is_there = [&](int k) {
        const auto& rows = trial.input.rows;
        return std::find(rows.begin(), rows.end(), large.rows[static_cast<std::size_t>(k)]) != rows.end();
      };
      return is_there(numbers[0]) && is_there(numbers[1]) ? std::optional(of_kind("a")) : std::nullopt;
    };
    const Shrunk small = shrunk({large, StartChoice{}}, of_kind("a"), judge, kBudget);
    EXPECT_EQ(small.trial.input.rows.size(), 2U);
    EXPECT_LE(small.judged, 500U);
  }
}

TEST(Shrinking, MakesCoordinatesSmallIntegers) {
  // Any four points with different x fail. The smallest such x are 0, 1, 2 and one more, -1 or 3.
  const Judge judge = [](const Trial& trial) -> std::optional<Disagreement> {
    std::vector<double> x;
    x.reserve(trial.input.rows.size());
    for (const Row& row : trial.input.rows) x.push_back(row[0]);
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());
    return x.size() >= 4 ? std::optional(of_kind("a")) : std::nullopt;
  };
  const Shrunk small = shrunk({many_rows(), StartChoice{}}, of_kind("a"), judge, kBudget);
  ASSERT_EQ(small.trial.input.rows.size(), 4U);
  for (const Row& row : small.trial.input.rows) {
    EXPECT_LE(std::fabs(row[0]), 4);
    EXPECT_EQ(row[1], 0);
    EXPECT_EQ(row[2], 0);
  }
}

TEST(Shrinking, KeepsTheKind) {
  // Fewer than three rows fail as well, but with another kind.
  const Judge judge = [](const Trial& trial) -> std::optional<Disagreement> {
    return of_kind(trial.input.rows.size() >= 3 ? "many" : "few");
  };
  const Shrunk small = shrunk({many_rows(), StartChoice{}}, of_kind("many"), judge, kBudget);
  EXPECT_EQ(small.trial.input.rows.size(), 3U);
  EXPECT_EQ(small.disagreement.kind, "many");
}

TEST(Shrinking, StopsWhenTheBudgetIsSpent) {
  std::size_t asked = 0;
  const Judge judge = [&](const Trial&) -> std::optional<Disagreement> {
    ++asked;
    return std::nullopt;
  };
  const Trial trial{many_rows(), StartChoice{property::StartKind::kBox, {1, 2, 3}}};
  const Shrunk small = shrunk(trial, of_kind("a"), judge, 20);
  EXPECT_EQ(asked, 20U);
  EXPECT_TRUE(small.is_budget_up);
  EXPECT_EQ(small.trial.input, trial.input);
}

TEST(Shrinking, FixesTheStart) {
  const Judge judge = [](const Trial&) { return std::optional(of_kind("a")); };
  const Trial trial{many_rows(), StartChoice{property::StartKind::kBox, {1, 2, 3}}};
  const Shrunk small = shrunk(trial, of_kind("a"), judge, kBudget);
  EXPECT_TRUE(small.trial.input.rows.empty());
  const Judge wants_a_row = [](const Trial& candidate) {
    return candidate.input.rows.empty() ? std::nullopt : std::optional(of_kind("a"));
  };
  const Shrunk one = shrunk(trial, of_kind("a"), wants_a_row, kBudget);
  EXPECT_EQ(one.trial.input.rows.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<oracle::Point>(one.trial.start));
}

TEST(Shrinking, IsAFunctionOfItsArguments) {
  const Judge judge = [](const Trial& trial) -> std::optional<Disagreement> {
    double sum = 0;
    for (const Row& row : trial.input.rows) sum += row[0];
    return sum > 2500 ? std::optional(of_kind("a")) : std::nullopt;
  };
  const Trial trial{many_rows(), StartChoice{}};
  const Shrunk once = shrunk(trial, of_kind("a"), judge, kBudget);
  const Shrunk again = shrunk(trial, of_kind("a"), judge, kBudget);
  EXPECT_EQ(once.trial.input, again.trial.input);
  EXPECT_EQ(once.judged, again.judged);
  EXPECT_LE(once.trial.input.rows.size(), 3U);
}

}  // namespace
}  // namespace flowcert::fuzz::shrinking_test
