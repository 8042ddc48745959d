// Stationary points, orbits, and what the class has for Python.
#include "complex.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "geometry/floating_point.h"
#include "geometry/parallel_for.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// How many records a thread rounds before it takes others.
constexpr std::size_t kRecords = 512;

FlowOptions options_for(std::size_t points, unsigned threads, bool unlimited) {
  return {.threads = threads == 0 ? geometry::all_cores() : threads,
          .most_cells = unlimited ? kAnyNumberOfCells : usual_most_cells(points)};
}

StationaryRecord record_of(StationaryIndex index, const RoundedSphere& sphere) {
  const auto face = static_cast<std::int8_t>(index.face_dimension);
  return {.index = index.is_critical() ? face : std::int8_t{-1},
          .kind = {face, static_cast<std::int8_t>(index.hull_dimension)},
          .center = sphere.center.coordinates(),
          .squared_distance = sphere.squared_radius};
}

std::vector<StationaryRecord> records_of(const FlowComplex& complex) {
  const StationaryPoints& stationary = complex.stationary();
  std::vector<StationaryRecord> records(stationary.size());
  geometry::parallel_for((records.size() + kRecords - 1) / kRecords, complex.threads(), [&](std::size_t part) {
    stop_if_interrupted();
    const std::size_t last = std::min((part + 1) * kRecords, records.size());
    for (std::size_t record = part * kRecords; record < last; ++record) {
      records[record] = record_of(stationary.index(record), complex.rounded_sphere(record));
    }
  });
  std::int64_t end = 0;
  for (std::size_t record = 0; record < records.size(); ++record) {
    const std::int64_t first = end;
    end += static_cast<std::int64_t>(stationary.contact(record).size());
    records[record].contact_offsets = {first, end};
  }
  return records;
}

std::vector<std::int64_t> contacts_of(const StationaryPoints& stationary) {
  std::vector<std::int64_t> contacts;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    const auto contact = stationary.contact(record);
    contacts.insert(contacts.end(), contact.begin(), contact.end());
  }
  return contacts;
}

// ---- Orbits ----

py::tuple kind_of(StationaryIndex index) { return py::make_tuple(index.face_dimension, index.hull_dimension); }

py::object position_or_none(const std::optional<RationalPoint>& position) {
  return position ? py::object(ratios_of(*position)) : py::none();
}

py::tuple segment_of(const FlowSegment& segment) {
  return py::make_tuple(type_text(segment.type), ratios_of(segment.start), ratios_of(segment.driver),
                        position_or_none(segment.end), segment.start_contact, segment.crossed_contact,
                        segment.end_contact);
}

py::object limit_of(const PointSet& points, const std::optional<StationaryLimit>& limit) {
  if (!limit) return py::none();
  const Rational squared_distance = exact_squared_radius(points, limit->contact);
  return py::make_tuple(kind_of(limit->index), ratios_of(limit->position), ratio_of(squared_distance), limit->contact);
}

}  // namespace

// ---- The class ----

Complex::Complex(const PointRows& rows, unsigned threads, bool unlimited)
    : complex_(
          [&rows] {
            const auto points = points_of(rows);
            const ReleasedLock released;
            return PointSet(points);
          }(),
          options_for(static_cast<std::size_t>(rows.shape(0)), threads, unlimited),
          [](FlowComplexPart, std::size_t, std::size_t) { stop_if_interrupted(); }) {}

py::array Complex::points() const {
  const PointSet& points = complex_.points();
  std::vector<Point> rows(points.row_count());
  for (PointId row = 0; row < rows.size(); ++row) rows[row] = points.at_row(row);
  return rows_of<double>(std::move(rows));
}

std::array<std::size_t, 4> Complex::critical_counts() const {
  const ReleasedLock released;
  return complex_.stationary().critical_counts();
}

std::array<std::size_t, 3> Complex::regular_counts() const {
  const ReleasedLock released;
  const RegularCounts& counts = complex_.stationary().regular_counts();
  return {counts.kind12, counts.kind13, counts.kind23};
}

long long Complex::euler_sum() const {
  const ReleasedLock released;
  return complex_.stationary().euler_sum();
}

py::tuple Complex::stationary_points() const {
  std::vector<StationaryRecord> records;
  std::vector<std::int64_t> contacts;
  {
    const ReleasedLock released;
    records = records_of(complex_);
    contacts = contacts_of(complex_.stationary());
  }
  return py::make_tuple(shared(array_of(std::move(records))), shared(array_of(std::move(contacts))));
}

