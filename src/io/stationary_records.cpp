// See stationary_records.h.
#include "io/stationary_records.h"

namespace flowcert::io {

namespace {

constexpr std::size_t kProgressStep = 64;

Json record(const PointSet& points, const StationaryPoints& stationary, std::size_t i) {
  const ExactSphere sphere = exact_sphere(points, stationary.contact(i));
  const StationaryIndex index = stationary.index(i);
  Json fields;
  fields["index"] = index_field(index);
  fields["kind"] = index.is_critical() ? "critical" : "regular";
  fields["contact"] = stationary.contact(i);
  fields["center"] = center_field(sphere.center);
  fields["squared_distance"] = to_text(sphere.squared_radius);
  Json& doubles = fields["center_double"] = Json::array();
  for (const Rational& coordinate : sphere.center) doubles.push_back(double_field(coordinate));
  fields["squared_distance_double"] = double_field(sphere.squared_radius);
  return fields;
}

}  // namespace

void write_stationary_records(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                              const std::string& input_sha256, const FurtherKeys& add_further_keys,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
  Json header = header_fields("flowcert-stationary-points", 1, input_sha256);
  add_counts(header, points, stationary);
  header["classes"] = points.repeated_classes();
  out << header.dump() << '\n';
  for (std::size_t i = 0; i < stationary.size() && out; ++i) {
    Json object = record(points, stationary, i);
    if (add_further_keys) add_further_keys(i, object);
    out << object.dump() << '\n';
    if (progress && (i + 1) % kProgressStep == 0) progress(i + 1, stationary.size());
  }
  if (progress) progress(stationary.size(), stationary.size());
}

}  // namespace flowcert::io
