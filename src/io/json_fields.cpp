// Every key of a JSON output is written here, or in the file that writes the output.
#include "io/json_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "flowcert/reproducibility.h"
#include "io/input_bytes.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::io {

// ---- Written ----

Json header_fields(const char* format, int format_version) {
  const Reproducibility made_by = reproducibility();
  Json fields;
  fields["format"] = format;
  fields["format_version"] = format_version;
  fields["version"] = made_by.version;
  fields["commit"] = made_by.commit;
  fields["kernel"] = made_by.kernel;
  fields["compiler"] = made_by.compiler;
  fields["cgal"] = made_by.cgal;
  return fields;
}

Json header_fields(const char* format, int format_version, const PointSet& points) {
  Json fields = header_fields(format, format_version);
  fields["input_sha256"] = coordinates_sha256(points);
  if (!points.left_out().empty()) fields["left_out"] = points.left_out();
  return fields;
}

void add_counts(Json& object, const PointSet& points, const StationaryPoints& stationary) {
  const RegularCounts& regular = stationary.regular_counts();
  object["points"] = points.row_count();
  object["merged_duplicates"] = points.merged_duplicates();
  object["critical"] = stationary.critical_counts();
  Json& kinds = object["regular_stationary"];
  kinds["1-2"] = regular.kind12;
  kinds["1-3"] = regular.kind13;
  kinds["2-3"] = regular.kind23;
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

Json double_field(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json segment_field(const FlowSegment& segment) {
  Json field;
  field["type"] = type_text(segment.type);
  field["driver"] = center_field(segment.driver);
  field["end"] = segment.end ? center_field(*segment.end) : Json(nullptr);
  return field;
}

Json segment_with_contacts_field(const FlowSegment& segment) {
  Json field = segment_field(segment);
  field["start_contact"] = segment.start_contact;
  field["crossed_contact"] = segment.crossed_contact;
  field["end_contact"] = segment.end ? Json(segment.end_contact) : Json(nullptr);
  return field;
}

Json limit_field(const PointSet& points, const std::optional<StationaryLimit>& limit) {
  Json field;
  if (!limit) {
    field["kind"] = "infinity";
    for (const char* key : {"index", "position", "contact", "squared_distance"}) field[key] = nullptr;
    return field;
  }
  field["kind"] = limit->index.is_critical() ? "critical" : "regular";
  field["index"] = index_field(limit->index);
  field["position"] = center_field(limit->position);
  field["contact"] = limit->contact;
  field["squared_distance"] = to_text(exact_sphere(points, limit->contact).squared_radius);
  return field;
}

Json stable_field(const StationaryPoints& stationary, const StableManifolds& s2, std::size_t i) {
  Json field;
  field["segments"] = s2.segment_count(i);
  field["has_vertex"] = s2.has_vertex(i);
  field["has_interval"] = s2.has_interval(i);
  if (!stationary.index(s2.record(i)).is_critical()) return field;
  Json& boundary = field["boundary"] = Json::array();
  for (const std::uint32_t record : s2.boundary(i)) boundary.push_back(stationary.contact(record));
  return field;
}

Json critical_point_field(const FlowComplex& complex, std::size_t record, const Rational& squared_distance) {
  Json field;
  field["record"] = record;
  field["contact"] = complex.stationary().contact(record);
  field["center"] = center_field(complex.sphere(record).center);
  const Point nearest = complex.rounded_sphere(record).center;
  field["center_double"] = {double_field(nearest.x), double_field(nearest.y), double_field(nearest.z)};
  field["squared_distance"] = to_text(squared_distance);
  field["squared_distance_double"] = double_field(nearest_or_infinity(squared_distance));
  return field;
}

Json pair_field(const PersistenceDiagram& diagram, const PersistencePair& pair) {
  const auto end_field = [&](std::size_t record) {
    return critical_point_field(diagram.complex(), record, diagram.squared_value(record));
  };
  Json field;
  field["dimension"] = pair.dimension;
  field["birth"] = end_field(pair.birth);
  field["death"] = pair.death ? end_field(*pair.death) : Json(nullptr);
  return field;
}

// ---- Read ----

const Json& required_field(const Json& object, const char* key) {
  if (!object.is_object()) throw InvalidInput(fmt::format("no object that could have '{}'", key));
  const auto value = object.find(key);
  if (value == object.end()) throw InvalidInput(fmt::format("no key '{}'", key));
  return *value;
}

const Json::string_t& required_string(const Json& value, const char* what) {
  if (!value.is_string()) throw InvalidInput(fmt::format("'{}' is no string", what));
  return value.get_ref<const Json::string_t&>();
}

const Json& required_array(const Json& value, const char* what) {
  if (!value.is_array()) throw InvalidInput(fmt::format("'{}' is no array", what));
  return value;
}

Rational required_rational(const Json& value, const char* what) { return exact_rational(required_string(value, what)); }

// ---- JSON from somebody else ----

namespace {

// Goes through the text before a tree is made of it, because a tree that is too deep ends its reader.
class LimitChecker : public nlohmann::json_sax<Json> {
 public:
  explicit LimitChecker(std::string_view name) : name_(name) {}

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(std::int64_t /*value*/) override { return true; }
  bool number_unsigned(std::uint64_t /*value*/) override { return true; }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return true; }
  bool string(std::string& /*value*/) override { return true; }
  bool binary(Json::binary_t& /*value*/) override { return true; }
  bool start_array(std::size_t /*size*/) override { return require(limits_.open()); }
  bool start_object(std::size_t /*size*/) override { return require(limits_.open()); }
  bool key(std::string& /*key*/) override { return require(limits_.key()); }
  bool end_array() override { return close(); }
  bool end_object() override { return close(); }
  bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& /*error*/) override {
    reject_file(name_, "not JSON, in byte " + std::to_string(position));
  }

 private:
  [[nodiscard]] bool require(const std::string& fault) const {
    if (!fault.empty()) reject_file(name_, fault);
    return true;
  }
  bool close() {
    limits_.close();
    return true;
  }

  std::string_view name_;
  JsonLimits limits_;
};

}  // namespace

std::string JsonLimits::open() {
  if (keys_.size() == kDeepestJson) return "nested deeper than " + std::to_string(kDeepestJson) + " levels";
  keys_.push_back(0);
  return {};
}

std::string JsonLimits::key() {
  if (++keys_.back() <= kMostJsonKeys) return {};
  return "an object of more than " + std::to_string(kMostJsonKeys) + " keys";
}

std::size_t place_of_no_json(std::string_view text) { return text.starts_with(kByteOrderMark) ? 0 : text.find('\0'); }

Json parse_foreign_json(std::string_view text, std::string_view name) {
  if (const std::size_t at = place_of_no_json(text); at != std::string_view::npos) {
    reject_file(name, "not JSON, in byte " + std::to_string(at + 1));
  }
  LimitChecker checker(name);
  Json::sax_parse(text, &checker);
  return Json::parse(text);
}

}  // namespace flowcert::io
