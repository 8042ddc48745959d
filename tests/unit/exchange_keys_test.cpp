// No key of the exchange format goes unread: its value is changed, and the claim fails, or is refused, or the report
// says that it was not judged. The keys are those of the schema.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "certify/truth.h"
#include "tests/cites.h"
#include "tests/unit/claim_file_samples.h"

namespace flowcert::exchange_keys_test {
namespace {

using Json = nlohmann::ordered_json;

// What says how the file was made, and nothing about the flow complex.
const std::set<std::string> kOfTheProgram = {"version", "commit", "kernel", "compiler", "cgal", "centers", "volumes"};

// Their keys are changed one by one.
const std::set<std::string> kObjects = {"regular_stationary", "stable", "skeleton", "surface", "lambda", "u1"};

// All keys of a schema's object, with those of the objects in it: "skeleton.segments.front".
void add_keys(const Json& schema, const Json& root, const std::string& around, std::set<std::string>& keys) {
  if (schema.contains("$ref")) {
    const std::string name = schema["$ref"];
    return add_keys(root.at(Json::json_pointer(name.substr(1))), root, around, keys);
  }
  for (const char* inside : {"items", "anyOf"}) {
    if (!schema.contains(inside)) continue;
    if (schema[inside].is_object()) add_keys(schema[inside], root, around, keys);
    for (const Json& one : schema[inside]) {
      if (one.is_object() && schema[inside].is_array()) add_keys(one, root, around, keys);
    }
  }
  if (!schema.contains("properties")) return;
  for (const auto& [key, value] : schema["properties"].items()) {
    const std::string name = around.empty() ? key : around + "." + key;
    keys.insert(name);
    add_keys(value, root, name, keys);
  }
}

std::set<std::string> keys_of(const char* definition) {
  std::ifstream file(FLOWCERT_EXCHANGE_SCHEMA);
  const Json schema = Json::parse(file);
  std::set<std::string> keys;
  add_keys(schema["definitions"][definition], schema, "", keys);
  return keys;
}

// Another value of the same form.
Json changed(const Json& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_number_integer()) return value.get<long>() + 1;
  if (value.is_number()) return value.get<double>() + 1;
  if (value.is_null()) return Json::array({0});
  if (value.is_array() && value.empty()) return Json::array({0});
  if (value.is_array()) {
    Json other = value;
    other.erase(other.size() - 1);
    return other;
  }
  if (value.is_object()) return Json::object();
  const std::string text = value;
  const bool is_number = !text.empty() && text.find_first_not_of("-0123456789/") == std::string::npos;
  return is_number ? text.find('/') == std::string::npos ? text + "1" : "1" + text : text + "x";
}

// Calls each(value) for every value that the path leads to.
void visit(Json& value, const std::string& path, const std::function<void(Json&)>& each) {
  if (value.is_array()) {
    for (Json& item : value) visit(item, path, each);
    return;
  }
  if (!value.is_object()) return;
  const std::size_t dot = path.find('.');
  const std::string key = path.substr(0, dot);
  if (!value.contains(key)) return;
  if (dot == std::string::npos) return each(value[key]);
  visit(value[key], path.substr(dot + 1), each);
}

constexpr RecordsToWrite all_but_sheets(WrittenVolumes volumes) {
  return {.u2 = true, .polylines = true, .s2 = true, .skeletons = true, .all = true, .volumes = volumes};
}

class ExchangeFile {
 public:
  ExchangeFile(const std::vector<Point>& rows, const RecordsToWrite& wanted)
      : points_(rows), truth_(fast_truth(points_)) {
    std::istringstream text(property::exchange_file(rows, wanted));
    for (std::string line; std::getline(text, line);) lines_.push_back(Json::parse(line));
    lines_[0]["indices"] = {0, 1, 2, 3};
    // compute writes no surfaces.
    for (Json& line : lines_) {
      if (!line.contains("index") || !line.contains("skeleton") || !line["skeleton"]["intervals"].empty()) continue;
      line["surface"] = surface_of(line["skeleton"]["segments"]);
    }
    bool is_second = false;
    for (Json& line : lines_) {
      if (line.contains("u1")) swap_ends(line["u1"], is_second);
    }
  }

  [[nodiscard]] std::string definition_of(std::size_t k) const {
    if (k == 0) return "header";
    return lines_[k].contains("kind") && lines_[k]["kind"] == "infinity" ? "infinity" : "record";
  }

  // What comes of it if one value that the path leads to is changed; empty if nothing does.
  [[nodiscard]] std::vector<std::string> outcomes(const std::string& path, const std::string& definition) const {
    std::vector<std::string> result;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (definition != definition_of(k)) continue;
      std::size_t count = 0;
      Json line = lines_[k];
      visit(line, path, [&](Json&) { ++count; });
      for (std::size_t at = 0; at < std::min<std::size_t>(count, 3); ++at) {
        std::vector<Json> lines = lines_;
        std::size_t next = 0;
        visit(lines[k], path, [&](Json& value) {
          if (next++ == at) value = changed(value);
        });
        result.push_back(outcome(lines));
      }
    }
    return result;
  }

  [[nodiscard]] std::string outcome(const std::vector<Json>& lines) const {
    std::string text;
    for (const Json& line : lines) text += line.dump() + "\n";
    try {
      const Claim claim = read_claim_from(text, "claim");
      require_rows(claim, points_, "claim");
      const CheckReport report = check(points_, claim, *truth_);
      return report.not_judged.empty() ? verdict_text(report.verdict) : "not judged";
    } catch (const InvalidInput&) {
      return "refused";
    }
  }
  [[nodiscard]] std::string outcome() const { return outcome(lines_); }

