// Campaigns are a function of their plan, however they are cut, interrupted and put together, and nothing
// that was reported is lost. The properties here fail on what they are told to.
#include "fuzz/campaign/campaign.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fuzz/campaign/batch.h"
#include "tests/unit/campaign_fixture.h"

namespace flowcert::fuzz::campaign_test {
namespace {

TEST_F(CampaignTest, IsTheSameWithAnyNumberOfJobs) {
  const std::string one = account_of_run(small_plan(), 410, 1, folder_ / "one");
  EXPECT_EQ(account_of_run(small_plan(), 410, 3, folder_ / "three"), one);
  // The counterexamples kept are those with the least numbers, whichever came first.
  EXPECT_EQ(names_in(folder_ / "three"), names_in(folder_ / "one"));
  EXPECT_EQ(names_in(folder_ / "one").size(), kMostCounterexamplesOfKind);
  EXPECT_NE(one.find("rows too-many"), std::string::npos);
  EXPECT_NE(one.find("mutant"), std::string::npos);
  CampaignPlan other = small_plan();
  other.seed = 8;
  EXPECT_NE(account_of_run(other, 410, 1, folder_ / "other"), one);
}

TEST_F(CampaignTest, ShardsTogetherAreTheWhole) {
  const std::string whole = account_of_run(small_plan(), 410, 1, folder_ / "whole");
  Campaign merged(small_plan(), 410, folder_ / "merged");
  std::size_t cases = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    CampaignPlan plan = small_plan();
    plan.shard = {k, 3};
    Campaign part(plan, 410, folder_ / "part");
    work(part, {rows_property(8)}, 1);
    EXPECT_EQ(part.tally().cases, part.expected_cases());
    cases += part.tally().cases;
    merged.absorb(part);
    merged.absorb(part);
  }
  EXPECT_EQ(cases, 410U);
  EXPECT_EQ(account_of(merged), whole);
  CampaignPlan other = small_plan();
  other.seed = 8;
  EXPECT_THROW(merged.absorb(Campaign(other, 410, folder_ / "part")), std::invalid_argument);
}

TEST_F(CampaignTest, AFailingCaseCanBeDoneAgainByItsNumber) {
  CampaignPlan plan = small_plan();
  plan.shrinks_all = true;
  Campaign all(plan, 120, folder_ / "all");
  work(all, {rows_property(8)}, 2);
  const std::set<std::size_t>& failing = all.tally().failures.at("rows too-many");
  EXPECT_EQ(all.counterexamples().size(), failing.size());
  EXPECT_EQ(all.failing_cases(), failing.size());
  ASSERT_GT(failing.size(), 20U);
  plan.shrinks_all = false;
  Campaign some(plan, 120, folder_ / "some");
  work(some, {rows_property(8)}, 2);
  EXPECT_EQ(some.tally().failures, all.tally().failures);
  EXPECT_EQ(some.counterexamples().size(), 3U);
  for (const std::size_t number : failing) {
    OneCase one(some, number);
    work(one, {rows_property(8)}, 1);
    EXPECT_TRUE(one.is_done());
    const std::string expected = file_text(all.counterexamples().at({number, "rows too-many"}));
    ASSERT_EQ(one.counterexamples().size(), 1U) << number;
    EXPECT_EQ(file_text(one.counterexamples().at("rows too-many")), expected);
    EXPECT_EQ(file_text(some.counterexamples().at({number, "rows too-many"})), expected);
    EXPECT_TRUE(fs::exists(some.file_of(one.counterexamples().at("rows too-many"))));
  }
  EXPECT_EQ(some.tally().cases, 120U);
  for (const std::size_t number : {std::size_t{120}, ~std::size_t{0}}) {
    EXPECT_THROW(OneCase(some, number), std::invalid_argument);
  }
}

// The new judgement of a case replaces the old one.
TEST_F(CampaignTest, ACaseThatIsDoneAgainIsJudgedAnew) {
  const fs::path folder = folder_ / "campaign";
  std::size_t number = 0;
  std::set<std::string> files;
  {
    Campaign campaign = Campaign::begun(small_plan(), 400, folder);
    work(campaign, {rows_property(8)}, 1);
    number = *campaign.tally().failures.at("rows too-many").rbegin();
    OneCase mended(campaign, number);
    work(mended, {rows_property(100)}, 1);
    EXPECT_TRUE(mended.is_done());
    EXPECT_TRUE(mended.counterexamples().empty());
    OneCase worse(campaign, number);
    work(worse, {rows_property(3)}, 1);
    ASSERT_EQ(worse.counterexamples().size(), 1U);
    EXPECT_EQ(worse.counterexamples().begin()->second.trial.input.rows.size(), 3U);
    files = names_in(folder / "findings");
    EXPECT_EQ(files.size(), kMostCounterexamplesOfKind + 1);
  }
  // The case's file stays when the campaign goes on.
  Campaign campaign = Campaign::resumed(folder, 800);
  work(campaign, {rows_property(8)}, 1);
  EXPECT_EQ(names_in(folder / "findings"), files);
  EXPECT_EQ(campaign.counterexamples().at({number, "rows too-many"}).trial.input.rows.size(), 3U);
}

// An open batch finds the failure of such a case by itself. It leaves out only a case that ended a process in it.
TEST_F(CampaignTest, AnOpenBatchIsNotToldOfACaseThatWasAskedFor) {
  const std::string whole = account_of_run(small_plan(), 40, 1, folder_ / "whole");
  Campaign campaign(small_plan(), 40, folder_ / "findings");
  Property crashing = rows_property(100);
  crashing.check = [](const Trial&) -> std::optional<Disagreement> {
    crash();
    return std::nullopt;
  };
  for (const std::size_t number : {std::size_t{3}, std::size_t{18}}) {
    OneCase one(campaign, number);
    work(one, {number == 3 ? crashing : rows_property(8)}, 1);
    ASSERT_EQ(one.counterexamples().size(), 1U);
    EXPECT_TRUE(fs::exists(campaign.file_of(one.counterexamples().begin()->second)));
    EXPECT_TRUE(campaign.counterexamples().empty());
  }
  work(campaign, {rows_property(8)}, 1);
  EXPECT_EQ(account_of(campaign), whole);
}

TEST_F(CampaignTest, ACaseThatIsKilledOrStoppedIsNotDone) {
  Campaign campaign(small_plan(), 40, folder_ / "findings");
  Property slow = rows_property(100);
  slow.check = [](const Trial&) -> std::optional<Disagreement> {
    ::sleep(60);
    return std::nullopt;
  };
  const auto start = std::chrono::steady_clock::now();
  OneCase stopped(campaign, 3);
  work(stopped, {slow}, 1, [&] { return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(200); });
  EXPECT_FALSE(stopped.is_done());
  Property killed = rows_property(100);
  killed.check = [](const Trial&) -> std::optional<Disagreement> {
    ::raise(SIGKILL);
    return std::nullopt;
  };
  OneCase twice(campaign, 3);
  work(twice, {killed}, 1);
  EXPECT_TRUE(twice.is_done());
  ASSERT_EQ(twice.counterexamples().size(), 1U);
  EXPECT_EQ(twice.counterexamples().begin()->second.disagreement.kind, "crash");
}

TEST_F(CampaignTest, ReadingLeavesAFolderAsItIs) {
  const fs::path folder = folder_ / "campaign";
  Campaign campaign = Campaign::begun(small_plan(), 130, folder);  // this object goes on using the folder
  work(campaign, {rows_property(8)}, 1);
  std::ofstream(folder / "batches.jsonl", std::ios::app) << R"({"batch":3,"comp)";
  const auto size = fs::file_size(folder / "batches.jsonl");
  EXPECT_EQ(account_of(Campaign::read(folder)).find("130\n"), 0U);
  EXPECT_EQ(Campaign::read(folder).counterexamples().size(), campaign.counterexamples().size());
  EXPECT_EQ(fs::file_size(folder / "batches.jsonl"), size);
  EXPECT_THROW(Campaign::read(folder_ / "none"), UnusableFolder);
}

