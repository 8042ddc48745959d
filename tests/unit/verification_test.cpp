// Answers to the cases of a run, read from a stream and judged: where an answer begins and ends, which outcome a case
// has, and what a run makes of them all.
//
// The answers are made of the oracle's stationary points, by contact sets.
#include "certify/programs/verification.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "certify/programs/command_run.h"
#include "fuzz/judge/drawn_cases.h"
#include "fuzz/judge/oracle_truth.h"
#include "fuzz/properties/input_points.h"
#include "io/json_fields.h"
#include "oracle/exact_geometry.h"
#include "oracle/stationary_points.h"
#include "tests/cites.h"

namespace flowcert::judge::verification_test {
namespace {

TEST(AskedCases, TextIsExact) {
  EXPECT_EQ(case_text("id", {{0.1, -0.0, 5e-324}, {1e300, -3, 0.5}}, NumberForm::kDecimal),
            "case id 2\n0.1 -0 5e-324\n1e+300 -3 0.5\n");
  EXPECT_EQ(case_text("id", {{0.1, -0.0, 1}}, NumberForm::kHexadecimal),
            "case id 1\n0x1.999999999999ap-4 -0x0p+0 0x1p+0\n");
  EXPECT_EQ(case_text("id", {}, NumberForm::kDecimal), "case id 0\n");
}

// ---- Reading

std::vector<Answer> answers_in(const std::string& text) {
  std::istringstream in(text);
  AnswerReader reader(in);
  std::vector<Answer> answers;
  for (Answer answer; reader.next(answer);) answers.push_back(answer);
  return answers;
}

std::string error_in(const std::string& text) {
  try {
    answers_in(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "read without an error";
}

TEST(AnswerReader, TellsWhereAnAnswerBeginsAndEnds) {
  CITES("FC-CLAIM-01");
  const auto answers = answers_in(
      "# hello\n\n answer  a:1\t\r\n0,0,0,0\n\n  # inside\nend of a line\nendless\nend \t\r\n"
      "refused b   too hard \nanswer c\nend\n# bye\n");
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].id, "a:1");
  EXPECT_EQ(answers[0].place.line, 3U);
  EXPECT_FALSE(answers[0].is_refusal);
  EXPECT_EQ(answers[0].text, "0,0,0,0\n\n  # inside\nend of a line\nendless\n");
  EXPECT_EQ(answers[1].id, "b");
  EXPECT_TRUE(answers[1].is_refusal);
  EXPECT_EQ(answers[1].text, "too hard");
  EXPECT_EQ(answers[2].text, "");
  EXPECT_EQ(answers[2].place.line, 11U);
  EXPECT_TRUE(answers_in("# nothing\n").empty());
}

// A program may be killed at any byte.
TEST(AnswerReader, TellsWhereTheStreamIsBrokenOff) {
  CITES("FC-CLAIM-01");
  const std::string text = "answer a\n0,0,0,0\nend\nrefused b no\n";
  const auto cut_of = [&](std::size_t size, std::size_t whole) {
    std::istringstream in(text.substr(0, size));
    AnswerReader reader(in, "it");
    std::size_t answers = 0;
    for (Answer answer; reader.next(answer);) answers += answer.is_cut ? 0 : 1;
    EXPECT_EQ(answers, whole) << size;
    return reader.cut();
  };
  EXPECT_EQ(cut_of(1, 0), "it:1: it ends within a line: 'a'");
  EXPECT_EQ(cut_of(8, 0), "it:1: it ends within a line: 'answer a'");
  EXPECT_EQ(cut_of(9, 0), "it:1: it ends within the answer to 'a'");
  EXPECT_EQ(cut_of(14, 0), "it:2: it ends within the answer to 'a'");
  EXPECT_EQ(cut_of(19, 0), "it:3: it ends within the answer to 'a'");
  EXPECT_EQ(cut_of(20, 1), "");
  EXPECT_EQ(cut_of(21, 1), "");
  EXPECT_EQ(cut_of(25, 1), "it:4: it ends within a line: 'refu'");
  EXPECT_EQ(cut_of(text.size(), 2), "");
}

TEST(AnswerReader, RefusesWhatIsNoAnswer) {
  CITES("FC-CLAIM-01");
  EXPECT_EQ(error_in("\nanswer a\nanswer b\nend\n"),
            "standard input:3: 'answer' before the 'end' of the answer of line 2");
  EXPECT_EQ(error_in("answer a\nrefused b\n"), "standard input:2: 'refused' before the 'end' of the answer of line 1");
  EXPECT_EQ(error_in("answer a\nend\n0,0,0,0\n"), "standard input:3: neither 'answer ID' nor 'refused ID': '0,0,0,0'");
  EXPECT_EQ(error_in("answer a b\nend\n"), "standard input:1: more than an id after 'answer': 'b'");
  EXPECT_EQ(error_in("refused\n"), "standard input:1: no id of a case after 'refused'");
}

// ---- Judging

fuzz::CaseRun run_of(const std::string& family, std::size_t cases) {
  fuzz::CaseRun run;
  run.cases = cases;
  run.chosen = fuzz::chosen_families({family});
  return run;
}

std::string line_of(int index, const std::vector<std::size_t>& contact) {
  std::string line = std::to_string(index) + ",,,,";
  for (const std::size_t name : contact) line += "," + std::to_string(name);
  return line + "\n";
}

// The critical points of a case.
std::string claim_of(const fuzz::CaseRun& run, std::size_t number) {
  std::string text;
  for (const auto& point : oracle::stationary_points(fuzz::input_of_case(run, number).rows).stationary) {
    if (point.is_critical()) text += line_of(point.hull_dimension, point.contact);
  }
  return text;
}

Answer answer_to(const fuzz::CaseRun& run, std::size_t number, const std::string& text) {
  const std::string id = fuzz::case_id(run, number, fuzz::input_of_case(run, number));
  return {.place = {.file = "answers", .line = number + 1}, .id = id, .is_refusal = false, .text = text};
}
Answer answer_to(const fuzz::CaseRun& run, std::size_t number) { return answer_to(run, number, claim_of(run, number)); }

VerificationOptions keeping_failures() {
  VerificationOptions options;
  options.oracle = truth_of_oracle();
  options.drawn = drawn_cases_of;
  options.most_failures_kept = 5;
  return options;
}

// A verification that has taken the right answers of the cases from `first` up to but not `last`.
Verification verified(const fuzz::CaseRun& run, std::size_t first, std::size_t last,
                      const VerificationOptions& options = keeping_failures()) {
  Verification verification(options);
  for (std::size_t number = first; number < last; ++number) verification.take(answer_to(run, number));
  return verification;
}

std::string complaint_of(Verification& verification, const Answer& answer) {
  try {
    verification.take(answer);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "taken";
}

TEST(Verification, RightAnswersConform) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04");
  for (const bool by_oracle : {false, true}) {
    const fuzz::CaseRun run = run_of("lattice-2", 12);
    VerificationOptions options = keeping_failures();
    options.by_oracle = by_oracle;
    const Verification verification = verified(run, 0, 12, options);
    EXPECT_EQ(verification.verdict(), Verdict::kConforms);
    EXPECT_EQ(verification.counts(), (OutcomeCounts{12, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(verification.too_large(), 0U);
    EXPECT_EQ(verification.approximate(), 0U);
    EXPECT_TRUE(verification.failures().empty());
  }
}

TEST(Verification, AWrongAnswerFails) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03");
  const fuzz::CaseRun run = run_of("general-position", 8);
  Verification verification = verified(run, 0, 5);
  std::string less = claim_of(run, 5), twice = claim_of(run, 6);
  ASSERT_FALSE(less.empty());
  verification.take(answer_to(run, 5, less.substr(less.find('\n') + 1)));
  verification.take(answer_to(run, 6, twice + twice.substr(0, twice.find('\n') + 1)));
  verification.take(answer_to(run, 7, "2,0,0\n"));
  EXPECT_EQ(verification.counts(), (OutcomeCounts{5, 0, 0, 2, 1, 0, 0}));
  EXPECT_EQ(verification.verdict(), Verdict::kFails);
  ASSERT_EQ(verification.failures().size(), 3U);
  const FailedCase& missing = verification.failures().at(5);
  EXPECT_EQ(missing.wrong, missing.findings.size());
  ASSERT_FALSE(missing.findings.empty());
  EXPECT_EQ(missing.findings.front().clause, "FC-INV-01") << "Euler's sum";
  EXPECT_EQ(missing.findings.back().clause, "FC-CLAIM-03");
  EXPECT_EQ(verification.failures().at(6).findings.front().reason, FindingReason::kClaimedTwice);
  EXPECT_EQ(verification.failures().at(7).outcome, Outcome::kUnreadable);
}

// A regular stationary point claimed as the pair of critical points that a perturbation makes of it.
TEST(Verification, APermittedVariationIsNoFailure) {
  CITES("FC-CLAIM-04");
  const fuzz::CaseRun run = run_of("right-angle-12", 1);
  const std::vector<Point> rows = property::rows_of(fuzz::input_of_case(run, 0));
  std::string claim = claim_of(run, 0), regular;
  const auto answer = oracle::stationary_points(fuzz::input_of_case(run, 0).rows);
  for (const auto& point : answer.stationary) {
    if (point.face_dimension != 1 || point.hull_dimension != 2 || point.contact.size() != 3) continue;
    regular = line_of(2, point.contact);
    for (const std::size_t left_out : point.contact) {
      std::vector<std::size_t> side = point.contact;
      std::erase(side, left_out);
      const auto middle = oracle::circumcentre({oracle::exact({rows[side[0]].x, rows[side[0]].y, rows[side[0]].z}),
                                                oracle::exact({rows[side[1]].x, rows[side[1]].y, rows[side[1]].z})});
      if (middle->center == point.center) regular += line_of(1, side);
    }
    claim += regular;
  }
  ASSERT_FALSE(regular.empty());
  Verification verification(keeping_failures());
  verification.take(answer_to(run, 0, claim));
  EXPECT_EQ(verification.counts(), (OutcomeCounts{0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(verification.verdict(), Verdict::kPerturbed);
  EXPECT_TRUE(verification.failures().empty());
  // Variations are not reported beside what is wrong.
  Verification wrong(keeping_failures());
  wrong.take(answer_to(run, 0, claim.substr(claim.find('\n') + 1)));
  ASSERT_EQ(wrong.failures().size(), 1U);
  for (const Finding& finding : wrong.failures().at(0).findings) EXPECT_FALSE(finding.is_variation);
}

TEST(Verification, ACaseIsAnsweredOnce) {
  CITES("FC-CLAIM-01");
  const fuzz::CaseRun run = run_of("lattice-3", 4);
  Verification verification = verified(run, 0, 2);
  EXPECT_NE(complaint_of(verification, answer_to(run, 1)).find("answers:2: a second answer to the case"),
            std::string::npos);
  // Nor is a wrong answer mended by a right one.
  verification.take(answer_to(run, 2, "none"));
  EXPECT_NE(complaint_of(verification, answer_to(run, 2)).find("a second answer"), std::string::npos);
  EXPECT_EQ(verification.taken(), 3U);
  EXPECT_EQ(verification.counts(), (OutcomeCounts{2, 0, 0, 0, 1, 0, 1}));
}

TEST(Verification, AllAnswersAreOfOneRun) {
  CITES("FC-CLAIM-01");
  const fuzz::CaseRun run = run_of("lattice-3", 4);
  Verification verification = verified(run, 0, 1);
  fuzz::CaseRun other_seed = run;
  other_seed.seed = 2;
  for (const fuzz::CaseRun& other : {run_of("lattice-3", 5), run_of("lattice-2", 4), other_seed}) {
    EXPECT_NE(complaint_of(verification, answer_to(other, 1)).find("of another run"), std::string::npos);
  }
  Answer damaged = answer_to(run, 1);
  damaged.id.back() = damaged.id.back() == '0' ? '1' : '0';
  EXPECT_NE(complaint_of(verification, damaged).find("no case is called"), std::string::npos);
  EXPECT_EQ(complaint_of(verification, answer_to(run, 1)), "taken");
}

TEST(Verification, WhatIsUnansweredIsNotRight) {
  CITES("FC-CLAIM-03");
  const fuzz::CaseRun run = run_of("lattice-3", 9);
  Verification verification = verified(run, 0, 2);
  verification.take(answer_to(run, 4));
  verification.take(answer_to(run, 7));
  EXPECT_EQ(verification.verdict(), Verdict::kFails);
  using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(verification.unanswered_ranges(), (Ranges{{2, 3}, {5, 6}, {8, 8}}));
  Answer refusal = answer_to(run, 8, "too hard\x1b[31m");
  refusal.is_refusal = true;
  verification.take(refusal);
  EXPECT_EQ(verification.counts(), (OutcomeCounts{4, 0, 0, 0, 0, 1, 4}));
  EXPECT_EQ(verification.failures().at(8).reason, "too hard?[31m");
}

TEST(Verification, OneCaseAlone) {
  CITES("FC-CLAIM-03");
  const fuzz::CaseRun run = run_of("lattice-3", 9);
  VerificationOptions options = keeping_failures();
  options.only = 3;
  Verification verification(options);
  EXPECT_NE(complaint_of(verification, answer_to(run, 2)).find("not the case"), std::string::npos);
  verification.take(answer_to(run, 3));
  EXPECT_EQ(verification.verdict(), Verdict::kConforms);
  EXPECT_TRUE(verification.unanswered_ranges().empty());
}

// ---- Vectors

// A folder with one vector: an acute triangle whose two orbits are said to end at the given sample. (They go to
// infinity.)
std::unique_ptr<ScratchFolder> vectors_with_limits_at(int sample) {
  Json one = Json::parse(R"({"id": "triangle", "comment": "", "flags": ["few-points"], "result": "determined",
    "points": [["0","0","0"], ["4","0","0"], ["2","3","0"]], "expected": {"merged_duplicates": 0}})");
  for (const auto& point : oracle::stationary_points({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}).stationary) {
    Json record = {{"index", point.hull_dimension}, {"contact", point.contact}, {"squared_distance", "0"}};
    for (const Rational& coordinate : point.center) record["center"].push_back(to_text(coordinate));
    record["squared_distance"] = to_text(point.squared_distance);
    if (point.hull_dimension == 2) record["limits"] = {{sample}, {sample}};
    one["expected"]["stationary"].push_back(record);
  }
  auto folder = std::make_unique<ScratchFolder>();
  write_text_file(folder->path() / "flags.json", R"({"format": "flowcert-vector-flags", "format_version": 1,
    "flags": [{"flag": "few-points", "meaning": "Few points."}]})");
  const Json group = {{"format", "flowcert-vectors"}, {"format_version", 1}, {"group", "few"}, {"cases", {one}}};
  write_text_file(folder->path() / "few.json", group.dump());
  return folder;
}

// All critical points of that triangle, with limits at a sample.
std::string exchange_claim(const std::string& limit) {
  std::string text = R"({"format":"flowcert-stationary-points","format_version":1})";
  for (const char* contact : {"[0]", "[1]", "[2]"}) text += std::string("\n{\"index\":0,\"contact\":") + contact + "}";
  for (const char* contact : {"[0,1]", "[0,2]", "[1,2]"}) {
    text += std::string("\n{\"index\":1,\"contact\":") + contact + "}";
  }
  return text + "\n{\"index\":2,\"contact\":[0,1,2],\"limits\":[" + limit + "," + limit + "]}\n";
}

TEST(Verification, AVectorSaysWhatIsRight) {
  CITES("FC-FLOW-07");
  const auto folder = vectors_with_limits_at(1);
  const auto cases = vectors_to_ask(folder->path().string(), drawn_cases_of);
  const auto outcomes = [&](const std::string& limit) {
    Verification verification(keeping_failures(), vectors_to_ask(folder->path().string(), drawn_cases_of));
    verification.take({.place = {.file = "answers", .line = 1},
                       .id = cases->id(cases->numbered(0)),
                       .is_refusal = false,
                       .text = exchange_claim(limit)});
    return verification.counts();
  };
  EXPECT_EQ(outcomes("[1]"), (OutcomeCounts{1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(outcomes("null"), (OutcomeCounts{0, 0, 0, 1, 0, 0, 0}));
}

TEST(Verification, OnlyWhatIsAskedIsExpected) {
  CITES("FC-CLAIM-03");
  const fuzz::CaseRun run = run_of("lattice-2", 5);
  VerificationOptions options = keeping_failures();
  options.asked = {1, 4};
  Verification verification(options, drawn_cases(run));
  EXPECT_EQ(verification.expected(), 2U);
  verification.take(answer_to(run, 4));
  EXPECT_EQ(verification.unanswered_ranges(), (std::vector<std::pair<std::size_t, std::size_t>>{{1, 1}}));
  EXPECT_NE(complaint_of(verification, answer_to(run, 2)).find("not among the cases that are asked"),
            std::string::npos);
  verification.take(answer_to(run, 1));
  EXPECT_EQ(verification.verdict(), Verdict::kConforms);
}

TEST(Verification, CasesOfMorePointsAreNotExpected) {
  CITES("FC-CLAIM-03");
  fuzz::CaseRun run = run_of("lattice-2", 12);
  run.most_points = 4;
  const std::vector<std::size_t> asked = drawn_cases(run)->asked_numbers();
  ASSERT_LT(asked.size(), 12U);
  ASSERT_GT(asked.size(), 1U);
  Verification verification(keeping_failures());  // the answers say which run it is
  for (const std::size_t number : asked) verification.take(answer_to(run, number));
  EXPECT_EQ(verification.expected(), asked.size());
  EXPECT_EQ(verification.verdict(), Verdict::kConforms);
  run.most_points = 0;
  EXPECT_THROW(Verification(keeping_failures(), drawn_cases(run)), InvalidInput);
}

TEST(Verification, WhatIsCutIsUnanswered) {
  CITES("FC-CLAIM-03");
  const fuzz::CaseRun run = run_of("lattice-3", 3);
  Answer cut = answer_to(run, 1);
  cut.is_cut = true;
  Verification verification = verified(run, 0, 1);
  verification.take(cut);
  EXPECT_EQ(verification.counts(), (OutcomeCounts{1, 0, 0, 0, 0, 0, 2}));
  cut.id = "no-id";
  EXPECT_NE(complaint_of(verification, cut).find("no case is called"), std::string::npos);
}

// A vector of the same name that says something else is another case.
TEST(Verification, AnswersAreToTheVectorsThatWereAsked) {
  CITES("FC-CLAIM-01");
  const auto asked = vectors_with_limits_at(1), other = vectors_with_limits_at(2);
  const auto cases = vectors_to_ask(asked->path().string(), drawn_cases_of);
  Verification verification(keeping_failures(), vectors_to_ask(other->path().string(), drawn_cases_of));
  const Answer answer{.place = {.file = "answers", .line = 1},
                      .id = cases->id(cases->numbered(0)),
                      .is_refusal = false,
                      .text = exchange_claim("[1]")};
  EXPECT_NE(complaint_of(verification, answer).find("no case of the vectors"), std::string::npos);
}

}  // namespace
}  // namespace flowcert::judge::verification_test
