// The two programs against each other: `flowcert-oracle certify` accepts every record that `flowcert compute
// -o` writes, and no record that was tampered with.
//
// Guarantees: all records are judged, not a sample; every field of a record is damaged once.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::certify_command_test {
namespace {

using nlohmann::ordered_json;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
constexpr char kTriangle[] = "0 0 0\n3 0 0\n0 4 0\n";

Finished certify(const std::string& input, const std::string& records) {
  return flowcert_oracle({"certify", input, records, "--sample", "1000000"});
}

// Has the program compute the records of a file, and the oracle judge all of them.
void expect_certified(const Scratch& scratch, const std::string& input) {
  SCOPED_TRACE(input);
  const std::string records = scratch.path("records.jsonl");
  const Finished computed = flowcert({"compute", input, "-o", records});
  ASSERT_EQ(computed.status, 0) << computed.err;
  const Finished judged = certify(input, records);
  EXPECT_EQ(judged.status, 0) << judged.out << judged.err;
  const std::size_t count = lines_of(content_of(records)).size() - 1;
  // Fewer than 1,000 records, so that no comma is in the way.
  ASSERT_LT(count, 1000U);
  const std::string all = std::to_string(count) + " of " + std::to_string(count) + " sampled";
  EXPECT_NE(judged.out.find(" " + all), std::string::npos) << judged.out;
}

std::string grid(int side) {
  std::string text;
  for (int k = 0; k < side * side * side; ++k) {
    text +=
        std::to_string(k % side) + " " + std::to_string(k / side % side) + " " + std::to_string(k / side / side) + "\n";
  }
  return text;
}

TEST(CertifyCommand, AcceptsAllRecordsOfDegenerateInputs) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-NUM-01", "FC-OUT-01");
  const Scratch scratch;
  const std::pair<std::string, std::string> inputs[] = {
      {"nothing", "# no point\n"},
      {"one", "1 2 3\n"},
      {"collinear", "0 0 0\n3 3 3\n1 1 1\n0x1p-1074 0x1p-1074 0x1p-1074\n"},
      {"coplanar", "0 0 1\n1 0 1\n0 1 1\n1 1 1\n0.5 0.5 1\n2 0 1\n"},
      {"cube", kCube},
      {"grid", grid(4)},
      {"duplicates", std::string(kCube) + kCube + "-0.0 0 -0.0\n" + kTriangle},
      {"kind 2-3", "5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n"},
      {"kind 1-3", "1 0 0\n-1 0 0\n0 1 0\n0 0 1\n"},
      {"magnitudes", "1.7e308 0 0\n-1.7e308 0 0\n0 5e-324 0\n0 1 1e-300\n3 0.1 1e150\n-7 1e200 1\n"}};
  for (const auto& [name, points] : inputs) expect_certified(scratch, scratch.file(name + ".xyz", points));
}

TEST(CertifyCommand, AcceptsAllRecordsOfTheRegressions) {
  CITES("FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-OUT-01");
  const Scratch scratch;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLOWCERT_REGRESSIONS)) {
    if (entry.path().extension() != ".xyz") continue;
    ++files;
    expect_certified(scratch, entry.path().string());
  }
  EXPECT_GE(files, 3U);
}

// The records of the right triangle, with one line replaced. The header is line 0. The regular record, of
// kind 1-2, is line 6: five critical points come before it.
class Tampered {
 public:
  Tampered() : input_(scratch_.file("triangle.xyz", kTriangle)) {
    flowcert({"compute", input_, "-o", scratch_.path("records.jsonl")});
    lines_ = lines_of(content_of(scratch_.path("records.jsonl")));
  }
  // The judgment after `damage` has changed the JSON of that line.
  Finished judge(std::size_t line, const std::function<void(ordered_json&)>& damage) const {
    std::vector<std::string> lines = lines_;
    ordered_json object = ordered_json::parse(lines.at(line));
    damage(object);
    lines[line] = object.dump();
    return judge_lines(lines);
  }
  Finished judge_lines(const std::vector<std::string>& lines) const {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return certify(input_, scratch_.file("tampered.jsonl", text));
  }
  const std::vector<std::string>& lines() const { return lines_; }
  const std::string& input() const { return input_; }

 private:
  Scratch scratch_;
  std::string input_;
  std::vector<std::string> lines_;
};

