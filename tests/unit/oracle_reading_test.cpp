// The oracle's own parsers: points as tables and OBJ, rationals, records. Each error is met once, with its line.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"

namespace oracle_reading_test {
namespace {

using oracle::PointFormat;
using oracle::Rational;
using Rows = std::vector<std::array<double, 3>>;

constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();
constexpr double kGreatest = std::numeric_limits<double>::max();

Rows points(const std::string& text, PointFormat format = PointFormat::kTable) {
  std::istringstream in(text);
  return oracle::read_points(in, "f", format);
}

// The message of the error that reading must end in.
template <typename Read>
std::string error(const Read& read) {
  try {
    read();
  } catch (const oracle::UnusableInput& unusable) {
    return unusable.what();
  }
  return "read without an error";
}

std::string points_error(const std::string& text, PointFormat format = PointFormat::kTable) {
  return error([&] { points(text, format); });
}

TEST(OracleReadTable, SeparatorsCommentsAndNames) {
  CITES("FC-IN-02", "FC-FILE-01");
  const Rows expected = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  const std::string rows = "1 2 3\n\n\t4,5, 6\r\n7\t8 9#x\n10,11,12";
  for (const std::string above : {"# header\n", "", "x y z\n", "X,Y,Z\n", "# x, y, z\n", "# zyx\n"}) {
    EXPECT_EQ(points(above + rows), expected) << above;
  }
}

// What flowcert may read in another way, or refuses.
TEST(OracleReadTable, OtherColumnsAreRefused) {
  CITES("FC-IN-05", "FC-FILE-01");
  EXPECT_EQ(points_error("7644 1.5 2 3\n"), "f:1: three columns expected, found 4");
  EXPECT_EQ(points_error("#   POINT3D_ID, X, Y, Z, R\n1 2 3\n"),
            "f:1: columns are named; flowcert-oracle reads x, y, z alone");
  EXPECT_EQ(points_error("# z y x\n1 2 3\n"), "f:1: columns are named; flowcert-oracle reads x, y, z alone");
  EXPECT_EQ(points_error("id,x,y,z\n1,2,3,4\n"), "f:1: columns are named; flowcert-oracle reads x, y, z alone");
  EXPECT_EQ(points_error("1 2 3\nx y z\n"), "f:2: 'x' is not a number");
  EXPECT_EQ(points_error("1,5 2\n"), "f:1: commas part some columns, and blanks others");
  EXPECT_EQ(points_error("1;2;3\n"), "f:1: three columns expected, found 1");
  EXPECT_EQ(points_error("3\na comment\nC 0 0 0\n"), "f:1: three columns expected, found 1");
  EXPECT_EQ(points_error("VERSION 0.7\n"), "f:1: three columns expected, found 2");
}

TEST(OracleReadTable, NumbersAreTheNearestDoubles) {
  CITES("FC-IN-02");
  // 2^53 + 1 is a tie, which goes to the even 2^53. The last digit of the second number breaks the tie.
  EXPECT_EQ(points("9007199254740993 9007199254740993.0000000000000000001 0.1"),
            (Rows{{9007199254740992.0, 9007199254740994.0, 0.1}}));
  EXPECT_EQ(points("0x1.8p1 -0x.8p-1073 0x10"), (Rows{{3, -kSubnormal, 16}}));
  EXPECT_EQ(points("1e-400 5e-324 -1.7976931348623157e308"), (Rows{{0, kSubnormal, -kGreatest}}));
  EXPECT_EQ(points("-0.0 +1 .5"), (Rows{{0, 1, 0.5}}));
}

TEST(OracleReadTable, HexadecimalFloatsAreExactOrAnError) {
  CITES("FC-IN-02");
  EXPECT_EQ(points("0x1.fffffffffffffp1023 -0x1p-1074 0x1.00000000000000000p0"), (Rows{{kGreatest, -kSubnormal, 1}}));
  EXPECT_EQ(points("-0x0p-9999 0X.0000001P+28 0x20000000000002p-1\n"), (Rows{{0, 1, 0x1.0000000000001p52}}));
  for (const std::string word : {"0x1.00000000000001p0", "-0x1.00000000000008p0", "0x20000000000001.8", "0x1p-1075",
                                 "0x1.8p-1074", "0x0.fffffffffffffcp-1022", "-0x1p-99999", "0X1.00000000000001P0"}) {
    EXPECT_EQ(points_error("0 0 0\n1 " + word + " 3\n"), "f:2: '" + word + "' is not exactly a double");
  }
  EXPECT_EQ(points_error("0x1p1024 0 0\n"), "f:1: '0x1p1024' is not a finite double");
  EXPECT_EQ(points_error("0x 0 0\n"), "f:1: '0x' is not a number");
}

TEST(OracleReadTable, ErrorsNameTheLine) {
  CITES("FC-IN-05", "FC-IN-01");
  EXPECT_EQ(points_error("1 2 3\n4 5\n"), "f:2: three columns expected, found 2");
  EXPECT_EQ(points_error("1 2 3\n\n4 5 # 6\n"), "f:3: three columns expected, found 2");
  EXPECT_EQ(points_error("1 2 3\n4 x 6\n"), "f:2: 'x' is not a number");
  EXPECT_EQ(points_error("1 2 3.0.0\n"), "f:1: '3.0.0' is not a number");
  EXPECT_EQ(points_error(std::string("1 2 3\0\n", 7)).substr(0, 7),
            "f:1: '3");  // the zero byte ends what()
  EXPECT_EQ(points_error("\n1 nan 3\n"), "f:2: 'nan' is not a finite double");
  EXPECT_EQ(points_error("1 2 -inf\n"), "f:1: '-inf' is not a finite double");
  EXPECT_EQ(points_error("1 1e309 3\n"), "f:1: '1e309' is not a finite double");
  EXPECT_EQ(points_error("1.7976931348623159e308 0 0\n"), "f:1: '1.7976931348623159e308' is not a finite double");
}

TEST(OracleReadTable, MissingAndEmptyFiles) {
  CITES("FC-IN-05");
  EXPECT_EQ(points_error(""), "f: empty");
  EXPECT_EQ(points_error(" \n\t\r\n"), "f: empty");
  EXPECT_EQ(error([] { oracle::read_point_file("no/such.xyz"); }), "no/such.xyz: cannot be opened");
  EXPECT_EQ(error([] { oracle::read_point_file("/"); }), "/: cannot be read");
}

TEST(OracleReadObj, VerticesOnly) {
  CITES("FC-IN-05");
  const std::string text = "# v 9 9 9\no name\nv 1 2 3 1.0\nvn 0 0 1\nvt x\nf 1 1 1\nv\t4 5 6\n";
  EXPECT_EQ(points(text, PointFormat::kObj), (Rows{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(points_error("vn 1 2 3\nv 1 2\n", PointFormat::kObj), "f:2: three numbers expected, found 2");
  EXPECT_EQ(points_error("v 1 2 z\n", PointFormat::kObj), "f:1: 'z' is not a number");
  // Only XYZ has commas.
  EXPECT_EQ(points_error("v 1,2,3\n", PointFormat::kObj), "f:1: three numbers expected, found 1");
  EXPECT_EQ(points_error("v,1,2,3\n", PointFormat::kObj), "f:1: flowcert-oracle does not know 'v,1,2,3' in OBJ");
  EXPECT_EQ(points_error("1 2 3\nv 1 2 3\n", PointFormat::kObj), "f:1: flowcert-oracle does not know '1' in OBJ");
  EXPECT_EQ(points_error("v 1 2 3\nf 1 1 \\\nv 1 2 3\n", PointFormat::kObj),
            "f:2: flowcert-oracle reads no line that goes on");
  EXPECT_EQ(points_error("o name\n", PointFormat::kObj), "f: no line begins with v");
}

TEST(OracleRationals, CanonicalOrNot) {
  CITES("FC-NUM-02");
  for (const char* text : {"0", "7", "-7", "1/2", "-3/4", "123456789012345678901234567891/2"}) {
    const auto read = oracle::parse_rational(text);
    ASSERT_TRUE(read) << text;
    EXPECT_TRUE(read->canonical) << text;
    EXPECT_EQ(read->value.str(), text);
  }
  const std::pair<const char*, const char*> others[] = {{"2/4", "1/2"},    {"-0", "0"},     {"007", "7"},
                                                        {"010/3", "10/3"}, {"3/1", "3"},    {"1/-2", "-1/2"},
                                                        {"0/5", "0"},      {"-2/-4", "1/2"}};
  for (const auto& [text, value] : others) {
    const auto read = oracle::parse_rational(text);
    ASSERT_TRUE(read) << text;
    EXPECT_FALSE(read->canonical) << text;
    EXPECT_EQ(read->value.str(), value);
  }
}

TEST(OracleRationals, WhatIsNone) {
  CITES("FC-NUM-02");
  for (const char* text : {"", "-", "1/0", "0/0", "1/", "/2", "1/2/3", "1.5", "+1", " 1", "1 ", "0x10", "1e3", "--1"}) {
    EXPECT_FALSE(oracle::parse_rational(text)) << text;
  }
}

TEST(OracleNearestDouble, TiesGoToEven) {
  CITES("FC-NUM-02");
  const Rational ulp = Rational(std::ldexp(1.0, -52));  // of 1
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(oracle::is_nearest_double(1.0, 1 + ulp / 2));
  EXPECT_FALSE(oracle::is_nearest_double(next, 1 + ulp / 2));
  EXPECT_FALSE(oracle::is_nearest_double(1.0, 1 + ulp * 5001 / 10000));
  EXPECT_TRUE(oracle::is_nearest_double(next, 1 + ulp * 5001 / 10000));
  EXPECT_TRUE(oracle::is_nearest_double(1.0, 1 - ulp / 4));  // the ulp below 1 is half as large
  EXPECT_FALSE(oracle::is_nearest_double(1.0, 1 - ulp / 3));
  EXPECT_TRUE(oracle::is_nearest_double(0.0, Rational(kSubnormal) / 2));
  EXPECT_FALSE(oracle::is_nearest_double(kSubnormal, Rational(kSubnormal) / 2));
  EXPECT_TRUE(oracle::is_nearest_double(kSubnormal, Rational(kSubnormal) * 3 / 4));
}

TEST(OracleNearestDouble, OverflowBeginsHalfWayTo2To1024) {
  CITES("FC-NUM-02");
  const Rational half_ulp = Rational(std::ldexp(1.0, 970));
  EXPECT_TRUE(oracle::is_nearest_double(kGreatest, Rational(kGreatest) + half_ulp - 1));
  EXPECT_FALSE(oracle::is_nearest_double(kGreatest, Rational(kGreatest) + half_ulp));
  EXPECT_FALSE(oracle::is_nearest_double(-kGreatest, -Rational(kGreatest) - half_ulp));
  EXPECT_FALSE(oracle::is_nearest_double(std::numeric_limits<double>::infinity(), Rational(kGreatest) * 2));
}

const std::string kHeader =
    R"({"format":"flowcert-stationary-points","format_version":1,"points":3,"merged_duplicates":1,)"
    R"("critical":[2,1,0,0],"regular_stationary":{"1-2":0,"1-3":0,"2-3":0}})";

TEST(OracleRecords, Header) {
  CITES("FC-IN-03");
  std::istringstream in(kHeader + "\na\nb\nc\n");
  const oracle::RecordFile file = oracle::read_record_file(in, "r");
  EXPECT_EQ(file.points, 3U);
  EXPECT_EQ(file.merged_duplicates, 1U);
  EXPECT_EQ(file.records, (std::vector<std::string>{"a", "b", "c"}));
}

TEST(OracleRecords, UnusableFiles) {
  CITES("FC-IN-05");
  const auto file_error = [](const std::string& text) {
    return error([&] {
      std::istringstream in(text);
      oracle::read_record_file(in, "r");
    });
  };
  EXPECT_EQ(file_error(""), "r: empty or unreadable");
  EXPECT_EQ(file_error(kHeader + "\na\nb\n"), "r: the header announces 3 records, the file has 2");
  EXPECT_EQ(file_error("{").substr(0, 5), "r:1: ");
  EXPECT_EQ(file_error(R"({"format":"flowcert-summary"})"),
            "r:1: the format is 'flowcert-summary', not a list of stationary points");
  EXPECT_EQ(file_error(R"({"format":"flowcert-stationary-points","format_version":2})"), "r:1: unknown format_version");
}

std::string replaced(std::string line, const std::string& from, const std::string& to) {
  return line.replace(line.find(from), from.size(), to);
}

// A record with one part replaced.
std::string record(const std::string& from = "", const std::string& to = "") {
  const std::string line =
      R"({"index":1,"kind":"critical","contact":[0,2],"center":["1/2","0","-3"],"squared_distance":"1/4",)"
      R"("center_double":[0.5,0.0,-3.0],"squared_distance_double":0.25})";
  return from.empty() ? line : replaced(line, from, to);
}

TEST(OracleRecords, ARecord) {
  CITES("FC-OUT-01");
  const oracle::Record read = oracle::parse_record(record(), "r:2: ");
  EXPECT_FALSE(read.fault);
  EXPECT_EQ(read.claim, (oracle::StationaryPoint{{Rational(1) / 2, 0, -3}, Rational(1) / 4, {0, 2}, 1, 1}));
  const oracle::Record regular =
      oracle::parse_record(record(R"(1,"kind":"critical")", R"([1,3],"kind":"regular")"), "");
  EXPECT_FALSE(regular.fault);
  EXPECT_EQ(regular.claim.face_dimension, 1);
  EXPECT_EQ(regular.claim.hull_dimension, 3);
}

TEST(OracleRecords, FindingsInTheWriting) {
  CITES("FC-NUM-02", "FC-CRIT-03");
  const auto clause = [](const std::string& line) {
    const oracle::Record read = oracle::parse_record(line, "");
    return read.fault ? read.fault->clause : "right";
  };
  EXPECT_EQ(clause(record("1/4", "2/8")), "FC-NUM-02");
  EXPECT_EQ(clause(record("1/2", "2/4")), "FC-NUM-02");
  EXPECT_EQ(clause(record("0.25", "0.25000000000000006")), "FC-NUM-02");
  EXPECT_EQ(clause(record("0.25", "null")), "FC-NUM-02");
  EXPECT_EQ(clause(record("-3.0", "-3.0000000000000004")), "FC-NUM-02");
  EXPECT_EQ(clause(record("critical", "regular")), "FC-CRIT-03");
  EXPECT_EQ(clause(record(R"("index":1)", R"("index":[1,2])")), "FC-CRIT-03");
  EXPECT_EQ(clause(record(R"(1,"kind":"critical")", R"([2,2],"kind":"regular")")), "FC-CRIT-03");
  // Null is right beyond the range of doubles, and nothing else is.
  const std::string huge = "1" + std::string(400, '0');
  const std::string line = record("1/4", huge);
  EXPECT_EQ(clause(line), "FC-NUM-02");
  const std::string with_null = replaced(line, "0.25", "null");
  EXPECT_EQ(clause(with_null), "right");
  // That range ends half way between the greatest double and 2^1024, and the tie overflows.
  const oracle::Integer end = (oracle::Integer(1) << 1024) - (oracle::Integer(1) << 970);
  EXPECT_EQ(clause(replaced(with_null, huge, end.str())), "right");
  EXPECT_EQ(clause(replaced(with_null, huge, oracle::Integer(end - 1).str())), "FC-NUM-02");
}

TEST(OracleRecords, UnusableRecords) {
  CITES("FC-NUM-02");
  const auto record_error = [](const std::string& line) { return error([&] { oracle::parse_record(line, "r:2: "); }); };
  EXPECT_EQ(record_error(record("1/4", "1/0")), "r:2: '1/0' is not a rational");
  EXPECT_EQ(record_error(record("[0,2]", "[0,-2]")), "r:2: a point id or an index is no natural number");
  EXPECT_EQ(record_error(record("[0,2]", "[0,2.5]")), "r:2: a point id or an index is no natural number");
  EXPECT_EQ(record_error(record("\"index\":1", "\"index\":4")), "r:2: an index is greater than 3");
  EXPECT_EQ(record_error(record("\"index\":1", "\"index\":[1]")), "r:2: a point id or an index is no natural number");
  EXPECT_EQ(record_error(record(R"(,"-3"])", "]")), "r:2: center is not three rationals");
  for (const std::string& line : {record("contact", "contacts"), record("0.25", "1e999"), record("}", ""),
                                  record("\"1/4\"", "0.25"), std::string("[]"), std::string(100000, '[')}) {
    EXPECT_EQ(record_error(line).substr(0, 6), "r:2: [") << line.substr(0, 200);
  }
}

}  // namespace
}  // namespace oracle_reading_test
