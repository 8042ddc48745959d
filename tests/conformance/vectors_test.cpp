// The conformance vectors of spec/vectors/, against the fast implementation and the oracle.
//
// Guarantees: every case of every file is run; whatever is expected there is compared as JSON, exactly. The
// fast implementation runs all cases under both kernels. That nobody edited a file by hand is made sure by
// making all of it once more, but for two things that take minutes: for more than 12 points, the search for
// stationary points (those listed are certified one by one), for more than 8, the choice of starts.
#include "oracle/vectors/vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "flowcert/orbit.h"
#include "flowcert/persistence.h"
#include "flowcert/read_points.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"
#include "io/orbit_fields.h"
#include "io/rational_text.h"
#include "io/skeleton_fields.h"
#include "oracle/orbit.h"
#include "oracle/read_points.h"
#include "oracle/read_records.h"
#include "oracle/vectors/flags.h"
#include "tests/cites.h"

namespace flowcert::conformance {
namespace {

namespace vectors = oracle::vectors;

constexpr std::size_t kMadeOnceMore = 8;  // points
constexpr std::size_t kSearched = 12;

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return text.str();
}

std::string vectors_text(const std::string& name) {
  return text_of_file(std::filesystem::path(FLOWCERT_SPEC_FOLDER) / "vectors" / (name + ".json"));
}

std::vector<std::string> names_of_files() {
  std::vector<std::string> names;
  const auto folder = std::filesystem::path(FLOWCERT_SPEC_FOLDER) / "vectors";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_EQ(entry.path().extension(), ".json") << entry.path();
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

const Json& group_named(const std::string& name) {
  static std::map<std::string, Json> read;
  const auto [place, is_new] = read.try_emplace(name);
  if (is_new) place->second = Json::parse(vectors_text(name));
  return place->second;
}

std::vector<Json> all_cases() {
  std::vector<Json> cases;
  for (const std::string& name : names_of_files()) {
    if (name == "flags") continue;
    for (const Json& one : group_named(name)["cases"]) cases.push_back(one);
  }
  return cases;
}

bool is_invalid(const Json& one) { return one["result"] == "invalid"; }

bool has(const Json& one, const char* key) { return one["expected"].contains(key); }

// All of a point file.
std::string xyz_text(const Json& one) {
  if (one.contains("text")) return one["text"];
  std::string text = one["points"].empty() ? "# no point\n" : "";
  for (const Json& row : one["points"]) {
    const char* separator = "";
    for (const Json& word : row) {
      text += separator;
      text += word.get<std::string>();
      separator = " ";
    }
    text += '\n';
  }
  return text;
}

std::string words_in_a_row(const Json& words) {
  std::string text;
  for (const Json& word : words) {
    if (!text.empty()) text += ',';
    text += word.get<std::string>();
  }
  return text;
}

std::vector<std::array<double, 3>> oracle_rows(const Json& one) {
  std::istringstream in(xyz_text(one));
  return oracle::read_points(in, "case", oracle::PointFormat::kXyz);
}

void expect_same(const Json& one, const std::string& what, const Json& actual, const Json& expected) {
  EXPECT_TRUE(actual.dump() == expected.dump())
      << one["id"] << ": " << what << "\nis       " << actual.dump() << "\nand not  " << expected.dump();
}

// ---- The files

using Adapter = valijson::adapters::NlohmannJsonAdapter;

const valijson::Schema& schema() {
  static const auto made = [] {
    const auto path = std::filesystem::path(FLOWCERT_SPEC_FOLDER) / "schemas" / "vectors.schema.json";
    auto parsed = std::make_unique<valijson::Schema>();
    const auto text = nlohmann::json::parse(text_of_file(path));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(text), *parsed);
    return parsed;
  }();
  return *made;
}

// What violates the schema, a line each; empty if nothing does.
std::string violations(const nlohmann::json& file) {
  valijson::ValidationResults results;
  if (valijson::Validator().validate(schema(), Adapter(file), &results)) return "";
  std::string text = "does not conform\n";
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& step : error.context) text += step;
    text += ": ";
    text += error.description;
    text += '\n';
  }
  return text.substr(0, 2000);
}

