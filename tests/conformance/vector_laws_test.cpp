// Laws that the answers of the conformance vectors keep, and what their schema says of the groups about locations,
// merge trees, pockets, the medial axis, infinity and statistics.
//
// Guarantees: every law is asked of all cases that it is about, and of three at least. Nothing is computed of the flow
// here: a law ties numbers of the files to each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "oracle/exact_geometry.h"
#include "oracle/persistence.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/conformance/vector_files.h"

namespace flowcert::conformance::vector_laws_test {
namespace {

using oracle::Rational;

constexpr std::size_t kCasesOfAClause = 3;

Rational number(const Json& text) { return oracle::parse_rational(text)->value; }

bool has_flag(const Json& one, const char* flag) {
  return std::find(one["flags"].begin(), one["flags"].end(), flag) != one["flags"].end();
}

// Calls visit(case) for all cases with the flag.
template <class Visit>
void visit_cases_with(const char* flag, const Visit& visit) {
  std::size_t visited = 0;
  for (const Json& one : all_cases()) {
    if (!has_flag(one, flag)) continue;
    visit(one);
    ++visited;
  }
  EXPECT_GE(visited, kCasesOfAClause) << flag;
}

// The same for the groups in which the case before it is the one that it is made of.
template <class Visit>
void visit_pairs_with(const char* flag, const Visit& visit) {
  std::size_t visited = 0;
  for (const std::string& name : names_of_files()) {
    if (name == "flags") continue;
    const Json& cases = group_named(name)["cases"];
    for (std::size_t k = 1; k < cases.size(); ++k) {
      if (!has_flag(cases[k], flag)) continue;
      visit(cases[k - 1], cases[k]);
      ++visited;
    }
  }
  EXPECT_GE(visited, kCasesOfAClause) << flag;
}

// ---- The schema

struct Damage {
  std::string group, id;
  std::vector<std::pair<std::string, std::string>> changes;  // of `expected`: path, and the rest of an operation
};

void expect_noticed(const Damage& damage) {
  nlohmann::json file = nlohmann::json::parse(vectors_text(damage.group));
  std::erase_if(file["cases"].get_ref<nlohmann::json::array_t&>(),
                [&](const nlohmann::json& one) { return one["id"] != damage.id; });
  ASSERT_EQ(file["cases"].size(), 1U) << damage.id;
  ASSERT_EQ(violations(file), "");
  for (const auto& [path, change] : damage.changes) {
    const std::string patch = R"([{"path":"/cases/0/expected/)" + path + "\"," + change + "}]";
    EXPECT_NE(violations(file.patch(nlohmann::json::parse(patch))), "") << damage.id << patch;
  }
}

TEST(VectorLaws, TheSchemaNoticesDamagesOfTreesAndPockets) {
  CITES("FC-TREE-02", "FC-POCK-03", "FC-POCK-04", "FC-POCK-06");
  expect_noticed({"merge-trees",
                  "merge-trees-0012",
                  {{"merge_trees/components", R"("op":"remove")"},
                   {"merge_trees/pockets/leaves/0/contact", R"("op":"remove")"},
                   {"merge_trees/pockets/leaves/0/more", R"("op":"add","value":1)"},
                   {"merge_trees/pockets/nodes/0/parts/0", R"("op":"remove")"},
                   {"merge_trees/pockets/nodes/0/joined_by", R"("op":"replace","value":[])"},
                   {"merge_trees/pockets/nodes/0/squared_distance", R"("op":"replace","value":0.5)"}}});
  expect_noticed({"pockets",
                  "pockets-0012",
                  {{"pockets", R"("op":"replace","value":[])"},
                   {"pockets/0/squared_persistence", R"("op":"replace","value":"-1")"},
                   {"pockets/0/outside", R"("op":"remove")"},
                   {"pockets/0/pore_limiting_radius/gates", R"("op":"replace","value":[])"},
                   {"pockets/0/largest_cavity_radius/balls/0/center", R"("op":"remove")"},
                   {"pockets/0/probes/0/is/0", R"("op":"replace","value":"hole")"},
                   {"pockets/0/pockets/0/difference_of_squares", R"("op":"replace","value":"0")"},
                   {"pockets/0/pockets/0/volume", R"("op":"replace","value":1)"},
                   {"pockets/0/pockets/0/cell/0/index", R"("op":"replace","value":4)"},
                   {"pockets/0/pockets/0/mouths", R"("op":"replace","value":[])"},
                   {"pockets/0/pockets/0/mouths/0/between", R"("op":"replace","value":[0])"},
                   {"pockets/0/pockets/0/neighbours/0", R"("op":"replace","value":-2)"},
                   {"pockets/0/pockets/0/widest_path", R"("op":"replace","value":null)"},
                   {"pockets/0/pockets/0/radius", R"("op":"add","value":1)"}}});
}

TEST(VectorLaws, TheSchemaNoticesDamagesOfLocationsAxesAndInfinity) {
  CITES("FC-LOC-01", "FC-MED-02", "FC-STAB-08", "FC-STAT-01");
  expect_noticed({"locations",
                  "locations-0006",
                  {{"locations", R"("op":"replace","value":[])"},
                   {"locations/0/position", R"("op":"remove")"},
                   {"locations/0/kind", R"("op":"replace","value":"far")"},
                   {"locations/0/nearest", R"("op":"replace","value":[])"}}});
  expect_noticed({"medial-axes",
                  "medial-axes-0012",
                  {{"medial_axes/angles", R"("op":"replace","value":[])"},
                   {"medial_axes/angles/0/angle", R"("op":"replace","value":60)"},
                   {"medial_axes/persistences/0/levels/0/index", R"("op":"replace","value":3)"},
                   {"medial_axes/persistences/0/levels/0/points", R"("op":"replace","value":0)"},
                   {"medial_axes/persistences/0/squared_persistence", R"("op":"replace","value":"-1")"}}});
  expect_noticed({"infinity",
                  "infinity-0012",
                  {{"infinity/segments", R"("op":"remove")"},
                   {"infinity/unbounded_intervals", R"("op":"remove")"},
                   {"infinity/unbounded_segments/0/vector/0", R"("op":"replace","value":"-0")"},
                   {"infinity/unbounded_segments/0/back_kind", R"("op":"replace","value":"far")"},
                   {"infinity/unbounded_sectors/0/corners", R"("op":"replace","value":[])"}}});
  expect_noticed({"cycles",
                  "cycles-0003",
                  {{"cycles", R"("op":"replace","value":[])"},
                   {"cycles/0/claim", R"("op":"replace","value":[])"},
                   {"cycles/0/reasons", R"("op":"replace","value":["wrong"])"},
                   {"cycles/0/reasons", R"("op":"remove")"}}});
  expect_noticed({"statistics",
                  "statistics-0012",
                  {{"statistics/n_s2", R"("op":"remove")"},
                   {"statistics/n_u2/0/1", R"("op":"replace","value":0)"},
                   {"statistics/n_u2/0", R"("op":"replace","value":[1])"}}});
}

// Points may be missing only where a start has to be refused for that.
TEST(VectorLaws, TheSchemaNoticesDamagesOfInvalidCases) {
  CITES("FC-FLOW-10", "FC-LOC-02", "FC-IN-05");
  nlohmann::json file = nlohmann::json::parse(vectors_text("invalid-input"));
  ASSERT_EQ(file["cases"][39]["id"], "invalid-input-0040");
  for (const char* damage :
       {R"([{"op":"remove","path":"/cases/39/start"}])", R"([{"op":"replace","path":"/cases/0/points","value":[]}])",
        R"([{"op":"remove","path":"/cases/39/points"}])", R"([{"op":"remove","path":"/cases/39/refused"}])",
        R"([{"op":"add","path":"/cases/39/text","value":""}])"}) {
    EXPECT_NE(violations(file.patch(nlohmann::json::parse(damage))), "") << damage;
  }
}

// ---- Counts

TEST(VectorLaws, LatticesAndTetrahedraHaveTheirCounts) {
  CITES("FC-INV-03", "FC-INV-05");
  visit_cases_with("whole-lattice", [](const Json& one) {
    std::size_t k = 1;
    const std::size_t points = one["points"].size() - one["expected"]["merged_duplicates"].get<std::size_t>();
    while (k * k * k < points) ++k;
    ASSERT_EQ(k * k * k, points) << one["id"];
    const std::size_t m = k - 1;
    expect_same(one, "critical", one["expected"]["critical"], {k * k * k, 3 * m * k * k, 3 * m * m * k, m * m * m});
    expect_same(one, "regular", one["expected"]["regular_stationary"], {{"1-2", 0}, {"1-3", 0}, {"2-3", 0}});
  });
  visit_cases_with("one-tetrahedron", [](const Json& one) {
    const std::array<int, 4> count = one["expected"]["critical"];
    EXPECT_EQ(count[0], 4) << one["id"];
    EXPECT_EQ(4 - count[1] + count[2] - count[3], 1) << one["id"];
  });
}

// ---- Boundaries

TEST(VectorLaws, BoundariesAreCyclesStrictlyBelow) {
  CITES("FC-CHAIN-03", "FC-CHAIN-01");
  visit_cases_with("determined-boundary", [](const Json& one) {
    std::map<Json, Rational> value;
    for (const Json& x : one["expected"]["stationary"]) value[x["contact"]] = number(x["squared_distance"]);
    for (const Json& x : one["expected"]["stationary"]) {
      if (!x.contains("stable") || !x["stable"].contains("boundary") || x["stable"]["boundary"].is_null()) continue;
      std::set<Json> odd;
      for (const Json& edge : x["stable"]["boundary"]) {
        EXPECT_LT(value.at(edge), value.at(x["contact"])) << one["id"] << edge;
        for (const Json& sample : edge) {
          if (!odd.insert(sample).second) odd.erase(sample);
        }
      }
      EXPECT_TRUE(odd.empty()) << one["id"] << x["contact"];
    }
  });
}

// ---- Images

// The normal of the first three contact points by name.
oracle::Point normal_of(const Json& one, const Json& contact) {
  std::array<oracle::Point, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> row{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row[axis] = std::stod(one["points"][contact[k].get<std::size_t>()][axis].get<std::string>());
    }
    p[k] = oracle::exact(row);
  }
  return oracle::cross(oracle::minus(p[1], p[0]), oracle::minus(p[2], p[0]));
}

