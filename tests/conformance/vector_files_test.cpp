// The files of spec/vectors/: their form, what they leave out, and that nobody edited one by hand.
//
// Guarantees: in a whole run (./dev test --slow) the files are made once more and compared, except for two things that
// take minutes: the search for stationary points of more than 12 points (vectors_oracle_test certifies those listed one
// by one), and the choice of starts for more than 8. Otherwise every eighth case is.
#include "tests/conformance/vector_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <regex>
#include <set>

#include "certify/truth.h"
#include "flowcert/rational.h"
#include "flowcert/read_points.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/run_scale.h"
#include "tests/vectors/flags.h"
#include "tests/vectors/vectors.h"

namespace flowcert::conformance::vector_files_test {
namespace {

namespace vectors = oracle::vectors;

constexpr std::size_t kMadeOnceMore = 8;  // points
constexpr std::size_t kStep = 8;          // of the cases that are made once more where a run is not whole

TEST(VectorFiles, ConformToTheSchema) {
  CITES("FC-NUM-02", "FC-OUT-01", "FC-FLOW-02", "FC-FILE-32", "FC-FILE-33", "FC-FILE-34", "FC-FILE-35");
  for (const std::string& name : names_of_files()) {
    EXPECT_EQ(violations(nlohmann::json::parse(vectors_text(name))), "") << name;
  }
}

TEST(VectorFiles, TheSchemaNoticesDamages) {
  CITES("FC-NUM-02", "FC-OUT-01", "FC-FLOW-02");
  nlohmann::json small = nlohmann::json::parse(vectors_text("orbits"));
  small["cases"].erase(small["cases"].begin() + 4, small["cases"].end());
  ASSERT_EQ(violations(small), "");
  const std::vector<const char*> damages = {
      R"([{"op":"remove","path":"/group"}])",
      R"([{"op":"add","path":"/more","value":1}])",
      R"([{"op":"replace","path":"/format_version","value":2}])",
      R"([{"op":"replace","path":"/cases/1/id","value":"orbits-2"}])",
      R"([{"op":"remove","path":"/cases/1/comment"}])",
      R"([{"op":"add","path":"/cases/1/more","value":1}])",
      R"([{"op":"remove","path":"/cases/1/expected"}])",
      R"([{"op":"replace","path":"/cases/1/result","value":"acceptable"}])",
      R"([{"op":"replace","path":"/cases/1/result","value":"invalid"}])",
      R"([{"op":"replace","path":"/cases/1/clauses","value":["FC-NONE"]}])",
      R"([{"op":"replace","path":"/cases/1/points/0/0","value":"0.5"}])",
      R"([{"op":"replace","path":"/cases/1/points/0","value":["0x0p+0","0x0p+0"]}])",
      R"([{"op":"replace","path":"/cases/1/expected/critical","value":[1,1,0]}])",
      R"([{"op":"replace","path":"/cases/1/expected/stationary/0/index","value":4}])",
      R"([{"op":"replace","path":"/cases/1/expected/stationary/0/index","value":[2,2]}])",
      R"([{"op":"replace","path":"/cases/1/expected/stationary/0/center/0","value":"-0"}])",
      R"([{"op":"replace","path":"/cases/1/expected/orbits/0/segments/0/type","value":"C-F-V"}])",
      R"([{"op":"remove","path":"/cases/1/expected/orbits/0/limit"}])"};
  for (const char* damage : damages) {
    EXPECT_NE(violations(small.patch(nlohmann::json::parse(damage))), "") << damage;
  }
}

// The damages are in the first cases that have such sets and pairs.
TEST(VectorFiles, TheSchemaNoticesDamagesOfStableSetsAndPairs) {
  CITES("FC-NUM-02", "FC-STAB-04", "FC-STAB-05", "FC-PERS-01");
  const auto damaged = [](const std::string& group, const std::string& id, const char* damage) {
    nlohmann::json file = nlohmann::json::parse(vectors_text(group));
    std::erase_if(file["cases"].get_ref<nlohmann::json::array_t&>(),
                  [&](const nlohmann::json& one) { return one["id"] != id; });
    return violations(file.patch(nlohmann::json::parse(damage)));
  };
  for (const char* damage :
       {R"([{"op":"remove","path":"/cases/0/expected/stationary/6/skeleton"}])",
        R"([{"op":"remove","path":"/cases/0/expected/stationary/6/stable"}])",
        R"([{"op":"remove","path":"/cases/0/expected/stationary/6/stable/walk"}])",
        R"([{"op":"replace","path":"/cases/0/expected/stationary/6/stable/walk","value":[0,1]}])",
        R"([{"op":"replace","path":"/cases/0/expected/stationary/6/stable/boundary/0","value":[0,1,2]}])",
        R"([{"op":"add","path":"/cases/0/expected/stationary/6/skeleton/more","value":1}])",
        R"([{"op":"remove","path":"/cases/0/expected/stationary/6/skeleton/sectors"}])",
        R"([{"op":"replace","path":"/cases/0/expected/stationary/6/skeleton/segments/0/back/1","value":"-0"}])",
        R"([{"op":"replace","path":"/cases/0/expected/stationary/6/skeleton/segments/0/back_kind","value":"x"}])"}) {
    EXPECT_EQ(damaged("stable-manifolds", "stable-manifolds-0005", "[]"), "");
    EXPECT_NE(damaged("stable-manifolds", "stable-manifolds-0005", damage), "") << damage;
  }
  for (const char* damage : {R"([{"op":"remove","path":"/cases/0/expected/persistence/0/death"}])",
                             R"([{"op":"replace","path":"/cases/0/expected/persistence/0/dimension","value":3}])",
                             R"([{"op":"replace","path":"/cases/0/expected/persistence/0/birth","value":0}])",
                             R"([{"op":"replace","path":"/cases/0/expected/persistence","value":null}])"}) {
    EXPECT_EQ(damaged("persistence", "persistence-0005", "[]"), "");
    EXPECT_NE(damaged("persistence", "persistence-0005", damage), "") << damage;
  }
}

// The damages are in the right triangle: three samples, two points of index 1, and one of kind 1-2.
TEST(VectorFiles, TheSchemaNoticesDamagesOfTheWholeComplex) {
  CITES("FC-UNST-02", "FC-CONN-01", "FC-CONN-03", "FC-VOL-01");
  const auto damaged = [](const std::string& group, const std::string& id, const std::string& damage) {
    nlohmann::json file = nlohmann::json::parse(vectors_text(group));
    std::erase_if(file["cases"].get_ref<nlohmann::json::array_t&>(),
                  [&](const nlohmann::json& one) { return one["id"] != id; });
    EXPECT_EQ(violations(file), "");
    return violations(file.patch(nlohmann::json::parse(damage)));
  };
  const std::string last = "/cases/0/expected/stationary/5/";
  for (const auto& [path, change] :
       std::map<std::string, std::string>{{"lambda/directions", R"("op":"remove")"},
                                          {"lambda/arcs", R"("op":"remove")"},
                                          {"lambda/arcs/0", R"("op":"replace","value":[])"},
                                          {"lambda/more", R"("op":"add","value":1)"},
                                          {"lambda/directions/0/limit", R"("op":"remove")"},
                                          {"lambda/directions/0/vector", R"("op":"remove")"},
                                          {"lambda/directions/0/vector/1", R"("op":"replace","value":"-0")"},
                                          {"lambda/directions/0/exit", R"("op":"add","value":["0","0","0"])"}}) {
    EXPECT_NE(damaged("lambda-lists", "lambda-lists-0007", R"([{"path":")" + last + path + "\"," + change + "}]"), "")
        << path;
  }
  for (const auto& [path, change] :
       std::map<std::string, std::string>{{last + "connections/0/to", R"("op":"remove")"},
                                          {last + "connections/0/orbits", R"("op":"replace","value":-1)"},
                                          {last + "connections/0/families", R"("op":"remove")"},
                                          {last + "connections", R"("op":"replace","value":[])"},
                                          {"/cases/0/expected/morse_smale", R"("op":"replace","value":"no")"}}) {
    EXPECT_NE(damaged("connections", "connections-0007", R"([{"path":")" + path + "\"," + change + "}]"), "") << path;
  }
  for (const auto& [path, change] :
       std::map<std::string, std::string>{{"volume", R"("op":"replace","value":"-1")"},
                                          {"volume", R"("op":"remove")"},
                                          {"shares", R"("op":"replace","value":[])"},
                                          {"shares/0", R"("op":"replace","value":[0])"},
                                          {"shares/0/1", R"("op":"replace","value":"0")"}}) {
    const std::string octahedron = "/cases/0/expected/stationary/26/";
    EXPECT_NE(damaged("volumes", "volumes-0013", R"([{"path":")" + octahedron + path + "\"," + change + "}]"), "")
        << path;
  }
}

