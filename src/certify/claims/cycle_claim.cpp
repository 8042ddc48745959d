// Reads cycles from JSON and from lines.
#include "certify/cycle_claim.h"

#include <fmt/format.h>

#include <algorithm>

#include "certify/claimed_rows.h"
#include "certify/claims/named_format.h"
#include "certify/layer.h"
#include "geometry/floating_point.h"
#include "io/json_fields.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert {

using namespace certify;

namespace {

// A closed polygon's edges.
void append_polygon(const std::vector<PointId>& polygon, std::vector<SampleEdge>& edges) {
  for (std::size_t k = 0; k < polygon.size(); ++k) edges.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
}

// ---- JSON

// A string is exact, and a number is a decimal.
std::optional<ClaimedNumber> number_in(const Json& object, const char* key) {
  const auto value = object.find(key);
  if (value == object.end()) return std::nullopt;
  if (value->is_number()) return claimed_distance(value->dump(), PlainInteger::kDecimal, {key, 1});
  return ClaimedNumber{required_rational(*value, key), true};
}

std::vector<PointId> rows_of(const Json& value, const char* key) {
  std::vector<PointId> rows;
  for (const Json& row : required_array(value, key)) {
    if (!row.is_number_unsigned() || row.get<std::uint64_t>() > kLargestId) {
      throw InvalidInput(fmt::format("'{}' has something that is no row", key));
    }
    rows.push_back(row.get<PointId>());
  }
  return rows;
}

template <std::size_t kSize>
std::array<PointId, kSize> simplex_of(const Json& value, const char* key) {
  const std::vector<PointId> rows = rows_of(value, key);
  if (rows.size() != kSize) throw InvalidInput(fmt::format("'{}' has something without {} rows", key, kSize));
  std::array<PointId, kSize> simplex{};
  std::ranges::copy(rows, simplex.begin());
  return simplex;
}

// All parts of an array that may be missing.
template <class Each>
auto list_in(const Json& object, const char* key, Each each) {
  std::optional<std::vector<decltype(each(object, key))>> list;
  if (const auto value = object.find(key); value != object.end()) {
    list.emplace();
    for (const Json& part : required_array(*value, key)) list->push_back(each(part, key));
  }
  return list;
}

ClaimedPairEnd end_of(const Json& cycle, const char* key) {
  const Json& value = required_field(cycle, key);
  ClaimedPairEnd end{{}, number_in(value, "squared_distance")};
  if (const auto contact = value.find("contact"); contact != value.end()) end.contact = rows_of(*contact, "contact");
  if (end.contact.empty() && !end.squared_distance) {
    throw InvalidInput(fmt::format("'{}' has neither a contact set nor a squared distance", key));
  }
  return end;
}

ClaimedCycle cycle_of(const Json& object) {
  ClaimedCycle cycle;
  cycle.birth = end_of(object, "birth");
  cycle.death = end_of(object, "death");
  cycle.squared_level = number_in(object, "squared_level");
  cycle.edges = list_in(object, "edges", simplex_of<2>).value_or(std::vector<SampleEdge>());
  if (const auto polygons = list_in(object, "polygons", rows_of)) {
    std::vector<SampleEdge> edges;
    for (const std::vector<PointId>& polygon : *polygons) append_polygon(polygon, edges);
    if (object.contains("edges")) {
      cycle.polygons = std::move(edges);
    } else {
      cycle.edges = std::move(edges);
    }
  }
  cycle.saddles = list_in(object, "surface", rows_of);
  cycle.triangles = list_in(object, "triangles", simplex_of<3>);
  cycle.maxima = list_in(object, "maxima", rows_of);
  cycle.walls = list_in(object, "walls", rows_of);
  cycle.cell = list_in(object, "cell",
                       [](const Json& part, const char* key) { return rows_of(required_field(part, "contact"), key); });
  cycle.components = list_in(object, "components", rows_of).value_or(std::vector<std::vector<PointId>>());
  return cycle;
}

CycleClaim cycles_of_json(const Json& object) {
  CycleClaim claim;
  const Json& version = required_field(object, "format_version");
  if (version != 1) throw InvalidInput("'format_version' is not 1, the only one that is known");
  const Json& dimension = required_field(object, "dimension");
  if (dimension != 0 && dimension != 1 && dimension != 2) throw InvalidInput("'dimension' is not 0, 1 or 2");
  claim.dimension = dimension.get<int>();
  for (const Json& cycle : required_array(required_field(object, "cycles"), "cycles")) {
    claim.cycles.push_back(cycle_of(cycle));
  }
  if (const auto pairs = object.find("pairs"); pairs != object.end()) {
    if (!pairs->is_number_unsigned()) throw InvalidInput("'pairs' is no number of pairs");
    claim.pairs = pairs->get<std::size_t>();
    claim.is_whole = *claim.pairs == claim.cycles.size();
  }
  return claim;
}

// ---- Lines

class CycleLines {
 public:
  CycleLines(std::string_view bytes, const std::string& name) : lines_(bytes, name) {}

  [[nodiscard]] CycleClaim read() {
    for (std::string_view line; lines_.next_uncommented(line);) {
      const std::vector<std::string_view> words = words_of(line);
      read_line(words.front(), std::span(words).subspan(1));
    }
    if (!is_begun_) lines_.place().reject("no line 'cycles' with a dimension");
    return std::move(claim_);
  }