std::map<Json, Json> limits_by_contact(const Json& one) {
  std::map<Json, Json> limits;
  for (const Json& x : one["expected"]["stationary"]) {
    if (x.contains("limits")) limits[x["contact"]] = x["limits"];
  }
  return limits;
}

TEST(VectorLaws, ReflectionsSwapSides) {
  CITES("FC-FLOW-11", "FC-INV-04");
  visit_pairs_with("mirror-image", [](const Json& one, const Json& image) {
    ASSERT_EQ(one["points"].size(), image["points"].size());
    for (std::size_t k = 0; k < one["points"].size(); ++k) {
      EXPECT_EQ(std::stod(one["points"][k][0].get<std::string>()),
                -std::stod(image["points"][k][0].get<std::string>()));
    }
    std::map<Json, Json> limits = limits_by_contact(one);
    for (auto& [contact, sides] : limits) std::swap(sides[0], sides[1]);
    EXPECT_EQ(limits, limits_by_contact(image)) << image["id"];
    EXPECT_FALSE(limits.empty()) << image["id"];
  });
}

// Classes of several rows would get other names in another way. These inputs have none.
TEST(VectorLaws, NewNamesSwapSidesWhereTheyTurn) {
  CITES("FC-FLOW-11", "FC-INV-04");
  visit_pairs_with("renamed", [](const Json& one, const Json& image) {
    const std::size_t last = one["points"].size() - 1;
    const auto renamed = [last](const Json& contact) {
      if (contact.is_null()) return contact;
      Json names = Json::array();
      for (auto name = contact.rbegin(); name != contact.rend(); ++name) {
        names.push_back(last - name->get<std::size_t>());
      }
      return names;
    };
    Json reversed = one["points"];
    std::reverse(reversed.begin(), reversed.end());
    ASSERT_EQ(reversed, image["points"]);
    ASSERT_EQ(one["expected"]["merged_duplicates"], 0);
    std::map<Json, Json> limits;
    for (const auto& [contact, sides] : limits_by_contact(one)) {
      const Json names = renamed(contact);
      const bool turns = oracle::dot(normal_of(one, contact), normal_of(image, names)) < 0;
      limits[names] = {renamed(sides[turns ? 1 : 0]), renamed(sides[turns ? 0 : 1])};
    }
    EXPECT_EQ(limits, limits_by_contact(image)) << image["id"];
    EXPECT_FALSE(limits.empty()) << image["id"];
  });
}

