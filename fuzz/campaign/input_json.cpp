// See input_json.h.
#include "fuzz/campaign/input_json.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "oracle/read_records.h"

namespace flowcert::fuzz {
namespace {

double number_of(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) {
    throw std::invalid_argument("'" + text + "' is no coordinate");
  }
  return value;
}

}  // namespace

nlohmann::json json_of(const Input& input) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Row& row : input.rows) {
    rows.push_back({fmt::format("{:a}", row[0]), fmt::format("{:a}", row[1]), fmt::format("{:a}", row[2])});
  }
  return rows;
}

Input input_of(const nlohmann::json& rows) {
  Input input;
  for (const nlohmann::json& row : rows) {
    input.rows.push_back({number_of(row.at(0).get<std::string>()), number_of(row.at(1).get<std::string>()),
                          number_of(row.at(2).get<std::string>())});
  }
  return input;
}

std::string to_text(const oracle::Point& point) {
  return point[0].str() + ' ' + point[1].str() + ' ' + point[2].str();
}

oracle::Point point_of(const std::string& text) {
  oracle::Point point;
  std::istringstream words(text);
  std::string word;
  for (oracle::Rational& coordinate : point) {
    words >> word;
    const auto written = oracle::parse_rational(words ? word : "");
    if (!written) throw std::invalid_argument("'" + text + "' is no position x y z of rationals");
    coordinate = written->value;
  }
  if (words >> word) throw std::invalid_argument("'" + text + "' is no position x y z of rationals");
  return point;
}

}  // namespace flowcert::fuzz
