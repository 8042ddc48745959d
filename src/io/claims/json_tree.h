// One JSON value in memory, with numbers as they are written: a claim's decimals must not become doubles.
//
// Guarantees: what is not JSON (RFC 8259), nests deeper than a claim can, names a key of an object twice, or
// has a number out of a double's range throws InvalidInput with the place. Memory is bounded by a multiple of
// the text, recursion by the depth.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/line_reader.h"

namespace flowcert::io {

enum class JsonKind { kNull, kBoolean, kNumber, kString, kArray, kObject };

struct JsonTree {
  JsonKind kind = JsonKind::kNull;
  std::string text;             // of a number, as written; of a string, its value
  std::vector<JsonTree> items;  // of an array; of an object its keys and values in turn

  [[nodiscard]] bool is(JsonKind other) const { return kind == other; }
  // The value of a key of an object; null where it has none.
  [[nodiscard]] const JsonTree* find(std::string_view key) const;
};

[[nodiscard]] JsonTree parse_json(std::string_view text, const LinePlace& place);

}  // namespace flowcert::io
