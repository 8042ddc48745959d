// `flowcert conformance` as a user calls it: the verdict on programs that answer the conformance vectors
// rightly, wrongly, or not at all (spec/formats.md, "Report of a conformance run").
//
// Guarantees: our own program is right on every case. Whatever a program does, crash, hang, fork, or fill the
// disk, the run comes to its end and says so, leaves nothing behind and no process running. All of this with
// a folder for temporary files whose name a shell would take apart.
#include <expat.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

// A regular tetrahedron: each of its four points of index 2 has the maximum and infinity as limits.
constexpr char kTetrahedron[] = "unstable-manifolds-0002";
constexpr char kTetrahedronOrbits[] = "orbits-0003";
// A right triangle: two of the orbits end at its regular stationary point.
constexpr char kTriangleOrbits[] = "orbits-0004";
// An acute triangle: edges of squared length 10, 16 and 18, and a circle of squared radius 5.
constexpr char kTrianglePairs[] = "persistence-0005";

const std::string kCompute = std::string(FLOWCERT_PROGRAM) + " compute {in} -o {out} --manifolds u2";
const std::string kPersistence = std::string(FLOWCERT_PROGRAM) + " persistence {in} -o {out}";
const std::string kOrbit = std::string(FLOWCERT_PROGRAM) + " orbit {in} --from {start} --json > {out}";

std::vector<json> vector_cases() {
  std::vector<json> cases;
  for (const auto& entry : fs::directory_iterator(FLOWCERT_VECTORS)) {
    const json file = json::parse(content_of(entry.path().string()));
    if (!file.contains("cases")) continue;
    for (const json& one : file["cases"]) cases.push_back(one);
  }
  return cases;
}

// Of a report. An object that has nothing of a case if there is not one.
json only_case_of(const json& report) {
  const json cases = report.value("cases", json::array());
  EXPECT_EQ(cases.size(), 1U) << report;
  if (cases.size() == 1) return cases[0];
  return {{"outcome", ""},
          {"level", ""},
          {"message", ""},
          {"findings", json::array()},
          {"orbit_findings", json::array()},
          {"persistence_findings", json::array()}};
}

bool is_running(const std::string& process_file) {
  return ::kill(std::stoi(content_of(process_file)), 0) == 0;
}

void wait_for(const std::string& file) {
  for (int tries = 0; tries < 2000 && !content_of(file).ends_with('\n'); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

// Of some groups the first cases, so that it does not take long to read them.
class FewVectors {
 public:
  FewVectors() {
    fs::copy_file(fs::path(FLOWCERT_VECTORS) / "flags.json", scratch_.path("flags.json"));
    fs::copy_file(fs::path(FLOWCERT_VECTORS) / "invalid-input.json", scratch_.path("invalid-input.json"));
    for (const std::string group :
         {"flat-inputs", "orbits", "persistence", "regular-stationary-points", "unstable-manifolds"}) {
      json file = json::parse(content_of(std::string(FLOWCERT_VECTORS) + "/" + group + ".json"));
      file["cases"].erase(file["cases"].begin() + kCases, file["cases"].end());
      std::ofstream(scratch_.path(group + ".json")) << file;
    }
  }
  [[nodiscard]] std::string folder() const { return scratch_.path(""); }

 private:
  static constexpr std::ptrdiff_t kCases = 6;
  Scratch scratch_;
};

class ConformanceCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() { few_vectors = new FewVectors; }
  static void TearDownTestSuite() { delete few_vectors; }

  void SetUp() override {
    temporary_ = scratch_.path("it's temporary");
    fs::create_directory(temporary_);
    ::setenv("TMPDIR", temporary_.c_str(), 1);
  }
  void TearDown() override {
    EXPECT_TRUE(fs::is_empty(temporary_)) << "left behind";
    ::unsetenv("TMPDIR");
  }

  static Words command(Words words, const std::string& vectors = few_vectors->folder()) {
    words.insert(words.begin(), {"conformance", "--vectors", vectors});
#ifdef __SANITIZE_ADDRESS__
    // Its shadow takes terabytes of addresses.
    words.insert(words.end(), {"--memory-limit", "0"});
#endif
    return words;
  }
  static Finished run(const Words& words, const std::string& vectors = few_vectors->folder()) {
    return flowcert(command(words, vectors));
  }
  // With the exit status checked against the verdict.
  static json as_json(Words words, const std::string& vectors = few_vectors->folder()) {
    words.emplace_back("--json");
    const Finished finished = run(words, vectors);
    json report = json::parse(finished.out, nullptr, false);
    EXPECT_TRUE(report.is_object()) << finished.out << finished.err;
    if (!report.is_object()) return json::object();
    EXPECT_EQ(finished.status, report["verdict"] == "fails" ? 1 : 0);
    return report;
  }

  // A program as a shell script: $1 is the file of points, $2 the file for the claim.
  [[nodiscard]] std::string script(const std::string& lines) const {
    return "sh " + scratch_.file("program.sh", lines + "\n") + " {in} {out}";
  }
  // What becomes of the tetrahedron, or another case, at the hands of a script.
  [[nodiscard]] json outcome_of(const std::string& lines, const std::string& id = kTetrahedron,
                                const std::string& time_limit = "60") const {
    const json report = as_json({"--against", script(lines), "--case", id, "--time-limit", time_limit});
    return only_case_of(report);
  }
  void expect_outcome(const std::string& lines, const std::string& outcome,
                      const std::string& message) const {
    const json one = outcome_of(lines, kTetrahedron, outcome == "timed out" ? "1" : "60");
    EXPECT_EQ(one["outcome"], outcome) << lines << one;
    EXPECT_NE(one["message"].get<std::string>().find(message), std::string::npos) << lines << one;
  }

  static inline const FewVectors* few_vectors = nullptr;
  Scratch scratch_;
  std::string temporary_;
};

// ---- Programs that are right

TEST_F(ConformanceCommand, OurOwnProgramIsRightOnAllCases) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-03", "FC-IN-04", "FC-IN-05", "FC-CRIT-02", "FC-CRIT-03", "FC-OUT-01",
        "FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07", "FC-CLAIM-06");
  const std::vector<json> cases = vector_cases();
  std::size_t orbits = 0, with_pairs = 0;
  std::map<std::string, std::size_t> flags;
  for (const json& one : cases) {
    for (const json& flag : one["flags"]) ++flags[flag];
    if (one.contains("expected")) with_pairs += one["expected"].contains("persistence") ? 1 : 0;
    if (one.contains("expected")) orbits += one["expected"].value("orbits", json::array()).size();
  }
  const json report = as_json({"--against", kCompute, "--orbits-against", kOrbit, "--persistence-against",
                               kPersistence, "--jobs", "2", "--time-limit", "120"},
                              FLOWCERT_VECTORS);
  EXPECT_EQ(report["verdict"], "conforms");
  ASSERT_EQ(report["cases"].size(), cases.size());
  for (const json& one : report["cases"]) {
    const bool is_invalid = one["group"] == "invalid-input";
    EXPECT_EQ(one["outcome"], is_invalid ? "properly refused" : "conforms") << one;
    EXPECT_EQ(one["message"].get<std::string>().starts_with("exit status 2: flowcert: "), is_invalid) << one;
    EXPECT_EQ(one["findings"], json::array());
  }
  EXPECT_EQ(report["judged"]["orbits"], orbits);
  EXPECT_EQ(report["judged"]["persistence"], with_pairs);
  EXPECT_GE(with_pairs, 60U);
  EXPECT_GT(report["judged"]["4"], cases.size() / 2);
  EXPECT_EQ(report["flags"].size(), flags.size());
  for (const json& flag : report["flags"]) {
    EXPECT_EQ(flag["cases"], flags[flag["flag"]]);
    EXPECT_EQ(flag["conforms"], flag["cases"]);
  }
}

