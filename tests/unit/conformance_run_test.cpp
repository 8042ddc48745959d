// Commands of the shell on cases made by hand: which outcome each way to end has, and how answers are compared with
// what a case says.
//
// Guarantees: no command outlives its test. Where a limit of time has to pass, it is 1/5 s; elsewhere it is long enough
// for a busy machine.
#include "certify/programs/conformance_run.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "certify/programs/command_run.h"
#include "fuzz/judge/oracle_truth.h"
#include "tests/cites.h"
#include "tests/unit/case_points.h"

namespace flowcert::judge::conformance_run_test {
namespace {

const std::vector<std::vector<std::string>> kWords = {{"0", "0", "0"}, {"3", "0", "0"}, {"0", "4", "0"}};
// Each line of a claim of the right triangle's critical points ends in \n.
const std::string kSamples = "0,,,,,0\\n0,,,,,1\\n0,,,,,2\\n";
const std::string kEdges = "1,,,,,0,1\\n1,,,,,0,2\\n";
// What a perturbation makes of the middle of the hypotenuse.
const std::string kPair = "1,,,,,1,2\\n2,,,,,0,1,2\\n";

std::string claiming(const std::string& lines) { return "printf '" + lines + "' > {out} # {in}"; }
const std::string kRight = claiming(kSamples + kEdges);

// The right triangle; its hypotenuse has a regular stationary point in the middle.
VectorCase right_triangle() {
  VectorCase one;
  one.id = "right-triangle";
  one.words = kWords;
  one.rows = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  one.stationary = case_points(*oracle_truth(one.rows));
  one.limits.resize(one.stationary.size());
  one.stable.resize(one.stationary.size());
  return one;
}

VectorCase invalid_case() {
  VectorCase one;
  one.id = "invalid";
  one.words = {{"nan", "0", "0"}};
  one.result = CaseResult::kInvalid;
  return one;
}

CaseOutcome outcome_of(const VectorCase& one, ConformanceOptions options) {
  options.truth = truth_of_oracle();
  const Interruption interruption;
  const std::vector<CaseOutcome> outcomes = run_conformance({&one}, options, [](std::size_t, std::size_t) {});
  return outcomes.at(0);
}

constexpr double kEnough = 60;
constexpr double kShort = 0.2;

CaseOutcome outcome_of(const VectorCase& one, const std::string& command, double seconds = kEnough) {
  ConformanceOptions options;
  options.command = command;
  options.limits.seconds = seconds;
  options.limits.file_bytes = 1 << 20;
  return outcome_of(one, options);
}

void expect_outcome(const VectorCase& one, const std::string& command, RunOutcome expected) {
  const CaseOutcome found = outcome_of(one, command, expected == RunOutcome::kTimedOut ? kShort : kEnough);
  EXPECT_STREQ(run_outcome_text(found.outcome), run_outcome_text(expected)) << command << ": " << found.message;
}

TEST(ConformanceRun, ClaimsAreJudged) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04");
  expect_outcome(right_triangle(), kRight, RunOutcome::kConforms);
  expect_outcome(right_triangle(), "printf '" + kSamples + kEdges + "' # {in}", RunOutcome::kConforms);
  expect_outcome(right_triangle(), claiming(kSamples + kEdges + kPair), RunOutcome::kPerturbed);
  expect_outcome(right_triangle(), claiming(kSamples + kPair), RunOutcome::kFails);
  const CaseOutcome missing = outcome_of(right_triangle(), claiming(kSamples + "1,,,,,0,1\\n"));
  EXPECT_EQ(missing.outcome, RunOutcome::kFails);
  EXPECT_EQ(missing.level, 3);
  EXPECT_NE(missing.message.find("missing"), std::string::npos);
  ASSERT_EQ(missing.findings.size(), 2U) << "Euler's sum is wrong, too";
  EXPECT_EQ(missing.findings[1].reason, FindingReason::kMissing);
  EXPECT_EQ(missing.findings[1].contact, (std::vector<PointId>{0, 2}));
}

TEST(ConformanceRun, WaysToEndAreToldApart) {
  CITES("FC-IN-05", "FC-CLAIM-01");
  const VectorCase one = right_triangle();
  expect_outcome(one, "exit 3 # {in}", RunOutcome::kRefused);
  expect_outcome(one, kRight.substr(0, kRight.find(" #")) + "; exit 1 # {in}", RunOutcome::kRefused);
  expect_outcome(one, "exit 126 # {in}", RunOutcome::kCrashed);
  expect_outcome(one, "exit 127 # {in}", RunOutcome::kCrashed);
  for (const char* signal : {"SEGV", "ABRT", "XFSZ", "HUP", "SYS"}) {
    const CaseOutcome found = outcome_of(one, std::string("kill -") + signal + " $$ # {in}");
    EXPECT_EQ(found.outcome, RunOutcome::kCrashed) << signal;
    EXPECT_EQ(found.message, std::string("SIG") + signal);
    // A shell in between says by its exit status which signal it was.
    EXPECT_EQ(outcome_of(one, std::string("sh -c 'kill -") + signal + " $$'; exit $? # {in}").message,
              std::string("SIG") + signal);
  }
  expect_outcome(one, "sleep 100 # {in}", RunOutcome::kTimedOut);
  expect_outcome(one, "trap '' TERM INT; while :; do :; done # {in}", RunOutcome::kTimedOut);
  expect_outcome(one, "exec yes # {in}", RunOutcome::kCrashed);
  for (const char* nothing : {"true", ": > {out}"}) {
    expect_outcome(one, std::string(nothing) + " # {in} {out}", RunOutcome::kUnreadable);
  }
  for (const char* other : {"mkfifo {out}", "mkdir {out}", "ln -s /dev/zero {out}", "ln -s /dev/null {out}"}) {
    const CaseOutcome found = outcome_of(one, std::string(other) + " # {in}");
    EXPECT_EQ(found.outcome, RunOutcome::kUnreadable) << other;
    EXPECT_EQ(found.message, "claim: not a regular file") << other;
  }
  expect_outcome(one, claiming("0,,,,,9\\n"), RunOutcome::kUnreadable);
}

// A shell adds 128 to a signal. There are 64, and statuses beyond them are the program's own, as that before them is.
TEST(ConformanceRun, AStatusIsASignalUpToTheLastOne) {
  CITES("FC-FILE-29");
  const std::pair<int, bool> statuses[] = {{2, false},  {125, false}, {128, false}, {129, true},  {137, true},
                                           {159, true}, {160, true},  {192, true},  {193, false}, {255, false}};
  for (const auto& [status, is_signal] : statuses) {
    const std::string command = "exit " + std::to_string(status) + " # {in}";
    expect_outcome(right_triangle(), command, is_signal ? RunOutcome::kCrashed : RunOutcome::kRefused);
    expect_outcome(invalid_case(), command, is_signal ? RunOutcome::kCrashed : RunOutcome::kProperlyRefused);
  }
  for (const char* signal : {"34", "64"}) {
    const CaseOutcome found = outcome_of(right_triangle(), std::string("kill -") + signal + " $$ # {in}");
    EXPECT_EQ(found.outcome, RunOutcome::kCrashed) << signal;
    EXPECT_EQ(found.message, std::string("signal ") + signal);
  }
  EXPECT_EQ(outcome_of(invalid_case(), "exit 255 # {in}").message, "exit status 255");
}

TEST(ConformanceRun, ATimeLimitIsKept) {
  CITES("FC-CLAIM-01");
  expect_outcome(right_triangle(), "sleep 1.5; " + kRight, RunOutcome::kTimedOut);
}

TEST(ConformanceRun, WhatIsInvalidHasToBeRefused) {
  CITES("FC-IN-01", "FC-IN-05");
  expect_outcome(invalid_case(), "exit 1 # {in}", RunOutcome::kProperlyRefused);
  expect_outcome(invalid_case(), "exit 0 # {in}", RunOutcome::kAccepted);
  expect_outcome(invalid_case(), kRight, RunOutcome::kAccepted);
  expect_outcome(invalid_case(), "exit 126 # {in}", RunOutcome::kCrashed);
  expect_outcome(invalid_case(), "exit 127 # {in}", RunOutcome::kCrashed);
  expect_outcome(invalid_case(), "kill -XFSZ $$ # {in}", RunOutcome::kCrashed);
  expect_outcome(invalid_case(), "sleep 100 # {in}", RunOutcome::kTimedOut);
}

TEST(ConformanceRun, NoChildIsLeft) {
  CITES("FC-CLAIM-01");
  const ScratchFolder folder;
  const std::string file = (folder.path() / "process").string();
  for (const std::string child : {"sleep 100 &", "setsid sleep 100 &"}) {
    for (const std::string end : {" ", " sleep 100; "}) {
      (void)outcome_of(right_triangle(), child + " echo $! > " + file + ";" + end + kRight, 1);
      pid_t process = 0;
      std::ifstream(file) >> process;
      ASSERT_GT(process, 0);
      EXPECT_NE(::kill(process, 0), 0) << child << end;
    }
  }
}

// ---- Orbits and persistence

// From (0,1/2,0), the orbit goes straight up to the middle of the points 0 and 2.
CaseOrbit orbit_of_cell() {
  return {"0,1/2,0", claimed_orbit_of(R"({"segments": [{"type": "C-C-F", "driver": ["0","0","0"],
    "end": ["0","2","0"]}], "limit": {"kind": "critical", "index": 1, "position": ["0","2","0"], "contact": [0,2],
    "squared_distance": "4"}})",
                                      "orbit")};
}

