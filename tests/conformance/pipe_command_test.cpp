// `flowcert generate | PROGRAM | flowcert verify` as a user calls it (src/cli/manual/cases.md),
// with a program in the middle that can be wrong (answering_program.cpp).
//
// Guarantees: right answers of every family conform in every format, by the fast implementation and by the
// oracle; each kind of wrong answer is found in its case and no other; what is no stream of answers is
// refused with one line. The README's example is run as it stands there.
#include <expat.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "fuzz/inputs/families.h"
#include "tests/cites.h"
#include "tests/conformance/pipe.h"

namespace flowcert::conformance::pipe_command_test {
namespace {

TEST(Verify, RightAnswersOfEveryFamilyConform) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04", "FC-CLAIM-05");
  std::set<std::string> all;
  for (const fuzz::Family& family : fuzz::families()) all.insert(family.name);
  EXPECT_EQ(all.size(), 36U);
  for (const char* form : {"exchange", "csv", "decimals", "contacts"}) {
    SCOPED_TRACE(form);
    const Pipe pipe({}, {form});
    const json report = pipe.as_json();
    EXPECT_EQ(report["verdict"], "conforms");
    EXPECT_EQ(report["cases"], 500);
    const bool is_decimal = std::string(form) == "decimals";
    EXPECT_EQ(report["profile"]["statement"], std::string("conforms to 1.2, points, ") +
                                                  (is_decimal ? "approximate within 1e-09" : "exact") +
                                                  " (500 drawn inputs)");
    EXPECT_EQ(report["failures"], json::array());
    EXPECT_EQ(report["unanswered_numbers"], json::array());
    EXPECT_EQ(report["approximate"] == 0, std::string(form) != "decimals");
    std::set<std::string> judged;
    for (const json& family : report["families"]) {
      judged.insert(family["family"]);
      EXPECT_GE(family["cases"], 13);
    }
    EXPECT_EQ(judged, all);
  }
}

TEST(Verify, PermittedVariationsAreRight) {
  CITES("FC-CLAIM-04");
  const Pipe pipe({"--family", "right-angle-12", "--cases", "40"}, {"perturbed"});
  const json report = pipe.as_json();
  EXPECT_EQ(report["verdict"], "perturbed");
  EXPECT_GT(report["perturbed"], 5);
  EXPECT_EQ(report["failures"], json::array());
  EXPECT_TRUE(contains(pipe.verify().out, "\nperturbed: 40 of 40 cases are right;"));
}

// Permitted variations are not reported beside what is wrong.
TEST(Verify, PermittedVariationsAreNoFailures) {
  CITES("FC-CLAIM-04", "FC-CLAIM-03");
  Words middle = {"perturbed"};
  for (int k = 0; k < 20; ++k) middle.insert(middle.end(), {"drop", std::to_string(k)});
  const json report = Pipe({"--family", "right-angle-12", "--cases", "20"}, middle).as_json();
  EXPECT_EQ(report["fails"], 20);
  for (const json& failure : report["failures"]) {
    EXPECT_EQ(failure["wrong"], failure["findings"].size());
    for (const json& finding : failure["findings"]) EXPECT_EQ(finding["permitted"], false) << finding;
  }
}

TEST(Verify, TheOracleAgrees) {
  CITES("FC-CLAIM-03");
  // Some cases are large, and the oracle is not asked about them.
  const Pipe pipe({"--level", "3", "--cases", "40", "--family", "lattice-3", "--family", "half-shell"});
  const json report = pipe.as_json({"--oracle"});
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["truth"], "oracle");
  EXPECT_GT(report["too_large_for_oracle"], 0);
  EXPECT_LT(report["too_large_for_oracle"], 20);
  const Finished text = pipe.verify({"--oracle"});
  EXPECT_TRUE(contains(text.out, "\nconforms: 40 of 40 cases are right; truth by the oracle, of ")) << text.out;
  EXPECT_EQ(pipe.as_json()["truth"], "fast implementation");
}

