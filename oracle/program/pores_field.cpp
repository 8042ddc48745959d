// Numbers of points and rooms are places in the lists beside them.
#include "oracle/program/pores_field.h"

#include "oracle/ball_linings.h"

namespace oracle {

namespace {

Json list_field(const Places& numbers) {
  Json field = Json::array();
  for (const std::size_t number : numbers) field.push_back(number);
  return field;
}

// The number that stands for the outside gets its name.
Json named_field(std::size_t number, std::size_t outside) {
  if (number == outside) return "outside";
  return number;
}

Json ends_field(const std::array<Ends, 2>& ends, std::size_t outside) {
  Json field = Json::array();
  for (const Ends& side : ends) {
    Json list = Json::array();
    for (const std::size_t end : side) list.push_back(named_field(end, outside));
    field.push_back(list);
  }
  return field;
}

Json point_field(const Pores& pores, std::size_t place) {
  const BallPoint& point = pores.points[place];
  Json field;
  field["index"] = point.index;
  field["contacts"] = list_field(point.contacts);
  field["value"] = number_field(point.value);
  field["position"] = Json::array();
  for (const Quadratic& coordinate : point.position) field["position"].push_back(number_field(coordinate));
  if (point.index == 2) field["ends"] = ends_field(pores.ends[place], pores.points.size());
  return field;
}

Json chamber_field(const Chamber& chamber) {
  Json field;
  field["peaks"] = list_field(chamber.peaks);
  field["gates"] = list_field(chamber.gates);
  field["exit"] = chamber.exit ? number_field(*chamber.exit) : Json(nullptr);
  field["windows"] = list_field(chamber.windows);
  field["handles"] = list_field(chamber.handles);
  return field;
}

}  // namespace

Json number_field(const Quadratic& x) {
  const PrimitivePolynomial name = primitive_polynomial(x);
  Json field;
  field["polynomial"] = Json::array();
  for (const Integer& coefficient : name.coefficients) field["polynomial"].push_back(coefficient.str());
  field["root"] = name.root;
  field["double"] = nearest_difference(x, Quadratic());
  return field;
}

Json pores_field(const Pores& pores) {
  Json field;
  for (const char* list : {"points", "chambers", "vestibules", "windows"}) field[list] = Json::array();
  for (std::size_t k = 0; k < pores.points.size(); ++k) field["points"].push_back(point_field(pores, k));
  for (const Chamber& chamber : pores.chambers) field["chambers"].push_back(chamber_field(chamber));
  for (const Vestibule& vestibule : pores.vestibules) field["vestibules"].push_back(list_field(vestibule.peaks));
  for (const Window& window : pores.windows) {
    Json shown;
    shown["point"] = window.point;
    shown["rooms"] = Json::array();
    for (const std::size_t room : window.rooms) shown["rooms"].push_back(named_field(room, outside_room(pores)));
    field["windows"].push_back(shown);
  }
  field["cavities"] = cavities_field(pores.cavities);
  return field;
}

Json cavities_field(const std::vector<Cavity>& cavities) {
  Json field = Json::array();
  for (const Cavity& cavity : cavities) {
    Json shown;
    shown["gate"] = cavity.gate ? number_field(*cavity.gate) : Json(nullptr);
    shown["peak"] = number_field(cavity.peak);
    field.push_back(shown);
  }
  return field;
}

Json pores_answer(const PoresQuestion& asked) {
  const Pores found = pores(asked.balls, asked.depth);
  Json object;
  object["format"] = "oracle-pores";
  object["format_version"] = 1;
  object["balls"] = asked.balls.size();
  object["depth"] = asked.depth.str();
  object.update(pores_field(found));
  object["nerve"] = cavities_field(cavities_by_homology(asked.balls));
  if (!asked.probe) return object;
  object["probe"] = asked.probe->str();
  object["cavities_at_probe"] = Json::array();
  for (const Places& lining : cavity_linings(asked.balls, found, *asked.probe)) {
    object["cavities_at_probe"].push_back(list_field(lining));
  }
  return object;
}

}  // namespace oracle
