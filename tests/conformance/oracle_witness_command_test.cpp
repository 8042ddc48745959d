// `flowcert-oracle witness` as its users see it: verdicts on what `flowcert cycles` prints, and what it cannot use.
//
// Guarantees: the witness of a square was worked out by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::oracle_witness_command_test {
namespace {

using nlohmann::json;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";

json square() {
  const json loop = {{0, 1}, {0, 3}, {1, 2}, {2, 3}}, surface = {{0, 1, 2, 3}}, cocycle = {{2, 3}};
  json witness = {{"loop", loop}, {"surface", surface}, {"cocycle", cocycle}, {"met", json::array()}};
  json cycle = {{"birth", {{"contact", {2, 3}}}}, {"death", {{"contact", {0, 1, 2, 3}}}}, {"witness", witness}};
  return {{"format", "flowcert-cycles"}, {"format_version", 1}, {"cycles", {cycle}}};
}

Finished judged(const std::string& text) {
  const Scratch scratch;
  const std::string points = scratch.file("square.xyz", "0 0 0\n2 0 0\n2 2 0\n0 2 0\n");
  return flowcert_oracle({"witness", points, scratch.file("cycles.json", text)});
}

TEST(OracleWitnessCommand, SaysWhichWitnessesAreRight) {
  CITES("FC-CYC-08", "FC-FILE-52");
  json file = square();
  Finished finished = judged(file.dump());
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.out, "pair 2,3/0,1,2,3: accepted\n");
  json cycle = file["cycles"][0];
  cycle["witness"]["cocycle"].clear();
  file["cycles"].push_back(cycle);
  finished = judged(file.dump());
  EXPECT_EQ(finished.status, 1) << finished.err;
  EXPECT_EQ(finished.out, "pair 2,3/0,1,2,3: accepted\npair 2,3/0,1,2,3: refused: even-on-loop\n");
}

TEST(OracleWitnessCommand, AcceptsThoseOfTheProgram) {
  CITES("FC-CYC-08", "FC-FILE-52");
  const Scratch scratch;
  const std::string points = scratch.file("cube.xyz", kCube);
  const std::string cycles = scratch.file("cube.json", flowcert({"cycles", points, "--witness", "--json"}).out);
  const Finished finished = flowcert_oracle({"witness", points, cycles});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(lines_of(finished.out).size(), 5U) << finished.out;
}

TEST(OracleWitnessCommand, RefusesOtherFiles) {
  json without = square(), empty = square(), later = square(), negative = square();
  without["cycles"][0].erase("witness");
  empty["cycles"].clear();
  later["format_version"] = 2;
  negative["cycles"][0]["witness"]["loop"][0][0] = -1;
  for (const std::string& text : {std::string(), std::string("[]"), without.dump(), empty.dump(), later.dump(),
                                  negative.dump(), flowcert({}).out}) {
    const Finished finished = judged(text);
    EXPECT_EQ(finished.status, 2) << text;
    EXPECT_EQ(finished.out, "") << text;
    EXPECT_TRUE(finished.err.starts_with("flowcert-oracle: ")) << finished.err;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
  }
}

}  // namespace
}  // namespace flowcert::conformance::oracle_witness_command_test