TEST(Verify, TakesGiesenKuehneAndHexadecimalInput) {
  CITES("FC-CLAIM-05", "FC-IN-02");
  const Words run = {"--family", "general-position", "--family", "mixed-magnitudes", "--cases", "60"};
  EXPECT_EQ(Pipe(joined(run, {"--hex"})).as_json()["verdict"], "conforms");
  const Pipe pipe({"--family", "general-position", "--cases", "60"}, {"giesen-kuehne"});
  EXPECT_EQ(pipe.as_json({"--highest-level", "3"})["verdict"], "conforms");
  EXPECT_EQ(pipe.as_json()["verdict"], "fails") << "that format claims incidences, and they are left out";
}

TEST(Verify, FindsEachWrongAnswer) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03");
  // The faults are in cases that have critical points.
  const Words faults = {"drop", "3", "index", "41", "unreadable", "77", "refuse", "108", "none", "149"};
  for (const char* form : {"csv", "decimals", "contacts"}) {
    SCOPED_TRACE(form);
    const Pipe pipe({"--seed", "7", "--cases", "150"}, joined({form}, faults));
    const Words ids = ids_of(pipe.cases());
    const json report = pipe.as_json();
    EXPECT_EQ(report["verdict"], "fails");
    EXPECT_EQ(report["fails"], 3);
    EXPECT_EQ(report["unreadable"], 1);
    EXPECT_EQ(report["refused"], 1);
    EXPECT_EQ(report["unanswered"], 0);
    const json& failures = report["failures"];
    ASSERT_EQ(failures.size(), 5U);
    const std::vector<std::size_t> numbers = {3, 41, 77, 108, 149};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      EXPECT_EQ(failures[k]["number"], numbers[k]);
      EXPECT_EQ(failures[k]["id"], ids[numbers[k]]);
      EXPECT_EQ(failures[k]["family"], fuzz::families()[numbers[k] % 36].name);
      EXPECT_EQ(failures[k]["wrong"].get<std::size_t>() == 0, k == 2 || k == 3);
      EXPECT_EQ(failures[k]["findings"].empty(), k == 2 || k == 3);
    }
    EXPECT_EQ(failures[0]["verdict"], "fails");
    const json& missing = failures[0]["findings"].back();
    EXPECT_EQ(missing["clause"], "FC-CLAIM-03");
    EXPECT_TRUE(missing["line"].is_null());
    EXPECT_FALSE(failures[1]["findings"][0]["line"].is_null());
    EXPECT_EQ(failures[2]["verdict"], "unreadable");
    EXPECT_TRUE(contains(failures[2]["reason"], "not an index, 0 to 3: 'saddle'"));
    EXPECT_EQ(failures[3]["verdict"], "refused");
    EXPECT_EQ(failures[3]["reason"], "too hard <for me>");
  }
}

