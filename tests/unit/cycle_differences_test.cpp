// Claims of cycles made by hand: each way to name a pair and to write a cycle, and each reason for what is wrong.
#include "certify/cycle_differences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "tests/cites.h"

namespace flowcert::cycle_differences_test {
namespace {

using Rows = std::vector<Point>;

const Rows kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
// A square of side 2 beside eight samples around a square of side 4. Both loops are born at 1, and die at 2 and at 4.
const Rows kSquareAndRing = {{0, 0, 0},  {2, 0, 0},  {2, 2, 0},  {0, 2, 0},  {50, 0, 0}, {52, 0, 0},
                             {54, 0, 0}, {54, 2, 0}, {54, 4, 0}, {52, 4, 0}, {50, 4, 0}, {50, 2, 0}};
// Two rectangles whose loops die at 50, and are born at 25 and at 49.
const Rows kOneDeath = {{0, 0, 0},   {10, 0, 0},  {10, 10, 0},  {0, 10, 0},
                        {900, 0, 0}, {902, 0, 0}, {902, 14, 0}, {900, 14, 0}};
const Rows kOctahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const Rows kEqualPeaks = {{-1, -1, -3}, {-1, 0, -1}, {0, -2, -1}, {0, 1, -3}, {0, 2, 1}, {1, -1, -3}, {1, 0, -1}};
const Rows kOnALine = {{0, 0, 0}, {2, 0, 0}, {6, 0, 0}};

// The reasons, or "right".
std::string judged(const Rows& rows, const std::string& claim, double tolerance = 1e-9) {
  const CycleClaim claimed = claimed_cycles_of(claim, "claim");
  require_rows(claimed, PointSet(rows), "claim");
  std::string reasons;
  for (const PairDifference& difference : cycle_differences(FlowComplex(rows), claimed, tolerance)) {
    EXPECT_NE(sentence_of(difference).find("This is a bug."), std::string::npos);
    reasons += (reasons.empty() ? "" : ", ") + difference.reason;
  }
  return reasons.empty() ? "right" : reasons;
}
std::string loops(const Rows& rows, const std::string& lines) { return judged(rows, "cycles 1\n" + lines); }

TEST(CycleDifferences, PairsHaveManyNames) {
  CITES("FC-CLAIM-25", "FC-FILE-53");
  const std::string loop = "\nloop 2 1 0 3\n";
  for (const char* pair : {"0,1/0,1,2,3", "3,2/3,2,1,0", "1/1 4/2", "0x1p0 0x1p1", "1.0 2.0", "1.0000000001 2"}) {
    EXPECT_EQ(loops(kSquare, "pair " + std::string(pair) + loop), "right") << pair;
  }
  for (const char* pair : {"0,2/0,1,2,3", "0,1/0,1,2", "1/1 9/4", "1.00001 2", "0x1.0000000000001p0 2"}) {
    EXPECT_EQ(loops(kSquare, "pair " + std::string(pair) + loop), "wrong-pair") << pair;
  }
  EXPECT_EQ(judged(kSquare, "cycles 1 all\n# of one\npair 1 2" + loop), "right");
  EXPECT_EQ(judged(kSquare, "cycles 1 all\n"), "missing");
  EXPECT_EQ(judged(kSquare, "cycles 1 all\npair 1 2\nloop 0 1 2 3\npair 1 2\nloop 0 1 2 3"), "wrong-pair");
  EXPECT_EQ(judged(kSquare, "cycles 2 all\n"), "right");
  EXPECT_TRUE(is_exact_claim(claimed_cycles_of("cycles 1\npair 1/2 3/4\nlevel 0x1p-1", "c")));
  EXPECT_FALSE(is_exact_claim(claimed_cycles_of("cycles 1\npair 1/2 3/4\nlevel 0.5", "c")));
}

TEST(CycleDifferences, LoopsAreWrongForAReason) {
  CITES("FC-CLAIM-25", "FC-CYC-02", "FC-CYC-03");
  const std::string square = "pair 1/1 2/1\n", ring = "pair 1/1 4/1\n", around = "loop 4 5 6 7 8 9 10 11\n";
  EXPECT_EQ(loops(kSquare, square + "edge 0 1\nedge 1 2\nedge 2 3\n"), "not-a-cycle");
  EXPECT_EQ(loops(kSquare, square + "edge 0 1\nedge 1 2\nedge 2 3\nedge 3 0\nedge 0 2\nedge 2 0"), "right");
  EXPECT_EQ(loops(kSquare, square + "loop 0 1 2\n"), "edge-too-long");
  EXPECT_EQ(loops(kSquare, square + "level 7/4\nloop 0 1 2 3\n"), "right");
  EXPECT_EQ(loops(kSquare, square + "level 2/1\nloop 0 1 2 3\n"), "wrong-pair");
  EXPECT_EQ(loops(kSquare, square + "level 1/2\nloop 0 1 2 3\n"), "wrong-pair");
  EXPECT_EQ(loops(kSquare, square), "dies-earlier");
  EXPECT_EQ(loops(kSquareAndRing, square + around), "dies-later");
  EXPECT_EQ(loops(kSquareAndRing, ring + "loop 0 1 2 3\n"), "dies-earlier");
  EXPECT_EQ(loops(kSquareAndRing, ring + around + "loop 0 1 2 3\n"), "right") << "a sum of both";
  // Its edges have other samples on their diametral spheres.
  EXPECT_EQ(loops(kSquareAndRing, ring + "level 2/1\nloop 5 7 9 11\n"), "right");
  EXPECT_EQ(loops(kSquareAndRing, ring + "level 7/4\nloop 5 7 9 11\n"), "edge-too-long");
}

TEST(CycleDifferences, LoopsOfOneDeathAreIndependent) {
  CITES("FC-CLAIM-25", "FC-CYC-02", "FC-CYC-03");
  const std::string early = "loop 0 1 2 3\n", late = "loop 4 5 6 7\n";
  EXPECT_EQ(loops(kOneDeath, "pair 49/1 50/1\n" + early), "born-earlier");
  EXPECT_EQ(loops(kOneDeath, "pair 49/1 50/1\n" + early + late), "right");
  EXPECT_EQ(loops(kOneDeath, "pair 49/1 50/1\nlevel 99/2\n" + early), "right") << "above the birth";
  EXPECT_EQ(loops(kOneDeath, "pair 25/1 50/1\n" + early + "pair 49/1 50/1\nlevel 99/2\n" + early), "dependent");
  EXPECT_EQ(loops(kOneDeath, "pair 25/1 50/1\n" + early + "pair 49/1 50/1\n" + late), "right");
  EXPECT_EQ(loops(kOneDeath, "pair 25/1 50/1\nlevel 99/2\n" + late + "pair 49/1 50/1\n" + early + late), "right");
}

TEST(CycleDifferences, Surfaces) {
  CITES("FC-CLAIM-25", "FC-FILE-53");
  const std::string loop = "pair 1/1 2/1\nloop 0 1 2 3\n";
  EXPECT_EQ(loops(kSquare, loop + "triangle 0 1 2\ntriangle 0 2 3\n"), "right");
  EXPECT_EQ(loops(kSquare, loop + "triangle 0 1 2\n"), "surface-boundary");
  Rows with_far = kSquare;
  with_far.push_back({1, 1, 9});
  const std::string tent = "triangle 0 1 4\ntriangle 1 2 4\ntriangle 2 3 4\ntriangle 3 0 4\n";
  EXPECT_EQ(loops(with_far, loop + tent), "triangle-too-large");
  const auto json = [](const std::string& rest) {
    return R"({"format": "flowcert-cycles", "format_version": 1, "dimension": 1, "cycles": [{"birth": )"
           R"({"contact": [1, 0]}, "death": {"squared_distance": "2"}, )" +
           rest + "}]}";
  };
  const std::string edges = R"("edges": [[0, 1], [1, 2], [2, 3], [0, 3]])";
  EXPECT_EQ(judged(kSquare, json(edges)), "right");
  EXPECT_EQ(judged(kSquare, json(edges + R"(, "polygons": [[0, 1, 2, 3]], "squared_level": 1.5)")), "right");
  EXPECT_EQ(judged(kSquare, json(edges + R"(, "polygons": [[0, 1, 2]])")), "malformed");
  EXPECT_EQ(judged(kSquare, json(edges + R"(, "surface": [[3, 2, 1, 0]])")), "right");
  EXPECT_EQ(judged(kSquare, json(edges + R"(, "surface": [])")), "surface-boundary");
  EXPECT_EQ(judged(kSquare, json(edges + R"(, "surface": [[0, 1]])")), "surface-boundary");
}

TEST(CycleDifferences, Voids) {
  CITES("FC-CLAIM-25", "FC-CYC-06");
  const std::string pair = "cycles 2\npair 2/3 1/1\n", maximum = "maximum 5 4 3 2 1 0\n";
  const std::string below = "triangle 0 2 5\ntriangle 2 1 5\ntriangle 1 3 5\ntriangle 3 0 5\n";
  const std::string above = "triangle 0 2 4\ntriangle 2 1 4\ntriangle 1 3 4\ntriangle 3 0 4\n";
  EXPECT_EQ(judged(kOctahedron, pair + maximum), "right");
  // All rays along axes from the middle meet a corner.
  EXPECT_EQ(judged(kOctahedron, pair + above + below), "right");
  EXPECT_EQ(judged(kOctahedron, pair + maximum + above + below), "right");
  EXPECT_EQ(judged(kOctahedron, pair + above), "not-a-cycle");
  EXPECT_EQ(judged(kOctahedron, pair + above + "triangle 0 2 1\ntriangle 0 3 1\n"), "triangle-too-large");
  EXPECT_EQ(judged(kOctahedron, pair + above + above), "wrong-void") << "they enclose nothing";
  EXPECT_EQ(judged(kOctahedron, pair), "wrong-void");
  EXPECT_EQ(judged(kOctahedron, pair + "maximum 0 1 2\n"), "wrong-void");
}

TEST(CycleDifferences, OfEqualPeaksEitherIsRight) {
  CITES("FC-CLAIM-25", "FC-CYC-06");
  const FlowComplex complex(kEqualPeaks);
  const std::string pair = "pair 9/4 149/64\n";
  std::vector<std::string> peaks;
  for (std::size_t i = 0; i < complex.stationary().size(); ++i) {
    if (complex.stationary().index(i) != StationaryIndex{3, 3}) continue;
    if (complex.sphere(i).squared_radius != Rational(149, 64)) continue;
    peaks.emplace_back("maximum");
    for (const PointId name : complex.stationary().contact(i)) peaks.back() += " " + std::to_string(name);
    peaks.back() += '\n';
  }
  ASSERT_EQ(peaks.size(), 2U);
  for (const std::string& peak : peaks) EXPECT_EQ(judged(kEqualPeaks, "cycles 2\n" + pair + peak), "right");
  EXPECT_EQ(judged(kEqualPeaks, "cycles 2\n" + pair + peaks[0] + peaks[1]), "wrong-void") << "they join at the birth";
  EXPECT_EQ(judged(kEqualPeaks, "cycles 2\n" + pair + peaks[0] + pair + peaks[1]), "wrong-pair");
  // The other pair of this death is born where both join the outside.
  for (const PersistencePair& other : complex.persistence().pairs()) {
    const Rational birth = complex.persistence().squared_value(other.birth);
    if (other.dimension != 2 || birth == Rational(9, 4)) continue;
    const std::string of_other = "cycles 2\npair " + to_text(birth) + " 149/64\n";
    EXPECT_EQ(judged(kEqualPeaks, of_other + peaks[0] + peaks[1]), "right");
    EXPECT_EQ(judged(kEqualPeaks, of_other + peaks[0]), "wrong-void");
  }
}

TEST(CycleDifferences, VoidsOfOneDeathHaveTheirOwnBirths) {
  CITES("FC-CLAIM-25", "FC-CYC-06");
  Rows boxes;  // their voids die at 27, and are born at 18 and 26
  for (const double x : {-3, 3}) {
    for (const double y : {-3, 3}) {
      for (const double z : {-3, 3}) boxes.push_back({x, y, z});
    }
  }
  for (const double x : {999, 1001}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-5, 5}) boxes.push_back({x, y, z});
    }
  }
  const std::string cube = "maximum 0 1 2 3 4 5 6 7\n", other = "maximum 8 9 10 11 12 13 14 15\n";
  EXPECT_EQ(judged(boxes, "cycles 2\npair 18/1 27/1\n" + cube + "pair 26/1 27/1\n" + other), "right");
  EXPECT_EQ(judged(boxes, "cycles 2\npair 26/1 27/1\n" + cube), "wrong-void");
  EXPECT_EQ(judged(boxes, "cycles 2\npair 18/1 27/1\nlevel 26/1\n" + other), "wrong-void");
}

