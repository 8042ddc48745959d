// `flowcert generate --vectors | PROGRAM | flowcert verify`, and persistence pairs through the same pipe
// (src/cli/manual/cases.md).
//
// Guarantees: right answers conform, and each wrong one is found in its case. The verdict on a vector is that of
// `conformance`.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cites.h"
#include "tests/conformance/pipe.h"

namespace flowcert::conformance::verify_vectors_test {
namespace {

// ---- Persistence pairs ----

TEST(Verify, RightPairsOfEveryFamilyConform) {
  CITES("FC-CLAIM-11", "FC-PERS-01");
  const Pipe pipe({"--cases", "160"}, {"pairs"});
  const json report = pipe.as_json({"--persistence"});
  EXPECT_EQ(report["verdict"], "conforms") << report;
  EXPECT_EQ(report["approximate"], 0);
  EXPECT_EQ(pipe.as_json({"--persistence", "--oracle"})["verdict"], "conforms");
  const json diagrams = Pipe({"--cases", "40", "--family", "lattice-3"}, {"diagram"}).as_json({"--persistence"});
  EXPECT_EQ(diagrams["verdict"], "conforms") << diagrams;
  EXPECT_GT(diagrams["approximate"], 30);
}

TEST(Verify, FindsWrongPairs) {
  CITES("FC-CLAIM-11");
  const Pipe pipe({"--cases", "20", "--family", "lattice-3"}, {"pairs", "drop", "3", "drop", "5", "refuse", "7"});
  const json report = pipe.as_json({"--persistence"});
  EXPECT_EQ(report["fails"], 2);
  EXPECT_EQ(report["reasons"][0]["reason"], "wrong-pair");
  EXPECT_EQ(report["reasons"][0]["cases"], 2);
  const json& failure = report["failures"][0];
  EXPECT_EQ(failure["number"], 3);
  EXPECT_EQ(failure["findings"], json::array());
  ASSERT_EQ(failure["persistence_findings"].size(), 1U);
  EXPECT_EQ(failure["persistence_findings"][0]["reason"], "wrong-pair");
  EXPECT_EQ(failure["persistence_findings"][0]["claimed"], "no such pair");
  const Finished text = pipe.verify({"--persistence"});
  EXPECT_TRUE(contains(unbroken(text.out), "  answer: wrong, persistence: claimed no such pair; truth: dimension "))
      << text.out;
  // A claim is no list of pairs.
  EXPECT_EQ(Pipe({"--cases", "3"}, {"csv"}).as_json({"--persistence"})["unreadable"], 3);
}

// A vector that has persistence pairs says what is right.
TEST(Verify, JudgesThePairsOfVectors) {
  CITES("FC-CLAIM-11", "FC-PERS-01");
  const json report = Pipe({"--vectors"}, {"pairs"}).as_json({"--persistence"});
  EXPECT_EQ(report["verdict"], "conforms") << report["reasons"];
}

// ---- Conformance vectors ----

// What `verify` says of the vectors of a folder, by id of vector, where it is not "conforms" or "perturbed".
std::map<std::string, std::string> verdicts_by_vector(const json& report) {
  std::map<std::string, std::string> verdicts;
  for (const json& failure : report["failures"]) {
    const std::string id = failure["id"];
    verdicts[id.substr(7, id.rfind(':') - 7)] = failure["verdict"];
  }
  return verdicts;
}

TEST(VerifyVectors, RightAnswersConform) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--vectors"}, {"exchange"});
  EXPECT_TRUE(contains(pipe.cases(), "# flowcert generate: 1462 conformance vectors.\n"))
      << pipe.cases().substr(0, 200);
  const json report = pipe.as_json();
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["truth"], "conformance vectors");
  EXPECT_EQ(report["run"], "flowcert generate --vectors");
  EXPECT_EQ(report["cases"], 1462);
  std::map<std::string, std::size_t> cases_of_flag;
  for (const json& flag : report["flags"]) cases_of_flag[flag["flag"]] = flag["conforms"];
  EXPECT_EQ(cases_of_flag.size(), 113U) << "all but those of invalid cases";
  EXPECT_FALSE(cases_of_flag.contains("not-finite"));
  EXPECT_EQ(cases_of_flag["void"], 73U);
  EXPECT_FALSE(Pipe({"--cases", "5"}).as_json().contains("flags"));
}

TEST(VerifyVectors, AFaultIsFoundInItsVector) {
  CITES("FC-CLAIM-03");
  const FewVectors few;
  const Pipe pipe({"--vectors", few.folder()}, {"csv", "drop", "3", "refuse", "8", "unreadable", "9", "skip", "20"});
  const Words ids = ids_of(pipe.cases());
  ASSERT_EQ(ids.size(), 30U);
  EXPECT_TRUE(ids.front().starts_with("vector:flat-inputs-0001:")) << ids.front();
  const json report = pipe.as_json();
  EXPECT_EQ(verdicts_by_vector(report),
            (std::map<std::string, std::string>{
                {"flat-inputs-0004", "fails"}, {"orbits-0003", "refused"}, {"orbits-0004", "unreadable"}}));
  EXPECT_EQ(report["unanswered_numbers"], json({{20, 20}}));
  EXPECT_EQ(report["failures"][0]["family"], "flat-inputs");
  const std::string again = report["failures"][0]["points"];
  EXPECT_TRUE(again.starts_with("flowcert generate --vectors ") && again.ends_with(" --case 3 --xyz")) << again;
  EXPECT_EQ(cases_of(generated({"--vectors", few.folder(), "--case", "3"})).front(), cases_of(pipe.cases())[3]);
  const std::string folder = pipe.scratch().path("kept");
  (void)pipe.verify({"--keep", folder});
  EXPECT_EQ(flowcert({"check", folder + "/flat-inputs-0004.xyz", folder + "/flat-inputs-0004.claim"}).status, 1);
}

