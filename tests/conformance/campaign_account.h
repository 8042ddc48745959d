// The result of a campaign, as `flowcert fuzz --json` reports it, and a wait until a campaign is under way.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance {

// The report without what depends on the time, on where the files are, and on how the run was cut.
inline nlohmann::json account_of(const Finished& finished) {
  nlohmann::json report = nlohmann::json::parse(finished.out);
  for (const char* key : {"seconds", "cases_per_second", "jobs", "by_points", "shard"}) report.erase(key);
  for (nlohmann::json& finding : report.at("findings")) finding.erase("file");
  return report;
}

// Waits until the campaign has written a batch.
inline void wait_for_a_batch(RunningProgram& program, const std::string& folder) {
  for (int k = 0; k < 3000 && !program.has_ended(); ++k) {
    std::error_code ignored;
    if (std::filesystem::file_size(folder + "/batches.jsonl", ignored) > 0 && !ignored) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL() << "the campaign never got anywhere";
}

}  // namespace flowcert::conformance
