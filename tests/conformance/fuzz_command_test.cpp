// `flowcert fuzz` as a shell sees it: campaigns that are the same however they are run, that end cleanly and
// go on after any end, and that find what is wrong with another implementation and make it small.
//
// Guarantees: a campaign is interrupted when its files say that it is under way, not after some time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "fuzz/inputs/large_family.h"
#include "tests/cites.h"
#include "tests/conformance/campaign_account.h"
#include "tests/conformance/case_texts.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::fuzz_command_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> fuzz(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"fuzz", "--json"});
  return arguments;
}

json campaign(const std::vector<std::string>& arguments, int status = 0) {
  const Finished finished = flowcert(fuzz(arguments));
  EXPECT_EQ(finished.status, status) << finished.err;
  EXPECT_EQ(finished.err, "");
  return account_of(finished);
}

std::string peer(const std::string& how) { return std::string(FLOWCERT_PEER) + " {in} {out} " + how; }

TEST(FuzzCommand, ListsFamiliesWithASentenceEach) {
  const Finished finished = flowcert({"fuzz", "--families", "list"});
  EXPECT_EQ(finished.status, 0);
  // A long sentence goes on in the next line, below its beginning.
  std::size_t families = 0;
  for (const std::string& line : lines_of(finished.out)) {
    if (line.starts_with("   ")) continue;
    ++families;
    EXPECT_GE(line.size(), 40U) << line;
  }
  EXPECT_EQ(families, fuzz::named_families().size());
  EXPECT_NE(finished.out.find("box-corners"), std::string::npos);
}

TEST(FuzzCommand, HoldsAllPropertiesOnASmallCampaign) {
  CITES("FC-CRIT-05", "FC-FLOW-02", "FC-STAB-04", "FC-PERS-05", "FC-INV-01", "FC-CERT-03", "FC-CERT-06");
  const Scratch scratch;
  const json report =
      campaign({"--count", "600", "--seed", "5", "--points", "0-7", "--jobs", "2", "--out", scratch.path("campaign")});
  EXPECT_EQ(report.at("format"), "flowcert-fuzz-report");
  EXPECT_EQ(report.at("format_version"), 1);
  EXPECT_EQ(report.at("cases"), 600);
  EXPECT_EQ(report.at("failing_cases"), 0);
  EXPECT_GE(report.at("signatures"), 100);
  EXPECT_EQ(report.at("by_property").at("critical-points"), 600);
  EXPECT_EQ(report.at("by_property").at("orbit"), 600);
  for (const char* name : {"certificate", "unstable-manifolds", "stable-sets", "persistence", "orbit-kernels",
                           "unstable-kernels", "stable-kernels"}) {
    EXPECT_GE(report.at("by_property").at(name), 15) << name;
  }
  EXPECT_GE(report.at("by_family").at("mutant"), 100);
  EXPECT_GE(report.at("by_family").size(), 30U);
  // Most families reach most of what there is to reach.
  EXPECT_GE(report.at("reached").at("cluster").size(), 4U);
  EXPECT_GE(report.at("reached").at("polygon").size(), 3U);
  EXPECT_GE(report.at("reached").at("cascade").size(), 3U);
  EXPECT_FALSE(fs::exists(scratch.path("campaign") + "/findings"));
}

TEST(FuzzCommand, ProvesLargeInputsFromTheirCertificates) {
  CITES("FC-CERT-02", "FC-CERT-03", "FC-CERT-06");
  const Words plan{"--count", "4", "--families", "large"};
  const json report = campaign(joined(plan, {"--against", "self"}));
  EXPECT_EQ(report.at("by_property"), json({{"certificate", 4}}));
  EXPECT_EQ(report.at("failing_cases"), 0);
  EXPECT_EQ(campaign(joined(plan, {"--property", "certificate", "--jobs", "2"})), report);
  const Finished refused = flowcert(joined({"fuzz", "--property", "orbit"}, plan));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("only the property certificate"), std::string::npos) << refused.err;
}

