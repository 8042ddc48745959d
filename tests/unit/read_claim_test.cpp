// Reading claims: the variants of each format, what is exact and what is not, and each error with its
// message. Damaged files have a test of their own.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "flowcert/flow_complex.h"
#include "flowcert/reproducibility.h"
#include "tests/cites.h"
#include "tests/unit/claim_file_samples.h"

namespace flowcert::read_claim_test {
namespace {

using Ids = std::vector<PointId>;

std::string text_of(const ClaimedNumber& number) {
  return to_text(number.value) + (number.is_exact ? " exact" : " near");
}

std::string text_of(const ClaimedPosition& position) {
  return text_of(position[0]) + ", " + text_of(position[1]) + ", " + text_of(position[2]);
}

Claim claim_of(const std::string& bytes) { return read_claim_from(bytes, "a"); }

// ---- Our own ----

const std::string kHeader = "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n";

std::string record_refusal(const std::string& record) { return claim_refusal(kHeader + record); }

ClaimedPoint record_of(const std::string& record) {
  const Claim claim = claim_of(kHeader + record);
  return claim.points.empty() ? ClaimedPoint{} : claim.points.front();
}

TEST(ReadExchange, EverythingThatComputeWrites) {
  CITES("FC-OUT-01", "FC-NUM-02", "FC-IN-03", "FC-FLOW-07", "FC-FILE-04", "FC-FILE-06", "FC-FILE-13");
  const std::vector<Point> rows = rows_of_many_kinds();
  const PointSet points(rows);
  const FlowComplex complex(points);
  const StationaryPoints& stationary = complex.stationary();
  const UnstableManifolds& u2 = complex.unstable();
  const Claim claim = claim_of(property::exchange_file(rows));
  EXPECT_EQ(claim.format, "exchange");
  EXPECT_EQ(claim.point_count, rows.size());
  EXPECT_EQ(claim.merged_duplicates, 1U);
  EXPECT_EQ(claim.classes, (std::vector<Ids>{{0, 5}}));
  EXPECT_EQ(claim.input_sha256, coordinates_sha256(points));
  EXPECT_EQ(claim.critical_counts, stationary.critical_counts());
  const RegularCounts& regular = stationary.regular_counts();
  EXPECT_EQ(claim.regular_counts, (std::array<std::size_t, 3>{regular.kind12, regular.kind13, regular.kind23}));
  EXPECT_GT(regular.kind12 + regular.kind23 + regular.kind13, 0U);
  ASSERT_EQ(claim.points.size(), stationary.size());
  std::size_t saddle = 0;
  std::size_t segments = 0;
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    SCOPED_TRACE(i);
    const ClaimedPoint& point = claim.points[i];
    const StationaryIndex index = stationary.index(i);
    const Ids contact(stationary.contact(i).begin(), stationary.contact(i).end());
    const ExactSphere sphere = exact_sphere(points, contact);
    EXPECT_EQ(point.line, i + 2);
    EXPECT_EQ(point.index, index.face_dimension);
    EXPECT_EQ(point.hull_dimension, index.is_critical() ? std::nullopt : std::optional<int>(index.hull_dimension));
    EXPECT_EQ(point.contact, contact);
    ASSERT_TRUE(point.center && point.squared_distance);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ((*point.center)[k].value, sphere.center[k]);
      EXPECT_TRUE((*point.center)[k].is_exact);
    }
    EXPECT_EQ(point.squared_distance->value, sphere.squared_radius);
    EXPECT_TRUE(point.squared_distance->is_exact);
    EXPECT_FALSE(point.distance);
    const bool is_saddle = index == StationaryIndex{2, 2};
    EXPECT_EQ(point.samples.has_value(), (index == StationaryIndex{1, 1}));
    EXPECT_EQ(point.samples ? *point.samples : contact, contact);
    EXPECT_EQ(point.successors.has_value(), is_saddle);
    EXPECT_EQ(point.successors_by_side, is_saddle);
    EXPECT_EQ(point.u2.has_value(), is_saddle);
    if (!is_saddle) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::optional<std::size_t> limit = u2.limit(saddle, side);
      const ClaimedTarget& target = point.successors->at(side);
      EXPECT_EQ(target.is_infinity, !limit);
      if (limit) {
        EXPECT_EQ(target.contact, Ids(stationary.contact(*limit).begin(), stationary.contact(*limit).end()));
      }
      const Orbit orbit = u2.orbit(saddle, side);
      const ClaimedPolyline& polyline = point.u2->at(side);
      ASSERT_EQ(polyline.size(), orbit.segments.size());
      for (std::size_t k = 0; k < polyline.size(); ++k, ++segments) {
        EXPECT_EQ(polyline[k].type, type_text(orbit.segments[k].type));
        ASSERT_TRUE(polyline[k].driver);
        EXPECT_EQ((*polyline[k].driver)[2].value, orbit.segments[k].driver[2]);
        ASSERT_EQ(polyline[k].end.has_value(), orbit.segments[k].end.has_value());
        if (polyline[k].end) {
          EXPECT_EQ((*polyline[k].end)[0].value, (*orbit.segments[k].end)[0]);
        }
      }
    }
    ++saddle;
  }
  EXPECT_GT(saddle, 0U);
  EXPECT_GT(segments, 2 * saddle);
}

