// A corner is a position, or an object with a vector where it is at infinity.
#include "io/unstable_surface_field.h"

#include <vector>

namespace flowcert::io {

namespace {

Json corner_field(const SurfaceCorner& corner) {
  if (!corner.at_infinity) return center_field(corner.position);
  Json field;
  field["vector"] = center_field(corner.position);
  return field;
}

Json intervals_field(const std::vector<UnstableInterval>& intervals) {
  Json field = Json::array();
  for (const UnstableInterval& interval : intervals) {
    Json& element = field.emplace_back();
    element["polygon"] = interval.polygon;
    element["from"] = corner_field(interval.from);
    element["to"] = corner_field(interval.to);
  }
  return field;
}

}  // namespace

Json unstable_surface_field(const UnstableSurface& surface) {
  Json field;
  Json& vertices = field["vertices"] = Json::array();
  for (const RationalPoint& vertex : surface.vertices) vertices.push_back(center_field(vertex));
  field["traces"] = intervals_field(surface.traces);
  field["runs"] = intervals_field(surface.runs);
  Json& sheets = field["sheets"] = Json::array();
  for (const UnstableSheet& sheet : surface.sheets) {
    Json& element = sheets.emplace_back();
    element["samples"] = sheet.samples;
    Json& corners = element["corners"] = Json::array();
    for (const SurfaceCorner& corner : sheet.corners) corners.push_back(corner_field(corner));
  }
  Json& segments = field["segments"] = Json::array();
  for (const UnstableSegment& segment : surface.segments) {
    Json& element = segments.emplace_back();
    element["samples"] = segment.samples;
    element["start"] = center_field(segment.start);
    element["end"] = corner_field(segment.end);
  }
  return field;
}

}  // namespace flowcert::io
