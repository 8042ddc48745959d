// The findings of `flowcert fuzz`: when they are printed, how small they are, and how they are counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/conformance/campaign_account.h"
#include "tests/conformance/case_texts.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::fuzz_findings_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kPeer = std::string(FLOWCERT_PEER) + " {in} {out} --strict";
const std::string kThrough = std::string(FLOWCERT_PEER) + " --cases --strict";

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

TEST(FuzzFindings, ArePrintedAsTheyCome) {
  const Scratch scratch;
  const std::string out = scratch.path("out");
  RunningProgram program(
      {FLOWCERT_PROGRAM, "fuzz", "--count", "1000000", "--through", kThrough, "--out", scratch.path("campaign")},
      {.standard_input = "/dev/null", .standard_output = out});
  for (int k = 0; k < 1000 && !contains(content_of(out), ".xyz\n"); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_FALSE(program.has_ended());
  const std::string soon = content_of(out);
  EXPECT_TRUE(soon.starts_with("Findings:\n  case ")) << soon;
  program.signal(SIGINT);
  EXPECT_EQ(program.finish().status, 1);
  const std::string all = content_of(out);
  EXPECT_TRUE(all.starts_with(soon));
  EXPECT_LT(all.find("  case "), all.find("smallest example"));
  EXPECT_EQ(times_in(all, lines_of(soon).at(1) + '\n'), 1U) << all;
  EXPECT_TRUE(contains(all, "\nAgain: flowcert fuzz --replay FILE --through '" + kThrough + "'\n")) << all;
}

TEST(FuzzFindings, ASecondRunTellsTheOldOnesAtTheEnd) {
  const Scratch scratch;
  const Words options = {"fuzz", "--through", kThrough, "--count", "60"};
  const Finished first = flowcert(joined(options, {"--out", scratch.path("campaign")}));
  EXPECT_EQ(first.status, 1) << first.err;
  const Finished again = flowcert(joined(options, {"--resume", scratch.path("campaign")}));
  EXPECT_EQ(again.status, 1) << again.err;
  for (const std::string& line : lines_of(first.out)) {
    EXPECT_TRUE(!line.ends_with(".xyz") || times_in(first.out + again.out, line) == 2) << line;
  }
  EXPECT_EQ(times_in(first.out, "indings:\n"), 1U);
}

// ---- The first ----

TEST(FuzzFindings, TheFirstIsShrunkToTheEnd) {
  const Scratch scratch;
  // The time is over before it is small.
  const Words options = {"fuzz",     "--json", "--first",   "--families", "box-corners",
                         "--points", "4-4",    "--against", kPeer};
  const Finished finished = flowcert(joined(options, {"--time", "0.1", "--out", scratch.path("timed")}));
  EXPECT_EQ(finished.status, 1) << finished.err;
  const json report = json::parse(finished.out);
  ASSERT_EQ(report.at("findings").size(), 1U) << report.at("findings");
  EXPECT_TRUE(report.at("findings")[0].at("not_fully_shrunk").is_null()) << report.at("findings");
  EXPECT_LE(report.at("findings")[0].at("points"), 4);
  EXPECT_GE(report.at("failing_cases"), 1);
  EXPECT_GT(report.at("seconds"), 0.1);
  const std::string file = report.at("findings")[0].at("file");
  EXPECT_TRUE(contains(content_of(file), "\n# shrunk: fully\n"));
}

TEST(FuzzFindings, TheFirstIsShrunkIfItComesAfterTheEnd) {
  const Scratch scratch;
  // The first answers take longer than the campaign has.
  const std::string calls = scratch.path("calls");
  const std::string slow = "echo >> " + calls + "; test $(wc -l < " + calls + ") -gt 3 || sleep 0.3; ";
  const Finished finished =
      flowcert({"fuzz", "--json", "--first", "--families", "box-corners", "--points", "4-4", "--jobs", "1", "--out",
                scratch.path("late"), "--against", slow + kPeer, "--time", "0.1"});
  const json report = json::parse(finished.out);
  for (const json& finding : report.at("findings")) {
    EXPECT_TRUE(finding.at("not_fully_shrunk").is_null()) << finding;
  }
  EXPECT_EQ(report.at("findings").size(), 1U) << report;
}

TEST(FuzzFindings, TheFirstIsTheOnlyOne) {
  const Scratch scratch;
  for (const char* jobs : {"1", "2"}) {
    const Finished finished =
        flowcert({"fuzz", "--first", "--jobs", jobs, "--through", kThrough, "--out", scratch.path(jobs)});
    EXPECT_EQ(finished.status, 1) << finished.err;
    EXPECT_EQ(times_in(finished.out, ".xyz\n"), 1U) << finished.out;
    EXPECT_TRUE(contains(finished.out, "1 finding\n")) << finished.out;
  }
  // Known ones do not count.
  const Finished known =
      flowcert({"fuzz", "--first", "--count", "40", "--families", "box-corners", "--mutants", "0", "--points", "4-4",
                "--through", kThrough, "--out", scratch.path("3"), "--known", scratch.path("1"), scratch.path("2")});
  EXPECT_LT(known.status, 2) << known.err;
}

// ---- Equal ones ----

TEST(FuzzFindings, ThoseWithTheSamePointsArePrintedOnce) {
  const Scratch scratch;
  const Words options = {"fuzz", "--count", "600", "--points", "3-4", "--families", "lattice-2", "--through", kThrough};
  const Finished first = flowcert(joined(options, {"--out", scratch.path("campaign")}));
  const Finished again = flowcert({"fuzz", "--resume", scratch.path("campaign"), "--through", kThrough, "--json"});
  std::map<std::pair<std::string, std::string>, int> times;  // by kind and sorted rows
  const json report = json::parse(again.out);
  for (const json& finding : report.at("findings")) {
    std::vector<std::string> rows;
    for (const std::string& line : lines_of(content_of(finding.at("file")))) {
      if (!line.starts_with("#")) rows.push_back(line);
    }
    std::ranges::sort(rows);
    std::string text;
    for (const std::string& row : rows) text += row + '\n';
    ++times[{finding.at("kind"), text}];
  }
  std::size_t all = 0;
  for (const auto& [finding, count] : times) all += static_cast<std::size_t>(count);
  ASSERT_GT(all, times.size());
  EXPECT_EQ(times_in(first.out, ".xyz\n"), times.size()) << first.out;
  EXPECT_TRUE(
      contains(first.out, "\n  " + std::to_string(all - times.size()) + " more with the same points as one above\n"))
      << first.out;
  EXPECT_TRUE(contains(first.out, "\n    (0, 0, 0) ")) << first.out;
}

// ---- Not fully shrunk ----

TEST(FuzzFindings, WhatIsNotFullyShrunkIsCalledSo) {
  const Scratch scratch;
  const Words options = {"fuzz", "--time", "0.3", "--families", "box-corners", "--against", "sleep 0.05; " + kPeer};
  const Finished text = flowcert(joined(options, {"--out", scratch.path("1")}));
  EXPECT_EQ(text.status, 1) << text.err;
  EXPECT_TRUE(contains(text.out, "\n    not fully shrunk: time was up\n")) << text.out;
  const Finished finished = flowcert(joined(options, {"--out", scratch.path("2"), "--json"}));
  const json report = json::parse(finished.out);
  ASSERT_EQ(report.at("findings").size(), 1U);
  const json& finding = report.at("findings")[0];
  EXPECT_EQ(finding.at("not_fully_shrunk"), "time was up");
  EXPECT_TRUE(
      contains(content_of(finding.at("file")), "\n# shrunk: not fully: the time was up, or the run was stopped\n"));
  // It has failed, though its batch is not done.
  EXPECT_EQ(report.at("failing_cases"), 1);
  EXPECT_EQ(report.at("kinds")[0].at("cases"), 1);
}

// ---- Numbers ----

TEST(FuzzFindings, OneIsSingular) {
  const Scratch scratch;
  const Finished one =
      flowcert({"fuzz", "--count", "1", "--points", "1-1", "--through", "true", "--out", scratch.path("1")});
  EXPECT_EQ(one.status, 1) << one.err;
  EXPECT_TRUE(contains(one.out, " of 1 point (")) << one.out;
  EXPECT_TRUE(contains(one.out, "case 0, 1 point\n")) << one.out;
  EXPECT_TRUE(contains(one.out, "  1 finding\n")) << one.out;
  EXPECT_TRUE(contains(one.out, "  1 case in ")) << one.out;
  EXPECT_FALSE(contains(one.out, " 1 cases")) << one.out;
}

}  // namespace
}  // namespace flowcert::conformance::fuzz_findings_test
