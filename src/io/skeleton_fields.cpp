// See skeleton_fields.h.
#include "io/skeleton_fields.h"

namespace flowcert::io {

namespace {

Json segment_field(const BackwardSegment& segment) {
  Json field;
  field["samples"] = segment.samples;
  field["front"] = center_field(segment.front);
  field["back"] = center_field(segment.back);
  field["front_contact"] = segment.front_contact;
  field["back_contact"] = segment.back_contact;
  field["back_kind"] = back_kind_text(segment.back_kind);
  return field;
}

Json interval_field(const BackwardInterval& interval) {
  Json field;
  field["polygon"] = interval.polygon;
  field["front"] = center_field(interval.front);
  field["back"] = center_field(interval.back);
  field["back_is_stationary"] = interval.back_is_stationary;
  return field;
}

Json sector_field(const BackwardSector& sector) {
  Json field;
  field["samples"] = sector.samples;
  Json& corners = field["corners"] = Json::array();
  for (const RationalPoint& corner : sector.corners) corners.push_back(center_field(corner));
  return field;
}

}  // namespace

Json stable_field(const StationaryPoints& stationary, const StableManifolds& s2, std::size_t i) {
  Json field;
  field["segments"] = s2.segment_count(i);
  field["has_vertex"] = s2.has_vertex(i);
  field["has_interval"] = s2.has_interval(i);
  if (!stationary.index(s2.record(i)).is_critical()) return field;
  Json& boundary = field["boundary"] = Json::array();
  for (const std::uint32_t record : s2.boundary(i)) boundary.push_back(stationary.contact(record));
  return field;
}

Json skeleton_field(const StableSet& set) {
  Json field;
  for (const char* key : {"segments", "intervals", "sectors"}) field[key] = Json::array();
  for (const BackwardSegment& segment : set.segments) field["segments"].push_back(segment_field(segment));
  for (const BackwardInterval& one : set.intervals) field["intervals"].push_back(interval_field(one));
  for (const BackwardSector& sector : set.sectors) field["sectors"].push_back(sector_field(sector));
  return field;
}

}  // namespace flowcert::io
