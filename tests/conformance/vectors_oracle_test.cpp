// The conformance vectors of spec/vectors/, against the oracle.
//
// Guarantees: every case of every file is run; whatever is expected there is compared as JSON, exactly. For
// more than 12 points, the stationary points that a case lists are certified one by one, and not searched
// for.
#include <gtest/gtest.h>

#include <sstream>

#include "oracle/orbit.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/conformance/vector_files.h"
#include "tests/run_scale.h"
#include "tests/vectors/vectors.h"

namespace flowcert::conformance::vectors_oracle_test {
namespace {

namespace vectors = oracle::vectors;

constexpr std::size_t kSearched = 12;  // points

std::vector<std::array<double, 3>> oracle_rows(const Json& one) {
  std::istringstream in(xyz_text(one));
  return oracle::read_points(in, "case", oracle::PointFormat::kTable);
}

// The answer that a case expects, each stationary point certified.
oracle::Answer certified_answer(const Json& one, const std::vector<std::array<double, 3>>& rows) {
  const oracle::PointSet set(rows);
  oracle::Answer answer{rows.size(), set.merged_duplicates, {}};
  for (const Json& x : one["expected"]["stationary"]) {
    const oracle::Record record = oracle::parse_record(x.dump(), one["id"]);
    const auto fault = record.fault ? record.fault : oracle::certify(set, record.claim);
    EXPECT_FALSE(fault) << one["id"] << fault->explanation;
    answer.stationary.push_back(record.claim);
  }
  return answer;
}

std::vector<oracle::Point> starts_of(const Json& one) {
  std::vector<oracle::Point> starts;
  for (const Json& path : one["expected"].value("orbits", Json::array())) {
    starts.push_back(oracle::parse_position(words_in_a_row(path["start"]), "start"));
  }
  for (const Json& location : one["expected"].value("locations", Json::array())) {
    starts.push_back(oracle::parse_position(words_in_a_row(location["position"]), "position"));
  }
  return starts;
}

TEST(Vectors, TheOraclePasses) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-OUT-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-05", "FC-FLOW-07",
        "FC-UNST-01", "FC-UNST-02", "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02", "FC-UNST-04", "FC-LOC-01",
        "FC-TREE-02", "FC-POCK-02", "FC-MED-02", "FC-STAB-08", "FC-STAT-01");
  for (const vectors::Group& group : vectors::groups()) {
    const Json& cases = group_named(group.name)["cases"];
    // Under sanitizers, which take ten times as long, every sixth case.
    for (std::size_t k = 0; k < group.recipes.size(); k += flowcert_tests::scale_of_run() < 1 ? 6 : 1) {
      const auto rows = oracle_rows(cases[k]);
      const oracle::Answer answer =
          rows.size() > kSearched ? certified_answer(cases[k], rows) : oracle::stationary_points(rows);
      const Json made = vectors::case_of(group, group.recipes[k], answer, starts_of(cases[k]));
      expect_same(cases[k], "the case", made, cases[k]);
    }
  }
}

TEST(Vectors, TheOracleRefusesWhatIsInvalid) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05", "FC-FLOW-10", "FC-LOC-02");
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) continue;
    if (one["refused"] == "points") {
      EXPECT_THROW(oracle_rows(one), oracle::UnusableInput) << one["id"];
    } else if (one["points"] == Json::array()) {
      const oracle::Point start = oracle::parse_position(words_in_a_row(one["start"]), "start");
      EXPECT_THROW(oracle::locate(oracle::PointSet(oracle_rows(one)), start), std::invalid_argument) << one["id"];
    } else {
      EXPECT_EQ(oracle_rows(one).size(), one["points"].size()) << one["id"];
      EXPECT_THROW(oracle::parse_position(words_in_a_row(one["start"]), "start"), oracle::UnusableInput) << one["id"];
    }
  }
}

}  // namespace
}  // namespace flowcert::conformance::vectors_oracle_test
