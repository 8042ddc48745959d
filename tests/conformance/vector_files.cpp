#include "tests/conformance/vector_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/json_schema.h"

namespace flowcert::conformance {

std::filesystem::path spec_folder() { return FLOWCERT_SPEC_FOLDER; }

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return text.str();
}

std::string vectors_text(const std::string& name) { return text_of_file(spec_folder() / "vectors" / (name + ".json")); }

std::vector<std::string> names_of_files() {
  std::vector<std::string> names;
  const auto folder = spec_folder() / "vectors";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_directory()) continue;  // balls/
    EXPECT_EQ(entry.path().extension(), ".json") << entry.path();
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

const Json& group_named(std::string_view name) {
  static std::map<std::string, Json> read;
  const auto [place, is_new] = read.try_emplace(std::string(name));
  if (is_new) place->second = Json::parse(vectors_text(place->first));
  return place->second;
}

std::vector<Json> all_cases() {
  std::vector<Json> cases;
  for (const std::string& name : names_of_files()) {
    if (name == "flags") continue;
    for (const Json& one : group_named(name)["cases"]) cases.push_back(one);
  }
  return cases;
}

bool is_invalid(const Json& one) { return one["result"] == "invalid"; }

bool has(const Json& one, const char* key) { return one["expected"].contains(key); }

// All of a point file.
std::string xyz_text(const Json& one) {
  if (one.contains("text")) return one["text"];
  std::string text = one["points"].empty() ? "# no point\n" : "";
  for (const Json& row : one["points"]) {
    const char* separator = "";
    for (const Json& word : row) {
      text += separator;
      text += word.get<std::string>();
      separator = " ";
    }
    text += '\n';
  }
  return text;
}

std::string words_in_a_row(const Json& words) {
  std::string text;
  for (const Json& word : words) {
    if (!text.empty()) text += ',';
    text += word.get<std::string>();
  }
  return text;
}

std::string violations(const nlohmann::json& file) {
  static const flowcert_tests::JsonSchema schema(spec_folder() / "schemas" / "vectors.schema.json");
  return schema.violations(file);
}

void expect_same(const Json& one, const std::string& what, const Json& actual, const Json& expected) {
  EXPECT_TRUE(actual.dump() == expected.dump())
      << one["id"] << ": " << what << "\nis       " << actual.dump() << "\nand not  " << expected.dump();
}

}  // namespace flowcert::conformance
