// The exchange format: the JSON Lines that `flowcert compute -o` writes, a header and one record for each point
// (spec/formats/stationary_points.md; spec/schemas/exchange.schema.json).
//
// Guarantees: a known key has a right value, or the file is refused. InvalidInput names the place of anything that is
// not JSON (RFC 8259), nests deeper than a claim can, has a key twice in one object, or has a number out of a
// double's range. Memory is bounded by a multiple of the text, recursion by the depth.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/claim.h"
#include "io/claims/claim_formats.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

// ---- JSON ----
// One value in memory. Numbers stay text, because a claim's decimals must not become doubles.

namespace {

enum class JsonKind { kNull, kBoolean, kNumber, kString, kArray, kObject };

struct JsonTree {
  JsonKind kind = JsonKind::kNull;
  std::string text;               // a number as written, or the value of a string
  std::vector<JsonTree> items;    // the items of an array, or the keys and values of an object in turn
  mutable bool is_known = false;  // of a key: somebody has asked for it

  [[nodiscard]] bool is(JsonKind other) const { return kind == other; }
  // The value of an object's key; null if the object does not have the key.
  [[nodiscard]] const JsonTree* find(std::string_view key) const {
    for (std::size_t k = 0; k + 1 < items.size(); k += 2) {
      if (items[k].text != key) continue;
      items[k].is_known = true;
      return &items[k + 1];
    }
    return nullptr;
  }

  // The keys that nobody has asked for, each with those of the objects around it: "skeleton.colour".
  void add_unknown_keys(const std::string& around, std::set<std::string>& keys) const {
    if (is(JsonKind::kArray)) {
      for (const JsonTree& item : items) item.add_unknown_keys(around, keys);
    }
    if (!is(JsonKind::kObject)) return;
    for (std::size_t k = 0; k + 1 < items.size(); k += 2) {
      const std::string name = around.empty() ? items[k].text : around + "." + items[k].text;
      if (!items[k].is_known) {
        keys.insert(name);
      } else {
        items[k + 1].add_unknown_keys(name, keys);
      }
    }
  }
};

// Our own records nest at most six deep: object, skeleton, sectors, sector, corners, position.
constexpr std::size_t kDeepest = 16;

// nlohmann's parser calls this for each event. The parser's own trees are not used: they keep numbers as doubles,
// take the last of two equal keys, and allow any depth.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(const LinePlace& place) : place_(place) {}

  [[nodiscard]] JsonTree take() { return std::move(root_); }

  bool null() override { return add(JsonKind::kNull, {}); }
  bool boolean(bool value) override { return add(JsonKind::kBoolean, value ? "true" : "false"); }
  bool number_integer(std::int64_t value) override { return add(JsonKind::kNumber, std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) override { return add(JsonKind::kNumber, std::to_string(value)); }
  bool number_float(double /*value*/, const std::string& text) override { return add(JsonKind::kNumber, text); }
  bool string(std::string& value) override { return add(JsonKind::kString, std::move(value)); }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return false; }  // never called for text
  bool start_array(std::size_t /*size*/) override { return open(JsonKind::kArray); }
  bool start_object(std::size_t /*size*/) override { return open(JsonKind::kObject); }
  bool key(std::string& key) override { return add(JsonKind::kString, std::move(key)); }
  bool end_array() override { return close(); }
  bool end_object() override {
    reject_repeated_keys();
    return close();
  }
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::json::exception& error) override {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) place_.reject("out of range of a double: " + in_quotes(last_token));
    place_.reject("not JSON, in column " + std::to_string(position));
  }

 private:
  // The pointers in open_ stay valid, because the items of a container grow only while none of them is open.
  bool add(JsonKind kind, std::string text) {
    JsonTree value{.kind = kind, .text = std::move(text), .items = {}, .is_known = false};
    if (open_.empty()) {
      root_ = std::move(value);
    } else {
      open_.back()->items.push_back(std::move(value));
    }
    return true;
  }
  bool open(JsonKind kind) {
    if (open_.size() == kDeepest) place_.reject("nested deeper than " + std::to_string(kDeepest) + " levels");
    add(kind, {});
    open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  void reject_repeated_keys() const {
    std::vector<std::string_view> keys;
    const std::vector<JsonTree>& items = open_.back()->items;
    for (std::size_t k = 0; k < items.size(); k += 2) keys.emplace_back(items[k].text);
    std::sort(keys.begin(), keys.end());
    const auto repeated = std::adjacent_find(keys.begin(), keys.end());
    if (repeated != keys.end()) place_.reject("a key twice: " + in_quotes(*repeated));
  }

  LinePlace place_;
  JsonTree root_;
  std::vector<JsonTree*> open_;
};

