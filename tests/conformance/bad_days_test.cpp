// Systems that fail around a command, and options that ask for too much: standard error that cannot be written, outputs
// that would destroy an input, limits, folders that are not there, plans that somebody else wrote.
//
// Guarantees: each is tried as a shell does it. A command's status and outputs are those of a good day, or its status
// is 2 with one line.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/conformance/case_texts.h"
#include "tests/conformance/conformance_fixture.h"
#include "tests/conformance/program_run.h"
#include "tests/hostile_text.h"

namespace flowcert::conformance::bad_days_test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr char kSquare[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

// `line` in /bin/sh, which has the program as $0 and the folder as $1.
Finished shell(const std::string& line, const Scratch& scratch) {
  return RunningProgram({"/bin/sh", "-c", line, FLOWCERT_PROGRAM, scratch.path("")}).finish();
}

void expect_one_line(const Finished& finished, const std::string& part) {
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  EXPECT_NE(finished.err.find(part), std::string::npos) << finished.err;
}

// ---- Standard error ----

TEST(Diagnostics, ThatCannotBeWrittenChangeNothing) {
  const Scratch scratch;
  // It gets a note and a warning.
  const std::string input = scratch.file("a.xyz", "0 0 0 1\n0 0 0 1\n1 0 0 1\n0 1 0 1\n");
  const Finished good = shell("exec \"$0\" compute \"$1/a.xyz\" -o \"$1/good.jsonl\" --json", scratch);
  ASSERT_EQ(good.status, 0);
  ASSERT_EQ(std::count(good.err.begin(), good.err.end(), '\n'), 2) << good.err;
  const std::string records = content_of(scratch.path("good.jsonl"));
  const char* const ways[] = {"2>/dev/full", "2>&-", "2>/dev/full 3>&-", "0<&- 2>&-"};
  for (const std::string way : ways) {
    SCOPED_TRACE(way);
    fs::remove(scratch.path("out.jsonl"));
    const Finished bad = shell("exec \"$0\" compute \"$1/a.xyz\" -o \"$1/out.jsonl\" --json " + way, scratch);
    EXPECT_EQ(bad.status, 0);
    EXPECT_EQ(nlohmann::json::parse(bad.out)["critical"], nlohmann::json::parse(good.out)["critical"]);
    EXPECT_EQ(content_of(scratch.path("out.jsonl")), records);
    EXPECT_EQ(shell("exec \"$0\" compute \"$1/none.xyz\" " + way, scratch).status, 2);
    EXPECT_EQ(shell("exec \"$0\" compute --nonsense " + way, scratch).status, 2);
  }
  // Nobody reads it: the pipe is closed before the program writes.
  const Finished piped = shell(
      "{ { sleep 0.2; \"$0\" compute \"$1/a.xyz\" -o \"$1/out.jsonl\" 2>&3; echo $? >\"$1/status\"; } 3>&1 >/dev/null; "
      "} "
      "| true",
      scratch);
  for (int k = 0; k < 100 && content_of(scratch.path("status")).empty(); ++k) ::usleep(50'000);
  EXPECT_EQ(content_of(scratch.path("status")), "0\n");
}

TEST(Diagnostics, AClosedStandardOutputIsToldAndIsNoFile) {
  const Scratch scratch;
  (void)scratch.file("a.xyz", kSquare);
  expect_one_line(shell("exec \"$0\" compute \"$1/a.xyz\" >&-", scratch), "standard output cannot be written");
  const Finished finished = shell("exec \"$0\" compute \"$1/a.xyz\" -o \"$1/out.jsonl\" >&- 2>&-", scratch);
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(content_of(scratch.path("out.jsonl")).find("flowcert: "), std::string::npos);
  expect_one_line(shell("exec \"$0\" compute - <&-", scratch), "cannot read");
}

// ---- Text of strangers ----

TEST(HostileText, OfAClaimReachesNoTerminal) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kSquare);
  for (const std::string& text : flowcert_tests::hostile_texts()) {
    const std::string quoted = nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    const std::string claim = scratch.file(
        "claim.jsonl", "{\"format\":\"flowcert-stationary-points\",\"format_version\":1," + quoted +
                           ":0}\n{\"index\":0,\"contact\":[0]," + quoted + ":1,\"kind\":" + quoted + "}\n");
    const std::string other =
        scratch.file("other.jsonl", "{\"format\":\"flowcert-stationary-points\",\"format_version\":1," + quoted +
                                        ":0}\n{\"index\":0,\"contact\":[0]," + quoted + ":1}\n");
    const std::string raw = scratch.file("raw.xyz", text + "\n");
    for (const Words& command : {Words{"check", input, claim}, Words{"check", input, other}, Words{"check", input, raw},
                                 Words{"compute", raw}, Words{"compute", text}, Words{text}}) {
      const Finished finished = flowcert(command);
      EXPECT_GE(finished.status, 0);
      for (const std::string& line : lines_of(finished.out + finished.err)) {
        EXPECT_TRUE(flowcert_tests::is_harmless(line)) << testing::PrintToString(command) << line;
        EXPECT_FALSE(line.starts_with("flowcert: conforms")) << line;
      }
    }
  }
}

