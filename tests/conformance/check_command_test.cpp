// `flowcert check` as a user calls it: verdicts and exit status, the report in words, in JSON and for CI
// systems (src/cli/manual/check.md), and what it refuses.
//
// Guarantees: claims that `compute -o` makes conform exactly, whatever it was told to write, by the fast
// implementation and by the oracle; so the two agree. One of the claims is a real output of another
// implementation (floating point), whose verdict was worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cites.h"
#include "tests/conformance/lattice_points.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::check_command_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

constexpr char kCube[] = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
constexpr char kFivePoints[] =
    "0.59376665 0.2281264 0.46036779\n0.37014753 0.98016997 0.69427669\n0.04229584 0.55486274 0.18034989\n"
    "0.43001661 0.41402878 0.3182466\n0.62040534 0.44004268 0.43736763\n";

// Five cospherical points, and six far from them: two right triangles, index 1 and 2 collide there.
constexpr char kCollisions[] =
    "-6 3 6\n6 -6 -3\n3 6 6\n6 3 -6\n6 -3 6\n100 3 7\n-90 40 11\n5 -110 31\n17 23 120\n-13 -29 -130\n"
    "60 70 -80\n";
constexpr char kCollisionsClaimed[] = R"(inf 3
2 3 4 | 7.02781928498733066 | inf 
7 | 0 | 1 7 | 7 8 
1 3 | 4.74341649025245449 | 2 3 4 | 1 3 4 
3 4 | 6.70820393249958169 | 1 3 4 | 3 4 5 
2 4 | 4.74341649025256995 | 2 3 4 | 0 2 4 | 4 7 8 | 4 5 8 
4 5 | 47.0983014555726953 | 3 4 5 | 4 5 8 
0 2 | 4.74341649025240031 | 0 2 4 
1 7 | 54.7106022631811797 | 4 7 8 
2 8 | 58.0538543078751914 | 4 7 8 | 4 5 8 
0 6 | 45.9619407771255908 | inf 
5 10 | 58.4337231399814172 | 3 5 10 
3 | 0 | 2 3 | 3 10 | 3 9 | 1 3 | 3 4 | 3 5 
9 | 0 | 3 9 | 9 10 
0 4 | 6.70820393249923264 | 0 2 4 
3 4 5 | 47.4558973594117006 | inf 
1 | 0 | 1 7 | 1 3 | 1 4 
3 5 10 | 63.228461278670359 | inf 
5 8 | 70.8131343749166291 | 4 5 8 
3 10 | 56.7472466292418503 | 3 5 10 | 3 9 10 
5 | 0 | 4 5 | 5 8 | 3 5 | 5 10 
8 | 0 | 2 8 | 5 8 | 7 8 
0 2 4 | 6.70820393249937119 | inf 
1 4 | 4.74341649025260903 | 4 7 8 | 1 3 4 | 2 3 4 
1 3 4 | 6.70820393249920688 | inf 
3 5 | 47.4473392299294403 | 3 4 5 | 3 5 10 
2 3 | 6.3639610306789276 | 2 3 4 
9 10 | 66.389005113798774 | 3 9 10 
7 8 | 80.2402642069428964 | 4 7 8 
0 | 0 | 0 2 | 0 6 | 0 4 
4 5 8 | 71.3102580144056191 | inf 
3 9 | 64.7321403940886029 | 3 9 10 
4 | 0 | 1 4 | 4 5 | 0 4 | 2 4 | 3 4 
10 | 0 | 3 10 | 9 10 | 5 10 
3 9 10 | 72.7434982539658961 | inf 
2 | 0 | 0 2 | 2 3 | 2 4 | 2 8 
4 7 8 | 80.2410468658716809 | inf 
6 | 0 | 0 6 
)";

// Points and a claim, in files.
class Checked {
 public:
  Checked(const std::string& points, const std::string& claim)
      : points_(scratch_.file("points.xyz", points)), claim_(scratch_.file("claim", claim)) {}
  // The claim that `compute -o` makes.
  Checked(const std::string& points, const Words& options) : Checked(points, std::string()) {
    Words words = {"compute", points_, "-o", claim_};
    words.insert(words.end(), options.begin(), options.end());
    const Finished computed = flowcert(words);
    EXPECT_EQ(computed.status, 0) << computed.err;
  }

