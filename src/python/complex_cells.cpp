// The whole complex for Python: volumes of stable sets, where the directions of stationary points lead, connections.
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "complex.h"
#include "flowcert/connections.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// The place of a stationary point's list among all lists, which come in the order of the points.
std::optional<std::size_t> list_of_record(const FlowLimits& limits, std::size_t record) {
  std::size_t first = 0, last = limits.size();
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    if (limits.record(middle) < record) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return first < limits.size() && limits.record(first) == record ? std::optional(first) : std::nullopt;
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
    const std::optional<std::size_t> place = list_of_record(limits, record);
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

bool Complex::is_morse_smale() const {
  const ReleasedLock released;
  return flowcert::is_morse_smale(complex_.stationary(), complex_.limits(), complex_.stable());
}

}  // namespace flowcert::python