// The damages are in an edge of the cube.
TEST(VectorFiles, TheSchemaNoticesDamagesOfUnstableSets) {
  CITES("FC-UNST-04");
  nlohmann::json file = nlohmann::json::parse(vectors_text("unstable-surfaces"));
  std::erase_if(file["cases"].get_ref<nlohmann::json::array_t&>(),
                [](const nlohmann::json& one) { return one["id"] != "unstable-surfaces-0012"; });
  ASSERT_EQ(violations(file), "");
  const std::string edge = "/cases/0/expected/stationary/8/u1/";
  for (const auto& [path, change] : std::vector<std::pair<std::string, std::string>>{
           {"vertices", R"("op":"remove")"},
           {"runs", R"("op":"remove")"},
           {"sheets", R"("op":"replace","value":[])"},
           {"sheets/0/corners/0", R"("op":"remove")"},
           {"sheets/0/corners/1/vector/0", R"("op":"replace","value":"-0")"},
           {"sheets/0/samples/0", R"("op":"remove")"},
           {"traces/0/polygon", R"("op":"replace","value":[0,1])"},
           {"traces/0/to", R"("op":"replace","value":null)"},
           {"traces/0/to/vector", R"("op":"remove")"},
           {"segments/0", R"("op":"add","value":{"samples":[0,1],"start":["0","0","0"]})"},
           {"more", R"("op":"add","value":1)"}}) {
    EXPECT_NE(violations(file.patch(nlohmann::json::parse(R"([{"path":")" + edge + path + "\"," + change + "}]"))), "")
        << path;
  }
}