TEST(FuzzCommand, IsTheSameWithAnyNumberOfJobsAndParts) {
  const Scratch scratch;
  const std::vector<std::string> plan{"--count",         "2500",     "--seed", "9", "--property",
                                      "critical-points", "--points", "0-5"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), plan.begin(), plan.end());
    return campaign(more);
  };
  const json whole = with({});
  EXPECT_EQ(whole.at("cases"), 2500);
  EXPECT_EQ(with({"--jobs", "3"}), whole);
  const std::string first = scratch.path("first");
  const std::string second = scratch.path("second");
  const json a = with({"--shard", "1/2", "--out", first});
  const json b = with({"--shard", "2/2", "--out", second});
  EXPECT_EQ(a.at("cases").get<int>() + b.at("cases").get<int>(), 2500);
  const Finished merged = flowcert({"fuzz", "merge", first, second, "--json", "--out", scratch.path("whole")});
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(account_of(merged), whole);
  // The merged campaign is a campaign like any other, and complete.
  EXPECT_EQ(account_of(flowcert({"fuzz", "--json", "--resume", scratch.path("whole")})), whole);
}

TEST(FuzzCommand, PartsOfOtherCampaignsAreRefused) {
  const Scratch scratch;
  (void)campaign({"--count", "10", "--out", scratch.path("a")});
  (void)campaign({"--count", "10", "--seed", "2", "--out", scratch.path("b")});
  const Finished finished = flowcert({"fuzz", "merge", scratch.path("a"), scratch.path("b")});
  EXPECT_EQ(finished.status, 2);
  EXPECT_NE(finished.err.find("another campaign"), std::string::npos) << finished.err;
}

class FuzzCommandInterrupted : public testing::TestWithParam<int> {};

TEST_P(FuzzCommandInterrupted, GoesOnToTheSameEnd) {
  const Scratch scratch;
  const std::string folder = scratch.path("campaign");
  const std::vector<std::string> plan{"--count",         "3500",     "--seed", "3", "--property",
                                      "critical-points", "--points", "3-5"};
  static const json uninterrupted = campaign(plan);
  auto start = fuzz(plan);
  start.insert(start.end(), {"--jobs", "2", "--out", folder});
  start.insert(start.begin(), FLOWCERT_PROGRAM);
  RunningProgram program(start);
  wait_for_a_batch(program, folder);
  program.signal(GetParam());
  const Finished finished = program.finish();
  if (GetParam() == SIGKILL) {
    EXPECT_EQ(finished.status, -SIGKILL);
  } else {
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_TRUE(json::parse(finished.out).at("interrupted"));
  }
  // Workers die with their parent, but not in the same instant.
  Finished resumed = flowcert(fuzz({"--resume", folder, "--jobs", "2"}));
  for (int k = 0; k < 50 && resumed.status == 2; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    resumed = flowcert(fuzz({"--resume", folder, "--jobs", "2"}));
  }
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(account_of(resumed), uninterrupted);
}

INSTANTIATE_TEST_SUITE_P(Signals, FuzzCommandInterrupted, testing::Values(SIGINT, SIGTERM, SIGKILL));

