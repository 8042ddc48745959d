// The exchange format: the JSON Lines that `flowcert compute -o` writes, a header and one record for each point
// (spec/formats/stationary_points.md; spec/schemas/exchange.schema.json).
//
// Guarantees: a known key has a right value, or the file is refused. InvalidInput names the place.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "certify/claims/claim_formats.h"
#include "certify/claims/exchange_value.h"
#include "flowcert/claim.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::certify {

namespace {

// ---- Stable sets ----
// The keys of a record that describe its stable set (spec/formats/stationary_points.md). A value that is not as the
// format says throws InvalidInput with the place.

std::array<PointId, 2> pair_of_ids(const ExchangeValue& value) {
  value.expect_size(2);
  const std::vector<PointId> ids = ids_of(value);
  return {ids[0], ids[1]};
}

bool is_zero_vector(const ClaimedPosition& vector) {
  return std::ranges::all_of(vector, [](const ClaimedNumber& coordinate) { return coordinate.value == 0; });
}

Corner<ClaimedPosition> finite_corner_of(const ExchangeValue& value) { return {position_of(value)}; }

Corner<ClaimedPosition> corner_at_infinity_of(const ExchangeValue& vector) {
  Corner<ClaimedPosition> corner{position_of(vector), true};
  if (is_zero_vector(corner.position)) vector.reject("a direction: the vector is zero");
  return corner;
}

// A position, or an object with a vector where it is at infinity.
Corner<ClaimedPosition> corner_of(const ExchangeValue& value) {
  return value.is(JsonKind::kObject) ? corner_at_infinity_of(value.get("vector")) : finite_corner_of(value);
}

// The front of a segment or an interval.
Corner<ClaimedPosition> front_of(const ExchangeValue& value, bool is_unbounded) {
  return is_unbounded ? corner_at_infinity_of(value.get("vector")) : finite_corner_of(value.get("front"));
}

BackKind back_kind_of(const ExchangeValue& value) {
  for (const BackKind kind : {BackKind::kCritical, BackKind::kRegular, BackKind::kEdge, BackKind::kVertex}) {
    if (value.text() == back_kind_text(kind)) return kind;
  }
  value.reject("a kind of back");
}

BackwardSegment<ClaimedPosition> segment_of(const ExchangeValue& value, bool is_unbounded) {
  BackwardSegment<ClaimedPosition> segment;
  segment.samples = pair_of_ids(value.get("samples"));
  segment.front = front_of(value, is_unbounded);
  segment.back = finite_corner_of(value.get("back"));
  if (!is_unbounded) {
    if (const auto contact = value.find("front_contact")) segment.front_contact = ids_of(*contact);
  }
  if (const auto contact = value.find("back_contact")) segment.back_contact = ids_of(*contact);
  if (const auto kind = value.find("back_kind")) segment.back_kind = back_kind_of(*kind);
  return segment;
}

BackwardInterval<ClaimedPosition> interval_of(const ExchangeValue& value, bool is_unbounded) {
  BackwardInterval<ClaimedPosition> interval;
  interval.polygon = ids_of(value.get("polygon"));
  interval.front = front_of(value, is_unbounded);
  interval.back = finite_corner_of(value.get("back"));
  if (const auto stationary = value.find("back_is_stationary")) interval.back_is_stationary = bool_of(*stationary);
  return interval;
}

Region<ClaimedPosition> sector_of(const ExchangeValue& value, bool is_unbounded) {
  Region<ClaimedPosition> sector{pair_of_ids(value.get("samples")),
                                 list_of(value.get("corners"), is_unbounded ? corner_of : finite_corner_of)};
  if (sector.corners.size() < 3) value.get("corners").reject("three or more corners");
  return sector;
}

std::array<std::size_t, 3> triangle_of(const ExchangeValue& value) {
  value.expect_size(3);
  return {count_of(value[0]), count_of(value[1]), count_of(value[2])};
}

ClaimedStable stable_of(const ExchangeValue& value) {
  ClaimedStable stable;
  if (const auto count = value.find("segments")) stable.segments = count_of(*count);
  if (const auto flag = value.find("has_vertex")) stable.has_vertex = bool_of(*flag);
  if (const auto flag = value.find("has_interval")) stable.has_interval = bool_of(*flag);
  if (const auto boundary = value.find("boundary")) stable.boundary = list_of(*boundary, ids_of);
  if (const auto walk = value.find("walk"); walk && !walk->is_null()) stable.walk = ids_of(*walk);
  return stable;
}

// The pieces without ends at infinity, or those with such ends, which have keys of their own.
StableSet<ClaimedPosition> pieces_of(const ExchangeValue& value, bool are_unbounded) {
  const std::string prefix = are_unbounded ? "unbounded_" : "";
  StableSet<ClaimedPosition> pieces;
  const auto read = [&](const char* key, auto& list, const auto& piece_of) {
    if (const auto all = value.find(prefix + key)) {
      list = list_of(*all, [&](const ExchangeValue& piece) { return piece_of(piece, are_unbounded); });
    }
  };
  if (!are_unbounded) (void)value.get("segments");
  read("segments", pieces.segments, segment_of);
  read("intervals", pieces.intervals, interval_of);
  read("sectors", pieces.sectors, sector_of);
  return pieces;
}

std::optional<std::vector<std::vector<std::size_t>>> orbits_of(const ExchangeValue& skeleton, std::size_t segments) {
  const auto value = skeleton.find("orbits");
  if (!value) return std::nullopt;
  auto orbits = list_of(*value, [](const ExchangeValue& chain) { return list_of(chain, count_of); });
  for (const auto& chain : orbits) {
    for (const std::size_t place : chain) {
      if (place >= segments) value->reject("chains of the segments: there are not so many");
    }
  }
  return orbits;
}

ClaimedSurface surface_of(const ExchangeValue& value) {
  ClaimedSurface surface;
  surface.vertices = list_of(value.get("vertices"), position_of);
  const ExchangeValue triangles = value.get("triangles");
  surface.triangles = list_of(triangles, triangle_of);
  for (const auto& triangle : surface.triangles) {
    for (const std::size_t vertex : triangle) {
      if (vertex >= surface.vertices.size()) triangles.reject("triangles of the vertices: there are not so many");
    }
  }
  return surface;
}

// ---- A file ----
// Rationals in strings are exact; numbers of JSON are decimals. Unknown keys are listed. A known key with a wrong value
// is an error. So is a known key that does not belong to points of this index.

constexpr std::string_view kFormatName = "flowcert-stationary-points";

// The header.

ClaimedIndices indices_of(const ExchangeValue& value) {
  ClaimedIndices indices{};
  for (const int index : list_of(value, index_of)) {
    bool& is_claimed = indices.at(static_cast<std::size_t>(index));
    if (is_claimed) value.reject(fmt::format("indices: {} is there twice", index));
    is_claimed = true;
  }
  return indices;
}

Claim claim_of_header(const ExchangeValue& header) {
  const ExchangeValue format = header.get("format");
  if (format.text() != kFormatName) format.reject(in_quotes(kFormatName));
  const ExchangeValue version = header.get("format_version");
  if (version.number_text() != "1") version.reject("1, the only version that is known");
  Claim claim;
  read_input_fields(header, claim);
  if (const auto value = header.find("classes")) claim.classes = list_of(*value, ids_of);
  if (const auto value = header.find("indices")) claim.indices = indices_of(*value);
  if (const auto value = header.find("critical")) claim.critical_counts = critical_counts_of(*value);
  if (const auto value = header.find("regular_stationary")) claim.regular_counts = regular_counts_of(*value);
  if (const auto value = header.find("centers")) {
    value->expect_one_of({"exact", "double", "none"}, "'exact', 'double' or 'none'");
  }
  if (const auto value = header.find("volumes")) {
    value->expect_one_of({"exact", "shares", "double"}, "'exact', 'shares' or 'double'");
  }
  if (const auto value = header.find("morse_smale")) claim.morse_smale = bool_of(*value);
  if (const auto value = header.find("hull_volume")) claim.hull_volume = distance_of(*value);
  return claim;
}

// Records.

void read_index_and_kind(const ExchangeValue& record, ClaimedPoint& point) {
  read_index(record.get("index"), point);
  const auto kind = record.find("kind");
  const char* const expected = point.hull_dimension ? "regular" : "critical";
  if (kind && kind->text() != expected) kind->reject(in_quotes(expected) + ", which the index says");
}

std::optional<ClaimedNumber> number_or_null(const ExchangeValue& value) {
  return value.is_null() ? std::nullopt : std::optional(number_of(value));
}

std::array<std::optional<ClaimedNumber>, 3> doubles_of(const ExchangeValue& value) {
  value.expect_size(3);
  return {number_or_null(value[0]), number_or_null(value[1]), number_or_null(value[2])};
}

// A position, or else the three doubles of another key, which may be null.
std::optional<ClaimedPosition> position_or_doubles(const std::optional<ExchangeValue>& exact,
                                                   const std::optional<ExchangeValue>& near) {
  if (exact) return position_of(*exact);
  if (!near || near->is_null()) return std::nullopt;
  near->expect_size(3);
  const bool has_null = (*near)[0].is_null() || (*near)[1].is_null() || (*near)[2].is_null();
  return has_null ? std::nullopt : std::optional(position_of(*near));
}

// Takes center, or else center_double, and squared_distance in the same way. A double is null if none is near. Beside
// the exact value it is kept apart.
void read_sphere(const ExchangeValue& record, ClaimedPoint& point) {
  const auto center = record.find("center"), near_center = record.find("center_double");
  point.center = position_or_doubles(center, near_center);
  if (center && near_center && !near_center->is_null()) point.rounded_center = doubles_of(*near_center);
  if (const auto distance = record.find("squared_distance")) {
    point.squared_distance = distance_of(*distance);
    if (const auto near = record.find("squared_distance_double")) {
      point.rounded_squared_distance = near->is_null() ? std::nullopt : std::optional(distance_of(*near));
      point.has_rounded_squared_distance = true;
    }
  } else if (const auto near = record.find("squared_distance_double"); near && !near->is_null()) {
    point.squared_distance = distance_of(*near);
  }
}

ClaimedTarget limit_of(const ExchangeValue& value) {
  if (value.is_null()) return {.is_infinity = true, .contact = {}};
  return {.is_infinity = false, .contact = ids_of(value)};
}

ClaimedSegment flow_segment_of(const ExchangeValue& value) {
  ClaimedSegment segment;
  if (const auto type = value.find("type")) segment.type = type->text();
  if (const auto driver = value.find("driver")) segment.driver = position_of(*driver);
  const ExchangeValue end = value.get("end");
  if (!end.is_null()) segment.end = position_of(end);
  return segment;
}

ClaimedPolyline polyline_of(const ExchangeValue& value) { return list_of(value, flow_segment_of); }

// Finds a key that only some points may have. points: these, in words.
std::optional<ExchangeValue> find_if(const ExchangeValue& record, const char* key, bool may_have,
                                     const std::string& points) {
  const auto value = record.find(key);
  if (value && !may_have) record.place().reject("a key of " + points + " only: " + in_quotes(key));
  return value;
}

std::optional<ExchangeValue> find_of_index(const ExchangeValue& record, const ClaimedPoint& point, const char* key,
                                           int index) {
  const bool is_other = point.hull_dimension || point.index != index;
  return find_if(record, key, !is_other, fmt::format("critical points of index {}", index));
}

void read_flow(const ExchangeValue& record, ClaimedPoint& point) {
  if (const auto samples = find_of_index(record, point, "samples", 1)) point.samples = ids_of(*samples);
  if (const auto limits = find_of_index(record, point, "limits", 2)) {
    limits->expect_size(2);
    point.successors = list_of(*limits, limit_of);
    point.successors_by_side = true;
  }
  if (const auto u2 = find_of_index(record, point, "u2", 2)) {
    u2->expect_size(2);
    point.u2 = list_of(*u2, polyline_of);
  }
}

ClaimedDirection direction_of(const ExchangeValue& value) {
  ClaimedDirection direction;
  direction.limit = limit_of(value.get("limit"));
  const auto exit = value.find("exit"), near_exit = value.find("exit_double");
  const auto vector = value.find("vector"), near_vector = value.find("vector_double");
  direction.is_vector = vector || near_vector;
  if (direction.is_vector && (exit || near_exit)) value.reject("a direction: it has an exit and a vector");
  const auto& exact = direction.is_vector ? vector : exit;
  const auto& near = direction.is_vector ? near_vector : near_exit;
  direction.exit = position_or_doubles(exact, near);
  if (exact && near && !near->is_null()) direction.rounded_exit = doubles_of(*near);
  if (direction.is_vector && direction.exit && is_zero_vector(*direction.exit)) {
    value.reject("a direction: the vector is zero");
  }
  return direction;
}

ClaimedLambdaList lambda_of(const ExchangeValue& value) {
  return {list_of(value.get("directions"), direction_of), list_of(value.get("arcs"), limit_of)};
}

ClaimedConnection connection_of(const ExchangeValue& value) {
  return {limit_of(value.get("to")), count_of(value.get("orbits")), count_of(value.get("families"))};
}

void read_directions(const ExchangeValue& record, ClaimedPoint& point) {
  const bool may_have = point.hull_dimension || point.index == 1 || point.index == 2;
  const char* const points = "critical points of index 1 and 2 and of regular stationary points";
  if (const auto value = find_if(record, "lambda", may_have, points)) point.lambda = lambda_of(*value);
  if (const auto value = find_if(record, "connections", may_have, points)) {
    point.connections = list_of(*value, connection_of);
  }
}

ClaimedShare share_of(const ExchangeValue& value) {
  value.expect_size(2);
  return {claimed_id(value[0].number_text(), value.place()), distance_of(value[1])};
}
ClaimedShare rounded_share_of(const ExchangeValue& value) {
  value.expect_size(2);
  if (!value[1].is_null()) return share_of(value);
  return {claimed_id(value[0].number_text(), value.place()), std::nullopt};
}

// In the same way as squared_distance.
void read_volume(const ExchangeValue& record, ClaimedPoint& point) {
  const auto exact = record.find("volume"), near = record.find("volume_double");
  if (exact) point.volume = distance_of(*exact);
  if (near && !near->is_null()) (exact ? point.rounded_volume : point.volume) = distance_of(*near);
  point.has_rounded_volume = exact && near;
  const bool may_have = point.hull_dimension || point.index >= 2;
  const char* const points = "critical points of index 2 and 3 and of regular stationary points";
  const auto shares = find_if(record, "shares", may_have, points),
             near_shares = find_if(record, "shares_double", may_have, points);
  if (shares && near_shares) record.place().reject("both 'shares' and 'shares_double'");
  if (shares) point.shares = list_of(*shares, share_of);
  if (near_shares) point.shares = list_of(*near_shares, rounded_share_of);
}

// Pieces are filled one part after the other: GCC 12 destroys corners twice where a later part of a braced list throws.
EdgePart<ClaimedPosition> edge_part_of(const ExchangeValue& value) {
  EdgePart<ClaimedPosition> part;
  part.polygon = ids_of(value.get("polygon"));
  part.front = corner_of(value.get("from"));
  part.back = corner_of(value.get("to"));
  return part;
}

Region<ClaimedPosition> sheet_of(const ExchangeValue& value) {
  Region<ClaimedPosition> sheet{pair_of_ids(value.get("samples")), list_of(value.get("corners"), corner_of)};
  if (!sheet.corners.empty() && sheet.corners.size() < 3) value.get("corners").reject("no corner, or three or more");
  return sheet;
}

Crossing<ClaimedPosition> ray_of(const ExchangeValue& value) {
  Crossing<ClaimedPosition> ray;
  ray.samples = pair_of_ids(value.get("samples"));
  ray.back = finite_corner_of(value.get("start"));
  ray.front = corner_of(value.get("end"));
  return ray;
}

void read_unstable(const ExchangeValue& record, ClaimedPoint& point) {
  const auto u1 = find_if(record, "u1", point.index == 1, "points of the index or kind 1, 1-2 and 1-3");
  if (!u1) return;
  point.u1 = {.vertices = list_of(u1->get("vertices"), position_of),
              .traces = list_of(u1->get("traces"), edge_part_of),
              .runs = list_of(u1->get("runs"), edge_part_of),
              .sheets = list_of(u1->get("sheets"), sheet_of),
              .segments = list_of(u1->get("segments"), ray_of)};
}

// Maxima may have a skeleton, too.
void read_stable(const ExchangeValue& record, ClaimedPoint& point) {
  const bool may_have = point.hull_dimension || point.index == 2;
  const char* const points = "critical points of index 2 and of regular stationary points";
  if (const auto value = find_if(record, "stable", may_have, points)) point.stable = stable_of(*value);
  if (const auto value = find_if(record, "skeleton", may_have || point.index == 3,
                                 "critical points of index 2 and 3 and of regular stationary points")) {
    point.skeleton = pieces_of(*value, false);
    point.orbits = orbits_of(*value, point.skeleton->segments.size());
  }
  if (const auto value = find_if(record, "surface", may_have, points)) point.surface = surface_of(*value);
  if (point.hull_dimension && point.stable && point.stable->boundary) {
    record.place().reject("a boundary, which only critical points have");
  }
}

ClaimedPoint point_of(const ExchangeValue& record) {
  ClaimedPoint point;
  point.line = record.place().line;
  read_index_and_kind(record, point);
  if (const auto contact = record.find("contact")) point.contact = contact_of(*contact);
  read_sphere(record, point);
  if (point.contact.empty() && !point.center) record.place().reject("neither 'contact' nor 'center'");
  read_flow(record, point);
  read_stable(record, point);
  read_directions(record, point);
  read_volume(record, point);
  read_unstable(record, point);
  return point;
}

bool is_of_infinity(const ExchangeValue& record) {
  const auto kind = record.find("kind");
  return kind && kind->is(JsonKind::kString) && kind->text() == "infinity";
}

ClaimedInfinity infinity_of(const ExchangeValue& record) {
  ClaimedInfinity infinity;
  infinity.line = record.place().line;
  const ExchangeValue skeleton = record.get("skeleton");
  infinity.bounded = pieces_of(skeleton, false);
  if (orbits_of(skeleton, infinity.bounded.segments.size())) {
    skeleton.reject("that of infinity, which has no orbits");
  }
  infinity.unbounded = pieces_of(skeleton, true);
  return infinity;
}

bool recognises_exchange(std::string_view bytes) { return trimmed(bytes).starts_with('{'); }

Claim read_exchange(std::string_view text, std::string_view file, bool /*is_unlimited*/) {
  LineReader lines(text, file);
  std::string_view line;
  lines.next_filled(line);
  const JsonDocument header = parse_json(line, lines.place());
  Claim claim = claim_of_header({header, "header", lines.place()});
  UnknownKeys unknown;
  header.add_unknown_keys(unknown);
  while (lines.next_filled(line)) {
    const JsonDocument record = parse_json(line, lines.place());
    const ExchangeValue value(record, "record", lines.place());
    if (is_of_infinity(value)) {
      if (claim.infinity) lines.place().reject("a second line of infinity");
      claim.infinity = infinity_of(value);
    } else {
      claim.points.push_back(point_of(value));
    }
    record.add_unknown_keys(unknown);
  }
  unknown.tell(claim);
  return claim;
}

}  // namespace

const ClaimFormat kExchangeClaims = {.name = "exchange", .recognises = recognises_exchange, .read = read_exchange};

}  // namespace flowcert::certify
