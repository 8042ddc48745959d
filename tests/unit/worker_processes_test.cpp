// The processes that work on campaigns. A case, a stop, somebody else, or what the machine lacks may end one.
// These ends are told apart, and none of them costs a case or a counterexample.
#include "fuzz/campaign/worker_processes.h"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <system_error>

#include "tests/unit/campaign_fixture.h"

namespace flowcert::fuzz::worker_processes_test {
namespace {

using WorkerProcessesTest = CampaignTest;

TEST_F(WorkerProcessesTest, ACaseThatEndsItsProcessIsAFinding) {
  Property property = rows_property(100);
  property.check = [](const Trial& trial) -> std::optional<Disagreement> {
    if (trial.input.rows.size() >= 9) crash();
    return std::nullopt;
  };
  CampaignPlan plan = small_plan();
  plan.searched_percent = 0;
  Campaign campaign(plan, 80, folder_ / "findings");
  work(campaign, {property}, 2);
  ASSERT_FALSE(campaign.counterexamples().empty());
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    EXPECT_EQ(counterexample.disagreement.kind, "crash");
    EXPECT_EQ(counterexample.property, "rows");
    EXPECT_EQ(counterexample.trial.input.rows.size(), 9U);
  }
  EXPECT_EQ(campaign.tally().cases + campaign.counterexamples().size(), 80U);
  // A case with a finding has failed, though no batch counts it.
  EXPECT_EQ(campaign.failing_cases(), campaign.counterexamples().size());
  EXPECT_EQ(campaign.failures().at("rows crash").size(), campaign.counterexamples().size());
  EXPECT_TRUE(campaign.is_settled());
}

TEST_F(WorkerProcessesTest, ACaseThatHangsIsAFinding) {
  Property property = rows_property(100);
  property.check = [](const Trial& trial) -> std::optional<Disagreement> {
    if (trial.input.rows.size() >= 12) ::sleep(60);
    return std::nullopt;
  };
  CampaignPlan plan = small_plan();
  plan.searched_percent = 0;
  Campaign campaign(plan, 80, folder_ / "findings");
  work(campaign, {property}, 1, [] { return false; }, 2);
  ASSERT_FALSE(campaign.counterexamples().empty());
  for (const auto& [key, counterexample] : campaign.counterexamples())
    EXPECT_EQ(counterexample.disagreement.kind, "hang");
}

// Whoever runs a process may end it this way, and so does a system without memory.
TEST_F(WorkerProcessesTest, ACaseIsNotBlamedForTheFirstSigkill) {
  const fs::path marks = folder_ / "marks";
  fs::create_directory(marks);
  Property property = rows_property(100);
  property.check = [&](const Trial& trial) -> std::optional<Disagreement> {
    const std::size_t rows = trial.input.rows.size();
    const bool is_first = rows == 11 && std::ofstream(marks / "of-11", std::ios::app).tellp() == 0;
    if (is_first) std::ofstream(marks / "of-11") << "killed";
    if (rows == 12 || is_first) ::raise(SIGKILL);
    return std::nullopt;
  };
  CampaignPlan plan = small_plan();
  plan.searched_percent = 0;
  Campaign campaign(plan, 200, folder_ / "findings");
  work(campaign, {property}, 1);
  EXPECT_TRUE(fs::exists(marks / "of-11"));
  ASSERT_FALSE(campaign.counterexamples().empty());
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    EXPECT_EQ(counterexample.disagreement.kind, "crash");
    EXPECT_EQ(counterexample.rows_before, 12U);
    EXPECT_NE(counterexample.source, "");
  }
  EXPECT_EQ(campaign.tally().cases + campaign.counterexamples().size(), 200U);
}

