// The parts of JSON that several outputs and claims share (spec/formats/). Each is spelled only here.
//
// Guarantees: rationals are written and read exactly, as strings; keys stay in the order in which the formats list
// them.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/orbit.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/write_persistence.h"
#include "io/layer.h"

namespace flowcert::io {

// ---- Written ----

using Json = nlohmann::ordered_json;

// format, format_version and the reproducibility line. With points, also input_sha256 and, where there
// are any, the rows that were left out.
[[nodiscard]] Json header_fields(const char* format, int format_version);
[[nodiscard]] Json header_fields(const char* format, int format_version, const PointSet& points);

// points, merged_duplicates, critical, regular_stationary, appended to an object.
void add_counts(Json& object, const PointSet& points, const StationaryPoints& stationary);

// 0 to 3, or the pair of a regular stationary point's kind.
[[nodiscard]] Json index_field(StationaryIndex index);

[[nodiscard]] Json center_field(const RationalPoint& point);
// null for an infinity, which stands for a number beyond the doubles.
[[nodiscard]] Json double_field(double value);

// type, driver, end.
[[nodiscard]] Json segment_field(const FlowSegment& segment);
// The same, with the three contact sets.
[[nodiscard]] Json segment_with_contacts_field(const FlowSegment& segment);
// Where an orbit ends: kind, index, position, contact, squared_distance. Without a limit it ends at infinity.
[[nodiscard]] Json limit_field(const PointSet& points, const std::optional<StationaryLimit>& limit);

// The object `stable`: what is known of the i-th set without its geometry.
[[nodiscard]] Json stable_field(const StationaryPoints& stationary, const StableManifolds& s2, std::size_t i);

// A critical point with its value, exact, and the doubles nearest to these.
[[nodiscard]] Json critical_point_field(const FlowComplex& complex, std::size_t record,
                                        const Rational& squared_distance);
// A pair: its exact values, and the doubles nearest to them.
[[nodiscard]] Json pair_field(const PersistenceDiagram& diagram, const PersistencePair& pair);

// ---- Read ----
// Each function checks that a claim in JSON has a key, or that a value has its type. Otherwise it throws
// InvalidInput: "no key 'end'", "'end' is no string".
[[nodiscard]] const Json& required_field(const Json& object, const char* key);

// what: the key that the value belongs to, for messages.
[[nodiscard]] const Json::string_t& required_string(const Json& value, const char* what);
[[nodiscard]] const Json& required_array(const Json& value, const char* what);
// A string that exact_rational() takes.
[[nodiscard]] Rational required_rational(const Json& value, const char* what);

// ---- JSON from somebody else ----
// How deep it may nest, and how many keys an object may have: readers recurse, and look keys up one by one. Both are
// far beyond what any of our formats needs.

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
