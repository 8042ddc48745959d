// flowcert-make-vectors makes the files of spec/vectors/ once more, the groups that take long (./dev test --slow).
//
// Guarantees: files are compared to the byte.
#include <gtest/gtest.h>

#include "tests/cites.h"
#include "tests/conformance/made_vectors.h"

namespace flowcert::conformance::make_all_vectors_test {
namespace {

TEST(MakeAllVectors, WritesStableSetsAndPersistencePairs) {
  CITES("FC-STAB-01", "FC-STAB-04", "FC-PERS-01");
  const Scratch folder;
  EXPECT_EQ(make_vectors({folder.path(""), "persistence", "stable-manifolds"}).status, 0);
  expect_files_of_the_spec(folder, {"flags.json", "persistence.json", "stable-manifolds.json"});
}

TEST(MakeAllVectors, WritesTheWholeComplex) {
  CITES("FC-UNST-02", "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02");
  const Scratch folder;
  EXPECT_EQ(make_vectors({folder.path(""), "connections", "lambda-lists", "volumes"}).status, 0);
  expect_files_of_the_spec(folder, {"flags.json", "connections.json", "lambda-lists.json", "volumes.json"});
}

TEST(MakeAllVectors, WritesUnstableSets) {
  CITES("FC-UNST-04", "FC-UNST-05", "FC-UNST-06");
  const Scratch folder;
  EXPECT_EQ(make_vectors({folder.path(""), "unstable-surfaces"}).status, 0);
  expect_files_of_the_spec(folder, {"flags.json", "unstable-surfaces.json"});
}

TEST(MakeAllVectors, WritesPores) {
  CITES("FC-BALL-03", "FC-BALL-05", "FC-BALL-09");
  const Scratch folder;
  EXPECT_EQ(make_vectors({folder.path(""), "pores"}).status, 0);
  EXPECT_TRUE(content_of(folder.path("balls/pores.json")) ==
              content_of(FLOWCERT_SPEC_FOLDER "/vectors/balls/pores.json"));
}

}  // namespace
}  // namespace flowcert::conformance::make_all_vectors_test