void expect_harmless(const Finished& finished, const std::string& what) {
  EXPECT_GE(finished.status, 0) << what;
  for (const std::string& line : lines_of(finished.out + finished.err)) {
    EXPECT_TRUE(flowcert_tests::is_harmless(line)) << what << ": " << line;
    EXPECT_FALSE(line.starts_with("flowcert: conforms")) << what << ": " << line;
  }
}

TEST(HostileText, IsHarmlessInReportsForPrograms) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kSquare), report = scratch.path("report.xml");
  const std::string id = ids_of(generated({"--cases", "1"})).front();
  for (const std::string& text : flowcert_tests::hostile_texts()) {
    const std::string quoted = nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    const std::string raw = nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    for (const std::string& key : {quoted, raw}) {
      const std::string claim =
          scratch.file("claim.jsonl", "{\"format\":\"flowcert-stationary-points\",\"format_version\":1," + key +
                                          ":0}\n{\"index\":0,\"contact\":[0]," + key + ":1}\n");
      const Finished checked = flowcert({"check", input, claim, "--json", "--junit", report});
      expect_harmless(checked, "check --json");
      EXPECT_FALSE(nlohmann::json::parse(checked.out)["not_judged"].empty());
      for (const std::string& line : lines_of(content_of(report)))
        EXPECT_TRUE(flowcert_tests::is_harmless(line)) << line;
    }
    std::string one_line = text;
    std::erase(one_line, '\n');
    const std::string answers[] = {"refused " + id + " " + one_line + "\n", "answer " + id + "\n" + text + "\nend\n",
                                   "answer " + one_line + "\nend\n", text + "\n"};
    for (const std::string& answer : answers) {
      const std::string file = scratch.file("answers", answer);
      for (const Words& options : {Words{}, Words{"--json"}, Words{"--junit", report}, Words{"--persistence"}}) {
        expect_harmless(flowcert(joined({"verify", "--cases", "1"}, options), {file, ""}), "verify");
      }
    }
  }
}

TEST(HostileText, IsHarmlessInNamesOfFilesAndPrograms) {
  const FewVectors few;
  const Scratch scratch;
  std::size_t programs = 0;
  for (const std::string& text : flowcert_tests::hostile_texts()) {
    const std::string name = text.substr(0, text.find('\0'));
    if (name.find('/') != std::string::npos) continue;
    const std::string input = scratch.file(name, kSquare), claim = scratch.file("c" + name, "0,0,0,0,0,0\n");
    const Words commands[] = {{"compute", input},
                              {"compute", input, "--json"},
                              {"check", input, claim},
                              {"stats", input},
                              {"check", input, claim, "--json"},
                              {"persistence", claim},
                              {"medial", input},
                              {"pockets", input},
                              {"pores", input, "--radii", "1/4"},
                              {"explain", input, "--ids", "0"}};
    for (const Words& command : commands) expect_harmless(flowcert(command), testing::PrintToString(command));
    // A program takes a while to start, so few of the texts are names and answers of programs.
    if (++programs % 8 != 0) continue;
    const std::string program = scratch.file("p" + name, "#!/bin/sh\ncat \"$0\" >\"$2\"\ncat \"$0\" >&2\n# " + text);
    fs::permissions(program, fs::perms::owner_all);
    for (const Words& form : {Words{}, Words{"--json"}}) {
      const Words run = {"conformance",
                         "--vectors",
                         few.folder(),
                         "--group",
                         "flat-inputs",
                         "--against",
                         "'" + program + "' {in} {out}"};
      expect_harmless(flowcert(joined(run, form)), "conformance");
    }
  }
  EXPECT_GE(programs, 32U);
}

// ---- Outputs ----

TEST(Outputs, NoneReplacesAnInput) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kSquare), other = scratch.file("b.xyz", "0.5 0.5 0\n");
  const std::string claim = scratch.file("claim.csv", "index,x,y,z\n0,0,0,0\n");
  ASSERT_EQ(::link(input.c_str(), scratch.path("hard.xyz").c_str()), 0);
  ASSERT_EQ(::symlink("a.xyz", scratch.path("soft.xyz").c_str()), 0);
  const Words commands[] = {{"compute", input, "-o", input},
                            {"compute", input, "-o", scratch.path("hard.xyz")},
                            {"compute", input, "-o", scratch.path("soft.xyz")},
                            {"compute", scratch.path("soft.xyz"), "-o", input},
                            {"persistence", input, "-o", input},
                            {"locate", input, other, "-o", other},
                            {"locate", input, other, "-o", input},
                            {"view", input, "-o", input},
                            {"surface", input, "-o", scratch.path("./a.xyz")},
                            {"stats", input, "--svg", input},
                            {"check", input, claim, "--junit", claim},
                            {"check", input, claim, "--junit", input}};
  for (const Words& command : commands) {
    SCOPED_TRACE(testing::PrintToString(command));
    const Finished finished = flowcert(command);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(content_of(input), kSquare);
    EXPECT_EQ(content_of(other), "0.5 0.5 0\n");
    EXPECT_EQ(content_of(claim), "index,x,y,z\n0,0,0,0\n");
  }
  expect_one_line(shell("exec \"$0\" compute - -o \"$1/a.xyz\" <\"$1/a.xyz\"", scratch), "it is an input of this run");
  EXPECT_EQ(content_of(input), kSquare);
  const std::set<std::string> files = {"a.xyz", "b.xyz", "claim.csv", "hard.xyz", "soft.xyz"};
  EXPECT_EQ(scratch.names(), files);
}

