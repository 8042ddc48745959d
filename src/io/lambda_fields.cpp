// Limits are named by their contact sets, as everywhere.
#include "io/lambda_fields.h"

#include "flowcert/sphere.h"

namespace flowcert::io {

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