TEST(Verify, ReportsToPeople) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--seed", "7", "--cases", "80"}, {"csv", "drop", "3", "unreadable", "12", "refuse", "40", "refuse",
                                                     "41", "skip", "50", "skip", "51", "skip", "70"});
  const Words ids = ids_of(pipe.cases());
  const Finished text = pipe.verify();
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.err, "");
  EXPECT_TRUE(contains(text.out, "family"));
  EXPECT_TRUE(
      text.out.starts_with("3 of 80 cases have no answer: 50-51, 70\n\n  reason      cases  smallest example\n"
                           "  refused         2  case 40 (few-points), 4 points\n"
                           "  missing         1  case 3 (lattice-4), "))
      << text.out;
  EXPECT_TRUE(contains(text.out, "\ncase " + ids[3] + " (lattice-4) fails on level 3\n  answer: wrong, level 3: "))
      << text.out;
  const std::string its_points = "generate --level 1 --seed 7 --cases 80 --case 3 --xyz";
  EXPECT_TRUE(contains(text.out, "  its points: flowcert " + its_points + "\n")) << text.out;
  // What is wrong, in plain words, and why.
  EXPECT_TRUE(contains(text.out, "\n    You missed ")) << text.out;
  const std::size_t why = text.out.find("  why: flowcert " + its_points + " | flowcert explain - --ids ");
  ASSERT_NE(why, std::string::npos) << text.out;
  const std::string line = text.out.substr(why + 7, text.out.find('\n', why) - why - 7);
  const Finished explained =
      RunningProgram({"/bin/sh", "-c", "flowcert() { \"$0\" \"$@\"; }; " + line, FLOWCERT_PROGRAM}).finish();
  EXPECT_EQ(explained.status, 0) << line << explained.err;
  EXPECT_TRUE(contains(explained.out, ": critical point of index ")) << explained.out;
  // They are a point file.
  Words words;
  std::istringstream command(its_points);
  for (std::string word; command >> word;) words.push_back(word);
  const Scratch scratch;
  EXPECT_EQ(flowcert({"compute", scratch.file("case.xyz", flowcert(words).out)}).status, 0);
  EXPECT_TRUE(contains(text.out, "\ncase " + ids[12] + " (coplanar-lattice) unreadable: answer:"));
  EXPECT_TRUE(contains(text.out, "\ncase " + ids[40] + " (few-points) refused: too hard <for me>\n"));
  EXPECT_TRUE(contains(text.out, "\nfails: 73 of 80 cases are right; truth by the fast implementation\n"));
  EXPECT_FALSE(contains(text.out, "--most"));

  // An example of each reason is always there.
  const Finished less = pipe.verify({"--most", "0"});
  EXPECT_EQ(less.status, 1);
  for (const std::size_t number : {3U, 12U, 40U}) EXPECT_TRUE(contains(less.out, ids[number]));
  EXPECT_FALSE(contains(less.out, ids[41]));
  EXPECT_TRUE(contains(less.out, "\n(3 of 4 failing cases are shown; --most N shows N)\n")) << less.out;
  const json reasons = pipe.as_json()["reasons"];
  ASSERT_EQ(reasons.size(), 3U);
  EXPECT_EQ(reasons[0], json({{"reason", "refused"}, {"cases", 2}, {"smallest", 40}, {"smallest_points", 4}}));
}

TEST(Verify, SaysHowManyAnswersAreApproximate) {
  CITES("FC-CLAIM-05");
  const Pipe pipe({"--cases", "40"}, {"decimals"});
  const std::size_t approximate = pipe.as_json()["approximate"];
  EXPECT_GT(approximate, 0U);
  const Finished text = pipe.verify({"--tolerance", "1e-7"});
  EXPECT_TRUE(contains(unbroken(text.out), ": 40 of 40 cases are right; " + std::to_string(approximate) +
                                               " approximate, tolerance 1e-07 of the radius; truth by the fast"))
      << text.out;
}

TEST(Verify, TwentyRangesOfUnansweredAreShown) {
  CITES("FC-CLAIM-03");
  Words middle = {"csv"};
  std::string shown = "0";
  for (int k = 0; k < 21; ++k) {
    middle.insert(middle.end(), {"skip", std::to_string(2 * k)});
    if (k > 0 && k < 20) shown += ", " + std::to_string(2 * k);
  }
  const Pipe pipe({"--cases", "60"}, middle);
  const std::string text = unbroken(pipe.verify().out);
  EXPECT_TRUE(text.starts_with("21 of 60 cases have no answer: " + shown + ", ...\n")) << text;
  EXPECT_EQ(pipe.as_json()["unanswered_numbers"].size(), 21U);
}

TEST(Verify, TenFailuresAreShownAndAllAreCounted) {
  CITES("FC-CLAIM-03");
  Words middle = {"csv"};
  for (int k = 0; k < 15; ++k) middle.insert(middle.end(), {"refuse", std::to_string(2 * k)});
  const Pipe pipe({"--cases", "40"}, middle);
  const Finished text = pipe.verify();
  std::size_t shown = 0;
  for (const std::string& line : lines_of(text.out)) shown += line.starts_with("case ") ? 1 : 0;
  EXPECT_EQ(shown, 10U);
  EXPECT_TRUE(contains(text.out, "\n(10 of 15 failing cases are shown; --most N shows N)\n")) << text.out;
  EXPECT_TRUE(contains(text.out, "\nfails: 25 of 40 cases are right;"));
  EXPECT_EQ(pipe.as_json()["failures"].size(), 15U);
  EXPECT_EQ(pipe.as_json({"--most", "4"})["failures"].size(), 4U);
}

