// spec/schemas/exchange.schema.json: it takes what compute writes, and says what our reader says of single
// lines.
#include <nlohmann/json.hpp>

#include "tests/cites.h"
#include "tests/json_schema.h"
#include "tests/unit/claim_file_samples.h"

namespace flowcert::exchange_schema_test {
namespace {

const std::string kHeader = "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n";

class ExchangeSchema {
 public:
  [[nodiscard]] bool accepts(const std::string& line) const {
    const nlohmann::json value = nlohmann::json::parse(line, nullptr, false);
    return !value.is_discarded() && schema_.violations(value).empty();
  }

 private:
  flowcert_tests::JsonSchema schema_{FLOWCERT_EXCHANGE_SCHEMA};
};

std::vector<std::vector<Point>> inputs() {
  return {rows_of_many_kinds(),
          {},
          {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}},
          {{1e308, 0, 0}, {-1e308, 1e-300, 0}, {0, 3, 1e300}, {0, -1e308, 5}}};
}

TEST(ExchangeSchema, TakesWhatComputeWrites) {
  CITES("FC-OUT-01", "FC-NUM-02");
  const ExchangeSchema schema;
  for (const std::vector<Point>& rows : inputs()) {
    std::istringstream lines(property::exchange_file(rows));
    std::string line;
    while (std::getline(lines, line)) EXPECT_TRUE(schema.accepts(line)) << line;
  }
}

TEST(ExchangeSchema, TakesTheWholeComplex) {
  CITES("FC-UNST-02", "FC-VOL-01", "FC-NUM-02");
  const ExchangeSchema schema;
  for (const std::vector<Point>& rows : inputs()) {
    for (const auto centers : {WrittenCenters::kExact, WrittenCenters::kDouble, WrittenCenters::kNone}) {
      for (const auto volumes : {WrittenVolumes::kDouble, WrittenVolumes::kShares, WrittenVolumes::kExact}) {
        std::istringstream lines(property::exchange_file(
            rows, {.u2 = true, .s2 = true, .centers = centers, .all = true, .volumes = volumes, .sheets = true}));
        std::string line;
        while (std::getline(lines, line)) EXPECT_TRUE(schema.accepts(line)) << line;
      }
    }
  }
}

TEST(ExchangeSchema, SaysWhatTheWholeComplexMayHave) {
  CITES("FC-UNST-02", "FC-VOL-01");
  const ExchangeSchema schema;
  for (const char* record :
       {R"({"index":1,"contact":[1],"lambda":{"directions":[],"arcs":[null]},"connections":[]})",
        R"({"index":[1,3],"contact":[1],"lambda":{"directions":[{"limit":[0]},{"limit":null}],"arcs":[[0,1]]}})",
        R"({"index":2,"contact":[1],"lambda":{"directions":[{"vector":["1","0","-1/2"],"limit":null}],"arcs":[]}})",
        R"({"index":2,"contact":[1],"lambda":{"directions":[{"exit_double":[1,2,null],"limit":null}],"arcs":[]}})",
        R"({"index":2,"contact":[1],"connections":[{"to":null,"orbits":1,"families":0}]})",
        R"({"index":3,"contact":[1],"volume":"1/3","volume_double":null,"shares":[[0,"1/6"],[7,"1/6"]]})",
        R"({"index":3,"contact":[1],"shares_double":[[0,0.5],[7,null]]})"}) {
    EXPECT_TRUE(schema.accepts(record)) << record;
    EXPECT_EQ(claim_refusal(kHeader + record), "accepted, 1 points") << record;
  }
  for (
      const char* record :
      {R"({"index":0,"contact":[1],"lambda":{"directions":[],"arcs":[null]}})",
       R"({"index":3,"contact":[1],"connections":[]})", R"({"index":1,"contact":[1],"lambda":{"directions":[]}})",
       R"({"index":1,"contact":[1],"lambda":{"directions":[{}],"arcs":[null]}})",
       R"({"index":1,"contact":[1],"lambda":{"directions":[{"exit":[1,2],"limit":null}],"arcs":[null]}})",
       R"({"index":2,"contact":[1],"lambda":{"directions":[{"exit":[1,2,3],"vector":[1,0,0],"limit":[0]}],"arcs":[]}})",
       R"({"index":1,"contact":[1],"connections":[{"orbits":1,"families":0}]})",
       R"({"index":1,"contact":[1],"connections":[{"to":null,"orbits":-1,"families":0}]})",
       R"({"index":3,"contact":[1],"volume":"-1"})", R"({"index":3,"contact":[1],"volume_double":-1})",
       R"({"index":3,"contact":[1],"shares":[[0,null]]})", R"({"index":1,"contact":[1],"shares_double":[]})",
       R"({"index":3,"contact":[1],"shares":[],"shares_double":[]})", R"({"index":3,"contact":[1],"shares":[[0]]})",
       R"({"index":1,"contact":[1],"shares":[[0,"1"]]})",
       R"({"format":"flowcert-stationary-points","format_version":1,"volumes":"none"})",
       R"({"format":"flowcert-stationary-points","format_version":1,"morse_smale":1})"}) {
    EXPECT_FALSE(schema.accepts(record)) << record;
    const std::string refusal = claim_refusal(kHeader + record);
    EXPECT_EQ(refusal.find("accepted"), std::string::npos) << record;
  }
}

TEST(ExchangeSchema, TakesWhatFlowsToInfinity) {
  CITES("FC-STAB-08", "FC-NUM-02");
  const ExchangeSchema schema;
  std::size_t count = 0;
  for (const std::vector<Point>& rows : inputs()) {
    std::istringstream lines(property::exchange_file(rows, {.u2 = true, .s2 = true, .skeletons = true, .all = true}));
    std::string line;
    while (std::getline(lines, line)) {
      EXPECT_TRUE(schema.accepts(line)) << line;
      count += line.starts_with(R"({"kind":"infinity","skeleton":{"segments":[)") ? 1 : 0;
    }
  }
  EXPECT_EQ(count, inputs().size());
  const std::string empty = R"({"kind":"infinity","skeleton":{"segments":[]}})";
  EXPECT_TRUE(schema.accepts(empty));
  EXPECT_EQ(claim_refusal(kHeader + empty), "accepted, 0 points");
  EXPECT_EQ(claim_refusal(kHeader + empty + "\n" + empty), "a:3: a second line of infinity");
  const auto with = [](const std::string& list, const std::string& pieces) {
    return R"({"kind":"infinity","skeleton":{"segments":[],")" + list + "\":[" + pieces + "]}}";
  };
  for (const std::string& line :
       {with("unbounded_segments", R"({"samples":[0,1],"vector":[0,0,"1"],"back":["1/2",0,0],"back_kind":"edge"})"),
        with("unbounded_intervals", R"({"polygon":[0,1,2],"vector":[0,0,1],"back":[0,0,0]})"),
        with("unbounded_sectors", R"({"samples":[0,1],"corners":[[0,0,0],[1,0,0],{"vector":[0,0,1]}]})")}) {
    EXPECT_TRUE(schema.accepts(line)) << line;
    EXPECT_EQ(claim_refusal(kHeader + line), "accepted, 0 points") << line;
  }
  for (const std::string& line :
       {std::string(R"({"kind":"infinity"})"), std::string(R"({"kind":"infinity","skeleton":{}})"),
        with("unbounded_segments", R"({"samples":[0,1],"vector":[0,0,"1"]})"),
        with("unbounded_segments", R"({"samples":[0,1],"front":[0,0,1],"back":[0,0,0]})"),
        with("unbounded_segments", R"({"samples":[0],"vector":[0,0,1],"back":[0,0,0]})"),
        with("unbounded_intervals", R"({"polygon":[0,1,2],"vector":[0,0],"back":[0,0,0]})"),
        with("unbounded_sectors", R"({"samples":[0,1],"corners":[[0,0,0],{"vector":[0,0,1]}]})"),
        with("unbounded_sectors", R"({"samples":[0,1],"corners":[[0,0,0],[1,0,0],{"back":[0,0,1]}]})")}) {
    EXPECT_FALSE(schema.accepts(line)) << line;
    EXPECT_EQ(claim_refusal(kHeader + line).find("accepted"), std::string::npos) << line;
  }
  EXPECT_NE(claim_refusal(kHeader + with("unbounded_segments", R"({"samples":[0,1],"vector":[0,0,0],"back":[0,0,0]})"))
                .find("the vector is zero"),
            std::string::npos);
}