// The numbers in a text whose key tells that it is a square of a length, a volume, or a coordinate.
void multiply(Json& value, const std::string& key, const Rational& scale) {
  static const std::set<std::string> squares = {"squared_persistence", "squared_radius", "difference_of_squares",
                                                "squared_distance"};
  if (value.is_structured()) {
    for (auto& [inner, part] : value.items()) multiply(part, value.is_object() ? inner : key, scale);
    return;
  }
  if (!value.is_string()) return;
  if (squares.contains(key)) value = Rational(number(value) * scale * scale).str();
  if (key == "volume") value = Rational(number(value) * scale * scale * scale).str();
  if (key == "center" || key == "probe") value = Rational(number(value) * scale).str();
}

TEST(VectorLaws, PocketsGrowWithTheScale) {
  CITES("FC-POCK-10", "FC-INV-04");
  visit_pairs_with("scaled-copy", [](const Json& one, const Json& image) {
    Rational scale = 0;
    for (std::size_t k = 0; k < one["points"].size(); ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Rational before = std::stod(one["points"][k][axis].get<std::string>());
        const Rational after = std::stod(image["points"][k][axis].get<std::string>());
        if (scale == 0 && before != 0) scale = after / before;
        EXPECT_EQ(after, before * scale);
      }
    }
    std::size_t compared = 0;
    for (const char* key : {"pockets", "merge_trees"}) {
      if (!has(one, key)) continue;
      Json grown = one["expected"][key];
      multiply(grown, "", scale);
      expect_same(image, key, image["expected"][key], grown);
      ++compared;
    }
    EXPECT_EQ(compared, 1U) << image["id"];
  });
}

