// Cycles for Python: loops with their surfaces, voids, and components that come together.
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.h"
#include "complex.h"
#include "flowcert/loop_classes.h"
#include "flowcert/surface.h"
#include "flowcert/voids.h"
#include "io/cycle_exports.h"
#include "io/cycles.h"
#include "io/number_text.h"
#include "numbers.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

CycleChoice choice_of(int dimension, std::size_t longest, const std::optional<std::string>& persistence,
                      const std::optional<PairName>& pair, const std::string& level) {
  CycleChoice choice;
  choice.dimension = dimension;
  choice.longest = longest;
  choice.level = cycle_level_of(level, "level");
  if (persistence) choice.longer_than = io::length_bound_of(*persistence, "persistence", 1);
  choice.pair = pair;
  return choice;
}

// What is made of a cycle without Python's lock.
struct CycleParts {
  CellSurface surface;
  std::vector<std::array<std::int64_t, 2>> edges;  // of dimension 1
  double measure = 0;                              // the loop's length, or the void's volume
};

std::vector<CycleParts> parts_of(const FlowComplex& complex, const std::vector<Cycle>& found, int dimension) {
  std::vector<CycleParts> parts(found.size());
  std::vector<CellSurface> voids;
  if (dimension == 2) voids = void_surfaces(complex, found);
  for (std::size_t k = 0; k < found.size(); ++k) {
    stop_if_interrupted();
    if (const auto* const loop = std::get_if<LoopCycle>(&found[k].chain)) {
      SurfaceMesh mesh = loop_surface_mesh(complex, loop->surface);
      parts[k].surface = {std::move(mesh.vertices), std::move(mesh.triangles)};
      parts[k].measure = loop_length(complex, *loop);
      for (const std::uint32_t edge : loop->edges) {
        const auto ends = complex.stationary().contact(edge);
        parts[k].edges.push_back({static_cast<std::int64_t>(ends[0]), static_cast<std::int64_t>(ends[1])});
      }
    }
    if (const auto* const space = std::get_if<Void>(&found[k].chain)) {
      parts[k].surface = std::move(voids[k]);
      parts[k].measure = complex.volumes().nearest_sum(space->cell);
    }
  }
  return parts;
}

template <class Number>
py::array integers_of(const std::vector<Number>& numbers) {
  return array_of(std::vector<std::int64_t>(numbers.begin(), numbers.end()));
}

py::tuple mesh_of(CellSurface surface) {
  return py::make_tuple(rows_of<double>(std::move(surface.vertices)),
                        rows_of<std::int32_t>(std::move(surface.triangles)));
}

py::tuple chain_of(const LoopCycle& loop, CycleParts parts, const StationaryPoints&) {
  py::list polygons;
  for (const LoopPolygon& polygon : loop.polygons) polygons.append(integers_of(polygon));
  return py::make_tuple(polygons, rows_of<std::int64_t>(std::move(parts.edges)), integers_of(loop.surface),
                        mesh_of(std::move(parts.surface)), parts.measure);
}

py::tuple chain_of(const Void& space, CycleParts parts, const StationaryPoints&) {
  return py::make_tuple(integers_of(space.maxima), integers_of(space.cell), integers_of(space.walls),
                        mesh_of(std::move(parts.surface)), parts.measure);
}

py::tuple chain_of(const JoinedComponents& joined, CycleParts, const StationaryPoints& stationary) {
  py::list components;
  for (const std::vector<std::uint32_t>& component : joined) {
    std::vector<std::int64_t> rows;
    for (const std::uint32_t sample : component) rows.push_back(stationary.contact(sample).front());
    components.append(array_of(std::move(rows)));
  }
  return py::tuple(components);
}

}  // namespace

py::list Complex::cycles(int dimension, std::size_t longest, const std::optional<std::string>& persistence,
                         const std::optional<PairName>& pair, const std::string& level) const {
  std::vector<Cycle> found;
  std::vector<CycleParts> parts;
  {
    const ReleasedLock released;
    found = flowcert::cycles(complex_, choice_of(dimension, longest, persistence, pair, level),
                             [](std::size_t, std::size_t) { stop_if_interrupted(); });
    parts = parts_of(complex_, found, dimension);
  }
  py::list list;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto& [ends, level, chain] = found[k];
    py::object shown = level ? py::object(ratio_of(level->exact())) : py::none();
    const auto made =
        std::visit([&](const auto& one) { return chain_of(one, std::move(parts[k]), complex_.stationary()); }, chain);
    list.append(py::make_tuple(py::make_tuple(ends.birth, *ends.death), shown, made));
  }
  return list;
}

namespace {

void require_rows(const std::vector<SampleEdge>& loop, const PointSet& points) {
  for (const SampleEdge& edge : loop) {
    const PointId row = std::max(edge[0], edge[1]);
    if (row >= points.row_count()) {
      throw InvalidInput("there is no point " + std::to_string(row) + "; there are " +
                         std::to_string(points.row_count()));
    }
  }
}

}  // namespace

bool Complex::represents(const std::vector<LoopEdges>& loops, std::uint32_t birth, std::uint32_t death,
                         const std::optional<std::string>& squared_level) const {
  const ReleasedLock released;
  for (const std::uint32_t record : {birth, death}) require_record(record);
  for (const LoopEdges& loop : loops) require_rows(loop, complex_.points());
  const StationaryPoints& stationary = complex_.stationary();
  if (stationary.index(birth) != StationaryIndex{1, 1} || stationary.index(death) != StationaryIndex{2, 2}) {
    throw InvalidInput("pair: not a critical point of index 1 and one of index 2");
  }
  const SquaredDistances& values = complex_.persistence().squared_distances();
  const SquaredLevel level =
      squared_level ? SquaredLevel(rational_of(*squared_level)) : SquaredLevel(values, birth, birth, 0);
  if (values.compare(birth, level) > 0 || values.compare(death, level) <= 0) {
    throw InvalidInput("squared_level: not from the birth on, and before the death");
  }
  return LoopClasses(complex_).represent(loops, {1, birth, death}, level);
}

bool Complex::homologous(const LoopEdges& loop, const LoopEdges& other, const std::string& squared_level) const {
  const ReleasedLock released;
  for (const LoopEdges* one : {&loop, &other}) require_rows(*one, complex_.points());
  return LoopClasses(complex_).are_homologous(loop, other, rational_of(squared_level));
}

}  // namespace flowcert::python
