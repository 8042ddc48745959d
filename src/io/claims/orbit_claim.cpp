// Reads orbits from JSON objects.
#include "flowcert/orbit_claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/floating_point.h"
#include "io/json_limits.h"

namespace flowcert {

using namespace io;

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
    if (!id.is_number_unsigned() || id.get<std::uint64_t>() >= (std::uint64_t{1} << 31)) {
      throw InvalidInput(fmt::format("'{}' has something that is no id", what));
    }
    ids.push_back(id.get<PointId>());
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

// The text of an index. JSON's 2.0 is the number 2.
std::string index_of(const Json& value) {
  const bool is_whole = value.is_number_float() && value.get<double>() == std::floor(value.get<double>()) &&
                        std::abs(value.get<double>()) < 1e15;
  if (is_whole) return std::to_string(value.get<std::int64_t>());
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
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

OrbitPath claimed_orbit_of(const std::string& bytes, const std::string& name) {
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
