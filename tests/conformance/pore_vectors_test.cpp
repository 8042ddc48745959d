// The conformance vectors of balls, spec/vectors/balls/pores.json: against the fast implementation, the schema, and the
// program that makes them.
//
// Guarantees: every case is run; what is expected is compared as JSON, exactly. Cases of few balls are made once more
// from the oracle (make_all_vectors_test makes all).
#include "tests/vectors/pore_vectors.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "flowcert/pores.h"
#include "flowcert/read_balls.h"
#include "io/write_pores.h"
#include "tests/cites.h"
#include "tests/conformance/vector_files.h"
#include "tests/vectors/vectors.h"

namespace flowcert::conformance::pore_vectors_test {
namespace {

namespace vectors = oracle::vectors;

constexpr char kFile[] = "balls/pores";
constexpr std::size_t kMadeOnceMore = 7;  // balls

const Json& cases() { return group_named(kFile)["cases"]; }

std::vector<Ball> fast_balls(const Json& one) {
  std::string text = "# of a vector\n";
  for (const Json& words : one["balls"]) {
    for (const Json& word : words) text += word.get<std::string>() + " ";
    text += '\n';
  }
  return read_balls_from(text, "case.xyz", {}, AtomRadii("column:4")).balls;
}

Json fast_number(const QuadraticNumber& number) {
  const PrimitivePolynomial polynomial = primitive_polynomial(number);
  return {{"polynomial", polynomial.coefficients}, {"root", polynomial.root}, {"double", nearest_or_infinity(number)}};
}

Json fast_points(const Pores& pores) {
  Json points = Json::array();
  for (std::uint32_t number = 0; number < pores.points().size(); ++number) {
    const BallPoint& point = pores.points()[number];
    Json& one = points.emplace_back();
    one["index"] = point.index;
    one["contact"] = point.contact;
    one["value"] = fast_number(pores.value(number));
    for (const QuadraticNumber& coordinate : pores.center(number)) one["center"].push_back(fast_number(coordinate));
  }
  return points;
}

// What `pores --json` writes, without what a vector leaves out.
Json fast_pores(const BallSet& balls, const Json& asked, const Pores& pores) {
  std::optional<Rational> probe;
  if (asked["probe"].is_string()) probe = Rational(asked["probe"].get<std::string>());
  std::ostringstream text;
  write_pores(text, {pores, Rational(asked["depth"].get<std::string>()), probe});
  Json json = Json::parse(text.str());
  EXPECT_EQ(json["balls"], balls.size());
  for (const char* key : {"format", "format_version", "version", "commit", "kernel", "compiler", "cgal", "radii"}) {
    EXPECT_EQ(json.erase(key), 1U) << key;
  }
  json.erase("balls");
  return json;
}

TEST(PoreVectors, TheFastImplementationPasses) {
  CITES("FC-BALL-01", "FC-BALL-02", "FC-BALL-03", "FC-BALL-04", "FC-BALL-05", "FC-BALL-06", "FC-BALL-07", "FC-BALL-08",
        "FC-BALL-09", "FC-BALL-10", "FC-FILE-56");
  std::size_t refused = 0;
  for (const Json& one : cases()) {
    if (is_invalid(one)) {
      EXPECT_THROW(fast_balls(one), InvalidInput) << one["id"];
      ++refused;
      continue;
    }
    const BallSet balls(fast_balls(one));
    for (const Json& asked : one["expected"]["pores"]) {
      const Pores pores(balls, Rational(asked["depth"].get<std::string>()));
      expect_same(one, "the list of points", fast_points(pores), one["expected"]["points"]);
      expect_same(one, "the pores", fast_pores(balls, asked, pores), asked);
    }
  }
  EXPECT_EQ(refused, 5U);
}

// The tool makes the file from its own table.
TEST(PoreVectors, AreAsTheToolMakesThem) {
  CITES("FC-BALL-03", "FC-BALL-05", "FC-BALL-09");
  const std::vector<vectors::PoreRecipe> recipes = vectors::pore_recipes();
  ASSERT_EQ(cases().size(), recipes.size());
  EXPECT_TRUE(vectors::text_of(vectors::pore_file(cases())) == vectors_text(kFile));
  for (std::size_t k = 0; k < recipes.size(); ++k) {
    if (recipes[k].balls.size() > kMadeOnceMore) continue;
    expect_same(cases()[k], "all", vectors::pore_case(recipes[k]), cases()[k]);
  }
}

TEST(PoreVectors, HaveTheCage) {
  CITES("FC-BALL-10");
  const std::string file = (spec_folder().parent_path() / "tests" / "inputs" / "cage.xyz").string();
  const std::vector<Ball> cage = read_balls(file, {}, AtomRadii("bondi")).balls;
  std::size_t found = 0;
  for (const Json& one : cases()) {
    if (is_invalid(one) || one["balls"].size() != cage.size()) continue;
    ++found;
    const std::vector<Ball> balls = fast_balls(one);
    for (std::size_t k = 0; k < cage.size(); ++k) {
      EXPECT_EQ(balls[k].center, cage[k].center);
      EXPECT_EQ(balls[k].radius, cage[k].radius);
    }
    EXPECT_NEAR(one["expected"]["pores"][0]["largest_cavity_diameter"].get<double>(), 5.397020, 5e-7);
    EXPECT_EQ(one["expected"]["pores"][0]["windows"].size(), 4U);
  }
  EXPECT_EQ(found, 1U);
}

TEST(PoreVectors, ConformToTheSchema) {
  CITES("FC-BALL-08", "FC-FILE-59");
  nlohmann::json small = nlohmann::json::parse(vectors_text(kFile));
  EXPECT_EQ(violations(small), "");
  auto& all = small["cases"].get_ref<nlohmann::json::array_t&>();
  std::erase_if(all, [](const nlohmann::json& one) { return one["comment"] != "four carbons"; });
  ASSERT_EQ(all.size(), 1U);
  const std::string pores = "/cases/0/expected/pores/0/";
  for (const auto& [path, change] : std::multimap<std::string, std::string>{
           {"/group", R"("op":"remove")"},
           {"/flags", R"("op":"replace","value":[])"},
           {"/cases/0/id", R"("op":"replace","value":"pores-1")"},
           {"/cases/0/balls/0/3", R"("op":"remove")"},
           {"/cases/0/expected", R"("op":"remove")"},
           {"/cases/0/result", R"("op":"replace","value":"invalid")"},
           {"/cases/0/expected/points/0/index", R"("op":"replace","value":0)"},
           {"/cases/0/expected/points/0/contact", R"("op":"replace","value":[1])"},
           {"/cases/0/expected/points/0/value/root", R"("op":"replace","value":2)"},
           {"/cases/0/expected/points/0/value/polynomial/0", R"("op":"replace","value":"-1")"},
           {"/cases/0/expected/points/0/center/2", R"("op":"remove")"},
           {"/cases/0/expected/more", R"("op":"add","value":1)"},
           {pores + "depth", R"("op":"replace","value":"-1")"},
           {pores + "cavities/0/1", R"("op":"replace","value":null)"},
           {pores + "windows/0/rooms", R"("op":"replace","value":[0])"},
           {pores + "chambers/0/gate/points", R"("op":"replace","value":[])"},
           {pores + "chambers/0/is", R"("op":"add","value":"shut")"},
           {pores + "chambers/0/exit/polynomial/0", R"("op":"replace","value":"0")"}}) {
    const std::string patch = R"([{"path":")" + path + "\"," + change + "}]";
    EXPECT_NE(violations(small.patch(nlohmann::json::parse(patch))), "") << patch;
  }
}

}  // namespace
}  // namespace flowcert::conformance::pore_vectors_test