TEST(ReadExchange, WhatIsExactAndWhatIsNot) {
  CITES("FC-NUM-02", "FC-IN-02", "FC-FILE-18");
  EXPECT_EQ(text_of(*record_of(R"({"index":2,"center":["1/2","-3","0x1.8p1"]})").center),
            "1/2 exact, -3 exact, 3 exact");
  EXPECT_EQ(text_of(*record_of(R"({"index":2,"center":["0.1","2/4","+1e2"]})").center),
            "1/10 near, 1/2 exact, 100 near");
  EXPECT_EQ(text_of(*record_of(R"({"index":2,"center":[5,-0.1,1e-400]})").center),
            "5 near, -1/10 near, 1/1" + std::string(400, '0') + " near");
  EXPECT_EQ(text_of(*record_of(R"({"index":2,"contact":[1],"squared_distance":"7/3"})").squared_distance), "7/3 exact");
  // The value is the decimal, not the double nearest to it.
  EXPECT_EQ(text_of(*record_of(R"({"index":1,"contact":[1],"squared_distance":0.30000000000000004})").squared_distance),
            "7500000000000001/25000000000000000 near");
  const std::string doubles = R"("center_double":[0.5,0,1],"squared_distance_double":2)";
  EXPECT_EQ(text_of(*record_of(R"({"index":1,"center":["1/3","0","0"],)" + doubles + "}").center),
            "1/3 exact, 0 exact, 0 exact");
  EXPECT_EQ(text_of(*record_of(R"({"index":1,)" + doubles + "}").center), "1/2 near, 0 near, 1 near");
  EXPECT_EQ(text_of(*record_of(R"({"index":1,)" + doubles + "}").squared_distance), "2 near");
  const ClaimedPoint overflown =
      record_of(R"({"index":1,"contact":[0],"center_double":[0,null,0],"squared_distance_double":null})");
  EXPECT_FALSE(overflown.center || overflown.squared_distance);
}

TEST(ReadExchange, UnknownKeysBlankLinesAndLittle) {
  CITES("FC-OUT-01", "FC-FILE-13");
  const Claim claim = claim_of("\xef\xbb\xbf\n " + kHeader + "\r\n" +
                               R"({"extra":{"index":[{}]},"index":[1,3],"contact":[3,2147483646]})" + "\n\n");
  ASSERT_EQ(claim.points.size(), 1U);
  EXPECT_EQ(claim.points[0].line, 4U);
  EXPECT_EQ(claim.points[0].index, 1);
  EXPECT_EQ(claim.points[0].hull_dimension, 3);
  EXPECT_EQ(claim.points[0].contact, (Ids{3, 2147483646}));
  EXPECT_FALSE(claim.points[0].center || claim.points[0].squared_distance || claim.points[0].successors);
  EXPECT_FALSE(claim.point_count || claim.critical_counts || claim.input_sha256);
  EXPECT_TRUE(claim_of(kHeader).points.empty());
}

// The first hundred are kept, and it is known that there are more.
TEST(ReadExchange, ManyUnknownKeys) {
  CITES("FC-CLAIM-01");
  for (const std::size_t count : {std::size_t{100}, std::size_t{101}, std::size_t{5000}}) {
    std::string text = kHeader;
    for (std::size_t k = 0; k < count; ++k) {
      text += "{\"index\":0,\"contact\":[0],\"k" + std::to_string(k) + "\":{\"index\":1}}\n";
    }
    const Claim claim = claim_of(text);
    EXPECT_EQ(claim.points.size(), count);
    EXPECT_EQ(claim.unknown_keys.size(), 100U);
    EXPECT_EQ(claim.has_more_unknown_keys, count > 100);
  }
}

TEST(ReadExchange, ErrorsInTheHeader) {
  CITES("FC-OUT-01", "FC-FILE-03", "FC-FILE-13", "FC-FILE-19");
  const auto header = [](const std::string& more) {
    return claim_refusal(kHeader.substr(0, kHeader.size() - 2) + "," + more + "}");
  };
  EXPECT_EQ(claim_refusal("{\"index\":1}"), "a:1: no key 'format'");
  EXPECT_EQ(claim_refusal("{\"format\":\"flowcert-orbit\",\"format_version\":1}"),
            "a:1: the value of 'format' is not 'flowcert-stationary-points'");
  EXPECT_EQ(claim_refusal("{\"format\":\"flowcert-stationary-points\",\"format_version\":2}"),
            "a:1: the value of 'format_version' is not 1, the only version that is known");
  EXPECT_EQ(header("\"points\":-1"), "a:1: not a count: '-1'");
  EXPECT_EQ(header("\"points\":\"5\""), "a:1: the value of 'points' is not a number");
  EXPECT_EQ(header("\"critical\":[1,2,3]"), "a:1: the value of 'critical' is not an array of 4");
  EXPECT_EQ(header("\"classes\":[[1,2],3]"), "a:1: the value of 'classes' is not an array");
  EXPECT_EQ(header("\"regular_stationary\":{\"1-2\":0,\"2-3\":0}"), "a:1: no key '1-3'");
  EXPECT_EQ(header("\"input_sha256\":\"0123\""),
            "a:1: the value of 'input_sha256' is not 64 lower case hexadecimal digits");
  EXPECT_EQ(claim_refusal(kHeader + kHeader), "a:2: no key 'index'");
}

