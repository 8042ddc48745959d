// JSON Schema (draft 7), as valijson validates it. In a file of its own because valijson takes long to
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

  // What violates the schema, a line each, at most 2,000 characters; empty if nothing does.
  [[nodiscard]] std::string violations(const nlohmann::json& document) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

}  // namespace flowcert_tests