  [[nodiscard]] Finished run(const Words& options = {}) const {
    Words words = {"check", points_, claim_};
    words.insert(words.end(), options.begin(), options.end());
    return flowcert(words);
  }
  // The report. The exit status is checked against the verdict, and the findings against the levels.
  [[nodiscard]] json as_json(Words options = {}) const {
    options.emplace_back("--json");
    const Finished finished = run(options);
    EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.err;
    json report = json::parse(finished.out, nullptr, false);
    EXPECT_TRUE(report.is_object()) << finished.out;
    if (!report.is_object()) return json::object();
    EXPECT_EQ(finished.status, report["verdict"] == "fails" ? 1 : 0);
    for (const auto& [level, of_level] : report["levels"].items()) {
      std::size_t wrong = 0, permitted = 0;
      for (const json& finding : report["findings"]) {
        if (finding["level"] == std::stoi(level)) ++(finding["permitted"] == true ? permitted : wrong);
      }
      EXPECT_EQ(of_level["wrong"], wrong);
      EXPECT_EQ(of_level["permitted"], permitted);
      EXPECT_EQ(of_level["conforms"] == false, wrong > 0);
    }
    return report;
  }
  [[nodiscard]] const Scratch& scratch() const { return scratch_; }
  [[nodiscard]] const std::string& points() const { return points_; }
  [[nodiscard]] const std::string& claim() const { return claim_; }

 private:
  Scratch scratch_;
  std::string points_;
  std::string claim_;
};

json levels(const json& report) {
  json result = json::array();
  for (const char* level : {"1", "2", "3", "4", "5"}) result.push_back(report["levels"][level]["conforms"]);
  return result;
}

TEST(CheckCommand, OurOwnClaimsConformExactly) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03", "FC-CLAIM-06", "FC-CLAIM-08");
  const std::vector<std::string> inputs = {kCube,
                                           kCollisions,
                                           "# nothing\n",
                                           "1 2 3\n",
                                           "0 0 0\n3 0 0\n0 4 0\n0 0 0\n",
                                           "5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n",
                                           lattice_points(1, 14, 3),
                                           lattice_points(2, 12, 1000003)};
  for (const std::string& points : inputs) {
    SCOPED_TRACE(points);
    for (const Words& options : {Words{}, {"--manifolds", "u2"}, {"--manifolds", "u2", "--polylines"}}) {
      const Checked own(points, options);
      for (const Words& by : {Words{}, {"--oracle"}}) {
        const json report = own.as_json(by);
        EXPECT_EQ(report["verdict"], "conforms");
        EXPECT_EQ(report["grade"], "exact");
        EXPECT_EQ(report["truth"], by.empty() ? "fast implementation" : "oracle");
        EXPECT_EQ(report["findings"], json::array());
        EXPECT_EQ(report["not_judged"], json::array());
        EXPECT_EQ(report["claimed"], report["critical"]);
        EXPECT_EQ(report["levels"]["5"]["conforms"].is_null(), options.size() < 3 || report["critical"][2] == 0);
      }
    }
  }
}

// A contact set tells its centre exactly; doubles are approximate.
TEST(CheckCommand, OurOwnClaimsConformWithoutExactCenters) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03");
  for (const std::string& points : {std::string(kCube), std::string(kCollisions), lattice_points(2, 12, 1000003)}) {
    for (const char* centers : {"double", "none"}) {
      const Checked own(points, Words{"--centers", centers, "--manifolds", "u2,s2", "--polylines", "--skeletons"});
      for (const Words& by : {Words{}, {"--oracle"}}) {
        const json report = own.as_json(by);
        EXPECT_EQ(report["verdict"], "conforms");
        EXPECT_EQ(report["grade"], centers == std::string("none") ? "exact" : "approximate");
        EXPECT_EQ(report["findings"], json::array());
        EXPECT_EQ(report["claimed"], report["critical"]);
      }
    }
  }
}