TEST(ReadExchange, ErrorsInARecord) {
  CITES("FC-OUT-01", "FC-NUM-02", "FC-IN-01");
  EXPECT_EQ(record_refusal("[1]"), "a:2: the value of 'record' is not an object");
  EXPECT_EQ(record_refusal("{\"index\":1"), "a:2: not JSON, in column 11");
  EXPECT_EQ(record_refusal("{\"index\":1}{"), "a:2: not JSON, in column 12");
  EXPECT_EQ(record_refusal("{\"index\":1,\"index\":1}"), "a:2: a key twice: 'index'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"b\":{\"c\":1,\"d\":2,\"c\":1}}"), "a:2: a key twice: 'c'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":" + std::string(1000000, '[')),
            "a:2: nested deeper than 16 levels");
  EXPECT_EQ(record_refusal("{\"index\":4,\"contact\":[1]}"), "a:2: not an index, 0 to 3: '4'");
  EXPECT_EQ(record_refusal("{\"index\":1.0,\"contact\":[1]}"), "a:2: not an index, 0 to 3: '1.0'");
  for (const char* kind : {"[2,1]", "[2,2]", "[0,1]"}) {
    EXPECT_EQ(record_refusal("{\"index\":" + std::string(kind) + ",\"contact\":[1]}"),
              "a:2: the value of 'index' is not a kind: [1,2], [2,3], [1,3]");
  }
  const std::string skeleton =
      "{\"index\":2,\"contact\":[1],\"skeleton\":{\"segments\":[{\"samples\":[0,1],"
      "\"front\":[0,0,0],\"back\":[0,0,0]}],\"orbits\":";
  EXPECT_EQ(record_refusal(skeleton + "[[0],[1]]}}"),
            "a:2: the value of 'orbits' is not chains of the segments: there are not so many");
  EXPECT_EQ(record_refusal("{\"index\":1,\"kind\":\"regular\",\"contact\":[1]}"),
            "a:2: the value of 'kind' is not 'critical', which the index says");
  EXPECT_EQ(record_refusal("{\"index\":1}"), "a:2: neither 'contact' nor 'center'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[]}"),
            "a:2: the value of 'contact' is not a contact set: it is empty");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[-1]}"), "a:2: not an id: '-1'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[1.5]}"), "a:2: not an id: '1.5'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[2147483647]}"), "a:2: an id beyond 2147483646: '2147483647'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[\"1\"]}"), "a:2: the value of 'contact' is not a number");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0]}"), "a:2: the value of 'center' is not an array of 3");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,null]}"),
            "a:2: the value of 'center' is not a rational in a string, or a number");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,1e999]}"), "a:2: out of range of a double: '1e999'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,\"1e999999999\"]}"),
            "a:2: an exponent too large: '1e999999999'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,\"1/0\"]}"), "a:2: the denominator is zero: '1/0'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,\"nan\"]}"), "a:2: not a finite number: 'nan'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,\"1 \"]}"), "a:2: not a number: '1 '");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,\"" + std::string(1000001, '1') + "\"]}"),
            "a:2: a number of too many digits: '" + std::string(40, '1') + "...'");
  EXPECT_EQ(record_refusal("{\"index\":1,\"center\":[0,0,\"0." + std::string(2000, '1') + "\"]}"),
            "a:2: a number of too many digits: '0." + std::string(38, '1') + "...'")
      << "a decimal, of which fewer are taken";
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[1],\"squared_distance\":\"-1/4\"}"),
            "a:2: the value of 'squared_distance' is not 0 or more");
  EXPECT_EQ(record_refusal("{\"index\":1,\"contact\":[1],\"limits\":[null,null]}"),
            "a:2: a key of critical points of index 2 only: 'limits'");
  EXPECT_EQ(record_refusal("{\"index\":[1,2],\"contact\":[1],\"samples\":[1]}"),
            "a:2: a key of critical points of index 1 only: 'samples'");
  EXPECT_EQ(record_refusal("{\"index\":2,\"contact\":[1],\"limits\":[null]}"),
            "a:2: the value of 'limits' is not an array of 2");
  EXPECT_EQ(record_refusal("{\"index\":2,\"contact\":[1],\"u2\":[[],[{\"type\":\"E-E-V\"}]]}"), "a:2: no key 'end'");
}