TEST_F(ConformanceCommand, GivesThePointsInOtherForms) {
  CITES("FC-IN-02", "FC-IN-04");
  const Words magnitudes = {"--group", "magnitudes", "--flag", "subnormal", "--flag", "near-overflow"};
  const auto verdict = [&](Words words) {
    words.insert(words.end(), magnitudes.begin(), magnitudes.end());
    return as_json(words, FLOWCERT_VECTORS)["verdict"];
  };
  EXPECT_EQ(verdict({"--against", kCompute}), "conforms");
  EXPECT_EQ(verdict({"--against", kCompute, "--hex"}), "conforms");
  EXPECT_EQ(verdict({"--against", kCompute, "--in-format", "off"}), "conforms");

  const std::string seen = scratch_.path("seen");
  const std::string look = "cat {in} > " + seen + "; exit 1";
  EXPECT_EQ(run({"--against", look, "--case", kTetrahedron}).status, 1);
  EXPECT_EQ(content_of(seen), "0 0 0\n1 1 0\n1 0 1\n0 1 1\n");
  EXPECT_EQ(run({"--against", look, "--case", kTetrahedron, "--in-format", "off", "--hex"}).status, 1);
  EXPECT_TRUE(content_of(seen).starts_with("OFF\n4 0 0\n0x0p+0 0x0p+0 0x0p+0\n0x1p+0 ")) << content_of(seen);
  // What is wrong with an invalid case is all that is wrong with it.
  EXPECT_EQ(run({"--against", look, "--case", "invalid-input-0007"}).status, 0);
  EXPECT_EQ(content_of(seen), "0 0 0\n1 1e309 0\n0 2 0\n");
  // One that is about the text of an XYZ file.
  const Finished no_text = run({"--against", look, "--case", "invalid-input-0027", "--in-format", "off"});
  EXPECT_EQ(no_text.status, 2);
  EXPECT_NE(no_text.err.find("invalid-input-0027 is about the text of an XYZ file"), std::string::npos)
      << no_text.err;
}