TEST(Verify, AReasonNeverReachesATerminalRaw) {
  CITES("FC-CLAIM-03");
  const std::string id = ids_of(generated({"--level", "1", "--cases", "1"})).front();
  const Scratch scratch;
  const std::string path = scratch.file("answers", "refused " + id + " \x1b[31mred\x07 \xc3\xbc\n");
  const Finished text = flowcert({"verify"}, {path, ""});
  EXPECT_EQ(text.status, 1);
  EXPECT_TRUE(contains(text.out, ") refused: ?[31mred? ??\n")) << text.out;
}

// Eight megabytes of wrong lines take little more than that: 400 MB of address space are enough.
TEST(Verify, AnEndlessAnswerTakesNoMemory) {
  const std::string head = generated({"--case", "3"});
  const Words words = lines_of(cases_of(head).at(0));
  const std::string id = words[0].substr(5, words[0].find(' ', 5) - 5);
  const Scratch scratch;
  std::string answer = "answer " + id + "\n";
  while (answer.size() < 8'000'000) answer += "2,0.5,0.25,0,1,0,1\n";
  const std::string file = scratch.file("answers", answer + "end\n");
  RunningProgram program({"/bin/sh", "-c", "ulimit -v 400000; exec \"$0\" verify --case 3", FLOWCERT_PROGRAM},
                         {file, ""});
  const Finished finished = program.finish();
  EXPECT_EQ(finished.status, 1) << finished.err;
  EXPECT_EQ(finished.err, "");
  const std::string reason = "answer: more than " + std::to_string(1000 + 4 * (words.size() - 1) * (words.size() - 1)) +
                             " lines for " + std::to_string(words.size() - 1) + " points";
  EXPECT_NE(std::regex_replace(finished.out, std::regex("\\s+"), " ").find("unreadable: " + reason), std::string::npos)
      << finished.out;
}

TEST(Verify, ReportsToProgramsAreBounded) {
  CITES("FC-CLAIM-03");
  std::string answers;
  for (const std::string& id : ids_of(generated({"--level", "2", "--cases", "1200"}))) {
    answers.append("refused ").append(id).append("\n");
  }
  const Scratch scratch;
  const std::string path = scratch.file("answers", answers);
  const json report = json::parse(flowcert({"verify", "--json"}, {path, ""}).out);
  EXPECT_EQ(report["refused"], 1200);
  EXPECT_EQ(report["failures"].size(), 1000U);
  EXPECT_EQ(report["failures"][999]["number"], 999);
  EXPECT_TRUE(report["failures"][999]["reason"].is_null());
  EXPECT_EQ(json::parse(flowcert({"verify", "--json", "--most", "1100"}, {path, ""}).out)["failures"].size(), 1100U);
}

TEST(Verify, AnswersMayComeInAnyOrder) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--cases", "40"}, {"csv", "drop", "7", "refuse", "3"});
  std::vector<std::string> answers;
  for (const std::string& line : lines_of(pipe.answers())) {
    if (line.starts_with("# here")) answers.emplace_back();
    if (line.starts_with("refused")) answers.emplace_back();
    answers.back() += line + "\r\n";
  }
  ASSERT_EQ(answers.size(), 40U);
  std::reverse(answers.begin(), answers.end());
  std::string reversed;
  for (const std::string& answer : answers) reversed += answer;
  EXPECT_EQ(pipe.verify_text(reversed, pipe.run()).out, pipe.verify().out);
}

TEST(Verify, NamesTheUnanswered) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--cases", "40"}, {"exchange", "skip", "0", "skip", "1", "skip", "2", "skip", "39"});
  const json report = pipe.as_json();
  EXPECT_EQ(report["verdict"], "fails");
  EXPECT_EQ(report["unanswered"], 4);
  EXPECT_EQ(report["unanswered_numbers"], json({{0, 2}, {39, 39}}));
  EXPECT_EQ(report["failures"], json::array());
}