TEST(ReadExchange, ErrorsInTheWholeComplex) {
  CITES("FC-OUT-01", "FC-NUM-02", "FC-UNST-02");
  const auto saddle = [](const std::string& keys) {
    return record_refusal("{\"index\":2,\"contact\":[1]," + keys + "}");
  };
  const auto direction = [&](const std::string& keys) {
    return saddle("\"lambda\":{\"directions\":[{" + keys + "}],\"arcs\":[]}");
  };
  EXPECT_EQ(direction(R"("limit":null)"), "accepted, 1 points");
  EXPECT_EQ(direction(R"("exit":[0,0,0])"), "a:2: no key 'limit'");
  EXPECT_EQ(direction(R"("limit":null,"exit":[0,0])"), "a:2: the value of 'exit' is not an array of 3");
  EXPECT_EQ(direction(R"("limit":null,"exit_double":[0,0])"), "a:2: the value of 'exit_double' is not an array of 3");
  EXPECT_EQ(direction(R"("limit":null,"exit":[0,0,0],"vector_double":[1,0,0])"),
            "a:2: the value of 'directions' is not a direction: it has an exit and a vector");
  EXPECT_EQ(direction(R"("limit":null,"vector":["0","0","0"])"),
            "a:2: the value of 'directions' is not a direction: the vector is zero");
  EXPECT_EQ(saddle(R"("lambda":{"directions":[]})"), "a:2: no key 'arcs'");
  EXPECT_EQ(saddle(R"("lambda":{"directions":[],"arcs":[1]})"), "a:2: the value of 'arcs' is not an array");
  EXPECT_EQ(saddle(R"("connections":[{"to":null,"orbits":1}])"), "a:2: no key 'families'");
  EXPECT_EQ(saddle(R"("connections":[{"to":null,"orbits":1,"families":-1}])"), "a:2: not a count: '-1'");
  EXPECT_EQ(saddle(R"("volume":"-1/6")"), "a:2: the value of 'volume' is not 0 or more");
  EXPECT_EQ(saddle(R"("volume_double":-1)"), "a:2: the value of 'volume_double' is not 0 or more");
  EXPECT_EQ(saddle(R"("shares":[[0]])"), "a:2: the value of 'shares' is not an array of 2");
  EXPECT_EQ(saddle(R"("shares":[[0,"-1"]])"), "a:2: the value of 'shares' is not 0 or more");
  for (const char* key : {"lambda", "connections"}) {
    EXPECT_EQ(record_refusal("{\"index\":3,\"contact\":[1],\"" + std::string(key) + "\":[]}"),
              "a:2: a key of critical points of index 1 and 2 and of regular stationary points only: '" +
                  std::string(key) + "'");
  }
  EXPECT_EQ(record_refusal(R"({"index":1,"contact":[1],"shares":[]})"),
            "a:2: a key of critical points of index 2 and 3 and of regular stationary points only: 'shares'");
  const auto header = [](const std::string& keys) {
    return claim_refusal(R"({"format":"flowcert-stationary-points","format_version":1,)" + keys + "}");
  };
  EXPECT_EQ(header(R"("morse_smale":1)"), "a:1: the value of 'morse_smale' is not true or false");
  EXPECT_EQ(header(R"("hull_volume":"-1")"), "a:1: the value of 'hull_volume' is not 0 or more");
  EXPECT_EQ(header(R"("volumes":"none")"), "a:1: the value of 'volumes' is not 'exact', 'shares' or 'double'");
}

// ---- CSV ----

TEST(ReadCsvClaim, Variants) {
  CITES("FC-IN-02", "FC-OUT-01", "FC-FILE-15");
  const Claim claim = claim_of(csv_file());
  EXPECT_EQ(claim.format, "csv");
  ASSERT_EQ(claim.points.size(), 4U);
  EXPECT_EQ(claim.points[0].line, 3U);
  EXPECT_EQ(claim.points[0].contact, Ids{3});
  EXPECT_EQ(text_of(*claim.points[0].squared_distance), "0 near");
  EXPECT_EQ(claim.points[1].index, 1);
  EXPECT_EQ(text_of(*claim.points[1].center), "1/2 near, -1/1000 near, 1/4 exact");
  EXPECT_EQ(text_of(*claim.points[1].squared_distance), "1/4 near");
  EXPECT_EQ(claim.points[1].contact, (Ids{0, 1}));
  EXPECT_EQ(text_of(*claim.points[2].center), "1/3 exact, 2 near, 3 near");
  EXPECT_FALSE(claim.points[2].squared_distance || claim.points[2].successors);
  EXPECT_TRUE(claim.points[2].contact.empty());
  EXPECT_FALSE(claim.points[3].squared_distance);
  EXPECT_EQ(claim.points[3].contact, (Ids{0, 1, 2, 4}));
  EXPECT_EQ(text_of(*claim_of("1 5/1 1e300 -0\n").points[0].center),
            "5 exact, 1" + std::string(300, '0') + " near, 0 near");
  EXPECT_TRUE(claim_of("# nothing\n").points.empty());
  EXPECT_TRUE(claim_of("index,x,y,z\n").points.empty());
}

TEST(ReadCsvClaim, WithoutAPosition) {
  CITES("FC-OUT-01", "FC-FILE-15");
  const Claim claim = claim_of("index,x,y,z,squared_distance,contact ids\n1,,,,,4,7\n2, , ,,.5,1,2,3,,\n");
  ASSERT_EQ(claim.points.size(), 2U);
  EXPECT_FALSE(claim.points[0].center || claim.points[0].squared_distance);
  EXPECT_EQ(claim.points[0].index, 1);
  EXPECT_EQ(claim.points[0].contact, (Ids{4, 7}));
  EXPECT_FALSE(claim.points[1].center);
  EXPECT_EQ(text_of(*claim.points[1].squared_distance), "1/2 near");
  EXPECT_EQ(claim.points[1].contact, (Ids{1, 2, 3}));
}