TEST_F(CampaignTest, GoesOnWhereItWasStopped) {
  const std::string whole = account_of_run(small_plan(), 410, 1, folder_ / "whole");
  const fs::path folder = folder_ / "campaign";
  {
    Campaign campaign = Campaign::begun(small_plan(), 410, folder);
    work(campaign, {rows_property(8)}, 1, [&] { return campaign.done_batches() >= 3; });
    EXPECT_GE(campaign.tally().cases, 120U);
    EXPECT_THROW(Campaign::resumed(folder, std::nullopt), UnusableFolder);  // in use
  }
  // A kill in the middle of a line would leave the file like this.
  std::ofstream(folder / "batches.jsonl", std::ios::app) << R"({"batch":3,"comp)";
  std::ofstream(folder / "findings.jsonl", std::ios::app) << R"({"find)";
  Campaign campaign = Campaign::resumed(folder, std::nullopt);
  EXPECT_GE(campaign.done_batches(), 3U);
  EXPECT_LT(campaign.done_batches(), 11U);
  work(campaign, {rows_property(8)}, 2);
  EXPECT_EQ(account_of(campaign), whole);
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    const fs::path file = campaign.file_of(counterexample);
    EXPECT_TRUE(file.empty() || fs::exists(file)) << file;
  }
}