// The program is suspended, as by Ctrl-Z, for longer than a property may take.
TEST(FuzzCommand, IsNotMisledByBeingSuspended) {
  const Scratch scratch;
  auto start = fuzz({"--count", "8000", "--property", "critical-points", "--points", "3-5", "--jobs", "2", "--hang",
                     "1", "--out", scratch.path("campaign")});
  start.insert(start.begin(), FLOWCERT_PROGRAM);
  RunningProgram program(start);
  wait_for_a_batch(program, scratch.path("campaign"));
  ASSERT_FALSE(program.has_ended());
  program.signal_family(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  program.signal_family(SIGCONT);
  const Finished finished = program.finish();
  EXPECT_EQ(finished.status, 0) << finished.out;
  EXPECT_EQ(account_of(finished).at("cases"), 8000);
}

TEST(FuzzCommand, StopsWhenItsTimeIsOver) {
  const auto start = std::chrono::steady_clock::now();
  const json report = campaign({"--time", "1", "--property", "critical-points"});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_GT(report.at("cases"), 0);
}

// The point files of a campaign's findings. Each has a page beside it.
std::vector<std::string> point_files(const std::string& campaign) {
  std::vector<std::string> files;
  std::size_t pages = 0;
  for (const auto& entry : fs::directory_iterator(campaign + "/findings")) {
    if (entry.path().extension() == ".xyz") files.push_back(entry.path().string());
    pages += entry.path().extension() == ".html" ? 1 : 0;
  }
  EXPECT_EQ(pages, files.size());
  EXPECT_FALSE(files.empty());
  return files;
}

// The findings of a campaign against a program that gets cospherical points wrong.
TEST(FuzzCommand, FindsWhatIsWrongWithCosphericalPointsAndMakesItSmall) {
  CITES("FC-CLAIM-03");
  const Scratch scratch;
  const std::string folder = scratch.path("campaign");
  const json report = campaign({"--count", "300", "--against", peer("--strict"), "--jobs", "2", "--out", folder}, 1);
  EXPECT_GT(report.at("failing_cases"), 20);
  ASSERT_GE(report.at("findings").size(), 1U);
  bool is_cospherical = false;
  for (const json& finding : report.at("findings")) {
    EXPECT_LE(finding.at("points"), 6) << finding;
    is_cospherical = is_cospherical || finding.at("kind") == "missed-by-cluster";
  }
  EXPECT_TRUE(is_cospherical) << report.at("findings");
  // The case of each file is wrong again, and only with the command.
  for (const std::string& path : point_files(folder)) {
    const Finished again = flowcert({"fuzz", "--replay", path, "--against", peer("--strict")});
    EXPECT_EQ(again.status, 1) << path << again.err;
    EXPECT_EQ(flowcert({"fuzz", "--replay", path, "--property", "critical-points"}).status, 0) << path;
    EXPECT_EQ(flowcert({"compute", path}).status, 0) << path;
  }
}

// What is ignored is looked for no more, and what is known is no failure.
TEST(FuzzCommand, GoesOnBeyondWhatIsKnown) {
  CITES("FC-CLAIM-03");
  const Scratch scratch;
  const std::string folder = scratch.path("campaign"), cluster = "against missed-by-cluster";
  const Words command = {"--count", "60", "--against", peer("--strict")};
  const json all = campaign(joined(command, {"--out", folder}), 1);
  ASSERT_TRUE(all.at("failures").contains(cluster)) << all.at("failures");
  EXPECT_FALSE(all.contains("explained"));
  std::size_t cases = 0;
  for (const json& kind : all.at("kinds")) cases += kind.at("cases").get<std::size_t>();
  EXPECT_GE(cases, all.at("failing_cases"));
  for (std::size_t k = 1; k < all.at("kinds").size(); ++k) {
    EXPECT_GE(all.at("kinds")[k - 1].at("cases"), all.at("kinds")[k].at("cases"));
  }

  const json without = campaign(joined(command, {"--out", scratch.path("2"), "--ignore", "missed-by-cluster"}), 1);
  EXPECT_FALSE(without.at("failures").contains(cluster)) << without.at("failures");
  EXPECT_EQ(without.at("ignored"), json({"missed-by-cluster"}));
  // Going on means the same.
  const json more = campaign({"--resume", scratch.path("2"), "--count", "90", "--against", peer("--strict")}, 1);
  EXPECT_FALSE(more.at("failures").contains(cluster)) << more.at("failures");

  const json known = campaign(joined(command, {"--out", scratch.path("3"), "--known", folder}), 0);
  EXPECT_EQ(known.at("explained"), known.at("findings").size());
  EXPECT_EQ(known.at("failing_cases"), all.at("failing_cases"));
  EXPECT_TRUE(known.at("kinds")[0].at("explained"));
  // One file explains its own finding. What is new comes first.
  const std::string file = folder + "/findings/" + "against-missed-by-cluster-" +
                           std::to_string(all.at("failing").at(cluster)[0].get<std::size_t>()) + ".xyz";
  const json some = campaign({"--resume", folder, "--count", "60", "--known", file, "--against", peer("--strict")}, 1);
  EXPECT_EQ(some.at("explained"), 1);
  EXPECT_TRUE(some.at("kinds").back().at("explained")) << some.at("kinds");
  EXPECT_FALSE(some.at("kinds")[0].at("explained"));

  EXPECT_EQ(flowcert(joined({"fuzz", "--ignore", "misses"}, command)).status, 2);
  EXPECT_EQ(flowcert({"fuzz", "--count", "5", "--ignore", "missing"}).status, 2);
  const std::string plain = scratch.file("plain.xyz", "0 0 0\n");
  const Finished refused = flowcert(joined({"fuzz", "--known", plain}, command));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("does not say of which property and kind"), std::string::npos) << refused.err;
}

