// `flowcert generate | PROGRAM | flowcert verify` where the program is slow, or ends before it is through
// (src/cli/manual/cases.md): cases of many points can be left out, and what came is judged.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/cites.h"
#include "tests/conformance/pipe.h"

namespace flowcert::conformance::slow_programs_test {
namespace {

TEST(Verify, CasesOfMorePointsAreNotAsked) {
  CITES("FC-CLAIM-03", "FC-CLAIM-22");
  const Words run = {"--seed", "7", "--cases", "60"};
  const Pipe pipe(joined(run, {"--most-points", "5"}));
  const std::size_t asked = ids_of(pipe.cases()).size();
  const json report = pipe.as_json();
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["cases"], asked);
  EXPECT_EQ(report["run"], "flowcert generate --level 1 --seed 7 --cases 60 --most-points 5");
  EXPECT_EQ(report["profile"]["statement"],
            "conforms to 1.2, points, exact (" + std::to_string(asked) + " drawn inputs of at most 5 points)");
  // The answers say so as well, and the file of generate.
  EXPECT_TRUE(contains(pipe.verify_text(pipe.answers()).out,
                       "\nright in what came: " + std::to_string(asked) + " cases; truth by"));
  const Finished by_file =
      pipe.verify_text(pipe.answers(), {"--json", "--asked", pipe.scratch().file("asked", pipe.cases())});
  EXPECT_EQ(json::parse(by_file.out)["cases"], asked) << by_file.err;
  // Another number of points is another run.
  for (const Words& other : {run, joined(run, {"--most-points", "6"})}) {
    const Finished refused = pipe.verify_text(pipe.answers(), other);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(contains(refused.err, "standard input:3: a case of another run: '1:7:")) << refused.err;
  }
  std::size_t large = 0;
  while (lines_of(cases_of(generated(run)).at(large)).size() <= 6) ++large;
  const Finished only = pipe.verify({"--case", std::to_string(large)});
  EXPECT_EQ(only.status, 2);
  EXPECT_TRUE(contains(only.err, "has more points than --most-points says")) << only.err;
}

// A program that ends early, or is killed, is judged by what came, wherever it was broken off.
TEST(Verify, WhatIsBrokenOffIsMissing) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--cases", "20"}, {"csv", "drop", "3"});
  const std::string& answers = pipe.answers();
  const Words ids = ids_of(pipe.cases());
  const std::size_t sixth = answers.find("answer " + ids[6]);
  const std::size_t end = answers.find("end\n", sixth);
  const std::pair<std::size_t, std::string> cuts[] = {
      {sixth, ""},
      {sixth + 3, "it ends within a line: 'ans'"},
      {sixth + 7 + ids[6].size() - 2, "it ends within a line: 'answer " + ids[6].substr(0, ids[6].size() - 2) + "'"},
      {end, "it ends within the answer to '" + ids[6] + "'"},
      {end + 2, "it ends within the answer to '" + ids[6] + "'"}};
  for (const auto& [size, where] : cuts) {
    for (const Words& told : {Words{}, pipe.run()}) {
      const Finished finished = pipe.verify_text(answers.substr(0, size), joined(told, {"--json"}));
      EXPECT_EQ(finished.status, 1) << where << finished.err;
      const json report = json::parse(finished.out);
      EXPECT_EQ(report["conforms"], 5) << where;
      EXPECT_EQ(report["fails"], 1) << where;
      EXPECT_EQ(report["unanswered_numbers"], json({{6, 19}})) << where;
      EXPECT_EQ(report["cut"].is_null(), where.empty());
      const std::string cut = report["cut"].is_null() ? "" : report["cut"].get<std::string>();
      EXPECT_TRUE(cut.ends_with(where)) << cut;
    }
  }
  // With the last `end` all is there, even without the end of its line.
  const json whole = json::parse(pipe.verify_text(answers.substr(0, answers.size() - 1), {"--json"}).out);
  EXPECT_EQ(whole["conforms"], 19);
  EXPECT_TRUE(whole["cut"].is_null());
  const Finished text = pipe.verify_text(answers.substr(0, end), pipe.run());
  EXPECT_TRUE(contains(unbroken(text.out), ": it ends within the answer to '" + ids[6] + "'\n")) << text.out;
  EXPECT_TRUE(contains(text.out, "\n14 of 20 cases have no answer: 6-19\n")) << text.out;
  // Anything else at the end is no answer that was broken off.
  EXPECT_EQ(pipe.verify_text(answers.substr(0, sixth) + "bye", pipe.run()).status, 2);
}

}  // namespace
}  // namespace flowcert::conformance::slow_programs_test
