// The examples of spec/flow_complex.md and spec/claims.md, run against both implementations.
//
// Guarantees: every fenced block that begins with `example` is parsed by the grammar of the spec's section 9
// and checked against the fast implementation and the oracle, each of which reads the points with its own
// reader; what the grammar does not know, a block that expects nothing and an id that no clause has are
// failures, so an example cannot be skipped by a slip of the pen.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/profile.h"
#include "flowcert/read_points.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "oracle/stationary_points.h"
#include "tests/cites.h"
#include "tests/conformance/told_statements.h"

namespace flowcert::conformance::spec_examples_test {
namespace {

// A record as text, "1/2 0 0 index 1-2 contact 0 1 2 squared_distance 1/4", the form of the `at` lines:
// rationals are canonical, so equal records are equal texts.
using RecordText = std::string;

struct Answer {
  std::size_t points = 0;
  std::size_t merged_duplicates = 0;
  std::vector<std::size_t> critical;  // 4
  std::vector<std::size_t> regular;   // of kinds 1-2, 1-3, 2-3
  std::vector<RecordText> records;
};

struct Example {
  std::string clause;
  std::string title;
  std::string points;                          // as the text of an XYZ file
  Answer expected;                             // records: those of the `at` lines
  std::vector<std::vector<std::string>> told;  // other statements, by words
};

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::size_t natural(const std::string& word) {
  if (!std::regex_match(word, std::regex("0|[1-9][0-9]{0,8}"))) {
    throw NotAnExample("'" + word + "' is no count or id");
  }
  return std::stoul(word);
}

std::vector<std::size_t> naturals(const std::vector<std::string>& words, std::size_t count) {
  if (words.size() != count + 1) throw NotAnExample("wrong number of counts after " + words[0]);
  std::vector<std::size_t> result;
  for (std::size_t i = 1; i < words.size(); ++i) result.push_back(natural(words[i]));
  return result;
}

void require_canonical(const std::string& word) {
  const auto rational = oracle::parse_rational(word);
  if (!rational || !rational->canonical) throw NotAnExample("'" + word + "' is no canonical rational");
}

// at X Y Z index K contact IDS… squared_distance R
RecordText parse_at(const std::vector<std::string>& words) {
  const auto is = [&](std::size_t place, const char* word) { return place < words.size() && words[place] == word; };
  const std::size_t n = words.size();
  if (n < 10 || !is(4, "index") || !is(6, "contact") || !is(n - 2, "squared_distance")) {
    throw NotAnExample("an `at` line that lacks a part");
  }
  for (const std::size_t place : {std::size_t{1}, std::size_t{2}, std::size_t{3}, n - 1}) {
    require_canonical(words[place]);
  }
  if (!std::regex_match(words[5], std::regex("[0-3]|1-2|2-3|1-3"))) {
    throw NotAnExample("'" + words[5] + "' is no index");
  }
  for (std::size_t i = 7; i < n - 2; ++i) natural(words[i]);
  RecordText text = words[1];
  for (std::size_t i = 2; i < n; ++i) text += " " + words[i];
  return text;
}

// Parses one statement after `expect`. `seen` has the keywords of the statements before it.
void parse_expectation(const std::vector<std::string>& words, std::set<std::string>& seen, Answer& expected) {
  const std::string& keyword = words[0];
  if (keyword == "at") {
    expected.records.push_back(parse_at(words));
    return;
  }
  if (!seen.insert(keyword).second) throw NotAnExample("'" + keyword + "' twice");
  if (keyword == "points") {
    expected.points = naturals(words, 1)[0];
  } else if (keyword == "merged_duplicates") {
    expected.merged_duplicates = naturals(words, 1)[0];
  } else if (keyword == "critical") {
    expected.critical = naturals(words, 4);
  } else if (keyword == "regular") {
    expected.regular = naturals(words, 3);
  } else {
    throw NotAnExample("unknown keyword '" + keyword + "'");
  }
}

// Parses the lines between the fences. The first one is "example ID".
Example parse_example(const std::vector<std::string>& lines, const std::set<std::string>& clauses) {
  Example example;
  const std::vector<std::string> opening = words_of(lines.at(0));
  if (opening.size() != 2) throw NotAnExample("'example' and one clause id expected");
  example.clause = opening[1];
  if (!clauses.contains(example.clause)) throw NotAnExample("no clause " + example.clause);
  enum class Part { kTitle, kPoints, kExpect } part = Part::kTitle;
  std::set<std::string> seen;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> words = words_of(lines[i]);
    if (words.empty()) throw NotAnExample("an empty line");
    if (part == Part::kTitle && words[0] == "title" && example.title.empty()) {
      example.title = lines[i].substr(5);
    } else if (part == Part::kTitle && lines[i] == "points" && !example.title.empty()) {
      part = Part::kPoints;
    } else if (part == Part::kPoints && lines[i] == "expect") {
      part = Part::kExpect;
    } else if (part == Part::kPoints) {
      example.points += lines[i] + "\n";
    } else if (part == Part::kExpect && is_told(words[0])) {
      example.told.push_back(words);
    } else if (part == Part::kExpect) {
      parse_expectation(words, seen, example.expected);
    } else {
      throw NotAnExample("unexpected line '" + lines[i] + "'");
    }
  }
  if (seen.size() != 4) throw NotAnExample("one of points, merged_duplicates, critical, regular is missing");
  return example;
}

std::set<std::string> clauses_of(const std::string& spec) {
  static const std::regex heading(R"(\*\*(FC-[A-Z]+-[0-9]{2})\*\* \()");
  std::set<std::string> clauses;
  for (auto match = std::sregex_iterator(spec.begin(), spec.end(), heading); match != std::sregex_iterator(); ++match) {
    clauses.insert((*match)[1]);
  }
  return clauses;
}

std::vector<Example> examples_of(const std::string& spec) {
  const std::set<std::string> clauses = clauses_of(spec);
  std::vector<Example> examples;
  std::istringstream in(spec);
  std::vector<std::string> block;
  bool inside = false;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!inside && line.starts_with("```example")) {
      inside = true;
      block = {line.substr(3)};
    } else if (inside && line == "```") {
      inside = false;
      try {
        examples.push_back(parse_example(block, clauses));
      } catch (const NotAnExample& error) {
        throw NotAnExample("the example that ends in line " + std::to_string(number) + ": " + error.what());
      }
    } else if (inside) {
      block.push_back(line);
    }
  }
  if (inside) throw NotAnExample("the last example has no end");
  return examples;
}

