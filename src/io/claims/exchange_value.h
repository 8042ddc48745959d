// A line of the exchange format in memory: JSON, and what its values mean in claims.
//
// Guarantees: a value that is not as asked for is refused, with its name and place. Rationals in strings are exact;
// numbers of JSON are decimals, and stay text. InvalidInput names the place of anything that is not JSON (RFC 8259),
// nests deeper than a claim can, has a key twice in one object, or has a number out of a double's range.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/claim.h"
#include "io/layer.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

// ---- JSON ----
// One value in memory. Numbers stay text, because a claim's decimals must not become doubles.

// Keys that nobody has asked for, ascending. A claim can have millions, so the first hundred are kept.
class UnknownKeys {
 public:
  void insert(const std::string& key) {
    if (keys_.size() < kMost) {
      keys_.insert(key);
    } else if (!keys_.contains(key)) {
      has_more_ = true;
    }
  }
  void tell(Claim& claim) const {
    claim.unknown_keys.assign(keys_.begin(), keys_.end());
    claim.has_more_unknown_keys = has_more_;
  }

 private:
  static constexpr std::size_t kMost = 100;
  std::set<std::string> keys_;
  bool has_more_ = false;
};

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
  void add_unknown_keys(const std::string& around, UnknownKeys& keys) const {
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

[[nodiscard]] JsonTree parse_json(std::string_view text, const LinePlace& place);

// ---- A value ----
// A value of a line of the exchange format, and what messages call it.
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

// ---- Headers ----

[[nodiscard]] std::array<std::size_t, 4> critical_counts_of(const ExchangeValue& value);
[[nodiscard]] std::array<std::size_t, 3> regular_counts_of(const ExchangeValue& value);
// Which input it is, and what has made the file. What made it is not kept.
void read_input_fields(const ExchangeValue& header, Claim& claim);

}  // namespace flowcert::io