// They are killed while they try a case, or between two cases.
TEST_F(WorkerProcessesTest, OutlivesTheKillingOfItsProcesses) {
  const std::string whole = account_of_run(small_plan(), 410, 1, folder_ / "whole");
  const fs::path marks = folder_ / "marks";
  Property property = rows_property(8);
  property.check = [&, usual = property.check](const Trial& trial) {
    std::ofstream(marks, std::ios::app) << '.';
    const bool is_time = std::set<std::uintmax_t>{30, 115, 215, 325, 447, 580}.contains(fs::file_size(marks));
    const pid_t worker = ::getpid();
    if (is_time && ::fork() == 0) {
      ::usleep(200);
      ::kill(worker, SIGKILL);
      ::_exit(0);
    }
    return usual(trial);
  };
  Campaign campaign(small_plan(), 410, folder_ / "findings");
  work(campaign, {property}, 1);
  EXPECT_GT(fs::file_size(marks), 580U);
  // By chance a case may have been under way twice when its process was killed, and is blamed for it. What it had
  // found by then stays, and is not made small: no process tries that case again.
  std::set<std::size_t> blamed;
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    if (ends_process(counterexample)) blamed.insert(counterexample.number);
  }
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    EXPECT_TRUE(counterexample.is_small || blamed.contains(counterexample.number));
  }
  EXPECT_LT(blamed.size(), 3U);
  EXPECT_EQ(campaign.tally().cases + blamed.size(), 410U);
  if (blamed.empty()) {
    EXPECT_EQ(account_of(campaign), whole);
  }
}

TEST_F(WorkerProcessesTest, ACrashIsMadeSmallThoughItsProcessIsKilled) {
  const fs::path marks = folder_ / "marks";
  const pid_t test = ::getpid();
  Property property = rows_property(100);
  property.check = [&](const Trial& trial) -> std::optional<Disagreement> {
    if (trial.input.rows.size() < 9) return std::nullopt;
    const pid_t parent = ::getppid();
    if (parent != test && !fs::exists(marks)) {  // in a child of the process that makes it small
      std::ofstream(marks) << '.';
      ::kill(parent, SIGKILL);
    }
    crash();
    return std::nullopt;
  };
  CampaignPlan plan = small_plan();
  plan.searched_percent = 0;
  Campaign campaign(plan, 80, folder_ / "findings");
  work(campaign, {property}, 1);
  EXPECT_TRUE(fs::exists(marks));
  ASSERT_FALSE(campaign.counterexamples().empty());
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    EXPECT_TRUE(counterexample.is_small);
    EXPECT_EQ(counterexample.trial.input.rows.size(), 9U);
  }
  EXPECT_EQ(campaign.tally().left_out, campaign.counterexamples().size());
}

