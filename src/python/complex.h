// The flow complex as Python holds it: what flowcert.FlowComplex asks for.
//
// Guarantees: everything that takes time is computed without Python's lock, and Ctrl-C stops it (released_lock.h).
// Arrays of stationary points are made once. Places in their list are the ids of stationary points everywhere.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "arrays.h"
#include "atoms.h"
#include "flowcert/flow_complex.h"
#include "flowcert/loop_classes.h"

namespace flowcert::python {

// A stationary point in the array of all of them. NumPy reads it as it is.
struct StationaryRecord {
  std::int8_t index = 0;  // -1: regular
  std::array<std::int8_t, 2> kind{};
  std::array<double, 3> center{};
  double squared_distance = 0;
  std::array<std::int64_t, 2> contact_offsets{};
};

// A persistence pair in the array of them. Points are places in the list; -1: none.
struct PairRecord {
  std::int8_t dimension = 0;
  double birth = 0;
  double death = 0;
  std::int64_t birth_point = 0;
  std::int64_t death_point = 0;
};

// What leads from one stationary point to another one, in the array of all that does. Points are places in the list.
struct ConnectionRecord {
  std::int64_t from = 0;
  std::int64_t to = 0;  // -1: infinity
  std::int64_t orbits = 0;
  std::int64_t families = 0;
};

class Complex {
 public:
  // Takes a copy of the points, and computes nothing yet. 0 threads: as many as the machine has cores. Unlimited: with
  // any number of Delaunay cells (usual_most_cells).
  Complex(const PointRows& rows, unsigned threads, bool unlimited);

  [[nodiscard]] const FlowComplex& flow_complex() const { return complex_; }
  [[nodiscard]] std::size_t row_count() const { return complex_.points().row_count(); }
  [[nodiscard]] std::size_t merged_duplicates() const { return complex_.points().merged_duplicates(); }
  [[nodiscard]] unsigned threads() const { return complex_.threads(); }
  // As they were given, with 0.0 for -0.0.
  [[nodiscard]] pybind11::array points() const;

  [[nodiscard]] std::array<std::size_t, 4> critical_counts() const;
  // Regular stationary points of the kinds 1-2, 1-3 and 2-3.
  [[nodiscard]] std::array<std::size_t, 3> regular_counts() const;
  [[nodiscard]] long long euler_sum() const;
  // The array of StationaryRecord, and that of all contact sets, one after the other.
  [[nodiscard]] pybind11::tuple stationary_points() const;
  // (center, squared distance), of pairs of ints.
  [[nodiscard]] pybind11::tuple exact(std::size_t record) const;

  // [(dimension, (birth, death)), ...]
  [[nodiscard]] pybind11::list persistence(bool with_zero, bool is_squared) const;
  [[nodiscard]] pybind11::array pairs(bool with_zero, bool is_squared) const;

  // vertices, triangles, the stationary point of each triangle, the squared distance at each vertex
  [[nodiscard]] pybind11::tuple surface(const std::vector<std::string>& selection) const;
  // vertices, where each line begins, the saddle of each line, its limits, the squared distance at each vertex
  [[nodiscard]] pybind11::tuple unstable_lines() const;
  // (segments, limit)
  [[nodiscard]] pybind11::tuple orbit(const std::array<std::string, 3>& start) const;

  // The nearest doubles, for all stationary points.
  [[nodiscard]] pybind11::array volumes() const;
  // Pairs of ints.
  [[nodiscard]] pybind11::tuple volume(std::size_t record) const;
  [[nodiscard]] pybind11::tuple hull_volume() const;
  // [(row, pair of ints), ...]
  [[nodiscard]] pybind11::list shares(std::size_t record, bool exact) const;
  // ([(limit, exit, is_vector), ...], [limit, ...]); limits are places or None. An exit is three pairs of ints, or
  // three doubles. None if the point has no such list.
  [[nodiscard]] pybind11::object lambda_list(std::size_t record, bool exact) const;
  [[nodiscard]] pybind11::array connections() const;
  // (vertices, traces, runs, sheets, segments), lists. A position is three pairs of ints, or three doubles. A corner is
  // (position, is_vector). A trace or run is (polygon, (corner, corner)), a sheet (samples, corners), a segment
  // (samples, start, corner). None if the point has no such set.
  [[nodiscard]] pybind11::object unstable_surface(std::size_t record, bool exact) const;
  [[nodiscard]] bool is_morse_smale() const;

  // [(pair, squared_level, chain), ...], the longest pair first (flowcert/_cycles.py). A pair is two places. persistence
  // and level are as commands take them; a pair is named by its contact sets.
  [[nodiscard]] pybind11::list cycles(int dimension, std::size_t longest, const std::optional<std::string>& persistence,
                                      const std::optional<std::array<std::vector<PointId>, 2>>& pair,
                                      const std::string& level) const;

  // Loops are edges of two rows each. Numbers are hexadecimal; without a level it is that of the birth.
  using LoopEdges = std::vector<SampleEdge>;
  [[nodiscard]] bool represents(const std::vector<LoopEdges>& loops, std::uint32_t birth, std::uint32_t death,
                                const std::optional<std::string>& squared_level) const;
  [[nodiscard]] bool homologous(const LoopEdges& loop, const LoopEdges& other, const std::string& squared_level) const;

  // (pockets, outside, gates, largest_balls, squared_persistence), as Pockets has them (flowcert/_pockets.py).
  // persistence is a bound as commands take it, and the probe hexadecimal.
  [[nodiscard]] pybind11::tuple pockets(const std::string& persistence, const std::optional<std::string>& probe) const;
  // (limits, nearest, tied), arrays. -1 is infinity.
  [[nodiscard]] pybind11::tuple locate(const PointRows& rows) const;

  // The data of the file of `compute --export` with this name (flowcert/_exports.py). The selection is that of surface,
  // for stable_surfaces; clip is hexadecimal, and without it nothing is cut.
  [[nodiscard]] pybind11::tuple exported(const std::string& name, const std::vector<std::string>& selection,
                                         const std::optional<std::string>& clip) const;
  // The page of HTML that `flowcert view` writes. Atoms are their names, row by row, or none; pockets is a bound as
  // commands take it.
  [[nodiscard]] pybind11::bytes page(const std::string& name, const std::vector<AtomTexts>& atoms, std::size_t most,
                                     bool has_cells, const std::optional<std::string>& pockets) const;

 private:
  // Throws InvalidInput if there is no such stationary point.
  void require_record(std::size_t record) const;

  FlowComplex complex_;
};

void add_complex(pybind11::module_& module);

}  // namespace flowcert::python