TEST(VectorFiles, ConformToTheSchema) {
  CITES("FC-NUM-02", "FC-OUT-01", "FC-FLOW-02");
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

// The first cases that have them.
TEST(VectorFiles, TheSchemaNoticesDamagesOfStableSetsAndPairs) {
  CITES("FC-NUM-02", "FC-STAB-04", "FC-STAB-05", "FC-PERS-01");
  const auto damaged = [](const std::string& group, const std::string& id, const char* damage) {
    nlohmann::json file = nlohmann::json::parse(vectors_text(group));
    std::erase_if(file["cases"].get_ref<nlohmann::json::array_t&>(),
                  [&](const nlohmann::json& one) { return one["id"] != id; });
    return violations(file.patch(nlohmann::json::parse(damage)));
  };
  for (
      const char* damage :
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
  for (const char* damage :
       {R"([{"op":"remove","path":"/cases/0/expected/persistence/0/death"}])",
        R"([{"op":"replace","path":"/cases/0/expected/persistence/0/dimension","value":3}])",
        R"([{"op":"replace","path":"/cases/0/expected/persistence/0/birth","value":0}])",
        R"([{"op":"replace","path":"/cases/0/expected/persistence","value":null}])"}) {
    EXPECT_EQ(damaged("persistence", "persistence-0005", "[]"), "");
    EXPECT_NE(damaged("persistence", "persistence-0005", damage), "") << damage;
  }
}

std::set<std::string> clauses_of_the_spec() {
  static const std::regex heading(R"(\*\*(FC-[A-Z]+-[0-9]{2})\*\* \()");
  const std::string spec = text_of_file(std::filesystem::path(FLOWCERT_SPEC_FOLDER) / "flow_complex.md");
  std::set<std::string> clauses;
  for (auto match = std::sregex_iterator(spec.begin(), spec.end(), heading); match != std::sregex_iterator();
       ++match) {
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
  EXPECT_EQ(flags.size(), group_named("flags")["flags"].size()) << "a case has a flag that is not defined";
  for (const auto& [flag, cases] : flags) EXPECT_GT(cases, 0U) << flag << " is no case's flag";
}

// Numbers of points, kinds of stationary points, results, types of flow segments: all there.
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
      }
      for (const Json& number : x["center"]) {
        const auto rational = oracle::parse_rational(number);
        EXPECT_TRUE(rational && rational->canonical) << one["id"] << number;
      }
    }
    const Json critical = {counts["0"], counts["1"], counts["2"], counts["3"]};
    expect_same(one, "critical", critical, expected["critical"]);
    EXPECT_EQ(counts["0"] - counts["1"] + counts["2"] - counts["3"], one["points"].empty() ? 0 : 1);
    const Json regular = {{"1-2", counts["[1,2]"]}, {"2-3", counts["[2,3]"]}, {"1-3", counts["[1,3]"]}};
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

// Printed by the tool, from what the tool's table says. (What is expected of larger inputs: TheOraclePasses.)
TEST(VectorFiles, AreAsTheToolMakesThem) {
  CITES("FC-CRIT-05", "FC-FLOW-05");
  EXPECT_EQ(vectors_text("flags"), vectors::text_of(vectors::flag_file()));
  std::vector<std::string> names = {"flags"};
  for (const vectors::Group& group : vectors::groups()) {
    names.push_back(group.name);
    const Json& file = group_named(group.name);
    const std::vector<Json> cases = file["cases"];
    EXPECT_TRUE(vectors::text_of(vectors::group_file(group, cases)) == vectors_text(group.name))
        << group.name;
    ASSERT_EQ(cases.size(), group.recipes.size() + group.invalid_recipes.size()) << group.name;
    for (std::size_t k = 0; k < group.recipes.size(); ++k) {
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

// ---- The fast implementation

PointSet fast_points(const Json& one) { return PointSet(read_points_from(xyz_text(one), "case.xyz").rows); }

Json fast_records(const PointSet& points, const StationaryPoints& stationary) {
  Json records = Json::array();
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    const StationaryIndex index = stationary.index(i);
    const ExactSphere sphere = exact_sphere(points, stationary.contact(i));
    records.push_back({{"index", index_field(index)},
                       {"kind", index.is_critical() ? "critical" : "regular"},
                       {"contact", stationary.contact(i)},
                       {"center", center_field(sphere.center)},
                       {"squared_distance", to_text(sphere.squared_radius)}});
  }
  return records;
}

void add_fast_limits(const Delaunay& delaunay, const StationaryPoints& stationary, ConstructionKernel kernel,
                     Json& records) {
  UnstableOptions options;
  options.flow.kernel = kernel;
  const UnstableManifolds manifolds(delaunay, stationary, options);
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    Json limits = Json::array();
    for (const std::size_t side : {0U, 1U}) {
      const auto limit = manifolds.limit(i, side);
      limits.push_back(limit ? Json(stationary.contact(*limit)) : Json());
    }
    records[manifolds.saddle(i)]["limits"] = limits;
  }
}

Json fast_orbit(const PointSet& points, Flow& flow, const Json& start) {
  const Orbit path = flow.orbit(parse_rational_point(words_in_a_row(start)));
  Json segments = Json::array();
  for (const FlowSegment& segment : path.segments) segments.push_back(segment_with_contacts_field(segment));
  return {{"start", center_field(path.start)},
          {"segments", segments},
          {"limit", limit_field(points, path.limit)}};
}

bool any_has(const Json& stationary, const char* key) {
  return std::any_of(stationary.begin(), stationary.end(), [&](const Json& x) { return x.contains(key); });
}

// The sides that a boundary walk goes along, as far as the skeleton knows: those whose segment ends at their
// midpoint, and the side of which a regular stationary point is the midpoint itself.
std::multiset<Json> sides_by_skeleton(const Json& record) {
  std::multiset<Json> sides;
  std::map<Json, std::size_t> of_polygon;
  for (const Json& segment : record["skeleton"]["segments"]) {
    if (segment["back_kind"] == "critical" || segment["back_kind"] == "regular")
      sides.insert(segment["samples"]);
    if (segment["front"] == record["center"]) {
      for (const Json& sample : segment["samples"]) ++of_polygon[sample];
    }
  }
  Json open = Json::array();
  for (const auto& [sample, count] : of_polygon) {
    if (count == 1) open.push_back(sample);
  }
  if (!open.empty()) sides.insert(open);
  return sides;
}

std::multiset<Json> sides_of_walk(const Json& walk) {
  std::multiset<Json> sides;
  for (std::size_t k = 0; k < walk.size(); ++k) {
    const Json &a = walk[k], &b = walk[(k + 1) % walk.size()];
    sides.insert(a < b ? Json{a, b} : Json{b, a});
  }
  return sides;
}

bool any_has_regular_back(const Json& skeleton) {
  return std::any_of(skeleton["segments"].begin(), skeleton["segments"].end(),
                     [](const Json& segment) { return segment["back_kind"] == "regular"; });
}

// The fast implementation has no walk of its own, and a boundary even where there is a tie.
void add_fast_stable_sets(const Delaunay& delaunay, const StationaryPoints& stationary,
                          ConstructionKernel kernel, const Json& expected, Json& records) {
  StableManifolds manifolds(delaunay, stationary, {.flow = {kernel, FacetSearch::kBinary}, .seed = 0});
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    Json& record = records[manifolds.record(i)];
    const Json& wanted = expected[manifolds.record(i)]["stable"];
    Json stable = stable_field(stationary, manifolds, i);
    const Json skeleton = skeleton_field(manifolds.set(i));
    const bool has_tie = manifolds.has_vertex(i) || any_has_regular_back(skeleton);
    if (stable.contains("boundary") && has_tie) stable["boundary"] = Json();
    stable["walk"] = Json();
    record["stable"] = stable;
    record["skeleton"] = skeleton;
    if (manifolds.has_vertex(i)) continue;
    const bool is_right = sides_of_walk(wanted["walk"]) == sides_by_skeleton(record);
    record["stable"]["walk"] = is_right ? wanted["walk"] : Json("not along the sides of the skeleton");
  }
}

Json fast_persistence(const PointSet& points, const Delaunay& delaunay, const StationaryPoints& stationary,
                      ConstructionKernel kernel) {
  UnstableOptions options;
  options.flow.kernel = kernel;
  UnstableManifolds unstable(delaunay, stationary, options);
  const StableManifolds stable(delaunay, stationary, {.flow = {kernel, FacetSearch::kBinary}, .seed = 0});
  const ChainComplex complex(points, stationary, unstable, stable, 0);
  const Persistence persistence(points, stationary, complex);
  Json pairs = Json::array();
  for (const PersistencePair& pair : persistence.pairs()) {
    pairs.push_back({{"dimension", pair.dimension},
                     {"birth", to_text(persistence.squared_value(pair.birth))},
                     {"death", pair.death ? Json(to_text(persistence.squared_value(*pair.death))) : Json()}});
  }
  return pairs;
}

// Its pairs come by dimension and birth; among equal births any order will do.
Json in_order(const Json& pairs) {
  std::vector<Json> sorted = pairs;
  const auto number = [](const Json& text) { return oracle::parse_rational(text)->value; };
  std::sort(sorted.begin(), sorted.end(), [&](const Json& a, const Json& b) {
    if (a["dimension"] != b["dimension"]) return a["dimension"] < b["dimension"];
    if (a["birth"] != b["birth"]) return number(a["birth"]) < number(b["birth"]);
    return !a["death"].is_null() && (b["death"].is_null() || number(a["death"]) < number(b["death"]));
  });
  return sorted;
}

Json fast_answer(const Json& one, ConstructionKernel kernel) {
  const PointSet points = fast_points(one);
  const Delaunay delaunay(points);
  const StationaryPoints stationary = stationary_points(delaunay);
  Json answer;
  add_counts(answer, points, stationary);
  answer.erase("points");
  answer["stationary"] = fast_records(points, stationary);
  const Json& expected = one["expected"]["stationary"];
  if (any_has(expected, "limits")) add_fast_limits(delaunay, stationary, kernel, answer["stationary"]);
  if (any_has(expected, "stable")) {
    add_fast_stable_sets(delaunay, stationary, kernel, expected, answer["stationary"]);
  }
  if (has(one, "persistence")) {
    answer["persistence"] = in_order(fast_persistence(points, delaunay, stationary, kernel));
  }
  if (!has(one, "orbits")) return answer;
  Flow flow(delaunay, {kernel, FacetSearch::kBinary});
  answer["orbits"] = Json::array();
  for (const Json& path : one["expected"]["orbits"]) {
    answer["orbits"].push_back(fast_orbit(points, flow, path["start"]));
  }
  return answer;
}

TEST(Vectors, TheFastImplementationPassesUnderTheLazyKernel) {
  CITES("FC-IN-02", "FC-IN-03", "FC-IN-04", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-04", "FC-CRIT-05",
        "FC-NUM-01", "FC-OUT-01", "FC-OUT-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-05",
        "FC-FLOW-07", "FC-STAB-01", "FC-STAB-04", "FC-STAB-05", "FC-STAB-06", "FC-STAB-07", "FC-PERS-01",
        "FC-PERS-05");
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) {
      expect_same(one, "lazy", fast_answer(one, ConstructionKernel::kLazy), one["expected"]);
    }
  }
}