// Where a tie leaves a boundary open, the oracle takes any that may be.
TEST(CheckCommand, OurOwnStableSetsConformExactly) {
  CITES("FC-CLAIM-06", "FC-CLAIM-09", "FC-CLAIM-10");
  const std::string arch = "0 5 0\n-3 0 -2\n3 0 -2\n0 0 12\n0 -5 0\n";
  const std::string right_angle = "2 0 1\n0 0 0\n2 2 0\n1 2 0\n";
  // Each input says whether a tie leaves a boundary open.
  const std::vector<std::pair<std::string, bool>> inputs = {{arch, true},
                                                            {right_angle, true},
                                                            {kCube, false},
                                                            {"1 0 0\n-1 0 0\n0 1 0\n0 0 1\n", false},
                                                            {lattice_points(1, 14, 3), true},
                                                            {lattice_points(2, 12, 1000003), false}};
  for (const auto& [points, has_tie] : inputs) {
    SCOPED_TRACE(points);
    const Checked own(points, Words{"--manifolds", "u2,s2", "--skeletons", "--polylines"});
    for (const Words& by : {Words{}, {"--oracle"}}) {
      const json report = own.as_json(by);
      EXPECT_EQ(report["verdict"], "conforms");
      EXPECT_EQ(report["grade"], "exact");
      EXPECT_EQ(report["findings"], json::array());
      EXPECT_EQ(levels(report), json({true, true, true, true, true}));
      EXPECT_EQ(report["not_judged"].size(), has_tie && !by.empty() ? 1U : 0U) << report;
    }
  }
  // A boundary that is no cycle is wrong by either truth. So is another boundary where there is no tie.
  const Checked own(arch, Words{"--manifolds", "s2"});
  for (const auto& [right, wrong] : {std::pair{R"("boundary":[[0,1],[0,3],[1,4],[3,4]])", R"("boundary":[[0,1]])"},
                                     {R"("boundary":[[0,1],[0,2],[1,2]])", R"("boundary":[])"}}) {
    std::string claim = content_of(own.claim());
    const std::size_t place = claim.find(right);
    ASSERT_NE(place, std::string::npos) << claim;
    claim.replace(place, std::string(right).size(), wrong);
    for (const Words& by : {Words{}, {"--oracle"}}) {
      const json report = Checked(arch, claim).as_json(by);
      ASSERT_EQ(report["findings"].size(), 1U) << report;
      EXPECT_EQ(report["findings"][0]["reason"], "wrong-incidence");
      EXPECT_EQ(report["findings"][0]["clause"], "FC-CHAIN-01");
      EXPECT_EQ(levels(report)[3], false);
    }
  }
}

TEST(CheckCommand, OurOwnWholeComplexesConform) {
  CITES("FC-CLAIM-13", "FC-CLAIM-14", "FC-CLAIM-15");
  const std::string chain = "0 0 0\n1 0 0\n1 1 0\n1 1 1\n2 1 1\n";
  for (const std::string& points :
       {std::string(kCube), chain, std::string("0 0 0\n1 0 0\n"), lattice_points(1, 12, 3)}) {
    SCOPED_TRACE(points);
    for (const Words& more : {Words{"--volumes", "exact"}, {"--centers", "double"}, {"--centers", "none"}}) {
      Words wanted = {"--manifolds", "all"};
      wanted.insert(wanted.end(), more.begin(), more.end());
      const Checked own(points, wanted);
      for (const Words& by : {Words{}, {"--oracle"}}) {
        const json report = own.as_json(by);
        EXPECT_EQ(report["verdict"], "conforms");
        EXPECT_EQ(report["grade"], more[1] == "exact" ? "exact" : "approximate");
        EXPECT_EQ(report["findings"], json::array());
        EXPECT_EQ(levels(report)[4], true);
      }
    }
  }
  const Checked own(chain, Words{"--manifolds", "all", "--volumes", "exact"});
  for (const auto& [right, wrong, reason] :
       {std::array{R"("volume":"1/6")", R"("volume":"1/5")", "wrong-volume"},
        {R"("orbits":0,"families":1)", R"("orbits":1,"families":1)", "wrong-connections"},
        {R"("morse_smale":false)", R"("morse_smale":true)", "wrong-connections"},
        {R"(],null]},"connections")", R"(],[0,1]]},"connections")", "wrong-lambda-list"}}) {
    std::string claim = content_of(own.claim());
    const std::size_t place = claim.find(right);
    ASSERT_NE(place, std::string::npos) << right << " in\n" << claim;
    claim.replace(place, std::string(right).size(), wrong);
    for (const Words& by : {Words{}, {"--oracle"}}) {
      const Checked changed(chain, claim);
      const json report = changed.as_json(by);
      ASSERT_EQ(report["findings"].size(), 1U) << report;
      EXPECT_EQ(report["findings"][0]["reason"], reason);
      EXPECT_EQ(report["findings"][0]["level"], 5);
      EXPECT_EQ(changed.run(by).status, 1);
    }
  }
}

