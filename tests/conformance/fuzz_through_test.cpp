// `flowcert fuzz --through`: a program that is started once, and asked case after case.
//
// Guarantees: what is wrong with it is what is wrong with the same program started for each input. However it ends,
// that is a finding of the case which it was asked, and no other case is the worse for it.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cites.h"
#include "tests/conformance/campaign_account.h"
#include "tests/conformance/case_texts.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::fuzz_through_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kThrough = std::string(FLOWCERT_PEER) + " --cases";

json campaign(const Words& options, int status) {
  const Finished finished = flowcert(joined({"fuzz", "--json"}, options));
  EXPECT_EQ(finished.status, status) << finished.err;
  EXPECT_EQ(finished.err, "");
  return account_of(finished);
}

// Writes a line to the file whenever it is started.
std::string counting_starts(const Scratch& scratch, const std::string& command) {
  return "echo started >>'" + scratch.path("starts") + "'; exec " + command;
}
std::size_t starts(const Scratch& scratch) { return lines_of(content_of(scratch.path("starts"))).size(); }

TEST(FuzzThrough, RightAnswersAreNoFindings) {
  CITES("FC-CLAIM-03");
  const Scratch scratch;
  const std::string command = counting_starts(scratch, std::string(FLOWCERT_MIDDLE) + " exchange");
  const json report = campaign({"--count", "250", "--jobs", "2", "--through", command}, 0);
  EXPECT_EQ(report.at("failing_cases"), 0);
  EXPECT_EQ(report.at("by_property"), json({{"against", 250}}));
  EXPECT_EQ(starts(scratch), 3U) << "one to see whether it starts, and one for each process that works";
}

// The start of a program is paid once, here 0.2 s.
TEST(FuzzThrough, ASlowStartIsPaidOnce) {
  const Scratch scratch;
  const std::string program = FLOWCERT_SPEC_FOLDER + std::string("/../tests/conformance/slow_start.py");
  const auto start = std::chrono::steady_clock::now();
  const json report = campaign(
      {"--count", "20", "--points", "1-4", "--through", counting_starts(scratch, "python3 '" + program + "'")}, 0);
  EXPECT_EQ(report.at("by_property"), json({{"against", 20}}));
  EXPECT_EQ(starts(scratch), 2U);
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(400));
}

TEST(FuzzThrough, FindsWhatAgainstFinds) {
  CITES("FC-CLAIM-03");
  const Scratch scratch;
  const std::string folder = scratch.path("through"), command = kThrough + " --strict";
  const Words cases = {"--count", "30", "--families", "box-corners", "--points", "4-5"};
  const std::string started = std::string(FLOWCERT_PEER) + " {in} {out} --strict";
  const json against = campaign(joined(cases, {"--against", started, "--out", scratch.path("against")}), 1);
  const json through = campaign(joined(cases, {"--through", command, "--out", folder}), 1);
  EXPECT_GT(through.at("failing_cases"), 5);
  EXPECT_EQ(through.at("failing"), against.at("failing"));
  ASSERT_EQ(through.at("findings").size(), against.at("findings").size());
  for (std::size_t k = 0; k < through.at("findings").size(); ++k) {
    EXPECT_EQ(through.at("findings")[k].at("points"), against.at("findings")[k].at("points"));
  }
  for (const auto& entry : fs::directory_iterator(folder + "/findings")) {
    if (entry.path().extension() != ".xyz") continue;
    EXPECT_EQ(flowcert({"fuzz", "--replay", entry.path().string(), "--through", command}).status, 1) << entry.path();
    const Words right = {"fuzz", "--replay", entry.path().string(), "--through", FLOWCERT_MIDDLE " exchange"};
    EXPECT_EQ(flowcert(right).status, 0) << entry.path();
  }
}