// Also where the fast implementation has not the very same thing to compare with, as for the walk.
TEST(Vectors, TheFastImplementationDisagreesWithWhatIsWrong) {
  CITES("FC-STAB-04", "FC-STAB-07", "FC-PERS-01");
  const std::map<std::string, std::vector<const char*>> wrong = {
      {"stable-manifolds-0005",
       {R"([{"op":"replace","path":"/stationary/6/stable/walk","value":[0,1,2,1]}])",
        R"([{"op":"replace","path":"/stationary/6/stable/walk","value":null}])",
        R"([{"op":"replace","path":"/stationary/6/stable/boundary","value":null}])",
        R"([{"op":"remove","path":"/stationary/6/stable/boundary/0"}])",
        R"([{"op":"replace","path":"/stationary/6/stable/segments","value":4}])",
        R"([{"op":"replace","path":"/stationary/6/stable/has_interval","value":true}])",
        R"([{"op":"replace","path":"/stationary/6/skeleton/segments/1/back/0","value":"1/3"}])",
        R"([{"op":"remove","path":"/stationary/6/skeleton/segments/2"}])"}},
      {"stable-manifolds-0007",
       {R"([{"op":"replace","path":"/stationary/5/stable/walk","value":[0,2,1,2]}])",
        R"([{"op":"replace","path":"/stationary/5/stable/walk","value":[]}])"}},
      {"persistence-0005",
       {R"([{"op":"replace","path":"/persistence/0/death","value":null}])",
        R"([{"op":"replace","path":"/persistence/3/birth","value":"1/3"}])",
        R"([{"op":"remove","path":"/persistence/2"}])"}}};
  for (const Json& one : all_cases()) {
    const auto changes = wrong.find(one["id"]);
    if (changes == wrong.end()) continue;
    for (const char* change : changes->second) {
      Json changed = one;
      changed["expected"] = one["expected"].patch(Json::parse(change));
      EXPECT_NE(fast_answer(changed, ConstructionKernel::kLazy).dump(), changed["expected"].dump()) << change;
    }
  }
}