std::set<std::string> clauses_of_the_spec() {
  static const std::regex heading(R"(\*\*(FC-[A-Z]+-[0-9]{2})\*\* \()");
  const std::string spec = text_of_file(spec_folder() / "flow_complex.md") + text_of_file(spec_folder() / "claims.md");
  std::set<std::string> clauses;
  for (auto match = std::sregex_iterator(spec.begin(), spec.end(), heading); match != std::sregex_iterator(); ++match) {
    clauses.insert((*match)[1]);
  }
  return clauses;
}

TEST(VectorFiles, NameWhatThereIs) {
  CITES("FC-IN-04", "FC-CRIT-03", "FC-FLOW-02");
  const std::set<std::string> clauses = clauses_of_the_spec();
  std::map<std::string, std::size_t> flags;
  for (const Json& flag : group_named("flags")["flags"]) {
    EXPECT_TRUE(flags.emplace(flag["flag"], 0).second) << flag["flag"] << " is defined twice";
    for (const Json& clause : flag["clauses"]) EXPECT_TRUE(clauses.contains(clause)) << flag["flag"];
  }
  std::set<std::string> ids, inputs;
  for (const std::string& name : names_of_files()) {
    if (name == "flags") continue;
    EXPECT_EQ(group_named(name)["group"], name);
    std::string previous;
    for (const Json& one : group_named(name)["cases"]) {
      const std::string id = one["id"];
      EXPECT_TRUE(ids.insert(id).second && previous < id && id.starts_with(name + "-")) << id;
      previous = id;
      for (const Json& clause : one["clauses"]) EXPECT_TRUE(clauses.contains(clause)) << id << clause;
      for (const Json& flag : one["flags"]) EXPECT_GT(++flags[flag], 0U) << id;
      const Json start = one.value("start", Json());
      EXPECT_TRUE(inputs.insert(name + xyz_text(one) + start.dump()).second) << id << " is there twice";
    }
  }
  EXPECT_GE(ids.size(), 300U);
  EXPECT_GE(group_named("stable-manifolds")["cases"].size(), 60U);
  EXPECT_GE(group_named("persistence")["cases"].size(), 60U);
  for (const char* group : {"lambda-lists", "connections", "volumes", "unstable-surfaces", "locations", "merge-trees",
                            "pockets", "medial-axes", "infinity", "statistics", "cycles"}) {
    EXPECT_GE(group_named(group)["cases"].size(), 40U) << group;
  }
  EXPECT_EQ(flags.size(), group_named("flags")["flags"].size()) << "a case has a flag that is not defined";
  for (const auto& [flag, cases] : flags) EXPECT_GE(cases, 3U) << flag << " is the flag of too few cases";
}