// ---- Trees and pairs

// Birth and death of the pairs of dimension 2 that the nodes stand for, or all in which a component ends.
std::multiset<std::pair<Rational, Rational>> pairs_of(const Json& tree) {
  std::multiset<std::pair<Rational, Rational>> pairs;
  std::vector<std::optional<Rational>> greatest;  // by part; nothing for one with infinity
  for (const Json& leaf : tree["leaves"]) {
    greatest.push_back(leaf["contact"].is_null() ? std::optional<Rational>() : number(leaf["squared_distance"]));
  }
  for (const Json& node : tree["nodes"]) {
    const Rational value = number(node["squared_distance"]);
    std::vector<std::optional<Rational>> parts;
    for (const Json& part : node["parts"]) parts.push_back(greatest.at(part.get<std::size_t>()));
    std::sort(parts.begin(), parts.end());  // what has infinity comes first
    const bool has_infinity = !parts.front();
    greatest.push_back(has_infinity ? std::optional<Rational>() : parts.back());
    parts.erase(has_infinity ? parts.begin() : parts.end() - 1);
    for (const auto& part : parts) pairs.emplace(value, *part);
  }
  return pairs;
}

// The pairs of the dimension, without the one that lasts.
std::multiset<std::pair<Rational, Rational>> listed_pairs(const Json& one, int dimension) {
  std::multiset<std::pair<Rational, Rational>> pairs;
  for (const Json& pair : one["expected"]["persistence"]) {
    if (pair["dimension"] == dimension && !pair["death"].is_null()) {
      pairs.emplace(number(pair["birth"]), number(pair["death"]));
    }
  }
  return pairs;
}

TEST(VectorLaws, NodesOfTreesAreThePairs) {
  CITES("FC-TREE-05", "FC-TREE-06", "FC-TREE-01");
  std::size_t with_nodes = 0;
  for (const Json& one : group_named("merge-trees")["cases"]) {
    if (!has(one, "persistence")) continue;
    const Json& trees = one["expected"]["merge_trees"];
    EXPECT_EQ(pairs_of(trees["pockets"]), listed_pairs(one, 2)) << one["id"];
    std::multiset<std::pair<Rational, Rational>> ends;
    for (const Json& node : trees["components"]["nodes"]) {
      for (std::size_t k = 1; k < node["parts"].size(); ++k) ends.emplace(0, number(node["squared_distance"]));
    }
    EXPECT_EQ(ends, listed_pairs(one, 0)) << one["id"];
    with_nodes += trees["pockets"]["nodes"].empty() ? 0 : 1;
  }
  EXPECT_GE(with_nodes, kCasesOfAClause);
}

// Both groups have some inputs in common.
TEST(VectorLaws, PocketsThatAreDeepAreAsManyAsLongPairs) {
  CITES("FC-POCK-09", "FC-TREE-05");
  std::map<Json, const Json*> by_points;
  for (const Json& one : group_named("merge-trees")["cases"]) by_points[one["points"]] = &one;
  std::size_t compared = 0, apart = 0;
  for (const Json& one : group_named("pockets")["cases"]) {
    const auto same = by_points.find(one["points"]);
    if (same == by_points.end()) continue;
    const auto pairs = pairs_of((*same->second)["expected"]["merge_trees"]["pockets"]);
    for (const Json& answer : one["expected"]["pockets"]) {
      const Rational square = number(answer["squared_persistence"]);
      std::size_t deep = 0;
      for (const Json& pocket : answer["pockets"]) {
        Rational mouth = 0;
        for (const Json& one : pocket["mouths"]) mouth = std::max(mouth, number(one["squared_radius"]));
        const bool is_deep =
            !oracle::is_root_difference_up_to(number(pocket["peaks"][0]["squared_radius"]), mouth, square);
        (is_deep ? deep : apart) += 1;
      }
      const auto longer = std::count_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
        return !oracle::is_root_difference_up_to(pair.second, pair.first, square);
      });
      EXPECT_EQ(deep, static_cast<std::size_t>(longer)) << one["id"] << square;
      ++compared;
    }
  }
  EXPECT_GT(compared, 60U);
  EXPECT_GE(apart, kCasesOfAClause);
}

}  // namespace
}  // namespace flowcert::conformance::vector_laws_test