template <typename Ids>
RecordText record_text(const std::vector<std::string>& center, int face_dimension, int hull_dimension,
                       const Ids& contact, const std::string& squared_distance) {
  std::string text = center[0] + " " + center[1] + " " + center[2] + " index ";
  if (face_dimension != hull_dimension) text += std::to_string(face_dimension) + "-";
  text += std::to_string(hull_dimension) + " contact";
  for (const auto id : contact) text += " " + std::to_string(id);
  return text + " squared_distance " + squared_distance;
}

Answer fast_answer(const std::string& xyz) {
  const PointSet points(xyz.empty() ? std::vector<Point>{} : read_points_from(xyz, "example.xyz").rows);
  const FlowComplex complex(points);
  const StationaryPoints& stationary = complex.stationary();
  Answer answer;
  answer.points = points.row_count();
  answer.merged_duplicates = points.merged_duplicates();
  answer.critical.assign(stationary.critical_counts().begin(), stationary.critical_counts().end());
  const RegularCounts& regular = stationary.regular_counts();
  answer.regular = {regular.kind12, regular.kind13, regular.kind23};
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    const ExactSphere sphere = exact_sphere(points, stationary.contact(i));
    answer.records.push_back(
        record_text({to_text(sphere.center[0]), to_text(sphere.center[1]), to_text(sphere.center[2])},
                    stationary.index(i).face_dimension, stationary.index(i).hull_dimension, stationary.contact(i),
                    to_text(sphere.squared_radius)));
  }
  return answer;
}

Answer oracle_answer(const std::string& xyz) {
  std::vector<std::array<double, 3>> rows;
  if (!xyz.empty()) {
    std::istringstream in(xyz);
    rows = oracle::read_points(in, "example", oracle::PointFormat::kTable);
  }
  const oracle::Answer found = oracle::stationary_points(rows);
  Answer answer;
  answer.points = found.points;
  answer.merged_duplicates = found.merged_duplicates;
  const auto critical = found.critical_counts();
  answer.critical.assign(critical.begin(), critical.end());
  const auto regular = found.regular_counts();
  answer.regular = {regular[0], regular[1], regular[2]};
  for (const oracle::StationaryPoint& s : found.stationary) {
    answer.records.push_back(record_text({s.center[0].str(), s.center[1].str(), s.center[2].str()}, s.face_dimension,
                                         s.hull_dimension, s.contact, s.squared_distance.str()));
  }
  return answer;
}