TEST(Outputs, FollowLinksAndKeepModes) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kSquare);
  fs::create_directory(scratch.path("folder"));
  (void)scratch.file("folder/old.jsonl", "old");
  ASSERT_EQ(::chmod(scratch.path("folder/old.jsonl").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("folder/old.jsonl", scratch.path("link").c_str()), 0);
  ASSERT_EQ(::symlink("link", scratch.path("link to link").c_str()), 0);
  ASSERT_EQ(::symlink("folder/new.jsonl", scratch.path("to nothing").c_str()), 0);
  ASSERT_EQ(flowcert({"compute", input, "-o", scratch.path("right.jsonl")}).status, 0);
  const std::string right = content_of(scratch.path("right.jsonl"));
  EXPECT_EQ(flowcert({"compute", input, "-o", scratch.path("link to link")}).status, 0);
  EXPECT_EQ(flowcert({"compute", input, "-o", scratch.path("to nothing")}).status, 0);
  for (const char* link : {"link", "link to link", "to nothing"}) EXPECT_TRUE(fs::is_symlink(scratch.path(link)));
  EXPECT_EQ(content_of(scratch.path("folder/old.jsonl")), right);
  EXPECT_EQ(content_of(scratch.path("folder/new.jsonl")), right);
  struct stat status{};
  ASSERT_EQ(::stat(scratch.path("folder/old.jsonl").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
  // A loop is an error, and nothing hangs.
  ASSERT_EQ(::symlink("loop", scratch.path("loop").c_str()), 0);
  EXPECT_EQ(flowcert({"compute", input, "-o", scratch.path("loop")}).status, 2);
  EXPECT_TRUE(fs::is_symlink(scratch.path("loop")));
}

TEST(Outputs, ALimitOfSizeIsToldAndLeavesNothing) {
  const Scratch scratch;
  (void)scratch.file("a.xyz", kSquare);
  // An instrumented program says of its counts, too, that they cannot be written.
  expect_one_line(shell("(ulimit -f 0; GCOV_ERROR_FILE=/dev/null exec \"$0\" compute \"$1/a.xyz\" "
                        "-o \"$1/out.jsonl\" 2>&1 >/dev/null) | cat >&2; exit 2",
                        scratch),
                  "File too large");
  EXPECT_EQ(scratch.names(), std::set<std::string>{"a.xyz"});
}

// ---- Options ----

TEST(Options, ThatAskForTooMuchAreErrors) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kSquare), records = scratch.path("a.jsonl");
  ASSERT_EQ(flowcert({"compute", input, "-o", records}).status, 0);
  for (const char* sample : {"-1", "0", "100000000000000000000", "x"}) {
    expect_one_line(flowcert_oracle({"certify", input, records, "--sample", sample}), "--sample");
  }
  EXPECT_EQ(flowcert_oracle({"certify", input, records, "--sample", "4000000000000000000"}).status, 0);
  const Finished all = flowcert({"surface", input, "--select", "persistence>-1", "-o", scratch.path("s.ply")});
  EXPECT_EQ(all.status, 0) << all.err;
  expect_one_line(shell("TMPDIR=/nonexistent exec \"$0\" conformance --group rounding --against 'true {in}'", scratch),
                  "TMPDIR is '/nonexistent'");
}

// ---- Plans of others ----

TEST(Resume, RunsNoCommandThatNobodySaid) {
  const Scratch scratch;
  const std::string mark = scratch.path("mark"), folder = scratch.path("campaign");
  const std::string program = scratch.file("peer", "#!/bin/sh\ntouch " + mark + "\nexit 1\n");
  fs::permissions(program, fs::perms::owner_all);
  const std::string command = program + " {in} {out}";
  (void)flowcert({"fuzz", "--count", "4", "--against", command, "--out", folder});
  ASSERT_TRUE(fs::exists(folder + "/plan.json"));
  fs::remove(mark);
  const Words resume = {"fuzz", "--resume", folder, "--count", "8"};
  const auto with = [&](const Words& more) {
    Words all = resume;
    all.insert(all.end(), more.begin(), more.end());
    return flowcert(all);
  };
  const Finished refused = with({});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find(command), std::string::npos) << refused.err;
  expect_one_line(with({"--against", "another {in} {out}"}), "another one");
  expect_one_line(with({"--persistence-against", command}), "another one");
  EXPECT_FALSE(fs::exists(mark));
  EXPECT_NE(with({"--against", command}).status, 2);
  EXPECT_TRUE(fs::exists(mark));
}

}  // namespace
}  // namespace flowcert::conformance::bad_days_test