TEST(Vectors, TheFastImplementationPassesUnderTheExactKernel) {
  CITES("FC-NUM-01", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-05", "FC-FLOW-07");
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) {
      expect_same(one, "exact", fast_answer(one, ConstructionKernel::kExact), one["expected"]);
    }
  }
}

TEST(Vectors, TheFastImplementationRefusesWhatIsInvalid) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05");
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) continue;
    if (one["refused"] == "points") {
      EXPECT_THROW(fast_points(one), InvalidInput) << one["id"];
    } else {
      EXPECT_EQ(fast_points(one).size(), one["points"].size()) << one["id"];
      EXPECT_THROW(parse_rational_point(words_in_a_row(one["start"])), InvalidInput) << one["id"];
    }
  }
}

// ---- The oracle

// The answer that a case expects, each stationary point certified.
oracle::Answer certified_answer(const Json& one, const std::vector<std::array<double, 3>>& rows) {
  const oracle::PointSet set(rows);
  oracle::Answer answer{rows.size(), set.merged_duplicates, {}};
  for (const Json& x : one["expected"]["stationary"]) {
    const oracle::Record record = oracle::parse_record(x.dump(), one["id"]);
    const auto finding = record.finding ? record.finding : oracle::certify(set, record.claim);
    EXPECT_FALSE(finding) << one["id"] << finding->explanation;
    answer.stationary.push_back(record.claim);
  }
  return answer;
}

