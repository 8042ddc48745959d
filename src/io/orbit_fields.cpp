// See orbit_fields.h.
#include "io/orbit_fields.h"

namespace flowcert::io {

Json segment_field(const FlowSegment& segment) {
  Json field;
  field["type"] = type_text(segment.type);
  field["driver"] = center_field(segment.driver);
  field["end"] = segment.end ? center_field(*segment.end) : Json(nullptr);
  return field;
}

Json segment_with_contacts_field(const FlowSegment& segment) {
  Json field = segment_field(segment);
  field["start_contact"] = segment.start_contact;
  field["crossed_contact"] = segment.crossed_contact;
  field["end_contact"] = segment.end ? Json(segment.end_contact) : Json(nullptr);
  return field;
}

Json limit_field(const PointSet& points, const std::optional<StationaryLimit>& limit) {
  Json field;
  if (!limit) {
    field["kind"] = "infinity";
    for (const char* key : {"index", "position", "contact", "squared_distance"}) field[key] = nullptr;
    return field;
  }
  field["kind"] = limit->index.is_critical() ? "critical" : "regular";
  field["index"] = index_field(limit->index);
  field["position"] = center_field(limit->position);
  field["contact"] = limit->contact;
  field["squared_distance"] = to_text(exact_sphere(points, limit->contact).squared_radius);
  return field;
}

}  // namespace flowcert::io
