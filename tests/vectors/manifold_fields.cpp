// A value that does not exist is null.
#include "tests/vectors/manifold_fields.h"

#include <algorithm>
#include <set>

#include "oracle/stable_pieces.h"

namespace oracle::vectors {

namespace {

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

// A position, or an object with a vector where it is at infinity.
Json corner_field(const Corner& corner) {
  if (!corner.at_infinity) return position_field(corner.position);
  Json field;
  field["vector"] = position_field(corner.position);
  return field;
}

Json backward_segment_field(const BackwardSegment& segment) {
  Json field;
  field["samples"] = segment.samples;
  field["front"] = corner_field(segment.front);
  field["back"] = corner_field(segment.back);
  field["front_contact"] = segment.front_contact;
  field["back_contact"] = segment.back_contact;
  field["back_kind"] = back_kind_text(segment.back_kind);
  return field;
}

Json interval_field(const PointSet& set, const EdgePart& interval) {
  Json field;
  field["polygon"] = interval.polygon;
  field["front"] = corner_field(interval.front);
  field["back"] = corner_field(interval.back);
  field["back_is_stationary"] = !flow_segment(set, interval.back.position);
  return field;
}

Json region_field(const Region& region) {
  Json field;
  field["samples"] = region.samples;
  field["corners"] = Json::array();
  for (const Corner& corner : region.corners) field["corners"].push_back(corner_field(corner));
  return field;
}

// Null for infinity.
Json contact_field(const std::optional<StationaryPoint>& limit) {
  if (!limit) return nullptr;
  return limit->contact;
}

// Where the ray of a direction u of y leaves the closed Voronoi face of y's directions. Nothing iff it never does.
std::optional<Point> exit_along(const PointSet& set, const StationaryPoint& y, const Direction& u) {
  const Places contact = places_of(set, y.contact);
  const std::size_t p = *std::max_element(contact.begin(), contact.end(), [&](std::size_t a, std::size_t b) {
    return dot(set.points[a], u) < dot(set.points[b], u);
  });
  const std::optional<Rational> time = set.first_meeting(p, y.center, u);
  if (!time) return std::nullopt;
  return moved(y.center, *time, u);
}

Json edge_part_field(const EdgePart& part) {
  Json field;
  field["polygon"] = part.polygon;
  field["from"] = corner_field(part.front);
  field["to"] = corner_field(part.back);
  return field;
}

Json ray_field(const Crossing& segment) {
  Json field;
  field["samples"] = segment.samples;
  field["start"] = corner_field(segment.back);
  field["end"] = corner_field(segment.front);
  return field;
}

}  // namespace

Json stable_field(const PointSet& set, const StationaryPoint& z, const StableSet& stable) {
  Json field;
  field["segments"] = segments_without_intervals(z, stable);
  field["has_vertex"] = stable.has_vertex;
  field["has_interval"] = !stable.intervals.empty();
  if (z.is_critical()) {
    field["boundary"] = nullptr;
    if (!has_tie(stable)) field["boundary"] = boundary_field(stable);
  }
  field["walk"] = nullptr;
  if (!stable.has_vertex) field["walk"] = boundary_walk(set, z, stable);
  return field;
}

// Intervals that the rays of sectors cross are not listed, because the sectors' corners give them.
Json skeleton_field(const PointSet& set, const StableSet& stable) {
  Json field;
  field["segments"] = Json::array();
  field["intervals"] = Json::array();
  field["sectors"] = Json::array();
  for (const BackwardSegment& segment : stable.segments) {
    field["segments"].push_back(backward_segment_field(segment));
  }
  for (const EdgePart& interval : stable.intervals) field["intervals"].push_back(interval_field(set, interval));
  for (const Region& sector : stable.sectors) field["sectors"].push_back(region_field(sector));
  return field;
}

// A cyclic list begins with the least exit in lexicographic order. The oracle's begins with the least direction.
Json lambda_field(const PointSet& set, const StationaryPoint& y, const std::vector<UnstableEntry>& list) {
  std::vector<Json> directions, arcs;
  std::vector<Point> ends;  // of the directions
  for (const UnstableEntry& entry : list) {
    if (entry.is_arc) {
      arcs.push_back(contact_field(entry.limit));
      continue;
    }
    const std::optional<Point> exit = exit_along(set, y, *entry.from);
    ends.push_back(exit.value_or(*entry.from));
    Json& direction = directions.emplace_back();
    direction[exit ? "exit" : "vector"] = position_field(ends.back());
    direction["limit"] = contact_field(entry.limit);
  }
  if (y.hull_dimension == 1 && !ends.empty()) {
    const auto first = std::min_element(ends.begin(), ends.end()) - ends.begin();
    std::rotate(directions.begin(), directions.begin() + first, directions.end());
    std::rotate(arcs.begin(), arcs.begin() + first, arcs.end());
  }
  Json field;
  field["directions"] = directions;
  field["arcs"] = arcs;
  return field;
}

Json unstable_surface_field(const UnstableSurface& surface) {
  Json field;
  for (const char* key : {"vertices", "traces", "runs", "sheets", "segments"}) field[key] = Json::array();
  for (const Point& vertex : surface.vertices) field["vertices"].push_back(position_field(vertex));
  for (const EdgePart& trace : surface.traces) field["traces"].push_back(edge_part_field(trace));
  for (const EdgePart& run : surface.runs) field["runs"].push_back(edge_part_field(run));
  for (const Region& sheet : surface.sheets) field["sheets"].push_back(region_field(sheet));
  for (const Crossing& segment : surface.segments) field["segments"].push_back(ray_field(segment));
  return field;
}

Json connections_field(const StationaryPoint& y, const std::vector<Connection>& all) {
  Json field = Json::array();
  for (const Connection& connection : all) {
    if (connection.from != y) continue;
    Json& one = field.emplace_back();
    one["to"] = contact_field(connection.to);
    one["orbits"] = connection.directions;
    one["families"] = connection.arcs;
  }
  return field;
}

Json shares_field(const PointSet& set, const std::vector<Rational>& shares) {
  Json field = Json::array();
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] != 0) field.push_back(Json::array({set.names[k], shares[k].str()}));
  }
  return field;
}

Json persistence_field(const std::vector<PersistencePair>& pairs) {
  Json field = Json::array();
  for (const PersistencePair& pair : pairs) {
    Json one;
    one["dimension"] = pair.dimension;
    one["birth"] = pair.birth.str();
    one["death"] = nullptr;
    if (pair.death) one["death"] = pair.death->str();
    field.push_back(one);
  }
  return field;
}

}  // namespace oracle::vectors
