// Another implementation's command as a property: what is wrong with its claim, or how it ended, is the kind of the
// disagreement, and what it may say is none.
#include "fuzz/judge/peer_property.h"

#include <gtest/gtest.h>

#include <algorithm>
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

}  // namespace
}  // namespace flowcert::judge::peer_property_test
