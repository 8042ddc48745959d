// Reading point files: the variants of each format, and each error with its message. Numbers and damaged
// files have tests of their own.
#include "flowcert/read_points.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "tests/cites.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert::read_points_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

const std::string kUnknown =
    "not a known format; these formats are read: table, pts, chemical, off, ply, obj, pcd, npy, pdb, pqr, cif "
    "(--format says one)";
const std::string kSkip = "; --skip-invalid leaves such rows out";

// ---- Tables ----

TEST(ReadTable, SeparatorsAndComments) {
  CITES("FC-IN-02", "FC-FILE-01");
  const Rows expected = {{1, 2, 3}, {-1.5, 0.1, 1e10}, {3, 0.5, -2}, {4, 5, 6}, {7, 8, 9}};
  EXPECT_EQ(rows_of("# points\n"
                    "1 2 3\n"
                    "\n"
                    "\t-1.5\t.1  1e10\n"
                    "0x1.8p+1,0.5 , -2 # a comment\n"
                    "   # another\n"
                    "4, 5, 6#,7\n"
                    "+7 8. 9,",
                    "a.xyz"),
            expected);
}

TEST(ReadTable, LineEndsAndByteOrderMark) {
  CITES("FC-IN-02");
  const Rows expected = {{1, 2, 3}, {4, 5, 6}};
  for (const char* text : {"1 2 3\n4 5 6\n", "1 2 3\n4 5 6", "1 2 3\r\n4 5 6\r\n", "1 2 3\r\n\r\n4 5 6",
                           "1 2 3\r4 5 6\r", "1 2 3\r\r4 5 6", "\xef\xbb\xbf 1 2 3\n4 5 6\n"}) {
    EXPECT_EQ(rows_of(text, "a.xyz"), expected) << text;
  }
  EXPECT_EQ(refusal("1 2 3\r\n\r\nx\r\n", "a.xyz"), "a.xyz:3: too few numbers: 1 of 3");
  EXPECT_EQ(refusal("1 2 3\r\rx\r", "a.xyz"), "a.xyz:3: too few numbers: 1 of 3");
}

TEST(ReadTable, RowsStayAsTheyAre) {
  CITES("FC-IN-02");
  const Rows rows = rows_of("1 2 -0.0\n1 2 0\n1 2 0\n", "a.xyz");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0], rows[1]);
  EXPECT_EQ(rows[1], rows[2]);
}

TEST(ReadTable, Errors) {
  CITES("FC-IN-01", "FC-IN-05", "FC-FILE-01");
  EXPECT_EQ(refusal("1 2 3\n4 5\n", "a.xyz"), "a.xyz:2: too few numbers: 2 of 3");
  EXPECT_EQ(refusal("1 2 3\n\n# c\n4 # 5 6\n", "a.xyz"), "a.xyz:4: too few numbers: 1 of 3");
  EXPECT_EQ(refusal("1,2,\n", "a.csv"),
            "a.csv:1: two columns, and points have three coordinates: --z 0 makes their z 0");
  // Names of columns are taken above the first row alone, and only these.
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n", "a.csv"), "accepted, 1 rows");
  EXPECT_EQ(refusal("x,y\n1,2,3\n", "a.csv"),
            "a.csv:2: 3 columns, and 2 names above: --columns says by number which are x, y, z");
  EXPECT_EQ(refusal("id,x,y,z\n1,2,3\n", "a.csv"),
            "a.csv:2: 3 columns, and 4 names above: --columns says by number which are x, y, z");
  EXPECT_EQ(refusal("1,2,3\nx,y,z\n", "a.csv"), "a.csv:2: not a number: 'x'");
  EXPECT_EQ(refusal("1,,3,4\n", "a.csv"), "a.csv:1: not a number: ''");
  EXPECT_EQ(refusal(",1,2,3\n", "a.csv", {.format = "table"}), "a.csv:1: not a number: ''");
  EXPECT_EQ(refusal("1,5;2,5;3,5\n", "a.csv"), "a.csv:1: a decimal comma: '1,5'; numbers have a point");
  EXPECT_EQ(refusal("1 abc 3\n", "dir/a.xyz"), "dir/a.xyz:1: not a number: 'abc'");
  EXPECT_EQ(refusal("1 2 1e5x\n", "a.xyz"), "a.xyz:1: not a number: '1e5x'");
  EXPECT_EQ(refusal("1 2 3\n1e999 0 0", "a.xyz"), "a.xyz:2: out of range of a double: '1e999'" + kSkip);
  EXPECT_EQ(refusal("0 0x1p-1075 0", "a.xyz"), "a.xyz:1: not exactly a double: '0x1p-1075'");
  EXPECT_EQ(refusal("0 0 nan", "a.xyz"), "a.xyz:1: not a finite number: 'nan'" + kSkip);
  EXPECT_EQ(refusal("0 -inf 0", "a.xyz"), "a.xyz:1: not a finite number: '-inf'" + kSkip);
}

