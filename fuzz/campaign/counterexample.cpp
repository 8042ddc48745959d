#include "fuzz/campaign/counterexample.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "oracle/program/read_records.h"

namespace flowcert::fuzz {

// ---- JSON ----

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

std::string to_text(const oracle::Point& point) { return point[0].str() + ' ' + point[1].str() + ' ' + point[2].str(); }

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

// ---- The file ----
// The points are read here, and not by the library's reader, because a counterexample may be about that reader.
namespace {

using nlohmann::json;

constexpr std::string_view kHead = "# flowcert fuzz finding";

void add_comment(std::string& text, std::string_view key, std::string_view value) {
  text += fmt::format("# {}: {}\n", key, value);
}

void add_answer(std::string& text, const std::string& name, const std::string& answer) {
  if (name.empty()) return;
  text += fmt::format("#\n# {}:\n", name);
  std::istringstream lines(answer);
  for (std::string line; std::getline(lines, line);) text += fmt::format("#   {}\n", line);
}

// The text after "# KEY: ", if the line is that comment.
std::optional<std::string> comment(const std::string& line, std::string_view key) {
  const std::string opening = fmt::format("# {}: ", key);
  if (!line.starts_with(opening)) return std::nullopt;
  return line.substr(opening.size());
}

Row row_of(const std::string& line) {
  std::istringstream words(line);
  Row row{};
  for (double& coordinate : row) {
    std::string word;
    char* end = nullptr;
    if (words >> word) coordinate = std::strtod(word.c_str(), &end);
    if (word.empty() || end == nullptr || *end != '\0' || !std::isfinite(coordinate)) {
      throw std::invalid_argument("no row x y z of finite numbers");
    }
  }
  return row;
}

// "vertex 3 0 17": the kind, and numbers.
std::string choice_text(const property::StartChoice& choice) {
  std::ostringstream text;
  text << choice;
  return text.str();
}
property::StartChoice choice_of(const std::string& text) {
  std::istringstream words(text);
  std::string kind;
  words >> kind;
  const auto& names = property::kStartKindNames;
  const auto name = std::find(names.begin(), names.end(), kind);
  if (name == names.end()) throw std::invalid_argument("no choice of a start");
  property::StartChoice choice{static_cast<property::StartKind>(name - names.begin()), {}};
  for (std::uint32_t number = 0; words >> number;) choice.numbers.push_back(number);
  if (!words.eof()) throw std::invalid_argument("no choice of a start");
  return choice;
}

void read_comment(const std::string& line, Counterexample& counterexample) {
  if (const auto property = comment(line, "property")) counterexample.property = *property;
  if (const auto kind = comment(line, "kind")) counterexample.disagreement.kind = *kind;
  if (const auto clause = comment(line, "clause")) counterexample.disagreement.clause = *clause;
  if (const auto complaint = comment(line, "complaint")) counterexample.disagreement.complaint = *complaint;
  if (const auto start = comment(line, "start")) counterexample.trial.start = point_of(*start);
  if (const auto choice = comment(line, "choice of start")) counterexample.trial.start = choice_of(*choice);
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

json start_json(const property::Trial& trial) {
  if (const auto* point = std::get_if<oracle::Point>(&trial.start)) return to_text(*point);
  const auto& choice = std::get<property::StartChoice>(trial.start);
  return {static_cast<int>(choice.kind), choice.numbers};
}

}  // namespace

bool ends_process(const Counterexample& counterexample) {
  return counterexample.disagreement.kind == "crash" || counterexample.disagreement.kind == "hang";
}

std::string kind_of(const Counterexample& counterexample) {
  return counterexample.property + ' ' + counterexample.disagreement.kind;
}

std::string name_of(const Counterexample& counterexample) {
  std::string name =
      fmt::format("{}-{}-{}", counterexample.property, counterexample.disagreement.kind, counterexample.number);
  for (char& c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (!is_plain) c = '-';
  }
  return name;
}

std::string why_not_fully_shrunk(const Counterexample& counterexample, const std::string& unless_small) {
  if (!counterexample.is_small) return unless_small;
  if (counterexample.disagreement.kind == "hang") return "it hangs";
  return counterexample.most_tried == 0 ? "" : fmt::format("{} smaller inputs were tried", counterexample.most_tried);
}

std::string file_text(const Counterexample& counterexample) {
  const property::Disagreement& found = counterexample.disagreement;
  std::string text = fmt::format("{}\n", kHead);
  add_comment(text, "property", counterexample.property);
  add_comment(text, "kind", found.kind);
  add_comment(text, "clause", found.clause);
  add_comment(text, "complaint", in_one_line(found.complaint));
  add_comment(
      text, "case",
      fmt::format("{} of seed {} ({}, {} point{})", counterexample.number, counterexample.seed, counterexample.source,
                  counterexample.rows_before, counterexample.rows_before == 1 ? "" : "s"));
  // Only a run that ended before leaves a file of what is not small.
  const std::string why = why_not_fully_shrunk(counterexample, "the time was up, or the run was stopped");
  add_comment(text, "shrunk", why.empty() ? "fully" : "not fully: " + why);
  if (const auto* start = std::get_if<oracle::Point>(&counterexample.trial.start)) {
    add_comment(text, "start", to_text(*start));
  } else {
    add_comment(text, "choice of start", choice_text(std::get<property::StartChoice>(counterexample.trial.start)));
  }
  add_answer(text, found.first_name, found.first);
  add_answer(text, found.second_name, found.second);
  std::ostringstream rows;
  rows << counterexample.trial.input;
  return text + rows.str();
}

Counterexample counterexample_of(const std::string& file_text) {
  Counterexample counterexample;
  std::istringstream lines(file_text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    try {
      const std::string row = line.substr(0, line.find('#'));
      if (line.starts_with('#')) {
        read_comment(line, counterexample);
      } else if (row.find_first_not_of(" \t\r") != std::string::npos) {
        counterexample.trial.input.rows.push_back(row_of(row));
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", number, error.what()));
    }
  }
  counterexample.rows_before = counterexample.trial.input.rows.size();
  return counterexample;
}

json json_of(const Counterexample& counterexample) {
  const property::Disagreement& found = counterexample.disagreement;
  return {{"seed", counterexample.seed},
          {"number", counterexample.number},
          {"source", counterexample.source},
          {"rows_before", counterexample.rows_before},
          {"property", counterexample.property},
          {"rows", json_of(counterexample.trial.input)},
          {"start", start_json(counterexample.trial)},
          {"kind", found.kind},
          {"clause", found.clause},
          {"complaint", found.complaint},
          {"answers", {found.first_name, found.first, found.second_name, found.second}},
          {"small", counterexample.is_small},
          {"most_tried", counterexample.most_tried},
          {"asked", counterexample.is_asked}};
}

Counterexample counterexample_of(const json& object) {
  Counterexample counterexample;
  object.at("seed").get_to(counterexample.seed);
  object.at("number").get_to(counterexample.number);
  object.at("source").get_to(counterexample.source);
  object.at("rows_before").get_to(counterexample.rows_before);
  object.at("property").get_to(counterexample.property);
  counterexample.trial.input = input_of(object.at("rows"));
  const json& start = object.at("start");
  if (start.is_string()) {
    counterexample.trial.start = point_of(start.get<std::string>());
  } else {
    property::StartChoice choice;
    choice.kind = static_cast<property::StartKind>(start.at(0).get<int>());
    choice.numbers = start.at(1).get<std::vector<std::uint32_t>>();
    counterexample.trial.start = choice;
  }
  property::Disagreement& found = counterexample.disagreement;
  object.at("kind").get_to(found.kind);
  object.at("clause").get_to(found.clause);
  object.at("complaint").get_to(found.complaint);
  const json& answers = object.at("answers");
  object.at("small").get_to(counterexample.is_small);
  counterexample.most_tried = object.value("most_tried", std::size_t{0});
  object.at("asked").get_to(counterexample.is_asked);
  found.first_name = answers.at(0).get<std::string>();
  found.first = answers.at(1).get<std::string>();
  found.second_name = answers.at(2).get<std::string>();
  found.second = answers.at(3).get<std::string>();
  return counterexample;
}

}  // namespace flowcert::fuzz
