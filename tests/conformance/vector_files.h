// The files of spec/vectors/ as their tests read them. Each is parsed once.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace flowcert::conformance {

using Json = nlohmann::ordered_json;

[[nodiscard]] std::filesystem::path spec_folder();
// Throws where the file cannot be read.
[[nodiscard]] std::string text_of_file(const std::filesystem::path& path);

// The names of all files, without ".json", in order.
[[nodiscard]] std::vector<std::string> names_of_files();
[[nodiscard]] std::string vectors_text(const std::string& name);
[[nodiscard]] const Json& group_named(std::string_view name);
// The cases of all groups.
[[nodiscard]] std::vector<Json> all_cases();

[[nodiscard]] bool is_invalid(const Json& one);
// Whether the case expects something under this key.
[[nodiscard]] bool has(const Json& one, const char* key);
// The whole text of a case's point file.
[[nodiscard]] std::string xyz_text(const Json& one);
// "1,2,3" for ["1", "2", "3"].
[[nodiscard]] std::string words_in_a_row(const Json& words);

// What violates the schema of vectors, a line each; empty if nothing does.
[[nodiscard]] std::string violations(const nlohmann::json& file);

// Fails the test where the two differ as text.
void expect_same(const Json& one, const std::string& what, const Json& actual, const Json& expected);

}  // namespace flowcert::conformance