TEST(ReadPoints, AnEmptyFileIsAnErrorAndNoPointsAreNone) {
  CITES("FC-IN-05");
  for (const char* name : {"a.xyz", "a.off", "a.ply", "a.obj", "-"}) {
    for (const char* text : {"", "\n", " \t\r\n\n", "\xef\xbb\xbf", "\xef\xbb\xbf \n"}) {
      EXPECT_EQ(refusal(text, name), std::string(name) + ": empty");
    }
    EXPECT_EQ(refusal(gzipped(""), name), std::string(name) + ": empty");
  }
  EXPECT_EQ(rows_of("# nothing", "a.xyz"), Rows{});
  EXPECT_EQ(rows_of("# nothing", "a.obj"), Rows{});
  EXPECT_EQ(rows_of("OFF 0 0 0", "a.off"), Rows{});
  EXPECT_EQ(rows_of("ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nproperty int y\nproperty int "
                    "z\nend_header",
                    "a.ply"),
            Rows{});
}

// ---- OFF ----

TEST(ReadOff, Variants) {
  CITES("FC-IN-02", "FC-FILE-02");
  const Rows expected = {{1, 2, 3}, {4, 5, 0.5}};
  EXPECT_EQ(rows_of("OFF\n2 1 0\n1 2 3\n4 5 .5\n3 0 1 1\n", "a.off"), expected);
  EXPECT_EQ(rows_of("OFF 2 0 0\r\n1 2 3\r\n4 5 .5", "a.OFF"), expected);
  EXPECT_EQ(rows_of("# c\nCOFF # c\n\n# c\n2 0 0 # c\n\n1 2 3 255 0 0 255 # c\n4 5 .5 red\n", "a.off"), expected);
  EXPECT_EQ(rows_of("NOFF\n2 0 0\n1 2 3 0 0 1\n4 5 0x.8 nan nan nan\n", "a.off"), expected);
  EXPECT_EQ(rows_of("  CNOFF\n2 0 0\n1 2 3 0 0 1 1 1 1 1\n4 5 0.5 0 0 1 1 1 1 1\ntrailing text\n", "a.off"), expected);
}

TEST(ReadOff, Errors) {
  CITES("FC-IN-01", "FC-IN-05", "FC-FILE-02");
  std::string rows;
  for (int k = 0; k < 57; ++k) rows += std::to_string(k) + " 0 0\n";
  EXPECT_EQ(refusal("OFF\n120 0 0\n" + rows, "a.off"), "a.off: 120 vertices announced, 57 found");
  EXPECT_EQ(refusal("OFF\n1000000000000000000 0 0\n" + rows, "a.off"),
            "a.off: 1000000000000000000 vertices announced, 57 found");
  EXPECT_EQ(refusal("OFF\n57 3 0\n" + rows + "3 0 1 2\n3 1 2 3", "a.off"), "a.off: 3 faces announced, 2 found");
  EXPECT_EQ(refusal("OFF\n57 1000000000000000000 0\n" + rows, "a.off"),
            "a.off: 1000000000000000000 faces announced, 0 found");
  EXPECT_EQ(refusal("OFF\n", "a.off"), "a.off: cut short: no counts after OFF");
  const auto as_off = [](const std::string& text) { return refusal(text, "a.off", {.format = "off"}); };
  EXPECT_EQ(as_off("# only a comment\n"), "a.off: not an OFF file: no keyword OFF");
  EXPECT_EQ(as_off("2 0 0\n1 2 3\n4 5 6\n"), "a.off:1: not an OFF file: begins with '2', not OFF");
  EXPECT_EQ(refusal("OFF BINARY\n", "a.off"), "a.off:1: binary OFF is not supported");
  EXPECT_EQ(refusal("OFF\n2 0\n", "a.off"), "a.off: 2 vertices announced, 0 found");
  EXPECT_EQ(refusal("OFF\n-2 0 0\n", "a.off"), "a.off:2: not a count: '-2'");
  EXPECT_EQ(refusal("OFF 1e18 0 0\n", "a.off"), "a.off:1: not a count: '1e18'");
  EXPECT_EQ(refusal("OFF 99999999999999999999 0 0\n", "a.off"), "a.off:1: not a count: '99999999999999999999'");
  EXPECT_EQ(refusal("OFF\n2 0 0\n1 2 3\n4 5\n", "a.off"), "a.off:4: too few numbers: 2 of 3");
  EXPECT_EQ(refusal("OFF\n2 0 0\n1 2 3\n4 5 nan\n", "a.off"), "a.off:4: not a finite number: 'nan'" + kSkip);
  EXPECT_EQ(refusal("OFF\n2 0 0\n1,2,3\n4 5 6\n", "a.off"), "a.off:3: too few numbers: 1 of 3");
}