JsonTree parse_json(std::string_view text, const LinePlace& place) {
  TreeBuilder builder(place);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

// ---- A value ----
// A value of a line of the exchange format, and what messages call it.
//
// Guarantees: a value that is not as asked for is refused, with its name and place. Rationals in strings are exact;
// numbers of JSON are decimals.
class ExchangeValue {
 public:
  ExchangeValue(const JsonTree& tree, std::string_view name, const LinePlace& place)
      : tree_(&tree), name_(name), place_(place) {}

  [[noreturn]] void reject(const std::string& what) const {
    place_.reject("the value of " + in_quotes(name_) + " is not " + what);
  }
  [[nodiscard]] bool is(JsonKind kind) const { return tree_->is(kind); }
  [[nodiscard]] bool is_null() const { return is(JsonKind::kNull); }
  [[nodiscard]] const LinePlace& place() const { return place_; }

  [[nodiscard]] const std::string& text() const {
    if (!is(JsonKind::kString)) reject("a string");
    return tree_->text;
  }
  [[nodiscard]] bool is_true() const { return tree_->text == "true"; }
  // The number as it is written.
  [[nodiscard]] const std::string& number_text() const {
    if (!is(JsonKind::kNumber)) reject("a number");
    return tree_->text;
  }

  // The size of an array. Its parts have the array's name in messages.
  [[nodiscard]] std::size_t size() const {
    if (!is(JsonKind::kArray)) reject("an array");
    return tree_->items.size();
  }
  void expect_size(std::size_t size) const {
    if (this->size() != size) reject("an array of " + std::to_string(size));
  }
  [[nodiscard]] ExchangeValue operator[](std::size_t k) const { return {tree_->items[k], name_, place_}; }

  // The value of an object's key, if it has one.
  [[nodiscard]] std::optional<ExchangeValue> find(std::string_view key) const {
    if (!is(JsonKind::kObject)) reject("an object");
    const JsonTree* const found = tree_->find(key);
    return found == nullptr ? std::nullopt : std::optional<ExchangeValue>(ExchangeValue(*found, key, place_));
  }
  [[nodiscard]] ExchangeValue get(std::string_view key) const {
    const std::optional<ExchangeValue> found = find(key);
    if (!found) place_.reject("no key " + in_quotes(key));
    return *found;
  }

 private:
  const JsonTree* tree_;
  std::string_view name_;
  LinePlace place_;
};

// The list of the results of `each` for the parts of an array.
template <class Each>
auto list_of(const ExchangeValue& value, Each each) {
  std::vector<decltype(each(value))> list;
  const std::size_t size = value.size();
  list.reserve(size);
  for (std::size_t k = 0; k < size; ++k) list.push_back(each(value[k]));
  return list;
}

inline bool bool_of(const ExchangeValue& value) {
  if (!value.is(JsonKind::kBoolean)) value.reject("true or false");
  return value.is_true();
}

inline ClaimedNumber number_of(const ExchangeValue& value) {
  if (value.is(JsonKind::kString)) return claimed_number(value.text(), PlainInteger::kExact, value.place());
  if (!value.is(JsonKind::kNumber)) value.reject("a rational in a string, or a number");
  return claimed_number(value.number_text(), PlainInteger::kDecimal, value.place());
}

inline ClaimedNumber distance_of(const ExchangeValue& value) {
  ClaimedNumber number = number_of(value);
  if (number.value < 0) value.reject("0 or more");
  return number;
}

inline ClaimedPosition position_of(const ExchangeValue& value) {
  value.expect_size(3);
  return {number_of(value[0]), number_of(value[1]), number_of(value[2])};
}

inline std::size_t count_of(const ExchangeValue& value) { return claimed_count(value.number_text(), value.place()); }

inline std::vector<PointId> ids_of(const ExchangeValue& value) {
  return list_of(value, [](const ExchangeValue& id) { return claimed_id(id.number_text(), id.place()); });
}

// ---- Stable sets ----
// The keys of a record that describe its stable set (spec/formats/stationary_points.md). A value that is not as the
// format says throws InvalidInput with the place.

std::vector<PointId> pair_of_ids(const ExchangeValue& value) {
  value.expect_size(2);
  return ids_of(value);
}

std::vector<ClaimedPosition> corners_of(const ExchangeValue& value) {
  auto corners = list_of(value, position_of);
  if (corners.size() < 3) value.reject("three or more corners");
  return corners;
}

ClaimedBackwardSegment segment_of(const ExchangeValue& value) {
  ClaimedBackwardSegment segment;
  segment.samples = pair_of_ids(value.get("samples"));
  segment.front = position_of(value.get("front"));
  segment.back = position_of(value.get("back"));
  if (const auto contact = value.find("front_contact")) segment.front_contact = ids_of(*contact);
  if (const auto contact = value.find("back_contact")) segment.back_contact = ids_of(*contact);
  if (const auto kind = value.find("back_kind")) {
    constexpr std::array kKinds = {"critical", "regular", "edge", "vertex"};
    segment.back_kind = kind->text();
    if (std::ranges::find(kKinds, segment.back_kind) == kKinds.end()) kind->reject("a kind of back");
  }
  return segment;
}

ClaimedInterval interval_of(const ExchangeValue& value) {
  ClaimedInterval interval{ids_of(value.get("polygon")), position_of(value.get("front")),
                           position_of(value.get("back")), std::nullopt};
  if (const auto stationary = value.find("back_is_stationary")) {
    interval.back_is_stationary = bool_of(*stationary);
  }
  return interval;
}

ClaimedSector sector_of(const ExchangeValue& value) {
  return {pair_of_ids(value.get("samples")), corners_of(value.get("corners"))};
}

std::array<std::size_t, 3> triangle_of(const ExchangeValue& value) {
  value.expect_size(3);
  return {count_of(value[0]), count_of(value[1]), count_of(value[2])};
}

ClaimedStable stable_of(const ExchangeValue& value) {
  ClaimedStable stable;
  if (const auto count = value.find("segments")) stable.segments = count_of(*count);
  if (const auto flag = value.find("has_vertex")) stable.has_vertex = bool_of(*flag);
  if (const auto flag = value.find("has_interval")) stable.has_interval = bool_of(*flag);
  if (const auto boundary = value.find("boundary")) stable.boundary = list_of(*boundary, ids_of);
  if (const auto walk = value.find("walk"); walk && !walk->is_null()) stable.walk = ids_of(*walk);
  return stable;
}

ClaimedSkeleton skeleton_of(const ExchangeValue& value) {
  ClaimedSkeleton skeleton;
  skeleton.segments = list_of(value.get("segments"), segment_of);
  if (const auto intervals = value.find("intervals")) skeleton.intervals = list_of(*intervals, interval_of);
  if (const auto sectors = value.find("sectors")) skeleton.sectors = list_of(*sectors, sector_of);
  if (const auto orbits = value.find("orbits")) {
    skeleton.orbits = list_of(*orbits, [](const ExchangeValue& chain) { return list_of(chain, count_of); });
    for (const auto& chain : *skeleton.orbits) {
      for (const std::size_t place : chain) {
        if (place >= skeleton.segments.size()) orbits->reject("chains of the segments: there are not so many");
      }
    }
  }
  return skeleton;
}

ClaimedSurface surface_of(const ExchangeValue& value) {
  ClaimedSurface surface;
  surface.vertices = list_of(value.get("vertices"), position_of);
  const ExchangeValue triangles = value.get("triangles");
  surface.triangles = list_of(triangles, triangle_of);
  for (const auto& triangle : surface.triangles) {
    for (const std::size_t vertex : triangle) {
      if (vertex >= surface.vertices.size()) triangles.reject("triangles of the vertices: there are not so many");
    }
  }
  return surface;
}

// ---- A file ----
// Rationals in strings are exact; numbers of JSON are decimals. Unknown keys are listed. A known key with a wrong value
// is an error. So is a known key that does not belong to points of this index.

constexpr std::string_view kFormatName = "flowcert-stationary-points";

int index_of(const ExchangeValue& value) { return claimed_index(value.number_text(), value.place()); }

// The header.

std::array<std::size_t, 3> regular_counts_of(const ExchangeValue& value) {
  return {count_of(value.get("1-2")), count_of(value.get("1-3")), count_of(value.get("2-3"))};
}

std::string sha256_of(const ExchangeValue& value) {
  const std::string& text = value.text();
  const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (text.size() != 64 || !std::all_of(text.begin(), text.end(), is_hex))
    value.reject("64 lower case hexadecimal digits");
  return text;
}

ClaimedIndices indices_of(const ExchangeValue& value) {
  ClaimedIndices indices{};
  for (const int index : list_of(value, index_of)) {
    bool& is_claimed = indices.at(static_cast<std::size_t>(index));
    if (is_claimed) value.reject("indices: " + std::to_string(index) + " is there twice");
    is_claimed = true;
  }
  return indices;
}

Claim claim_of_header(const ExchangeValue& header) {
  const ExchangeValue format = header.get("format");
  if (format.text() != kFormatName) format.reject(in_quotes(kFormatName));
  const ExchangeValue version = header.get("format_version");
  if (version.number_text() != "1") version.reject("1, the only version that is known");
  Claim claim;
  if (const auto value = header.find("points")) claim.point_count = count_of(*value);
  if (const auto value = header.find("merged_duplicates")) claim.merged_duplicates = count_of(*value);
  if (const auto value = header.find("input_sha256")) claim.input_sha256 = sha256_of(*value);
  if (const auto value = header.find("classes")) claim.classes = list_of(*value, ids_of);
  if (const auto value = header.find("indices")) claim.indices = indices_of(*value);
  if (const auto value = header.find("critical")) {
    value->expect_size(4);
    claim.critical_counts = {count_of((*value)[0]), count_of((*value)[1]), count_of((*value)[2]),
                             count_of((*value)[3])};
  }
  if (const auto value = header.find("regular_stationary")) claim.regular_counts = regular_counts_of(*value);
  // These say what made the file, and how.
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal"}) {
    if (const auto value = header.find(key)) (void)value->text();
  }
  if (const auto value = header.find("centers")) {
    constexpr std::array kForms = {"exact", "double", "none"};
    if (std::ranges::find(kForms, value->text()) == kForms.end()) value->reject("'exact', 'double' or 'none'");
  }
  return claim;
}