std::vector<oracle::Point> starts_of(const Json& one) {
  std::vector<oracle::Point> starts;
  for (const Json& path : one["expected"].value("orbits", Json::array())) {
    starts.push_back(oracle::parse_position(words_in_a_row(path["start"]), "start"));
  }
  return starts;
}

TEST(Vectors, TheOraclePasses) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-OUT-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-05",
        "FC-FLOW-07");
  for (const vectors::Group& group : vectors::groups()) {
    const Json& cases = group_named(group.name)["cases"];
    for (std::size_t k = 0; k < group.recipes.size(); ++k) {
      const auto rows = oracle_rows(cases[k]);
      const oracle::Answer answer =
          rows.size() > kSearched ? certified_answer(cases[k], rows) : oracle::stationary_points(rows);
      const Json made = vectors::case_of(group, group.recipes[k], answer, starts_of(cases[k]));
      expect_same(cases[k], "the case", made, cases[k]);
    }
  }
}

TEST(Vectors, TheOracleRefusesWhatIsInvalid) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05");
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) continue;
    if (one["refused"] == "points") {
      EXPECT_THROW(oracle_rows(one), oracle::UnusableInput) << one["id"];
    } else {
      EXPECT_EQ(oracle_rows(one).size(), one["points"].size()) << one["id"];
      EXPECT_THROW(oracle::parse_position(words_in_a_row(one["start"]), "start"), oracle::UnusableInput)
          << one["id"];
    }
  }
}

}  // namespace
}  // namespace flowcert::conformance