TEST(Verify, OnlyOneCase) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--seed", "7", "--case", "12"});
  EXPECT_EQ(pipe.as_json()["unanswered_numbers"], json({{0, 11}, {13, 499}}));
  const json report = pipe.as_json({"--case", "12"});
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["cases"], 1);
  EXPECT_EQ(report["families"].size(), 1U);
  const Finished other = pipe.verify({"--case", "13"});
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(contains(other.err, "standard input:3: not the case that --case names: '")) << other.err;
}

// ---- Which cases were asked ----

// Without the run, nobody but the program under test says which cases were asked.
TEST(Verify, WithoutTheRunItSaysNoMoreThanRight) {
  CITES("FC-CLAIM-22");
  const Pipe pipe({"--cases", "30"});
  const Finished text = pipe.verify_text(pipe.answers());
  EXPECT_EQ(text.status, 0);
  EXPECT_TRUE(contains(text.out, "\nright in what came: 30 cases; truth by")) << text.out;
  const std::string words = std::regex_replace(text.out, std::regex("\\s+"), " ");
  EXPECT_TRUE(contains(words, "verify --level 1 --seed 1 --cases 30 says")) << text.out;
  // The column of outcomes has that name, and nothing else.
  EXPECT_FALSE(contains(text.out, "\nconforms")) << text.out;
  const Finished finished = pipe.verify_text(pipe.answers(), {"--json"});
  EXPECT_EQ(finished.status, 0);
  const json report = json::parse(finished.out);
  EXPECT_EQ(report["verdict"], "right in what came");
  EXPECT_TRUE(report["profile"]["statement"].is_null());
  const std::string junit = pipe.scratch().path("report.xml");
  EXPECT_EQ(pipe.verify_text(pipe.answers(), {"--junit", junit}).status, 0);
  EXPECT_FALSE(contains(content_of(junit), "conforms"));
  // What is wrong is wrong.
  const Pipe wrong({"--cases", "30"}, {"csv", "drop", "3"});
  EXPECT_EQ(wrong.verify_text(wrong.answers()).status, 1);
}

TEST(Verify, AnswersToARunOfTheirOwnAreRefused) {
  CITES("FC-CLAIM-22");
  const Pipe own({"--cases", "1", "--seed", "99"});
  const Finished finished = own.verify_text(own.answers(), {"--level", "1", "--seed", "7"});
  EXPECT_EQ(finished.status, 2);
  EXPECT_TRUE(contains(finished.err, "a case of another run: '")) << finished.err;
}

TEST(Verify, WhatIsMissingOfARunThatIsToldIsMissing) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--cases", "20"}, {"csv", "skip", "3"});
  const Scratch scratch;
  const std::string asked = scratch.file("cases", pipe.cases());
  for (const Words& told : {pipe.run(), Words{"--asked", asked}}) {
    const Finished nothing = pipe.verify_text("", joined(told, {"--json"}));
    EXPECT_EQ(nothing.status, 1) << nothing.err;
    EXPECT_EQ(json::parse(nothing.out)["unanswered"], 20);
    const Finished some = pipe.verify_text(pipe.answers(), joined(told, {"--json"}));
    EXPECT_EQ(some.status, 1);
    EXPECT_EQ(json::parse(some.out)["unanswered_numbers"], json({{3, 3}}));
  }
}

TEST(Verify, AFileOfGenerateSaysWhatIsAsked) {
  CITES("FC-CLAIM-03");
  const Pipe all({"--cases", "20"});
  const std::vector<std::string> cases = cases_of(all.cases());
  const Scratch scratch;
  // The file has three cases, in any order; one gets no answer.
  const std::string asked = scratch.file("cases", cases.at(7) + cases.at(2) + cases.at(11));
  const Finished refused = all.verify_text(all.answers(), {"--asked", asked});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.err, "not among the cases that are asked: '")) << refused.err;
  std::string answers;
  for (const std::size_t number : {std::size_t{2}, std::size_t{7}}) {
    answers += Pipe({"--cases", "20", "--case", std::to_string(number)}).answers();
  }
  const json report = json::parse(all.verify_text(answers, {"--json", "--asked", asked}).out);
  EXPECT_EQ(report["cases"], 3);
  EXPECT_EQ(report["conforms"], 2);
  EXPECT_EQ(report["unanswered_numbers"], json({{11, 11}}));
  const Finished none = all.verify_text(answers, {"--asked", scratch.file("no_cases", "1 2 3\n")});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(contains(none.err, "no line 'case ID N'")) << none.err;
  EXPECT_EQ(all.verify_text(answers, {"--asked", asked, "--seed", "2"}).status, 2);
}