TEST(ExchangeSchema, SaysWhatAnUnstableSetMayHave) {
  CITES("FC-UNST-04", "FC-CLAIM-17");
  const ExchangeSchema schema;
  const auto record = [](const std::string& index, const std::string& traces, const std::string& sheets,
                         const std::string& segments) {
    return R"({"index":)" + index + R"(,"contact":[1],"u1":{"vertices":[["0","1/2",3]],"traces":[)" + traces +
           R"(],"runs":[],"sheets":[)" + sheets + R"(],"segments":[)" + segments + "]}}";
  };
  const std::string trace = R"({"polygon":[0,1,2],"from":["0","1","2"],"to":{"vector":["0","0","-7/2"]}})",
                    sheet = R"({"samples":[0,1],"corners":[[0,0,0],{"vector":[1,0,0]},{"vector":["0","1","0"]}]})",
                    segment = R"({"samples":[0,1],"start":[0,0,0],"end":["1","1","1"]})";
  for (const std::string& right :
       {record("1", trace, sheet, segment), record("[1,2]", "", sheet, ""), record("[1,3]", "", "", segment),
        record("1", "", R"({"samples":[0,1],"corners":[]})", "")}) {
    EXPECT_TRUE(schema.accepts(right)) << right;
    EXPECT_EQ(claim_refusal(kHeader + right), "accepted, 1 points") << right;
  }
  for (const std::string& wrong :
       {record("2", trace, sheet, segment), record("0", "", "", ""), record("[2,3]", "", "", ""),
        record("1", R"({"polygon":[0,1,2],"from":["0","1","2"]})", "", ""),
        record("1", R"({"polygon":[0,1,2],"from":["0","1","2"],"to":null})", "", ""),
        record("1", R"({"polygon":[0,1,2],"from":["0","1","2"],"to":{}})", "", ""),
        record("1", "", R"({"samples":[0,1],"corners":[[0,0,0],[0,0,1]]})", ""),
        record("1", "", R"({"samples":[0,1,2],"corners":[]})", ""), record("1", "", R"({"samples":[0,1]})", ""),
        record("1", "", "", R"({"samples":[0,1],"start":{"vector":["0","1","0"]},"end":["1","1","1"]})"),
        record("1", "", "", R"({"samples":[0,1],"start":[0,0,0]})"),
        std::string(R"({"index":1,"contact":[1],"u1":{"vertices":[],"traces":[],"runs":[],"sheets":[]}})")}) {
    EXPECT_FALSE(schema.accepts(wrong)) << wrong;
    EXPECT_EQ(claim_refusal(kHeader + wrong).find("accepted"), std::string::npos) << wrong;
  }
  // This much a schema cannot say.
  const std::string zero = R"({"polygon":[0,1,2],"from":["0","1","2"],"to":{"vector":["0",0,"-0"]}})";
  EXPECT_TRUE(claim_refusal(kHeader + record("1", zero, "", "")).ends_with("is not a direction: the vector is zero"));
}

