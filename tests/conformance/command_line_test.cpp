// The program `flowcert` as a shell sees it: exit status, one line for an error, and no output file that is
// half written.
//
// Guarantees: nothing here knows how the program is made. Every kind of error is met once, and the directory
// is listed after each; a signal is sent when the temporary file is seen, so it arrives while the program
// writes.
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <thread>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::command_line_test {
namespace {

using Names = std::set<std::string>;
using Words = std::vector<std::string>;

constexpr char kTriangle[] = "0 0 0\n3 0 0\n0 4 0\n";

// Status 2, nothing on standard output, and this as the last of `lines` lines on standard error.
void expect_error(const Finished& finished, const std::string& pattern, std::size_t lines = 1) {
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.out, "");
  const Words said = lines_of(finished.err);
  ASSERT_EQ(said.size(), lines) << finished.err;
  EXPECT_TRUE(std::regex_match(said.back(), std::regex("flowcert: " + pattern))) << said.back();
  EXPECT_TRUE(finished.err.ends_with("\n"));
}

TEST(CommandLine, WrongUsageIsStatus2AndOneLine) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  const Words usages[] = {{"--"},
                          {"bogus"},
                          {"--bogus"},
                          {"compute"},
                          {"compute", input, "--bogus"},
                          {"compute", input, input},
                          {"compute", input, "-o"},
                          {"compute", input, "--runs", "0"},
                          {"compute", input, "--runs", "x"},
                          {"explain", input},
                          {"explain", "--ids", "0"},
                          {"explain", input, "--ids"},
                          {"explain", input, "--ids", "0,x"},
                          {"explain", input, "--ids", "-1"},
                          {"explain", input, "--ids", "4294967296"},
                          {"explain", input, "--ids", "0", "--at", "0,0,0"}};
  for (const Words& usage : usages) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    const bool has_command = !usage.empty() && (usage[0] == "compute" || usage[0] == "explain");
    expect_error(flowcert(usage), ".+ \\(see flowcert " + (has_command ? usage[0] + ' ' : "") + "--help\\)");
  }
}

TEST(CommandLine, WrongWordsAreNamedWithWhatIsNearest) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  const std::pair<Words, std::string> usages[] = {
      {{"--"}, "a command is required \\(see flowcert --help\\)"},
      {{"comput"}, "there is no command 'comput'; did you mean compute\\? \\(see flowcert --help\\)"},
      {{"chekc", input}, "there is no command 'chekc'; did you mean check\\? .*"},
      {{"helpp"}, "there is no command 'helpp'; did you mean (help|--help)\\? .*"},
      {{"help", "mouthful"}, "there is no word 'mouthful'; there are: mouth"},
      {{"help", "quartz"}, "there is no word 'quartz'; flowcert help lists those that there are"},
      {{"quartz"}, "there is no command 'quartz' \\(see flowcert --help\\)"},
      // Its options are not looked at.
      {{"quartz", "x", "--dimension", "1"}, "there is no command 'quartz' \\(see flowcert --help\\)"},
      {{"comput", input, "--json"}, "there is no command 'comput'; did you mean compute\\? \\(see flowcert --help\\)"},
      {{"-v"}, "flowcert has no option '-v'; did you mean --version\\? \\(see flowcert --help\\)"},
      {{"compute", input, "--jsno"},
       "compute has no option '--jsno'; did you mean --json\\? \\(see flowcert compute .*"},
      {{"compute", "--out=x", input}, "compute has no option '--out'; did you mean --output\\? .*"},
      {{"orbit", input, "--fron", "0,0,1"}, "orbit has no option '--fron'; did you mean --from\\? .*"},
      {{"explain", input, "--id", "1"}, "explain has no option '--id'; did you mean --ids\\? .*"},
      // These were the names of options.
      {{"verify", "--levels", "2"}, "verify has no option '--levels'; did you mean --highest-level\\? .*"},
      {{"generate", "--only", "3"}, "generate has no option '--only'; did you mean --case\\? .*"},
      {{"fuzz", "--search", "10"}, "fuzz has no option '--search'; did you mean --mutants\\? .*"},
      {{"locate", input, "--points", input}, "locate has no option '--points'; did you mean --positions\\? .*"},
      {{"stats", input, "-q"}, "stats has no option '-q' \\(see flowcert stats --help\\)"},
      {{"--json", "compute", input}, "--json has to stand after compute .*"},
      {{"fuzz", "merge", "a", "--jsn"}, ".* no option '--jsn'; .* --json\\? \\(see flowcert fuzz merge --help\\)"},
      {{"compute", "a", "b", "c\nd", "e"}, "unexpected arguments: 'b' 'c\\\\nd' 'e' \\(see flowcert compute --help\\)"},
      {{"compute", "a", "b"}, "unexpected argument: 'b' .*"},
      {{"explain", "--ids", "0", "1", input}, "--ids takes one word: write --ids 0,1 .*"},
      {{"explain", input, "--ids", "0", "1", "2"}, "--ids takes one word: write --ids 0,1,2 .*"},
      {{"explain", input, "--at", "1/2", "-2", "3"}, "--at takes one word: write --at 1/2,-2,3 .*"},
      {{"orbit", "--from", "1", "2", "3", input}, "--from takes one word: write --from 1,2,3 .*"}};
  for (const auto& [usage, pattern] : usages) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    expect_error(flowcert(usage), pattern);
  }
}

