// Files are read with nlohmann's JSON. All that a case refers to must exist.
#include "certify/programs/vector_cases.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ranges>
#include <set>
#include <system_error>
#include <tuple>

#include "certify/finding_words.h"
#include "io/input_bytes.h"
#include "io/number_text.h"

namespace flowcert::certify {

namespace {

namespace fs = std::filesystem;

constexpr char kFlagFile[] = "flags.json";

void require(bool is_so, const std::string& otherwise) {
  if (!is_so) throw InvalidInput(otherwise);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

// ---- What is right ----

Point point_of(const std::vector<std::string>& words) {
  require(words.size() == 3, "a point without three coordinates");
  std::array<double, 3> row{};
  for (std::size_t k = 0; k < 3; ++k) {
    const NumberText number = parse_number(words[k]);
    require(number.fault == nullptr, "no coordinate: " + in_quotes(words[k]));
    row.at(k) = number.value;
  }
  return {row[0], row[1], row[2]};
}

std::vector<PointId> contact_of(const Json& value, std::size_t rows) {
  auto contact = value.get<std::vector<PointId>>();
  require(!contact.empty() && contact.back() < rows, "a contact set that is none of the points");
  require(std::ranges::is_sorted(contact, std::less_equal<>()), "a contact set that does not ascend");
  return contact;
}

CasePoint stationary_point_of(const Json& value, std::size_t rows) {
  const Json& index = value.at("index");
  const auto dimensions =
      index.is_array() ? index.get<std::array<int, 2>>() : std::array{index.get<int>(), index.get<int>()};
  require(0 <= dimensions[0] && dimensions[0] <= dimensions[1] && dimensions[1] <= 3, "no index: " + index.dump());
  CasePoint point;
  point.index = {static_cast<std::uint8_t>(dimensions[0]), static_cast<std::uint8_t>(dimensions[1])};
  point.contact = contact_of(value.at("contact"), rows);
  const Json& center = value.at("center");
  require(center.size() == 3, "a centre without three coordinates");
  for (std::size_t k = 0; k < 3; ++k) point.sphere.center.at(k) = exact_rational(center.at(k).get<std::string>());
  point.sphere.squared_radius = exact_rational(value.at("squared_distance").get<std::string>());
  return point;
}

// The order of FC-OUT-02. The judgement searches the list by it.
std::tuple<bool, int, int, const std::vector<PointId>&> order_key(const CasePoint& point) {
  return {!point.index.is_critical(), point.index.face_dimension, point.index.hull_dimension, point.contact};
}

using RecordOf = std::map<std::vector<PointId>, std::size_t>;

CaseLimits limits_of(const Json& value, const RecordOf& record_of, std::size_t rows) {
  require(value.size() == 2, "not two limits");
  CaseLimits limits;
  for (std::size_t side = 0; side < 2; ++side) {
    if (value.at(side).is_null()) continue;
    const auto record = record_of.find(contact_of(value.at(side), rows));
    require(record != record_of.end(), "a limit that is not among the stationary points");
    limits.at(side) = record->second;
  }
  return limits;
}

// An index-2 point may have its limits in two places, which must say the same.
std::optional<CaseLimits> limits_in(const Json& record, const RecordOf& record_of, std::size_t rows) {
  std::optional<CaseLimits> limits;
  if (record.contains("limits")) limits = limits_of(record.at("limits"), record_of, rows);
  const auto incidences = record.find("incidences");
  if (incidences == record.end() || record.at("index") != 2) return limits;
  const CaseLimits again = limits_of(incidences->at("limits"), record_of, rows);
  require(!limits || *limits == again, "limits that are not those among the incidences");
  return again;
}

std::vector<std::size_t> boundary_of(const Json& value, const RecordOf& record_of, const VectorCase& one) {
  std::vector<std::size_t> boundary;
  for (const Json& contact : value) {
    const auto record = record_of.find(contact_of(contact, one.rows.size()));
    require(record != record_of.end() && one.stationary[record->second].index.hull_dimension == 1,
            "a boundary with what is no critical point of index 1");
    boundary.push_back(record->second);
  }
  require(std::ranges::is_sorted(boundary, std::less_equal<>()), "a boundary that is not in order");
  return boundary;
}

CaseStable stable_of(const Json& value, const RecordOf& record_of, const VectorCase& one) {
  CaseStable stable{value.at("segments").get<std::size_t>(), value.at("has_vertex").get<bool>(),
                    value.at("has_interval").get<bool>(), std::nullopt, std::nullopt};
  const auto boundary = value.find("boundary");
  if (boundary != value.end() && !boundary->is_null()) {
    stable.boundary = boundary_of(*boundary, record_of, one);
  }
  if (value.at("walk").is_null()) return stable;
  stable.walk = value.at("walk").get<std::vector<PointId>>();
  require(std::ranges::all_of(*stable.walk, [&](PointId id) { return id < one.rows.size(); }),
          "a walk along what is none of the points");
  return stable;
}

// The start as a command line takes it. It must be read as what the vector means.
std::string start_of(const std::vector<std::string>& words) {
  std::string start = joined(words);
  const RationalPoint taken = parse_rational_point(start);
  for (std::size_t k = 0; k < 3; ++k) {
    require(taken.at(k) == exact_rational(words[k]), "a start that is no double and no fraction: " + words[k]);
  }
  return start;
}

std::vector<ListedPair> pairs_of(const Json& array) {
  std::vector<ListedPair> pairs;
  for (const Json& value : required_array(array, "persistence")) {
    const Json& dimension = required_field(value, "dimension");
    require(dimension.is_number_unsigned() && dimension.get<std::uint64_t>() < kPairDimensions,
            "'dimension' is not 0, 1 or 2");
    pairs.push_back({dimension.get<int>(), required_rational(required_field(value, "birth"), "birth"), std::nullopt});
    const Json& death = required_field(value, "death");
    if (!death.is_null()) pairs.back().death = required_rational(death, "death");
    require(!pairs.back().death || pairs.back().birth < *pairs.back().death, "a persistence pair of no length");
  }
  require(std::ranges::is_sorted(pairs, is_before), "persistence pairs that are not in order");
  return pairs;
}

void add_expected(const Json& expected, VectorCase& one) {
  const std::size_t rows = one.rows.size();
  RecordOf record_of;
  one.merged_duplicates = expected.at("merged_duplicates").get<std::size_t>();
  for (const Json& value : expected.at("stationary")) {
    one.stationary.push_back(stationary_point_of(value, rows));
    const bool is_new = record_of.emplace(one.stationary.back().contact, one.stationary.size() - 1).second;
    require(is_new, "a stationary point twice");
  }
  require(
      std::ranges::is_sorted(one.stationary, [](const auto& a, const auto& b) { return order_key(a) < order_key(b); }),
      "stationary points that are not in order");
  for (const Json& value : expected.at("stationary")) {
    one.limits.push_back(limits_in(value, record_of, rows));
    const auto stable = value.find("stable");
    one.stable.push_back(stable == value.end() ? std::nullopt : std::optional(stable_of(*stable, record_of, one)));
  }
  if (expected.contains("persistence")) one.persistence = pairs_of(expected.at("persistence"));
  if (!expected.contains("orbits")) return;
  for (const Json& value : expected.at("orbits")) {
    one.orbits.push_back(
        {start_of(value.at("start").get<std::vector<std::string>>()), claimed_orbit_of(value.dump(), "an orbit")});
  }
}

// ---- Cases and files ----

CaseResult result_of(const std::string& word) {
  if (word == "determined") return CaseResult::kDetermined;
  if (word == "acceptable") return CaseResult::kAcceptable;
  require(word == "invalid", "no result: " + in_quotes(word));
  return CaseResult::kInvalid;
}

// If the start is what has to be refused, the points are valid.
void add_input(const Json& value, VectorCase& one) {
  if (value.contains("text")) one.text = value.at("text").get<std::string>();
  if (!one.text) one.words = value.at("points").get<std::vector<std::vector<std::string>>>();
  const bool has_start = one.is_invalid() && value.at("refused").get<std::string>() == "start";
  if (has_start) one.refused_start = joined(value.at("start").get<std::vector<std::string>>());
  if (one.is_invalid()) return;
  require(!one.text, "a text, but a result");
  for (const auto& words : one.words) one.rows.push_back(point_of(words));
}

// The id becomes the name of a folder.
bool is_name(const std::string& id) {
  return !id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

VectorCase case_of(const Json& value, const std::string& group) {
  VectorCase one;
  one.json = value.dump(2);
  one.id = value.at("id").get<std::string>();
  require(is_name(one.id), "no id: " + in_quotes(one.id));
  one.group = group;
  one.comment = value.at("comment").get<std::string>();
  one.flags = value.at("flags").get<std::vector<std::string>>();
  one.result = result_of(value.at("result").get<std::string>());
  add_input(value, one);
  if (!one.is_invalid()) add_expected(value.at("expected"), one);
  return one;
}

// Adds the place to what `read` throws.
template <typename Read>
auto at_place(const std::string& place, const Read& read) {
  try {
    return read();
  } catch (const Json::exception& error) {
    throw InvalidInput(fmt::format("{}: not as the format says: {}", place, error.what()));
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", place, error.what()));
  }
}

Json file_of(const std::string& path, const char* format) {
  const std::string bytes = read_bytes(path);
  return at_place(path, [&] {
    Json file = Json::parse(bytes);
    require(file.at("format") == format && file.at("format_version") == 1, fmt::format("not {}, version 1", format));
    return file;
  });
}

void add_flags(const std::string& path, Vectors& vectors) {
  const Json file = file_of(path, "flowcert-vector-flags");
  at_place(path, [&] {
    for (const Json& flag : file.at("flags")) {
      vectors.flags.push_back({flag.at("flag").get<std::string>(), flag.at("meaning").get<std::string>()});
    }
  });
}

void add_group(const std::string& path, Vectors& vectors) {
  const Json file = file_of(path, "flowcert-vectors");
  at_place(path, [&] {
    vectors.groups.push_back(file.at("group").get<std::string>());
    std::size_t ordinal = 0;
    for (const Json& value : file.at("cases")) {
      vectors.cases.push_back(
          at_place(fmt::format("case {}", ++ordinal), [&] { return case_of(value, vectors.groups.back()); }));
    }
  });
}

void require_consistent(const std::string& folder, const Vectors& vectors) {
  std::set<std::string> flags, ids;
  for (const VectorFlag& flag : vectors.flags) flags.insert(flag.name);
  for (const VectorCase& one : vectors.cases) {
    require(ids.insert(one.id).second, fmt::format("{}: two cases are {}", folder, one.id));
    for (const std::string& flag : one.flags) {
      require(flags.contains(flag),
              fmt::format("{}: {}: {} does not know the flag {}", folder, one.id, kFlagFile, in_quotes(flag)));
    }
  }
  require(!vectors.cases.empty(), folder + ": no conformance vectors");
}

}  // namespace

Vectors read_vectors(const std::string& folder) {
  require(fs::is_directory(folder), folder + ": no folder of conformance vectors");
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    const std::string name = entry.path().filename().string();
    if (extension == ".json" && name != kFlagFile) paths.push_back(entry.path().string());
  }
  std::ranges::sort(paths);
  Vectors vectors;
  add_flags((fs::path(folder) / kFlagFile).string(), vectors);
  for (const std::string& path : paths) add_group(path, vectors);
  require_consistent(folder, vectors);
  return vectors;
}

std::string usual_vectors_folder() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / FLOWCERT_INSTALLED_VECTORS;
  return fs::is_directory(installed, ignored) ? installed.string() : FLOWCERT_SOURCE_VECTORS;
}

// ---- Point files ----

namespace {

// The vectors have hexadecimal floats. A program that reads none must not refuse an invalid case for that.
std::string word_text(const std::string& word, bool hexadecimal) {
  const bool is_hexadecimal = word.find("0x") != std::string::npos;
  if (hexadecimal || !is_hexadecimal) return word;
  const NumberText number = parse_number(word);
  return number.fault == nullptr ? shortest_text(number.value) : word;
}

}  // namespace

std::optional<std::string> point_file_text(const VectorCase& one, const PointFileStyle& style) {
  const bool is_xyz = style.format == PointFileFormat::kXyz;
  if (one.text) return is_xyz ? one.text : std::nullopt;
  std::string text = is_xyz ? "" : fmt::format("OFF\n{} 0 0\n", one.words.size());
  // An XYZ file of no byte is an error (FC-IN-05).
  if (is_xyz && one.words.empty()) text = "# no points\n";
  for (const auto& row : one.words) {
    const auto words =
        row | std::views::transform([&](const std::string& word) { return word_text(word, style.hexadecimal); });
    text += fmt::format("{}\n", fmt::join(words, " "));
  }
  return text;
}

std::string point_file_name(const PointFileStyle& style) {
  return style.format == PointFileFormat::kXyz ? "points.xyz" : "points.off";
}

}  // namespace flowcert::certify