TEST(ExchangeSchema, SaysWhatTheReaderSays) {
  CITES("FC-OUT-01", "FC-NUM-02", "FC-FILE-18", "FC-FILE-47");
  const ExchangeSchema schema;
  for (const char* record :
       {R"({"index":2,"center":["1/2","-3","0x1.8p1"]})", R"({"index":2,"center":["0.1",1e-4,"+.5e+7"]})",
        R"({"index":[1,3],"kind":"regular","contact":[0],"new":1})", R"({"index":1,"samples":[7],"contact":[7]})",
        R"({"index":2,"contact":[1],"limits":[null,[1]],"u2":[[],[{"end":null}]]})",
        R"({"index":2,"contact":[1],"stable":{"segments":3,"has_vertex":false,"boundary":[[0,1]],"walk":[0,1,0]}})",
        R"({"index":[1,2],"contact":[1],"stable":{"walk":null},"surface":{"vertices":[],"triangles":[]}})",
        R"({"index":2,"contact":[1],"skeleton":{"segments":[{"samples":[0,1],"front":[0,0,0],"back":["1/2",0,0]}]}})",
        R"({"index":1,"center_double":[1,2,3],"squared_distance_double":null})"}) {
    EXPECT_TRUE(schema.accepts(record)) << record;
    EXPECT_EQ(claim_refusal(kHeader + record), "accepted, 1 points") << record;
  }
  for (const char* record :
       {R"({"index":4,"contact":[1]})",
        R"({"index":"1","contact":[1]})",
        R"({"index":[2,1],"contact":[1]})",
        R"({"index":1})",
        R"({"index":1,"contact":[]})",
        R"({"index":1,"contact":[-1]})",
        R"({"index":1,"contact":[2147483647]})",
        R"({"index":1,"contact":[1.5]})",
        R"({"contact":[1]})",
        R"({"index":1,"center":["1","2"]})",
        R"({"index":1,"center":["1","2","x"]})",
        R"({"index":1,"center":["1","2","nan"]})",
        R"({"index":1,"center":["1","2",null]})",
        R"({"index":1,"contact":[1],"squared_distance":"-1"})",
        R"({"index":1,"contact":[1],"squared_distance":-0.5})",
        R"({"index":1,"kind":"regular","contact":[1]})",
        R"({"index":[1,2],"kind":"critical","contact":[1]})",
        R"({"index":1,"contact":[1],"limits":[null,null]})",
        R"({"index":2,"contact":[1],"limits":[null]})",
        R"({"index":2,"contact":[1],"u2":[[],[{}]]})",
        R"({"index":2,"contact":[1],"samples":[1]})",
        R"({"index":1,"contact":[1],"stable":{}})",
        R"({"index":[1,2],"contact":[1],"stable":{"boundary":[]}})",
        R"({"index":2,"contact":[1],"stable":{"has_vertex":0}})",
        R"({"index":2,"contact":[1],"stable":{"walk":[1.5]}})",
        R"({"index":2,"contact":[1],"skeleton":{}})",
        R"({"index":2,"contact":[1],"skeleton":{"segments":[{"samples":[0,1]}]}})",
        R"({"index":2,"contact":[1],"skeleton":{"segments":[],"sectors":[{"samples":[0,1],"corners":[]}]}})",
        R"({"index":2,"contact":[1],"surface":{"vertices":[]}})",
        R"({"index":2,"contact":[1],"surface":{"vertices":[],"triangles":[[0,1]]}})",
        "[]",
        "1"}) {
    EXPECT_FALSE(schema.accepts(record)) << record;
    EXPECT_NE(claim_refusal(kHeader + record), "accepted, 1 points") << record;
  }
  // Numbers in strings, as coordinates and as distances.
  for (const char* number : {"0", "-0", "+0", "-00", "-0/05", "-0.0", "-.0", "-0.", "-0E-5", "-0.e1", "-0x0",
                             "-0X.0P+3", "3/02", ".5", "5.", "+5.", "5e5", "0x.8p-1"}) {
    for (const std::string& record :
         {R"({"index":1,"center":[0,0,")" + std::string(number) + R"("]})",
          R"({"index":1,"contact":[0],"squared_distance":")" + std::string(number) + R"("})"}) {
      EXPECT_TRUE(schema.accepts(record)) << record;
      EXPECT_EQ(claim_refusal(kHeader + record), "accepted, 1 points") << record;
    }
  }
  for (const char* number :
       {"-1", "-0.01", "-.1", "-0x.1", "-1/2", "-0/0", "1/0", "1/00", "1/-2", "--0", "", ".", "5e"}) {
    const std::string record = R"({"index":1,"contact":[0],"squared_distance":")" + std::string(number) + R"("})";
    EXPECT_FALSE(schema.accepts(record)) << record;
    EXPECT_NE(claim_refusal(kHeader + record), "accepted, 1 points") << record;
  }
  for (const char* header : {R"({"format":"flowcert-stationary-points"})", R"({"format":"x","format_version":1})",
                             R"({"format":"flowcert-stationary-points","format_version":1,"points":-1})"}) {
    EXPECT_FALSE(schema.accepts(header)) << header;
    EXPECT_NE(claim_refusal(header), "accepted, 0 points") << header;
  }
}

}  // namespace
}  // namespace flowcert::exchange_schema_test