TEST(Verify, AnAnswerWithoutLinesClaimsNothing) {
  CITES("FC-CLAIM-03", "FC-IN-04");
  const Words run = {"--family", "few-points", "--cases", "30"};
  std::string answers;
  std::size_t empty = 0;
  for (const std::string& one : cases_of(generated(run))) {
    answers += "answer " + id_of(one) + "\nend\n";
    empty += lines_of(one).size() == 1 ? 1 : 0;
  }
  EXPECT_GT(empty, 0U);
  EXPECT_LT(empty, 30U);
  const Scratch scratch;
  const Finished finished = flowcert({"verify", "--json"}, {scratch.file("answers", answers), ""});
  const json report = json::parse(finished.out);
  EXPECT_EQ(report["conforms"], empty);
  EXPECT_EQ(report["fails"], 30 - empty);
}

// `check` would refuse one of these claims only because of the points.
TEST(Verify, AnUnreadableAnswerIsOneFailure) {
  CITES("FC-CLAIM-01");
  const Pipe pipe({"--cases", "20"}, {"csv", "skip", "5"});
  const std::string id = ids_of(pipe.cases())[5];
  for (const char* claim : {"0,0,0,0,0,99", "3,nan,0,0", "{\"index\":3}", "inf 2", "\x1f\x8b\x08", "<"}) {
    SCOPED_TRACE(claim);
    const std::string answer = "answer " + id + "\n# mine\n" + claim + "\nend\n";
    const Finished finished = pipe.verify_text(answer + pipe.answers(), {"--json"});
    EXPECT_EQ(finished.status, 1) << finished.err;
    const json report = json::parse(finished.out);
    EXPECT_EQ(report["conforms"], 19);
    EXPECT_EQ(report["unreadable"], 1);
    EXPECT_EQ(report["failures"][0]["id"], id);
    EXPECT_TRUE(report["failures"][0]["reason"].get<std::string>().starts_with("answer:"));
  }
}

TEST(Verify, RefusesWhatIsNoStreamOfAnswers) {
  CITES("FC-IN-05");
  const Words run = {"--cases", "20"};
  const auto refuses = [](const Pipe& pipe, const std::string& answers, const std::string& what) {
    for (const Words& options : {Words{}, {"--json"}}) {
      const Finished finished = pipe.verify_text(answers, options);
      EXPECT_EQ(finished.status, 2);
      EXPECT_EQ(finished.out, "");
      EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
      EXPECT_TRUE(finished.err.starts_with("flowcert: standard input:" + what)) << finished.err;
    }
  };
  const Pipe right(run);
  const Words ids = ids_of(right.cases());
  const std::string first = "answer " + ids[0] + "\nend\n";
  refuses(right, "", " no answers\n");
  refuses(right, "# nothing\n\n", " no answers\n");
  refuses(right, first + first, "3: a second answer to the case '" + ids[0] + "'");
  refuses(right, first + "refused " + ids[0] + "\n", "3: a second answer to the case '" + ids[0] + "'");
  refuses(right, first + "\nhello\n", "4: neither 'answer ID' nor 'refused ID': 'hello'");
  refuses(right, first + "end\n", "3: neither 'answer ID' nor 'refused ID': 'end'");
  refuses(right, "answer\nend\n", "1: no id of a case after 'answer'");
  refuses(right, "answer " + ids[0] + " 5\nend\n", "1: more than an id after 'answer': '5'");
  refuses(right, "answ", " no answers\n");
  refuses(right, first + "answer 1\n1,2,3,4\n", "3: no case is called '1'");
  refuses(right, "answer " + ids[1] + "\n" + first, "2: 'answer' before the 'end' of the answer of line 1");
  // These ids are damaged, of other runs, out of range, or absurd.
  for (const std::string& id :
       {std::string("1"), std::string("::/:"), '0' + ids[0], ids[0] + '0', ids[0] + ":lattice-2",
        std::string("1:1:20/20:0000"), std::string("1:1:0/99999999999:0000"), std::string("4:1:0/20:0000"),
        std::string("1:1:0/20:0000:no-family"), std::string("1:1:-1/20:0000")}) {
    std::string answers = first;
    answers.append("answer ").append(id).append("\nend\n");
    std::string reason = "3: no case is called '";
    reason.append(id).append("'");
    refuses(right, answers, reason);
  }
  const std::string other = ids_of(generated({"--cases", "20", "--seed", "2"}))[1];
  refuses(right, first + "answer " + other + "\nend\n", "3: a case of another run: '");
  // Here a program answers like that.
  refuses(Pipe(run, {"csv", "twice", "5"}), Pipe(run, {"csv", "twice", "5"}).answers(), "");
  for (const char* fault : {"other-id", "stray"}) {
    const Pipe pipe(run, {"csv", fault, "5"});
    refuses(pipe, pipe.answers(), "");
  }
}