// What an implementation's answer contradicts in the example; empty if nothing.
std::string contradiction(const Answer& expected, const Answer& answer) {
  std::ostringstream text;
  if (answer.points != expected.points) text << "points " << answer.points << "; ";
  if (answer.merged_duplicates != expected.merged_duplicates) {
    text << "merged_duplicates " << answer.merged_duplicates << "; ";
  }
  if (answer.critical != expected.critical) {
    text << "critical " << ::testing::PrintToString(answer.critical) << "; ";
  }
  if (answer.regular != expected.regular) {
    text << "regular " << ::testing::PrintToString(answer.regular) << "; ";
  }
  std::size_t total = 0;
  for (const std::size_t count : expected.critical) total += count;
  for (const std::size_t count : expected.regular) total += count;
  if (answer.records.size() != total) text << answer.records.size() << " records; ";
  for (const RecordText& record : expected.records) {
    const auto times = std::count(answer.records.begin(), answer.records.end(), record);
    if (times != 1) text << "'" << record << "' is " << times << " of the records; ";
  }
  return text.str();
}

std::string text_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// What the other statements of the example contradict; empty if nothing.
std::string contradiction_of_told(const Example& example) {
  std::string text;
  for (const std::vector<std::string>& words : example.told) {
    const std::string claimed = text_of(words);
    for (const std::string& right : {told_by_fast(example.points, words), told_by_oracle(example.points, words)}) {
      if (right != claimed) text += "'" + claimed + "' is '" + right + "'; ";
    }
  }
  return text;
}

std::string spec_text() {
  std::ostringstream text;
  for (const char* file : {FLOWCERT_SPEC_FOLDER "/flow_complex.md", FLOWCERT_SPEC_FOLDER "/claims.md"}) {
    text << std::ifstream(file).rdbuf();
  }
  return text.str();
}

TEST(SpecExamples, HoldInBothImplementations) {
  CITES("FC-IN-03", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-INV-01", "FC-OUT-01");
  const std::vector<Example> examples = examples_of(spec_text());
  ASSERT_GE(examples.size(), 8U);
  for (const Example& example : examples) {
    const Answer fast = fast_answer(example.points);
    const Answer oracle = oracle_answer(example.points);
    EXPECT_EQ(contradiction(example.expected, fast), "") << example.clause << example.title;
    EXPECT_EQ(contradiction(example.expected, oracle), "") << example.clause << example.title;
    EXPECT_EQ(fast.records, oracle.records) << example.clause << example.title;
    EXPECT_EQ(contradiction_of_told(example), "") << example.clause << example.title;
  }
}

// The first group of the first line of a file of the spec that is such a line.
std::string first_match(const char* path, const char* pattern) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::smatch parts;
    if (std::regex_match(line, parts, std::regex(pattern))) return parts[1].str();
  }
  return "none";
}

TEST(SpecVersion, IsTheOneThatBothJudgesName) {
  CITES("FC-CLAIM-22", "FC-TERM-01");
  EXPECT_EQ(first_match(FLOWCERT_SPEC_FOLDER "/flow_complex.md", R"(Version (\d+\.\d+), \d{4}-\d\d-\d\d)"),
            kSpecVersion);
  EXPECT_EQ(first_match(FLOWCERT_SPEC_FOLDER "/judge.py", R"re(VERSION = "(\d+\.\d+)".*)re"), kSpecVersion);
}

// The three below make sure that the test above can fail: a small spec, damaged in every way.
constexpr char kHeading[] = "**FC-CRIT-02** (determined). Text.\n";

std::string small_spec(const std::string& from = "", const std::string& to = "") {
  std::string text = std::string(kHeading) +
                     "```example FC-CRIT-02\ntitle Two points\npoints\n0 0 0\n0x1p0 0 0\nexpect\npoints 2\n"
                     "merged_duplicates 0\ncritical 2 1 0 0\nregular 0 0 0\n"
                     "at 1/2 0 0 index 1 contact 0 1 squared_distance 1/4\n```\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(SpecExamplesGrammar, TheSmallSpecIsRight) {
  CITES("FC-CRIT-02");
  const std::vector<Example> examples = examples_of(small_spec());
  ASSERT_EQ(examples.size(), 1U);
  EXPECT_EQ(contradiction(examples[0].expected, fast_answer(examples[0].points)), "");
  EXPECT_EQ(contradiction(examples[0].expected, oracle_answer(examples[0].points)), "");
}