void Complex::require_record(std::size_t record) const {
  const std::size_t count = complex_.stationary().size();
  if (record < count) return;
  throw InvalidInput("there is no stationary point " + std::to_string(record) + "; there are " + std::to_string(count));
}

py::tuple Complex::exact(std::size_t record) const {
  ExactSphere sphere;
  {
    const ReleasedLock released;
    require_record(record);
    sphere = complex_.sphere(record);
  }
  return py::make_tuple(ratios_of(sphere.center), ratio_of(sphere.squared_radius));
}

py::tuple Complex::orbit(const std::array<std::string, 3>& start) const {
  const RationalPoint from = point_of(start);
  Orbit orbit;
  {
    const ReleasedLock released;
    if (complex_.points().empty()) throw InvalidInput("there are no points");
    orbit = complex_.orbit(from);
  }
  py::list segments;
  for (const FlowSegment& segment : orbit.segments) segments.append(segment_of(segment));
  return py::make_tuple(segments, limit_of(complex_.points(), orbit.limit));
}

void add_complex(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(StationaryRecord, index, kind, center, squared_distance, contact_offsets);
  PYBIND11_NUMPY_DTYPE(PairRecord, dimension, birth, death, birth_point, death_point);
  PYBIND11_NUMPY_DTYPE(ConnectionRecord, from, to, orbits, families);
  // Whatever modes another library has set for doubles, each call has the usual ones.
  const py::call_guard<geometry::IeeeDoubles> ieee;
  py::class_<Complex>(module, "Complex", "What FlowComplex asks; see flowcert.FlowComplex.")
      .def(py::init<const PointRows&, unsigned, bool>(), py::arg("rows"), py::arg("threads"), py::arg("unlimited"),
           ieee)
      .def_property_readonly("row_count", &Complex::row_count)
      .def_property_readonly("merged_duplicates", &Complex::merged_duplicates)
      .def_property_readonly("threads", &Complex::threads)
      .def("points", &Complex::points, ieee)
      .def("critical_counts", &Complex::critical_counts, ieee)
      .def("regular_counts", &Complex::regular_counts, ieee)
      .def("euler_sum", &Complex::euler_sum, ieee)
      .def("stationary_points", &Complex::stationary_points, ieee)
      .def("exact", &Complex::exact, py::arg("record"), ieee)
      .def("persistence", &Complex::persistence, py::arg("with_zero"), py::arg("is_squared"), ieee)
      .def("pairs", &Complex::pairs, py::arg("with_zero"), py::arg("is_squared"), ieee)
      .def("surface", &Complex::surface, py::arg("selection"), ieee)
      .def("unstable_lines", &Complex::unstable_lines, ieee)
      .def("orbit", &Complex::orbit, py::arg("start"), ieee)
      .def("volumes", &Complex::volumes, ieee)
      .def("volume", &Complex::volume, py::arg("record"), ieee)
      .def("hull_volume", &Complex::hull_volume, ieee)
      .def("shares", &Complex::shares, py::arg("record"), py::arg("exact"), ieee)
      .def("lambda_list", &Complex::lambda_list, py::arg("record"), py::arg("exact"), ieee)
      .def("connections", &Complex::connections, ieee)
      .def("unstable_surface", &Complex::unstable_surface, py::arg("record"), py::arg("exact"), ieee)
      .def("is_morse_smale", &Complex::is_morse_smale, ieee)
      .def("represents", &Complex::represents, py::arg("loops"), py::arg("birth"), py::arg("death"),
           py::arg("squared_level"), ieee)
      .def("homologous", &Complex::homologous, py::arg("loop"), py::arg("other"), py::arg("squared_level"), ieee)
      .def("cycles", &Complex::cycles, py::arg("dimension"), py::arg("longest"), py::arg("persistence"),
           py::arg("pair"), py::arg("level"), ieee)
      .def("pockets", &Complex::pockets, py::arg("persistence"), py::arg("probe"), ieee)
      .def("locate", &Complex::locate, py::arg("rows"), ieee)
      .def("exported", &Complex::exported, py::arg("name"), py::arg("selection"), py::arg("clip"), ieee)
      .def("page", &Complex::page, py::arg("name"), py::arg("atoms"), py::arg("most"), py::arg("cells"),
           py::arg("pockets"), ieee);
}

}  // namespace flowcert::python
