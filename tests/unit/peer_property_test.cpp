// Another implementation's command as a property: what is wrong with its claim, or how it ended, is the kind of the
// disagreement, and what it may say is none.
#include "fuzz/judge/peer_property.h"

#include <gtest/gtest.h>

#include "tests/cites.h"

namespace flowcert::judge {
namespace {

const std::string kSamples = "0,,,,,0\\n0,,,,,1\\n0,,,,,2\\n";
const std::string kEdges = "1,,,,,0,1\\n1,,,,,0,2\\n";

// The kind of the disagreement about the right triangle, "none" if there is none.
std::string kind_of(const std::string& command, double seconds = 60) {
  PeerOptions options;
  options.command = command + " # {in} {out}";
  options.limits.seconds = seconds;
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
  EXPECT_EQ(kind_of("sleep 100", 0.2), "time-limit");
  EXPECT_EQ(kind_of("true"), "unreadable");
  EXPECT_EQ(kind_of(claiming("0,,,,,3\\n")), "unreadable");
}

}  // namespace
}  // namespace flowcert::judge