// Whatever a path holds, an error, a note and the first line of a table are one line each.
TEST(CommandLine, PathsAreToldOnOneLine) {
  const Scratch scratch;
  const std::string strange = "a\nflowcert: b\t\x1b[31m.xyz";
  const std::string shown = scratch.path("a\\nflowcert: b\\t\\x1b[31m.xyz");
  const std::string missing = scratch.path("no/" + strange);
  for (const Words& usage : {Words{"compute", missing}, Words{"check", missing, missing}, Words{"stats", missing},
                             Words{"explain", missing, "--ids", "0"}, Words{"conformance", "--vectors", missing},
                             Words{"surface", missing, "-o", "x.ply"}, Words{"persistence", missing},
                             Words{"cycles", missing}, Words{"fuzz", "--replay", missing},
                             Words{"fuzz", "--resume", missing, "--count", "1"}, Words{"fuzz", "merge", missing}}) {
    const Finished finished = flowcert(usage);
    SCOPED_TRACE(::testing::PrintToString(usage));
    expect_error(finished, ".+");
    EXPECT_NE(finished.err.find("/no/a\\nflowcert: b\\t\\x1b[31m.xyz"), std::string::npos) << finished.err;
  }
  const std::string input = scratch.file(strange, "0 0 0 1\n0 0 0 1\n1 0 0 1\n");
  const Finished finished = flowcert({"compute", input});
  EXPECT_EQ(finished.err, "note: " + shown + ":1: more than three columns; those after the third are ignored\n" +
                              "warning: " + shown + ": 1 repeated point merged\n");
  const Words lines = lines_of(finished.out);
  std::string table;
  for (const std::string& line : lines) table += line;
  EXPECT_EQ(table.find('\x1b'), std::string::npos);
  expect_error(flowcert({"compute", input, "-o", missing}), ".+cannot be written: .+", 3);
  RunningProgram oracle({FLOWCERT_ORACLE_PROGRAM, "stationary", missing});
  EXPECT_EQ(lines_of(oracle.finish().err).size(), 1U);
}

