// Stable and unstable manifolds are listed in the order of their records, so that one walk writes all. What every
// record has is written as text at once, because long numbers take most of the file.
#include "flowcert/write_stationary_points.h"

#include <fmt/format.h>

#include <iterator>

#include "flowcert/stable_manifolds.h"
#include "geometry/bounded_sphere.h"
#include "io/json_fields.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::size_t kProgressStep = 64;

class RecordWriter {
 public:
  RecordWriter(const FlowComplex& complex, const RecordsToWrite& wanted)
      : complex_(complex), stationary_(complex.stationary()), wanted_(wanted) {}

  // To be called for each record, in the order of the list. The line holds until the next call.
  const std::string& line(std::size_t i) {
    const StationaryIndex index = stationary_.index(i);
    text_.clear();
    add(R"({{"index":{},"kind":"{}","contact":[{}])", index_field(index).dump(),
        index.is_critical() ? "critical" : "regular", fmt::join(stationary_.contact(i), ","));
    Json more;  // the keys after these
    if (wanted_.centers == WrittenCenters::kExact) {
      const ExactSphere sphere = complex_.sphere(i);
      add_center(sphere);
      add_doubles(doubles_of(i, sphere), more);
    } else if (wanted_.centers == WrittenCenters::kDouble) {
      add_doubles(complex_.rounded_sphere(i), more);
    }
    if ((wanted_.u2 || wanted_.s2) && index == StationaryIndex{1, 1}) more["samples"] = stationary_.contact(i);
    if (wanted_.u2) add_u2(i, more);
    if (wanted_.s2) add_s2(i, more);
    if (more.is_null()) {
      text_ += '}';
    } else {
      text_ += ',';
      text_ += std::string_view(more.dump()).substr(1);
    }
    text_ += '\n';
    return text_;
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  void add_center(const ExactSphere& sphere) {
    const auto& [x, y, z] = sphere.center;
    add(R"(,"center":["{}","{}","{}"],"squared_distance":"{}")", to_text(x), to_text(y), to_text(z),
        to_text(sphere.squared_radius));
  }

  // Bounds decide most of them sooner than the exact numbers do.
  [[nodiscard]] RoundedSphere doubles_of(std::size_t i, const ExactSphere& sphere) const {
    const std::size_t dimension = stationary_.index(i).hull_dimension;
    const auto decided = decided_sphere(bounded_sphere(complex_.points(), stationary_.contact(i), dimension));
    return decided ? *decided : rounded_sphere(sphere);
  }

  static void add_doubles(const RoundedSphere& sphere, Json& fields) {
    const auto& [x, y, z] = sphere.center;
    fields["center_double"] = Json::array({double_field(x), double_field(y), double_field(z)});
    fields["squared_distance_double"] = double_field(sphere.squared_radius);
  }

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

  void add_s2(std::size_t i, Json& fields) {
    const StableManifolds& s2 = complex_.stable();
    if (next_s2_ == s2.size() || s2.record(next_s2_) != i) return;
    fields["stable"] = stable_field(stationary_, s2, next_s2_);
    if (wanted_.skeletons) {
      const StableSet set = s2.set(next_s2_);
      const auto walk = boundary_walk(set, stationary_.index(i), stationary_.contact(i));
      fields["stable"]["walk"] = walk ? Json(*walk) : Json(nullptr);
      fields["skeleton"] = skeleton_field(set);
      if (stationary_.index(i).is_critical()) {
        fields["skeleton"]["orbits"] = connecting_orbits(set, complex_.sphere(i).center);
      }
    }
    ++next_s2_;
  }

  const FlowComplex& complex_;
  const StationaryPoints& stationary_;
  RecordsToWrite wanted_;
  std::size_t next_u2_ = 0, next_s2_ = 0;
  std::string text_;
};

}  // namespace

void write_stationary_points(std::ostream& out, const FlowComplex& complex, const RecordsToWrite& wanted,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  const std::size_t count = complex.stationary().size();
  Json header = header_fields("flowcert-stationary-points", 1, complex.points());
  add_counts(header, complex.points(), complex.stationary());
  header["classes"] = complex.points().repeated_classes();
  if (wanted.centers == WrittenCenters::kDouble) header["centers"] = "double";
  if (wanted.centers == WrittenCenters::kNone) header["centers"] = "none";
  out << header.dump() << '\n';
  RecordWriter writer(complex, wanted);
  for (std::size_t i = 0; i < count && out; ++i) {
    out << writer.line(i);
    if (progress && (i + 1) % kProgressStep == 0) progress(i + 1, count);
  }
  if (progress) progress(count, count);
}

}  // namespace flowcert
