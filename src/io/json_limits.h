// How deep JSON from somebody else may nest, and how many keys an object may have: readers recurse, and look keys up
// one by one. Both are far beyond what any of our formats needs.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/json_fields.h"
#include "io/layer.h"

namespace flowcert::io {

// Our own records nest at most eight deep: object, u1, sheets, sheet, corners, corner, vector, position.
inline constexpr std::size_t kDeepestJson = 16;
inline constexpr std::size_t kMostJsonKeys = 1000;

// Counts while a parser goes through a text. Each call returns what is wrong then, or nothing.
class JsonLimits {
 public:
  [[nodiscard]] std::string open();
  [[nodiscard]] std::string key();
  void close() { keys_.pop_back(); }

 private:
  std::vector<std::size_t> keys_;  // of each array or object that is open
};

// The place of a byte that no JSON has (FC-FILE-47), though nlohmann's parser passes over it: a byte order mark in
// front, or NUL, which it takes for the end. npos if there is none.
[[nodiscard]] std::size_t place_of_no_json(std::string_view text);

// The text as JSON. Throws InvalidInput, "NAME: reason", where it is not JSON or beyond the limits. O(n).
[[nodiscard]] Json parse_foreign_json(std::string_view text, std::string_view name);

}  // namespace flowcert::io