// What is half small when time is up is kept, and called so, until it is done again.
TEST_F(WorkerProcessesTest, WhatIsHalfSmallWhenItIsStoppedIsKeptAsThat) {
  CampaignPlan plan = small_plan();
  plan.fewest_rows = 12;
  plan.searched_percent = 0;
  const fs::path marks = folder_ / "marks";
  Property property = rows_property(2);
  property.check = [&, usual = property.check](const Trial& trial) {
    // It waits for the stop when it has got to four rows.
    if (trial.input.rows.size() <= 4) std::ofstream(marks) << '.';
    for (int k = 0; k < 100 && trial.input.rows.size() <= 4; ++k) ::usleep(10'000);
    return usual(trial);
  };
  Campaign campaign(plan, 40, folder_ / "findings");
  work(campaign, {property}, 1, [&] { return fs::exists(marks); });
  ASSERT_EQ(campaign.counterexamples().size(), 1U);
  const Counterexample half = campaign.counterexamples().begin()->second;
  EXPECT_FALSE(half.is_small);
  EXPECT_LT(half.trial.input.rows.size(), half.rows_before);
  EXPECT_GE(half.trial.input.rows.size(), 2U);
  EXPECT_EQ(why_not_fully_shrunk(half, "time was up"), "time was up");
  EXPECT_EQ(campaign.failing_cases(), 1U);
  work(campaign, {rows_property(2)}, 1);
  const Counterexample whole = campaign.counterexamples().begin()->second;
  EXPECT_EQ(whole.trial.input.rows.size(), 2U);
  EXPECT_EQ(why_not_fully_shrunk(whole, "time was up"), "");
}

// A stop leaves nothing half small, whenever it comes.
TEST_F(WorkerProcessesTest, StoppedWhileMakingSmallItEndsTheSame) {
  CampaignPlan plan = small_plan();
  plan.batch_cases = 5;
  const fs::path marks = folder_ / "marks";
  for (const bool crashes : {false, true}) {
    Property property = rows_property(6);
    property.check = [&, usual = property.check](const Trial& trial) {
      std::ofstream(marks, std::ios::app) << '.';
      const auto found = usual(trial);
      if (found && crashes) crash();
      return found;
    };
    // Each time the run stops after more checks, most of which are there to make something small.
    const auto account = [&](const fs::path& folder, std::size_t stops) {
      Campaign::begun(plan, 20, folder);
      for (std::size_t k = 0; k < stops; ++k) {
        Campaign campaign = Campaign::resumed(folder, std::nullopt);
        std::ofstream(marks, std::ios::trunc).flush();
        work(campaign, {property}, 1, [&] { return fs::file_size(marks) > 6 * (k + 1); });
      }
      Campaign campaign = Campaign::resumed(folder, std::nullopt);
      work(campaign, {property}, 1);
      for (const auto& [key, counterexample] : campaign.counterexamples()) EXPECT_TRUE(counterexample.is_small);
      return account_of(campaign);
    };
    const std::string name = crashes ? "crashing" : "failing";
    const std::string whole = account(folder_ / name, 0);
    EXPECT_NE(whole.find(crashes ? "crash" : "too-many"), std::string::npos);
    EXPECT_EQ(account(folder_ / (name + "-stopped"), 5), whole);
  }
}

TEST_F(WorkerProcessesTest, ACrashForWantOfAMachineIsNotMadeSmall) {
  Property property = rows_property(100);
  const pid_t test = ::getpid();
  property.check = [&](const Trial& trial) -> std::optional<Disagreement> {
    if (trial.input.rows.size() < 9) return std::nullopt;
    // A worker is the child of the test, and those that make a crash small are children of workers.
    if (::getppid() != test) throw property::MachineFailure("no more processes");
    crash();
    return std::nullopt;
  };
  CampaignPlan plan = small_plan();
  plan.searched_percent = 0;
  Campaign campaign(plan, 80, folder_ / "findings");
  EXPECT_THROW(work(campaign, {property}, 1), property::MachineFailure);
  ASSERT_EQ(campaign.counterexamples().size(), 1U);
  EXPECT_GE(campaign.counterexamples().begin()->second.trial.input.rows.size(), 9U);
}

TEST_F(WorkerProcessesTest, WhatTheMachineLacksIsNoFinding) {
  Property property = rows_property(100);
  property.check = [](const Trial& trial) -> std::optional<Disagreement> {
    if (trial.input.rows.size() >= 5) throw std::system_error(ENOSPC, std::generic_category(), "scratch");
    return std::nullopt;
  };
  Campaign campaign(small_plan(), 40, folder_ / "findings");
  EXPECT_THROW(work(campaign, {property}, 2), property::MachineFailure);
  EXPECT_TRUE(campaign.counterexamples().empty());
}

TEST_F(WorkerProcessesTest, StopsInTheMiddleOfALongCase) {
  const std::string whole = account_of_run(small_plan(), 80, 1, folder_ / "whole");
  const fs::path folder = folder_ / "campaign";
  Property slow = rows_property(8);
  slow.check = [](const Trial&) -> std::optional<Disagreement> {
    ::sleep(60);
    return std::nullopt;
  };
  {
    Campaign campaign = Campaign::begun(small_plan(), 80, folder);
    const auto start = std::chrono::steady_clock::now();
    work(campaign, {slow}, 2,
         [&] { return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(300); });
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
    EXPECT_TRUE(campaign.counterexamples().empty());
    EXPECT_TRUE(campaign.is_settled());
  }
  Campaign campaign = Campaign::resumed(folder, std::nullopt);
  work(campaign, {rows_property(8)}, 1);
  EXPECT_EQ(account_of(campaign), whole);
}

TEST_F(WorkerProcessesTest, ExceptionsAreFindings) {
  Property property = rows_property(100);
  property.check = [](const Trial& trial) -> std::optional<Disagreement> {
    if (trial.input.rows.size() >= 5) throw std::logic_error("five rows \xff and more");
    return std::nullopt;
  };
  Campaign campaign(small_plan(), 40, folder_ / "findings");
  work(campaign, {property}, 1);
  ASSERT_EQ(campaign.counterexamples().size(), 1U);
  const Counterexample& counterexample = campaign.counterexamples().begin()->second;
  EXPECT_EQ(counterexample.disagreement.kind, "throws");
  EXPECT_EQ(counterexample.trial.input.rows.size(), 5U);
}

}  // namespace
}  // namespace flowcert::fuzz::worker_processes_test
