// Persistence pairs as GUDHI's Python has them. The list of a scan has a hundred thousand tuples, so it is made by
// Python's own functions.
#include <algorithm>
#include <cmath>
#include <optional>

#include "complex.h"
#include "flowcert/write_persistence.h"
#include "geometry/difference_of_roots.h"
#include "geometry/parallel_for.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// How many records a thread rounds before it takes others.
constexpr std::size_t kRecords = 512;
constexpr double kLasts = HUGE_VAL;

std::vector<double> squared_distances_of(const FlowComplex& complex, unsigned threads) {
  const PointSet& points = complex.points();
  const StationaryPoints& stationary = complex.stationary();
  std::vector<double> distances(stationary.size());
  geometry::parallel_for((distances.size() + kRecords - 1) / kRecords, threads, [&](std::size_t part) {
    stop_if_interrupted();
    const std::size_t last = std::min((part + 1) * kRecords, distances.size());
    for (std::size_t record = part * kRecords; record < last; ++record) {
      distances[record] =
          rounded_squared_radius(points, stationary.contact(record), stationary.index(record).hull_dimension);
    }
  });
  return distances;
}

// One thread makes the pairs. Meanwhile another one can round.
std::vector<double> squared_distances_beside_pairs(const FlowComplex& complex) {
  complex.make(FlowComplexPart::kLinks);
  std::vector<double> distances;
  geometry::parallel_for(2, complex.threads(), [&](std::size_t task) {
    if (task == 0) {
      complex.make(FlowComplexPart::kPersistence);
    } else {
      distances = squared_distances_of(complex, 1);
    }
  });
  return distances;
}

// The roots of the exact squares.
std::vector<double> plain_distances_of(const FlowComplex& complex) {
  complex.make(FlowComplexPart::kPersistence);
  std::vector<double> distances(complex.stationary().size());
  geometry::parallel_for((distances.size() + kRecords - 1) / kRecords, complex.threads(), [&](std::size_t part) {
    stop_if_interrupted();
    const std::size_t last = std::min((part + 1) * kRecords, distances.size());
    for (std::size_t record = part * kRecords; record < last; ++record) {
      const Rational square = exact_squared_radius(complex.points(), complex.stationary().contact(record));
      distances[record] = geometry::nearest_difference_of_roots(square, 0);
    }
  });
  return distances;
}

std::vector<PairRecord> pairs_of(const FlowComplex& complex, bool with_zero, bool is_squared) {
  const ReleasedLock released;
  const std::vector<double> distances =
      is_squared ? squared_distances_beside_pairs(complex) : plain_distances_of(complex);
  const auto distance_at = [&](std::size_t record) {
    if (distances[record] == HUGE_VAL) {
      throw InvalidInput("a squared distance is beyond the largest double; exact() has it");
    }
    return distances[record];
  };
  const PersistenceDiagram diagram(complex, with_zero);
  std::vector<PairRecord> records;
  records.reserve(diagram.pairs().size());
  for (const auto& [dimension, birth, death] : diagram.pairs()) {
    records.push_back({.dimension = static_cast<std::int8_t>(dimension),
                       .birth = distance_at(birth),
                       .death = death ? distance_at(*death) : kLasts,
                       .birth_point = static_cast<std::int64_t>(birth),
                       .death_point = death ? static_cast<std::int64_t>(*death) : -1});
  }
  return records;
}

// ---- Tuples ----

py::object owned(PyObject* object) {
  if (object == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(object);
}

// Tuples of numbers alone are no part of a cycle. Python would find that out by itself, one collection later.
PyObject* tuple_of(py::object first, py::object second) {
  PyObject* const tuple = PyTuple_New(2);
  if (tuple == nullptr) throw py::error_already_set();
  PyTuple_SET_ITEM(tuple, 0, first.release().ptr());
  PyTuple_SET_ITEM(tuple, 1, second.release().ptr());
  PyObject_GC_UnTrack(tuple);
  return tuple;
}

// Numbers one after the other, of which equal ones are one object: all births of dimension 0 are.
class Numbers {
 public:
  [[nodiscard]] py::object of(double value) {
    if (!last_ || value != value_) {
      last_ = owned(PyFloat_FromDouble(value));
      value_ = value;
    }
    return last_;
  }

 private:
  py::object last_;
  double value_ = 0;
};

}  // namespace

py::list Complex::persistence(bool with_zero, bool is_squared) const {
  const std::vector<PairRecord> pairs = pairs_of(complex_, with_zero, is_squared);
  const py::object dimensions[] = {py::int_(0), py::int_(1), py::int_(2)};
  Numbers births, deaths;
  py::list list(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& [dimension, birth, death, birth_point, death_point] = pairs[k];
    py::object interval = owned(tuple_of(births.of(birth), deaths.of(death)));
    PyObject* const pair = tuple_of(dimensions[dimension], std::move(interval));
    PyList_SET_ITEM(list.ptr(), static_cast<py::ssize_t>(k), pair);
  }
  return list;
}

py::array Complex::pairs(bool with_zero, bool is_squared) const {
  return array_of(pairs_of(complex_, with_zero, is_squared));
}

}  // namespace flowcert::python