// A folder that cannot be entered, here because it leads to itself. One without permission does the same, but root may
// enter it.
TEST(CommandLine, AFolderThatCannotBeEnteredIsToldInOurWords) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  std::filesystem::create_symlink("loop", scratch.path("loop"));
  const std::string inside = scratch.path("loop/out");
  const std::string claim = scratch.file("claim.csv", "0,0,0,0\n");
  for (const Words& usage :
       {Words{"compute", input, "-o", inside}, Words{"compute", inside}, Words{"compute", input, "--export", inside},
        Words{"stats", input, "--svg", inside}, Words{"persistence", input, "-o", inside},
        Words{"cycles", input, "--export", inside}, Words{"surface", input, "-o", inside + ".ply"},
        Words{"check", input, inside}, Words{"check", input, claim, "--junit", inside},
        Words{"fuzz", "--count", "1", "--out", inside}, Words{"fuzz", "--count", "1", "--corpus", inside},
        Words{"fuzz", "--resume", inside, "--count", "1"}, Words{"conformance", "--vectors", inside, "--list"},
        Words{"conformance", "--against", "true {in}", "--keep", inside, "--case", "unstable-manifolds-0003"}}) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    const Finished finished = flowcert(usage);
    EXPECT_EQ(finished.status, 2);
    EXPECT_TRUE(std::regex_match(finished.err, std::regex("flowcert: [^ ]*loop/out[^ ]*: .*\n"))) << finished.err;
    EXPECT_EQ(finished.err.find("filesystem error"), std::string::npos) << finished.err;
  }
}

TEST(CommandLine, HelpHasAnExample) {
  for (const Words& usage :
       {Words{"--help"}, Words{"compute", "--help"}, Words{"explain", "--help"}, Words{"orbit", "--help"}}) {
    const Finished finished = flowcert(usage);
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.err, "");
    EXPECT_NE(finished.out.find("Usage: flowcert"), std::string::npos) << finished.out;
    EXPECT_NE(finished.out.find("Example"), std::string::npos) << finished.out;
  }
}

TEST(CommandLine, VersionIsTheReproducibilityLine) {
  const Finished finished = flowcert({"--version"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.err, "");
  const std::regex line(R"(flowcert \d+\.\d+\.\d+ \(commit ([0-9a-f]{12}|unknown); kernel: [^;]+; )"
                        R"(compiler: (gcc|clang) \d[^;]*; CGAL \d+\.\d+(\.\d+)?\)\n)");
  EXPECT_TRUE(std::regex_match(finished.out, line)) << finished.out;
}

struct BadFile {
  std::string name;
  std::string content;
  int line;  // 0: the message has none
};

TEST(CommandLine, UnusableInputIsOneLineThatNamesTheLine) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05");
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n";
  const BadFile files[] = {{"nan.xyz", "0 0 0\n1 nan 0\n", 2},
                           {"infinite.xyz", "0 0 0\n1 0 0\n-inf 0 0\n", 3},
                           {"overflow.txt", "0 0 1e309\n", 1},
                           {"inexact.xyz", "0 0 0x1.00000000000001p0\n", 1},
                           {"word.csv", "0,0,0\n\n# comment\n0,zero,0\n", 4},
                           {"short.pts", "0 0 0\n1 1\n", 2},
                           {"short.off", "OFF\n2 0 0\n0 0 0\n", 0},
                           {"word.off", "OFF\n2 0 0\n0 0 0\n0 0 y\n", 4},
                           {"word.obj", "v 0 0 0\nf 1 1 1\nv 1 0 z\n", 3},
                           {"no_z.ply", ply + "end_header\n0 0\n1 1\n", 0},
                           {"short.ply", ply + "property double z\nend_header\n0 0 0\n", 0},
                           {"infinite.ply", ply + "property double z\nend_header\n0 0 0\n1 inf 1\n", 9},
                           {"empty.xyz", "", 0},
                           {"blank.obj", " \n\t\r\n", 0},
                           {"damaged.xyz.gz", std::string("\x1f\x8b\x08\x00\x00", 5), 0}};
  for (const BadFile& bad : files) {
    SCOPED_TRACE(bad.name);
    const Scratch scratch;
    const std::string input = scratch.file(bad.name, bad.content);
    const std::string line = bad.line > 0 ? std::to_string(bad.line) + ": .+" : "(\\d+:)? ?.+";
    const std::string pattern = input + ":" + line;
    expect_error(flowcert({"compute", input, "-o", scratch.path("out.jsonl")}), pattern);
    expect_error(flowcert({"compute", input, "--json"}), pattern);
    expect_error(flowcert({"explain", input, "--ids", "0"}), pattern);
    expect_error(flowcert({"orbit", input, "--from", "0,0,0"}), pattern);
    EXPECT_EQ(scratch.names(), Names{bad.name});
  }
}

