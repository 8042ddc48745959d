// `flowcert stats` as a user calls it: bars, JSON (src/cli/manual/stats.md) and pictures.
//
// Guarantees: the three tell the same numbers, which are those of `compute --stats`. Those of a triangle are worked out
// by hand. Pictures are read by Expat, so they are well-formed XML.
#include <expat.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "fuzz/inputs/large_configurations.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::stats_command_test {
namespace {

using nlohmann::json;

constexpr char kAcute[] = "0 0 0\n4 0 0\n1 3 0\n";
constexpr const char* kNames[] = {"n_s2", "n_u2", "n_wcc", "exact_bytes"};

json statistics_of(const std::vector<std::string>& words) {
  const Finished finished = flowcert(words);
  EXPECT_EQ(finished.status, 0) << finished.err;
  return json::parse(finished.out);
}

// The object of a distribution.
const json& distribution(const json& statistics, const std::string& name) {
  return statistics[name == "n_s2" ? "s2" : "u2"][name];
}

// The counts of a histogram's lines of bars, in the order in which `stats` prints the histograms.
std::vector<std::vector<std::size_t>> printed_counts(const std::string& text) {
  std::vector<std::vector<std::size_t>> all;
  const std::regex bar(R"( +([0-9,]+) +([0-9,]+) +([0-9,]+)( +#+)?)");
  bool is_bars = false;
  for (const std::string& line : lines_of(text)) {
    if (std::regex_match(line, std::regex(" +from +to +count"))) {
      all.emplace_back();
      is_bars = true;
    } else if (std::smatch found; is_bars && std::regex_match(line, found, bar)) {
      const std::string digits = std::regex_replace(found[3].str(), std::regex(","), "");
      all.back().push_back(std::stoul(digits));
      EXPECT_EQ(all.back().back() > 0, found[4].matched) << line;
    } else {
      is_bars = false;
    }
  }
  return all;
}

std::size_t sum_of(const std::vector<std::size_t>& counts) {
  std::size_t sum = 0;
  for (const std::size_t count : counts) sum += count;
  return sum;
}

bool is_well_formed(const std::string& text) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  return XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_OK;
}

// The counts of a picture's bars, and their heights.
struct Bars {
  std::vector<std::size_t> counts;
  std::vector<double> heights;
};
Bars bars_of(const std::string& svg) {
  Bars bars;
  const std::regex bar(R"re(height="([0-9.]+)" fill="#4477aa"><title>\d+ to \d+: (\d+)</title>)re");
  for (std::sregex_iterator at(svg.begin(), svg.end(), bar), end; at != end; ++at) {
    bars.counts.push_back(std::stoul((*at)[2].str()));
    bars.heights.push_back(std::stod((*at)[1].str()));
  }
  return bars;
}

TEST(StatsCommand, ATriangle) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kAcute);
  const json statistics = statistics_of({"stats", input, "--json"});
  EXPECT_EQ(statistics["format"], "flowcert-stats");
  EXPECT_EQ(statistics["format_version"], 1);
  EXPECT_EQ(statistics["critical"], json::parse("[3,3,1,0]"));
  EXPECT_EQ(distribution(statistics, "n_s2")["histogram"], json::parse("[[1,3]]"));
  EXPECT_EQ(distribution(statistics, "n_u2")["histogram"], json::parse("[[1,2]]"));
  EXPECT_EQ(distribution(statistics, "n_wcc")["count"], 0);
  const Finished finished = flowcert({"stats", input});
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(printed_counts(finished.out), (std::vector<std::vector<std::size_t>>{{3}, {2}}));
  EXPECT_NE(finished.out.find("  none"), std::string::npos);
}

