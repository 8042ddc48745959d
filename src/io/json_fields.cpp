// See json_fields.h.
#include "io/json_fields.h"

#include "flowcert/reproducibility.h"

namespace flowcert::io {

Json header_fields(const char* format, int format_version, const std::string& input_sha256) {
  const Reproducibility made_by = reproducibility();
  Json fields;
  fields["format"] = format;
  fields["format_version"] = format_version;
  fields["version"] = made_by.version;
  fields["commit"] = made_by.commit;
  fields["kernel"] = made_by.kernel;
  fields["compiler"] = made_by.compiler;
  fields["cgal"] = made_by.cgal;
  fields["input_sha256"] = input_sha256;
  return fields;
}

void add_counts(Json& object, const PointSet& points, const StationaryPoints& stationary) {
  const RegularCounts& regular = stationary.regular_counts();
  object["points"] = points.row_count();
  object["merged_duplicates"] = points.merged_duplicates();
  object["critical"] = stationary.critical_counts();
  Json& kinds = object["regular_stationary"];
  kinds["1-2"] = regular.kind12;
  kinds["2-3"] = regular.kind23;
  kinds["1-3"] = regular.kind13;
}

Json index_field(StationaryIndex index) {
  if (index.is_critical()) return index.face_dimension;
  return std::array{index.face_dimension, index.hull_dimension};
}

Json center_field(const RationalPoint& point) {
  Json field = Json::array();
  for (const Rational& coordinate : point) field.push_back(to_text(coordinate));
  return field;
}

Json double_field(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? Json(*nearest) : Json(nullptr);
}

}  // namespace flowcert::io