TEST(CommandLine, MissingFilesAndDirectories) {
  CITES("FC-IN-05");
  const Scratch scratch;
  expect_error(flowcert({"compute", scratch.path("no.xyz"), "-o", scratch.path("out.jsonl")}),
               scratch.path("no.xyz") + ": .*No such file or directory");
  expect_error(flowcert({"compute", scratch.path("")}), scratch.path("") + ": .*Is a directory");
  EXPECT_EQ(scratch.names(), Names{});
}

TEST(CommandLine, NotesAreOnStandardErrorAndOnlyWhereDue) {
  CITES("FC-IN-03", "FC-IN-02");
  const Scratch scratch;
  EXPECT_EQ(flowcert({"compute", scratch.file("a.xyz", kTriangle)}).err, "");
  const std::string one = scratch.file("one.xyz", "0 0 0\n1 0 0\n-0.0 0 0\n");
  const Finished warned = flowcert({"compute", one, "--json"});
  EXPECT_EQ(warned.status, 0);
  EXPECT_EQ(warned.err, "warning: " + one + ": 1 repeated point merged\n");
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "1 2 3\n";
  EXPECT_EQ(flowcert({"compute", scratch.file("many.xyz", many)}).err,
            "warning: " + scratch.path("many.xyz") + ": 1,000 repeated points merged\n");

  const auto ply = [](const std::string& type, std::size_t bytes) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty " + type + " x\nproperty " + type +
           " y\nproperty " + type + " z\nend_header\n" + std::string(3 * bytes, '\0');
  };
  const std::string single = scratch.file("single.ply", ply("float", 4));
  const Words notes = lines_of(flowcert({"compute", single}).err);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].starts_with("note: " + single + ": ")) << notes[0];
  EXPECT_NE(notes[0].find("single precision"), std::string::npos) << notes[0];
  EXPECT_EQ(flowcert({"compute", scratch.file("double.ply", ply("double", 8))}).err, "");
}

TEST(CommandLine, FurtherColumnsGetANoteAndDecimalCommasAnError) {
  CITES("FC-FILE-01", "FC-FILE-39", "FC-FILE-45");
  const Scratch scratch;
  const auto notes = [&](const std::string& rows) {
    const std::string input = scratch.file("a.xyz", rows);
    const Finished finished = flowcert({"compute", input});
    EXPECT_EQ(finished.status, finished.err.starts_with("flowcert: ") ? 2 : 0);
    std::string told = finished.err;
    for (std::size_t at = 0; (at = told.find(input + ":", at)) != std::string::npos;) told.erase(at, input.size() + 1);
    return told;
  };
  const std::string columns = ": more than three columns; those after the third are ignored\n";
  const std::string comma =
      ": a comma between digits, and blanks alone between other numbers: is it a decimal point?\n";
  EXPECT_EQ(notes("0 0 0\n1 0 0\n"), "");
  EXPECT_EQ(notes("0,0,0\n1, 0 ,0\n2,0,0,\n"), "");
  EXPECT_EQ(notes("1 0 0 0 5\n2 0 0 7 8\n"), "note: 1" + columns);
  EXPECT_EQ(notes("0 0 0\n1 0 0 0\n"), "flowcert: 2: 4 columns, and the first row has 3\n");
  EXPECT_EQ(notes("0 0 0 0\n1 0 0\n"), "flowcert: 2: 3 columns, and the first row has 4\n");
  EXPECT_EQ(notes("0,1 2 3\n"), "flowcert: 1" + comma);
  EXPECT_EQ(notes("# x\n1 2 3\n1,2 4\n"), "flowcert: 3" + comma);
  EXPECT_EQ(notes("0,5 1,5 2,5\n"), "flowcert: 1" + comma);
}