TEST_F(ConformanceCommand, TakesClaimsInAnyFormatFromWhereverTheyAre) {
  CITES("FC-CLAIM-04", "FC-CLAIM-05");
  const std::string by_file = std::string(FLOWCERT_PROGRAM) + " compute {in} -o points.jsonl > /dev/null; ";
  EXPECT_EQ(run({"--against", by_file + "cat points.jsonl", "--case", kTetrahedron}).status, 0)
      << "standard output";
  EXPECT_EQ(run({"--against", by_file + "cp points.jsonl \"my claim's\"", "--case", kTetrahedron}).status, 1);
  EXPECT_EQ(run({"--against", by_file + "cp points.jsonl \"my claim's\"; test {out} -ef \"my claim's\"",
                 "--out-name", "my claim's", "--case", kTetrahedron})
                .status,
            0);
  // A perturbation's, of the right triangle: an edge and a facet at one place.
  const json one = outcome_of(
      "printf '0,0,0,0\\n0,3,0,0\\n0,0,4,0\\n1,1.5,0,0\\n1,0,2,0\\n1,1.5,2,0,,1,2\\n2,1.5,2,0,,0,1,2\\n' > "
      "$2",
      "regular-stationary-points-0001");
  EXPECT_EQ(one["outcome"], "conforms where determined") << one;
  EXPECT_NE(one["message"].get<std::string>().find("symbolic-perturbation [FC-CLAIM-04]"), std::string::npos);
}

// ---- Programs that are wrong

TEST_F(ConformanceCommand, SaysWhereAClaimIsWrong) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03", "FC-CLAIM-06");
  const std::string compute = std::string(FLOWCERT_PROGRAM) + " compute \"$1\" --manifolds u2 -o all\n";
  const json cut = outcome_of(compute + "sed '$d' all > \"$2\"");
  EXPECT_EQ(cut["outcome"], "fails");
  EXPECT_EQ(cut["level"], 1) << "the header announces more";
  ASSERT_GE(cut["findings"].size(), 2U);
  EXPECT_EQ(cut["findings"][0]["level"], 1);
  EXPECT_EQ(cut["findings_left_out"], 0);

  const json less = outcome_of("printf 'inf 3\\n0 | 0\\n1 | 0\\n2 | 0\\n3 | 0\\n' > \"$2\"");
  EXPECT_EQ(less["outcome"], "fails");
  EXPECT_EQ(less["level"], 3);
  const auto missing = [](const json& finding) { return finding["reason"] == "missing"; };
  EXPECT_EQ(std::ranges::count_if(less["findings"], missing), 11);
  EXPECT_TRUE(less["message"].get<std::string>().starts_with("level 3: missing [FC-CLAIM-03]")) << less;

  const json turned =
      outcome_of(compute + "sed 's/\\(\"limits\":\\)\\[\\(.*\\),null\\]/\\1[null,\\2]/' all > \"$2\"");
  EXPECT_EQ(turned["outcome"], "fails");
  EXPECT_EQ(turned["level"], 4);
  ASSERT_FALSE(turned["findings"].empty());
  EXPECT_EQ(turned["findings"][0]["clause"], "FC-FLOW-07");
  // The same with the vector's limits turned instead: it is the vector that says what is right.
  const std::string folder = scratch_.path("vectors");
  fs::copy(few_vectors->folder(), folder);
  json file = json::parse(content_of(folder + "/unstable-manifolds.json"));
  for (json& x : file["cases"][1]["expected"]["stationary"]) {
    if (x.contains("limits")) std::reverse(x["limits"].begin(), x["limits"].end());
  }
  std::ofstream(folder + "/unstable-manifolds.json") << file;
  EXPECT_EQ(run({"--against", kCompute, "--case", kTetrahedron}, folder).status, 1);
  EXPECT_EQ(run({"--against", kCompute, "--case", "unstable-manifolds-0003"}, folder).status, 0);
}

TEST_F(ConformanceCommand, KnowsOutcomesApart) {
  CITES("FC-IN-05", "FC-CLAIM-01");
  expect_outcome("echo no idea >&2; exit 3", "refused", "exit status 3: no idea");
  expect_outcome("rm ../stderr; mkfifo ../stderr; exit 3", "refused", "exit status 3");
  expect_outcome("kill -SEGV $$", "crashed", "SIGSEGV");
  expect_outcome("sh -c 'kill -ABRT $$'; exit $?", "crashed", "SIGABRT");
  expect_outcome("exit 127", "crashed", "not started");
  expect_outcome("true", "unreadable", "claim: there is no such file");
  expect_outcome(": > \"$2\"", "unreadable", "claim: empty");
  expect_outcome("printf 'garbage \\001\\377' > \"$2\"", "unreadable", "claim:1: ");
  expect_outcome("echo 2,0,0,0,,0,1,9 > \"$2\"", "unreadable", "there is no point 9");
  expect_outcome("mkdir \"$2\"", "unreadable", "not a regular file");
  expect_outcome("mkfifo \"$2\"", "unreadable", "not a regular file");
  expect_outcome("ln -s /dev/zero \"$2\"", "unreadable", "not a regular file");
  expect_outcome("head -c 20000000 /dev/zero > \"$2\"", "unreadable", "20000000 bytes");
  expect_outcome("chmod 000 .", "unreadable", "claim: ");
}

