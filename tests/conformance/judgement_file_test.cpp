// The form of spec/judgements.json (spec/formats/judgements.md).
//
// Guarantees: the schema takes the file, and notices damages. What the judgements say is asked of both judges by
// judgements_test.py.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/conformance/vector_files.h"
#include "tests/json_schema.h"

namespace flowcert::conformance::judgement_file_test {
namespace {

nlohmann::json judgement_file() { return nlohmann::json::parse(text_of_file(spec_folder() / "judgements.json")); }

// What violates the schema, a line each; empty if nothing does.
std::string violations(const nlohmann::json& file) {
  static const flowcert_tests::JsonSchema schema(spec_folder() / "schemas" / "judgements.schema.json");
  return schema.violations(file);
}

// The file with these judgements alone, in this order.
nlohmann::json judgements_of(const std::vector<std::string>& ids) {
  nlohmann::json file = judgement_file();
  nlohmann::json chosen = nlohmann::json::array();
  for (const std::string& id : ids) {
    for (const nlohmann::json& one : file["judgements"]) {
      if (one["id"] == id) chosen.push_back(one);
    }
  }
  EXPECT_EQ(chosen.size(), ids.size());
  file["judgements"] = chosen;
  return file;
}

TEST(JudgementFile, ConformsToTheSchema) {
  CITES("FC-CLAIM-20", "FC-FILE-36", "FC-FILE-37");
  EXPECT_EQ(violations(judgement_file()), "");
}

// The second judgement is a claim that fails, the third one that is perturbed, the fourth one about pairs.
TEST(JudgementFile, TheSchemaNoticesDamages) {
  CITES("FC-CLAIM-19", "FC-CLAIM-20");
  const nlohmann::json small = judgements_of({"claim-01-3", "claim-03-1", "claim-04-1", "claim-11-4"});
  ASSERT_EQ(violations(small), "");
  const std::vector<const char*> damages = {
      R"([{"op":"remove","path":"/format"}])",
      R"([{"op":"add","path":"/more","value":1}])",
      R"([{"op":"replace","path":"/format_version","value":2}])",
      R"([{"op":"replace","path":"/judgements","value":[]}])",
      R"([{"op":"copy","from":"/judgements/1","path":"/judgements/0"}])",
      R"([{"op":"replace","path":"/judgements/1/id","value":"claim-3-1"}])",
      R"([{"op":"replace","path":"/judgements/1/clause","value":"FC-CRIT-03"}])",
      R"([{"op":"remove","path":"/judgements/1/comment"}])",
      R"([{"op":"replace","path":"/judgements/1/case","value":"critical-points-2"}])",
      R"([{"op":"add","path":"/judgements/1/levels","value":6}])",
      R"([{"op":"add","path":"/judgements/1/more","value":1}])",
      R"([{"op":"replace","path":"/judgements/1/claim","value":"0,0,0,0"}])",
      R"([{"op":"replace","path":"/judgements/1/claim/0","value":"two\nlines"}])",
      R"([{"op":"replace","path":"/judgements/1/verdict","value":"wrong"}])",
      R"([{"op":"replace","path":"/judgements/1/verdict","value":"conforms"}])",
      R"([{"op":"replace","path":"/judgements/1/findings","value":[]}])",
      R"([{"op":"replace","path":"/judgements/1/findings/0/level","value":0}])",
      R"([{"op":"replace","path":"/judgements/1/findings/0/reason","value":"tie-break"}])",
      R"([{"op":"replace","path":"/judgements/1/findings/0/clause","value":"FC-CRIT-05 b"}])",
      R"([{"op":"remove","path":"/judgements/1/findings/0/permitted"}])",
      R"([{"op":"add","path":"/judgements/1/findings/0/line","value":1}])",
      R"([{"op":"replace","path":"/judgements/2/verdict","value":"fails"}])",
      R"([{"op":"replace","path":"/judgements/2/findings/0/permitted","value":false}])",
      R"([{"op":"remove","path":"/judgements/3/answers"}])",
      R"([{"op":"replace","path":"/judgements/3/answers","value":"orbit"}])",
      R"([{"op":"add","path":"/judgements/3/levels","value":5}])",
      R"([{"op":"replace","path":"/judgements/3/verdict","value":"perturbed"}])",
      R"([{"op":"replace","path":"/judgements/3/findings/0/reason","value":"missing"}])",
      R"([{"op":"add","path":"/judgements/3/findings/0/level","value":5}])"};
  for (const char* damage : damages) {
    EXPECT_NE(violations(small.patch(nlohmann::json::parse(damage))), "") << damage;
  }
}

TEST(JudgementFile, NamesCasesAndGivesEachIdOnce) {
  CITES("FC-CLAIM-20");
  std::set<std::string> cases, ids;
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) cases.insert(one["id"]);
  }
  const nlohmann::json file = judgement_file();
  for (const nlohmann::json& one : file["judgements"]) {
    const std::string id = one["id"];
    EXPECT_TRUE(ids.insert(id).second) << id;
    EXPECT_TRUE(cases.contains(one["case"].get<std::string>())) << id;
    EXPECT_EQ("FC-CLAIM-" + id.substr(6, 2), one["clause"].get<std::string>()) << id;
  }
  EXPECT_GE(ids.size(), 200U);
}

}  // namespace
}  // namespace flowcert::conformance::judgement_file_test