TEST(CommandLine, NamesOfColumnsMayStandAboveTheFirstPoint) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::string rows = flowcert({"compute", scratch.file("a.csv", "0,0,0\n1,0,0\n"), "-o", "-"}).out;
  const auto after_header = [](const std::string& records) { return records.substr(records.find('\n')); };
  for (const std::string head : {"x,y,z\n", "X,Y,Z\r\n", "x y z\n", "# a comment\n\n x , y , z\n"}) {
    const std::string input = scratch.file("a.csv", head + "0,0,0\n1,0,0\n");
    const Finished finished = flowcert({"compute", input, "-o", "-"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(finished.err, "");
    EXPECT_EQ(after_header(finished.out), after_header(rows));
    const Finished piped = flowcert({"compute", "-", "-o", "-"}, {.standard_input = input, .standard_output = ""});
    EXPECT_EQ(after_header(piped.out), after_header(rows));
    RunningProgram oracle({FLOWCERT_ORACLE_PROGRAM, "stationary", input});
    EXPECT_EQ(oracle.finish().status, 0);
  }
  // The oracle knows no other order.
  const std::string other = scratch.file("a.csv", "y,x,z\n0,0,0\n0,1,0\n");
  EXPECT_EQ(after_header(flowcert({"compute", other, "-o", "-"}).out), after_header(rows));
  EXPECT_EQ(RunningProgram({FLOWCERT_ORACLE_PROGRAM, "stationary", other}).finish().status, 2);
  for (const std::string rejected : {"x,y\n0,0,0\n", "0,0,0\nx,y,z\n", "x,y,z\nx,y,z\n0,0,0\n"}) {
    const std::string input = scratch.file("a.csv", rejected);
    expect_error(flowcert({"compute", input}), input + ":[12]: .+");
    RunningProgram oracle({FLOWCERT_ORACLE_PROGRAM, "stationary", input});
    EXPECT_EQ(oracle.finish().status, 2);
  }
}

TEST(CommandLine, StandardInputIsReadByItsContent) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::pair<std::string, std::string> inputs[] = {
      {"table", kTriangle},
      {"off", "OFF\n3 0 0\n0 0 0\n3 0 0\n0 4 0\n"},
      {"obj", "o triangle\nv 0 0 0\nv 3 0 0\nv 0 4 0\n"},
      {"ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
       "end_header\n0 0 0\n3 0 0\n0 4 0\n"}};
  for (const auto& [format, content] : inputs) {
    const Finished finished =
        flowcert({"compute", "-"}, {.standard_input = scratch.file(format, content), .standard_output = ""});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_TRUE(finished.out.starts_with("standard input (" + format + ")\n")) << finished.out;
    EXPECT_TRUE(std::regex_search(finished.out, std::regex("\npoints +3\n"))) << finished.out;
  }
  expect_error(flowcert({"compute", "-"}), "-: empty");
  expect_error(
      flowcert({"compute", "-"}, {.standard_input = scratch.file("bad", "0 0 0\n1 1\n"), .standard_output = ""}),
      "-:2: .+");
}

