// Rooms between balls for Python (flowcert/_pores.py).
//
// Guarantees: numbers of balls come and go exactly (numbers.h). What takes more than a moment is computed without
// Python's lock. Points are known by their places in points().
#include "pores.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "atoms.h"
#include "flowcert/ball_cavities.h"
#include "flowcert/pores.h"
#include "geometry/floating_point.h"
#include "geometry/parallel_for.h"
#include "io/viewer_page.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// x, y, z and the radius, hexadecimal.
using BallText = std::array<std::string, 4>;

std::vector<Ball> balls_of(const std::vector<BallText>& rows) {
  std::vector<Ball> balls;
  balls.reserve(rows.size());
  for (const auto& [x, y, z, radius] : rows) balls.push_back({point_of({x, y, z}), rational_of(radius)});
  return balls;
}

// (coefficients, root, nearest double, nearest double of twice the number), as Python's QuadraticNumber has them.
py::tuple tuple_of(const QuadraticNumber& number) {
  const auto [texts, root] = primitive_polynomial(number);
  py::list coefficients;
  for (const std::string& text : texts) coefficients.append(ratio_of(Rational(text))[0]);
  return py::make_tuple(py::tuple(coefficients), root, nearest_or_infinity(number),
                        nearest_or_infinity(QuadraticNumber(Rational(2)) * number));
}

// A critical point in the array of all of them. NumPy reads it as it is.
struct BallPointRecord {
  std::int8_t index = 0;
  std::int64_t rank = 0;
  double value = 0;
  std::array<double, 3> center{};
  std::array<std::int64_t, 2> contact_offsets{};
};

class BallPores {
 public:
  BallPores(std::vector<Ball> balls, const Rational& depth, unsigned threads)
      : balls_(std::move(balls)), threads_(threads), depth_(depth), pores_(balls_, depth, threads) {}

  [[nodiscard]] std::size_t ball_count() const { return balls_.size(); }
  [[nodiscard]] std::size_t point_count() const { return pores_.points().size(); }

  [[nodiscard]] py::array hidden() const {
    std::vector<std::int64_t> ids;
    for (std::uint32_t id = 0; id < balls_.size(); ++id) {
      if (!std::ranges::binary_search(balls_.visible(), id)) ids.push_back(id);
    }
    return array_of(std::move(ids));
  }