TEST(ReadCsvClaim, Errors) {
  CITES("FC-IN-01", "FC-IN-05", "FC-FILE-15", "FC-FILE-19");
  EXPECT_EQ(claim_refusal("1,2,3\n"), "a:1: too few numbers: 2 of 3 after the index");
  EXPECT_EQ(claim_refusal("1,0,0,0\n-1,0,0,0\n"), "a:2: not an index, 0 to 3: '-1'");
  EXPECT_EQ(claim_refusal("word\n"), "a:1: not an index, 0 to 3: 'word'");
  EXPECT_EQ(claim_refusal("1,0,0,0\nindex,x,y,z\n"), "a:2: not an index, 0 to 3: 'index'");
  EXPECT_EQ(claim_refusal("index,x,z,y\n"), "a:1: no column 'y' where it belongs");
  EXPECT_EQ(claim_refusal("index,x,y,z,distance\n"), "a:1: no column 'squared_distance' where it belongs");
  EXPECT_EQ(claim_refusal("index,x,y\n"), "a:1: no column 'z' where it belongs");
  EXPECT_EQ(claim_refusal("index,x,,\n"), "a:1: no column 'y' where it belongs");
  EXPECT_EQ(claim_refusal("index,x,y,z,,contact\n"), "a:1: no column 'squared_distance' where it belongs");
  EXPECT_EQ(claim_refusal("index,x,y,z,, # more\n0,1,2,3\n"), "accepted, 1 points") << "empty ones at the end";
  EXPECT_EQ(claim_refusal("1,0,,0\n"), "a:1: not a number: ''");
  EXPECT_EQ(claim_refusal("1,,,0,,4,7\n"), "a:1: not a number: ''");
  EXPECT_EQ(claim_refusal("1,0,1,2\n1,,,,\n"), "a:2: neither a position nor contact ids");
  EXPECT_EQ(claim_refusal("1,,,,2,,\n"), "a:1: neither a position nor contact ids");
  EXPECT_EQ(claim_refusal("1,,,\n"), "a:1: too few numbers: 2 of 3 after the index");
  EXPECT_EQ(claim_refusal("1,0,inf,0\n"), "a:1: not a finite number: 'inf'");
  EXPECT_EQ(claim_refusal("1,0,1e701,0\n"), "a:1: an exponent too large: '1e701'");
  EXPECT_EQ(claim_refusal("1,0,1e-99999999999999999999,0\n"), "a:1: an exponent too large: '1e-99999999999999999999'");
  EXPECT_EQ(claim_refusal("1,0," + std::string(2001, '0') + ",0\n"),
            "a:1: a number of too many digits: '" + std::string(40, '0') + "...'");
  EXPECT_EQ(claim_refusal("1,0,0x1p99999,0\n"), "a:1: out of range of a double: '0x1p99999'");
  EXPECT_EQ(claim_refusal("1,0,0,0,-1\n"), "a:1: a negative distance: '-1'");
  EXPECT_EQ(claim_refusal("1,0,0,0,1,4294967296\n"), "a:1: an id beyond 2147483646: '4294967296'");
  EXPECT_EQ(claim_refusal("1,0,0,0,1,2,,3\n"), "a:1: an empty field before '3'");
}

// ---- Giesen and Kuehne ----

TEST(ReadGiesenKuehne, Variants) {
  CITES("FC-OUT-01", "FC-FILE-16");
  const Claim claim = claim_of(giesen_kuehne_file());
  EXPECT_EQ(claim.format, "giesen-kuehne");
  ASSERT_EQ(claim.points.size(), 4U);
  EXPECT_EQ(claim.points[0].line, 2U);
  EXPECT_EQ(claim.points[0].index, 0);
  EXPECT_EQ(claim.points[0].contact, Ids{7});
  EXPECT_EQ(text_of(*claim.points[0].distance), "0 near");
  EXPECT_TRUE(claim.points[0].successors && claim.points[0].successors->empty());
  const ClaimedPoint& saddle = claim.points[1];
  EXPECT_EQ(saddle.index, 2);
  EXPECT_EQ(saddle.contact, (Ids{0, 4, 5}));
  EXPECT_EQ(text_of(*saddle.distance), "707106781186547573/1000000000000000000 near");
  EXPECT_FALSE(saddle.squared_distance || saddle.center || saddle.successors_by_side);
  ASSERT_EQ(saddle.successors->size(), 2U);
  EXPECT_EQ(saddle.successors->at(0).contact, (Ids{0, 2, 4, 5}));
  EXPECT_FALSE(saddle.successors->at(0).is_infinity);
  EXPECT_TRUE(saddle.successors->at(1).is_infinity);
  EXPECT_EQ(claim.points[3].successors->size(), 2U);
  EXPECT_TRUE(claim_of("inf 3").points.empty());
  EXPECT_EQ(claim_of("1|0\r\n2|0\r\ninf 3\r\n").points.size(), 2U);
}

