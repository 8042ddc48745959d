// The whole complex for Python: volumes of stable sets, where the directions of stationary points lead, connections,
// and unstable sets of dimension 2.
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "complex.h"
#include "flowcert/connections.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// The place of what belongs to a stationary point among all of its kind, which come in the order of the points.
template <class Parts>
std::optional<std::size_t> place_of_record(const Parts& parts, std::size_t record) {
  std::size_t first = 0, last = parts.size();
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    if (parts.record(middle) < record) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return first < parts.size() && parts.record(first) == record ? std::optional(first) : std::nullopt;
}

py::tuple exit_of(const RationalPoint& exit) { return ratios_of(exit); }
// Zeros have no sign.
py::tuple exit_of(const Point& exit) { return py::make_tuple(exit.x + 0.0, exit.y + 0.0, exit.z + 0.0); }

template <class List>
py::tuple tuple_of_list(const List& list) {
  py::list directions;
  for (const auto& direction : list.directions) {
    directions.append(py::make_tuple(direction.limit, exit_of(direction.exit), direction.is_vector));
  }
  return py::make_tuple(directions, list.arcs);
}

std::vector<ConnectionRecord> records_of_connections(const FlowLimits& limits) {
  std::vector<ConnectionRecord> records;
  for (const Connection& connection : connections(limits)) {
    const bool is_finite = connection.to != Connection::kInfinity;
    records.push_back({.from = connection.from,
                       .to = is_finite ? std::int64_t{connection.to} : -1,
                       .orbits = connection.orbits,
                       .families = connection.families});
  }
  return records;
}

// ---- Unstable sets ----

double double_of(const Rational& x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return nearest_double(x).value_or(x < 0 ? -kInfinity : kInfinity) + 0.0;  // zeros have no sign
}

// Makes tuples of positions and of what has some.
struct SurfaceTuples {
  bool exact;

  [[nodiscard]] py::tuple position(const RationalPoint& x) const {
    return exact ? ratios_of(x) : py::make_tuple(double_of(x[0]), double_of(x[1]), double_of(x[2]));
  }
  [[nodiscard]] py::tuple of(const RationalPoint& x) const { return position(x); }
  [[nodiscard]] py::tuple of(const Corner<>& corner) const {
    return py::make_tuple(position(corner.position), corner.at_infinity);
  }
  [[nodiscard]] py::tuple of(const EdgePart<>& part) const {
    return py::make_tuple(part.polygon, py::make_tuple(of(part.front), of(part.back)));
  }
  [[nodiscard]] py::tuple of(const Region<>& sheet) const { return py::make_tuple(sheet.samples, list(sheet.corners)); }
  [[nodiscard]] py::tuple of(const Crossing<>& segment) const {
    return py::make_tuple(segment.samples, position(segment.back.position), of(segment.front));
  }
  template <class Part>
  [[nodiscard]] py::list list(const std::vector<Part>& parts) const {
    py::list made;
    for (const Part& part : parts) made.append(of(part));
    return made;
  }
};

}  // namespace

py::array Complex::volumes() const {
  std::vector<double> doubles;
  {
    const ReleasedLock released;
    const StableVolumes& volumes = complex_.volumes();
    doubles.resize(complex_.stationary().size());
    for (std::size_t record = 0; record < doubles.size(); ++record) doubles[record] = volumes.nearest(record);
  }
  return array_of(std::move(doubles));
}

py::tuple Complex::volume(std::size_t record) const {
  Rational volume;
  {
    const ReleasedLock released;
    require_record(record);
    volume = complex_.volumes().exact(record);
  }
  return ratio_of(volume);
}

py::tuple Complex::hull_volume() const {
  Rational volume;
  {
    const ReleasedLock released;
    volume = complex_.volumes().hull();
  }
  return ratio_of(volume);
}

py::list Complex::shares(std::size_t record, bool exact) const {
  std::vector<std::pair<PointId, Rational>> shares;
  std::vector<std::pair<PointId, double>> rounded;
  {
    const ReleasedLock released;
    require_record(record);
    if (exact) shares = complex_.volumes().shares(record);
    if (!exact) rounded = complex_.volumes().rounded_shares(record);
  }
  py::list list;
  for (const auto& [row, share] : shares) list.append(py::make_tuple(row, ratio_of(share)));
  for (const auto& [row, share] : rounded) list.append(py::make_tuple(row, share));
  return list;
}

py::object Complex::lambda_list(std::size_t record, bool exact) const {
  std::optional<LambdaList> list;
  std::optional<RoundedLambdaList> rounded;
  {
    const ReleasedLock released;
    require_record(record);
    const FlowLimits& limits = complex_.limits();
    const std::optional<std::size_t> place = place_of_record(limits, record);
    if (place && exact) list = limits.list(*place);
    if (place && !exact) rounded = limits.rounded_list(*place);
  }
  if (list) return tuple_of_list(*list);
  if (rounded) return tuple_of_list(*rounded);
  return py::none();
}

py::array Complex::connections() const {
  std::vector<ConnectionRecord> records;
  {
    const ReleasedLock released;
    records = records_of_connections(complex_.limits());
  }
  return array_of(std::move(records));
}

py::object Complex::unstable_surface(std::size_t record, bool exact) const {
  std::optional<UnstableSurface<>> surface;
  {
    const ReleasedLock released;
    require_record(record);
    const UnstableSurfaces& surfaces = complex_.unstable_surfaces();
    if (const auto place = place_of_record(surfaces, record)) surface = surfaces.set(*place);
  }
  if (!surface) return py::none();
  const SurfaceTuples tuples{exact};
  return py::make_tuple(tuples.list(surface->vertices), tuples.list(surface->traces), tuples.list(surface->runs),
                        tuples.list(surface->sheets), tuples.list(surface->segments));
}

bool Complex::is_morse_smale() const {
  const ReleasedLock released;
  return flowcert::is_morse_smale(complex_.stationary(), complex_.limits(), complex_.stable());
}

}  // namespace flowcert::python