TEST(CommandLine, AnOutputThatCannotBeWrittenIsStatus2) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  std::filesystem::create_directory(scratch.path("folder"));
  std::filesystem::create_symlink("/dev/full", scratch.path("full"));
  const Names before = scratch.names();
  for (const std::string& output :
       {scratch.path("folder"), scratch.path("none/out.jsonl"), scratch.path("a.xyz/out.jsonl"), scratch.path("full"),
        std::string("/dev/full"), std::string("/proc/flowcert.jsonl")}) {
    SCOPED_TRACE(output);
    expect_error(flowcert({"compute", input, "-o", output}), output + ": cannot be written: .+");
    EXPECT_EQ(scratch.names(), before);
  }
  EXPECT_EQ(content_of(input), kTriangle);
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("full")));
}

TEST(CommandLine, AFullStandardOutputIsStatus2) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  const Words usages[] = {{"compute", input},
                          {"compute", input, "--json"},
                          {"compute", input, "-o", "/dev/stdout"},
                          {"explain", input, "--ids", "0,1"},
                          {"explain", input, "--ids", "0,1,2", "--json"},
                          {"orbit", input, "--from", "1,1,1"},
                          {"orbit", input, "--from", "1,1,1", "--json"},
                          {"compute", input, "--manifolds", "u2", "--stats"},
                          {"--help"},
                          {"compute", "--help"},
                          {"--version"}};
  for (const Words& usage : usages) {
    SCOPED_TRACE(::testing::PrintToString(usage));
    expect_error(flowcert(usage, {.standard_input = "/dev/null", .standard_output = "/dev/full"}),
                 ".*cannot be written: .+");
  }
}

TEST(CommandLine, AnOutputFileReplacesTheOldOneAndNothingElse) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  const std::string output = scratch.file("out.jsonl", "old\n");
  EXPECT_EQ(flowcert({"compute", input, "-o", output}).status, 0);
  EXPECT_TRUE(content_of(output).starts_with("{"));
  EXPECT_EQ(scratch.names(), (Names{"a.xyz", "out.jsonl"}));
  // An input that cannot be computed leaves the file alone.
  const std::string complete = content_of(output);
  EXPECT_EQ(flowcert({"compute", scratch.path("none.xyz"), "-o", output}).status, 2);
  EXPECT_EQ(content_of(output), complete);
}

// Random points. Writing their records takes about 150 microseconds a point.
std::string many_points(int count) {
  std::mt19937_64 random(1);
  std::string text;
  for (int i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) text += std::to_string(random() >> 40) + (axis < 2 ? " " : "\n");
  }
  return text;
}

