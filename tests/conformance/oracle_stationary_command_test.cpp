// `flowcert-oracle stationary` as its users see it: the list as text and as JSON Lines, and what is refused;
// and what all commands of the program have in common: help, and an output that cannot be written.
//
// Guarantees: the lists were worked out by hand.
#include <gtest/gtest.h>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::oracle_stationary_command_test {
namespace {

// A right triangle, one corner twice.
constexpr char kTriangle[] = "0 0 0\n4 0 0\n0 4 0\n0 0 0\n";

class OracleStationaryCommand : public testing::Test {
 protected:
  [[nodiscard]] Finished list(std::vector<std::string> options, const Streams& streams = {}) const {
    options.insert(options.begin(), {"stationary", input_});
    return flowcert_oracle(options, streams);
  }

  Scratch scratch_;
  std::string input_ = scratch_.file("triangle.xyz", kTriangle);
};

void expect_refused(const Finished& finished, const std::string& message) {
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err, "flowcert-oracle: " + message + "\n");
}

TEST_F(OracleStationaryCommand, PrintsALineForEachStationaryPoint) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-IN-03", "FC-OUT-01");
  const Finished finished = list({});
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.err, "");
  EXPECT_EQ(finished.out,
            "points 4, merged duplicates 1\n"
            "critical 3 2 0 0\n"
            "regular stationary 1-2: 1, 1-3: 0, 2-3: 0\n"
            "index 0 at 0 0 0 contact 0 squared_distance 0\n"
            "index 0 at 4 0 0 contact 1 squared_distance 0\n"
            "index 0 at 0 4 0 contact 2 squared_distance 0\n"
            "index 1 at 2 0 0 contact 0 1 squared_distance 4\n"
            "index 1 at 0 2 0 contact 0 2 squared_distance 4\n"
            "index 1-2 at 2 2 0 contact 0 1 2 squared_distance 8\n");
}

TEST_F(OracleStationaryCommand, PrintsTheSameAsJson) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-IN-03", "FC-OUT-01", "FC-NUM-02");
  const std::vector<std::string> lines = lines_of(list({"--json"}).out);
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], R"({"format":"oracle-stationary-points","format_version":1,"points":4,"merged_duplicates":1,)"
                      R"("critical":[3,2,0,0],"regular_stationary":{"1-2":1,"1-3":0,"2-3":0}})");
  EXPECT_EQ(lines[4], R"({"index":1,"kind":"critical","contact":[0,1],"center":["2","0","0"],)"
                      R"("squared_distance":"4"})");
  EXPECT_EQ(lines[6], R"({"index":[1,2],"kind":"regular","contact":[0,1,2],"center":["2","2","0"],)"
                      R"("squared_distance":"8"})");
}

TEST_F(OracleStationaryCommand, NoPointHasNoStationaryPoints) {
  CITES("FC-IN-04", "FC-CRIT-02");
  const std::string nothing = scratch_.file("nothing.xyz", "# no point\n");
  EXPECT_EQ(flowcert_oracle({"stationary", nothing}).out,
            "points 0, merged duplicates 0\ncritical 0 0 0 0\nregular stationary 1-2: 0, 1-3: 0, 2-3: 0\n");
}

TEST_F(OracleStationaryCommand, RefusesMorePointsThanTheLimit) {
  CITES("FC-CRIT-02");
  const std::string reason = " points; the search over all subsets of four takes time n^5 (see --limit)";
  EXPECT_EQ(list({"--limit", "4"}).status, 0);
  expect_refused(list({"--limit", "3"}), input_ + ": 4" + reason);
  expect_refused(list({"--limit", "3", "--json"}), input_ + ": 4" + reason);
  std::string rows;
  for (int k = 0; k < 1234; ++k) rows += std::to_string(k) + " 0 0\n";
  const std::string many = scratch_.file("many.xyz", rows);
  expect_refused(flowcert_oracle({"stationary", many}), many + ": 1,234" + reason);
}

TEST_F(OracleStationaryCommand, AskedForHelpSaysWhatThereIs) {
  CITES("FC-CRIT-02");
  const Finished all = flowcert_oracle({"--help"});
  EXPECT_EQ(all.status, 0);
  for (const char* word : {"stationary", "certify", "orbit", "Examples:"}) {
    EXPECT_NE(all.out.find(word), std::string::npos) << word;
  }
  const Finished one = flowcert_oracle({"stationary", "--help"});
  EXPECT_EQ(one.status, 0);
  for (const char* word : {"INPUT", "--json", "--limit", "Examples:"}) {
    EXPECT_NE(one.out.find(word), std::string::npos) << word;
  }
}

TEST_F(OracleStationaryCommand, AnOutputThatCannotBeWrittenIsStatus2) {
  CITES("FC-OUT-01");
  const Streams full = {.standard_input = "/dev/null", .standard_output = "/dev/full"};
  expect_refused(list({}, full), "standard output cannot be written");
  expect_refused(list({"--json"}, full), "standard output cannot be written");
  expect_refused(flowcert_oracle({"orbit", input_, "--from", "1,2,3"}, full), "standard output cannot be written");
}

}  // namespace
}  // namespace flowcert::conformance::oracle_stationary_command_test
