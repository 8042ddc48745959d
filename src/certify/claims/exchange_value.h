// A line of the exchange format in memory: JSON, and what its values mean in claims.
//
// Guarantees: a value that is not as asked for is refused, with its name and place. Rationals in strings are exact;
// numbers of JSON are decimals, and stay text. InvalidInput names the place of anything that is not JSON (RFC 8259),
// nests deeper than a claim can, has a key twice in one object, or has a number out of a double's range.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <memory>
#include <memory_resource>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "certify/layer.h"
#include "flowcert/claim.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::certify {

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

// A JSON text, value by value in the order of the text: an array or object stands before what is in it. A value takes
// 32 bytes and its text, because one line of a claim may have millions of them.
class JsonDocument {
 public:
  using Place = std::uint32_t;
  static constexpr Place kNone = 0xffffffffU;

  [[nodiscard]] JsonKind kind(Place at) const { return nodes_[at].kind; }
  // A number as written, or the value of a string.
  [[nodiscard]] std::string_view text(Place at) const { return nodes_[at].text; }
  // How many items an array has, or keys and values an object.
  [[nodiscard]] std::size_t size(Place at) const { return nodes_[at].size; }
  // The first item of an array, or key of an object, and what follows an item: the next one, if there is one.
  [[nodiscard]] static Place first(Place at) { return at + 1; }
  [[nodiscard]] Place next(Place item) const { return nodes_[item].end; }
  [[nodiscard]] Place item(Place at, std::size_t k) const;
  // The value of an object's key, or kNone. The key is then known.
  [[nodiscard]] Place find(Place at, std::string_view key) const;
  // The keys that nobody has asked for, each with those of the objects around it: "skeleton.colour".
  void add_unknown_keys(UnknownKeys& keys) const { add_unknown_keys(0, "", keys); }

 private:
  friend class DocumentBuilder;
  struct Node {
    JsonKind kind = JsonKind::kNull;
    mutable bool is_known = false;  // of a key: somebody has asked for it
    std::uint32_t size = 0;
    Place end = 0;
    std::string_view text;
  };
  void add_unknown_keys(Place at, const std::string& around, UnknownKeys& keys) const;

  std::deque<Node> nodes_;  // the first one is the whole
  std::unique_ptr<std::pmr::monotonic_buffer_resource> texts_;
};

[[nodiscard]] JsonDocument parse_json(std::string_view text, const LinePlace& place);

// ---- A value ----
// A value of a line of the exchange format, and what messages call it.
class ExchangeValue {
 public:
  // The document must outlive it.
  ExchangeValue(const JsonDocument& document, std::string_view name, const LinePlace& place)
      : ExchangeValue(document, 0, name, place) {}

  [[noreturn]] void reject(const std::string& what) const {
    place_.reject("the value of " + in_quotes(name_) + " is not " + what);
  }
  [[nodiscard]] bool is(JsonKind kind) const { return document_->kind(at_) == kind; }
  [[nodiscard]] bool is_null() const { return is(JsonKind::kNull); }
  [[nodiscard]] const LinePlace& place() const { return place_; }

  [[nodiscard]] std::string_view text() const {
    if (!is(JsonKind::kString)) reject("a string");
    return document_->text(at_);
  }
  [[nodiscard]] bool is_true() const { return document_->text(at_) == "true"; }
  // words: the texts, as a message lists them.
  void expect_one_of(std::initializer_list<std::string_view> texts, const char* words) const {
    if (std::ranges::find(texts, text()) == texts.end()) reject(words);
  }
  // The number as it is written.
  [[nodiscard]] std::string_view number_text() const {
    if (!is(JsonKind::kNumber)) reject("a number");
    return document_->text(at_);
  }

  // The size of an array. Its parts have the array's name in messages.
  [[nodiscard]] std::size_t size() const {
    if (!is(JsonKind::kArray)) reject("an array");
    return document_->size(at_);
  }
  void expect_size(std::size_t size) const {
    if (this->size() != size) reject("an array of " + std::to_string(size));
  }
  // O(k).
  [[nodiscard]] ExchangeValue operator[](std::size_t k) const {
    return {*document_, document_->item(at_, k), name_, place_};
  }
  // Calls use(part) for all parts of an array.
  template <class Use>
  void for_each(const Use& use) const {
    auto at = JsonDocument::first(at_);
    for (std::size_t k = size(); k > 0; --k, at = document_->next(at))
      use(ExchangeValue(*document_, at, name_, place_));
  }

  // The value of an object's key, if it has one.
  [[nodiscard]] std::optional<ExchangeValue> find(std::string_view key) const {
    if (!is(JsonKind::kObject)) reject("an object");
    const JsonDocument::Place found = document_->find(at_, key);
    if (found == JsonDocument::kNone) return std::nullopt;
    return ExchangeValue(*document_, found, key, place_);
  }
  [[nodiscard]] ExchangeValue get(std::string_view key) const {
    const std::optional<ExchangeValue> found = find(key);
    if (!found) place_.reject("no key " + in_quotes(key));
    return *found;
  }

 private:
  ExchangeValue(const JsonDocument& document, JsonDocument::Place at, std::string_view name, const LinePlace& place)
      : document_(&document), at_(at), name_(name), place_(place) {}

  const JsonDocument* document_;
  JsonDocument::Place at_;
  std::string_view name_;
  LinePlace place_;
};

// The list of the results of `each` for the parts of an array.
template <class Each>
auto list_of(const ExchangeValue& value, Each each) {
  std::vector<decltype(each(value))> list;
  list.reserve(value.size());
  value.for_each([&](const ExchangeValue& part) { list.push_back(each(part)); });
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

inline std::size_t count_of(const ExchangeValue& value) { return written_size(value.number_text(), value.place()); }

inline std::vector<PointId> ids_of(const ExchangeValue& value) {
  return list_of(value, [](const ExchangeValue& id) { return claimed_id(id.number_text(), id.place()); });
}

inline std::vector<PointId> contact_of(const ExchangeValue& value) {
  std::vector<PointId> contact = ids_of(value);
  if (contact.empty()) value.reject("a contact set: it is empty");
  return contact;
}

inline int index_of(const ExchangeValue& value) { return claimed_index(value.number_text(), value.place()); }

// An index, or the pair of a kind. to: a ClaimedPoint or a ClaimedCellPart.
void read_index(const ExchangeValue& value, auto& to) {
  if (value.is(JsonKind::kArray)) {
    value.expect_size(2);
    to.index = index_of(value[0]);
    to.hull_dimension = index_of(value[1]);
    if (to.index < 1 || to.index >= *to.hull_dimension) value.reject("a kind: [1,2], [2,3], [1,3]");
  } else {
    to.index = index_of(value);
  }
}

// ---- Headers ----

[[nodiscard]] std::array<std::size_t, 4> critical_counts_of(const ExchangeValue& value);
[[nodiscard]] std::array<std::size_t, 3> regular_counts_of(const ExchangeValue& value);
// Which input it is, and what has made the file. What made it is not kept.
void read_input_fields(const ExchangeValue& header, Claim& claim);

}  // namespace flowcert::certify