TEST_F(ConformanceCommand, BoundsWhatAProgramTakes) {
  CITES("FC-CLAIM-01");
  expect_outcome("exec yes > \"$2\"", "crashed", "SIGXFSZ");
  expect_outcome("yes", "crashed", "SIGXFSZ");
  expect_outcome("exec yes >&2", "crashed", "SIGXFSZ");
  const std::string limits =
      "echo $(ulimit -v) $(ulimit -c) > " + scratch_.path("limits") + "; exit 1 # {in}";
  const Words words = {"conformance", "--vectors", few_vectors->folder(), "--against",
                       limits,        "--case",    kTetrahedron};
  EXPECT_EQ(flowcert(words).status, 1);
  EXPECT_EQ(content_of(scratch_.path("limits")), "4194304 0\n");
  Words unlimited = words;
  unlimited.insert(unlimited.end(), {"--memory-limit", "0"});
  EXPECT_EQ(flowcert(unlimited).status, 1);
  EXPECT_EQ(content_of(scratch_.path("limits")), "unlimited 0\n");
}

TEST_F(ConformanceCommand, EndsWhatHangsWithAllThatItStarted) {
  CITES("FC-CLAIM-01");
  const std::string file = scratch_.path("process");
  const std::string sleeper = "sleep 1000 & echo $! > " + file + "\n";
  expect_outcome("trap '' TERM INT HUP; while :; do sleep 1000; done", "timed out", "not done after 1 s");
  expect_outcome("sh -c '" + sleeper + " wait'; wait", "timed out", "not done after 1 s");
  EXPECT_FALSE(is_running(file)) << "a grandchild";
  expect_outcome("kill -STOP $$", "timed out", "not done after 1 s");
  // With a child in the background that holds its output open, it is done all the same.
  expect_outcome(sleeper + FLOWCERT_PROGRAM + " compute \"$1\" -o \"$2\"", "conforms", "");
  EXPECT_FALSE(is_running(file)) << "a child in the background";
}

TEST_F(ConformanceCommand, AsksThatWhatIsInvalidBeRefused) {
  CITES("FC-IN-01", "FC-IN-05");
  const Words invalid = {"--group", "invalid-input", "--flag", "overflow", "--flag", "short-row"};
  const auto report_of = [&](const std::string& command) {
    Words words = {"--against", command + " # {in}"};
    words.insert(words.end(), invalid.begin(), invalid.end());
    return as_json(words);
  };
  const json accepted = report_of("exit 0");
  const json refused = report_of("exit 1");
  const json crashed = report_of("kill -SEGV $$");
  EXPECT_EQ(accepted["verdict"], "fails");
  EXPECT_EQ(refused["verdict"], "conforms");
  EXPECT_EQ(crashed["verdict"], "fails");
  ASSERT_EQ(accepted["cases"].size(), refused["cases"].size());
  std::size_t skipped = 0;
  for (std::size_t k = 0; k < accepted["cases"].size(); ++k) {
    const bool is_skipped = refused["cases"][k]["outcome"] == "skipped";
    skipped += is_skipped ? 1 : 0;
    EXPECT_EQ(accepted["cases"][k]["outcome"], is_skipped ? "skipped" : "accepted");
    EXPECT_EQ(refused["cases"][k]["outcome"], is_skipped ? "skipped" : "properly refused");
    EXPECT_EQ(crashed["cases"][k]["outcome"], is_skipped ? "skipped" : "crashed");
  }
  EXPECT_GE(skipped, 2U) << "those with a start";
  EXPECT_EQ(refused["groups"][0]["cases"], refused["cases"].size() - skipped);
  // Starts, which only the other command can refuse.
  const Words start = {"--against", "exit 9 # {in}", "--case", "invalid-input-0030"};
  EXPECT_EQ(run(start).status, 2);
  Words with_orbits = start;
  with_orbits.insert(with_orbits.end(), {"--orbits-against", "echo {start} > /dev/null; exit 1 # {in}"});
  EXPECT_EQ(run(with_orbits).status, 0);
  with_orbits.back() = "exit 0 # {in} {start}";
  EXPECT_EQ(run(with_orbits).status, 1);
}

TEST_F(ConformanceCommand, ComparesOrbits) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-CLAIM-07");
  const auto outcome = [&](const std::string& id, const std::string& change) {
    const std::string orbits =
        std::string(FLOWCERT_PROGRAM) + " orbit {in} --from {start} --json | sed '" + change + "'";
    const json report = as_json({"--against", kCompute, "--orbits-against", orbits, "--case", id});
    return only_case_of(report);
  };
  EXPECT_EQ(outcome(kTetrahedronOrbits, "")["outcome"], "conforms");
  EXPECT_EQ(outcome(kTetrahedronOrbits, "s/\"[a-z]*_contact\":[^]]*\\],*//g")["outcome"], "unreadable")
      << "a comma too many";
  EXPECT_EQ(outcome(kTetrahedronOrbits, "s/\"start_contact\":[^]]*\\],//g")["outcome"], "conforms");
  for (const std::string change :
       {"s/\\(\"squared_distance\":\"\\)/\\11/", "s/\"index\":3/\"index\":2/",
        "s/\"type\":\"C-C/\"type\":\"F-F/", "s/\\(\"driver\":\\[\"\\)/\\11/",
        "s/\\(\"crossed_contact\":\\)\\[[0-9]*/\\1[7/", "s/\"critical\"/\"regular\"/"}) {
    const json one = outcome(kTetrahedronOrbits, change);
    EXPECT_EQ(one["outcome"], "fails") << change << one;
    EXPECT_TRUE(one["level"].is_null());
    ASSERT_FALSE(one["orbit_findings"].empty()) << change << one;
    EXPECT_EQ(one["orbit_findings"][0]["permitted"], false);
    EXPECT_TRUE(one["message"].get<std::string>().starts_with("orbit from ")) << one;
  }
  EXPECT_EQ(outcome(kTetrahedronOrbits, "s/.*/no JSON/")["outcome"], "unreadable");
  EXPECT_EQ(outcome(kTetrahedronOrbits, "s/\"limit\"/\"l\"/")["outcome"], "unreadable");
  // From a regular stationary point a perturbation lets an orbit go on; from nowhere else.
  const json varied =
      outcome(kTriangleOrbits, "s/\"limit\":{\"kind\":\"regular\".*/\"limit\":{\"kind\":\"infinity\"}}/");
  EXPECT_EQ(varied["outcome"], "conforms where determined") << varied;
  ASSERT_EQ(varied["orbit_findings"].size(), 2U);
  EXPECT_EQ(varied["orbit_findings"][0]["permitted"], true);
  EXPECT_EQ(outcome(kTetrahedronOrbits,
                    "s/\"limit\":{\"kind\":\"critical\".*/\"limit\":{\"kind\":\"infinity\"}}/")["outcome"],
            "fails");
}

