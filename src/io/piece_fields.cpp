// A function for each shape, and for each piece with more keys than its shape.
#include "io/piece_fields.h"

#include <vector>

namespace flowcert::io {

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

}  // namespace flowcert::io