TEST(CycleDifferences, Components) {
  CITES("FC-CLAIM-25", "FC-CYC-07");
  const std::string pair = "cycles 0\npair 0/1 4/1\n";
  EXPECT_EQ(judged(kOnALine, pair + "component 1 0\ncomponent 2\n"), "right");
  EXPECT_EQ(judged(kOnALine, pair + "component 1\ncomponent 2\n"), "wrong-components");
  EXPECT_EQ(judged(kOnALine, pair + "component 0 1\n"), "wrong-components");
  EXPECT_EQ(judged(kOnALine, pair + "component 0 1\ncomponent 0 1\n"), "wrong-components");
  EXPECT_EQ(judged(kOnALine, "cycles 0\npair 2/2,1\ncomponent 0 1\ncomponent 2\n"), "right");
  EXPECT_EQ(judged(kOnALine, "cycles 0 all\npair 2/2,1\ncomponent 0 1\ncomponent 2\n"), "missing");
}

TEST(CycleDifferences, WhatIsRefused) {
  CITES("FC-FILE-53");
  const auto refusal = [](const std::string& claim) {
    try {
      return judged(kSquare, claim);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refusal("cycles 3\n"), "claim:1: no dimension 0, 1 or 2");
  EXPECT_EQ(refusal("cycles 1 some\n"), "claim:1: not a dimension, and nothing or 'all', behind 'cycles'");
  EXPECT_EQ(refusal("cycles 1\nloop 0 1 2\n"), "claim:2: no line 'pair' before it");
  EXPECT_EQ(refusal("cycles 1\npair 1 2\nmaximum 0 1\n"), "claim:3: not what a cycle of dimension 1 has: 'maximum'");
  EXPECT_EQ(refusal("cycles 1\npair 1 2\nedge 0 1 2\n"), "claim:3: not 2 rows");
  EXPECT_EQ(refusal("cycles 1\npair 1 2\n\nedge 0 4\n"), "claim:2: there is no point 4; the ids are 0 to 3");
  EXPECT_EQ(refusal("cycles 1\npair 1\n"),
            "claim:2: neither two contact sets, like 3,17/5,8,20, nor two squared distances");
  EXPECT_EQ(refusal(R"({"format": "flowcert-cycles", "format_version": 2})"),
            "claim: 'format_version' is not 1, the only one that is known");
  EXPECT_EQ(refusal(R"({"format": "flowcert-cycles", "format_version": 1, "dimension": 1, "cycles": [{"birth": 3}]})"),
            "claim: 'birth' has neither a contact set nor a squared distance");
  EXPECT_TRUE(is_cycle_claim("# loops\ncycles 1\n", "x"));
  EXPECT_FALSE(is_cycle_claim("1 0 2\n", "x"));
}

}  // namespace
}  // namespace flowcert::cycle_differences_test
