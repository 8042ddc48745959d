// Stable and unstable manifolds are listed in the order of their records, so that one walk writes all.
#include "flowcert/write_stationary_points.h"

#include "flowcert/stable_manifolds.h"
#include "io/json_fields.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::size_t kProgressStep = 64;

class RecordWriter {
 public:
  RecordWriter(const FlowComplex& complex, const RecordsToWrite& wanted)
      : complex_(complex), stationary_(complex.stationary()), wanted_(wanted) {}

  // To be called for each record, in the order of the list.
  Json record(std::size_t i) {
    const ExactSphere sphere = complex_.sphere(i);
    const StationaryIndex index = stationary_.index(i);
    Json fields;
    fields["index"] = index_field(index);
    fields["kind"] = index.is_critical() ? "critical" : "regular";
    fields["contact"] = stationary_.contact(i);
    fields["center"] = center_field(sphere.center);
    fields["squared_distance"] = to_text(sphere.squared_radius);
    Json& doubles = fields["center_double"] = Json::array();
    for (const Rational& coordinate : sphere.center) doubles.push_back(double_field(coordinate));
    fields["squared_distance_double"] = double_field(sphere.squared_radius);
    if ((wanted_.u2 || wanted_.s2) && index == StationaryIndex{1, 1}) fields["samples"] = fields["contact"];
    if (wanted_.u2) add_u2(i, fields);
    if (wanted_.s2) add_s2(i, sphere.center, fields);
    return fields;
  }

 private:
  [[nodiscard]] Json limit_contact(std::size_t side) const {
    const std::optional<std::size_t> limit = complex_.unstable().limit(next_u2_, side);
    return limit ? Json(stationary_.contact(*limit)) : Json(nullptr);
  }

  [[nodiscard]] Json polyline(std::size_t side) const {
    Json segments = Json::array();
    for (const FlowSegment& segment : complex_.unstable().orbit(next_u2_, side).segments) {
      segments.push_back(segment_field(segment));
    }
    return segments;
  }

  void add_u2(std::size_t i, Json& fields) {
    const UnstableManifolds& u2 = complex_.unstable();
    if (next_u2_ == u2.size() || u2.saddle(next_u2_) != i) return;
    Json& limits = fields["limits"] = Json::array();
    for (const std::size_t side : {0U, 1U}) limits.push_back(limit_contact(side));
    if (wanted_.polylines) {
      Json& lines = fields["u2"] = Json::array();
      for (const std::size_t side : {0U, 1U}) lines.push_back(polyline(side));
    }
    ++next_u2_;
  }

  void add_s2(std::size_t i, const RationalPoint& center, Json& fields) {
    const StableManifolds& s2 = complex_.stable();
    if (next_s2_ == s2.size() || s2.record(next_s2_) != i) return;
    fields["stable"] = stable_field(stationary_, s2, next_s2_);
    if (wanted_.skeletons) {
      const StableSet set = s2.set(next_s2_);
      const auto walk = boundary_walk(set, stationary_.index(i), stationary_.contact(i));
      fields["stable"]["walk"] = walk ? Json(*walk) : Json(nullptr);
      fields["skeleton"] = skeleton_field(set);
      if (stationary_.index(i).is_critical()) fields["skeleton"]["orbits"] = connecting_orbits(set, center);
    }
    ++next_s2_;
  }

  const FlowComplex& complex_;
  const StationaryPoints& stationary_;
  RecordsToWrite wanted_;
  std::size_t next_u2_ = 0, next_s2_ = 0;
};

}  // namespace

void write_stationary_points(std::ostream& out, const FlowComplex& complex, const RecordsToWrite& wanted,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  const std::size_t count = complex.stationary().size();
  Json header = header_fields("flowcert-stationary-points", 1, complex.points());
  add_counts(header, complex.points(), complex.stationary());
  header["classes"] = complex.points().repeated_classes();
  out << header.dump() << '\n';
  RecordWriter writer(complex, wanted);
  for (std::size_t i = 0; i < count && out; ++i) {
    out << writer.record(i).dump() << '\n';
    if (progress && (i + 1) % kProgressStep == 0) progress(i + 1, count);
  }
  if (progress) progress(count, count);
}

}  // namespace flowcert