TEST_F(ConformanceCommand, ComparesPersistencePairs) {
  CITES("FC-PERS-01", "FC-PERS-02", "FC-PERS-03", "FC-PERS-05");
  const auto outcome = [&](const std::string& command) {
    const json report = as_json(
        {"--against", kCompute, "--persistence-against", command + " # {in}", "--case", kTrianglePairs});
    EXPECT_EQ(report["persistence_command"], command + " # {in}");
    return only_case_of(report);
  };
  const auto text = [&](const std::string& pairs) { return outcome("printf '" + pairs + "'"); };
  const auto changed = [&](const std::string& change) {
    return outcome(std::string(FLOWCERT_PROGRAM) + " persistence points.xyz --json | sed '" + change + "'");
  };
  const auto expect_wrong = [](const json& one, const std::string& claimed, const std::string& truth) {
    EXPECT_EQ(one["outcome"], "fails") << one;
    EXPECT_TRUE(one["level"].is_null());
    ASSERT_FALSE(one["persistence_findings"].empty()) << one;
    EXPECT_EQ(one["persistence_findings"][0]["claimed"], claimed);
    EXPECT_EQ(one["persistence_findings"][0]["truth"], truth);
    EXPECT_EQ(one["message"], "persistence: claimed " + claimed + "; truth: " + truth);
  };
  const std::string components = "0 0 inf\n0 0 2.5\n0 0 4\n", none = "no such pair";
  // Right ones: in any order, with pairs of length zero, with decimals of the same nearest doubles.
  EXPECT_EQ(text("# of a triangle\n" + components + "1 4.5 5\n")["outcome"], "conforms");
  EXPECT_EQ(text("1 4.50000000000000000001 5e0 # late\n\n2 7 7\n" + components)["outcome"], "conforms");
  EXPECT_EQ(changed("")["outcome"], "conforms");
  // Wrong ones, by name.
  expect_wrong(text(components + "1 4.5 5.000000000000001\n"),
               "dimension 1, birth 4.5, death 5.000000000000001", "dimension 1, birth 4.5, death 5");
  expect_wrong(text(components), none, "dimension 1, birth 4.5, death 5");
  expect_wrong(text(components + "1 4.5 5\n1 4.5 5\n"), "dimension 1, birth 4.5, death 5", none);
  expect_wrong(text(components + "2 4.5 5\n"), none, "dimension 1, birth 4.5, death 5");
  expect_wrong(text("0 0 2.5\n0 0 4\n1 4.5 5\n"), none, "dimension 0, birth 0, death inf");
  expect_wrong(changed("s/\"squared_distance\":\"9\\/2\"/\"squared_distance\":\"13\\/3\"/"),
               "dimension 1, birth 13/3, death 5", "dimension 1, birth 9/2, death 5");
  expect_wrong(changed("s/\"death\":{\"contact\":\\[0,1,2\\][^}]*}/\"death\":null/"),
               "dimension 1, birth 9/2, death inf", "dimension 1, birth 9/2, death 5");
}

