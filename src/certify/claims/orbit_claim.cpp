// Reads orbits from JSON objects.
#include "certify/orbit_claim.h"

#include <fmt/format.h>

#include <algorithm>

#include "certify/layer.h"
#include "geometry/floating_point.h"
#include "io/json_fields.h"
#include "io/number_text.h"

namespace flowcert {

using namespace certify;

namespace {

RationalPoint position_of(const Json& value, const char* what) {
  if (!value.is_array() || value.size() != 3) {
    throw InvalidInput(fmt::format("'{}' is no array of three rationals", what));
  }
  RationalPoint position;
  for (std::size_t k = 0; k < 3; ++k) position.at(k) = required_rational(value[k], what);
  return position;
}

std::vector<PointId> ids_of(const Json& value, const char* what) {
  std::vector<PointId> ids;
  for (const Json& id : required_array(value, what)) {
    const std::int64_t number = id.is_number_integer() ? id.get<std::int64_t>() : -1;
    if (number < 0 || number > kLargestId) {
      throw InvalidInput(fmt::format("'{}' has something that is no id", what));
    }
    ids.push_back(static_cast<PointId>(number));
  }
  std::ranges::sort(ids);
  return ids;
}

std::optional<std::vector<PointId>> contact_of(const Json& segment, const char* key) {
  const auto value = segment.find(key);
  if (value == segment.end() || value->is_null()) return std::nullopt;
  return ids_of(*value, key);
}

PathSegment segment_of(const Json& object) {
  PathSegment segment;
  segment.type = required_string(required_field(object, "type"), "type");
  segment.driver = position_of(required_field(object, "driver"), "driver");
  const Json& end = required_field(object, "end");
  if (!end.is_null()) segment.end = position_of(end, "end");
  segment.start_contact = contact_of(object, "start_contact");
  segment.crossed_contact = contact_of(object, "crossed_contact");
  segment.end_contact = contact_of(object, "end_contact");
  return segment;
}

bool is_index(const Json& value) {
  return value.is_number_integer() && 0 <= value.get<std::int64_t>() && value.get<std::int64_t>() <= 3;
}

// The text of an index, or of the pair of a kind.
std::string index_of(const Json& value) {
  const bool is_kind = value.is_array() && value.size() == 2 && is_index(value[0]) && is_index(value[1]);
  if (!is_kind && !is_index(value)) throw InvalidInput("'index' is no index, 0 to 3, and no pair of them");
  return value.dump();
}

std::optional<PathLimit> limit_of(const Json& object) {
  const std::string kind = required_string(required_field(object, "kind"), "kind");
  if (kind == "infinity") return std::nullopt;
  return PathLimit{kind, index_of(required_field(object, "index")),
                   position_of(required_field(object, "position"), "position"),
                   ids_of(required_field(object, "contact"), "contact"),
                   required_rational(required_field(object, "squared_distance"), "squared_distance")};
}

}  // namespace

OrbitPath claimed_orbit_of(std::string_view bytes, const std::string& name) {
  const geometry::IeeeDoubles ieee;
  try {
    const Json object = parse_foreign_json(bytes, name);
    OrbitPath path;
    for (const Json& segment : required_array(required_field(object, "segments"), "segments"))
      path.segments.push_back(segment_of(segment));
    path.limit = limit_of(required_field(object, "limit"));
    return path;
  } catch (const Json::exception& error) {
    throw InvalidInput(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace flowcert