// Records.

void read_index(const ExchangeValue& record, ClaimedPoint& point) {
  const ExchangeValue index = record.get("index");
  if (index.is(JsonKind::kArray)) {
    index.expect_size(2);
    point.index = index_of(index[0]);
    point.hull_dimension = index_of(index[1]);
    if (point.index < 1 || point.index >= *point.hull_dimension) index.reject("a kind: [1,2], [2,3], [1,3]");
  } else {
    point.index = index_of(index);
  }
  const auto kind = record.find("kind");
  const char* const expected = point.hull_dimension ? "regular" : "critical";
  if (kind && kind->text() != expected) kind->reject(in_quotes(expected) + ", which the index says");
}

std::optional<ClaimedNumber> number_or_null(const ExchangeValue& value) {
  return value.is_null() ? std::nullopt : std::optional(number_of(value));
}

std::array<std::optional<ClaimedNumber>, 3> doubles_of(const ExchangeValue& value) {
  value.expect_size(3);
  return {number_or_null(value[0]), number_or_null(value[1]), number_or_null(value[2])};
}

// Takes center, or else center_double, and squared_distance in the same way. A double is null if none is near. Beside
// the exact value it is kept apart.
void read_sphere(const ExchangeValue& record, ClaimedPoint& point) {
  if (const auto center = record.find("center")) {
    point.center = position_of(*center);
    if (const auto near = record.find("center_double"); near && !near->is_null()) {
      point.rounded_center = doubles_of(*near);
    }
  } else if (const auto near = record.find("center_double"); near && !near->is_null()) {
    near->expect_size(3);
    if (!(*near)[0].is_null() && !(*near)[1].is_null() && !(*near)[2].is_null()) point.center = position_of(*near);
  }
  if (const auto distance = record.find("squared_distance")) {
    point.squared_distance = distance_of(*distance);
    if (const auto near = record.find("squared_distance_double")) {
      point.rounded_squared_distance = near->is_null() ? std::nullopt : std::optional(distance_of(*near));
      point.has_rounded_squared_distance = true;
    }
  } else if (const auto near = record.find("squared_distance_double"); near && !near->is_null()) {
    point.squared_distance = distance_of(*near);
  }
}

