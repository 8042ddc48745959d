// The exchange format: the JSON Lines that `flowcert compute -o` writes, a header and one record a point
// (spec/formats.md, section 2; spec/schemas/exchange.schema.json).
//
// Rationals in strings are exact; numbers of JSON are decimals. Unknown keys are ignored. A key that is known
// and is not what it should be is an error, and so is one that does not belong to a point of its index.
#include <algorithm>
#include <string>

#include "io/claims/claim_formats.h"
#include "io/claims/exchange_value.h"
#include "io/claims/stable_claim_fields.h"

namespace flowcert::io {
namespace {

constexpr std::string_view kFormatName = "flowcert-stationary-points";

int index_of(const ExchangeValue& value) { return claimed_index(value.number_text(), value.place()); }

// ---- The header ----

std::array<std::size_t, 3> regular_counts_of(const ExchangeValue& value) {
  return {count_of(value.get("1-2")), count_of(value.get("2-3")), count_of(value.get("1-3"))};
}

std::string sha256_of(const ExchangeValue& value) {
  const std::string& text = value.text();
  const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (text.size() != 64 || !std::all_of(text.begin(), text.end(), is_hex))
    value.reject("64 lower case hexadecimal digits");
  return text;
}

Claim claim_of_header(const ExchangeValue& header) {
  const ExchangeValue format = header.get("format");
  if (format.text() != kFormatName) format.reject(in_quotes(kFormatName));
  const ExchangeValue version = header.get("format_version");
  if (version.number_text() != "1") version.reject("1, the only version that is known");
  Claim claim;
  if (const auto value = header.find("points")) claim.point_count = count_of(*value);
  if (const auto value = header.find("merged_duplicates")) claim.merged_duplicates = count_of(*value);
  if (const auto value = header.find("input_sha256")) claim.input_sha256 = sha256_of(*value);
  if (const auto value = header.find("classes")) claim.classes = list_of(*value, ids_of);
  if (const auto value = header.find("critical")) {
    value->expect_size(4);
    claim.critical_counts = {count_of((*value)[0]), count_of((*value)[1]), count_of((*value)[2]),
                             count_of((*value)[3])};
  }
  if (const auto value = header.find("regular_stationary")) claim.regular_counts = regular_counts_of(*value);
  return claim;
}

// ---- Records ----

void read_index(const ExchangeValue& record, ClaimedPoint& point) {
  const ExchangeValue index = record.get("index");
  if (index.is(JsonKind::kArray)) {
    index.expect_size(2);
    point.index = index_of(index[0]);
    point.hull_dimension = index_of(index[1]);
    if (point.index < 1 || point.index >= *point.hull_dimension) index.reject("a kind: [1,2], [2,3], [1,3]");
  } else {
    point.index = index_of(index);
  }
  const auto kind = record.find("kind");
  const char* const expected = point.hull_dimension ? "regular" : "critical";
  if (kind && kind->text() != expected) kind->reject(in_quotes(expected) + ", which the index says");
}

// center, or else center_double; likewise squared_distance. A double is null where none is near.
void read_sphere(const ExchangeValue& record, ClaimedPoint& point) {
  if (const auto center = record.find("center")) {
    point.center = position_of(*center);
  } else if (const auto near = record.find("center_double"); near && !near->is_null()) {
    near->expect_size(3);
    if (!(*near)[0].is_null() && !(*near)[1].is_null() && !(*near)[2].is_null())
      point.center = position_of(*near);
  }
  if (const auto distance = record.find("squared_distance")) {
    point.squared_distance = distance_of(*distance);
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

// A key that only critical points of one index have.
std::optional<ExchangeValue> find_of_index(const ExchangeValue& record, const ClaimedPoint& point,
                                           const char* key, int index) {
  const auto value = record.find(key);
  if (value && (point.hull_dimension || point.index != index)) {
    record.place().reject(std::string("a key of critical points of index ") + std::to_string(index) +
                          " only: " + in_quotes(key));
  }
  return value;
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

// Of critical points of index 2 and of regular stationary points.
void read_stable(const ExchangeValue& record, ClaimedPoint& point) {
  for (const char* key : {"stable", "skeleton", "surface"}) {
    const auto value = record.find(key);
    if (!value) continue;
    if (!point.hull_dimension && point.index != 2) {
      record.place().reject("a key of critical points of index 2 and of regular stationary points only: " +
                            in_quotes(key));
    }
    if (key == std::string_view("stable")) point.stable = stable_of(*value);
    if (key == std::string_view("skeleton")) point.skeleton = skeleton_of(*value);
    if (key == std::string_view("surface")) point.surface = surface_of(*value);
  }
  if (point.hull_dimension && point.stable && point.stable->boundary) {
    record.place().reject("a boundary, which only critical points have");
  }
}

ClaimedPoint point_of(const ExchangeValue& record) {
  ClaimedPoint point;
  point.line = record.place().line;
  read_index(record, point);
  if (const auto contact = record.find("contact")) {
    point.contact = ids_of(*contact);
    if (point.contact.empty()) contact->reject("a contact set: it is empty");
  }
  read_sphere(record, point);
  if (point.contact.empty() && !point.center) record.place().reject("neither 'contact' nor 'center'");
  read_flow(record, point);
  read_stable(record, point);
  return point;
}

bool recognises_exchange(std::string_view bytes) {
  const auto* const first = std::find_if_not(bytes.begin(), bytes.end(), is_blank);
  return first != bytes.end() && *first == '{';
}

Claim read_exchange(std::string_view text, std::string_view file) {
  LineReader lines(text, file);
  std::string_view line;
  lines.next_filled(line);
  const JsonTree header = parse_json(line, lines.place());
  Claim claim = claim_of_header({header, "header", lines.place()});
  while (lines.next_filled(line)) {
    const JsonTree record = parse_json(line, lines.place());
    claim.points.push_back(point_of({record, "record", lines.place()}));
  }
  return claim;
}

}  // namespace

const ClaimFormat kExchangeClaims = {
    .name = "exchange", .recognises = recognises_exchange, .read = read_exchange};

}  // namespace flowcert::io
