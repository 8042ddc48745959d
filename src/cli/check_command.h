// The commands that judge. Their caller hands them the oracle and what draws cases, because src/ knows neither.
#pragma once

#include <functional>
#include <memory>

#include "certify/other_truth.h"
#include "certify/programs/asked_cases.h"
#include "cli/command.h"

namespace flowcert::cli {

struct DrawnRuns {
  // Adds options that say which cases are asked. After the command line is parsed, the returned function makes these
  // cases, or nothing if none of the options is given.
  std::function<std::function<std::unique_ptr<AskedCases>()>(CLI::App& command)> add_options;
  DrawnCasesOf of_id;
};

void add_check_command(CLI::App& app, int& status, const OtherTruth& oracle);
void add_conformance_command(CLI::App& app, int& status, const OtherTruth& oracle);
void add_verify_command(CLI::App& app, int& status, const OtherTruth& oracle, const DrawnRuns& drawn);

}  // namespace flowcert::cli
