// See answer_fields.h.
#include "oracle/vectors/answer_fields.h"

#include <algorithm>
#include <set>

#include "oracle/stable_pieces.h"

namespace oracle::vectors {

namespace {

Json index_field(const StationaryPoint& x) {
  if (x.face_dimension == x.hull_dimension) return x.hull_dimension;
  return Json::array({x.face_dimension, x.hull_dimension});
}

Json kind_field(const StationaryPoint& x) {
  return x.face_dimension == x.hull_dimension ? "critical" : "regular";
}

Json segment_field(const PointSet& set, const FlowSegment& segment) {
  const bool ends = segment.end.has_value();
  return {{"type", segment_type(set, segment)},
          {"driver", position_field(segment.driver)},
          {"end", ends ? position_field(*segment.end) : Json()},
          {"start_contact", segment.start_contact},
          {"crossed_contact", segment.crossed_contact},
          {"end_contact", ends ? Json(segment.end_contact) : Json()}};
}

Json limit_field(const std::optional<StationaryPoint>& limit) {
  if (!limit) {
    return {{"kind", "infinity"},
            {"index", nullptr},
            {"position", nullptr},
            {"contact", nullptr},
            {"squared_distance", nullptr}};
  }
  return {{"kind", kind_field(*limit)},
          {"index", index_field(*limit)},
          {"position", position_field(limit->center)},
          {"contact", limit->contact},
          {"squared_distance", limit->squared_distance.str()}};
}

const char* back_kind_text(BackKind kind) {
  switch (kind) {
    case BackKind::kCritical:
      return "critical";
    case BackKind::kRegular:
      return "regular";
    case BackKind::kEdge:
      return "edge";
    case BackKind::kVertex:
      break;
  }
  return "vertex";
}

// The samples of the index-1 points in which an odd number of connecting orbits end.
Json boundary_field(const StableSet& stable) {
  std::set<std::array<std::size_t, 2>> odd;
  for (const BackwardSegment& segment : stable.segments) {
    if (segment.back_kind != BackKind::kCritical) continue;
    if (!odd.insert(segment.samples).second) odd.erase(segment.samples);
  }
  return odd;
}

}  // namespace

Json position_field(const Point& x) { return Json::array({x[0].str(), x[1].str(), x[2].str()}); }

Json record_field(const StationaryPoint& x) {
  return {{"index", index_field(x)},
          {"kind", kind_field(x)},
          {"contact", x.contact},
          {"center", position_field(x.center)},
          {"squared_distance", x.squared_distance.str()}};
}

Json orbit_field(const PointSet& set, const Point& start, const Orbit& path) {
  Json segments = Json::array();
  for (const FlowSegment& segment : path.segments) segments.push_back(segment_field(set, segment));
  return {{"start", position_field(start)}, {"segments", segments}, {"limit", limit_field(path.limit)}};
}

Json stable_field(const PointSet& set, const StationaryPoint& z, const StableSet& stable) {
  Json field = {{"segments", segments_without_intervals(z, stable)},
                {"has_vertex", stable.has_vertex},
                {"has_interval", !stable.intervals.empty()}};
  if (z.face_dimension == z.hull_dimension) {
    field["boundary"] = has_tie(stable) ? Json() : boundary_field(stable);
  }
  field["walk"] = stable.has_vertex ? Json() : Json(boundary_walk(set, z, stable));
  return field;
}

// The intervals that sectors come through are not listed: the sectors' corners tell them.
Json skeleton_field(const PointSet& set, const StableSet& stable) {
  Json field = {{"segments", Json::array()}, {"intervals", Json::array()}, {"sectors", Json::array()}};
  for (const BackwardSegment& segment : stable.segments) {
    field["segments"].push_back({{"samples", segment.samples},
                                 {"front", position_field(segment.front)},
                                 {"back", position_field(segment.back)},
                                 {"front_contact", segment.front_contact},
                                 {"back_contact", segment.back_contact},
                                 {"back_kind", back_kind_text(segment.back_kind)}});
  }
  for (const BackwardInterval& interval : stable.intervals) {
    if (interval.kind == IntervalKind::kCrossed) continue;
    field["intervals"].push_back({{"polygon", interval.polygon},
                                  {"front", position_field(interval.front)},
                                  {"back", position_field(interval.back)},
                                  {"back_is_stationary", !flow_segment(set, interval.back)}});
  }
  for (const Sector& sector : stable.sectors) {
    Json corners = Json::array();
    for (const Point& corner : sector.polygon) corners.push_back(position_field(corner));
    field["sectors"].push_back({{"samples", sector.samples}, {"corners", corners}});
  }
  return field;
}

Json persistence_field(const std::vector<PersistencePair>& pairs) {
  Json field = Json::array();
  for (const PersistencePair& pair : pairs) {
    field.push_back({{"dimension", pair.dimension},
                     {"birth", pair.birth.str()},
                     {"death", pair.death ? Json(pair.death->str()) : Json()}});
  }
  return field;
}

Json counts_field(const Answer& answer) {
  const auto regular = answer.regular_counts();
  return {{"merged_duplicates", answer.merged_duplicates},
          {"critical", answer.critical_counts()},
          {"regular_stationary", {{"1-2", regular[0]}, {"2-3", regular[1]}, {"1-3", regular[2]}}}};
}

}  // namespace oracle::vectors
