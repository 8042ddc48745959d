// See answer_fields.h.
#include "oracle/vectors/answer_fields.h"

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

Json counts_field(const Answer& answer) {
  const auto regular = answer.regular_counts();
  return {{"merged_duplicates", answer.merged_duplicates},
          {"critical", answer.critical_counts()},
          {"regular_stationary", {{"1-2", regular[0]}, {"2-3", regular[1]}, {"1-3", regular[2]}}}};
}

}  // namespace oracle::vectors
