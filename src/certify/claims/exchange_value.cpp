// Memory is bounded by a multiple of the text, recursion by the depth.
#include "certify/claims/exchange_value.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/json_fields.h"

namespace flowcert::certify {

// nlohmann's parser calls this for each event. The parser's own trees are not used: they keep numbers as doubles,
// take the last of two equal keys, and allow any depth.
class DocumentBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit DocumentBuilder(const LinePlace& place) : place_(place) {
    document_.texts_ = std::make_unique<std::pmr::monotonic_buffer_resource>();
  }

  [[nodiscard]] JsonDocument take() { return std::move(document_); }

  bool null() override { return add(JsonKind::kNull, {}); }
  bool boolean(bool value) override { return add(JsonKind::kBoolean, value ? "true" : "false"); }
  bool number_integer(std::int64_t value) override { return add(JsonKind::kNumber, std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) override { return add(JsonKind::kNumber, std::to_string(value)); }
  bool number_float(double /*value*/, const std::string& text) override {
    // The parser writes the point as the locale of the process has it.
    std::string number = text;
    std::ranges::replace_if(
        number, [](char c) { return !is_digit(c) && c != '+' && c != '-' && c != 'e' && c != 'E'; }, '.');
    return add(JsonKind::kNumber, number);
  }
  bool string(std::string& value) override { return add(JsonKind::kString, value); }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return false; }  // never called for text
  bool start_array(std::size_t /*size*/) override { return open(JsonKind::kArray); }
  bool start_object(std::size_t /*size*/) override { return open(JsonKind::kObject); }
  bool key(std::string& key) override {
    require(limits_.key());
    return add(JsonKind::kString, key);
  }
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
  bool add(JsonKind kind, std::string_view text) {
    auto& nodes = document_.nodes_;
    if (nodes.size() >= JsonDocument::kNone) place_.reject("more values than 4294967294");
    if (!open_.empty()) ++nodes[open_.back()].size;
    const auto end = static_cast<JsonDocument::Place>(nodes.size() + 1);
    nodes.push_back({.kind = kind, .is_known = false, .size = 0, .end = end, .text = kept(text)});
    return true;
  }
  std::string_view kept(std::string_view text) {
    if (text.empty()) return {};
    auto* const place = static_cast<char*>(document_.texts_->allocate(text.size(), 1));
    std::ranges::copy(text, place);
    return {place, text.size()};
  }
  bool open(JsonKind kind) {
    require(limits_.open());
    add(kind, {});
    open_.push_back(static_cast<JsonDocument::Place>(document_.nodes_.size() - 1));
    return true;
  }
  void require(const std::string& fault) const {
    if (!fault.empty()) place_.reject(fault);
  }
  bool close() {
    limits_.close();
    document_.nodes_[open_.back()].end = static_cast<JsonDocument::Place>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }
  void reject_repeated_keys() const {
    std::vector<std::string_view> keys;
    JsonDocument::Place at = JsonDocument::first(open_.back());
    for (std::size_t k = document_.size(open_.back()); k > 0; k -= 2) {
      keys.push_back(document_.text(at));
      at = document_.next(document_.next(at));
    }
    std::sort(keys.begin(), keys.end());
    const auto repeated = std::adjacent_find(keys.begin(), keys.end());
    if (repeated != keys.end()) place_.reject("a key twice: " + in_quotes(*repeated));
  }

  LinePlace place_;
  JsonLimits limits_;
  JsonDocument document_;
  std::vector<JsonDocument::Place> open_;
};

JsonDocument parse_json(std::string_view text, const LinePlace& place) {
  if (const std::size_t at = place_of_no_json(text); at != std::string_view::npos) {
    place.reject("not JSON, in column " + std::to_string(at + 1));
  }
  DocumentBuilder builder(place);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

JsonDocument::Place JsonDocument::item(Place at, std::size_t k) const {
  Place place = first(at);
  for (; k > 0; --k) place = next(place);
  return place;
}

JsonDocument::Place JsonDocument::find(Place at, std::string_view key) const {
  Place name = first(at);
  for (std::size_t k = size(at); k > 0; k -= 2) {
    const Place value = next(name);
    if (text(name) == key) {
      nodes_[name].is_known = true;
      return value;
    }
    name = next(value);
  }
  return kNone;
}

void JsonDocument::add_unknown_keys(Place at, const std::string& around, UnknownKeys& keys) const {
  Place item = first(at);
  if (kind(at) == JsonKind::kArray) {
    for (std::size_t k = size(at); k > 0; --k, item = next(item)) add_unknown_keys(item, around, keys);
  }
  if (kind(at) != JsonKind::kObject) return;
  for (std::size_t k = size(at); k > 0; k -= 2) {
    const Place value = next(item);
    std::string name = around;
    if (!name.empty()) name += '.';
    name += text(item);
    if (nodes_[item].is_known) {
      add_unknown_keys(value, name, keys);
    } else {
      keys.insert(name);
    }
    item = next(value);
  }
}

// ---- Headers ----

namespace {

std::string_view sha256_of(const ExchangeValue& value) {
  const std::string_view text = value.text();
  const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (text.size() != 64 || !std::all_of(text.begin(), text.end(), is_hex))
    value.reject("64 lower case hexadecimal digits");
  return text;
}

}  // namespace

std::array<std::size_t, 4> critical_counts_of(const ExchangeValue& value) {
  value.expect_size(4);
  return {count_of(value[0]), count_of(value[1]), count_of(value[2]), count_of(value[3])};
}

std::array<std::size_t, 3> regular_counts_of(const ExchangeValue& value) {
  return {count_of(value.get("1-2")), count_of(value.get("1-3")), count_of(value.get("2-3"))};
}

void read_input_fields(const ExchangeValue& header, Claim& claim) {
  if (const auto value = header.find("points")) claim.point_count = count_of(*value);
  if (const auto value = header.find("merged_duplicates")) claim.merged_duplicates = count_of(*value);
  if (const auto value = header.find("input_sha256")) claim.input_sha256.emplace(sha256_of(*value));
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal"}) {
    if (const auto value = header.find(key)) (void)value->text();
  }
}

}  // namespace flowcert::certify
