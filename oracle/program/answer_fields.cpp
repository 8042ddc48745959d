// A value that does not exist is null.
#include "oracle/program/answer_fields.h"

namespace oracle {

namespace {

Json index_field(const StationaryPoint& x) {
  if (x.is_critical()) return x.hull_dimension;
  Json pair;
  pair.push_back(x.face_dimension);
  pair.push_back(x.hull_dimension);
  return pair;
}

const char* kind_text(const StationaryPoint& x) { return x.is_critical() ? "critical" : "regular"; }

Json segment_field(const PointSet& set, const FlowSegment& segment) {
  Json field;
  field["type"] = segment_type(set, segment);
  field["driver"] = position_field(segment.driver);
  field["end"] = nullptr;
  field["start_contact"] = segment.start_contact;
  field["crossed_contact"] = segment.crossed_contact;
  field["end_contact"] = nullptr;
  if (segment.end) {
    field["end"] = position_field(*segment.end);
    field["end_contact"] = segment.end_contact;
  }
  return field;
}

Json limit_field(const std::optional<StationaryPoint>& limit) {
  Json field;
  field["kind"] = "infinity";
  field["index"] = nullptr;
  field["position"] = nullptr;
  field["contact"] = nullptr;
  field["squared_distance"] = nullptr;
  if (limit) {
    field["kind"] = kind_text(*limit);
    field["index"] = index_field(*limit);
    field["position"] = position_field(limit->center);
    field["contact"] = limit->contact;
    field["squared_distance"] = limit->squared_distance.str();
  }
  return field;
}

}  // namespace

Json position_field(const Point& x) {
  Json field;
  for (const Rational& coordinate : x) field.push_back(coordinate.str());
  return field;
}

Json record_field(const StationaryPoint& x) {
  Json field;
  field["index"] = index_field(x);
  field["kind"] = kind_text(x);
  field["contact"] = x.contact;
  field["center"] = position_field(x.center);
  field["squared_distance"] = x.squared_distance.str();
  return field;
}

Json orbit_field(const PointSet& set, const Point& start, const Orbit& path) {
  Json field;
  field["start"] = position_field(start);
  field["segments"] = Json::array();
  for (const FlowSegment& segment : path.segments) field["segments"].push_back(segment_field(set, segment));
  field["limit"] = limit_field(path.limit);
  return field;
}

Json counts_field(const Answer& answer) {
  const auto regular = answer.regular_counts();
  Json field;
  field["merged_duplicates"] = answer.merged_duplicates;
  field["critical"] = answer.critical_counts();
  field["regular_stationary"]["1-2"] = regular[0];
  field["regular_stationary"]["1-3"] = regular[1];
  field["regular_stationary"]["2-3"] = regular[2];
  return field;
}

}  // namespace oracle