// All results, kinds of stationary points and types of flow segments occur, from no point to 60 points.
TEST(VectorFiles, LeaveNothingOut) {
  CITES("FC-IN-04", "FC-CRIT-02", "FC-CRIT-03", "FC-FLOW-02", "FC-FLOW-07");
  std::set<std::string> results, kinds, types, limits;
  std::set<std::size_t> sizes;
  for (const Json& one : all_cases()) {
    results.insert(one["result"]);
    if (is_invalid(one)) continue;
    sizes.insert(one["points"].size());
    for (const Json& x : one["expected"]["stationary"]) {
      kinds.insert(x["index"].dump());
      for (const Json& limit : x.value("limits", Json::array())) limits.insert(limit.type_name());
    }
    if (!has(one, "orbits")) continue;
    for (const Json& path : one["expected"]["orbits"]) {
      limits.insert(path["limit"]["index"].dump());
      for (const Json& segment : path["segments"]) types.insert(segment["type"]);
    }
  }
  using Texts = std::set<std::string>;
  EXPECT_EQ(results, (Texts{"acceptable", "determined", "invalid"}));
  EXPECT_EQ(kinds, (Texts{"0", "1", "2", "3", "[1,2]", "[1,3]", "[2,3]"}));
  EXPECT_EQ(limits, (Texts{"0", "1", "2", "3", "[1,2]", "[1,3]", "[2,3]", "array", "null"}));
  EXPECT_EQ(types.size(), 17U) << "of Table 1";
  EXPECT_EQ(*sizes.begin(), 0U);
  EXPECT_EQ(*sizes.rbegin(), 60U);
}

// Which claims of indices at a tetrahedron of kind 1-3 check() takes for what a perturbation makes (FC-CLAIM-04).
Json claims_of_tetrahedron(const Json& one, const Json& x) {
  const PointSet points(read_points_from(xyz_text(one), "case.xyz").rows);
  const std::unique_ptr<Truth> truth = fast_truth(points);
  ClaimedPosition center;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    center[axis] = {oracle::parse_rational(x["center"][axis])->value, true};
  }
  Json claims = Json::array({Json::array()});
  for (const std::vector<int>& indices : {std::vector{1, 2}, {2, 3}, {1, 2, 2, 3}}) {
    Claim claim;
    const auto add = [&claim](int index) -> ClaimedPoint& {
      ClaimedPoint& point = claim.points.emplace_back();
      point.index = index;
      return point;
    };
    for (std::size_t i = 0; i < truth->size(); ++i) {
      if (!truth->index(i).is_critical()) continue;
      add(truth->index(i).face_dimension).contact.assign(truth->contact(i).begin(), truth->contact(i).end());
    }
    for (const int index : indices) add(index).center = center;
    if (check(points, claim, *truth).verdict == Verdict::kPerturbed) claims.push_back(indices);
  }
  return claims;
}

// The alternatives of a case are those of its regular stationary points; the counts are those of its list.
TEST(VectorFiles, AreConsistent) {
  CITES("FC-INV-01", "FC-INV-02", "FC-CRIT-06", "FC-NUM-02");
  const std::map<std::string, Json> claims = {
      {"[1,2]", Json::parse("[[],[1,2]]")},
      {"[2,3]", Json::parse("[[],[2,3]]")},
      {"[1,3]", Json::parse("[[],[1,2],[2,3],[1,2,2,3]]")},
  };
  for (const Json& one : all_cases()) {
    if (is_invalid(one)) continue;
    const Json& expected = one["expected"];
    std::map<std::string, int> counts;
    Json alternatives = Json::array();
    for (const Json& x : expected["stationary"]) {
      const std::string index = x["index"].dump();
      ++counts[index];
      if (claims.contains(index)) {
        alternatives.push_back({{"contact", x["contact"]}, {"claims", claims.at(index)}});
        const bool is_tetrahedron = index == "[1,3]" && x["contact"].size() == 4;
        if (is_tetrahedron) alternatives.back()["claims"] = claims_of_tetrahedron(one, x);
      }
      for (const Json& number : x["center"]) {
        const auto rational = oracle::parse_rational(number);
        EXPECT_TRUE(rational && rational->canonical) << one["id"] << number;
      }
    }
    const Json critical = {counts["0"], counts["1"], counts["2"], counts["3"]};
    expect_same(one, "critical", critical, expected["critical"]);
    EXPECT_EQ(counts["0"] - counts["1"] + counts["2"] - counts["3"], one["points"].empty() ? 0 : 1);
    const Json regular = {{"1-2", counts["[1,2]"]}, {"1-3", counts["[1,3]"]}, {"2-3", counts["[2,3]"]}};
    expect_same(one, "regular_stationary", regular, expected["regular_stationary"]);
    expect_same(one, "alternatives", alternatives, one.value("alternatives", Json::array()));
    EXPECT_EQ(one["result"] == "acceptable", !alternatives.empty()) << one["id"];
    for (const Json& pair : expected.value("persistence", Json::array())) {
      const auto is_sayable = [](const Json& text) {
        const auto number = oracle::parse_rational(text);
        return number && number->canonical && nearest_double(number->value);
      };
      EXPECT_TRUE(is_sayable(pair["birth"])) << one["id"];
      EXPECT_TRUE(pair["death"].is_null() || is_sayable(pair["death"])) << one["id"];
    }
  }
}

