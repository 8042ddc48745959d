// What the programs say of themselves: one screen for those who ask for nothing, and help that begins with examples
// which can be copied and run.
//
// Guarantees: commands and examples are taken from the help itself, so a new one is looked at, too. Each example is run
// by a shell, in a folder where the files that examples name exist, small ones. Long campaigns are made short; nothing
// else of an example is changed.
#include "tests/conformance/help_text.h"

#include <gtest/gtest.h>

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance::help_text_test {
namespace {

using Words = std::vector<std::string>;

const std::string kOracle = "flowcert-oracle";

Finished run_program(const std::string& program, Words words) {
  words.insert(words.begin(), program == kOracle ? FLOWCERT_ORACLE_PROGRAM : FLOWCERT_PROGRAM);
  return RunningProgram(words).finish();
}

// All command lines that have a help, "flowcert fuzz merge" among them.
std::vector<Words> all_commands() {
  std::vector<Words> all;
  for (const std::string& program : {std::string("flowcert"), kOracle}) {
    all.push_back({program});
    for (const std::string& command : commands_in(run_program(program, {"--help"}).out)) {
      all.push_back({program, command});
      for (const std::string& below : commands_in(run_program(program, {command, "--help"}).out)) {
        all.push_back({program, command, below});
      }
    }
  }
  return all;
}

std::string help_of(const Words& command) {
  Words words(command.begin() + 1, command.end());
  words.emplace_back("--help");
  const Finished finished = run_program(command[0], words);
  EXPECT_EQ(finished.status, 0);
  return finished.out;
}

TEST(HelpText, NothingAskedForIsOneScreen) {
  const Finished finished = flowcert({});
  EXPECT_EQ(finished.status, 2) << "nothing was judged, so it is not that of a right answer";
  EXPECT_EQ(finished.err, "");
  const Words lines = lines_of(finished.out);
  EXPECT_LE(lines.size(), 24U) << finished.out;
  for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
  // A command that is in no group of main.cpp is in CLI11's own, whose name depends on its version.
  EXPECT_FALSE(boost::algorithm::icontains(finished.out, "subcommands")) << finished.out;
  std::size_t shown = 0;
  for (const std::string& command : commands_in(flowcert({"--help"}).out)) {
    const bool sets_up_a_shell = command == "completion" || command == "manual";
    const bool is_shown = finished.out.find("\n  " + command + " ") != std::string::npos;
    EXPECT_NE(is_shown, sets_up_a_shell) << command;
    shown += is_shown ? 1 : 0;
  }
  EXPECT_GE(shown, 11U);
  const Words examples = examples_in(flowcert({"--help"}).out);
  EXPECT_EQ(examples.size(), 2U);
  EXPECT_TRUE(finished.out.ends_with("\n  " + examples.front() + '\n')) << finished.out;
}

TEST(HelpText, TheOracleSaysWhatItCanDo) {
  const Finished finished = flowcert_oracle({});
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.err, "");
  EXPECT_EQ(finished.out, flowcert_oracle({"--help"}).out);
  EXPECT_LE(lines_of(finished.out).size(), 24U);
}

TEST(HelpText, BeginsWithTwoExamples) {
  const std::vector<Words> commands = all_commands();
  EXPECT_GE(commands.size(), 19U);
  for (const Words& command : commands) {
    SCOPED_TRACE(::testing::PrintToString(command));
    const Words lines = lines_of(help_of(command));
    ASSERT_GE(lines.size(), 6U);
    EXPECT_FALSE(lines[0].empty());
    EXPECT_TRUE(lines[1].starts_with("Usage: " + command[0])) << lines[1];
    EXPECT_EQ(lines[3], "Examples:");
    EXPECT_TRUE(lines[4].starts_with("  " + command[0] + ' ')) << lines[4];
    std::size_t examples = 0, at = 4;
    for (; at < lines.size() && !lines[at].empty(); ++at) examples += lines[at].starts_with("    ") ? 0 : 1;
    EXPECT_EQ(examples, 2U);
    EXPECT_NE(lines.back(), "");
    const std::string path = boost::algorithm::join(command, " ");
    for (const std::string& example : examples_in(help_of(command))) {
      EXPECT_NE(example.find(path), std::string::npos) << example;
    }
  }
}

// ---- Examples run ----

// The folder in which the examples run.
class ExampleFolder {
 public:
  ExampleFolder() {
    std::mt19937 random(3);
    std::string rows, vertices;
    for (int k = 0; k < 40; ++k) {
      std::string row;
      for (int axis = 0; axis < 3; ++axis) row += ' ' + std::to_string(static_cast<double>(random() % 1000) / 500);
      rows += row.substr(1) + '\n';
      vertices += 'v' + row + '\n';
    }
    (void)scratch_.file("bunny.obj", vertices);
    (void)scratch_.file("bunny.xyz", rows);
    (void)scratch_.file("protein.pdb", content_of(std::string(FLOWCERT_USER_INPUTS) + "/barrel.pdb"));
    (void)scratch_.file("cage.xyz", content_of(std::string(FLOWCERT_USER_INPUTS) + "/cage.xyz"));
    (void)scratch_.file("diameters.txt", "cavity 5.397020\nwindow 3.628998\n");
    (void)scratch_.file("cage.balls", "2 2 2 1\n2 -2 -2 1\n-2 2 -2 1\n-2 -2 2 1\n");
    (void)scratch_.file("probes.xyz", rows);
    (void)scratch_.file("cube.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n");
    make_claims();
    make_program("my-flow", "exec flowcert compute \"$1\" -o \"$2\"");
    make_program("your-program", "exec " FLOWCERT_MIDDLE " exchange");
    make_program("your-diagrams", "exec " FLOWCERT_MIDDLE " pairs");
    std::filesystem::create_directory(scratch_.path("findings"));
    std::filesystem::create_directory(scratch_.path("bin"));
    std::filesystem::create_symlink(FLOWCERT_PROGRAM, scratch_.path("bin/flowcert"));
    std::filesystem::create_symlink(FLOWCERT_ORACLE_PROGRAM, scratch_.path("bin/flowcert-oracle"));
  }

  [[nodiscard]] Finished run(const std::string& example) const {
    const std::string setting = "cd '" + scratch_.path("") + "' && PATH=\"$PWD/bin:$PATH\" && ";
    return RunningProgram({"/bin/sh", "-c", setting + example}).finish();
  }

 private:
  void make_program(const std::string& name, const std::string& command) const {
    std::filesystem::permissions(scratch_.file(name, "#!/bin/sh\n" + command + '\n'),
                                 std::filesystem::perms::owner_all);
  }

  void make_claims() const {
    for (const char* name : {"bunny", "cube"}) {
      const std::string path = scratch_.path(name);
      ASSERT_EQ(flowcert({"compute", path + ".xyz", "-o", path + ".jsonl"}).status, 0);
      (void)scratch_.file(std::string(name) + ".json", flowcert({"cycles", path + ".xyz", "--witness", "--json"}).out);
    }
    std::filesystem::copy(scratch_.path("bunny.jsonl"), scratch_.path("claim.jsonl"));
    std::string all, saddles;
    const Words records = lines_of(content_of(scratch_.path("bunny.jsonl")));
    for (std::size_t k = 1; k < records.size(); ++k) {
      const auto record = nlohmann::json::parse(records[k]);
      std::string row = record.at("index").dump();
      for (const auto& coordinate : record.at("center_double")) row += ',' + coordinate.dump();
      all += row + '\n';
      if (record.at("index") != 0) saddles += row + '\n';
    }
    (void)scratch_.file("claim.csv", all);
    (void)scratch_.file("saddles.csv", saddles);
  }

  Scratch scratch_;
};

// Campaigns of a minute are of a second, and an example of all vectors is of a few. A manual page is not shown.
std::string shortened(std::string example) {
  const std::pair<const char*, const char*> words[] = {{"--time 60", "--time 1"},
                                                       {"--count 1000000", "--count 40"},
                                                       {"--count 100000", "--count 40"},
                                                       {"--case 4711", "--case 11"},
                                                       {"man -l -", "cat"},
                                                       {" --level 1", " --cases 40"}};
  for (const auto& [word, shorter] : words) boost::algorithm::replace_all(example, word, shorter);
  const bool is_of_all_vectors =
      example.starts_with("flowcert conformance") && example.find("--group") == std::string::npos;
  return is_of_all_vectors && example.find("--list") == std::string::npos ? example + " --group rounding" : example;
}

TEST(HelpText, ExamplesRun) {
  std::size_t run = 0;
  for (const Words& command : all_commands()) {
    const ExampleFolder folder;
    if (command.back() == "merge") {
      for (const char* part : {"1", "2"}) {
        const std::string shard = std::string("--shard ") + part + "/2 --out part-" + part;
        EXPECT_EQ(folder.run("flowcert fuzz --count 40 " + shard).status, 0);
      }
    }
    for (const std::string& example : examples_in(help_of(command))) {
      const std::string line = shortened(example);
      const Finished finished = folder.run(line);
      // explain says by its status whether a point is stationary.
      const bool is_verdict = command.back() == "explain" && finished.status == 1;
      EXPECT_TRUE(finished.status == 0 || is_verdict) << line << '\n'
                                                      << finished.status << finished.out << finished.err;
      EXPECT_EQ(finished.err.find("flowcert"), std::string::npos) << line << '\n' << finished.err;
      ++run;
    }
  }
  EXPECT_GE(run, 40U);
}

}  // namespace
}  // namespace flowcert::conformance::help_text_test