TEST(ReadGiesenKuehne, Errors) {
  CITES("FC-IN-01", "FC-IN-05", "FC-FILE-16", "FC-FILE-19");
  EXPECT_EQ(claim_refusal("inf 2\n"), "a:1: a flow complex of dimension '2', not 3");
  EXPECT_EQ(claim_refusal("inf\n"), "a:1: no dimension after 'inf'");
  EXPECT_EQ(claim_refusal("inf 3 3\n"), "a:1: more than the dimension after 'inf': '3'");
  EXPECT_EQ(claim_refusal("inf 3\n1 | 0\ninf 3\n"), "a:3: a second maximum at infinity");
  EXPECT_EQ(claim_refusal("inf 3\n1 2\n"), "a:2: cut short: no distance");
  EXPECT_EQ(claim_refusal("inf 3\n1 2 |\n"), "a:2: cut short: no distance");
  EXPECT_EQ(claim_refusal("inf 3\n | 1\n"), "a:2: no ids between two bars");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 2 3 4 | 1\n"), "a:2: a critical point of 5 ids, not 1 to 4");
  EXPECT_EQ(claim_refusal("inf 3\n0 -1 | 1\n"), "a:2: not an id: '-1'");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 | 1 2\n"), "a:2: more than one number between two bars: ' 1 2'");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 | | 1\n"), "a:2: nothing between two bars");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 | nan\n"), "a:2: not a finite number: 'nan'");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 | -0.5\n"), "a:2: a negative distance: '-0.5'");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 | 1 | 2 | | 3\n"), "a:2: no ids between two bars");
  EXPECT_EQ(claim_refusal("inf 3\n0 1 | 1 | inf 3\n"), "a:2: more than one number between two bars: ' inf 3'");
}

// ---- VTP ----

