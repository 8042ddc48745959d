// flowcert-make-vectors as its users see it: files that are those of spec/vectors/, a table of what they
// hold, and what it refuses; and the tables behind it, asked for what they do not have.
//
// Guarantees: files are compared to the byte. Only groups that take a second are made; make_all_vectors_test makes the
// others.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cites.h"
#include "tests/conformance/made_vectors.h"
#include "tests/vectors/flags.h"
#include "tests/vectors/recipes.h"
#include "tests/vectors/starts.h"

namespace flowcert::conformance::make_vectors_test {
namespace {

TEST(MakeVectors, WritesTheFilesOfTheSpec) {
  CITES("FC-CRIT-05", "FC-CRIT-03", "FC-IN-05");
  const Scratch folder;
  const Finished finished = make_vectors({folder.path(""), "invalid-input", "regular-stationary-points"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.err, "");
  expect_files_of_the_spec(folder, {"flags.json", "invalid-input.json", "regular-stationary-points.json"});
}

TEST(MakeVectors, TellsHowManyCasesThereAre) {
  CITES("FC-IN-01", "FC-IN-05");
  const Scratch folder;
  const std::vector<std::string> lines = lines_of(make_vectors({folder.path(""), "invalid-input"}).out);
  ASSERT_EQ(lines.size(), 15U);
  EXPECT_TRUE(lines[0].starts_with("invalid-input                  42 cases     13726 bytes ")) << lines[0];
  EXPECT_EQ(lines[1], "all                            42 cases");
  EXPECT_EQ(lines[3], "  invalid                      42");
  EXPECT_EQ(lines[5], "  bad-start                     8");
  EXPECT_EQ(lines[14], "segments of given orbits");
}

TEST(MakeVectors, WhatItCannotDoIsStatus2) {
  CITES("FC-IN-05");
  const std::string usage = "usage: flowcert-make-vectors FOLDER [GROUP...]\n";
  const Scratch folder;
  const auto expect_refused = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Finished finished = make_vectors(arguments);
    EXPECT_EQ(finished.status, 2) << message;
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err, message);
    EXPECT_EQ(folder.names(), std::set<std::string>{});
  };
  expect_refused({}, usage);
  expect_refused({"--help"}, usage);
  expect_refused({folder.path(""), "invalid-input", "no-such-group"},
                 "flowcert-make-vectors: there is no group no-such-group\n");
  const std::string nowhere = folder.path("nowhere");
  expect_refused({nowhere, "invalid-input"},
                 "flowcert-make-vectors: " + nowhere + "/invalid-input.json: cannot be written\n");
  expect_refused({"/dev/null", "invalid-input"},
                 "flowcert-make-vectors: /dev/null/invalid-input.json: cannot be written\n");
}

TEST(MakeVectors, TablesRefuseWhatTheyDoNotHave) {
  CITES("FC-CRIT-05");
  const oracle::PointSet no_points(oracle::vectors::Rows{});
  const oracle::vectors::Findings nothing{{}, no_points, {}, {}, {}, {}, {}, {}};
  EXPECT_THROW(oracle::vectors::flags_of(nothing, {"no-such-flag"}), std::logic_error);
  EXPECT_THROW(oracle::vectors::flags_of(nothing, {"empty"}), std::logic_error);  // a flag, but no aim
  EXPECT_EQ(oracle::vectors::flags_of(nothing, {"rounded"}), (std::vector<std::string>{"rounded", "empty"}));
  oracle::vectors::GroupWriter cases("a-group", "Some cases", "FC-CRIT-05");
  EXPECT_THROW(cases.drawn(1, "no-such-family", 100, {1}), std::logic_error);
  EXPECT_TRUE(cases.group().recipes.empty());
}

TEST(MakeVectors, AnIdIsThereOnce) {
  CITES("FC-CRIT-05");
  oracle::vectors::GroupWriter cases("a-group", "Some cases", "FC-CRIT-05");
  cases.given(7, "no point", "", {});
  EXPECT_NO_THROW(oracle::vectors::require_different_ids({cases.group()}));
  EXPECT_THROW(oracle::vectors::require_different_ids({cases.group(), cases.group()}), std::logic_error);
  cases.given(7, "one point", "", {{1, 2, 3}});
  EXPECT_THROW(oracle::vectors::require_different_ids({cases.group()}), std::logic_error);
}

TEST(MakeVectors, StartsAreChosenAroundPointsOnly) {
  CITES("FC-FLOW-05");
  const auto starts_among = [](const oracle::vectors::Rows& rows) {
    return oracle::vectors::chosen_starts(oracle::PointSet(rows), oracle::stationary_points(rows), 1000, 1);
  };
  EXPECT_TRUE(starts_among({}).empty());
  // An orbit around one point can only stay there or go away from it.
  EXPECT_EQ(starts_among({{1, 2, 3}}).size(), 2U);
}

}  // namespace
}  // namespace flowcert::conformance::make_vectors_test