TEST_F(ConformanceCommand, KnowsOutcomesOfThePersistenceCommandApart) {
  CITES("FC-PERS-01", "FC-IN-05");
  const auto expect = [&](const std::string& command, const std::string& outcome,
                          const std::string& message) {
    const json one = only_case_of(as_json(
        {"--against", kCompute, "--persistence-against", command + " # {in}", "--case", kTrianglePairs}));
    EXPECT_EQ(one["outcome"], outcome) << one;
    EXPECT_NE(one["message"].get<std::string>().find(message), std::string::npos) << one;
    EXPECT_EQ(one["persistence_findings"], json::array());
  };
  expect("true", "unreadable", "standard output: empty");
  expect("echo nonsense", "unreadable", "standard output:1: not the three words");
  expect("printf '# x\n3 1 2\n'", "unreadable", "standard output:2: no dimension");
  expect("echo 1 x 2", "unreadable", "no squared distance: 'x'");
  expect("echo 1 nan inf", "unreadable", "no squared distance: 'nan'");
  expect("echo '{}'", "unreadable", "no key 'pairs'");
  expect("echo '{'", "unreadable", "standard output");
  expect("echo '{\"pairs\":[{\"dimension\":0,\"birth\":{\"squared_distance\":0.5},\"death\":null}]}'",
         "unreadable", "'squared_distance' is no string");
  expect("echo no >&2; exit 3", "refused", "exit status 3: no");
  expect("kill -SEGV $$", "crashed", "SIGSEGV");
  const json missing = only_case_of(
      as_json({"--against", kCompute, "--persistence-against", "true {in} {out}", "--case", kTrianglePairs}));
  EXPECT_EQ(missing["outcome"], "unreadable") << missing;
  EXPECT_EQ(missing["message"], "persistence: there is no such file");
  // The claim that failed before keeps its message, and the pairs are judged all the same.
  const json both =
      only_case_of(as_json({"--against", script("echo '# nothing' > \"$2\""), "--persistence-against",
                            "echo 0 0 inf # {in}", "--case", kTrianglePairs}));
  EXPECT_EQ(both["level"], 3);
  EXPECT_TRUE(both["message"].get<std::string>().starts_with("level 3")) << both;
  EXPECT_EQ(both["persistence_findings"].size(), 3U);
}

// ---- Choosing, reports, what is kept

TEST_F(ConformanceCommand, ChoosesCases) {
  CITES("FC-IN-04");
  const auto listed = [](Words words) {
    words.emplace_back("--list");
    const Finished finished = run(words, FLOWCERT_VECTORS);
    EXPECT_EQ(finished.status, 0) << finished.err;
    return lines_of(finished.out);
  };
  EXPECT_EQ(listed({}).size(), vector_cases().size());
  const auto collinear = listed({"--flag", "collinear"});
  EXPECT_GT(collinear.size(), 2U);
  for (const std::string& line : collinear) EXPECT_NE(line.find("collinear"), std::string::npos) << line;
  for (const std::string& line : listed({"--group", "orbits", "--flag", "collinear"})) {
    EXPECT_TRUE(line.starts_with("  orbits-")) << line;
  }
  EXPECT_EQ(listed({"--case", kTetrahedron, "--case", kTriangleOrbits}).size(), 2U);
  const auto refuses = [](const Words& words, const std::string& what) {
    const Finished finished = run(words);
    EXPECT_EQ(finished.status, 2) << finished.out;
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
  };
  refuses({"--list", "--flag", "no-flag"}, "there is no flag 'no-flag'");
  refuses({"--list", "--group", "no-group"}, "there is no group 'no-group'");
  refuses({"--list", "--case", "orbits-9999"}, "there is no case 'orbits-9999'");
  refuses({"--list", "--case", kTetrahedron, "--group", "orbits"}, "no case is in all of");
  refuses({}, "--against");
  refuses({"--against", "true"}, "{in}");
  refuses({"--against", "true {in}", "--orbits-against", "true {in}"}, "{start}");
  refuses({"--against", "true {in}", "--persistence-against", "true"}, "{in}");
  refuses({"--against", "true {in}", "--time-limit", "nan"}, "--time-limit");
  refuses({"--against", "true {in}", "--out-name", "../claim"}, "--out-name");
  refuses({"--against", "true {in}", "--junit", scratch_.path("none/report.xml")}, "none/report.xml");
}

TEST_F(ConformanceCommand, RefusesVectorsThatItCannotUse) {
  CITES("FC-IN-05");
  const std::string folder = scratch_.path("vectors");
  const auto refuses = [&](const std::string& name, const std::string& content, const std::string& what) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    for (const char* file : {"flags.json", "duplicates.json"}) {
      fs::copy_file(fs::path(FLOWCERT_VECTORS) / file, fs::path(folder) / file);
    }
    EXPECT_EQ(flowcert({"conformance", "--vectors", folder, "--list"}).status, 0);
    std::ofstream(folder + "/" + name) << content;
    const Finished finished = flowcert({"conformance", "--vectors", folder, "--list"});
    EXPECT_EQ(finished.status, 2) << finished.out;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
  };
  const json whole = json::parse(content_of(std::string(FLOWCERT_VECTORS) + "/duplicates.json"));
  const auto damaged = [&](const std::string& pointer, const json& value) {
    json file = whole;
    file[json::json_pointer(pointer)] = value;
    return file.dump();
  };
  const std::string name = "duplicates.json";
  refuses(name, whole.dump().substr(0, 1000), name);
  refuses(name, damaged("/format_version", 2), "version 1");
  refuses(name, damaged("/cases/0/flags/0", "unheard-of"), "'unheard-of'");
  refuses(name, damaged("/cases/1/id", whole["cases"][0]["id"]), "two cases");
  refuses(name, damaged("/cases/0/id", "../somewhere"), "case 1");
  refuses(name, damaged("/cases/2/points/0/0", "one"), "case 3");
  refuses(name, damaged("/cases/0/expected/stationary/0/contact", {1000000}), "case 1");
  refuses(name, damaged("/cases/0/expected/stationary/0/center/0", "1/0"), "case 1");
  refuses(name, damaged("/cases/0/result", "unknown"), "'unknown'");
  json turned = whole;
  std::reverse(turned["cases"][3]["expected"]["stationary"].begin(),
               turned["cases"][3]["expected"]["stationary"].end());
  refuses(name, turned.dump(), "not in order");
  refuses("flags.json", "{}", "flags.json");
  const auto damaged_other = [](const std::string& group, const std::string& id, const std::string& pointer,
                                const json& value) {
    json file = json::parse(content_of(std::string(FLOWCERT_VECTORS) + "/" + group + ".json"));
    std::erase_if(file["cases"].get_ref<json::array_t&>(), [&](const json& one) { return one["id"] != id; });
    file[json::json_pointer("/cases/0/expected/" + pointer)] = value;
    return file.dump();
  };
  const auto refuses_pairs = [&](const std::string& pointer, const json& value, const std::string& what) {
    refuses("persistence.json", damaged_other("persistence", kTrianglePairs, pointer, value), what);
  };
  refuses_pairs("persistence/0/dimension", 3, "'dimension'");
  refuses_pairs("persistence/0/birth", "1/0", "no rational");
  refuses_pairs("persistence/3/death", "9/2", "of no length");
  refuses_pairs("persistence/0/death", "100", "not in order");
  refuses_pairs("persistence", 5, "no array");
  const auto refuses_stable = [&](const std::string& pointer, const json& value, const std::string& what) {
    refuses(
        "stable-manifolds.json",
        damaged_other("stable-manifolds", "stable-manifolds-0005", "stationary/6/stable/" + pointer, value),
        what);
  };
  refuses_stable("segments", "three", "case 1");
  refuses_stable("boundary/0", {0, 1, 2}, "a boundary with what");
  refuses_stable("boundary/0", {0, 9}, "none of the points");
  refuses_stable("boundary/0", {1, 2}, "a boundary that is not in order");
  refuses_stable("walk/0", 3, "a walk along");
  EXPECT_EQ(flowcert({"conformance", "--vectors", scratch_.path("none"), "--list"}).status, 2);
}

