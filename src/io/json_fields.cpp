// See json_fields.h.
#include "io/json_fields.h"

#include "flowcert/reproducibility.h"

namespace flowcert {

Json header_fields(const char* format, int format_version, const std::string& input_sha256) {
  const Reproducibility made_by = reproducibility();
  return {{"format", format},         {"format_version", format_version}, {"version", made_by.version},
          {"commit", made_by.commit}, {"kernel", made_by.kernel},         {"compiler", made_by.compiler},
          {"cgal", made_by.cgal},     {"input_sha256", input_sha256}};
}

void add_counts(Json& object, const PointSet& points, const StationaryPoints& stationary) {
  const RegularCounts& regular = stationary.regular_counts();
  object["points"] = points.row_count();
  object["merged_duplicates"] = points.merged_duplicates();
  object["critical"] = stationary.critical_counts();
  object["regular_stationary"] = {{"1-2", regular.kind12}, {"2-3", regular.kind23}, {"1-3", regular.kind13}};
}

Json index_field(StationaryIndex index) {
  if (index.is_critical()) return index.face_dimension;
  return Json::array({index.face_dimension, index.hull_dimension});
}

Json center_field(const RationalPoint& point) {
  return Json::array({to_text(point[0]), to_text(point[1]), to_text(point[2])});
}

Json double_field(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? Json(*nearest) : Json(nullptr);
}

}  // namespace flowcert