TEST(ReadVtp, EveryEncoding) {
  CITES("FC-IN-02", "FC-FILE-17");
  for (const VtpChoices& choices : all_vtp_choices()) {
    SCOPED_TRACE(vtp_file(choices));
    const Claim claim = claim_of(vtp_file(choices));
    EXPECT_EQ(claim.format, "vtp");
    ASSERT_EQ(claim.points.size(), kVtpPoints.size());
    for (std::size_t k = 0; k < kVtpPoints.size(); ++k) {
      const Point& p = kVtpPoints[k].position;
      EXPECT_EQ(claim.points[k].line, k + 1);
      EXPECT_EQ(claim.points[k].index, kVtpPoints[k].type);
      ASSERT_TRUE(claim.points[k].center);
      EXPECT_EQ(text_of(*claim.points[k].center), to_text(Rational(p.x)) + " near, " + to_text(Rational(p.y)) +
                                                      " near, " + to_text(Rational(p.z)) + " near");
      EXPECT_TRUE(claim.points[k].contact.empty());
      EXPECT_FALSE(claim.points[k].squared_distance || claim.points[k].distance);
    }
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

TEST(ReadVtp, PiecesAndTypes) {
  CITES("FC-IN-02", "FC-FILE-17");
  const std::string file = vtp_file({});
  const std::size_t from = file.find("<Piece");
  const std::string piece = file.substr(from, file.find("</PolyData>") - from);
  const Claim twice = claim_of(replaced(file, piece, piece + "<Piece NumberOfPoints=\"0\"/>" + piece));
  ASSERT_EQ(twice.points.size(), 2 * kVtpPoints.size());
  EXPECT_EQ(twice.points.back().line, 2 * kVtpPoints.size());
  EXPECT_TRUE(claim_of("<VTKFile type='PolyData'><PolyData/></VTKFile>").points.empty());
  // Positions may have any type. 2^53 + 1 is no double.
  const std::string integers = bytes_of(std::int64_t{9007199254740993}, false) + bytes_of(std::int64_t{-1}, false) +
                               bytes_of(std::int64_t{0}, false);
  const Claim exact = claim_of(
      "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='1'><Points><DataArray type='Int64' "
      "NumberOfComponents='3' format='binary'>" +
      base64(bytes_of(std::uint32_t{24}, false)) + base64(integers) +
      "</DataArray></Points><PointData><DataArray type='Float32' "
      "Name='CriticalType'>2</DataArray></PointData>"
      "</Piece></PolyData></VTKFile>");
  ASSERT_EQ(exact.points.size(), 1U);
  EXPECT_EQ(exact.points[0].index, 2);
  EXPECT_EQ(text_of(*exact.points[0].center), "9007199254740993 near, -1 near, 0 near");
}

TEST(ReadVtp, ErrorsInTheDocument) {
  CITES("FC-IN-05", "FC-FILE-17", "FC-FILE-19");
  const std::string file = vtp_file({});
  const auto with = [&](const std::string& from, const std::string& to) {
    return claim_refusal(replaced(file, from, to));
  };
  EXPECT_EQ(claim_refusal("<html></html>"), "a:1: not a VTP file: it begins with 'html'");
  EXPECT_EQ(with("\"PolyData\"", "\"UnstructuredGrid\""), "a:2: not a VTP file: its type is 'UnstructuredGrid'");
  EXPECT_EQ(with("</Piece>", "</Peace>"), "a:26: not XML: mismatched tag");
  EXPECT_EQ(claim_refusal(file.substr(0, 60)), "a:2: not XML: unclosed token");
  EXPECT_EQ(claim_refusal("<!DOCTYPE a [<!ENTITY b 'c'>]><a/>"), "a:1: a VTP file has no document type");
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += "<a>";
  EXPECT_EQ(with("<CellData>", deep), "a:11: nested deeper than 32 levels");
  EXPECT_EQ(with("LittleEndian", "MiddleEndian"), "a:2: not a byte order: 'MiddleEndian'");
  EXPECT_EQ(with("UInt32", "UInt16"), "a:2: not a header type: 'UInt16'");
  EXPECT_EQ(with("NumberOfPoints=\"5\"", ""), "a:4: no attribute 'NumberOfPoints'");
  EXPECT_EQ(with("NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\""), "a:4: not a count: '-5'");
  EXPECT_EQ(with("\"CriticalType\" format=\"ascii\">\n", "\"Type\" format=\"ascii\">\n"),
            "a:4: no array 'CriticalType' in the point data");
  EXPECT_EQ(with("NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""), "a:12: positions are not of 3 components");
  EXPECT_EQ(with("<Points>", "<Dots>").substr(0, 13), "a:25: not XML");
  EXPECT_EQ(with("type=\"Float64\"", "type=\"String\""), "a:12: not a type of numbers: 'String'");
  EXPECT_EQ(with("format=\"ascii\">\n   0", "format=\"hex\">\n   0"), "a:7: not a format of an array: 'hex'");
}

TEST(ReadVtp, ErrorsInTheArrays) {
  CITES("FC-IN-01", "FC-IN-05");
  const std::string ascii = vtp_file({});
  EXPECT_EQ(claim_refusal(replaced(ascii, "0 1 2 3 0", "0 1 2 3")),
            "a:7: an array of 4 numbers where the number of points asks for 5");
  EXPECT_EQ(claim_refusal(replaced(ascii, "0 1 2 3 0", "0 1 2 4 0")),
            "a:7: point 3 of the piece: its CriticalType is none of 0 to 3");
  EXPECT_EQ(claim_refusal(replaced(ascii, "0 1 2 3 0", "0 1 2 x 0")), "a:7: not a number: 'x'");
  EXPECT_EQ(claim_refusal(replaced(ascii, "-1.25", "nan")), "a:12: not a finite number: 'nan'");
  EXPECT_EQ(claim_refusal(replaced(ascii, "NumberOfPoints=\"5\"", "NumberOfPoints=\"1000000000000000000\"")),
            "a:12: more points than any file holds: 1000000000000000000");
  EXPECT_EQ(claim_refusal(vtp_file({.encoding = "base64"}, {{0, {0, 1e308 * 10, 0}}})),
            "a:12: not a finite number: value 1");
  const auto binary = [](const VtpChoices& choices, const std::string& from, const std::string& to) {
    return claim_refusal(replaced(vtp_file(choices), from, to));
  };
  const std::string points = "NumberOfPoints=\"5\"";
  for (const char* encoding : {"base64", "appended base64", "appended raw"}) {
    const VtpChoices plain = {.encoding = encoding};
    const VtpChoices compressed = {.encoding = encoding, .compressed = true};
    EXPECT_EQ(binary(plain, points, "NumberOfPoints=\"6\"").substr(0, 3), "a:1");
    EXPECT_NE(binary(plain, points, "NumberOfPoints=\"6\"")
                  .find("an array of 120 bytes where the number of "
                        "points asks for 144"),
              std::string::npos);
    EXPECT_NE(binary(compressed, points, "NumberOfPoints=\"100000000000000\"")
                  .find("an array of 120 bytes where the number of points asks for 2400000000000000"),
              std::string::npos);
    EXPECT_NE(binary(compressed, points, "NumberOfPoints=\"4\"")
                  .find("more compressed data than the number of points asks for"),
              std::string::npos);
    EXPECT_NE(binary(compressed, "vtkZLib", "vtkLZ4").find("compressed by 'vtkLZ4DataCompressor', not by"),
              std::string::npos);
  }
  EXPECT_EQ(binary({.encoding = "base64"}, "AAAAAA", "AAA!AA"), "a:7: not base64: '!'");
  EXPECT_EQ(binary({.encoding = "base64"}, "\n<InformationKey", "AAAA\n<InformationKey"),
            "a:7: more binary data than announced");
  EXPECT_EQ(binary({.encoding = "appended raw"}, "offset=\"24\"", "offset=\"9999\""),
            "a:10: an offset beyond the appended data");
  EXPECT_EQ(binary({.encoding = "appended raw"}, "offset=\"24\"", "offset=\"148\""),
            "a:10: cut short in the binary data");
  EXPECT_EQ(binary({.encoding = "appended raw"}, " _", " "), "a: appended data without its underscore");
  EXPECT_EQ(binary({.encoding = "appended raw"}, "</VTKFile>", ""), "a: cut short in the appended data");
}

TEST(ReadVtp, OnePartOfTheAppendedDataIsNotReadTwice) {
  CITES("FC-IN-05");
  // Thousands of small pieces that point to one large array would be far more points than bytes.
  const std::string file = vtp_file({.encoding = "appended raw"});
  const std::size_t from = file.find("<Piece");
  const std::string piece = file.substr(from, file.find("</PolyData>") - from);
  EXPECT_EQ(claim_refusal(replaced(file, piece, piece + piece)), "a:18: arrays that share appended data");
}

// ---- Recognition, gzip, files ----

TEST(ReadClaim, RecognisedByContent) {
  CITES("FC-IN-05", "FC-FILE-12");
  const auto format = [](const std::string& text) { return claim_of(text).format; };
  EXPECT_EQ(format(" \n" + kHeader), "exchange");
  EXPECT_EQ(format(vtp_file({}).substr(21)), "vtp");
  EXPECT_EQ(format("\n\n7 | 0\n"), "giesen-kuehne");
  EXPECT_EQ(format("  inf 3\n"), "giesen-kuehne");
  EXPECT_EQ(format("# a | b\n0 1 2 3\n"), "csv");
  EXPECT_EQ(format(gzipped(giesen_kuehne_file())), "giesen-kuehne");
  EXPECT_EQ(format(gzipped("\xef\xbb\xbf" + kHeader)), "exchange");
  for (const char* empty : {"", "\n", " \t\r\n", "\xef\xbb\xbf\n"}) {
    EXPECT_EQ(claim_refusal(empty), "a: empty");
    EXPECT_EQ(claim_refusal(gzipped(empty)), "a: empty");
  }
  EXPECT_EQ(claim_refusal(gzipped(kHeader).substr(0, 20)), "a: gzip data cut short");
}

// Four rows. Each claim names row 3, which exists, or row 4, in one place of a record.
TEST(ReadClaim, NamesRowsOfTheInput) {
  CITES("FC-IN-03", "FC-OUT-01", "FC-FILE-18");
  const PointSet points(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const auto complaint = [&](std::string record, const std::string& row) -> std::string {
    record.replace(record.find('#'), 1, row);
    try {
      require_rows(claim_of(kHeader + record), points, "a");
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string saddle = "{\"index\":2,\"contact\":[0,1,2],";
  const std::string piece = "\"front\":[0,0,0],\"back\":[0,0,0]";
  for (const std::string& record :
       {std::string("{\"index\":2,\"contact\":[0,1,#]}"),
        std::string("{\"index\":1,\"contact\":[0,1],\"samples\":[0,#]}"), saddle + "\"limits\":[null,[0,1,2,#]]}",
        saddle + "\"stable\":{\"walk\":[0,1,#]}}", saddle + "\"stable\":{\"boundary\":[[0,1],[1,#]]}}",
        saddle + "\"skeleton\":{\"segments\":[{\"samples\":[0,#]," + piece + "}]}}",
        saddle + "\"skeleton\":{\"segments\":[{\"samples\":[0,1]," + piece + ",\"front_contact\":[0,1,#]}]}}",
        saddle + "\"skeleton\":{\"segments\":[{\"samples\":[0,1]," + piece + ",\"back_contact\":[0,#]}]}}",
        saddle + "\"skeleton\":{\"segments\":[],\"intervals\":[{\"polygon\":[0,1,#]," + piece + "}]}}",
        saddle + "\"lambda\":{\"directions\":[{\"limit\":[0,#]}],\"arcs\":[]}}",
        saddle + "\"lambda\":{\"directions\":[],\"arcs\":[[0,#]]}}",
        saddle + "\"connections\":[{\"to\":[0,#],\"orbits\":1,\"families\":0}]}", saddle + "\"shares\":[[#,\"1/6\"]]}",
        saddle + "\"skeleton\":{\"segments\":[],\"sectors\":[{\"samples\":[0,#],"
                 "\"corners\":[[0,0,0],[1,0,0],[0,1,0]]}]}}"}) {
    EXPECT_EQ(complaint(record, "3"), "accepted") << record;
    EXPECT_EQ(complaint(record, "4"), "a:2: there is no point 4; the ids are 0 to 3") << record;
  }
}

TEST(ReadClaim, FilesAndStandardInput) {
  CITES("FC-IN-05");
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("read_claim_test_" + std::to_string(getpid()));
  std::ofstream(path, std::ios::binary) << gzipped(csv_file());
  EXPECT_EQ(read_claim(path.string()).points.size(), 4U);
  const int saved = dup(STDIN_FILENO);
  ASSERT_NE(std::freopen(path.c_str(), "rb", stdin), nullptr);
  EXPECT_EQ(read_claim("-").format, "csv");
  dup2(saved, STDIN_FILENO);
  close(saved);
  std::filesystem::remove(path);
  const auto message = [](const std::string& name) -> std::string {
    try {
      (void)read_claim(name);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message(path.string()), path.string() + ": cannot open: No such file or directory");
  EXPECT_EQ(message("/"), "/: cannot open: Is a directory");
}

}  // namespace
}  // namespace flowcert::read_claim_test