TEST_F(ConformanceCommand, FindsTheVectorsThatAreInstalledWithIt) {
  CITES("FC-IN-04");
  const fs::path prefix = scratch_.path("prefix");
  fs::create_directories(prefix / "bin");
  fs::copy_file(FLOWCERT_PROGRAM, prefix / "bin" / "flowcert");
  const Words list = {(prefix / "bin" / "flowcert").string(), "conformance", "--list"};
  EXPECT_EQ(lines_of(RunningProgram(list).finish().out).size(), vector_cases().size()) << "the source tree's";
  const fs::path vectors = prefix / "share" / "flowcert" / "vectors";
  fs::create_directories(vectors);
  for (const char* file : {"flags.json", "invalid-input.json"}) {
    fs::copy_file(fs::path(FLOWCERT_VECTORS) / file, vectors / file);
  }
  for (const std::string& line : lines_of(RunningProgram(list).finish().out)) {
    EXPECT_TRUE(line.starts_with("  invalid-input-")) << line;
  }
}

TEST_F(ConformanceCommand, PrintsATable) {
  CITES("FC-CLAIM-03");
  const std::string no = script("test $(wc -l < \"$1\") -gt 3 || exit 1\n" + std::string(FLOWCERT_PROGRAM) +
                                " compute \"$1\" -o \"$2\"");
  const Words words = {"--against",     no,       "--case",           "flat-inputs-0003", "--case",
                       kTriangleOrbits, "--case", "flat-inputs-0005", "--case",           kTetrahedron,
                       "--most",        "1"};
  const Finished finished = run(words);
  EXPECT_EQ(finished.status, 1);
  const auto lines = lines_of(finished.out);
  const auto has_line = [&](const std::string& start, const std::string& end) {
    return std::ranges::any_of(
        lines, [&](const std::string& line) { return line.starts_with(start) && line.ends_with(end); });
  };
  EXPECT_TRUE(
      has_line("  flag", "cases  conforms  where determined  fails  refused  crashed  timed out  unreadable"))
      << finished.out;
  EXPECT_TRUE(has_line("  flat-inputs",
                       "2         1                 0      0        1        0          0           0"))
      << finished.out;
  EXPECT_TRUE(has_line("flat-inputs-0003 (", "): refuses what is valid")) << finished.out;
  EXPECT_TRUE(has_line("  exit status 1", "")) << finished.out;
  EXPECT_TRUE(has_line("not judged: the orbits of 1 case, without --orbits-against", "")) << finished.out;
  EXPECT_TRUE(has_line("and 1 more; --most shows more", "")) << finished.out;
  EXPECT_TRUE(has_line("4 cases in ", ": 2 conform, 0 where determined, 2 negative")) << finished.out;
  EXPECT_EQ(lines.back(), "fails");
  EXPECT_EQ(finished.err, "");
}

// The name of each element, and whether the document is one.
std::vector<std::string> elements_of(const std::string& document) {
  std::vector<std::string> names;
  XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &names);
  XML_SetStartElementHandler(parser, [](void* user, const XML_Char* name, const XML_Char** /*attributes*/) {
    static_cast<std::vector<std::string>*>(user)->emplace_back(name);
  });
  EXPECT_EQ(XML_Parse(parser, document.data(), static_cast<int>(document.size()), 1), XML_STATUS_OK)
      << document;
  XML_ParserFree(parser);
  return names;
}