TEST(Verify, WritesAReportForCiSystems) {
  CITES("FC-CLAIM-03");
  const Pipe pipe({"--cases", "80"}, {"csv", "drop", "3", "refuse", "40", "skip", "50"});
  const std::string path = pipe.scratch().path("report.xml");
  EXPECT_EQ(pipe.verify({"--junit", path}).status, 1);
  const std::string report = content_of(path);
  struct Count {
    std::size_t cases = 0, failures = 0;
  } count;
  const XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &count);
  XML_SetStartElementHandler(parser, [](void* data, const XML_Char* name, const XML_Char** /*attributes*/) {
    auto* const counted = static_cast<Count*>(data);
    counted->cases += std::string(name) == "testcase" ? 1 : 0;
    counted->failures += std::string(name) == "failure" ? 1 : 0;
  });
  EXPECT_EQ(XML_Parse(parser, report.data(), static_cast<int>(report.size()), 1), XML_STATUS_OK) << report;
  XML_ParserFree(parser);
  EXPECT_EQ(count.cases, 36U);
  EXPECT_EQ(count.failures, 3U);
  EXPECT_TRUE(contains(report, "tests=\"36\" failures=\"3\" errors=\"0\" skipped=\"0\"")) << report;
  EXPECT_TRUE(contains(report, "refused: too hard &lt;for me&gt;"));
  EXPECT_TRUE(contains(report, "1 unanswered"));
}

TEST(Verify, KeepsFailingCasesForCheck) {
  CITES("FC-CLAIM-03", "FC-CLAIM-01");
  const Pipe pipe({"--seed", "7", "--cases", "80"},
                  {"csv", "drop", "3", "unreadable", "12", "refuse", "40", "none", "75"});
  const std::string folder = pipe.scratch().path("kept/here");
  const Finished finished = pipe.verify({"--keep", folder});
  EXPECT_EQ(finished.status, 1) << finished.err;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  EXPECT_EQ(names, (std::set<std::string>{"case-1-7-3.xyz", "case-1-7-3.claim", "case-1-7-12.xyz", "case-1-7-12.claim",
                                          "case-1-7-40.xyz", "case-1-7-75.xyz", "case-1-7-75.claim"}));
  for (const auto& [number, status] : {std::pair("3", 1), {"12", 2}, {"75", 1}}) {
    std::string points = folder;
    points.append("/case-1-7-").append(number).append(".xyz");
    const std::string claim = points.substr(0, points.size() - 3) + "claim";
    std::string command = "flowcert check ";
    command.append(points).append(" ").append(claim).append("\n");
    EXPECT_TRUE(contains(finished.out, command)) << finished.out;
    EXPECT_EQ(flowcert({"check", points, claim}).status, status) << number;
  }
  const std::string file = pipe.scratch().file("file", "");
  EXPECT_EQ(pipe.verify({"--keep", file}).status, 2);
}

