// See skeleton_fields.h.
#include "io/skeleton_fields.h"

namespace flowcert {

Json stable_field(const StationaryPoints& stationary, const StableManifolds& s2, std::size_t i) {
  Json field = {{"segments", s2.segment_count(i)},
                {"has_vertex", s2.has_vertex(i)},
                {"has_interval", s2.has_interval(i)}};
  if (!stationary.index(s2.record(i)).is_critical()) return field;
  Json& boundary = field["boundary"] = Json::array();
  for (const std::uint32_t record : s2.boundary(i)) boundary.push_back(stationary.contact(record));
  return field;
}

Json skeleton_field(const StableSet& set) {
  Json field = {{"segments", Json::array()}, {"intervals", Json::array()}, {"sectors", Json::array()}};
  for (const BackwardSegment& segment : set.segments) {
    field["segments"].push_back({{"samples", segment.samples},
                                 {"front", center_field(segment.front)},
                                 {"back", center_field(segment.back)},
                                 {"front_contact", segment.front_contact},
                                 {"back_contact", segment.back_contact},
                                 {"back_kind", back_kind_text(segment.back_kind)}});
  }
  for (const BackwardInterval& interval : set.intervals) {
    field["intervals"].push_back({{"polygon", interval.polygon},
                                  {"front", center_field(interval.front)},
                                  {"back", center_field(interval.back)},
                                  {"back_is_stationary", interval.back_is_stationary}});
  }
  for (const BackwardSector& sector : set.sectors) {
    Json corners = Json::array();
    for (const RationalPoint& corner : sector.corners) corners.push_back(center_field(corner));
    field["sectors"].push_back({{"samples", sector.samples}, {"corners", corners}});
  }
  return field;
}

}  // namespace flowcert