// ---- OBJ ----

TEST(ReadObj, OnlyTheVertices) {
  CITES("FC-IN-02", "FC-IN-01", "FC-IN-05");
  const Rows expected = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  EXPECT_EQ(rows_of("# c\nmtllib a.mtl\nv 1 2 3\nvn 0 0 1\nvt 0 0\n  v\t4 5 6 1.0 # c\nf 1 2 x\nv 7 8 9 255 "
                    "0 0\nvery odd",
                    "a.obj"),
            expected);
  EXPECT_EQ(rows_of("o nothing\n", "a.obj", {.format = "obj"}), Rows{});
  EXPECT_EQ(refusal("v 1 2 3\nv 1 2\n", "a.obj"), "a.obj:2: too few numbers: 2 of 3");
  EXPECT_EQ(refusal("v\n", "a.obj"), "a.obj:1: too few numbers: 0 of 3");
  EXPECT_EQ(rows_of("v 1 2 \\\n3\nv 4 \\\n \\\n5 6", "a.obj"), (Rows{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(refusal("o a\nv 1 inf 3\n", "a.obj"), "a.obj:2: not a finite number: 'inf'" + kSkip);
}

// ---- PLY ----

TEST(ReadPly, AsciiWithElementsAndListsAround) {
  CITES("FC-IN-02");
  EXPECT_EQ(rows_of(ply_ascii(), "a.ply"), kPlyRows);
  std::string with_carriage_returns;
  for (const char c : ply_ascii()) with_carriage_returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(rows_of(with_carriage_returns, "a.ply"), kPlyRows);
}

TEST(ReadPly, AsciiFloatsAreTheNearestDoublesOfTheirText) {
  CITES("FC-IN-02");
  const PointFile file = read_points_from(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n"
      "0.1 0x1p-3 1e300\n",
      "a.ply");
  EXPECT_EQ(file.rows, (Rows{{0.1, 0.125, 1e300}}));
  EXPECT_EQ(notes_of(file), Notes{"declared as float, but decimals: taken as the nearest doubles, not floats"});
}

TEST(ReadPly, BinaryInEveryTypeAndBothOrders) {
  CITES("FC-IN-02");
  for (const bool big : {false, true}) {
    for (const char* type : {"char", "int8"}) EXPECT_EQ(rows_of(ply_binary<std::int8_t>(big, type), "a.ply"), kPlyRows);
    for (const char* type : {"short", "int16"}) {
      EXPECT_EQ(rows_of(ply_binary<std::int16_t>(big, type), "a.ply"), kPlyRows);
    }
    for (const char* type : {"int", "int32"})
      EXPECT_EQ(rows_of(ply_binary<std::int32_t>(big, type), "a.ply"), kPlyRows);
    for (const char* type : {"float", "float32"}) EXPECT_EQ(rows_of(ply_binary<float>(big, type), "a.ply"), kPlyRows);
    for (const char* type : {"double", "float64"}) EXPECT_EQ(rows_of(ply_binary<double>(big, type), "a.ply"), kPlyRows);
    const Rows large = {{200, 0, 255}, {128, 1, 2}};
    for (const char* type : {"uchar", "uint8"}) {
      EXPECT_EQ(rows_of(ply_binary<std::uint8_t>(big, type, large), "a.ply"), large);
    }
    const Rows larger = {{60000, 0, 65535}, {32768, 1, 2}};
    for (const char* type : {"ushort", "uint16"}) {
      EXPECT_EQ(rows_of(ply_binary<std::uint16_t>(big, type, larger), "a.ply"), larger);
    }
    const Rows largest = {{4294967295.0, 0, 1}, {2147483648.0, 1, 2}};
    for (const char* type : {"uint", "uint32"}) {
      EXPECT_EQ(rows_of(ply_binary<std::uint32_t>(big, type, largest), "a.ply"), largest);
    }
  }
}

TEST(ReadPly, FloatsAndDoublesAreTakenExactly) {
  CITES("FC-IN-02");
  const Rows rows = {{0.1, 1e-310, -1.0 / 3}, {kLargest, kSmallest, 0}};
  const PointFile doubles = read_points_from(ply_binary<double>(false, "double", rows), "a.ply");
  EXPECT_EQ(doubles.rows, rows);
  EXPECT_EQ(notes_of(doubles), Notes{});
  const Rows single = {{double{0.1F}, double{1e-45F}, double{3e38F}}, {double{-1.0F / 3}, 0, 1}};
  const PointFile floats = read_points_from(ply_binary<float>(true, "float", single), "a.ply");
  EXPECT_EQ(floats.rows, single);
  EXPECT_EQ(notes_of(floats), Notes{"the coordinates are single precision, and are taken exactly as such"});
  EXPECT_EQ(floats.format, "ply");
}

TEST(ReadPly, BinaryCoordinatesMustBeFinite) {
  CITES("FC-IN-01");
  for (const double bad : {kInfinity, -kInfinity, std::nan("")}) {
    EXPECT_EQ(refusal(ply_binary<float>(false, "float", {{0, 0, 0}, {0, bad, 0}}), "a.ply"),
              "a.ply: row 1: not a finite number: y" + kSkip);
    EXPECT_EQ(refusal(ply_binary<double>(true, "double", {{0, 0, bad}, {0, bad, 0}}), "a.ply"),
              "a.ply: row 0: not a finite number: z" + kSkip);
  }
}

TEST(ReadPly, ErrorsInTheHeader) {
  CITES("FC-IN-05");
  const std::string xy = "property float x\nproperty float y\n";
  const std::string start = "ply\nformat ascii 1.0\n";
  const auto message = [](const std::string& text) { return refusal(text, "a.ply", {.format = "ply"}); };
  EXPECT_EQ(message("plyx\n"), "a.ply:1: not a PLY file: does not begin with 'ply'");
  EXPECT_EQ(message("\nply\n"), "a.ply:1: not a PLY file: does not begin with 'ply'");
  EXPECT_EQ(message("ply\nformat ascii 2.0\n"), "a.ply:2: not a known version of PLY: '2.0'");
  EXPECT_EQ(message("ply\nformat binary 1.0\n"), "a.ply:2: not a PLY format: 'binary'");
  EXPECT_EQ(message("ply\nformat ascii\n"), "a.ply:2: incomplete PLY header: no version");
  EXPECT_EQ(message(start + "format ascii 1.0\n"), "a.ply:3: a second format");
  EXPECT_EQ(message("ply\nelement vertex 0\nend_header\n"), "a.ply:3: no format in the PLY header");
  EXPECT_EQ(message(start + "elements vertex 1\n"), "a.ply:3: not a line of a PLY header: 'elements'");
  EXPECT_EQ(message(start + "element vertex\n"), "a.ply:3: incomplete PLY header: no count");
  EXPECT_EQ(message(start + "element vertex -1\n"), "a.ply:3: not a count: '-1'");
  EXPECT_EQ(message(start + "property float x\n"), "a.ply:3: a property before the first element");
  EXPECT_EQ(message("ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty half x\n"),
            "a.ply:4: not a PLY type: 'half'");
  EXPECT_EQ(message(start + "element vertex 1\nproperty list float int x\n"),
            "a.ply:4: the length of a list is not an integer");
  EXPECT_EQ(message(start + "element vertex 1\n" + xy), "a.ply: cut short: no end_header");
  EXPECT_EQ(message(start + "element vertex 1\n" + xy + "end_header\n1 2\n"),
            "a.ply: the vertices have no property 'z'");
  EXPECT_EQ(message(start + "element vertex 1\n" + xy + "property list int int z\nend_header\n1 2\n"),
            "a.ply: the property 'z' of the vertices is a list");
  EXPECT_EQ(message(start + "element vertex 1\n" + xy + xy + "property int z\nend_header\n"),
            "a.ply: the vertices have more than one property 'x'");
  EXPECT_EQ(message(start + "element face 0\nend_header\n"), "a.ply: no element 'vertex'");
  EXPECT_EQ(message(start + "element vertex 0\nelement vertex 0\nend_header\n"),
            "a.ply: more than one element 'vertex'");
}

TEST(ReadPly, ErrorsInTheRows) {
  CITES("FC-IN-01", "FC-IN-05");
  const std::string xyz = "property double x\nproperty double y\nproperty double z\n";
  const auto ascii = [&](const std::string& count, const std::string& rows) {
    return refusal("ply\nformat ascii 1.0\nelement vertex " + count + "\n" + xyz + "end_header\n" + rows, "a.ply");
  };
  EXPECT_EQ(ascii("3", "1 2 3\n4 5 6\n"), "a.ply: 3 vertices announced, 2 found");
  EXPECT_EQ(ascii("1000000000000000000", "1 2 3\n"), "a.ply: 1000000000000000000 vertices announced, 1 found");
  EXPECT_EQ(ascii("2", "1 2 3\n4 5\n"), "a.ply:9: too few values: none for property 'z'");
  EXPECT_EQ(ascii("1", "1 nan 3\n"), "a.ply:8: not a finite number: 'nan'" + kSkip);
  EXPECT_EQ(ascii("1", "1 2 3#\n"), "a.ply:8: not a number: '3#'");
  const std::string face = "element face 2\nproperty list char int i\n";
  const std::string none = "element none 1000000000000000000\n";
  const std::string head = "element vertex 1\n" + xyz + none + face + "end_header\n";
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\n" + head + "1 2 3\n3 0 0 0\n", "a.ply"),
            "a.ply: 2 rows of 'face' announced, 1 found");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\n" + head + "1 2 3\n1 0\n1e300 0 0", "a.ply"),
            "a.ply:13: too few values: none for property 'i'");
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\n" + head + "1 2 3\n1 0\n-1", "a.ply"),
            "a.ply:13: not the length of a list: '-1'");
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  const std::string vertex(24, '\0');
  EXPECT_EQ(refusal(binary + head + vertex + "\xff", "a.ply"), "a.ply: a list of negative length in row 0 of 'face'");
  EXPECT_EQ(refusal(binary + head + vertex + std::string(1, '\0'), "a.ply"),
            "a.ply: 2 rows of 'face' announced, 1 found");
  EXPECT_EQ(
      refusal(binary + "element vertex 1000000000000000000\n" + xyz + "end_header\n" + vertex + vertex + "1", "a.ply"),
      "a.ply: 1000000000000000000 vertices announced, 2 found");
  EXPECT_EQ(refusal(binary + "element a 4611686018427387905\nproperty int i\nelement vertex 1\n" + xyz +
                        "end_header\n" + vertex,
                    "a.ply"),
            "a.ply: 4611686018427387905 rows of 'a' announced, 6 found");
}

