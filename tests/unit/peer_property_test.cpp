// Another implementation's command as a property: what is wrong with its claim, or how it ended, is the kind of the
// disagreement, and what it may say is none.
#include "fuzz/judge/peer_property.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "tests/cites.h"

namespace flowcert::judge::peer_property_test {
namespace {

const std::string kSamples = "0,,,,,0\\n0,,,,,1\\n0,,,,,2\\n";
const std::string kEdges = "1,,,,,0,1\\n1,,,,,0,2\\n";

// The kind of the disagreement about the right triangle, "none" if there is none.
std::string kind_of(const std::string& command, PeerOptions options = {}) {
  options.command = command + " # {in} {out}";
  const property::Property property = peer_property(options);
  const auto found = property.check({{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}, oracle::Point{}});
  return found ? found->kind : "none";
}

std::string claiming(const std::string& lines) { return "printf '" + lines + "' > {out}"; }

TEST(PeerProperty, RightClaimsAndPermittedOnesAgree) {
  CITES("FC-CLAIM-03", "FC-CLAIM-04");
  EXPECT_EQ(kind_of(claiming(kSamples + kEdges)), "none");
  EXPECT_EQ(kind_of(claiming(kSamples + kEdges + "1,,,,,1,2\\n2,,,,,0,1,2\\n")), "none");
}

TEST(PeerProperty, WhatIsWrongIsTheKind) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03");
  EXPECT_EQ(kind_of(claiming(kSamples + "1,,,,,0,1\\n")), "missing");
  EXPECT_EQ(kind_of(claiming(kSamples + kEdges + kEdges)), "claimed-twice");
  EXPECT_EQ(kind_of(claiming(kSamples + kEdges + "1,,,,,1,2\\n")), "collision-as-critical");
}

TEST(PeerProperty, AnEndIsAKind) {
  CITES("FC-CLAIM-01");
  EXPECT_EQ(kind_of(claiming(kSamples + kEdges) + "; exit 3"), "refusal");
  EXPECT_EQ(kind_of("kill -SEGV $$"), "signal");
  EXPECT_EQ(kind_of("exit 127"), "not-started");
  PeerOptions hurried;
  hurried.limits.seconds = 0.2;
  EXPECT_EQ(kind_of("sleep 100", hurried), "time-limit");
  EXPECT_EQ(kind_of("true"), "unreadable");
  EXPECT_EQ(kind_of(claiming("0,,,,,3\\n")), "unreadable");
}

// The next reason is looked for in the same answer.
TEST(PeerProperty, WhatIsIgnoredIsNoKind) {
  CITES("FC-CLAIM-03");
  const auto kind_without = [](const std::string& command, const std::vector<std::string>& ignored) {
    PeerOptions options;
    options.ignored = ignored;
    return kind_of(command, options);
  };
  const std::string wrong = claiming(kSamples + "1,,,,,0,1\\n1,,,,,0,1\\n");
  EXPECT_EQ(kind_without(wrong, {}), "claimed-twice");
  EXPECT_EQ(kind_without(wrong, {"claimed-twice"}), "missing");
  EXPECT_EQ(kind_without(wrong, {"claimed-twice", "missing"}), "none") << "the Euler sum is right";
  EXPECT_EQ(kind_without(claiming(kSamples + "1,,,,,0,1\\n"), {"missing"}), "none") << "the Euler sum follows";
  EXPECT_EQ(kind_without("exit 3", {"refusal"}), "none");
  EXPECT_EQ(kind_without("exit 3", {"signal"}), "refusal");
  const auto kinds = peer_kinds();
  for (const char* kind : {"missing", "wrong-surface", "signal", "wrong-pair", "rounding"}) {
    EXPECT_NE(std::ranges::find(kinds, kind), kinds.end()) << kind;
  }
  EXPECT_EQ(std::ranges::find(kinds, "spanning-part"), kinds.end());
}

// The pairs of the right triangle, whose edges have the squared radii 9/4 and 4.
TEST(PeerProperty, PairsAreJudgedInstead) {
  CITES("FC-CLAIM-11");
  PeerOptions options;
  options.judges_pairs = true;
  EXPECT_STREQ(peer_property(options).name.c_str(), "persistence-against");
  const auto kind = [&](const std::string& lines) { return kind_of(claiming(lines), options); };
  EXPECT_EQ(kind("0 0 2.25\\n0 0 4\\n0 0 inf\\n"), "none");
  EXPECT_EQ(kind("0 0 2.25\\n0 0 inf\\n"), "wrong-pair");
  EXPECT_EQ(kind("0 0 2.2500001\\n0 0 4\\n0 0 inf\\n"), "wrong-pair");
  EXPECT_EQ(kind("0 0\\n"), "unreadable");
  EXPECT_EQ(kind("{}"), "unreadable");
  options.ignored = {"wrong-pair"};
  EXPECT_EQ(kind("0 0 2.25\\n0 0 inf\\n"), "none");
}

// ---- One process for all cases ----

// A script of the shell that does this for each case, whose id is $id.
std::string for_each_case(const std::string& script) {
  return "while read -r word id count; do test $word = case || continue; " + script + "; done";
}
std::string answering(const std::string& lines) { return "printf \"answer $id\\n" + lines + "end\\n\""; }

property::Property dialogue(const std::string& command, double seconds = 10) {
  PeerOptions options;
  options.command = command;
  options.is_dialogue = true;
  options.limits.seconds = seconds;
  return peer_property(options);
}

std::optional<property::Disagreement> disagreement_with(const property::Property& property) {
  return property.check({{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}, oracle::Point{}});
}

TEST(PeerProperty, AnswersOfOneProcessAreJudgedAlike) {
  CITES("FC-CLAIM-01", "FC-CLAIM-03");
  const auto kind = [](const std::string& script) {
    const property::Property property = dialogue(for_each_case(script));
    const auto found = disagreement_with(property);
    // The next case is judged by itself.
    const auto again = disagreement_with(property);
    EXPECT_EQ(found ? found->kind : "none", again ? again->kind : "none") << script;
    return found ? found->kind : "none";
  };
  EXPECT_EQ(kind(answering(kSamples + kEdges)), "none");
  EXPECT_EQ(kind(answering(kSamples + "1,,,,,0,1\\n")), "missing");
  EXPECT_EQ(kind(answering("")), "missing") << "it claims nothing";
  EXPECT_EQ(kind(answering(kSamples + kEdges + kEdges)), "claimed-twice");
  EXPECT_EQ(kind(answering("0,,,,,3\\n")), "unreadable");
  EXPECT_EQ(kind("echo refused $id too hard"), "refusal");
  EXPECT_EQ(kind("exit 3"), "refusal");
  EXPECT_EQ(kind("exit 0"), "unreadable");
  EXPECT_EQ(kind("kill -SEGV $$"), "signal");
  EXPECT_EQ(kind("echo hello"), "unreadable");
  EXPECT_EQ(kind(answering(kSamples + kEdges) + "; echo hello"), "unreadable") << "it is left behind";
  EXPECT_EQ(kind("echo answer $id; exit 0"), "unreadable");
}

TEST(PeerProperty, AnAnswerThatDoesNotComeMayNotBeFlushed) {
  const auto found = disagreement_with(dialogue(for_each_case("sleep 100"), 0.2));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "time-limit");
  EXPECT_EQ(found->complaint, "no answer after 0.2 s; is each answer flushed, in Python by print(..., flush=True)?");
  // It may as well read nothing, or answer by halves.
  EXPECT_EQ(disagreement_with(dialogue("sleep 100", 0.2))->kind, "time-limit");
  EXPECT_EQ(disagreement_with(dialogue(for_each_case("printf 'answer '; sleep 100"), 0.2))->kind, "time-limit");
}

// A process that ends between two cases, or spoils the next one, is no fault of that case.
TEST(PeerProperty, ACaseIsJudgedWithoutThoseBefore) {
  const std::string counted =
      "n=0; " + for_each_case("n=$((n + 1)); test $n -lt 4 || exit 9; " + answering(kSamples + kEdges));
  const property::Property property = dialogue(counted);
  for (int k = 0; k < 8; ++k) EXPECT_FALSE(disagreement_with(property)) << k;
}

// An answer without an end takes bounded memory.
TEST(PeerProperty, AnAnswerWithoutEndIsUnreadable) {
  const auto found = disagreement_with(dialogue("exec yes 'answer fuzz:1'"));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "unreadable");
  const auto line = disagreement_with(dialogue("head -c 20000000 /dev/zero; sleep 100", 20));
  ASSERT_TRUE(line);
  EXPECT_EQ(line->complaint, "standard output: more than 16777216 bytes");
}

}  // namespace
}  // namespace flowcert::judge::peer_property_test
