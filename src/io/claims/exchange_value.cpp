// Memory is bounded by a multiple of the text, recursion by the depth.
#include "io/claims/exchange_value.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/json_limits.h"

namespace flowcert::io {

namespace {

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
  bool number_float(double /*value*/, const std::string& text) override {
    // The parser writes the point as the locale of the process has it.
    std::string number = text;
    std::ranges::replace_if(
        number, [](char c) { return !is_digit(c) && c != '+' && c != '-' && c != 'e' && c != 'E'; }, '.');
    return add(JsonKind::kNumber, std::move(number));
  }
  bool string(std::string& value) override { return add(JsonKind::kString, std::move(value)); }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return false; }  // never called for text
  bool start_array(std::size_t /*size*/) override { return open(JsonKind::kArray); }
  bool start_object(std::size_t /*size*/) override { return open(JsonKind::kObject); }
  bool key(std::string& key) override {
    require(limits_.key());
    return add(JsonKind::kString, std::move(key));
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
    require(limits_.open());
    add(kind, {});
    open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
    return true;
  }
  void require(const std::string& fault) const {
    if (!fault.empty()) place_.reject(fault);
  }
  bool close() {
    limits_.close();
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
  JsonLimits limits_;
  JsonTree root_;
  std::vector<JsonTree*> open_;
};

}  // namespace

JsonTree parse_json(std::string_view text, const LinePlace& place) {
  TreeBuilder builder(place);
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

// ---- Headers ----

namespace {

std::string sha256_of(const ExchangeValue& value) {
  const std::string& text = value.text();
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
  if (const auto value = header.find("input_sha256")) claim.input_sha256 = sha256_of(*value);
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal"}) {
    if (const auto value = header.find(key)) (void)value->text();
  }
}

}  // namespace flowcert::io