// ---- Gzip, names, content, files ----

// A megabyte is read of any file, a hundred times its size of longer ones, and everything where that is asked for.
TEST(ReadPoints, GzipGrowsOnlySoFar) {
  CITES("FC-IN-05");
  std::string rows;
  while (rows.size() < (std::size_t{1} << 20)) rows += "1 2 3\n";
  EXPECT_EQ(rows_of(gzipped(rows.substr(0, 600'000)), "a.gz").size(), 100'000U);
  const std::string small = gzipped(rows + rows);
  ASSERT_LT(small.size(), std::size_t{10'000});
  EXPECT_EQ(refusal(small, "a.gz"),
            "a.gz: gzip data grow to more than 100 times their size, or 4 GB; --unlimited reads them");
  const PointFile all = read_points_from(small, "a.gz", {.unlimited = true});
  EXPECT_EQ(all.rows.size(), 2 * rows.size() / 6);
}

TEST(ReadPoints, GzipOfEveryFormat) {
  CITES("FC-IN-02", "FC-IN-05");
  EXPECT_EQ(rows_of(gzipped("1 2 3"), "a.xyz.gz"), (Rows{{1, 2, 3}}));
  EXPECT_EQ(rows_of(gzipped("1 2 3"), "a.xyz"), (Rows{{1, 2, 3}}));
  EXPECT_EQ(rows_of("1 2 3", "a.xyz.gz"), (Rows{{1, 2, 3}}));
  EXPECT_EQ(rows_of(gzipped("OFF 1 0 0\n1 2 3"), "a.OFF.GZ"), (Rows{{1, 2, 3}}));
  EXPECT_EQ(rows_of(gzipped("v 1 2 3"), "-"), (Rows{{1, 2, 3}}));
  EXPECT_EQ(rows_of(gzipped(ply_binary<float>(true, "float")), "a.ply.gz"), kPlyRows);
  EXPECT_EQ(rows_of(gzipped("1 2 3\n4 5") + gzipped(" 6\n"), "a.gz"), (Rows{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(rows_of(gzipped("1 2 3") + std::string(512, '\0'), "a.gz"), (Rows{{1, 2, 3}}));
  EXPECT_EQ(refusal(gzipped("1 2 3") + "4 5 6", "a.gz"), "a.gz: garbage after the gzip data");
  EXPECT_EQ(refusal(gzipped("1 2 3").substr(0, 15), "a.gz"), "a.gz: gzip data cut short");
  EXPECT_EQ(refusal(gzipped("1 2 3\n4 5"), "a.gz"), "a.gz:2: too few numbers: 2 of 3");
  std::string damaged = gzipped("1 2 3");
  damaged[damaged.size() - 6] ^= 1;
  EXPECT_EQ(refusal(damaged, "a.gz"), "a.gz: gzip data corrupted");
  std::string large;
  for (int k = 0; k < 100000; ++k) large += "0 0 " + std::to_string(k) + "\n";
  EXPECT_EQ(rows_of(gzipped(large), "a.gz"), rows_of(large, "a.xyz"));
}

TEST(ReadPoints, TheContentSaysTheFormatWhateverTheName) {
  CITES("FC-IN-05", "FC-FILE-38");
  const std::pair<std::string, const char*> files[] = {{"1 2 3", "table"},
                                                       {"# v 1 2 3\n1,2,3", "table"},
                                                       {"# only a comment", "table"},
                                                       {"OFF 0 0 0", "off"},
                                                       {"NOFF\n0 0 0", "off"},
                                                       {ply_ascii(), "ply"},
                                                       {ply_binary<double>(false, "double"), "ply"},
                                                       {"# c\n\n  v 1 2 3", "obj"},
                                                       {"mtllib a.mtl\nv 1 2 3", "obj"}};
  for (const auto& [text, format] : files) {
    for (const char* name : {"-", "a", "a.xyz", "a.txt", "a.csv", "a.off", "a.PLY", "a.obj", "a.pdb1.gz", "a.ply/b"}) {
      EXPECT_EQ(read_points_from(text, name).format, format) << name;
    }
  }
  EXPECT_EQ(refusal("word\n1 2 3", "-"), "-: " + kUnknown);
}

// A directory of the test's own, gone when the test is.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "read_points_test_XXXXXX").string();
    path_ = mkdtemp(name.data()) == nullptr ? "" : name;
    EXPECT_FALSE(path_.empty());
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] std::string written(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
    return file(name);
  }

 private:
  std::string path_;
};

std::string refusal_of_path(const std::string& path) {
  try {
    return "accepted, " + std::to_string(read_points(path).rows.size()) + " rows";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

TEST(ReadPoints, Files) {
  CITES("FC-IN-05");
  const TemporaryDirectory directory;
  EXPECT_EQ(read_points(directory.written("a.xyz", "1 2 3\n")).rows, (Rows{{1, 2, 3}}));
  EXPECT_EQ(read_points(directory.written("a.off.gz", gzipped("OFF 1 0 0\n1 2 3\n"))).rows, (Rows{{1, 2, 3}}));
  EXPECT_EQ(read_points(directory.written("a.ply", ply_binary<double>(false, "double"))).rows, kPlyRows);
  const std::string bad = directory.written("bad.obj", "v 1 2 3\nv 1 2 x\n");
  EXPECT_EQ(refusal_of_path(bad), bad + ":2: not a number: 'x'");
  const std::string missing = directory.file("missing.xyz");
  EXPECT_EQ(refusal_of_path(missing), missing + ": cannot open: No such file or directory");
  EXPECT_EQ(refusal_of_path(directory.file("")), directory.file("") + ": cannot open: Is a directory");
  const std::string empty = directory.written("empty.xyz", "");
  EXPECT_EQ(refusal_of_path(empty), empty + ": empty");
}

TEST(ReadPoints, StandardInput) {
  CITES("FC-IN-05");
  const TemporaryDirectory directory;
  const int saved = dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(directory.written("in", "OFF 1 0 0\n1 2 3\n").c_str(), "rb", stdin), nullptr);
  const PointFile file = read_points("-");
  const std::string at_the_end = refusal_of_path("-");
  dup2(saved, STDIN_FILENO);
  close(saved);
  EXPECT_EQ(file.rows, (Rows{{1, 2, 3}}));
  EXPECT_EQ(file.format, "off");
  EXPECT_EQ(at_the_end, "-: empty");
}

}  // namespace
}  // namespace flowcert::read_points_test