TEST(FuzzThrough, AFolderOfACampaignRunsItsCommandOnlyIfItIsSaidAgain) {
  const Scratch scratch;
  const std::string folder = scratch.path("campaign"), command = FLOWCERT_MIDDLE " csv";
  (void)campaign({"--count", "20", "--through", command, "--out", folder}, 0);
  const json plan = json::parse(json::parse(content_of(folder + "/plan.json")).at("plan").get<std::string>());
  EXPECT_EQ(plan.at("version"), 5);
  EXPECT_EQ(plan.at("through"), true);
  EXPECT_EQ(plan.at("against"), command);
  EXPECT_EQ(campaign({"--resume", folder, "--count", "40", "--through", command}, 0).at("cases"), 40);
  const Words resumed = {"fuzz", "--resume", folder, "--count", "60"};
  const std::string runs = folder + ": its campaign runs the command " + command;
  for (const auto& [more, what] :
       {std::pair<Words, std::string>{{}, "; it runs if --through says it again\n"},
        {{"--against", command + " {in}"}, ", not another one; it runs if --through says it again\n"},
        {{"--through", "other"}, ", and --through says another one\n"}}) {
    const Finished finished = flowcert(joined(resumed, more));
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err, "flowcert: " + runs + what);
  }
}

// ---- Ends ----

struct Ending {
  const char* how;
  const char* kind;
  const char* complaint;  // a part of it
};

class FuzzThroughEndings : public testing::TestWithParam<Ending> {};

// The program misbehaves on six points and more.
TEST_P(FuzzThroughEndings, AreFindings) {
  const Scratch scratch;
  const auto& [how, kind, complaint] = GetParam();
  const json report =
      campaign({"--count", "14", "--points", "5-7", "--mutants", "0", "--families", "general-position", "--time-limit",
                "0.3", "--through", kThrough + " " + how + " 6", "--out", scratch.path("campaign")},
               1);
  ASSERT_EQ(report.at("findings").size(), 1U) << report.at("findings");
  const json& finding = report.at("findings")[0];
  EXPECT_EQ(finding.at("kind"), kind);
  EXPECT_EQ(finding.at("points"), 6);
  EXPECT_TRUE(contains(finding.at("complaint"), complaint)) << finding;
  // Cases of five points got their answers.
  EXPECT_GT(report.at("failing_cases"), 2);
  EXPECT_LT(report.at("failing_cases"), 14);
}

INSTANTIATE_TEST_SUITE_P(All, FuzzThroughEndings,
                         testing::Values(Ending{"--crash", "signal", "SIGSEGV"},
                                         Ending{"--refuse", "refusal", "exit status 3: too many points for me"},
                                         Ending{"--quit", "unreadable", "it ended before it had answered"},
                                         Ending{"--stray", "unreadable",
                                                "neither 'answer ID' nor 'refused ID': 'that was hard'"},
                                         Ending{"--other-id", "unreadable", "an answer to 'fuzz:"}));

TEST(FuzzThrough, ARefusalIsOneAndTheProgramGoesOn) {
  const Scratch scratch;
  const std::string refuses = "while read -r word id count; do test $word = case && echo refused $id too hard; done";
  const std::string command = counting_starts(scratch, "sh -c '" + refuses + "'");
  const json report = campaign({"--count", "10", "--through", command, "--out", scratch.path("campaign")}, 1);
  EXPECT_EQ(report.at("failures"), json({{"against refusal", 10}}));
  EXPECT_EQ(report.at("findings")[0].at("complaint"), "refused: too hard");
  EXPECT_EQ(report.at("findings")[0].at("points"), 1);
  EXPECT_EQ(starts(scratch), 2U);
}

TEST(FuzzThrough, RefusesWhatItCannotStart) {
  for (const Words& options : {Words{"--through", "/no/such/program"}, Words{"--through", "exit 126"},
                               Words{"--through", "true", "--against", "true {in}"},
                               Words{"--through", "true", "--persistence-against", "true {in}"},
                               Words{"--through", "true", "--property", "orbit"}}) {
    const Finished finished = flowcert(joined({"fuzz", "--count", "5"}, options));
    EXPECT_EQ(finished.status, 2) << options[1];
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(contains(finished.err, "--through")) << finished.err;
  }
}

}  // namespace
}  // namespace flowcert::conformance::fuzz_through_test
