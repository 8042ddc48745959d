// A function for each shape, and for each piece with more keys than its shape. Limits are named by their contact sets,
// as everywhere.
#include "io/manifold_fields.h"

#include "flowcert/sphere.h"

namespace flowcert::io {

// ---- Pieces ----

namespace {

// A position, or an object with a vector where it is at infinity.
Json corner_field(const Corner<>& corner) {
  if (!corner.at_infinity) return center_field(corner.position);
  Json field;
  field["vector"] = center_field(corner.position);
  return field;
}

Json field_of(const EdgePart<>& part) {
  Json field;
  field["polygon"] = part.polygon;
  field["from"] = corner_field(part.front);
  field["to"] = corner_field(part.back);
  return field;
}

Json field_of(const Crossing<>& ray) {
  Json field;
  field["samples"] = ray.samples;
  field["start"] = corner_field(ray.back);
  field["end"] = corner_field(ray.front);
  return field;
}

Json field_of(const Region<>& region) {
  Json field;
  field["samples"] = region.samples;
  Json& corners = field["corners"] = Json::array();
  for (const Corner<>& corner : region.corners) corners.push_back(corner_field(corner));
  return field;
}

// A front at infinity has a key of its own.
void add_ends(const Corner<>& front, const Corner<>& back, Json& field) {
  field[front.at_infinity ? "vector" : "front"] = center_field(front.position);
  field["back"] = center_field(back.position);
}

Json field_of(const BackwardSegment<>& segment) {
  Json field;
  field["samples"] = segment.samples;
  add_ends(segment.front, segment.back, field);
  if (!segment.front.at_infinity) field["front_contact"] = segment.front_contact;
  field["back_contact"] = segment.back_contact;
  field["back_kind"] = back_kind_text(segment.back_kind);
  return field;
}

Json field_of(const BackwardInterval<>& interval) {
  Json field;
  field["polygon"] = interval.polygon;
  add_ends(interval.front, interval.back, field);
  field["back_is_stationary"] = interval.back_is_stationary;
  return field;
}

template <class Piece>
Json list_field(const std::vector<Piece>& pieces) {
  Json field = Json::array();
  for (const Piece& piece : pieces) field.push_back(field_of(piece));
  return field;
}

template <class Piece>
void write_list(std::ostream& out, const std::vector<Piece>& pieces, bool are_unbounded) {
  const char* between = "[";
  for (const Piece& piece : pieces) {
    if (is_unbounded(piece) != are_unbounded) continue;
    out << between << field_of(piece).dump();
    between = ",";
  }
  out << (*between == '[' ? "[]" : "]");
}

}  // namespace

Json skeleton_field(const StableSet<>& set) {
  Json field;
  field["segments"] = list_field(set.segments);
  field["intervals"] = list_field(set.intervals);
  field["sectors"] = list_field(set.sectors);
  return field;
}

void write_skeleton_of_infinity(std::ostream& out, const StableSet<>& set) {
  write_list(out << R"({"segments":)", set.segments, false);
  write_list(out << R"(,"intervals":)", set.intervals, false);
  write_list(out << R"(,"sectors":)", set.sectors, false);
  write_list(out << R"(,"unbounded_segments":)", set.segments, true);
  write_list(out << R"(,"unbounded_intervals":)", set.intervals, true);
  write_list(out << R"(,"unbounded_sectors":)", set.sectors, true);
  out << '}';
}

Json unstable_surface_field(const UnstableSurface<>& surface) {
  Json field;
  Json& vertices = field["vertices"] = Json::array();
  for (const RationalPoint& vertex : surface.vertices) vertices.push_back(center_field(vertex));
  field["traces"] = list_field(surface.traces);
  field["runs"] = list_field(surface.runs);
  field["sheets"] = list_field(surface.sheets);
  field["segments"] = list_field(surface.segments);
  return field;
}

// ---- Where directions lead ----

namespace {

Json contact_of_limit(const StationaryPoints& stationary, const std::optional<std::size_t>& limit) {
  return limit ? Json(stationary.contact(*limit)) : Json(nullptr);
}

// Zeros have no sign.
Json doubles_field(const Point& position) {
  return Json::array({double_field(position.x + 0.0), double_field(position.y + 0.0), double_field(position.z + 0.0)});
}

const char* exact_key(bool is_vector) { return is_vector ? "vector" : "exit"; }
const char* double_key(bool is_vector) { return is_vector ? "vector_double" : "exit_double"; }

// position_of(direction) is an object with what is said of the direction before its limit.
template <class List, class PositionOf>
Json list_field(const StationaryPoints& stationary, const List& list, const PositionOf& position_of) {
  Json field;
  Json& directions = field["directions"] = Json::array();
  for (const auto& direction : list.directions) {
    Json& element = directions.emplace_back(position_of(direction));
    element["limit"] = contact_of_limit(stationary, direction.limit);
  }
  Json& arcs = field["arcs"] = Json::array();
  for (const auto& limit : list.arcs) arcs.push_back(contact_of_limit(stationary, limit));
  return field;
}

}  // namespace

Json lambda_field(const StationaryPoints& stationary, const LambdaList& list) {
  return list_field(stationary, list, [](const LambdaList::Direction& direction) {
    Json field;
    field[exact_key(direction.is_vector)] = center_field(direction.exit);
    field[double_key(direction.is_vector)] = doubles_field(rounded_point(direction.exit));
    return field;
  });
}

Json lambda_field(const StationaryPoints& stationary, const RoundedLambdaList& list, bool has_positions) {
  return list_field(stationary, list, [has_positions](const RoundedLambdaList::Direction& direction) {
    Json field = Json::object();
    if (has_positions) field[double_key(direction.is_vector)] = doubles_field(direction.exit);
    return field;
  });
}

Json connections_field(const StationaryPoints& stationary, const std::vector<Connection>& connections) {
  Json field = Json::array();
  for (const Connection& connection : connections) {
    Json& element = field.emplace_back();
    Json& to = element["to"] = nullptr;
    if (connection.to != Connection::kInfinity) to = stationary.contact(connection.to);
    element["orbits"] = connection.orbits;
    element["families"] = connection.families;
  }
  return field;
}

}  // namespace flowcert::io