TEST(CertifyCommand, RejectsEveryTamperedField) {
  CITES("FC-IN-03", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-NUM-02", "FC-OUT-01");
  const Tampered tampered;
  ASSERT_EQ(tampered.lines().size(), 7U);
  EXPECT_EQ(tampered.judge(6, [](ordered_json&) {}).status, 0);
  const std::pair<const char*, ordered_json> damages[] = {
      {"index", {2, 3}},
      {"index", 1},
      {"kind", "critical"},
      {"contact", {0, 1}},
      {"contact", {1, 2}},
      {"contact", {0, 1, 2, 3}},
      {"contact", {0, 1, 1, 2}},
      {"contact", {2, 1, 0}},
      {"center", {"3/2", "2", "1/1000000000000000000000000000000"}},
      {"center", {"6/4", "2", "0"}},
      {"squared_distance", "25/5"},
      {"squared_distance", "50/8"},
      {"squared_distance", "62500000000000000000000000001/10000000000000000000000000000"},
      {"center_double", {1.5, 2.0000000000000004, 0.0}},
      {"squared_distance_double", 6.250000000000001},
      {"squared_distance_double", nullptr}};
  for (const auto& [key, value] : damages) {
    const Finished judged =
        tampered.judge(6, [&key = key, &value = value](ordered_json& record) { record[key] = value; });
    EXPECT_EQ(judged.status, 1) << key << " " << value << judged.out << judged.err;
    // The message names the line and a clause.
    EXPECT_TRUE(std::regex_search(judged.out, std::regex("jsonl:7: FC-[A-Z]+-[0-9]{2}"))) << judged.out;
  }
  EXPECT_EQ(tampered.judge(0, [](ordered_json& header) { header["points"] = 4; }).status, 1);
  EXPECT_EQ(tampered.judge(0, [](ordered_json& header) { header["merged_duplicates"] = 1; }).status, 1);
}

TEST(CertifyCommand, WhatCannotBeJudgedIsStatus2) {
  const Tampered tampered;
  std::vector<Finished> all;
  std::vector<std::string> fewer = tampered.lines();
  fewer.pop_back();
  all.push_back(tampered.judge_lines(fewer));
  std::vector<std::string> no_header = tampered.lines();
  no_header.erase(no_header.begin());
  all.push_back(tampered.judge_lines(no_header));
  all.push_back(tampered.judge_lines({}));
  all.push_back(tampered.judge(0, [](ordered_json& header) { header["format"] = "flowcert-summary"; }));
  all.push_back(tampered.judge(0, [](ordered_json& header) { header["format_version"] = 2; }));
  all.push_back(tampered.judge(3, [](ordered_json& record) { record.erase("contact"); }));
  all.push_back(tampered.judge(3, [](ordered_json& record) { record["squared_distance"] = "1/0"; }));
  std::vector<std::string> garbled = tampered.lines();
  garbled[2].resize(garbled[2].size() / 2);
  all.push_back(tampered.judge_lines(garbled));
  all.push_back(certify(tampered.input() + ".none", tampered.input()));
  all.push_back(certify(tampered.input(), tampered.input() + ".none"));
  all.push_back(certify(tampered.input(), tampered.input()));
  all.push_back(flowcert_oracle({"certify", tampered.input()}));
  all.push_back(flowcert_oracle({"--"}));
  for (const Finished& finished : all) {
    EXPECT_EQ(finished.status, 2) << finished.out << finished.err;
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(finished.err.starts_with("flowcert-oracle: ")) << finished.err;
  }
}

// The oracle's own list has the fields of the program's records.
TEST(CertifyCommand, AcceptsTheOraclesOwnList) {
  CITES("FC-OUT-02", "FC-CRIT-02", "FC-CRIT-03");
  const Scratch scratch;
  const std::string input = scratch.file("five.xyz", "0 0 1\n1 0 0\n0 0 0\n1 1 1\n1 0 1\n1 0 0\n");
  const Finished listed = flowcert_oracle({"stationary", "--json", input});
  ASSERT_EQ(listed.status, 0) << listed.err;
  EXPECT_EQ(certify(input, scratch.file("oracle.jsonl", listed.out)).status, 0);
  const std::string records = scratch.path("records.jsonl");
  ASSERT_EQ(flowcert({"compute", input, "-o", records}).status, 0);
  const std::vector<std::string> ours = lines_of(content_of(records)), theirs = lines_of(listed.out);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 1; i < ours.size(); ++i) {
    ordered_json record = ordered_json::parse(ours[i]);
    record.erase("center_double");
    record.erase("squared_distance_double");
    EXPECT_EQ(record.dump(), theirs[i]);
  }
}

}  // namespace
}  // namespace flowcert::conformance::certify_command_test