// A program that takes no account of cospherical points, asked by `conformance` and through the pipe. A file without
// a line would be no claim.
TEST(VerifyVectors, TheVerdictIsThatOfConformance) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04", "FC-CLAIM-05");
  const FewVectors few;
  const Scratch scratch;
  const std::string by_pipe = R"("$0" generate --vectors "$1" | while read -r word id count; do
      [ "$word" = case ] || continue
      for ((k = 0; k < count; ++k)); do read -r row; echo "$row"; done >"$3/points"
      "$2" "$3/points" "$3/claim" </dev/null
      echo "answer $id"; cat "$3/claim"; echo end
    done | "$0" verify --vectors "$1" --json)";
  const Finished piped =
      RunningProgram({"/bin/bash", "-c", by_pipe, FLOWCERT_PROGRAM, few.folder(), FLOWCERT_PEER, scratch.path("")})
          .finish();
  const json verified = json::parse(piped.out);
  const Finished run = flowcert({"conformance", "--vectors", few.folder(), "--json", "--memory-limit", "0", "--against",
                                 std::string(FLOWCERT_PEER) + " {in} {out} && echo '#' >>{out}"});
  const json conformance = json::parse(run.out);
  std::map<std::string, std::string> expected;
  std::map<std::string, std::size_t> counts;
  for (const json& one : conformance["cases"]) {
    if (one["group"] == "invalid-input") continue;
    ++counts[one["outcome"]];
    if (one["negative"]) expected[one["id"]] = one["outcome"];
  }
  EXPECT_GT(counts["fails"], 0U);
  EXPECT_GT(counts["conforms"], 0U);
  EXPECT_EQ(verdicts_by_vector(verified), expected);
  for (const char* outcome : {"conforms", "perturbed", "fails", "unreadable"}) {
    EXPECT_EQ(verified[outcome], counts[outcome]) << outcome;
  }
}

TEST(VerifyVectors, OfMorePointsAreLeftOut) {
  CITES("FC-CLAIM-03");
  const FewVectors few;
  const Words run = {"--vectors", few.folder(), "--most-points", "5"};
  const Pipe pipe(run, {"csv"});
  EXPECT_TRUE(
      contains(pipe.cases(), "# flowcert generate: 30 conformance vectors, without those of more than 5 points.\n"));
  const std::vector<std::string> all = cases_of(generated({"--vectors", few.folder()}));
  const auto asked = static_cast<std::size_t>(
      std::ranges::count_if(all, [](const std::string& one) { return lines_of(one).size() <= 6; }));
  ASSERT_LT(asked, 30U);
  EXPECT_TRUE(id_of(cases_of(pipe.cases()).at(0)).starts_with("vector:flat-inputs-0001/5:")) << pipe.cases();
  const json report = pipe.as_json();
  EXPECT_EQ(report["cases"], asked);
  EXPECT_EQ(report["unanswered"], 0);
  EXPECT_TRUE(report["run"].get<std::string>().ends_with(" --most-points 5")) << report["run"];
  for (const Words& other : {Words{"--vectors", few.folder()}, {"--vectors", few.folder(), "--most-points", "6"}}) {
    const Finished refused = pipe.verify_text(pipe.answers(), other);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(contains(refused.err, "standard input:3: a case of another run: 'vector:")) << refused.err;
  }
}

TEST(VerifyVectors, OtherVectorsThanThoseThatWereAskedAreRefused) {
  CITES("FC-IN-05");
  const FewVectors few;
  const Pipe pipe({"--vectors", few.folder()}, {"csv"});
  const auto refuses = [](const Finished& finished, const std::string& what) {
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(contains(finished.err, what)) << finished.err;
  };
  refuses(pipe.verify_text(pipe.answers()), "standard input:3: no case of the vectors in ");
  // What the vectors say is a part of the id, too.
  std::string flat = content_of(few.folder() + "/flat-inputs.json");
  flat.replace(flat.find("\"merged_duplicates\":0"), 21, "\"merged_duplicates\":1");
  std::ofstream(few.folder() + "/flat-inputs.json") << flat;
  refuses(pipe.verify(), "standard input:3: no case of the vectors in ");
  const Words drawn = {"--cases", "3"};
  refuses(pipe.verify_text(Pipe(drawn).answers(), pipe.run()), "a case of another run: '");
  refuses(pipe.verify_text("refused " + ids_of(generated(drawn))[0] + "\n" + pipe.answers()),
          "a case of another run: 'vector:");
  refuses(flowcert({"generate", "--vectors", "--seed", "2"}), "--seed");
  refuses(flowcert({"generate", "--vectors", few.folder() + "/flags.json"}), "--vectors");
  refuses(flowcert({"generate", "--vectors", few.folder(), "--case", "30"}), "--case: the run has 30 cases, 0 to 29");
}

}  // namespace
}  // namespace flowcert::conformance::verify_vectors_test