TEST(FuzzCommand, JudgesPersistencePairs) {
  CITES("FC-CLAIM-11");
  const Scratch scratch;
  const std::string right = std::string(FLOWCERT_PROGRAM) + " persistence {in} --json";
  const json report = campaign({"--count", "60", "--persistence-against", right, "--out", scratch.path("right")}, 0);
  EXPECT_EQ(report.at("by_property"), json({{"persistence-against", 60}}));
  // It loses the last pair.
  const std::string wrong = std::string(FLOWCERT_PROGRAM) + " persistence {in} -o - | sed '$d'; true";
  const std::string folder = scratch.path("wrong");
  const json lost = campaign({"--count", "20", "--persistence-against", wrong, "--out", folder}, 1);
  EXPECT_GT(lost.at("failures").at("persistence-against wrong-pair"), 5);
  for (const std::string& path : point_files(folder)) {
    EXPECT_EQ(flowcert({"fuzz", "--replay", path, "--persistence-against", wrong}).status, 1) << path;
    EXPECT_EQ(flowcert({"fuzz", "--replay", path, "--persistence-against", right}).status, 0) << path;
  }
}

TEST(FuzzCommand, DoesOneCaseAgain) {
  const Scratch scratch;
  const std::string folder = scratch.path("campaign");
  const json report = campaign({"--count", "120", "--against", peer("--strict"), "--jobs", "2", "--out", folder}, 1);
  const auto& numbers = report.at("failing").at("against missed-by-cluster");
  EXPECT_EQ(report.at("failures").at("against missed-by-cluster"), numbers.size());
  ASSERT_GT(numbers.size(), 5U);
  const std::string last = std::to_string(numbers.back().get<std::size_t>());
  const Finished again = flowcert({"fuzz", "--resume", folder, "--case", last, "--against", peer("--strict")});
  EXPECT_EQ(again.status, 1) << again.err;
  const std::string file = folder + "/findings/against-missed-by-cluster-" + last + ".xyz";
  EXPECT_NE(again.out.find(file), std::string::npos) << again.out;
  EXPECT_EQ(flowcert({"fuzz", "--replay", file, "--against", peer("--strict")}).status, 1);
  EXPECT_EQ(flowcert({"fuzz", "--resume", folder, "--case", "120", "--against", peer("--strict")}).status, 2);
  EXPECT_EQ(flowcert({"fuzz", "--case", "18446744073709551615"}).status, 2);
  // Without a folder the merged campaign has nowhere to put its files.
  const Finished merged = flowcert({"fuzz", "merge", folder});
  EXPECT_EQ(merged.status, 1) << merged.err;
  const Finished right = flowcert({"fuzz", "--case", "7", "--property", "critical-points", "--json"});
  EXPECT_EQ(right.status, 0) << right.err;
  const json case_report = json::parse(right.out);
  EXPECT_EQ(case_report.at("format"), "flowcert-fuzz-case");
  EXPECT_EQ(case_report.at("case"), 7);
  EXPECT_EQ(case_report.at("findings"), json::array());
}

// Whether a process has these words in its command line.
bool is_running(const std::string& words) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    std::string line((std::istreambuf_iterator<char>(file)), {});
    std::replace(line.begin(), line.end(), '\0', ' ');
    if (line.find(words) == 0) return true;
  }
  return false;
}