// Volumes that are known without a computation.
TEST(VectorFiles, SharesAddUpToVolumesAndSomeAreKnown) {
  CITES("FC-VOL-01", "FC-VOL-02");
  const std::map<std::string, std::vector<std::string>> known = {
      {"volumes-0012", {"1"}},   {"volumes-0013", {"4/3"}},        {"volumes-0014", {"4"}},
      {"volumes-0015", {"2/3"}}, {"volumes-0016", {"1/6", "1/6"}}, {"volumes-0017", {"50", "45", "45"}}};
  std::size_t found = 0;
  for (const Json& one : group_named("volumes")["cases"]) {
    std::vector<std::string> positive;
    for (const Json& x : one["expected"]["stationary"]) {
      const oracle::Rational volume = oracle::parse_rational(x["volume"])->value;
      oracle::Rational sum = 0;
      for (const Json& share : x.value("shares", Json::array())) sum += oracle::parse_rational(share[1])->value;
      EXPECT_EQ(sum, volume) << one["id"];
      if (volume != 0) positive.push_back(x["volume"]);
    }
    const auto expected = known.find(one["id"]);
    if (expected == known.end()) continue;
    EXPECT_EQ(positive, expected->second) << one["id"];
    ++found;
  }
  EXPECT_EQ(found, known.size());
}

// Both groups have these inputs under the same numbers. A connection is one iff its end is a limit of the list.
TEST(VectorFiles, ConnectionsLeadToTheLimitsOfLists) {
  CITES("FC-CONN-01", "FC-UNST-02");
  const Json& lists = group_named("lambda-lists")["cases"];
  std::size_t compared = 0;
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const Json& other = group_named("connections")["cases"][k];
    if (lists[k]["points"] != other["points"]) continue;
    for (std::size_t i = 0; i < other["expected"]["stationary"].size(); ++i) {
      const Json& record = lists[k]["expected"]["stationary"][i];
      if (!record.contains("lambda")) continue;
      std::set<std::string> limits, ends;
      for (const Json& direction : record["lambda"]["directions"]) limits.insert(direction["limit"].dump());
      for (const Json& limit : record["lambda"]["arcs"]) limits.insert(limit.dump());
      for (const Json& one : other["expected"]["stationary"][i]["connections"]) ends.insert(one["to"].dump());
      EXPECT_EQ(ends, limits) << other["id"] << record;
      ++compared;
    }
  }
  EXPECT_GT(compared, 200U);
}

// The tool makes the files from its own table. (TheOraclePasses has what is expected of larger inputs.)
TEST(VectorFiles, AreAsTheToolMakesThem) {
  CITES("FC-CRIT-05", "FC-FLOW-05", "FC-FILE-31");
  EXPECT_EQ(vectors_text("flags"), vectors::text_of(vectors::flag_file()));
  std::vector<std::string> names = {"flags"};
  for (const vectors::Group& group : vectors::groups()) {
    names.push_back(group.name);
    const Json& file = group_named(group.name);
    const std::vector<Json> cases = file["cases"];
    EXPECT_TRUE(vectors::text_of(vectors::group_file(group, cases)) == vectors_text(group.name)) << group.name;
    ASSERT_EQ(cases.size(), group.recipes.size() + group.invalid_recipes.size()) << group.name;
    for (std::size_t k = 0; k < group.recipes.size(); k += flowcert_tests::is_whole_run() ? 1 : kStep) {
      if (group.recipes[k].points.size() > kMadeOnceMore) continue;
      expect_same(cases[k], "all", vectors::case_of(group, group.recipes[k]), cases[k]);
    }
    for (std::size_t k = 0; k < group.invalid_recipes.size(); ++k) {
      const Json& one = cases[group.recipes.size() + k];
      expect_same(one, "all", vectors::case_of(group, group.invalid_recipes[k]), one);
    }
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, names_of_files());
}

}  // namespace
}  // namespace flowcert::conformance::vector_files_test
