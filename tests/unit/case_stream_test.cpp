// Runs of cases: a case is what its number says, for good, and an id names nothing else.
#include "fuzz/inputs/case_stream.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

namespace flowcert::fuzz::case_stream_test {
namespace {

CaseRun run_of(int level, std::uint64_t seed, const std::vector<std::string>& names = {}) {
  CaseRun run;
  run.level = level;
  run.seed = seed;
  run.cases = usual_cases(level);
  run.chosen = chosen_families(names);
  return run;
}

std::string id_of(const CaseRun& run, std::size_t number) { return case_id(run, number, input_of_case(run, number)); }

TEST(CaseStream, IdsNameTheirCases) {
  for (const CaseRun& run : {run_of(1, 1), run_of(2, 7), run_of(3, 18446744073709551615U),
                             run_of(1, 3, {"lattice-2", "few-points"}), run_of(3, 5, {"half-shell"})}) {
    for (std::size_t number = 0; number < 80; ++number) {
      const Input input = input_of_case(run, number);
      const std::string id = case_id(run, number, input);
      EXPECT_EQ(id.find_first_of(" \t\n#"), std::string::npos) << id;
      const std::optional<NamedCase> named = case_named(id);
      ASSERT_TRUE(named) << id;
      EXPECT_EQ(named->run, run);
      EXPECT_EQ(named->number, number);
      EXPECT_EQ(named->input, input);
    }
  }
}

// Pins the cases: if these lines change, answers that somebody has kept are refused.
TEST(CaseStream, IdsNameTheSameInputsForGood) {
  EXPECT_EQ(id_of(run_of(1, 7), 12), "1:7:12/500:a688");
  EXPECT_EQ(id_of(run_of(2, 1), 4999), "2:1:4999/5000:7cec");
  EXPECT_EQ(id_of(run_of(3, 1), 19999), "3:1:19999/20000:4a51");
  EXPECT_EQ(id_of(run_of(1, 7, {"one-ulp-off", "collinear"}), 3), "1:7:3/500:8c32:collinear,one-ulp-off");
}

TEST(CaseStream, OneSpellingOfAnId) {
  const std::string id = id_of(run_of(1, 7), 12);
  ASSERT_TRUE(case_named(id));
  for (std::size_t k = 0; k < id.size(); ++k) {
    for (const char c : {'0', '3', ':', '/', 'x', ' ', '-', '+'}) {
      std::string damaged = id;
      damaged[k] = c;
      EXPECT_TRUE(damaged == id || !case_named(damaged)) << damaged;
    }
    EXPECT_FALSE(case_named(id.substr(0, k))) << k;
  }
  EXPECT_FALSE(case_named(id + ":"));
  EXPECT_FALSE(case_named(id + ":lattice-2"));
  EXPECT_FALSE(case_named("1:07:12" + id.substr(6)));
  EXPECT_FALSE(case_named("1:7:12/99999999999999999999:0000"));
  const std::string chosen = id_of(run_of(1, 7, {"lattice-2", "few-points"}), 0);
  ASSERT_TRUE(chosen.ends_with(":lattice-2,few-points")) << chosen;
  EXPECT_FALSE(case_named(chosen + ",few-points"));
  EXPECT_FALSE(case_named(chosen.substr(0, chosen.find("lattice")) + "few-points,lattice-2"));
}

// A run that leaves out cases has ids of its own, and the same cases.
TEST(CaseStream, IdsSayWhichCasesAreLeftOut) {
  CaseRun few = run_of(1, 7);
  few.most_points = 5;
  std::size_t left_out = 0;
  for (std::size_t number = 0; number < 80; ++number) {
    const Input input = input_of_case(few, number);
    EXPECT_EQ(input, input_of_case(run_of(1, 7), number));
    const std::string id = case_id(few, number, input);
    const std::optional<NamedCase> named = case_named(id);
    ASSERT_EQ(named.has_value(), input.rows.size() <= 5) << id;
    left_out += named ? 0 : 1;
    if (!named) continue;
    EXPECT_EQ(named->run, few);
    EXPECT_FALSE(case_named(id.substr(0, id.find("/5:")) + id.substr(id.find("/5:") + 2)));
  }
  EXPECT_GT(left_out, 10U);
  EXPECT_LT(left_out, 70U);
}

TEST(CaseStream, ACaseIsAFunctionOfItsNumber) {
  CaseRun shorter = run_of(2, 9);
  shorter.cases = 40;
  std::set<std::vector<Row>> seen;
  for (std::size_t number = 0; number < 40; ++number) {
    const Input input = input_of_case(run_of(2, 9), number);
    EXPECT_EQ(input, input_of_case(shorter, number));
    EXPECT_EQ(&family_of_case(shorter, number), &families()[number % families().size()]);
    seen.insert(input.rows);
  }
  EXPECT_GT(seen.size(), 35U);
  EXPECT_NE(input_of_case(run_of(2, 9), 0), input_of_case(run_of(2, 10), 0));
  EXPECT_NE(input_of_case(run_of(2, 9), 0), input_of_case(run_of(3, 9), 0));
}

TEST(CaseStream, LevelsGrow) {
  std::array<std::size_t, 3> points{};
  std::array<std::size_t, 3> most{};
  for (int level = 1; level <= kCaseLevels; ++level) {
    for (std::size_t number = 0; number < 500; ++number) {
      const std::size_t rows = input_of_case(run_of(level, 1), number).rows.size();
      points.at(static_cast<std::size_t>(level - 1)) += rows;
      most.at(static_cast<std::size_t>(level - 1)) = std::max(most.at(static_cast<std::size_t>(level - 1)), rows);
    }
  }
  EXPECT_LT(points[0], points[1]);
  EXPECT_LT(points[1], points[2]);
  EXPECT_LE(most[1], 12U);
  EXPECT_GT(most[2], 100U);
  EXPECT_LE(most[2], 400U);
  EXPECT_LT(usual_cases(1), usual_cases(2));
  EXPECT_LT(usual_cases(2), usual_cases(3));
}

TEST(CaseStream, FamiliesByName) {
  EXPECT_TRUE(chosen_families({}).empty());
  EXPECT_EQ(chosen_families({"lattice-2", "general-position", "lattice-2"}), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(family_names(run_of(1, 1, {"lattice-2", "general-position"})),
            (std::vector<std::string>{"general-position", "lattice-2"}));
  EXPECT_THROW((void)chosen_families({"lattice-2", "lattice"}), std::invalid_argument);
  const std::vector<std::string> all = family_names({});
  EXPECT_EQ(all.size(), families().size());
  EXPECT_TRUE(chosen_families(all).empty()) << "all of them is the same as none";
}

}  // namespace
}  // namespace flowcert::fuzz::case_stream_test
