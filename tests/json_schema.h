// JSON Schema (draft 7), as valijson validates it. It has a file of its own because valijson takes long to
// compile.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace flowcert_tests {

class JsonSchema {
 public:
  // Throws where the file is not JSON.
  explicit JsonSchema(const std::filesystem::path& path);
  ~JsonSchema();
  JsonSchema(const JsonSchema&) = delete;
  JsonSchema& operator=(const JsonSchema&) = delete;

  // What violates the schema, one line for each violation, at most 2,000 characters. Empty if nothing does.
  [[nodiscard]] std::string violations(const nlohmann::json& document) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace flowcert_tests