// From (3/4,1,0) it goes to the middle of the hypotenuse, where a perturbation may let it go on.
CaseOrbit orbit_to_regular() {
  return {"3/4,1,0", claimed_orbit_of(R"({"segments": [{"type": "C-C-E", "driver": ["0","0","0"],
    "end": ["3/2","2","0"]}], "limit": {"kind": "regular", "index": [1,2], "position": ["3/2","2","0"],
    "contact": [0,1,2], "squared_distance": "25/4"}})",
                                      "orbit")};
}

const std::string kOrbit =
    R"({"segments": [{"type": "C-C-F", "driver": ["0","0","0"], "end": ["0","2","0"]}], "limit": {"kind": "critical",)"
    R"( "index": 1, "position": ["0","2","0"], "contact": [0,2], "squared_distance": "4"}})";

CaseOutcome with_orbit(const CaseOrbit& orbit, const std::string& answer, const std::string& claim = kRight) {
  VectorCase one = right_triangle();
  one.orbits = {orbit};
  ConformanceOptions options;
  options.command = claim;
  options.orbit_command = "printf '%s' '" + answer + "' > {out} # {in} {start}";
  return outcome_of(one, options);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(ConformanceRun, OrbitsAreCompared) {
  CITES("FC-FLOW-01", "FC-CLAIM-07");
  const CaseOutcome right = with_orbit(orbit_of_cell(), kOrbit);
  EXPECT_EQ(right.outcome, RunOutcome::kConforms) << right.message;
  EXPECT_EQ(right.orbits_judged, 1U);
  const CaseOutcome wrong = with_orbit(orbit_of_cell(), replaced(kOrbit, R"("index": 1)", R"("index": 2)"));
  EXPECT_EQ(wrong.outcome, RunOutcome::kFails);
  ASSERT_EQ(wrong.orbit_findings.size(), 1U);
  EXPECT_FALSE(wrong.orbit_findings[0].difference.is_permitted);
  EXPECT_EQ(with_orbit(orbit_of_cell(), "{}").outcome, RunOutcome::kUnreadable);
}

CaseOutcome with_pairs(const std::string& lines, double tolerance) {
  VectorCase one = right_triangle();
  one.persistence = {{0, 0, Rational(9) / 4}, {0, 0, Rational(4)}, {0, 0, std::nullopt}};
  ConformanceOptions options;
  options.command = kRight;
  options.persistence_command = "printf '" + lines + "' > {out} # {in}";
  options.check.tolerance = tolerance;
  return outcome_of(one, options);
}

// The shell's printf makes the bytes of the mark.
TEST(ConformanceRun, AByteOrderMarkIsPassedOver) {
  CITES("FC-FILE-47");
  const std::string mark = "\\357\\273\\277";
  const auto answering = [&](const std::string& marks) {
    VectorCase one = right_triangle();
    one.orbits = {orbit_of_cell()};
    one.persistence = {{0, 0, Rational(9) / 4}, {0, 0, Rational(4)}, {0, 0, std::nullopt}};
    ConformanceOptions options;
    options.command = claiming(marks + kSamples + kEdges);
    options.orbit_command = "printf '" + marks + "%s' '" + kOrbit + "' > {out} # {in} {start}";
    options.persistence_command = "printf '" + marks + "0 0 inf\\n0 0 2.25\\n0 0 4\\n' > {out} # {in}";
    return outcome_of(one, options);
  };
  for (const std::string& marks : {std::string(), mark}) {
    const CaseOutcome found = answering(marks);
    EXPECT_EQ(found.outcome, RunOutcome::kConforms) << found.message;
    EXPECT_EQ(found.orbits_judged, 1U);
    EXPECT_TRUE(found.is_persistence_judged);
  }
  EXPECT_EQ(outcome_of(right_triangle(), claiming(mark + mark + kSamples + kEdges)).outcome, RunOutcome::kUnreadable);
  EXPECT_EQ(with_orbit(orbit_of_cell(), "\xef\xbb\xbf\xef\xbb\xbf" + kOrbit).outcome, RunOutcome::kUnreadable);
  EXPECT_EQ(with_pairs(mark + mark + "0 0 inf\\n", kDefaultTolerance).outcome, RunOutcome::kUnreadable);
}

TEST(ConformanceRun, AnOrbitMayGoOnFromARegularPoint) {
  CITES("FC-CLAIM-07", "FC-CLAIM-08", "FC-FILE-27");
  const std::string ends_there =
      R"({"segments": [{"type": "C-C-V", "driver": ["0","0","0"], "end": ["3/2","2","0"]}], "limit": {)"
      R"("kind": "regular", "index": [1,2], "position": ["3/2","2","0"], "contact": [0,1,2],)"
      R"( "squared_distance": "25/4"}})";
  const std::string goes_on =
      R"({"segments": [{"type": "C-C-E", "driver": ["0","0","0"], "end": ["3/2","2","0"]},)"
      R"( {"type": "E-F-inf", "driver": ["3/2","2","0"], "end": null}], "limit": {"kind": "infinity"}})";
  for (const std::string& orbit : {ends_there, goes_on}) {
    const CaseOutcome varied = with_orbit(orbit_to_regular(), orbit);
    EXPECT_EQ(varied.outcome, RunOutcome::kPerturbed) << varied.message;
  }
  for (const std::string& orbit : {replaced(ends_there, "25/4", "999"), replaced(ends_there, "C-C-V", "C-C-Q"),
                                   replaced(goes_on, "E-F-inf", "Q")}) {
    EXPECT_EQ(with_orbit(orbit_to_regular(), orbit).outcome, RunOutcome::kFails) << orbit;
  }
  // Where the claim is wrong, a permitted orbit changes nothing.
  const CaseOutcome fails = with_orbit(orbit_to_regular(), ends_there, claiming(kSamples));
  EXPECT_EQ(fails.outcome, RunOutcome::kFails);
  EXPECT_NE(fails.message.find("missing"), std::string::npos) << fails.message;
}

TEST(ConformanceRun, TheFirstNegativeOutcomeStays) {
  CITES("FC-CLAIM-01");
  const CaseOutcome fails = with_orbit(orbit_of_cell(), "{}", claiming(kSamples));
  EXPECT_EQ(fails.outcome, RunOutcome::kFails);
  const CaseOutcome refused = with_orbit(orbit_of_cell(), "{}", "exit 1 # {in}");
  EXPECT_EQ(refused.outcome, RunOutcome::kRefused);
}

TEST(ConformanceRun, PersistenceHasTheToleranceOfClaims) {
  CITES("FC-CLAIM-05", "FC-CLAIM-11");
  const std::string right = "0 0 inf\\n0 0 2.25\\n0 0 4\\n", near = "0 0 inf\\n0 0 2.25\\n0 0 4.00000002\\n";
  const CaseOutcome found = with_pairs(right, kDefaultTolerance);
  EXPECT_EQ(found.outcome, RunOutcome::kConforms) << found.message;
  EXPECT_TRUE(found.is_persistence_judged);
  EXPECT_EQ(with_pairs(near, 1e-8).outcome, RunOutcome::kConforms) << "5e-9 times its magnitude";
  EXPECT_EQ(with_pairs(near, kDefaultTolerance).outcome, RunOutcome::kFails);
  const CaseOutcome fails = with_pairs("0 0 inf\\n0 0 2.25\\n", kDefaultTolerance);
  EXPECT_EQ(fails.outcome, RunOutcome::kFails);
  EXPECT_EQ(fails.persistence_findings.size(), 1U);
}

// ---- Words of the shell

TEST(CommandRun, FillsInPlacesWhateverTheyHold) {
  CITES("FC-IN-05");
  const ScratchFolder folder;
  std::size_t number = 0;
  for (const std::string value : {"plain-1/2.5", "two words", "it's", "'", "$HOME `id` \\ \"x\" *", "{out} {in}", ""}) {
    const CommandRun run =
        run_command({"printf '%s' {start} > {out} # {in}", "points", "0 0 0\n", "answer", {{"{start}", value}}},
                    folder.path() / std::to_string(++number), {}, [] { return false; });
    EXPECT_EQ(run.end.number, 0);
    EXPECT_EQ(answer_bytes(run), value);
  }
}

TEST(CommandRun, IsCancelled) {
  CITES("FC-CLAIM-01");
  const ScratchFolder folder;
  const CommandRun run = run_command({"sleep 100 # {in}", "points", "0 0 0\n", "answer", {}}, folder.path() / "1", {},
                                     [] { return true; });
  EXPECT_EQ(run.end.ending, ProgramEnding::kCancelled);
}

}  // namespace
}  // namespace flowcert::judge::conformance_run_test