ClaimedTarget limit_of(const ExchangeValue& value) {
  if (value.is_null()) return {.is_infinity = true, .contact = {}};
  return {.is_infinity = false, .contact = ids_of(value)};
}

ClaimedSegment flow_segment_of(const ExchangeValue& value) {
  ClaimedSegment segment;
  if (const auto type = value.find("type")) segment.type = type->text();
  if (const auto driver = value.find("driver")) segment.driver = position_of(*driver);
  const ExchangeValue end = value.get("end");
  if (!end.is_null()) segment.end = position_of(end);
  return segment;
}

ClaimedPolyline polyline_of(const ExchangeValue& value) { return list_of(value, flow_segment_of); }

// Finds a key that only critical points of one index may have.
std::optional<ExchangeValue> find_of_index(const ExchangeValue& record, const ClaimedPoint& point, const char* key,
                                           int index) {
  const auto value = record.find(key);
  if (value && (point.hull_dimension || point.index != index)) {
    record.place().reject(std::string("a key of critical points of index ") + std::to_string(index) +
                          " only: " + in_quotes(key));
  }
  return value;
}

void read_flow(const ExchangeValue& record, ClaimedPoint& point) {
  if (const auto samples = find_of_index(record, point, "samples", 1)) point.samples = ids_of(*samples);
  if (const auto limits = find_of_index(record, point, "limits", 2)) {
    limits->expect_size(2);
    point.successors = list_of(*limits, limit_of);
    point.successors_by_side = true;
  }
  if (const auto u2 = find_of_index(record, point, "u2", 2)) {
    u2->expect_size(2);
    point.u2 = list_of(*u2, polyline_of);
  }
}

