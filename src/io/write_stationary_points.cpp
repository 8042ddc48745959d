// Stable and unstable manifolds are listed in the order of their records, so that one walk writes all of a part. What
// every record has is written as text at once, because long numbers take most of the file.
#include "flowcert/write_stationary_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <ranges>

#include "flowcert/connections.h"
#include "flowcert/stable_manifolds.h"
#include "geometry/bounded_sphere.h"
#include "geometry/floating_point.h"
#include "io/json_fields.h"
#include "io/manifold_fields.h"
#include "io/ordered_text.h"

namespace flowcert {

using namespace io;

namespace {

// The first k below the count for which record_of(k), which ascends, is no less than the record.
template <class RecordOf>
std::size_t first_from(std::size_t record, std::size_t count, const RecordOf& record_of) {
  const auto places = std::views::iota(std::size_t{0}, count);
  return static_cast<std::size_t>(std::ranges::lower_bound(places, record, {}, record_of) - places.begin());
}

class RecordWriter {
 public:
  // Writes the records from `first` on, one after the other, to the text's end.
  RecordWriter(const FlowComplex& complex, const RecordsToWrite& wanted, std::size_t first, std::string& text)
      : complex_(complex), stationary_(complex.stationary()), wanted_(wanted), text_(text) {
    if (wanted.u2) {
      const UnstableManifolds& u2 = complex.unstable();
      next_u2_ = first_from(first, u2.size(), [&u2](std::size_t k) { return u2.saddle(k); });
    }
    if (wanted.s2) {
      const StableManifolds& s2 = complex.stable();
      next_s2_ = first_from(first, s2.size(), [&s2](std::size_t k) { return s2.record(k); });
    }
    if (wanted.all) {
      const FlowLimits& limits = complex.limits();
      next_list_ = first_from(first, limits.size(), [&limits](std::size_t k) { return limits.record(k); });
    }
    if (wanted.sheets) {
      const UnstableSurfaces& u1 = complex.unstable_surfaces();
      next_u1_ = first_from(first, u1.size(), [&u1](std::size_t k) { return u1.record(k); });
    }
  }

  void add_line(std::size_t i) {
    const StationaryIndex index = stationary_.index(i);
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
    if (wanted_.all) {
      add_limits(i, more);
      add_volume(i, more);
    }
    if (wanted_.sheets) add_u1(i, more);
    if (more.is_null()) {
      text_ += '}';
    } else {
      text_ += ',';
      text_ += std::string_view(more.dump()).substr(1);
    }
    text_ += '\n';
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
    if (wanted_.all && wanted_.skeletons && stationary_.index(i) == StationaryIndex{3, 3}) {
      fields["skeleton"] = skeleton_field(s2.set_of_record(i));
    }
    if (next_s2_ == s2.size() || s2.record(next_s2_) != i) return;
    fields["stable"] = stable_field(stationary_, s2, next_s2_);
    if (wanted_.skeletons) {
      const StableSet<> set = s2.set(next_s2_);
      const auto walk = boundary_walk(set, stationary_.index(i), stationary_.contact(i));
      fields["stable"]["walk"] = walk ? Json(*walk) : Json(nullptr);
      fields["skeleton"] = skeleton_field(set);
      if (stationary_.index(i).is_critical()) {
        fields["skeleton"]["orbits"] = connecting_orbits(set, complex_.sphere(i).center);
      }
    }
    ++next_s2_;
  }

  void add_limits(std::size_t i, Json& fields) {
    const FlowLimits& limits = complex_.limits();
    if (next_list_ == limits.size() || limits.record(next_list_) != i) return;
    const bool is_exact = wanted_.centers == WrittenCenters::kExact,
               has_positions = wanted_.centers != WrittenCenters::kNone;
    fields["lambda"] = is_exact ? lambda_field(stationary_, limits.list(next_list_))
                                : lambda_field(stationary_, limits.rounded_list(next_list_), has_positions);
    fields["connections"] = connections_field(stationary_, connections_of(limits, next_list_));
    ++next_list_;
  }

  void add_volume(std::size_t i, Json& fields) const {
    const StableVolumes& volumes = complex_.volumes();
    const bool is_exact = wanted_.volumes == WrittenVolumes::kExact;
    if (is_exact) fields["volume"] = to_text(volumes.exact(i));
    fields["volume_double"] = double_field(volumes.nearest(i));
    // A positive volume may be nearest to 0.
    if (is_exact) {
      add_shares(volumes.shares(i), "shares", [](const Rational& share) { return Json(to_text(share)); }, fields);
    } else if (wanted_.volumes == WrittenVolumes::kShares) {
      add_shares(volumes.rounded_shares(i), "shares_double", double_field, fields);
    }
  }
  template <class Share, class Field>
  static void add_shares(const std::vector<std::pair<PointId, Share>>& shares, const char* key, const Field& field_of,
                         Json& fields) {
    if (shares.empty()) return;
    Json& field = fields[key] = Json::array();
    for (const auto& [sample, share] : shares) field.push_back(Json::array({sample, field_of(share)}));
  }

  void add_u1(std::size_t i, Json& fields) {
    const UnstableSurfaces& u1 = complex_.unstable_surfaces();
    if (next_u1_ == u1.size() || u1.record(next_u1_) != i) return;
    fields["u1"] = unstable_surface_field(u1.set(next_u1_));
    ++next_u1_;
  }

  const FlowComplex& complex_;
  const StationaryPoints& stationary_;
  RecordsToWrite wanted_;
  std::size_t next_u2_ = 0, next_s2_ = 0, next_list_ = 0, next_u1_ = 0;
  std::string& text_;
};

}  // namespace

void write_stationary_points(std::ostream& out, const FlowComplex& complex, const RecordsToWrite& wanted,
                             const Progress& progress) {
  const geometry::IeeeDoubles ieee;
  const std::size_t count = complex.stationary().size();
  Json header = header_fields("flowcert-stationary-points", 1, complex.points());
  add_counts(header, complex.points(), complex.stationary());
  header["classes"] = complex.points().repeated_classes();
  if (wanted.centers == WrittenCenters::kDouble) header["centers"] = "double";
  if (wanted.centers == WrittenCenters::kNone) header["centers"] = "none";
  if (wanted.all) {
    header["morse_smale"] = is_morse_smale(complex.stationary(), complex.limits(), complex.stable());
    header["hull_volume"] = to_text(complex.volumes().hull());
    constexpr std::array kForms = {"double", "shares", "exact"};  // as they are listed
    header["volumes"] = kForms.at(static_cast<std::size_t>(wanted.volumes));
  }
  out << header.dump() << '\n';
  const auto make = [&](std::size_t first, std::size_t last, std::string& text) {
    RecordWriter writer(complex, wanted, first, text);
    for (std::size_t i = first; i < last; ++i) writer.add_line(i);
  };
  const auto write = [&](const std::string& text, std::size_t done) {
    out << text;
    if (progress) progress(done, count);
    return bool(out);
  };
  const bool are_exact = wanted.centers == WrittenCenters::kExact || wanted.volumes == WrittenVolumes::kExact;
  const bool are_long = wanted.polylines || wanted.skeletons || (wanted.all && are_exact);
  const std::size_t records = wanted.sheets ? 1 : are_long ? kLongRecords : kShortRecords;
  write_in_order(count, records, complex.threads(), make, write);
  if (wanted.all && wanted.skeletons) {
    write_skeleton_of_infinity(out << R"({"kind":"infinity","skeleton":)", complex.stable().set_of_infinity());
    out << "}\n";
  }
  if (progress) progress(count, count);
}

}  // namespace flowcert
