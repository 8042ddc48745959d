// What the tests of campaigns share: a folder, a small plan, a property that fails on many rows, and an
// account by which two campaigns are compared.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/worker_processes.h"

namespace flowcert::fuzz {

namespace fs = std::filesystem;
using property::Disagreement;
using property::Property;
using property::Trial;

class CampaignTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "flowcert-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

inline CampaignPlan small_plan() {
  CampaignPlan plan;
  plan.seed = 7;
  plan.batch_cases = 40;
  return plan;
}

// Fails on inputs of at least so many rows.
inline Property rows_property(std::size_t rows) {
  return {.name = "rows", .description = "few rows", .check = [rows](const Trial& trial) {
            return trial.input.rows.size() < rows
                       ? std::nullopt
                       : std::optional(Disagreement{"too-many", "FC-IN-01", "too many rows", "", "", "", ""});
          }};
}

// Ends this process by a signal, as a bad pointer does. A sanitizer would catch the signal and exit instead.
inline void crash() {
  (void)::signal(SIGSEGV, SIG_DFL);
  ::raise(SIGSEGV);
}

inline void work(
    BatchSource& source, const std::vector<Property>& properties, unsigned jobs,
    const std::function<bool()>& is_stopped = [] { return false; }, double hang_seconds = 60) {
  WorkOptions options;
  options.jobs = jobs;
  options.hang_seconds = hang_seconds;
  options.is_stopped = is_stopped;
  options.progress = [](std::size_t) {};
  work_on(source, properties, options);
}

// All that has to be the same in two campaigns. Times are left out.
inline std::string account_of(const Campaign& campaign) {
  std::string text = std::to_string(campaign.tally().cases) + '\n';
  for (const auto& [name, count] : campaign.tally().by_source) text += name + ' ' + std::to_string(count) + '\n';
  for (const auto& [name, count] : campaign.tally().by_mutation) text += name + ' ' + std::to_string(count) + '\n';
  for (const auto& [name, numbers] : campaign.tally().failures) {
    text += name;
    for (const std::size_t number : numbers) text += ' ' + std::to_string(number);
    text += '\n';
  }
  for (const auto& [signature, where] : campaign.signatures()) {
    text += to_text(signature) + ' ' + std::to_string(where.number) + '\n';
  }
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    text += campaign.file_of(counterexample).filename().string() + '\n' + file_text(counterexample);
  }
  return text;
}

inline std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

inline std::string account_of_run(const CampaignPlan& plan, std::size_t cases, unsigned jobs, const fs::path& folder) {
  Campaign campaign(plan, cases, folder);
  work(campaign, {rows_property(8)}, jobs);
  return account_of(campaign);
}

}  // namespace flowcert::fuzz