TEST(StatsCommand, BarsJsonAndPicturesAgreeWithCompute) {
  const Scratch scratch;
  std::string rows;
  for (const auto& row : fuzz::half_shell(600, 1).rows) {
    rows += std::to_string(row[0]) + " " + std::to_string(row[1]) + " " + std::to_string(row[2]) + "\n";
  }
  const std::string input = scratch.file("points.xyz", rows), folder = scratch.path("pictures");
  for (const std::string kernel : {"cascade", "lazy", "exact"}) {
    SCOPED_TRACE(kernel);
    const json statistics = statistics_of({"stats", input, "--json", "--kernel", kernel, "--svg", folder});
    const json summary =
        statistics_of({"compute", input, "--manifolds", "u2,s2", "--stats", "--json", "--kernel", kernel});
    EXPECT_EQ(statistics["input_sha256"], summary["input_sha256"]);
    EXPECT_EQ(statistics["u2"]["kernel"], kernel);
    EXPECT_EQ(statistics["u2"]["depth"], summary["u2"]["depth"]);
    for (const char* name : {"n_s2", "n_u2", "n_wcc"}) {
      EXPECT_EQ(distribution(statistics, name), distribution(summary, name)) << name;
    }
    EXPECT_EQ(statistics["u2"]["exact_bytes"]["count"], summary["u2"]["exact_bytes"]["count"]);
    const Finished finished = flowcert({"stats", input, "--kernel", kernel});
    const auto printed = printed_counts(finished.out);
    std::size_t next = 0;
    for (const std::string name : kNames) {
      const std::string svg = content_of(folder + "/" + name + ".svg");
      EXPECT_TRUE(is_well_formed(svg)) << name;
      const std::vector<std::size_t> drawn = bars_of(svg).counts;
      const json& expected = distribution(statistics, name);
      EXPECT_EQ(sum_of(drawn), expected["count"]) << name;
      if (expected["count"] == 0) continue;
      EXPECT_LE(drawn.size(), 30U);
      EXPECT_GT(drawn.size(), 1U) << name;
      EXPECT_EQ(printed.at(next++), drawn) << name;
    }
    EXPECT_EQ(next, printed.size());
  }
}

TEST(StatsCommand, HeightsAreInProportionOrLogarithmic) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", lattice_points(5, 60, 3)), folder = scratch.path("pictures");
  (void)statistics_of({"stats", input, "--json", "--svg", folder});
  const Bars plain = bars_of(content_of(folder + "/n_u2.svg"));
  (void)statistics_of({"stats", input, "--json", "--svg", folder, "--log"});
  const Bars logarithmic = bars_of(content_of(folder + "/n_u2.svg"));
  ASSERT_EQ(plain.counts, logarithmic.counts);
  ASSERT_GT(plain.counts.size(), 1U);
  const auto most =
      static_cast<std::size_t>(std::max_element(plain.counts.begin(), plain.counts.end()) - plain.counts.begin());
  const auto log_of = [](std::size_t count) { return count == 0 ? 0 : std::log(2 * static_cast<double>(count)); };
  for (std::size_t k = 0; k < plain.counts.size(); ++k) {
    const double share = static_cast<double>(plain.counts[k]) / static_cast<double>(plain.counts[most]);
    EXPECT_NEAR(plain.heights[k], share * plain.heights[most], 0.2);
    EXPECT_NEAR(logarithmic.heights[k] * log_of(plain.counts[most]),
                logarithmic.heights[most] * log_of(plain.counts[k]), 2);
  }
}

TEST(StatsCommand, RefusesInOneLine) {
  const Scratch scratch;
  const std::string input = scratch.file("points.xyz", kAcute);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"stats"},
                                                {"stats", scratch.path("none.xyz")},
                                                {"stats", input, "--kernel", "x"},
                                                {"stats", input, "--svg", input}}) {
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_EQ(finished.out, "");
  }
  EXPECT_EQ(scratch.names(), (std::set<std::string>{"points.xyz"}));
}

TEST(StatsCommand, ItsHelpHasAnExample) {
  const Finished finished = flowcert({"stats", "--help"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_NE(finished.out.find("Example"), std::string::npos);
}

}  // namespace
}  // namespace flowcert::conformance::stats_command_test
