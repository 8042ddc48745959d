// The plain sentences below findings: the words of the examples, and one for every reason, which the glossary knows.
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

#include "certify/finding_words.h"
#include "certify/pair_differences.h"
#include "cli/glossary.h"
#include "tests/cites.h"
#include "tests/unit/hand_made_claims.h"

namespace flowcert::finding_sentence_test {
namespace {

const std::vector<Point> kRightTriangle = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
const std::vector<Point> kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
const std::vector<Point> kTriangle = {{0, 0, 0}, {6, 0, 0}, {2, 4, 0}};

// The sentence of the first finding with this reason.
std::string sentence(const std::vector<Point>& rows, const Claim& claim, FindingReason reason) {
  const CheckReport report = check(PointSet(rows), claim);
  for (const Finding& finding : report.findings) {
    if (finding.reason == reason) return finding.sentence;
  }
  return "no such finding";
}

TEST(FindingSentences, SayWhatANewcomerAsks) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04", "FC-CRIT-05");
  EXPECT_EQ(sentence(kRightTriangle, Claimed().add(1, {1, 2}).claim, FindingReason::kCollisionAsCritical),
            "The midpoint of edge 1 2 is not critical: point 0 lies on its sphere, too. Moving the points a little "
            "would not make this answer right. Right is to claim nothing there; the edge beside the triangle 0 1 2 is "
            "permitted. This is a bug.");
  EXPECT_EQ(sentence(kRightTriangle, Claimed().at(1, decimals({Rational(3, 2), 2, 0})).claim,
                     FindingReason::kCollisionAsCritical),
            "This place, the regular stationary point of triangle 0 1 2 (kind 1-2), is not critical. Moving the points "
            "a little would not make this answer right. Right is to claim nothing there; the edge beside the triangle "
            "0 1 2 is permitted. This is a bug.");
  EXPECT_EQ(sentence(kTriangle, Claimed().add(0, {0}).add(0, {1}).claim, FindingReason::kWrongCounts),
            "The counts are wrong: you have an Euler sum of 2; it is 1. This is a bug.");
  EXPECT_EQ(sentence(kTriangle, Claimed().add(1, {0, 1}).claim, FindingReason::kMissing),
            "You missed point 0. This is a bug.");
  EXPECT_EQ(sentence(kTriangle, Claimed().add(0, {0}).add(0, {1}).add(0, {2}).claim, FindingReason::kMissing),
            "You missed the saddle of edge 0 1 (index 1). This is a bug.");
  Claimed of_edges;
  for (const PointId row : {0U, 1U, 2U}) of_edges.add(0, {row});
  of_edges.add(1, {0, 1}).add(1, {0, 2}).add(1, {1, 2});
  EXPECT_EQ(sentence(kTriangle, of_edges.claim, FindingReason::kMissing),
            "You missed the saddle of triangle 0 1 2 (index 2). This is a bug.");
  EXPECT_EQ(sentence(kSquare, Claimed().add(2, {0, 2}).claim, FindingReason::kContactIncomplete),
            "Four points lie on this sphere (0 1 2 3); you named two. This is a bug.");
  EXPECT_EQ(sentence(kSquare, Claimed().add(2, {0, 1, 2}).claim, FindingReason::kSpanningPart),
            "You named three of the points on its sphere, which span the same. This is a convention: all of them are "
            "asked for, and this is permitted.");
  EXPECT_EQ(sentence(kSquare, Claimed().add(0, {0}).claim, FindingReason::kMissedByCluster),
            "You missed the saddle of the 4 cocircular points 0 1 2 3 (index 2), where more points lie on one sphere "
            "than a simplex has. This is a bug.");
  EXPECT_EQ(sentence(kTriangle, Claimed().add(1, {0, 1}).add(1, {0, 1}).claim, FindingReason::kClaimedTwice),
            "You named the saddle of edge 0 1 (index 1) twice. This is a bug.");
}

// No two reasons are told alike, and flowcert help has a word for each.
TEST(FindingSentences, EveryReasonHasOneAndAnEntryInTheGlossary) {
  const std::unique_ptr<Truth> truth = fast_truth(PointSet(kSquare));
  std::set<std::string> sentences;
  for (int k = 0; k <= static_cast<int>(FindingReason::kSymbolicPerturbation); ++k) {
    Finding finding;
    finding.reason = static_cast<FindingReason>(k);
    finding.contact = {0, 1};
    const std::string text = certify::finding_sentence(finding, *truth);
    EXPECT_TRUE(text.ends_with(".")) << reason_text(finding.reason);
    EXPECT_TRUE(text.find("This is a bug.") != std::string::npos ||
                text.find("This is a convention: ") != std::string::npos)
        << text;
    EXPECT_TRUE(sentences.insert(text).second) << text;
    EXPECT_NE(cli::entry_of(reason_text(finding.reason)), nullptr) << reason_text(finding.reason);
  }
  EXPECT_EQ(sentences.size(), 25U);
}

TEST(FindingSentences, OfPairs) {
  CITES("FC-CLAIM-11");
  PairDifference difference{.claimed = "", .truth = "", .dimension = 1, .is_claimed = true, .is_true = false};
  EXPECT_EQ(sentence_of(difference), "There is no such tunnel. This is a bug.");
  difference = {.claimed = "", .truth = "", .dimension = 2, .is_claimed = false, .is_true = true};
  EXPECT_EQ(sentence_of(difference), "You missed this void. This is a bug.");
  difference = {.claimed = "", .truth = "", .dimension = 0, .is_claimed = true, .is_true = true};
  EXPECT_EQ(sentence_of(difference), "This component has another birth or death. This is a bug.");
  EXPECT_NE(cli::entry_of(difference.reason), nullptr);
}

TEST(Glossary, FindsWordsInAnyForm) {
  EXPECT_STREQ(cli::entry_of("Mouths")->word, "mouth");
  EXPECT_STREQ(cli::entry_of("pore-limiting radius")->word, "pore limiting radius");
  EXPECT_STREQ(cli::entry_of("U2")->word, "u2");
  EXPECT_EQ(cli::entry_of("mouthful"), nullptr);
  EXPECT_EQ(cli::entry_of(""), nullptr);
  const auto entries = cli::glossary();
  for (std::size_t k = 1; k < entries.size(); ++k) {
    EXPECT_LT(std::string(entries[k - 1].word), entries[k].word);
  }
}

}  // namespace
}  // namespace flowcert::finding_sentence_test