TEST_F(CampaignTest, CanBeMadeLonger) {
  const std::string whole = account_of_run(small_plan(), 410, 1, folder_ / "whole");
  const fs::path folder = folder_ / "campaign";
  {
    Campaign campaign = Campaign::begun(small_plan(), 130, folder);
    work(campaign, {rows_property(8)}, 1);
    EXPECT_EQ(campaign.tally().cases, 130U);
  }
  Campaign campaign = Campaign::resumed(folder, 410);
  work(campaign, {rows_property(8)}, 1);
  EXPECT_EQ(account_of(campaign), whole);
}

TEST_F(CampaignTest, KilledOutrightLosesNoFinding) {
  const std::string whole = account_of_run(small_plan(), 4000, 1, folder_ / "whole");
  const fs::path folder = folder_ / "campaign";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Campaign campaign = Campaign::begun(small_plan(), 4000, folder);
    WorkOptions options;
    options.jobs = 2;
    options.is_stopped = [] { return false; };
    options.progress = [&](std::size_t) {
      if (campaign.done_batches() >= 5) ::raise(SIGKILL);
    };
    work_on(campaign, {rows_property(8)}, options);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  std::size_t findings_before = 0;
  {
    // The workers die with their parent, but not in the same instant.
    Campaign campaign = [&] {
      for (int attempt = 0;; ++attempt) {
        try {
          return Campaign::resumed(folder, std::nullopt);
        } catch (const UnusableFolder&) {
          if (attempt == 50) throw;
          ::usleep(100'000);
        }
      }
    }();
    findings_before = campaign.counterexamples().size();
    EXPECT_GT(findings_before, 0U);
    work(campaign, {rows_property(8)}, 2);
    EXPECT_EQ(account_of(campaign), whole);
  }
}

TEST_F(CampaignTest, RefusesFoldersThatItCannotUse) {
  EXPECT_THROW(Campaign::resumed(folder_ / "none", std::nullopt), UnusableFolder);
  std::ofstream(folder_ / "plan.json") << "{}\n";
  EXPECT_THROW(Campaign::resumed(folder_, std::nullopt), UnusableFolder);
  EXPECT_THROW(Campaign::begun(small_plan(), 10, folder_), UnusableFolder);
  EXPECT_THROW(Campaign::begun(small_plan(), 10, "/proc/none"), UnusableFolder);
}

TEST(CampaignPlan, SurvivesItsText) {
  CampaignPlan plan;
  plan.seed = 0xffffffffffffffffU;
  plan.families = families_of("box-corners:3,half-shell");
  plan.fewest_rows = 3;
  plan.most_rows = 9;
  plan.searched_percent = 55;
  plan.properties = {"orbit", "stable-kernels"};
  plan.against = "my 'flow' {in}";
  plan.batch_cases = 17;
  plan.shrinks_all = true;
  plan.corpus = {{{{0.1, -0.0, 1e300}, {5e-324, 2, 3}}}};
  plan.shard = {2, 5};
  EXPECT_EQ(plan_of(to_text(plan)), plan);
  plan.is_dialogue = true;
  plan.ignored = {"refusal"};
  EXPECT_EQ(plan_of(to_text(plan)), plan);
  for (const char* text : {"", "{}", "[]", "{\"format\":\"flowcert-fuzz\",\"version\":2}"}) {
    EXPECT_THROW((void)plan_of(text), std::invalid_argument) << text;
  }
  plan.properties = {"orbits"};
  EXPECT_THROW((void)plan_of(to_text(plan)), std::invalid_argument);
}

TEST(CampaignPlan, RefusesUnknownFamiliesAndWeights) {
  for (const char* list :
       {"no-such", "half-shell:0", "half-shell:-1", "half-shell:x", "half-shell:", "half-shell:9999999"}) {
    EXPECT_THROW((void)families_of(list), std::invalid_argument) << list;
  }
  EXPECT_EQ(families_of("half-shell,box-corners:12").at(1), (WeightedFamily{"box-corners", 12}));
}

TEST(CampaignPlan, CutsCasesIntoBatchesAndShards) {
  CampaignPlan plan;
  plan.batch_cases = 10;
  EXPECT_EQ(cases_of_batch(plan, 25, 2), 5U);
  EXPECT_EQ(cases_of_batch(plan, 25, 3), 0U);
  EXPECT_EQ(cases_of_batch(plan, 30, 2), 10U);
  EXPECT_EQ(cases_of_batch(plan, std::nullopt, 1000), 10U);
  plan.shard = {1, 3};
  EXPECT_EQ(batch_from(plan, 75, 0), 1U);
  EXPECT_EQ(batch_from(plan, 75, 2), 4U);
  EXPECT_EQ(batch_from(plan, 75, 7), 7U);
  EXPECT_EQ(batch_from(plan, 75, 8), std::nullopt);
}

TEST(CampaignPlan, CountsTheCasesOfAShard) {
  CampaignPlan plan;
  plan.batch_cases = 10;
  for (const std::size_t total : {std::size_t{0}, std::size_t{5}, std::size_t{10}, std::size_t{75}, std::size_t{80}}) {
    for (plan.shard.count = 1; plan.shard.count < 12; ++plan.shard.count) {
      for (plan.shard.index = 0; plan.shard.index < plan.shard.count; ++plan.shard.index) {
        std::size_t sum = 0;
        for (auto batch = batch_from(plan, total, 0); batch; batch = batch_from(plan, total, *batch + 1)) {
          sum += cases_of_batch(plan, total, *batch);
        }
        EXPECT_EQ(cases_of_shard(plan, total), sum) << total;
      }
    }
  }
  plan.shard = {3, 7};
  EXPECT_EQ(cases_of_shard(plan, 700'000'000'000), 100'000'000'000U);
}

Counterexample some_counterexample() {
  Counterexample counterexample{
      12, 345, "shell", 9, "orbit", {}, {"segment-type", "FC-FLOW-02", "two\nlines", "fast", "a\nb", "oracle", "c"}};
  counterexample.trial.input.rows = {{0.1, -2, 1e-300}, {3, 4, 5}};
  counterexample.trial.start = oracle::Point{oracle::Rational(1, 3), oracle::Rational(-2), oracle::Rational(0)};
  return counterexample;
}

TEST(Counterexample, SurvivesItsFile) {
  const Counterexample counterexample = some_counterexample();
  const std::string text = file_text(counterexample);
  const Counterexample read = counterexample_of(text);
  EXPECT_EQ(read.trial.input, counterexample.trial.input);
  EXPECT_EQ(std::get<oracle::Point>(read.trial.start), std::get<oracle::Point>(counterexample.trial.start));
  EXPECT_EQ(read.property, "orbit");
  EXPECT_EQ(read.disagreement.kind, "segment-type");
  EXPECT_EQ(read.disagreement.clause, "FC-FLOW-02");
  EXPECT_EQ(name_of(counterexample), "orbit-segment-type-345");
  Counterexample chosen = counterexample;
  chosen.trial.start = property::StartChoice{property::StartKind::kEdge, {3, 0, 4294967295}};
  const auto choice = std::get<property::StartChoice>(counterexample_of(file_text(chosen)).trial.start);
  EXPECT_EQ(choice.kind, property::StartKind::kEdge);
  EXPECT_EQ(choice.numbers, (std::vector<std::uint32_t>{3, 0, 4294967295}));
  // A reader of point files sees rows alone: every other line is a comment.
  std::istringstream lines(text);
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) rows += line.starts_with('#') ? 0 : 1;
  EXPECT_EQ(rows, 2U);
}

TEST(Counterexample, RefusesRowsThatAreNone) {
  for (const char* text : {"1 2\n", "1 2 x\n", "1 2 inf\n", "# start: 1/0 2 3\n1 2 3\n", "# start: 1 2\n",
                           "# choice of start: no-such 1\n", "# choice of start: edge 1 x\n"}) {
    EXPECT_THROW((void)counterexample_of(std::string(text)), std::invalid_argument) << text;
  }
  EXPECT_EQ(counterexample_of(std::string("# any comment\n1 2 3 # and more\n\n0x1p-3 0 0\n")).trial.input.rows.size(),
            2U);
}

TEST(BatchOrder, SurvivesItsText) {
  const BatchOrder order = order_of(to_text(BatchOrder{3, 40, {121, 130}}));
  EXPECT_EQ(order.batch, 3U);
  EXPECT_EQ(order.cases, 40U);
  EXPECT_EQ(order.left_out, (std::set<std::size_t>{121, 130}));
  EXPECT_EQ(order.only, std::nullopt);
  EXPECT_EQ(order_of(to_text(BatchOrder{3, 40, {}, 125})).only, 125U);
  EXPECT_THROW((void)order_of("x"), std::invalid_argument);
}

}  // namespace
}  // namespace flowcert::fuzz::campaign_test
