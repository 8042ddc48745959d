// See write_manifolds.h.
#include "io/write_manifolds.h"

#include "flowcert/connecting_orbits.h"
#include "io/orbit_fields.h"
#include "io/skeleton_fields.h"
#include "io/stationary_records.h"

namespace flowcert::io {

namespace {

class FurtherKeysOf {
 public:
  FurtherKeysOf(const PointSet& points, const StationaryPoints& stationary, const ManifoldsToWrite& manifolds)
      : points_(points), stationary_(stationary), manifolds_(manifolds) {}

  void operator()(std::size_t i, Json& record) {
    if (stationary_.index(i) == StationaryIndex{1, 1}) record["samples"] = stationary_.contact(i);
    if (manifolds_.u2 != nullptr) add_u2(i, record);
    if (manifolds_.s2 != nullptr) add_s2(i, record);
  }

 private:
  [[nodiscard]] Json limit_contact(std::size_t side) const {
    const std::optional<std::size_t> limit = manifolds_.u2->limit(next_u2_, side);
    return limit ? Json(stationary_.contact(*limit)) : Json(nullptr);
  }

  [[nodiscard]] Json polyline(std::size_t side) const {
    Json segments = Json::array();
    for (const FlowSegment& segment : manifolds_.u2->orbit(next_u2_, side).segments) {
      segments.push_back(segment_field(segment));
    }
    return segments;
  }

  // Index-2 points and regular ones come in the order of the list.
  void add_u2(std::size_t i, Json& record) {
    if (next_u2_ == manifolds_.u2->size() || manifolds_.u2->saddle(next_u2_) != i) return;
    Json& limits = record["limits"] = Json::array();
    for (const std::size_t side : {0U, 1U}) limits.push_back(limit_contact(side));
    if (manifolds_.polylines) {
      Json& u2 = record["u2"] = Json::array();
      for (const std::size_t side : {0U, 1U}) u2.push_back(polyline(side));
    }
    ++next_u2_;
  }

  void add_s2(std::size_t i, Json& record) {
    StableManifolds& s2 = *manifolds_.s2;
    if (next_s2_ == s2.size() || s2.record(next_s2_) != i) return;
    record["stable"] = stable_field(stationary_, s2, next_s2_);
    if (manifolds_.skeletons) {
      const StableSet set = s2.set(next_s2_);
      const auto walk = boundary_walk(set, stationary_.index(i), stationary_.contact(i));
      record["stable"]["walk"] = walk ? Json(*walk) : Json(nullptr);
      record["skeleton"] = skeleton_field(set);
      if (stationary_.index(i).is_critical()) {
        const RationalPoint center = exact_sphere(points_, stationary_.contact(i)).center;
        record["skeleton"]["orbits"] = connecting_orbits(set, center);
      }
    }
    ++next_s2_;
  }

  const PointSet& points_;
  const StationaryPoints& stationary_;
  const ManifoldsToWrite& manifolds_;
  std::size_t next_u2_ = 0, next_s2_ = 0;
};

}  // namespace

void write_manifolds(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                     const ManifoldsToWrite& manifolds, const std::string& input_sha256,
                     const std::function<void(std::size_t, std::size_t)>& progress) {
  FurtherKeysOf add_further_keys(points, stationary, manifolds);
  write_stationary_records(out, points, stationary, input_sha256, std::ref(add_further_keys), progress);
}

}  // namespace flowcert::io