TEST(CheckCommand, JudgesAnotherImplementationWhereItIsDetermined) {
  CITES("FC-CLAIM-04", "FC-CLAIM-05", "FC-CLAIM-06");
  const Checked other(kCollisions, kCollisionsClaimed);
  for (const Words& by : {Words{}, {"--oracle"}}) {
    const json report = other.as_json(by);
    EXPECT_EQ(report["verdict"], "perturbed");
    EXPECT_EQ(report["not_decided"], json::array());
    EXPECT_EQ(report["grade"], "approximate");
    EXPECT_EQ(report["tolerance"], 1e-9);
    EXPECT_EQ(report["claim_format"], "giesen-kuehne");
    EXPECT_EQ(report["claimed"], json({11, 18, 8, 0}));
    EXPECT_EQ(report["critical"], json({11, 16, 6, 0}));
    EXPECT_EQ(levels(report), json({true, true, true, true, nullptr}));
    EXPECT_EQ(report["levels"]["2"]["permitted"], 4) << "two pairs";
  }
  const Finished text = other.run();
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(other.run({"--strict"}).status, 1);
  EXPECT_EQ(other.run({"--strict"}).out, text.out);
  const std::string said = unbroken(text.out);
  EXPECT_NE(said.find("claim:5: permitted, level 2: symbolic-perturbation [FC-CLAIM-04]: claimed index 1, "
                      "contact set 3 4; truth: a regular stationary point of kind 1-2, contact set 1 3 4\n"),
            std::string::npos)
      << text.out;
  EXPECT_NE(said.find("\nperturbed (approximate, tolerance 1e-09 of the radius; truth by "
                      "the fast implementation)\n"),
            std::string::npos)
      << text.out;
  EXPECT_EQ(other.as_json({"--tolerance", "1e-15"})["verdict"], "fails") << "radii are off by 1e-13";
}

// Only necessary conditions are known where the contact set is no simplex.
TEST(CheckCommand, TellsWhatIsNotDecided) {
  CITES("FC-CLAIM-04");
  const Checked square(std::string("1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n"),
                       std::string("0,1,0,0\n0,-1,0,0\n0,0,1,0\n0,0,-1,0\n1,,,,,0,2\n1,,,,,0,3\n1,,,,,1,2\n1,,,,,1,3\n"
                                   "1,,,,,0,1\n2,,,,,0,1,2\n2,,,,,0,1,3\n"));
  const json report = square.as_json();
  EXPECT_EQ(report["verdict"], "perturbed");
  EXPECT_EQ(report["levels"]["2"]["permitted"], 3);
  EXPECT_EQ(report["levels"]["2"]["not_decided"], 3);
  EXPECT_EQ(report["findings"][0]["decided"], false);
  ASSERT_EQ(report["not_decided"].size(), 1U);
  const Finished text = square.run();
  EXPECT_EQ(text.status, 0);
  const std::string said = unbroken(text.out);
  EXPECT_NE(said.find("claim:9: not decided, level 2: symbolic-perturbation [FC-CLAIM-04]: claimed index 1"),
            std::string::npos)
      << text.out;
  EXPECT_NE(said.find("\nnot decided: whether one perturbation makes all that is claimed"), std::string::npos);
  EXPECT_EQ(square.run({"--strict"}).status, 1);
}