 private:
  using Words = std::span<const std::string_view>;

  void read_line(std::string_view key, Words words) {
    if (key == "cycles") return begin(words);
    if (key == "pair") return read_pair(words);
    if (claim_.cycles.empty()) lines_.place().reject("no line 'pair' before it");
    ClaimedCycle& cycle = claim_.cycles.back();
    if (key == "level") {
      expect(words.size() == 1, "not a number behind 'level', which is squared");
      cycle.squared_level = number(words[0]);
    } else if (key == "loop" && claim_.dimension == 1) {
      append_polygon(rows(words), cycle.edges);
    } else if (key == "edge" && claim_.dimension == 1) {
      cycle.edges.push_back(simplex<2>(words));
    } else if (key == "triangle" && claim_.dimension > 0) {
      if (!cycle.triangles) cycle.triangles.emplace();
      cycle.triangles->push_back(simplex<3>(words));
    } else if (key == "maximum" && claim_.dimension == 2) {
      if (!cycle.maxima) cycle.maxima.emplace();
      cycle.maxima->push_back(rows(words));
    } else if (key == "component" && claim_.dimension == 0) {
      cycle.components.push_back(rows(words));
    } else {
      lines_.place().reject("not what a cycle of dimension " + std::to_string(claim_.dimension) +
                            " has: " + in_quotes(key));
    }
  }

  void begin(Words words) {
    expect(!is_begun_, "a second line 'cycles'");
    expect(!words.empty() && words.size() <= 2 && (words.size() == 1 || words[1] == "all"),
           "not a dimension, and nothing or 'all', behind 'cycles'");
    expect(words[0] == "0" || words[0] == "1" || words[0] == "2", "no dimension 0, 1 or 2");
    claim_.dimension = words[0][0] - '0';
    claim_.is_whole = words.size() == 2;
    is_begun_ = true;
  }

  // "3,17/5,8,20", two contact sets, or two squared distances.
  void read_pair(Words words) {
    expect(is_begun_, "no line 'cycles' before it");
    ClaimedCycle& cycle = claim_.cycles.emplace_back();
    cycle.line = lines_.place().line;
    if (words.size() == 2) {
      cycle.birth.squared_distance = number(words[0]);
      cycle.death.squared_distance = number(words[1]);
      return;
    }
    const auto ends = words.size() == 1 ? split_at(words[0], '/') : std::vector<std::string_view>();
    expect(ends.size() == 2, "neither two contact sets, like 3,17/5,8,20, nor two squared distances");
    cycle.birth.contact = rows(split_at(ends[0], ','));
    cycle.death.contact = rows(split_at(ends[1], ','));
  }

  void expect(bool is_right, const char* otherwise) const {
    if (!is_right) lines_.place().reject(otherwise);
  }
  [[nodiscard]] ClaimedNumber number(std::string_view word) const {
    return claimed_distance(word, PlainInteger::kDecimal, lines_.place());
  }
  [[nodiscard]] std::vector<PointId> rows(Words words) const {
    std::vector<PointId> rows;
    for (const std::string_view word : words) rows.push_back(claimed_id(word, lines_.place()));
    return rows;
  }
  template <std::size_t kSize>
  [[nodiscard]] std::array<PointId, kSize> simplex(Words words) const {
    if (words.size() != kSize) lines_.place().reject(fmt::format("not {} rows", kSize));
    std::array<PointId, kSize> simplex{};
    std::ranges::copy(rows(words), simplex.begin());
    return simplex;
  }

  LineReader lines_;
  CycleClaim claim_;
  bool is_begun_ = false;
};

}  // namespace

bool is_cycle_claim(std::string_view bytes, const std::string& name) {
  const std::string_view text = trimmed(bytes);
  if (text.starts_with('{')) return names_format(text, "flowcert-cycles");
  LineReader lines(text, name);
  std::string_view first;
  return lines.next_uncommented(first) && words_of(first).front() == "cycles";
}

CycleClaim claimed_cycles_of(std::string_view bytes, const std::string& name) {
  const geometry::IeeeDoubles ieee;
  if (!trimmed(bytes).starts_with('{')) return CycleLines(bytes, name).read();
  const Json object = parse_foreign_json(bytes, name);
  try {
    return cycles_of_json(object);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", name, error.what()));
  }
}

void require_rows(const CycleClaim& claim, const PointSet& points, const std::string& name) {
  for (const ClaimedCycle& cycle : claim.cycles) {
    const LinePlace place{.file = name, .line = std::max<std::size_t>(cycle.line, 1)};
    const auto require = [&](std::span<const PointId> rows) { require_ids(rows, points, place); };
    require(cycle.birth.contact), require(cycle.death.contact);
    std::ranges::for_each(cycle.edges, require);
    if (cycle.polygons) std::ranges::for_each(*cycle.polygons, require);
    if (cycle.triangles) std::ranges::for_each(*cycle.triangles, require);
    for (const auto* lists : {&cycle.saddles, &cycle.maxima, &cycle.walls, &cycle.cell}) {
      if (*lists) std::ranges::for_each(**lists, require);
    }
    std::ranges::for_each(cycle.components, require);
  }
}

}  // namespace flowcert
