// Files of conformance vectors that cannot be used are refused, with the case; points are written so that they read
// back.
#include "certify/programs/vector_cases.h"

#include <gtest/gtest.h>

#include "certify/programs/command_run.h"
#include "flowcert/read_points.h"
#include "tests/cites.h"

namespace flowcert::certify::vector_cases_test {
namespace {

const char* const kCase = R"({"id": "two-points", "comment": "", "flags": ["few-points"], "result": "determined",
  "points": [["0x0p+0","0x0p+0","0x0p+0"], ["0x1p+1","-0x1p-1074","0.1"]],
  "expected": {"merged_duplicates": 0, "stationary": [
    {"index": 0, "contact": [0], "center": ["0","0","0"], "squared_distance": "0"},
    {"index": 0, "contact": [1], "center": ["2","0","0"], "squared_distance": "0"},
    {"index": 1, "contact": [0,1], "center": ["1","0","0"], "squared_distance": "1"}],
  "persistence": [{"dimension": 0, "birth": "0", "death": "1"}, {"dimension": 0, "birth": "0", "death": null}]}})";

Vectors read(const Json& cases) {
  const ScratchFolder folder;
  write_text_file(folder.path() / "flags.json", R"({"format": "flowcert-vector-flags", "format_version": 1,
    "flags": [{"flag": "few-points", "meaning": "Few points."}]})");
  const Json group = {{"format", "flowcert-vectors"}, {"format_version", 1}, {"group", "few"}, {"cases", cases}};
  write_text_file(folder.path() / "few.json", group.dump());
  return read_vectors(folder.path().string());
}

// The complaint about the case with another value at a JSON pointer.
std::string complaint(const char* pointer, const Json& value) {
  Json one = Json::parse(kCase);
  one[Json::json_pointer(pointer)] = value;
  try {
    (void)read(Json::array({one}));
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    return text.substr(text.rfind("case 1: ") + 8);
  }
  return "none";
}

TEST(VectorCases, AreRead) {
  CITES("FC-IN-02");
  const Vectors vectors = read(Json::array({Json::parse(kCase)}));
  ASSERT_EQ(vectors.cases.size(), 1U);
  const VectorCase& one = vectors.cases[0];
  EXPECT_EQ(one.stationary.size(), 3U);
  EXPECT_EQ(one.rows[1].y, -0x1p-1074);
  ASSERT_TRUE(one.persistence);
  EXPECT_EQ(one.persistence->size(), 2U);
  EXPECT_FALSE(one.persistence->back().death);
  EXPECT_THROW((void)read(Json::array({Json::parse(kCase), Json::parse(kCase)})), InvalidInput) << "the same id";
  EXPECT_THROW((void)read(Json::array()), InvalidInput);
}

TEST(VectorCases, ThatCannotBeRightAreRefused) {
  CITES("FC-OUT-01", "FC-OUT-02");
  const char* const contact = "/expected/stationary/2/contact";
  EXPECT_EQ(complaint(contact, {0, 1}), "none");
  EXPECT_EQ(complaint(contact, {1, 0}), "a contact set that does not ascend");
  EXPECT_EQ(complaint(contact, {0, 1, 1}), "a contact set that does not ascend");
  EXPECT_EQ(complaint(contact, {0, 2}), "a contact set that is none of the points");
  EXPECT_EQ(complaint(contact, Json::array()), "a contact set that is none of the points");
  EXPECT_EQ(complaint("/expected/stationary/1/contact", {0}), "a stationary point twice");
  EXPECT_EQ(complaint("/expected/stationary/0/index", 2), "stationary points that are not in order");
  EXPECT_EQ(complaint("/expected/stationary/2/index", {2, 1}), "no index: [2,1]");
  EXPECT_EQ(complaint("/expected/stationary/2/limits", {nullptr, {0, 2}}), "a contact set that is none of the points");
  EXPECT_EQ(complaint("/expected/stationary/2/limits", {nullptr}), "not two limits");
  EXPECT_EQ(complaint("/expected/persistence/0/death", "0"), "a persistence pair of no length");
  EXPECT_EQ(complaint("/expected/persistence/0/dimension", 3), "'dimension' is not 0, 1 or 2");
  EXPECT_EQ(complaint("/expected/persistence/1/death", "1/2"), "persistence pairs that are not in order");
  EXPECT_EQ(complaint("/result", "right"), "no result: 'right'");
  EXPECT_EQ(complaint("/id", "../two"), "no id: '../two'");
}

TEST(VectorCases, PointFilesReadBack) {
  CITES("FC-IN-02");
  const VectorCase one = read(Json::array({Json::parse(kCase)})).cases[0];
  for (const PointFileFormat format : {PointFileFormat::kXyz, PointFileFormat::kOff}) {
    for (const bool hexadecimal : {false, true}) {
      const PointFileStyle style{format, hexadecimal};
      const auto rows = read_points_from(point_file_text(one, style).value(), point_file_name(style)).rows;
      ASSERT_EQ(rows.size(), one.rows.size());
      for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_EQ(rows[k].x, one.rows[k].x);
        EXPECT_EQ(rows[k].y, one.rows[k].y);
        EXPECT_EQ(rows[k].z, one.rows[k].z);
      }
    }
  }
}

}  // namespace
}  // namespace flowcert::certify::vector_cases_test