 private:
  // compute writes the lesser end first, which is never at infinity alone. Every second interval begins there.
  static void swap_ends(Json& u1, bool& is_second) {
    for (const char* part : {"traces", "runs"}) {
      for (Json& interval : u1[part]) {
        if (is_second) std::swap(interval["from"], interval["to"]);
        is_second = !is_second;
      }
    }
  }

  [[nodiscard]] Json surface_of(const Json& segments) const {
    Json surface = {{"vertices", Json::array()}, {"triangles", Json::array()}};
    for (const Json& segment : segments) {
      for (const Json& sample : segment["samples"]) {
        const std::size_t first = surface["vertices"].size();
        const Point& p = points_[points_.ordinal_of_row(sample)];
        surface["vertices"].push_back({p.x, p.y, p.z});
        surface["vertices"].push_back(segment["front"]);
        surface["vertices"].push_back(segment["back"]);
        surface["triangles"].push_back({first, first + 1, first + 2});
      }
    }
    return surface;
  }

  PointSet points_;
  std::unique_ptr<Truth> truth_;
  std::vector<Json> lines_;
};

const std::vector<Point> kCrowded = {{-118, -3, 155},   {2, -3, -205},  {194, -3, -61}, {-70, -163, 91},
                                     {-134, -153, -57}, {-208, 57, 25}, {170, -83, 71}, {30, 147, -159}};

// Parts of unstable sets of all sorts, also at infinity.
const std::vector<Point> kManyRays = {{-3, -1, -1}, {3, 3, -2}, {0, 2, -2}, {3, -2, 0}, {2, 1, -2}, {0, 1, 0}};

TEST(ExchangeKeys, NoneGoesUnread) {
  CITES("FC-CLAIM-01", "FC-OUT-01");
  const std::array<ExchangeFile, 3> files = {ExchangeFile(rows_of_many_kinds(), all_but_sheets(WrittenVolumes::kExact)),
                                             ExchangeFile(kCrowded, all_but_sheets(WrittenVolumes::kShares)),
                                             ExchangeFile(kManyRays, {.sheets = true})};
  for (const ExchangeFile& file : files) ASSERT_EQ(file.outcome(), "conforms");
  for (const char* definition : {"header", "record", "infinity"}) {
    for (const std::string& key : keys_of(definition)) {
      if (kOfTheProgram.contains(key) || kObjects.contains(key)) continue;
      std::set<std::string> outcomes;
      for (const ExchangeFile& file : files) {
        for (const std::string& one : file.outcomes(key, definition)) outcomes.insert(one);
      }
      // A part of a contact set can name it.
      if (key == "contact" || key.ends_with("limit") || key.ends_with("arcs") || key.ends_with("to"))
        outcomes.erase("conforms where determined");
      EXPECT_FALSE(outcomes.empty()) << key << " is in no file";
      for (const std::string& one : outcomes) {
        EXPECT_TRUE(one == "fails" || one == "refused" || one == "perturbed" || one == "not judged")
            << key << ": " << one;
      }
    }
  }
}

TEST(ExchangeKeys, UnknownOnesAreNotJudged) {
  CITES("FC-CLAIM-01");
  const PointSet points(rows_of_many_kinds());
  std::string text = property::exchange_file(rows_of_many_kinds());
  text.insert(1, R"("mood":{"good":true},)");
  text.replace(text.find("\"stable\":{"), 10, R"("stable":{"colour":[{"red":1}],)");
  const CheckReport report = check(points, read_claim_from(text, "claim"));
  EXPECT_EQ(report.verdict, Verdict::kConforms);
  EXPECT_EQ(report.not_judged, (std::vector<std::string>{"what the unknown key 'mood' says",
                                                         "what the unknown key 'stable.colour' says"}));
}

TEST(ExchangeKeys, DoublesBesideExactValues) {
  CITES("FC-NUM-02", "FC-CLAIM-05");
  const std::string header = "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n";
  const PointSet points(std::vector<Point>{{4, 1, 0}});
  const auto said = [&](const std::string& values) {
    const std::string record =
        "{\"index\":0,\"contact\":[0],\"center\":[\"4\",\"1\",\"0\"],"
        "\"squared_distance\":\"0\"," +
        values + "}\n";
    const CheckReport report = check(points, read_claim_from(header + record, "claim"));
    return report.findings.empty() ? verdict_text(report.verdict) : report.findings[0].claimed;
  };
  EXPECT_EQ(said(R"("center_double":[4.0,1.0,-0.0],"squared_distance_double":0)"), "conforms");
  EXPECT_EQ(said(R"("center_double":[4.0,1.5,0.0])"), "index 0, contact set 0, center_double with 1.5");
  EXPECT_EQ(said(R"("center_double":[4.0,null,0.0])"), "index 0, contact set 0, center_double with no double");
  EXPECT_EQ(said(R"("squared_distance_double":1)"), "index 0, contact set 0, squared_distance_double 1");
  EXPECT_EQ(said(R"("squared_distance_double":null)"), "index 0, contact set 0, squared_distance_double no double");
}

}  // namespace
}  // namespace flowcert::exchange_keys_test
