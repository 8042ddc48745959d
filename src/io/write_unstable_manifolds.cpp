// See write_unstable_manifolds.h.
#include "io/write_unstable_manifolds.h"

#include "io/orbit_fields.h"
#include "io/stationary_records.h"

namespace flowcert {

namespace {

Json limit_contact(const StationaryPoints& stationary, const UnstableManifolds& u2, std::size_t k,
                   std::size_t side) {
  const std::optional<std::size_t> limit = u2.limit(k, side);
  return limit ? Json(stationary.contact(*limit)) : Json(nullptr);
}

Json polyline(UnstableManifolds& u2, std::size_t k, std::size_t side) {
  Json segments = Json::array();
  for (const FlowSegment& segment : u2.orbit(k, side).segments) segments.push_back(segment_field(segment));
  return segments;
}

}  // namespace

void write_unstable_manifolds(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                              UnstableManifolds& u2, bool polylines, const std::string& input_sha256,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
  std::size_t next = 0;  // of the index-2 points, which come in the order of the list
  const auto add_further_keys = [&](std::size_t i, Json& record) {
    if (stationary.index(i) == StationaryIndex{1, 1}) record["samples"] = stationary.contact(i);
    if (next == u2.size() || u2.saddle(next) != i) return;
    record["limits"] =
        Json::array({limit_contact(stationary, u2, next, 0), limit_contact(stationary, u2, next, 1)});
    if (polylines) record["u2"] = Json::array({polyline(u2, next, 0), polyline(u2, next, 1)});
    ++next;
  };
  write_stationary_records(out, points, stationary, input_sha256, add_further_keys, progress);
}

}  // namespace flowcert
