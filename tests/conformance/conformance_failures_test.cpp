// `flowcert conformance` on programs that answer the conformance vectors wrongly, or not at all
// (spec/formats/conformance.md).
//
// Guarantees: whatever a program does, crash, hang, fork, or fill the disk, the run comes to its end and says
// so, leaves nothing behind and no process running.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/cites.h"
#include "tests/conformance/conformance_fixture.h"

namespace flowcert::conformance::conformance_failures_test {
namespace {

bool is_running(const std::string& process_file) { return ::kill(std::stoi(content_of(process_file)), 0) == 0; }

void wait_for(const std::string& file) {
  for (int tries = 0; tries < 2000 && !content_of(file).ends_with('\n'); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

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

  const json turned = outcome_of(compute + "sed 's/\\(\"limits\":\\)\\[\\(.*\\),null\\]/\\1[null,\\2]/' all > \"$2\"");
  EXPECT_EQ(turned["outcome"], "fails");
  EXPECT_EQ(turned["level"], 4);
  ASSERT_FALSE(turned["findings"].empty());
  EXPECT_EQ(turned["findings"][0]["clause"], "FC-FLOW-07");
  // The same with the vector's limits turned instead: it is the vector that says what is right.
  const std::string folder = scratch_.path("vectors");
  fs::copy(few_vectors->folder(), folder);
  json file = json::parse(content_of(folder + "/unstable-manifolds.json"));
  for (json& x : file["cases"][1]["expected"]["stationary"]) {
    if (!x.contains("limits")) continue;
    std::reverse(x["limits"].begin(), x["limits"].end());
    x["incidences"]["limits"] = x["limits"];
  }
  std::ofstream(folder + "/unstable-manifolds.json") << file;
  EXPECT_EQ(run({"--against", kCompute, "--case", kTetrahedron}, folder).status, 1);
  EXPECT_EQ(run({"--against", kCompute, "--case", "unstable-manifolds-0003"}, folder).status, 0);
}

TEST_F(ConformanceCommand, KnowsOutcomesApart) {
  CITES("FC-IN-05", "FC-CLAIM-01", "FC-FILE-29");
  expect_outcome("echo no idea >&2; exit 3", "refused", "exit status 3: no idea");
  expect_outcome("rm ../stderr; mkfifo ../stderr; exit 3", "refused", "exit status 3");
  expect_outcome("kill -SEGV $$", "crashed", "SIGSEGV");
  expect_outcome("sh -c 'kill -ABRT $$'; exit $?", "crashed", "SIGABRT");
  // The first run, on two points, only shows whether there is such a command.
  expect_outcome("[ $(wc -l < \"$1\") = 2 ] || exit 127", "crashed", "not started");
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
  const std::string limits = "echo $(ulimit -v) $(ulimit -c) > " + scratch_.path("limits") + "; exit 1 # {in}";
  const Words words = {"conformance", "--vectors", few_vectors->folder(), "--against", limits, "--case", kTetrahedron};
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
  // A child in the background holds the program's output open. The case is done all the same.
  expect_outcome(sleeper + FLOWCERT_PROGRAM + " compute \"$1\" -o \"$2\"", "conforms", "");
  EXPECT_FALSE(is_running(file)) << "a child in the background";
}

// A process that leaves the command's group and session is found all the same, however far away its parents ended.
TEST_F(ConformanceCommand, EndsWhatHasLeftTheGroup) {
  CITES("FC-CLAIM-01");
  const std::string file = scratch_.path("process");
  const std::string wait_for_it = "; while ! [ -s " + file + " ]; do sleep 0.01; done; ";
  const std::string right = FLOWCERT_PROGRAM + std::string(" compute \"$1\" -o \"$2\"");
  const std::string sleeper = "sh -c \"echo \\$\\$ > " + file + "; exec sleep 1000\"";
  for (const std::string& start :
       {"setsid " + sleeper + " &", "setsid sh -c '(setsid " + sleeper + " &) &' &",
        "setsid sh -c 'trap \"\" TERM HUP INT; (" + sleeper + " &); sleep 1000' >/dev/null 2>&1 &"}) {
    SCOPED_TRACE(start);
    const std::string started = "rm -f " + file + "\n" + start + " true" + wait_for_it;
    expect_outcome(started + right, "conforms", "");
    EXPECT_FALSE(is_running(file)) << "after the command";
    expect_outcome(started + "sleep 1000", "timed out", "not done after 1 s");
    EXPECT_FALSE(is_running(file)) << "after the time limit";
  }
}

TEST_F(ConformanceCommand, AsksThatWhatIsInvalidBeRefused) {
  CITES("FC-IN-01", "FC-IN-05", "FC-FILE-26", "FC-FILE-29");
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
  // Only the other command can refuse a start.
  const Words start = {"--against", "exit 9 # {in}", "--case", "invalid-input-0030"};
  EXPECT_EQ(run(start).status, 2);
  Words with_orbits = start;
  with_orbits.insert(with_orbits.end(), {"--orbits-against", "echo {start} > /dev/null; exit 1 # {in}"});
  EXPECT_EQ(run(with_orbits).status, 0);
  with_orbits.back() = "exit 0 # {in} {start}";
  EXPECT_EQ(run(with_orbits).status, 1);
}

TEST_F(ConformanceCommand, ComparesOrbits) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-CLAIM-07", "FC-FILE-27");
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
  for (const std::string change : {"s/\\(\"squared_distance\":\"\\)/\\11/", "s/\"index\":3/\"index\":2/",
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
  // A perturbation lets an orbit go on from a regular stationary point, and from nowhere else.
  const std::string infinity = "\"limit\":{\"kind\":\"infinity\"}}/";
  const std::string away = "{\"type\":\"E-F-inf\",\"driver\":[\"2\",\"2\",\"0\"],\"end\":null}";
  const json varied =
      outcome(kTriangleOrbits, "s/\\],\"limit\":{\"kind\":\"regular\".*/," + away + "]," + infinity + "; s/\\[,/[/");
  EXPECT_EQ(varied["outcome"], "perturbed") << varied;
  ASSERT_EQ(varied["orbit_findings"].size(), 2U);
  EXPECT_EQ(varied["orbit_findings"][0]["permitted"], true);
  EXPECT_EQ(outcome(kTriangleOrbits, "s/\"limit\":{\"kind\":\"regular\".*/" + infinity)["outcome"], "fails");
  EXPECT_EQ(outcome(kTetrahedronOrbits, "s/\"limit\":{\"kind\":\"critical\".*/" + infinity)["outcome"], "fails");
}

// The first orbit of the tetrahedron is one segment, of type C-C-V, from the sample 0 to the maximum. The
// first orbit of the triangle has three segments and goes to infinity.
TEST_F(ConformanceCommand, SaysWhereAnOrbitIsWrong) {
  CITES("FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07");
  const auto expect = [&](const std::string& id, const std::string& change, const std::string& claimed,
                          const std::string& truth) {
    const std::string orbits =
        std::string(FLOWCERT_PROGRAM) + " orbit {in} --from {start} --json | sed '" + change + "'";
    const json one = only_case_of(as_json({"--against", kCompute, "--orbits-against", orbits, "--case", id}));
    EXPECT_EQ(one["outcome"], "fails") << change;
    ASSERT_FALSE(one["orbit_findings"].empty()) << change << one;
    EXPECT_EQ(one["orbit_findings"][0]["claimed"], claimed) << change;
    EXPECT_EQ(one["orbit_findings"][0]["truth"], truth) << change;
  };
  const auto of_tetrahedron = [&](const std::string& change, const std::string& claimed, const std::string& truth) {
    expect(kTetrahedronOrbits, change, claimed, truth);
  };
  const std::string top = "(1/2, 1/2, 1/2)", maximum = "critical point of index 3 at " + top;
  of_tetrahedron("s/\"end\":\\[\"1\\/2/\"end\":[\"3\\/2/", "segment 1: end (3/2, 1/2, 1/2)", top);
  of_tetrahedron("s/\"end\":\\[[^]]*\\]/\"end\":null/", "segment 1: end infinity", top);
  of_tetrahedron("s/\"driver\":\\[\"0/\"driver\":[\"1\\/3/", "segment 1: driver (1/3, 0, 0)", "(0, 0, 0)");
  of_tetrahedron("s/\"type\":\"C/\"type\":\"a type of more than forty letters, which are cut off/",
                 "segment 1: type a type of more than forty letters, which...", "C-C-V");
  of_tetrahedron("s/\"start_contact\":\\[0\\]/\"start_contact\":[2,1]/", "segment 1: start, contact set 1 2",
                 "contact set 0");
  of_tetrahedron("s/\"crossed_contact\":\\[0\\]/\"crossed_contact\":[]/", "segment 1: on the way, contact set ",
                 "contact set 0");
  of_tetrahedron("s/\"end_contact\":\\[0,/\"end_contact\":[/", "segment 1: end, contact set 1 2 3",
                 "contact set 0 1 2 3");
  of_tetrahedron("s/\"segments\":\\[.*\\],\"limit/\"segments\":[],\"limit/", "0 segments", "1");
  of_tetrahedron("s/\"limit\":.*/\"limit\":{\"kind\":\"infinity\"}}/", "limit infinity", maximum);
  of_tetrahedron("s/\"index\":3/\"index\":[2,3]/", "limit critical point of index [2,3] at " + top, maximum);
  of_tetrahedron("s/\"position\":\\[\"1/\"position\":[\"3/", "limit critical point of index 3 at (3/2, 1/2, 1/2)",
                 maximum);
  of_tetrahedron("s/\"contact\":\\[0,/\"contact\":[/", "limit, contact set 1 2 3", "contact set 0 1 2 3");
  of_tetrahedron("s/\"squared_distance\":\"3\\/4/\"squared_distance\":\"1\\/2/", "limit, squared distance 1/2", "3/4");
  const std::string place = "s/\"end\":null,\"start/\"end\":[\"1\",\"2\",\"3\"],\"start/";
  expect(kTriangleOrbits, place, "segment 3: end (1, 2, 3)", "infinity");
  expect(kTriangleOrbits,
         "s/\"kind\":\"infinity\".*/\"kind\":\"critical\",\"index\":3,\"position\":[\"1\",\"2\",\"3\"],"
         "\"contact\":[0],\"squared_distance\":\"1\"}}/",
         "limit critical point of index 3 at (1, 2, 3)", "infinity");
}

TEST_F(ConformanceCommand, KnowsOutcomesOfTheOrbitCommandApart) {
  CITES("FC-FLOW-02", "FC-IN-05");
  const auto expect = [&](const std::string& change, const std::string& message) {
    const std::string orbits =
        std::string(FLOWCERT_PROGRAM) + " orbit {in} --from {start} --json | sed '" + change + "'";
    const json one =
        only_case_of(as_json({"--against", kCompute, "--orbits-against", orbits, "--case", kTetrahedronOrbits}));
    EXPECT_EQ(one["outcome"], "unreadable") << change;
    EXPECT_EQ(one["message"], message) << change;
  };
  expect("s/.*/[1]/", "no object that could have 'segments'");
  expect("s/\"segments\":\\[.*\\],\"limit/\"segments\":{},\"limit/", "'segments' is no array");
  expect("s/\"segments\":\\[.*\\],\"limit/\"segments\":[7],\"limit/", "no object that could have 'type'");
  expect("s/\"type\":\"[^\"]*\"/\"type\":7/", "'type' is no string");
  expect("s/\"type\"/\"kind\"/", "no key 'type'");
  expect("s/\"driver\":\\[/\"driver\":[\"1\",/", "'driver' is no array of three rationals");
  expect("s/\"driver\":\\[[^]]*\\]/\"driver\":\"0 0 0\"/", "'driver' is no array of three rationals");
  expect("s/\"driver\":\\[\"0\"/\"driver\":[0/", "'driver' is no string");
  expect("s/\"driver\":\\[\"0\"/\"driver\":[\"zero\"/", "no rational: 'zero'");
  for (const std::string id : {"-1", "2147483648", "\"0\"", "0.5"}) {
    expect("s/\"start_contact\":\\[0\\]/\"start_contact\":[" + id + "]/",
           "'start_contact' has something that is no id");
  }
  expect("s/\"start_contact\":\\[0\\]/\"start_contact\":0/", "'start_contact' is no array");
  expect("s/\"limit\":.*/\"limit\":null}/", "no object that could have 'kind'");
  expect("s/\"kind\":\"critical\"/\"kind\":3/", "'kind' is no string");
  expect("s/\"squared_distance\":\"[^\"]*\"/\"squared_distance\":null/", "'squared_distance' is no string");
}

TEST_F(ConformanceCommand, ComparesPersistencePairs) {
  CITES("FC-PERS-01", "FC-PERS-02", "FC-PERS-03", "FC-PERS-05", "FC-FILE-28");
  const auto outcome = [&](const std::string& command) {
    const json report =
        as_json({"--against", kCompute, "--persistence-against", command + " # {in}", "--case", kTrianglePairs});
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
  // These pairs are right: in any order, with pairs of length zero, with decimals of the same nearest doubles.
  EXPECT_EQ(text("# of a triangle\n" + components + "1 4.5 5\n")["outcome"], "conforms");
  EXPECT_EQ(text("1 4.50000000000000000001 5e0 # late\n\n2 7 7\n" + components)["outcome"], "conforms");
  EXPECT_EQ(changed("")["outcome"], "conforms");
  // GUDHI's tools write the characteristic of the field in front.
  EXPECT_EQ(text("2  0 0 inf \n2  0 0 2.5 \n11 0 0 4\n2  1 4.5 5\n")["outcome"], "conforms");
  // Decimals are right within the tolerance, and pairs within twice of it are as good as none.
  EXPECT_EQ(
      text("0 0 2.5000000001\n" + components.substr(0, 8) + "0 0 4\n1 4.4999999999 5.000000000000001\n")["outcome"],
      "conforms");
  EXPECT_EQ(text("1 4.5 5\n2 7 7.00000001\n" + components)["outcome"], "conforms");
  // These pairs are wrong, and each finding names a pair.
  expect_wrong(text(components + "1 4.5 5.00000001\n"), "dimension 1, birth 4.5, death 5.00000001",
               "dimension 1, birth 4.5, death 5");
  expect_wrong(text(components + "1 4.5 5\n2 7 7.0000001\n"), "dimension 2, birth 7, death 7.0000001", none);
  expect_wrong(text(components), none, "dimension 1, birth 4.5, death 5");
  expect_wrong(text(components + "1 4.5 5\n1 4.5 5\n"), "dimension 1, birth 4.5, death 5", none);
  expect_wrong(text(components + "2 4.5 5\n"), none, "dimension 1, birth 4.5, death 5");
  expect_wrong(text("0 0 2.5\n0 0 4\n1 4.5 5\n"), none, "dimension 0, birth 0, death inf");
  expect_wrong(changed("s/\"squared_distance\":\"9\\/2\"/\"squared_distance\":\"13\\/3\"/"),
               "dimension 1, birth 13/3, death 5", "dimension 1, birth 9/2, death 5");
  expect_wrong(changed("s/\"squared_distance\":\"9\\/2\"/\"squared_distance\":\"1" + std::string(60, '0') + "\"/"),
               "dimension 1, birth 1" + std::string(59, '0') + "..., death 5", "dimension 1, birth 9/2, death 5");
  expect_wrong(changed("s/\"death\":{[^}]*\"contact\":\\[0,1,2\\][^}]*}/\"death\":null/"),
               "dimension 1, birth 9/2, death inf", "dimension 1, birth 9/2, death 5");
}

TEST_F(ConformanceCommand, KnowsOutcomesOfThePersistenceCommandApart) {
  CITES("FC-PERS-01", "FC-IN-05");
  const auto expect = [&](const std::string& command, const std::string& outcome, const std::string& message) {
    const json one = only_case_of(
        as_json({"--against", kCompute, "--persistence-against", command + " # {in}", "--case", kTrianglePairs}));
    EXPECT_EQ(one["outcome"], outcome) << one;
    EXPECT_NE(one["message"].get<std::string>().find(message), std::string::npos) << one;
    EXPECT_EQ(one["persistence_findings"], json::array());
  };
  expect("true", "unreadable", "standard output: empty");
  expect("echo nonsense", "unreadable", "standard output:1: not the words dimension, birth, death");
  expect("printf '# x\n3 1 2\n'", "unreadable", "standard output:2: no dimension");
  expect("echo 1 0 0 inf", "unreadable", "standard output:1: no characteristic of a field: '1'");
  expect("echo 2 0 0 inf 5", "unreadable", "standard output:1: not the words dimension, birth, death");
  expect("echo 1 x 2", "unreadable", "not a number: 'x'");
  expect("echo 1 nan inf", "unreadable", "not a finite number: 'nan'");
  expect("echo '{}'", "unreadable", "no key 'pairs'");
  expect("echo '{'", "unreadable", "standard output");
  expect("echo '{\"pairs\":[{\"dimension\":0,\"birth\":{\"squared_distance\":0.5},\"death\":null}]}'", "unreadable",
         "'squared_distance' is no string");
  expect("echo no >&2; exit 3", "refused", "exit status 3: no");
  expect("kill -SEGV $$", "crashed", "SIGSEGV");
  for (const std::string word : {"-1", "1x", "9999999999"}) {
    expect("echo " + word + " 0 1", "unreadable", "standard output:1: no dimension 0, 1 or 2: '" + word + "'");
  }
  expect("echo '{\"pairs\":5}'", "unreadable", "'pairs' is no array");
  expect("echo '{\"pairs\":[5]}'", "unreadable", "no object that could have 'dimension'");
  for (const std::string dimension : {"-1", "3", "\"1\"", "0.5"}) {
    expect("echo '{\"pairs\":[{\"dimension\":" + dimension + "}]}'", "unreadable", "'dimension' is not 0, 1 or 2");
  }
  const json missing = only_case_of(
      as_json({"--against", kCompute, "--persistence-against", "true {in} {out}", "--case", kTrianglePairs}));
  EXPECT_EQ(missing["outcome"], "unreadable") << missing;
  EXPECT_EQ(missing["message"], "persistence: there is no such file");
  // The claim that failed before keeps its message, and the pairs are judged all the same.
  const json both = only_case_of(as_json({"--against", script("echo '# nothing' > \"$2\""), "--persistence-against",
                                          "echo 0 0 inf # {in}", "--case", kTrianglePairs}));
  EXPECT_EQ(both["level"], 3);
  EXPECT_TRUE(both["message"].get<std::string>().starts_with("level 3")) << both;
  EXPECT_EQ(both["persistence_findings"].size(), 3U);
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

}  // namespace
}  // namespace flowcert::conformance::conformance_failures_test
