// `flowcert verify`: whether a program's answers to the cases of `flowcert generate` are right. Exit status 0
// if all are, 1 if any is not or is missing.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/judging_options.h"
#include "cli/progress_line.h"
#include "fuzz/commands/commands.h"
#include "fuzz/commands/verify_report.h"
#include "fuzz/judge/oracle_truth.h"
#include "io/output_file.h"

namespace flowcert::commands {

namespace {

// Of failing cases, to people and to programs.
constexpr std::size_t kUsuallyShown = 10;
constexpr std::size_t kUsuallyReported = 1000;

struct VerifyCommandOptions {
  VerificationOptions verification;
  std::optional<std::size_t> most;
  std::string junit;
  bool json = false;
};

void take_all_answers(Verification& verification) {
  ProgressLine progress("verifying");
  std::ios::sync_with_stdio(false);
  AnswerReader answers(std::cin);
  Answer answer;
  while (answers.next(answer)) {
    verification.take(answer);
    progress(verification.taken(), verification.expected());
  }
}

int verify(VerifyCommandOptions options) {
  const bool is_for_programs = options.json || !options.junit.empty();
  options.verification.most_failures_kept =
      options.most.value_or(is_for_programs ? kUsuallyReported : kUsuallyShown);
  Verification verification(options.verification);
  take_all_answers(verification);
  if (!verification.has_begun()) throw InvalidInput("standard input: no answers");
  if (!options.junit.empty()) {
    OutputFile file(options.junit);
    write_verify_junit(file.stream(), verification);
    file.commit();
  }
  if (options.json) {
    print_verify_json(verification);
  } else {
    print_verify_text(verification, options.most.value_or(kUsuallyShown));
  }
  return verification.verdict() == Verdict::kFails ? kNegativeVerdict : kRight;
}

}  // namespace

void add_verify_command(CLI::App& app, int& status) {
  auto options = std::make_shared<VerifyCommandOptions>();
  VerificationOptions& verification = options->verification;
  CLI::App* command =
      app.add_subcommand("verify", "Whether a program's answers to the cases of generate are right");
  command->add_flag("--json", options->json, "Print one JSON object");
  command->add_option("--junit", options->junit, "Write a JUnit report to this file, a test case a family");
  command
      ->add_option("--keep", verification.folder,
                   "Write points and claim of each failing case into this folder, for flowcert check")
      ->type_name("DIR");
  add_judging_options(*command, verification.check);
  command
      ->add_option("--most", options->most,
                   "Report so many failing cases; without this 10, to programs 1,000")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--only", verification.only, "Expect an answer to this case alone")
      ->check(CLI::NonNegativeNumber);
  command->add_flag(
      "--oracle", verification.by_oracle,
      fmt::format("Let the oracle say what is true, not the fast implementation, for cases of up "
                  "to {} points",
                  kMostPointsForOracle));
  command->footer(
      "Reads from standard input, for each case, in any order:\n"
      "  answer ID\n  ...the critical points, in a format that flowcert check reads...\n  end\n"
      "or a line `refused ID REASON`.\n\n"
      "Example:\n  flowcert generate --level 1 --seed 7 | ./your-program | flowcert verify");
  command->callback([options, &status] { status = verify(*options); });
}

}  // namespace flowcert::commands