// Waits for a third name beside input and output. Fails when the program ends without it.
bool wait_for_temporary(const Scratch& scratch, RunningProgram& program) {
  while (scratch.names().size() < 3) {
    if (program.has_ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

TEST(Signals, LeaveTheOldFileAndNoTemporaryOne) {
  const Scratch scratch;
  const std::string input = scratch.file("many.xyz", many_points(40000));
  const std::string output = scratch.file("out.jsonl", "old\n");
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    RunningProgram program({FLOWCERT_PROGRAM, "compute", input, "-o", output});
    ASSERT_TRUE(wait_for_temporary(scratch, program)) << program.finish().err;
    program.signal(number);
    const Finished finished = program.finish();
    EXPECT_EQ(finished.status, -number);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(scratch.names(), (Names{"many.xyz", "out.jsonl"}));
    EXPECT_EQ(content_of(output), "old\n");
  }
}

TEST(Signals, AnIgnoredOneStaysIgnored) {
  const Scratch scratch;
  const std::string input = scratch.file("many.xyz", many_points(4000));
  const std::string output = scratch.file("out.jsonl", "old\n");
  // nohup does this.
  RunningProgram program(
      {"/bin/sh", "-c", R"(trap "" HUP; exec "$0" compute "$1" -o "$2")", FLOWCERT_PROGRAM, input, output});
  ASSERT_TRUE(wait_for_temporary(scratch, program)) << program.finish().err;
  program.signal(SIGHUP);
  EXPECT_EQ(program.finish().status, 0);
  EXPECT_EQ(scratch.names(), (Names{"many.xyz", "out.jsonl"}));
  EXPECT_TRUE(content_of(output).starts_with("{"));
}

TEST(Signals, AReaderThatGoesAwayEndsTheProgram) {
  const Scratch scratch;
  const std::string input = scratch.file("many.xyz", many_points(4000));
  const std::string small = scratch.file("a.xyz", kTriangle);
  // The status of a pipeline is that of its last command, so the program's own goes to standard error.
  const auto piped = [](const std::string& command, const std::string& file) {
    return RunningProgram({"/bin/sh", "-c", "(" + command + "; echo $? >&2) | true", FLOWCERT_PROGRAM, file}).finish();
  };
  EXPECT_EQ(piped(R"("$0" compute "$1" -o /dev/stdout)", input).err, "141\n");  // 128 + SIGPIPE
  // This output is so short that it may be written before the reader is gone.
  const Finished finished = piped(R"("$0" compute "$1" --json)", small);
  EXPECT_EQ(finished.status, 0);
  EXPECT_TRUE(finished.err == "0\n" || finished.err == "141\n") << finished.err;
  EXPECT_EQ(scratch.names(), (Names{"many.xyz", "a.xyz"}));
}

// The program of ./dev demo has the commands that compute. For the others it says what builds them.
TEST(CommandLine, TheFirstProgramNamesWhatItLacks) {
  const Scratch scratch;
  const std::string input = scratch.file("a.xyz", kTriangle);
  const auto first = [](Words arguments) {
    arguments.insert(arguments.begin(), FLOWCERT_FIRST_PROGRAM);
    return RunningProgram(arguments).finish();
  };
  for (const Words& command : {Words{"compute", input, "--manifolds", "u2,s2"},
                               Words{"orbit", input, "--from", "0,0,1"}, Words{"persistence", input},
                               Words{"surface", input, "--select", "largest-gaps=1", "-o", scratch.path("s.ply")}}) {
    EXPECT_EQ(first(command).status, 0) << command.front();
  }
  for (const Words& command :
       {Words{"check", input, input}, Words{"check", "--help"}, Words{"conformance", "--against", "a {in}"},
        Words{"fuzz"}, Words{"generate", "--level", "1"}, Words{"verify"}}) {
    const Finished finished = first(command);
    expect_error(finished, command.front() + ": this program was built without it; './dev build' adds it .*");
  }
  const std::string help = first({"--help"}).out, whole = flowcert({"--help"}).out;
  EXPECT_NE(help.find("\nNot built yet: ./dev build adds these:\n"), std::string::npos) << help;
  EXPECT_EQ(whole.find("Not built yet"), std::string::npos);
  // Each is told as in the program that has it.
  for (const std::string name : {"check ", "conformance ", "fuzz ", "generate ", "verify ", "view "}) {
    const std::size_t at = whole.find("\n  " + name);
    ASSERT_NE(at, std::string::npos);
    EXPECT_NE(help.find(whole.substr(at, whole.find('\n', at + 1) - at)), std::string::npos) << name << help;
  }
}

TEST(CommandLine, WithoutACommandEachGroupIsPrintedOnce) {
  for (const char* program : {FLOWCERT_PROGRAM, FLOWCERT_FIRST_PROGRAM}) {
    const Finished finished = RunningProgram({program}).finish();
    EXPECT_EQ(finished.status, 2);
    std::map<std::string, int> headings;
    std::istringstream lines(finished.out);
    for (std::string line; std::getline(lines, line);) headings[line] += line.starts_with("  ") ? 0 : 1;
    const char* const last = program == std::string(FLOWCERT_PROGRAM) ? "Judge claims and programs"
                                                                      : "Not built yet: ./dev build adds these";
    for (const char* group : {"Compute", "Look closely", last}) {
      EXPECT_EQ(headings[group], 1) << program << '\n' << finished.out;
    }
  }
}

}  // namespace
}  // namespace flowcert::conformance::command_line_test