  // The array of BallPointRecord, and that of all contacts, one point after the other.
  [[nodiscard]] py::tuple points() const {
    const std::vector<BallPoint>& points = pores_.points();
    std::vector<BallPointRecord> records(points.size());
    std::vector<std::int64_t> contacts;
    {
      const ReleasedLock released;
      geometry::parallel_for(points.size(), threads_, [&](std::size_t k) { records[k] = record_of(k); });
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto first = static_cast<std::int64_t>(contacts.size());
        contacts.insert(contacts.end(), points[k].contact.begin(), points[k].contact.end());
        records[k].contact_offsets = {first, static_cast<std::int64_t>(contacts.size())};
      }
    }
    return py::make_tuple(shared(array_of(std::move(records))), shared(array_of(std::move(contacts))));
  }

  // Of a point that there is.
  [[nodiscard]] py::tuple value(std::uint32_t point) const { return tuple_of(pores_.value(point)); }
  [[nodiscard]] py::tuple center(std::uint32_t point) const {
    const auto [x, y, z] = pores_.center(point);
    return py::make_tuple(tuple_of(x), tuple_of(y), tuple_of(z));
  }

  // [(peaks, gates, windows, handles, exit), ...]
  [[nodiscard]] py::list chambers() const {
    py::list chambers;
    for (const auto& [peaks, gates, exit, windows, handles] : pores_.chambers()) {
      chambers.append(py::make_tuple(places_of(peaks), places_of(gates), places_of(windows), places_of(handles), exit));
    }
    return chambers;
  }

  // The nearest double. A gate below 0 counts as 0 (FC-BALL-05).
  [[nodiscard]] double depth(std::size_t number) const {
    const Chamber& chamber = pores_.chambers()[number];
    const QuadraticNumber gate = chamber.gates.empty() ? QuadraticNumber() : pores_.value(chamber.gates[0]);
    return nearest_difference(pores_.value(chamber.peaks[0]), gate);
  }

  // [(point, rooms), ...]
  [[nodiscard]] py::list windows() const {
    py::list windows;
    for (const PoreWindow& window : pores_.windows()) {
      std::vector<std::int64_t> rooms(window.rooms.begin(), window.rooms.end());
      std::ranges::replace(rooms, std::int64_t{Pores::kOutside}, std::int64_t{-1});
      windows.append(py::make_tuple(window.point, py::tuple(py::cast(rooms))));
    }
    return windows;
  }

  [[nodiscard]] py::list vestibules() const {
    py::list vestibules;
    for (const auto& peaks : pores_.vestibules()) vestibules.append(places_of(peaks));
    return vestibules;
  }

  // Rows of a gate and a peak. A gate below 0 is -1.
  [[nodiscard]] py::array cavities() const {
    std::vector<std::array<std::int64_t, 2>> rows;
    for (const auto& [gate, peak] : pores_.cavities()) rows.push_back({gate ? std::int64_t{*gate} : -1, peak});
    return rows_of<std::int64_t>(std::move(rows));
  }

  [[nodiscard]] std::size_t cavities_at(const std::string& probe) const {
    const ReleasedLock released;
    return pores_.cavities_at(rational_of(probe));
  }

  // [(point, count), ...]
  [[nodiscard]] py::list cavity_steps() const {
    py::list steps;
    for (const auto& [point, count] : pores_.cavity_steps()) steps.append(py::make_tuple(point, count));
    return steps;
  }

  // The page of HTML that `flowcert view --radii` writes. centres: the doubles nearest to those of the balls.
  [[nodiscard]] py::bytes page(const std::string& name, const PointRows& centres, const std::vector<AtomTexts>& atoms,
                               const std::optional<std::string>& probe) const {
    std::ostringstream out;
    const std::span<const Point> rows = points_of(centres);
    {
      const ReleasedLock released;
      const AtomNames names = atom_names(atoms, balls_.size());
      const std::optional<Rational> radius = probe ? std::optional(rational_of(*probe)) : std::nullopt;
      write_viewer_page(out, name, rows, {pores_, depth_, radius, names.empty() ? nullptr : &names, "as given"});
    }
    return py::bytes(std::move(out).str());
  }

 private:
  [[nodiscard]] BallPointRecord record_of(std::size_t place) const {
    const auto point = static_cast<std::uint32_t>(place);
    const auto [x, y, z] = pores_.center(point);
    return {.index = static_cast<std::int8_t>(pores_.points()[place].index),
            .rank = pores_.points()[place].rank,
            .value = nearest_or_infinity(pores_.value(point)),
            .center = {nearest_or_infinity(x), nearest_or_infinity(y), nearest_or_infinity(z)}};
  }

  BallSet balls_;
  unsigned threads_;
  Rational depth_;
  Pores pores_;
};

// [lining, ...]
py::list cavities_between(const std::vector<BallText>& rows, const std::string& probe) {
  std::vector<BallCavity> cavities;
  {
    const ReleasedLock released;
    cavities = ball_cavities(BallSet(balls_of(rows)), rational_of(probe));
  }
  py::list linings;
  for (const BallCavity& cavity : cavities) linings.append(places_of(cavity.lining));
  return linings;
}

}  // namespace

void add_pores(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(BallPointRecord, index, rank, value, center, contact_offsets);
  const py::call_guard<geometry::IeeeDoubles> ieee;
  py::class_<BallPores>(module, "Pores", "What flowcert.Pores asks.")
      .def(py::init([](const std::vector<BallText>& rows, const std::string& depth, unsigned threads) {
             const ReleasedLock released;
             const unsigned cores = threads == 0 ? geometry::all_cores() : threads;
             return std::make_unique<BallPores>(balls_of(rows), rational_of(depth), cores);
           }),
           py::arg("rows"), py::arg("depth"), py::arg("threads"), ieee)
      .def_property_readonly("ball_count", &BallPores::ball_count)
      .def_property_readonly("point_count", &BallPores::point_count)
      .def("hidden", &BallPores::hidden, ieee)
      .def("points", &BallPores::points, ieee)
      .def("value", &BallPores::value, py::arg("point"), ieee)
      .def("center", &BallPores::center, py::arg("point"), ieee)
      .def("chambers", &BallPores::chambers, ieee)
      .def("depth", &BallPores::depth, py::arg("chamber"), ieee)
      .def("windows", &BallPores::windows, ieee)
      .def("vestibules", &BallPores::vestibules, ieee)
      .def("cavities", &BallPores::cavities, ieee)
      .def("cavities_at", &BallPores::cavities_at, py::arg("probe"), ieee)
      .def("cavity_steps", &BallPores::cavity_steps, ieee)
      .def("page", &BallPores::page, py::arg("name"), py::arg("centres"), py::arg("atoms"), py::arg("probe"), ieee);
  module.def("ball_cavities", cavities_between, py::arg("rows"), py::arg("probe"), ieee,
             "What FlowComplex.pockets asks where atoms have radii.");
}

}  // namespace flowcert::python
