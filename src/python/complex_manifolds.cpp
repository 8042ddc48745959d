// Stable surfaces and unstable lines as arrays of vertices, and of what is made of them.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "complex.h"
#include "flowcert/surface.h"
#include "geometry/parallel_for.h"
#include "released_lock.h"

namespace flowcert::python {

namespace py = pybind11;

namespace {

// ---- Surfaces ----

std::vector<double> distances_of(const SurfaceMesh& mesh) {
  std::vector<double> distances;
  distances.reserve(mesh.squared_distances.size());
  for (const std::optional<double>& value : mesh.squared_distances) distances.push_back(value.value_or(HUGE_VAL));
  return distances;
}

std::vector<std::int64_t> saddles_of(const FlowComplex& complex, const SurfaceMesh& mesh) {
  std::vector<std::int64_t> saddles;
  saddles.reserve(mesh.set_of_triangle.size());
  for (const std::size_t set : mesh.set_of_triangle) {
    saddles.push_back(static_cast<std::int64_t>(complex.stable().record(set)));
  }
  return saddles;
}

// ---- Lines ----

struct Lines {
  std::vector<Point> vertices;
  std::vector<std::int64_t> offsets{0};
  std::vector<std::int64_t> saddles;
  std::vector<std::int64_t> limits;  // -1: infinity
  std::vector<double> squared_distances;

  void append(std::size_t saddle, std::optional<std::size_t> limit, const std::vector<RoundedSphere>& orbit) {
    for (const auto& [position, squared_distance] : orbit) {
      if (!position.is_finite()) {
        throw InvalidInput("a coordinate is beyond the largest double");
      }
      vertices.push_back(position);
      squared_distances.push_back(squared_distance);
    }
    offsets.push_back(static_cast<std::int64_t>(vertices.size()));
    saddles.push_back(static_cast<std::int64_t>(saddle));
    limits.push_back(limit ? static_cast<std::int64_t>(*limit) : -1);
  }
};

// All lines of U2, those of side 0 before those of side 1 for each saddle. A thread makes the orbits of some saddles,
// and each is then appended in its turn.
Lines lines_of(const FlowComplex& complex) {
  const UnstableManifolds& u2 = complex.unstable();
  const std::size_t at_a_time = 64 * std::size_t{complex.threads()};
  std::vector<std::array<std::vector<RoundedSphere>, 2>> orbits(at_a_time);
  Lines lines;
  for (std::size_t first = 0; first < u2.size(); first += at_a_time) {
    stop_if_interrupted();
    const std::size_t count = std::min(at_a_time, u2.size() - first);
    geometry::parallel_for(count, complex.threads(), [&](std::size_t k) {
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
        orbits[k].at(side) = u2.rounded_orbit(first + k, side);
    });
    for (std::size_t k = 0; k < count; ++k) {
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        lines.append(u2.saddle(first + k), u2.limit(first + k, side), orbits[k].at(side));
      }
    }
  }
  return lines;
}

}  // namespace

py::tuple Complex::surface(const std::vector<std::string>& selection) const {
  SurfaceMesh mesh;
  std::vector<std::int64_t> saddles;
  std::vector<double> squared_distances;
  {
    const ReleasedLock released;
    const auto progress = [](std::size_t, std::size_t) { stop_if_interrupted(); };
    mesh = surface_mesh(complex_, selected_sets(complex_, selection), progress);
    saddles = saddles_of(complex_, mesh);
    squared_distances = distances_of(mesh);
  }
  return py::make_tuple(rows_of<double>(std::move(mesh.vertices)), rows_of<std::int32_t>(std::move(mesh.triangles)),
                        array_of(std::move(saddles)), array_of(std::move(squared_distances)));
}

py::tuple Complex::unstable_lines() const {
  Lines lines;
  {
    const ReleasedLock released;
    lines = lines_of(complex_);
  }
  return py::make_tuple(rows_of<double>(std::move(lines.vertices)), array_of(std::move(lines.offsets)),
                        array_of(std::move(lines.saddles)), array_of(std::move(lines.limits)),
                        array_of(std::move(lines.squared_distances)));
}

}  // namespace flowcert::python
