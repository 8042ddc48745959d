// See orbit_fields.h.
#include "io/orbit_fields.h"

namespace flowcert {

Json segment_field(const FlowSegment& segment) {
  return {{"type", type_text(segment.type)},
          {"driver", center_field(segment.driver)},
          {"end", segment.end ? center_field(*segment.end) : Json(nullptr)}};
}

Json segment_with_contacts_field(const FlowSegment& segment) {
  Json field = segment_field(segment);
  field["start_contact"] = segment.start_contact;
  field["crossed_contact"] = segment.crossed_contact;
  field["end_contact"] = segment.end ? Json(segment.end_contact) : Json(nullptr);
  return field;
}

Json limit_field(const PointSet& points, const std::optional<StationaryLimit>& limit) {
  if (!limit) {
    return {{"kind", "infinity"},
            {"index", nullptr},
            {"position", nullptr},
            {"contact", nullptr},
            {"squared_distance", nullptr}};
  }
  return {{"kind", limit->index.is_critical() ? "critical" : "regular"},
          {"index", index_field(limit->index)},
          {"position", center_field(limit->position)},
          {"contact", limit->contact},
          {"squared_distance", to_text(exact_sphere(points, limit->contact).squared_radius)}};
}

}  // namespace flowcert
