#include "tests/json_schema.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace flowcert_tests {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

struct JsonSchema::Parsed {
  valijson::Schema schema;
};

JsonSchema::JsonSchema(const std::filesystem::path& path) : parsed_(std::make_unique<Parsed>()) {
  std::ifstream file(path);
  const nlohmann::json document = nlohmann::json::parse(file);
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(document), parsed_->schema);
}

JsonSchema::~JsonSchema() = default;

std::string JsonSchema::violations(const nlohmann::json& document) const {
  valijson::ValidationResults results;
  if (valijson::Validator().validate(parsed_->schema, Adapter(document), &results)) return "";
  std::string text = "does not conform\n";
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& step : error.context) text += step;
    text += ": ";
    text += error.description;
    text += '\n';
  }
  return text.substr(0, 2000);
}

}  // namespace flowcert_tests