TEST(Verify, ToleranceIsOfTheUser) {
  CITES("FC-CLAIM-05");
  const Words run = {"--family", "general-position", "--cases", "20"};
  const json exact = Pipe(run, {"decimals"}).as_json();
  EXPECT_EQ(exact["verdict"], "conforms");
  EXPECT_EQ(exact["tolerance"], 1e-9);
  const Pipe rounded(run, {"rounded"});
  EXPECT_EQ(rounded.as_json()["fails"], 20);
  EXPECT_EQ(rounded.as_json({"--tolerance", "1e-5"})["verdict"], "conforms");
  EXPECT_EQ(rounded.verify({"--tolerance", "1"}).status, 2);
}

TEST(Verify, StatesDecimalsWithASmallToleranceAlone) {
  CITES("FC-CLAIM-23", "FC-CLAIM-22");
  const Words run = {"--family", "general-position", "--cases", "20"};
  const Pipe decimals(run, {"decimals"});
  EXPECT_EQ(decimals.as_json({"--tolerance", "1e-6"})["profile"]["statement"],
            "conforms to 1.2, points, approximate within 1e-06 (20 drawn inputs)");
  const std::string path = decimals.scratch().path("report.xml");
  const Finished text = decimals.verify({"--tolerance", "1e-5", "--junit", path});
  EXPECT_EQ(text.status, 0);
  EXPECT_TRUE(
      contains(text.out, "\nno statement: the tolerance 1e-05 is above 1e-06 (FC-CLAIM-23)\nconforms: 20 of 20"))
      << text.out;
  EXPECT_FALSE(contains(content_of(path), "<property"));
  const json none = decimals.as_json({"--tolerance", "1e-5"});
  EXPECT_TRUE(none["profile"]["statement"].is_null()) << none["profile"];
  EXPECT_EQ(none["verdict"], "conforms");
  EXPECT_EQ(Pipe(run, {"csv"}).as_json({"--tolerance", "1e-5"})["profile"]["statement"],
            "conforms to 1.2, points, exact (20 drawn inputs)");
}

// ---- The README ----

std::string readme_block(const std::string& name) {
  const Words lines = lines_of(content_of(FLOWCERT_FUZZ_README));
  auto line = std::find(lines.begin(), lines.end(), "<!-- example: " + name + " -->");
  EXPECT_GT(lines.end() - line, 3) << name;
  std::string block;
  if (lines.end() - line > 3) {
    for (line += 2; line != lines.end() && *line != "```"; ++line) block += *line + '\n';
  }
  return block;
}

TEST(Readme, TheProgramInTheMiddle) {
  CITES("FC-CLAIM-03");
  const Scratch scratch;
  std::filesystem::create_directory(scratch.path("build"));
  std::filesystem::create_symlink(FLOWCERT_PROGRAM, scratch.path("build/flowcert"));
  (void)scratch.file("middle.sh", readme_block("middle"));
  const Words lines = lines_of(readme_block("pipe"));
  ASSERT_GT(lines.size(), 1U);
  ASSERT_TRUE(lines.front().starts_with("$ ")) << lines.front();
  const std::string command = "cd \"$0\" && " + lines.front().substr(2);
  const Finished finished = RunningProgram({"/bin/bash", "-c", command, scratch.path("")}).finish();
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_EQ(finished.err, "");
  const Words printed = lines_of(finished.out);
  ASSERT_GT(printed.size(), 38U) << finished.out;
  // The README shows the head of the table and what follows "...".
  const auto gap = std::find(lines.begin(), lines.end(), "...");
  ASSERT_NE(gap, lines.end());
  EXPECT_EQ(Words(lines.begin() + 1, gap), Words(printed.begin(), printed.begin() + (gap - lines.begin() - 1)));
  EXPECT_EQ(Words(gap + 1, lines.end()), Words(printed.end() - (lines.end() - gap - 1), printed.end()));
}

}  // namespace
}  // namespace flowcert::conformance::pipe_command_test