TEST_F(ConformanceCommand, WritesAReportForCiSystems) {
  CITES("FC-CLAIM-03");
  const std::string path = scratch_.path("report & more.xml");
  const Words words = {"--against", script("echo 'a <b> & \001 \"c\"' >&2; exit 1"),
                       "--case",    kTetrahedron,
                       "--case",    "invalid-input-0001",
                       "--case",    "invalid-input-0030",
                       "--junit",   path};
  EXPECT_EQ(run(words).status, 1);
  const std::vector<std::string> names = elements_of(content_of(path));
  EXPECT_EQ(names, (Words{"testsuites", "testsuite", "testcase", "testcase", "skipped", "testsuite",
                          "testcase", "failure"}));
  EXPECT_NE(content_of(path).find("<testsuite name=\"unstable-manifolds\" tests=\"1\" failures=\"1\" "
                                  "errors=\"0\" skipped=\"0\""),
            std::string::npos)
      << content_of(path);
  EXPECT_NE(content_of(path).find("a &lt;b&gt; &amp; ? &quot;c&quot;"), std::string::npos)
      << content_of(path);
}

TEST_F(ConformanceCommand, KeepsWhatIsNeededToSeeForOneself) {
  CITES("FC-CLAIM-03");
  const std::string folder = scratch_.path("kept/here");
  const std::string command = script("echo said; echo complained >&2; echo '# nothing' > \"$2\"");
  EXPECT_EQ(
      run({"--against", command, "--case", kTetrahedron, "--case", "flat-inputs-0001", "--keep", folder})
          .status,
      1);
  EXPECT_FALSE(fs::exists(folder + "/flat-inputs-0001")) << "nothing is right for no points";
  const std::string kept = folder + "/" + kTetrahedron;
  EXPECT_EQ(content_of(kept + "/points.xyz"), "0 0 0\n1 1 0\n1 0 1\n0 1 1\n");
  EXPECT_EQ(content_of(kept + "/claim"), "# nothing\n");
  EXPECT_EQ(content_of(kept + "/stdout"), "said\n");
  EXPECT_EQ(content_of(kept + "/stderr"), "complained\n");
  EXPECT_EQ(json::parse(content_of(kept + "/case.json"))["id"], kTetrahedron);
  EXPECT_EQ(flowcert({"check", kept + "/points.xyz", kept + "/claim"}).status, 1);
  // Another run leaves nothing of this one, and does not wait for a pipe.
  EXPECT_EQ(run({"--against", script("mkfifo \"$2\""), "--case", kTetrahedron, "--keep", folder}).status, 1);
  EXPECT_FALSE(fs::exists(kept + "/claim"));
  EXPECT_EQ(content_of(kept + "/stdout"), "");
}

TEST_F(ConformanceCommand, EndsOnCtrlCWithAllThatItStarted) {
  CITES("FC-CLAIM-01");
  const std::string file = scratch_.path("process");
  const std::string sleeper = script("sleep 1000 & echo $! > " + file + "; wait");
  Words words = command({"--against", sleeper, "--case", kTetrahedron, "--time-limit", "600"});
  words.insert(words.begin(), FLOWCERT_PROGRAM);
  RunningProgram program(words);
  wait_for(file);
  EXPECT_TRUE(is_running(file));
  EXPECT_FALSE(fs::is_empty(temporary_));
  program.signal(SIGINT);
  const Finished finished = program.finish();
  EXPECT_EQ(finished.status, 130);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err, "flowcert: interrupted\n");
  EXPECT_FALSE(is_running(file));
}

// The README's example, in a folder with a program build/flowcert.
TEST_F(ConformanceCommand, DoesWhatTheReadmeSays) {
  CITES("FC-CLAIM-03");
  const auto lines = lines_of(content_of(FLOWCERT_README));
  auto line = std::ranges::find(lines, "<!-- example: conformance -->");
  ASSERT_LT(line, lines.end() - 3);
  const std::string typed = *(line += 2);
  ASSERT_TRUE(typed.starts_with("$ ")) << typed;
  fs::create_directory(scratch_.path("build"));
  fs::create_symlink(FLOWCERT_PROGRAM, scratch_.path("build/flowcert"));
  const Finished finished =
      RunningProgram({"/bin/sh", "-c", "cd " + scratch_.path("") + " && " + typed.substr(2)}).finish();
  EXPECT_EQ(finished.status, 0) << finished.err;
  const auto printed = lines_of(finished.out);
  for (++line; line != lines.end() && !line->starts_with("```"); ++line) {
    EXPECT_TRUE(*line == "..." || std::ranges::find(printed, *line) != printed.end())
        << *line << finished.out;
  }
}

// A path that means something only where the user is.
TEST_F(ConformanceCommand, AsksForFullPaths) {
  CITES("FC-IN-05");
  const std::string relative = fs::relative(FLOWCERT_PROGRAM, fs::current_path()).string();
  const std::string path = relative.find('/') == std::string::npos ? "./" + relative : relative;
  const Finished finished = run({"--against", path + " compute {in} -o {out}", "--case", kTetrahedron});
  EXPECT_EQ(finished.status, 2) << finished.out;
  EXPECT_NE(finished.err.find("$PWD/"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace flowcert::conformance