TEST(SpecExamplesGrammar, WhatItDoesNotKnowIsAnError) {
  const std::pair<const char*, const char*> damages[] = {{"example FC-CRIT-02", "example FC-NONE"},
                                                         {"example FC-CRIT-02", "example"},
                                                         {"title Two points\n", ""},
                                                         {"title Two", "titel Two"},
                                                         {"expect\n", ""},
                                                         {"critical 2 1 0 0", "critical 2 1 0"},
                                                         {"critical 2 1 0 0\n", ""},
                                                         {"regular 0 0 0", "regular 0 0 0\nregular 0 0 0"},
                                                         {"regular 0 0 0", "regulars 0 0 0"},
                                                         {"points 2", "points two"},
                                                         {"at 1/2", "At 1/2"},
                                                         {"at 1/2", "at 2/4"},
                                                         {"at 1/2", "at 0.5"},
                                                         {"index 1 ", "index 4 "},
                                                         {"index 1 ", "index 2-2 "},
                                                         {"contact 0 1", "contact"},
                                                         {"contact 0 1", "contact 0 x"},
                                                         {" squared_distance 1/4", ""},
                                                         {"1/4\n", "1/4\n\n"},
                                                         {"1/4\n```", "1/4\n"}};
  for (const auto& [from, to] : damages) {
    EXPECT_THROW(examples_of(small_spec(from, to)), NotAnExample) << from << " -> " << to;
  }
}

TEST(SpecExamplesGrammar, WhatIsWrongIsFoundInBothImplementations) {
  const std::pair<const char*, const char*> mistakes[] = {{"points 2", "points 3"},
                                                          {"merged_duplicates 0", "merged_duplicates 1"},
                                                          {"critical 2 1 0 0", "critical 2 1 1 0"},
                                                          {"regular 0 0 0", "regular 0 0 1"},
                                                          {"at 1/2", "at 1/3"},
                                                          {"index 1 ", "index 2 "},
                                                          {"contact 0 1", "contact 0 2"},
                                                          {"1/4", "1/2"}};
  for (const auto& [from, to] : mistakes) {
    const std::vector<Example> examples = examples_of(small_spec(from, to));
    ASSERT_EQ(examples.size(), 1U);
    EXPECT_NE(contradiction(examples[0].expected, fast_answer(examples[0].points)), "") << from;
    EXPECT_NE(contradiction(examples[0].expected, oracle_answer(examples[0].points)), "") << from;
  }
}

// A statement of each kind, right and made wrong.
TEST(SpecExamplesGrammar, OtherStatementsAreFoundWrongInBothImplementations) {
  const std::string right =
      "nearest 1/2 1 0 contact 0 1\norbit 1/4 0 0 types C-C-F ends 0 1\norbit 1/2 0 0 types stays ends 0 1\n"
      "orbit 2 0 0 types C-C-inf ends infinity\npair 0 0 1/4 times 1\npair 0 0 never times 1\n";
  const auto spec = [](const std::string& told) { return small_spec("at 1/2", told + "at 1/2"); };
  EXPECT_EQ(contradiction_of_told(examples_of(spec(right)).at(0)), "");
  const std::pair<const char*, const char*> mistakes[] = {{"contact 0 1", "contact 0"},   {"1/2 1 0", "1/3 1 0"},
                                                          {"types C-C-F", "types F-F-V"}, {"ends 0 1", "ends 1"},
                                                          {"types stays", "types F-F-F"}, {"ends infinity", "ends 0"},
                                                          {"1/4 times 1", "1/4 times 2"}, {"0 never", "1 never"}};
  for (const auto& [from, to] : mistakes) {
    std::string wrong = right;
    wrong.replace(wrong.find(from), std::string(from).size(), to);
    const std::string found = contradiction_of_told(examples_of(spec(wrong)).at(0));
    // Both implementations say so.
    EXPECT_EQ(std::count(found.begin(), found.end(), ';'), 2) << wrong << found;
  }
}

}  // namespace
}  // namespace flowcert::conformance::spec_examples_test