TEST(CheckCommand, NamesWhatIsMissing) {
  CITES("FC-CLAIM-03", "FC-INV-01");
  const Checked missing(kFivePoints, std::string("inf 3\n0 | 0\n1 | 0\n2 | 0\n3 | 0\n4 | 0\n"));
  const Checked truth(kFivePoints, Words{});
  std::vector<std::vector<int>> expected;
  for (const std::string& line : lines_of(content_of(truth.claim()))) {
    const json record = json::parse(line);
    if (record.contains("kind") && record["index"] != 0) expected.push_back(record["contact"]);
  }
  const json report = missing.as_json({"--highest-level", "3"});
  EXPECT_EQ(levels(report), json({true, true, false, nullptr, nullptr}));
  std::vector<std::vector<int>> named;
  for (const json& finding : report["findings"]) {
    EXPECT_EQ(finding["level"], 3);
    EXPECT_TRUE(finding["line"].is_null());
    if (finding["reason"] == "missing") named.push_back(finding["contact"]);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(named.begin(), named.end());
  EXPECT_EQ(named, expected);
  const Finished text = missing.run({"--highest-level", "3", "--most", "1"});
  EXPECT_EQ(text.status, 1);
  EXPECT_NE(text.out.find("(of each level, 1 more at most are shown)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("\nfails ("), std::string::npos) << text.out;
}

// A program that lists saddles alone is right about them.
TEST(CheckCommand, JudgesSomeIndices) {
  CITES("FC-CLAIM-12");
  const Checked saddle(std::string("1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n"), std::string("2,0,0,0\n"));
  EXPECT_EQ(saddle.as_json()["verdict"], "fails");
  const json report = saddle.as_json({"--indices", "2,3"});
  EXPECT_EQ(report["verdict"], "conforms");
  EXPECT_EQ(report["indices"], json({2, 3}));
  EXPECT_EQ(report["not_judged"].size(), 3U) << report["not_judged"];
  EXPECT_EQ(saddle.as_json({"--indices", "1,2"})["verdict"], "fails");
  EXPECT_EQ(saddle.run({"--indices", "4"}).status, 2);
}

// A table of reasons comes first, and one finding of each reason is shown whatever --most says.
TEST(CheckCommand, SaysWhyFirst) {
  CITES("FC-CLAIM-02", "FC-CLAIM-03");
  const Checked square(std::string("1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n"),
                       std::string("0,1,0,0\n0,-1,0,0\n2,,,,,0,1,2\n1,,,,,1,2\n1,,,,,1,2\n"));
  const json reasons = square.as_json()["reasons"];
  ASSERT_EQ(reasons.size(), 3U) << reasons;
  EXPECT_EQ(reasons[0], json({{"reason", "missing"}, {"permitted", false}, {"findings", 5}, {"example", 5}}));
  EXPECT_EQ(reasons[1]["reason"], "claimed-twice");
  EXPECT_EQ(reasons[2], json({{"reason", "spanning-part"}, {"permitted", true}, {"findings", 1}, {"example", 0}}));
  const Finished text = square.run({"--most", "0"});
  EXPECT_TRUE(
      text.out.starts_with("  reason                    findings  smallest example\n"
                           "  missing        wrong             5  "))
      << text.out;
  for (const char* reason : {": missing [", ": claimed-twice [", ": spanning-part ["}) {
    EXPECT_NE(unbroken(text.out).find(reason), std::string::npos) << reason;
  }
}

// One thing is wrong in a record of our own. The finding names the line.
TEST(CheckCommand, SaysWhereAClaimIsWrong) {
  CITES("FC-CLAIM-05", "FC-OUT-01");
  const Checked own(kCube, Words{"--manifolds", "u2"});
  std::vector<std::string> lines = lines_of(content_of(own.claim()));
  const std::size_t at = lines.size() - 1;
  const std::size_t place = lines[at].find("\"3/4\"");
  ASSERT_NE(place, std::string::npos) << lines[at];
  lines[at].replace(place, 5, "\"5/4\"");
  std::string changed;
  for (const std::string& line : lines) changed += line + "\n";
  const Checked wrong(kCube, changed);
  const json report = wrong.as_json();
  ASSERT_EQ(report["findings"].size(), 1U) << report;
  EXPECT_EQ(report["findings"][0]["line"], lines.size());
  EXPECT_EQ(report["findings"][0]["reason"], "wrong-position");
  EXPECT_EQ(report["findings"][0]["clause"], "FC-OUT-01");
  EXPECT_EQ(report["findings"][0]["contact"], json({0, 1, 2, 3, 4, 5, 6, 7}));
  // The same claim is made of other points.
  const Checked other(lattice_points(3, 8, 100), content_of(own.claim()));
  const json of_other = other.as_json();
  EXPECT_EQ(of_other["levels"]["1"]["conforms"], false);
  EXPECT_EQ(of_other["findings"][0]["clause"], "FC-CLAIM-01");
}

TEST(CheckCommand, WritesAReportForCiSystems) {
  CITES("FC-CLAIM-03");
  const Checked missing(kFivePoints, std::string("inf 3\n0 | 0\n1 | 0\n2 | 0\n3 | 0\n4 | 0\n"));
  const std::string path = missing.scratch().path("report & more.xml");
  EXPECT_EQ(missing.run({"--junit", path}).status, 1);
  const std::string report = content_of(path);
  EXPECT_TRUE(report.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n")) << report;
  EXPECT_TRUE(report.ends_with("</testsuites>\n"));
  EXPECT_NE(report.find("tests=\"5\" failures=\"2\" errors=\"0\" skipped=\"1\""), std::string::npos) << report;
  std::size_t cases = 0;
  for (std::size_t at = 0; (at = report.find("<testcase ", at)) != std::string::npos; ++at) ++cases;
  EXPECT_EQ(cases, 5U);
  EXPECT_NE(report.find("missing [FC-CLAIM-03]"), std::string::npos);
  EXPECT_EQ(report.find("< "), std::string::npos);
  EXPECT_NE(report.find("<property name=\"profile\" value=\"does not conform to 1.2\"/>"), std::string::npos) << report;

  // A permitted variation is told, and is no failure.
  const Checked varied(kCollisions, kCollisionsClaimed);
  EXPECT_EQ(varied.run({"--junit", path}).status, 0);
  const std::string permitted = content_of(path);
  EXPECT_NE(permitted.find("failures=\"0\""), std::string::npos) << permitted;
  EXPECT_NE(permitted.find("<system-out>"), std::string::npos);
  EXPECT_NE(permitted.find("permitted, level 2: symbolic-perturbation [FC-CLAIM-04]"), std::string::npos);

  const Checked right(kCube, Words{});
  EXPECT_EQ(right.run({"--junit", path, "--json"}).status, 0);
  EXPECT_NE(content_of(path).find("failures=\"0\""), std::string::npos);
  EXPECT_NE(content_of(path).find("value=\"conforms to 1.2, points, exact\""), std::string::npos) << content_of(path);
}

TEST(CheckCommand, SaysInWhichProfileAClaimConforms) {
  CITES("FC-CLAIM-22");
  const Checked limits(kCube, Words{"--manifolds", "u2"});
  const auto lines = lines_of(limits.run().out);
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[lines.size() - 2], "conforms to 1.2, points + U2, exact");
  EXPECT_EQ(limits.as_json()["profile"], json::parse(R"({"specification": "1.2", "parts": ["points", "U2"],
      "grade": "exact", "statement": "conforms to 1.2, points + U2, exact"})"));
  const json shallow = limits.as_json({"--highest-level", "2"})["profile"];
  EXPECT_EQ(shallow["parts"], json::array());
  EXPECT_TRUE(shallow["statement"].is_null());
  const Checked wrong(kCube, std::string("index,x,y,z\n0,0,0,0\n"));
  EXPECT_EQ(wrong.as_json()["profile"]["statement"], "does not conform to 1.2");
  EXPECT_EQ(wrong.as_json()["profile"]["grade"], "approximate");
}

// With decimals a statement names the tolerance, and there is none for a large one.
TEST(CheckCommand, StatesDecimalsWithASmallToleranceAlone) {
  CITES("FC-CLAIM-23", "FC-CLAIM-22");
  const std::string two = "0 0 0\n2 0 0\n", near = "0,0,0,0\n0,2,0,0\n1,1.0000009,0,0\n";
  const Checked decimals(two, near), exact(two, Words{}), pairs(two, std::string("0 0 inf\n0 0 1.0000009\n"));
  EXPECT_EQ(decimals.as_json()["verdict"], "fails") << "1e-9";
  const auto last_two = [](const Finished& finished) {
    const auto lines = lines_of(unbroken(finished.out));
    return lines.size() < 2 ? Words{} : Words(lines.end() - 2, lines.end());
  };
  const std::string path = decimals.scratch().path("report.xml");
  const auto text = [&](const Checked& checked, const std::string& tolerance) {
    return last_two(checked.run({"--tolerance", tolerance, "--junit", path})).at(0);
  };
  const auto statement = [](const Checked& checked, const std::string& tolerance) {
    const json report = checked.as_json({"--tolerance", tolerance});
    EXPECT_EQ(report["verdict"], "conforms");
    return report["profile"]["statement"];
  };
  const std::string within = "conforms to 1.2, points, approximate within 1e-06";
  EXPECT_EQ(text(decimals, "1e-6"), within);
  EXPECT_NE(content_of(path).find("<property name=\"profile\" value=\"" + within + "\"/>"), std::string::npos);
  EXPECT_EQ(statement(decimals, "0.000001"), within);
  for (const auto& [tolerance, shown] :
       {std::pair("1.0000000000000002e-6", "1.0000000000000002e-06"), std::pair("0.001", "0.001")}) {
    const std::string none = "no statement: the tolerance " + std::string(shown) + " is above 1e-06 (FC-CLAIM-23)";
    EXPECT_EQ(text(decimals, tolerance), none);
    EXPECT_EQ(content_of(path).find("<property"), std::string::npos) << tolerance;
    EXPECT_TRUE(statement(decimals, tolerance).is_null()) << tolerance;
    EXPECT_EQ(text(pairs, tolerance), none);
    EXPECT_TRUE(statement(pairs, tolerance).is_null()) << tolerance;
  }
  EXPECT_EQ(text(pairs, "1e-6"), "conforms to 1.2, persistence, approximate within 1e-06");
  EXPECT_EQ(text(exact, "0.001"), "conforms to 1.2, points, exact");
  EXPECT_EQ(statement(exact, "0.001"), "conforms to 1.2, points, exact");
  const Checked wrong(two, std::string("0,0,0,0\n0,2,0,0\n1,1.5,0,0\n"));
  EXPECT_EQ(text(wrong, "0.001"), "does not conform to 1.2");
}

TEST(CheckCommand, RefusesWhatItCannotUse) {
  CITES("FC-IN-05", "FC-CLAIM-01", "FC-FILE-47");
  const Checked own(kCube, Words{});
  const auto refuses = [](const Words& words, const std::string& what) {
    const Finished finished = flowcert(words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(lines_of(finished.err).size(), 1U) << finished.err;
    EXPECT_NE(finished.err.find(what), std::string::npos) << finished.err;
  };
  const std::string none = own.scratch().path("none");
  refuses({"check", own.points(), none}, none);
  refuses({"check", none, own.claim()}, none);
  refuses({"check", own.points()}, "CLAIM");
  refuses({"check", "-", "-"}, "standard input");
  refuses({"check", own.points(), own.scratch().file("cut", "inf 3\n0 1 |")}, "cut:2");
  refuses({"check", own.points(), own.scratch().file("row", "0,0,0,0,0,0\n1,.5,0,0,.25,0,8\n")},
          "row:2: there is no point 8; the ids are 0 to 7");
  refuses({"check", own.points(), own.scratch().file("sample", "inf 3\n0 | 0 | 0 1 | 0 9\n")},
          "sample:2: there is no point 9");
  refuses({"check", own.points(), own.scratch().file("index", "4,0,0,0\n")}, "index:1: not an index, 0 to 3");
  const std::string row = "0,0,0,0\n", mark = "\xef\xbb\xbf";
  EXPECT_NE(flowcert({"check", own.points(), own.scratch().file("marked", mark + row)}).status, 2);
  refuses({"check", own.points(), own.scratch().file("marks", mark + mark + row)}, "marks:1");
  refuses({"check", own.points(), own.claim(), "--tolerance", "1"}, "--tolerance");
  refuses({"check", own.points(), own.claim(), "--tolerance", "nan"}, "--tolerance");
  refuses({"check", own.points(), own.claim(), "--highest-level", "6"}, "--highest-level");
  refuses({"check", own.points(), own.claim(), "--junit", none + "/report.xml"}, none);
  const Checked large(lattice_points(4, 101, 50), Words{});
  refuses({"check", large.points(), large.claim(), "--oracle"}, "--oracle: 101 points");
  EXPECT_EQ(large.run().status, 0);
}

// Below the example of a reason stand a sentence, the atoms of a molecule, and a command that runs.
TEST(CheckCommand, TellsReasonsInPlainWords) {
  CITES("FC-CLAIM-03");
  const Scratch scratch;
  const std::string molecule = scratch.file("it's a molecule.xyz", "3\nof three atoms\nC1 0 0 0\nN2 6 0 0\nO3 2 4 0\n");
  const std::string claim =
      scratch.file("claim.csv", "index,x,y,z\n0,0,0,0\n0,6,0,0\n0,2,4,0\n1,3,0,0\n1,1,2,0\n1,4,2,0\n");
  const Finished done = flowcert({"check", molecule, claim});
  EXPECT_EQ(done.status, 1);
  EXPECT_NE(done.out.find("    You missed the saddle of triangle 0 1 2 (index 2). This is a bug.\n"
                          "    atoms: 0 C1, 1 N2, 2 O3\n    flowcert explain '"),
            std::string::npos)
      << done.out;
  const std::size_t begin = done.out.find("explain '");
  ASSERT_NE(begin, std::string::npos);
  const std::string command = done.out.substr(begin, done.out.find('\n', begin) - begin);
  const Finished explained = RunningProgram({"/bin/sh", "-c", "\"$0\" " + command, FLOWCERT_PROGRAM}).finish();
  EXPECT_EQ(explained.status, 0) << command << explained.err;
  EXPECT_NE(explained.out.find("0, 1, 2 (C1, N2, O3)"), std::string::npos) << explained.out;
  const json report = json::parse(flowcert({"check", molecule, claim, "--json"}).out);
  const auto missed =
      std::ranges::find_if(report["findings"], [](const json& one) { return one["reason"] == "missing"; });
  ASSERT_NE(missed, report["findings"].end());
  EXPECT_EQ((*missed)["sentence"], "You missed the saddle of triangle 0 1 2 (index 2). This is a bug.");
  EXPECT_EQ((*missed)["names"], json({"C1", "N2", "O3"}));
}

TEST(CheckCommand, ReadsFromStandardInput) {
  CITES("FC-CLAIM-03");
  const Checked own(kCube, Words{});
  EXPECT_EQ(flowcert({"check", own.points(), "-"}, {own.claim(), ""}).status, 0);
  EXPECT_EQ(flowcert({"check", "-", own.claim()}, {own.points(), ""}).status, 0);
}

}  // namespace
}  // namespace flowcert::conformance::check_command_test
