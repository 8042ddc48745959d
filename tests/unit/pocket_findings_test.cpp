// Claims of pockets as text: what the reader refuses, and what check finds in them, in words.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "flowcert/flow_complex.h"
#include "io/write_pockets.h"
#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::pocket_findings_test {
namespace {

// The corners of a cube of side 2, with one pocket of six mouths.
const std::vector<Point> kBox = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0},
                                 {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};

std::string pockets_text(const std::string& keys) {
  return R"({"format":"flowcert-pockets","format_version":2,"squared_persistence":"0",)" + keys + "}\n";
}
std::string one_pocket(const std::string& keys, const std::string& of_claim = "") {
  return pockets_text(of_claim + R"("pockets":[{"maxima":[[0,1,2,3,4,5,6,7]])" + (keys.empty() ? "" : "," + keys) +
                      "}]");
}

std::string said(const std::string& claim, const CheckOptions& options = {}) {
  const PointSet points(kBox);
  return text(check(points, read_claim_from(claim, "claim"), options));
}

std::string refusal(const std::string& claim) {
  try {
    const Claim read = read_claim_from(claim, "claim");
    require_rows(read, PointSet(kBox), "claim");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "taken";
}

TEST(PocketFindings, WhatIsRightConforms) {
  CITES("FC-CLAIM-18");
  EXPECT_EQ(said(one_pocket("")), "conforms");
  EXPECT_EQ(said(one_pocket(R"("difference_of_squares":"1","volume":8,"lining":[7,6,5,4,3,2,1,0],"neighbours":[-1])")),
            "conforms");
  EXPECT_EQ(said(one_pocket(R"("difference_of_squares":1.0000000000001,"depth":0.3178372451957822)")), "conforms");
  EXPECT_EQ(
      said(one_pocket(R"("peaks":[{"contact":[7,6,5,4,3,2,1,0],"center":["1",1,"1"],"radius":1.7320508075688772}])")),
      "conforms");
  EXPECT_EQ(said(one_pocket(R"("is":"channel")", R"("probe":1.2,)")), "conforms");
  EXPECT_EQ(said(one_pocket(R"("is":"cavity")", R"("probe":"3/2",)")), "conforms");
  EXPECT_EQ(said(one_pocket("", R"("critical":[8,12,6,1],"regular_stationary":{"1-2":0,"1-3":0,"2-3":0},)")),
            "conforms");
  // A line may begin anywhere, and four of the eight samples span the same.
  EXPECT_EQ(
      said(std::string("\n\n { \"format\" :\n\"flowcert-pockets\",\"format_version\":2,\n\"squared_persistence\":0,") +
           "\"pockets\":[{\"maxima\":[[0,1,2,4]]}]}"),
      "conforms");
}

// What is written of the empty set, and of sets without pockets.
TEST(PocketFindings, ClaimsWithoutPocketsConform) {
  CITES("FC-CLAIM-18", "FC-POCK-07");
  for (const std::vector<Point>& rows : {std::vector<Point>{}, {{1, 2, 3}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
    const FlowComplex complex{PointSet(rows)};
    std::ostringstream out;
    write_pockets(out, {complex, Pockets(complex.merge_trees(), 0), std::nullopt, false});
    const CheckReport report = check(complex.points(), read_claim_from(out.str(), "claim"));
    EXPECT_EQ(text(report), "conforms");
    EXPECT_TRUE(report.is_exact);
  }
}

TEST(PocketFindings, WhatIsWrongIsSaid) {
  CITES("FC-CLAIM-18", "FC-POCK-03", "FC-POCK-04", "FC-POCK-05", "FC-POCK-06", "FC-POCK-07", "FC-POCK-08",
        "FC-POCK-11");
  EXPECT_EQ(said(pockets_text("\"pockets\":[]")),
            "fails\n5 wrong-pocket FC-POCK-02: no such pocket; a pocket of 1 maximum, with critical point of index 3, "
            "contact set 0 1 2 3 4 5 6 7");
  EXPECT_EQ(said(one_pocket(R"("difference_of_squares":"2")")),
            "fails\n5 wrong-pocket FC-POCK-05: pocket 0, a difference of squares of 2; it is 1");
  EXPECT_EQ(said(one_pocket(R"("depth":null)")),
            "fails\n5 wrong-pocket FC-POCK-11: pocket 0, depth no double; the depth is ~0.31783724519578227");
  EXPECT_EQ(said(one_pocket(R"("lining":[0,1,2,3,4,5,6])")),
            "fails\n5 wrong-pocket FC-POCK-03: pocket 0, a lining of 7 samples; it has 8");
  EXPECT_EQ(said(one_pocket(R"("volume":"9")")),
            "fails\n5 wrong-volume FC-POCK-03: pocket 0, volume 9; the volume is 8");
  EXPECT_EQ(said(one_pocket(R"("neighbours":[])")),
            "fails\n5 wrong-pocket FC-POCK-04: pocket 0, 0 neighbours; it has 1, which are other ones");
  EXPECT_EQ(
      said(one_pocket(R"("mouths":[])")),
      "fails\n5 wrong-pocket FC-POCK-04: pocket 0, mouths: 0 other points; there are 6, the first one at 0 1 2 3");
  EXPECT_EQ(said(one_pocket(R"("is":"pocket")", R"("probe":1,)")),
            "fails\n5 wrong-pocket FC-POCK-06: pocket 0, pocket; for the probe it is a channel");
  EXPECT_EQ(said(one_pocket("", R"("pore_limiting_radius":null,)")),
            "fails\n5 wrong-pocket FC-POCK-07: pore limiting radius: there is none; there is one");
  EXPECT_EQ(said(one_pocket("", R"("critical":[8,12,6,2],)")),
            "fails\n3 wrong-counts FC-CLAIM-18: 8 12 6 2 critical points; there are 8 12 6 1");
  EXPECT_EQ(said(one_pocket("", R"("points":9,)")), "fails\n1 wrong-counts FC-IN-03: 9 points; 8");
  EXPECT_EQ(said(pockets_text(R"("pockets":[{"maxima":[[0,1,2,3,4,5,6,7,7]]}])")),
            "fails\n1 malformed FC-CLAIM-01: a contact set in a pocket; point 7 is named twice");
  // Levels beyond those that are asked for are not judged.
  EXPECT_EQ(said(one_pocket(R"("depth":2)"), {.highest_level = 4}), "conforms");
}

// The box's two widest mouths have the radius 17/2.
TEST(PocketFindings, AMouthIsOpenForAProbeThatIsJustAsWide) {
  CITES("FC-CLAIM-18", "FC-POCK-06");
  std::vector<Point> rows = kBox;
  for (Point& p : rows) p = {3 * p.x, 4 * p.y, 7.5 * p.z};
  const Claim claim = read_claim_from(one_pocket(R"("is":"channel")", R"("probe":"17/2",)"), "claim");
  EXPECT_EQ(text(check(PointSet(rows), claim)), "conforms");
}

// Half the mouths' area, and what is wrong by no more than rounding explains.
TEST(PocketFindings, AreasAndRoundings) {
  CITES("FC-CLAIM-18", "FC-POCK-11");
  const auto all_mouths = [](const std::string& first) {
    std::string mouths;
    for (const char* contact : {"0,1,2,3", "0,1,4,5", "0,2,4,6", "1,3,5,7", "2,3,6,7", "4,5,6,7"}) {
      mouths += std::string(mouths.empty() ? "" : ",") + "{\"contact\":[" + contact + "]" +
                (mouths.empty() ? first : "") + "}";
    }
    return one_pocket("\"mouths\":[" + mouths + "]");
  };
  EXPECT_EQ(said(all_mouths(",\"area\":4.0000000001")), "conforms");
  EXPECT_EQ(said(all_mouths(",\"area\":4.0000000001"), {.tolerance = 0}),
            "fails\n5 wrong-pocket FC-POCK-11: pocket 0, a mouth 0 1 2 3 of area 4.0000000001; its area is about 4");
  EXPECT_EQ(said(all_mouths(",\"area\":2")),
            "fails\n5 wrong-pocket FC-POCK-11: pocket 0, a mouth 0 1 2 3 of area 2; its area is about 4");
  EXPECT_EQ(said(all_mouths(",\"between\":[0]")),
            "fails\n5 wrong-pocket FC-POCK-04: pocket 0, a mouth 0 1 2 3 between others; other pockets are above it");
  EXPECT_EQ(said(one_pocket(R"("difference_of_squares":1.00000000000001)"), {.tolerance = 0}),
            "fails\n5 rounding FC-POCK-05: pocket 0, a difference of squares of 1.00000000000001; it is 1");
}

TEST(PocketFindings, MalformedClaimsAreRefused) {
  CITES("FC-CLAIM-18", "FC-CLAIM-01");
  EXPECT_EQ(refusal(R"({"format":"flowcert-pockets","format_version":3,"squared_persistence":"0","pockets":[]})"),
            "claim:1: the value of 'format_version' is not 2, the only version that is known");
  EXPECT_EQ(refusal(R"({"format":"flowcert-pockets","format_version":1,"persistence":"0","pockets":[]})"),
            "claim:1: the value of 'format_version' is not 2; in 1 pockets were merged by differences of squared "
            "distances");
  EXPECT_EQ(refusal(R"({"format":"flowcert-pockets","format_version":2,"pockets":[]})"),
            "claim:1: no key 'squared_persistence'");
  EXPECT_EQ(refusal(R"({"format":"flowcert-pockets","format_version":2,"squared_persistence":"-1","pockets":[]})"),
            "claim:1: the value of 'squared_persistence' is not 0 or more");
  EXPECT_EQ(refusal(pockets_text(R"("pockets":[{"maxima":[]}])")),
            "claim:1: the value of 'maxima' is not one maximum or more");
  EXPECT_EQ(refusal(pockets_text(R"("pockets":[{"maxima":[[]]}])")),
            "claim:1: the value of 'maxima' is not a contact set: it is empty");
  EXPECT_EQ(refusal(pockets_text(R"("pockets":[{"maxima":[[0,8]]}])")),
            "claim:1: there is no point 8; the ids are 0 to 7");
  EXPECT_EQ(refusal(one_pocket(R"("neighbours":[1])")),
            "claim:1: the value of 'neighbours' is not numbers of pockets, or -1: there are 1");
  EXPECT_EQ(refusal(one_pocket(R"("is":"cavity")")), "claim:1: the value of 'is' is not there without a probe");
  EXPECT_EQ(refusal(one_pocket(R"("is":"hole")", R"("probe":"1",)")),
            "claim:1: the value of 'is' is not cavity, pocket or channel");
  EXPECT_EQ(refusal(one_pocket(R"("widest_path":{"gates":[]})")),
            "claim:1: the value of 'gates' is not one witness or more");
  EXPECT_EQ(refusal(one_pocket(R"("cell":[{"index":[3,2],"contact":[0]}])")),
            "claim:1: the value of 'index' is not a kind: [1,2], [2,3], [1,3]");
  EXPECT_EQ(refusal("\n\n" + pockets_text("\"pockets\":[},")), "claim:3: not JSON, in column 88");
}

// Keys that the format does not have are told, and not judged.
TEST(PocketFindings, UnknownKeysAreTold) {
  CITES("FC-CLAIM-18");
  const CheckReport report = check(PointSet(kBox), read_claim_from(one_pocket(R"("colour":3)"), "claim"));
  EXPECT_EQ(text(report), "conforms\nnot judged: what the unknown key 'pockets.colour' says");
}

}  // namespace
}  // namespace flowcert::pocket_findings_test