// Reads keys that only critical points of index 2 and regular stationary points may have.
void read_stable(const ExchangeValue& record, ClaimedPoint& point) {
  for (const char* key : {"stable", "skeleton", "surface"}) {
    const auto value = record.find(key);
    if (!value) continue;
    if (!point.hull_dimension && point.index != 2) {
      record.place().reject("a key of critical points of index 2 and of regular stationary points only: " +
                            in_quotes(key));
    }
    if (key == std::string_view("stable")) point.stable = stable_of(*value);
    if (key == std::string_view("skeleton")) point.skeleton = skeleton_of(*value);
    if (key == std::string_view("surface")) point.surface = surface_of(*value);
  }
  if (point.hull_dimension && point.stable && point.stable->boundary) {
    record.place().reject("a boundary, which only critical points have");
  }
}

ClaimedPoint point_of(const ExchangeValue& record) {
  ClaimedPoint point;
  point.line = record.place().line;
  read_index(record, point);
  if (const auto contact = record.find("contact")) {
    point.contact = ids_of(*contact);
    if (point.contact.empty()) contact->reject("a contact set: it is empty");
  }
  read_sphere(record, point);
  if (point.contact.empty() && !point.center) record.place().reject("neither 'contact' nor 'center'");
  read_flow(record, point);
  read_stable(record, point);
  return point;
}

bool recognises_exchange(std::string_view bytes) {
  const auto* const first = std::find_if_not(bytes.begin(), bytes.end(), is_blank);
  return first != bytes.end() && *first == '{';
}

Claim read_exchange(std::string_view text, std::string_view file) {
  LineReader lines(text, file);
  std::string_view line;
  lines.next_filled(line);
  const JsonTree header = parse_json(line, lines.place());
  Claim claim = claim_of_header({header, "header", lines.place()});
  std::set<std::string> unknown;
  header.add_unknown_keys("", unknown);
  while (lines.next_filled(line)) {
    const JsonTree record = parse_json(line, lines.place());
    claim.points.push_back(point_of({record, "record", lines.place()}));
    record.add_unknown_keys("", unknown);
  }
  claim.unknown_keys.assign(unknown.begin(), unknown.end());
  return claim;
}

}  // namespace

const ClaimFormat kExchangeClaims = {.name = "exchange", .recognises = recognises_exchange, .read = read_exchange};

}  // namespace flowcert::io
