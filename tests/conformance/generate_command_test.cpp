// `flowcert generate` as a user calls it (src/cli/manual/cases.md): what it prints, that it is the
// same every time, and how it ends. What becomes of the cases is in pipe_command_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>

#include "tests/cites.h"
#include "tests/conformance/case_texts.h"

namespace flowcert::conformance::generate_command_test {
namespace {

// A family's line begins with two blanks, and what goes on with more.
std::size_t lines_of_families(const std::string& list) {
  const Words lines = lines_of(list);
  return static_cast<std::size_t>(
      std::ranges::count_if(lines, [](const std::string& line) { return !line.starts_with("   "); }));
}

TEST(Generate, SaysWhatItIsAndAsksAllFamiliesInTurn) {
  CITES("FC-IN-03", "FC-IN-04");
  const std::string stream = generated();
  EXPECT_TRUE(stream.starts_with("# flowcert generate: 500 cases, level 1, seed 1.")) << stream.substr(0, 200);
  const std::vector<std::string> cases = cases_of(stream);
  ASSERT_EQ(cases.size(), 500U);
  std::set<std::string> ids;
  std::size_t small = 0, empty = 0;
  for (const std::string& one : cases) {
    const Words lines = lines_of(one);
    std::istringstream head(lines.front());
    std::string word, id, more;
    std::size_t rows = 0;
    ASSERT_TRUE(head >> word >> id >> rows) << lines.front();
    EXPECT_FALSE(head >> more) << lines.front();
    EXPECT_EQ(rows, lines.size() - 1);
    EXPECT_LE(rows, 12U);
    small += rows <= 8 ? 1 : 0;
    empty += rows == 0 ? 1 : 0;
    ids.insert(id);
  }
  EXPECT_EQ(ids.size(), 500U);
  EXPECT_GT(small, 450U);
  EXPECT_GT(empty, 0U) << "no points are an input too";
}

TEST(Generate, IsAFunctionOfItsOptions) {
  CITES("FC-IN-02");
  EXPECT_EQ(generated({"--seed", "7"}), generated({"--seed", "7"}));
  EXPECT_EQ(generated(), generated({"--level", "1", "--seed", "1"}));
  const auto points_of = [](const Words& options) {
    std::vector<std::string> cases = cases_of(generated(options));
    for (std::string& one : cases) one.erase(0, one.find('\n'));
    return cases;
  };
  const auto first = points_of({"--cases", "72"});
  EXPECT_NE(first, points_of({"--cases", "72", "--seed", "2"}));
  EXPECT_NE(first, points_of({"--cases", "72", "--level", "2"}));
  // The number of cases does not matter.
  const auto longer = points_of({"--cases", "100"});
  EXPECT_EQ(first, std::vector(longer.begin(), longer.begin() + 72));
}

TEST(Generate, PointsAloneAreAPointFile) {
  CITES("FC-IN-02");
  for (const Words& form : {Words{}, Words{"--hex"}}) {
    for (const std::string number : {"0", "3", "17"}) {
      Words options = {"--seed", "7", "--case", number};
      options.insert(options.end(), form.begin(), form.end());
      const std::string one = cases_of(generated(options)).at(0);
      options.emplace_back("--xyz");
      EXPECT_EQ(generated(options), one.substr(one.find('\n') + 1));
    }
  }
  const Scratch scratch;
  const std::string points = scratch.file("a.xyz", generated({"--case", "3", "--xyz"}));
  const Finished piped = flowcert({"compute", "-"}, {.standard_input = points, .standard_output = ""});
  EXPECT_EQ(piped.status, 0) << piped.err;
  const Finished all = flowcert({"generate", "--xyz"});
  EXPECT_EQ(all.status, 2);
  EXPECT_EQ(all.err, "flowcert: --xyz requires --case (see flowcert generate --help)\n");
}

// Every number of families that is written is the number that there is.
TEST(Generate, FamiliesAreCountedAlikeEverywhere) {
  const std::size_t all = lines_of_families(flowcert({"fuzz", "--families", "list"}).out);
  const std::string complaint = flowcert({"generate", "--family", "none"}).err;
  const std::string names = complaint.substr(complaint.find("there are: "));
  const auto drawn = static_cast<std::size_t>(std::ranges::count(names, ',')) + 1;
  const std::string of_all = std::to_string(drawn) + " of the " + std::to_string(all) + " families";
  std::size_t mentions = 0;
  for (const std::string& path :
       {FLOWCERT_SPEC_FOLDER + std::string("/../README.md"), std::string(FLOWCERT_FUZZ_README),
        FLOWCERT_SPEC_FOLDER + std::string("/../src/cli/manual/cases.md")}) {
    const std::string text = content_of(path);
    const std::regex numbered("([0-9]+ of the )?([0-9]+) families");
    for (std::sregex_iterator found(text.begin(), text.end(), numbered); found != std::sregex_iterator(); ++found) {
      EXPECT_EQ((*found)[2], std::to_string(all)) << path << ": " << found->str();
      EXPECT_TRUE(!(*found)[1].matched || found->str() == of_all) << path << ": " << found->str();
      ++mentions;
    }
  }
  EXPECT_EQ(mentions, 4U);
  const std::string help = flowcert({"generate", "--help"}).out;
  EXPECT_NE(std::regex_replace(help, std::regex("\\s+"), " ").find(of_all), std::string::npos) << help;
}

TEST(Generate, OnlyIsTheVeryCase) {
  CITES("FC-IN-03");
  const Words run = {"--seed", "7", "--family", "lattice-2", "--family", "collinear", "--cases", "20"};
  const std::vector<std::string> cases = cases_of(generated(run));
  ASSERT_EQ(cases.size(), 20U);
  for (const std::size_t number : {std::size_t{0}, std::size_t{13}, std::size_t{19}}) {
    const auto alone = cases_of(generated(joined(run, {"--case", std::to_string(number)})));
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_EQ(alone.front(), cases[number]);
  }
}

// What is left out has no line, and what is left keeps its number and its points.
TEST(Generate, LeavesOutCasesOfMorePoints) {
  CITES("FC-IN-03");
  const Words run = {"--seed", "7", "--cases", "120"}, few = joined(run, {"--most-points", "5"});
  const std::string stream = generated(few);
  EXPECT_TRUE(
      stream.starts_with("# flowcert generate: 120 cases, level 1, seed 7, without those of more than 5 points.\n"))
      << stream.substr(0, 200);
  const auto points_of = [](const std::string& one) { return one.substr(one.find('\n')); };
  const std::vector<std::string> all = cases_of(generated(run)), some = cases_of(stream);
  std::size_t next = 0;
  for (std::size_t number = 0; number < all.size(); ++number) {
    if (lines_of(all[number]).size() > 6) continue;
    ASSERT_LT(next, some.size());
    EXPECT_TRUE(id_of(some[next]).starts_with("1:7:" + std::to_string(number) + "/120/5:")) << id_of(some[next]);
    EXPECT_EQ(points_of(some[next++]), points_of(all[number]));
  }
  EXPECT_EQ(next, some.size());
  EXPECT_GT(next, 20U);
  EXPECT_LT(next, 100U);
  const std::string number = id_of(some[1]).substr(4, id_of(some[1]).find('/') - 4);
  EXPECT_EQ(cases_of(generated(joined(few, {"--case", number}))).at(0), some[1]);
}

TEST(Generate, ACaseWithoutPointsIsAPointFile) {
  CITES("FC-IN-04");
  const auto& cases = cases_of(generated());
  const auto empty = std::ranges::find_if(cases, [](const std::string& one) { return lines_of(one).size() == 1; });
  ASSERT_NE(empty, cases.end());
  EXPECT_EQ(generated({"--case", std::to_string(empty - cases.begin()), "--xyz"}), "# no points\n");
}

TEST(Generate, PrintsExactNumbers) {
  CITES("FC-IN-02");
  const Words run = {"--level", "3", "--cases", "200", "--seed", "3"};
  const auto decimal = cases_of(generated(run));
  const auto hexadecimal = cases_of(generated(joined(run, {"--hex"})));
  ASSERT_EQ(decimal.size(), hexadecimal.size());
  std::size_t most = 0;
  for (std::size_t k = 0; k < decimal.size(); ++k) {
    const Words rows = lines_of(decimal[k]);
    const Words hex_rows = lines_of(hexadecimal[k]);
    ASSERT_EQ(rows.size(), hex_rows.size());
    EXPECT_EQ(rows.front(), hex_rows.front());
    most = std::max(most, rows.size() - 1);
    for (std::size_t row = 1; row < rows.size(); ++row) {
      std::istringstream words(rows[row]), hex_words(hex_rows[row]);
      std::string word, hex_word;
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(words >> word && hex_words >> hex_word) << rows[row];
        EXPECT_TRUE(hex_word.starts_with("0x") || hex_word.starts_with("-0x")) << hex_word;
        EXPECT_EQ(std::strtod(word.c_str(), nullptr), std::strtod(hex_word.c_str(), nullptr)) << word;
      }
    }
  }
  EXPECT_GT(most, 100U) << "on level 3 some are large";
}

TEST(Generate, EndsSilentlyWithItsReader) {
  CITES("FC-IN-05");
  const Scratch scratch;
  const std::string script = "\"$0\" generate --level 3 2>\"$1\" | head -n 1; echo ${PIPESTATUS[0]}";
  for (const std::string& ignore : {std::string(), std::string("trap '' PIPE; ")}) {
    const Finished finished =
        RunningProgram({"/bin/bash", "-c", ignore + script, FLOWCERT_PROGRAM, scratch.path("err")}).finish();
    const Words lines = lines_of(finished.out);
    ASSERT_EQ(lines.size(), 2U) << finished.out;
    EXPECT_TRUE(lines[0].starts_with("# flowcert generate"));
    EXPECT_EQ(lines[1], "141") << "128 + SIGPIPE";
    EXPECT_EQ(content_of(scratch.path("err")), "");
  }
}

TEST(Generate, RefusesWhatItCannotUse) {
  CITES("FC-IN-05");
  const auto refuses = [](const Words& options, const std::string& what) {
    const Finished finished = flowcert(joined({"generate"}, options));
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_TRUE(contains(finished.err, what)) << finished.err;
  };
  refuses({"--level", "0"}, "--level");
  refuses({"--level", "4"}, "--level");
  refuses({"--seed", "-1"}, "--seed");
  refuses({"--seed", "18446744073709551616"}, "--seed");
  refuses({"--cases", "0"}, "--cases");
  refuses({"--cases", "10000001"}, "--cases");
  refuses({"--case", "500"}, "--case: the run has 500 cases, 0 to 499");
  refuses({"--cases", "1", "--case", "1"}, "--case: the run has 1 case, 0 to 0");
  refuses({"--most-points", "-1"}, "--most-points");
  refuses({"--most-points", "1", "--family", "lattice-4"}, "--most-points: every case has more points than that");
  const std::string first = cases_of(generated({"--family", "lattice-4"})).at(0);
  refuses({"--most-points", "1", "--family", "lattice-4", "--case", "0"},
          "--case: case 0 has " + std::to_string(lines_of(first).size() - 1) + " points, more than --most-points says");
  refuses({"--family", "lattice-22"}, "no family is called 'lattice-22'; there are: general-position,");
}

}  // namespace
}  // namespace flowcert::conformance::generate_command_test
