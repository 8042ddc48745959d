// The large family has the sizes that it says, is drawn where it is named alone, and leaves the others as they are.
#include "fuzz/inputs/large_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "fuzz/campaign/batch.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/inputs/stable_configurations.h"

namespace flowcert::fuzz::large_family_test {
namespace {

TEST(LargeFamily, HasTheSizesThatItSays) {
  std::size_t small = 0, of_many_bits = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Input input = draw(large_family(), seed, 50);
    EXPECT_GE(input.rows.size(), kFewestRowsOfLarge);
    EXPECT_LE(input.rows.size(), kMostRowsOfLarge);
    EXPECT_EQ(input, draw(large_family(), seed, 50));
    small += input.rows.size() < 3000 ? 1 : 0;
    of_many_bits += std::ranges::any_of(input.rows, [](const Row& row) { return row[0] > 0x1p40; }) ? 1 : 0;
  }
  EXPECT_GE(small, 10U);
  EXPECT_GE(of_many_bits, 3U);
}

TEST(LargeFamily, IsMadeOfDistinctPoints) {
  for (const auto& make : {lattice_piece, lattice_layers, integer_spheres}) {
    for (const std::size_t points : {1U, 2U, 50U, 1000U}) {
      const Input input = make(points, 3);
      EXPECT_EQ(input.rows.size(), points);
      EXPECT_EQ((std::set<Row>(input.rows.begin(), input.rows.end()).size()), points);
    }
  }
  EXPECT_EQ(rounded_capsule(1000, 3).rows.size(), 1000U);
  EXPECT_THROW((void)rounded_capsule(0, 3), std::invalid_argument);
}

TEST(LargeFamily, IsDrawnOnlyIfItIsNamed) {
  EXPECT_EQ(named_families().size(), families_and_stable_ones().size() + 1);
  CampaignPlan plan;
  EXPECT_EQ(plan_of(to_text(plan)), plan);
  const TrialMix usual(plan);
  for (std::uint64_t seed = 0; seed < 2000; ++seed) ASSERT_FALSE(is_large(usual.draw(seed).family));
  plan.families = families_of("large,box-corners");
  EXPECT_EQ(plan_of(to_text(plan)), plan);
  const TrialMix both(plan);
  std::set<std::string> drawn;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FreshTrial trial = both.draw(seed);
    drawn.insert(trial.family);
    EXPECT_EQ(trial.trial.input.rows.size() > kMostRowsOfTrial, is_large(trial.family));
  }
  EXPECT_EQ(drawn, (std::set<std::string>{"box-corners", "large"}));
}

// Notes which properties are tried.
class Watcher : public BatchObserver {
 public:
  std::set<std::string> tried;

  void tries(std::size_t /*number*/, const std::string& /*source*/, const std::string& property,
             const property::Trial& /*trial*/) override {
    tried.insert(property);
  }
  void has_done(std::size_t /*number*/, const std::string& /*source*/) override {}
  void found(const Counterexample& /*counterexample*/) override {}
  void discovered(const Discovery& /*discovery*/) override {}
  [[nodiscard]] bool is_stopped() override { return false; }
};

TEST(LargeFamily, IsHeldOnlyToPropertiesThatTakeIt) {
  CampaignPlan plan;
  plan.families = families_of("large");
  const auto holds = [](const property::Trial&) -> std::optional<property::Disagreement> { return std::nullopt; };
  Watcher watcher;
  const BatchResult result =
      run_batch(plan,
                {{.name = "few", .description = "", .check = holds},
                 {.name = "any", .description = "", .most_rows = property::kAnyRows, .check = holds}},
                {0, 5, {}, {}}, watcher);
  EXPECT_TRUE(result.is_complete);
  EXPECT_EQ(result.tally.cases, 5U);
  EXPECT_EQ(result.tally.by_property, (std::map<std::string, std::size_t>{{"any", 5}}));
  EXPECT_EQ(watcher.tried, std::set<std::string>{"any"});  // and no signature
}

}  // namespace
}  // namespace flowcert::fuzz::large_family_test