TEST(FuzzCommand, LeavesNoCommandWhenItIsKilled) {
  const Scratch scratch;
  const std::string sleep = "sleep " + std::to_string(100'000 + ::getpid());
  // The first run tells whether the command can be started.
  const std::string command = "echo {in} >> '" + scratch.path("runs") + "'; test $(wc -l < '" + scratch.path("runs") +
                              "') = 1 || { " + sleep + " & " + sleep + "; }";
  // The killed program leaves its temporary folder here.
  fs::create_directory(scratch.path("temporary"));
  RunningProgram program({"/usr/bin/env", "TMPDIR=" + scratch.path("temporary"), FLOWCERT_PROGRAM, "fuzz", "--count",
                          "10", "--time-limit", "600", "--against", command, "--out", scratch.path("campaign")});
  for (int k = 0; k < 1000 && !is_running(sleep); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(is_running(sleep));
  program.signal(SIGKILL);
  (void)program.finish();
  for (int k = 0; k < 1000 && is_running(sleep); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(is_running(sleep));
}

TEST(FuzzCommand, OurOwnClaimsAreRight) {
  const json report = campaign(
      {"--count", "200", "--against", std::string(FLOWCERT_PROGRAM) + " compute {in} -o {out}", "--jobs", "2"});
  EXPECT_EQ(report.at("failing_cases"), 0);
  EXPECT_EQ(report.at("by_property").at("against"), 200);
}

// The option that says what the program does with six rows and more, and the kind of the finding.
class FuzzCommandEndings : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(FuzzCommandEndings, AreFindings) {
  const Scratch scratch;
  const auto& [how, kind] = GetParam();
  const json report = campaign({"--count", "12", "--against", peer(how), "--points", "5-7", "--mutants", "0",
                                "--time-limit", "0.3", "--out", scratch.path("campaign")},
                               1);
  bool is_found = false;
  for (const json& finding : report.at("findings")) {
    if (finding.at("kind") != kind) continue;
    is_found = true;
    EXPECT_EQ(finding.at("points"), 6);
  }
  EXPECT_TRUE(is_found) << report.at("findings");
}

INSTANTIATE_TEST_SUITE_P(All, FuzzCommandEndings,
                         testing::Values(std::pair("--crash 6", "signal"), std::pair("--hang 6", "time-limit"),
                                         std::pair("--refuse 6", "refusal")));

TEST(FuzzCommand, ReplaysAnyPointFile) {
  const Scratch scratch;
  const std::string square = scratch.file("square.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const Finished finished = flowcert({"fuzz", "--replay", square});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(lines_of(finished.out).size(), 9U) << finished.out;
  EXPECT_EQ(flowcert({"fuzz", "--replay", scratch.file("bad.xyz", "0 0 0\n1 0\n")}).status, 2);
  EXPECT_EQ(flowcert({"fuzz", "--replay", scratch.path("none.xyz")}).status, 2);
}

TEST(FuzzCommand, BeginsWithACorpus) {
  const Scratch scratch;
  fs::create_directory(scratch.path("corpus"));
  (void)scratch.file("corpus/square.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  const json with = campaign({"--count", "50", "--corpus", scratch.path("corpus"), "--mutants", "100"});
  EXPECT_EQ(with.at("by_family").at("mutant"), 50);
  (void)scratch.file("corpus/bad.xyz", "0 0\n");
  const Finished bad = flowcert({"fuzz", "--count", "50", "--corpus", scratch.path("corpus")});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("bad.xyz:1:"), std::string::npos) << bad.err;
}

TEST(FuzzCommand, AsksNobodyAboutNoPoints) {
  const Scratch scratch;
  const json report = campaign({"--count", "20", "--against", "exit 3; {in}", "--out", scratch.path("campaign")}, 1);
  for (const json& finding : report.at("findings")) EXPECT_EQ(finding.at("points"), 1);
}

TEST(FuzzCommand, SaysWhatToDoAboutFindingsOfAnEarlierCampaign) {
  const Scratch scratch;
  const auto run = [&](const std::string& options) {
    return RunningProgram({"/bin/sh", "-c",
                           "cd \"$1\" && exec \"$0\" fuzz --seed 9 --count 2 --against 'exit 3 # {in}' " + options,
                           FLOWCERT_PROGRAM, scratch.path("")})
        .finish();
  };
  EXPECT_EQ(run("").status, 1);
  const Finished again = run("");
  EXPECT_EQ(again.status, 2);
  EXPECT_EQ(
      again.err,
      "flowcert: flowcert-fuzz-9: there are findings of an earlier campaign; --out flowcert-fuzz-9-2 begins another\n");
  EXPECT_EQ(run("--out campaign").status, 1);
  EXPECT_EQ(
      run("--out campaign").err,
      "flowcert: campaign: there is a campaign already; --resume campaign goes on with it, --out campaign-2 begins "
      "another\n");
  EXPECT_EQ(run("--out campaign-2").status, 1);
  EXPECT_TRUE(contains(run("--out campaign/").err, "--out campaign-3 begins another\n"));
  EXPECT_TRUE(contains(run("--out campaign-2").err, "--out campaign-3 begins another\n"));
  fs::create_directory(scratch.path("my own"));
  (void)scratch.file("my own/notes", "");
  EXPECT_EQ(run("--out 'my own'").err, "flowcert: my own: it is no empty folder; --out 'my own-2' begins a campaign\n");
  EXPECT_NE(content_of(FLOWCERT_FUZZ_README).find("`flowcert-fuzz-SEED`"), std::string::npos);
}

TEST(FuzzCommand, RefusesFoldersThatDoNotFit) {
  const Scratch scratch;
  fs::create_directory(scratch.path("full"));
  (void)scratch.file("full/batches.jsonl", "");
  const std::string timed = scratch.path("timed");
  (void)campaign({"--time", "0.2", "--points", "1-3", "--out", timed});
  const std::string done = scratch.path("done");
  (void)campaign({"--count", "50", "--points", "1-3", "--out", done});
  const std::string damaged = scratch.path("damaged");
  fs::copy(done, damaged);
  (void)scratch.file("damaged/plan.json", R"({"cases":-1,"plan":""})");
  const std::vector<std::vector<std::string>> wrong = {
      {"fuzz", "--count", "10", "--out", scratch.path("full")},
      {"fuzz", "--resume", timed},
      {"fuzz", "--resume", done, "--count", "20"},
      {"fuzz", "--resume", damaged},
      {"fuzz", "--replay", scratch.path("full")},
      {"fuzz", "--count", "5", "--against", "/no/such {in}", "--out", scratch.path("new")},
  };
  for (const auto& words : wrong) {
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2) << words.at(2) << finished.out;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << words.at(2) << finished.err;
  }
  EXPECT_FALSE(fs::exists(scratch.path("new")));
  EXPECT_FALSE(fs::exists(scratch.path("full") + "/plan.json"));
}

TEST(FuzzCommand, RefusesWhatItCannotUse) {
  const Scratch scratch;
  const std::vector<std::vector<std::string>> wrong = {
      {"fuzz"},
      {"fuzz", "--count", "0"},
      {"fuzz", "--count", "10", "--families", "no-such"},
      {"fuzz", "--count", "10", "--points", "8-4"},
      {"fuzz", "--count", "10", "--points", "4-13"},
      {"fuzz", "--count", "10", "--property", "no-such"},
      {"fuzz", "--count", "10", "--shard", "3/2"},
      {"fuzz", "--count", "10", "--shard", "0/2"},
      {"fuzz", "--time", "nan"},
      {"fuzz", "--count", "10", "--jobs", "0"},
      {"fuzz", "--count", "10", "--against", "true"},
      {"fuzz", "--count", "10", "--against", "/no/such/program {in}"},
      {"fuzz", "--count", "10", "--out", "/proc/none"},
      {"fuzz", "--resume", scratch.path("none")},
      {"fuzz", "--resume", scratch.path("none"), "--seed", "2"},
      {"fuzz", "--count", "10", "--corpus", scratch.path("none")},
      {"fuzz", "merge"},
      {"fuzz", "merge", scratch.path("none")},
  };
  for (const auto& words : wrong) {
    const Finished finished = flowcert(words);
    std::string line;
    for (const std::string& word : words) line += word + ' ';
    EXPECT_EQ(finished.status, 2) << line;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << line << finished.err;
    EXPECT_EQ(finished.out, "") << line;
  }
}

}  // namespace
}  // namespace flowcert::conformance::fuzz_command_test
