#include "io/cycle_exports.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "geometry/floating_point.h"
#include "io/layer.h"
#include "io/number_text.h"
#include "io/region_exports.h"

namespace flowcert {

using namespace io;

namespace {

// The number of the pair of each cell, and its values.
void append_pairs(std::vector<VtpArray>& arrays, const std::vector<std::int64_t>& numbers, const FlowComplex& complex,
                  const std::vector<Cycle>& cycles) {
  std::vector<double> births, deaths, levels;
  for (const Cycle& cycle : cycles) {
    births.push_back(rounded(complex.persistence().squared_value(cycle.pair.birth)));
    deaths.push_back(rounded(complex.persistence().squared_value(*cycle.pair.death)));
    levels.push_back(rounded(cycle.level.value().exact()));
  }
  arrays.push_back({"pair", numbers});
  arrays.push_back(array_by_number("squared_birth", numbers, births));
  arrays.push_back(array_by_number("squared_death", numbers, deaths));
  arrays.push_back(array_by_number("squared_level", numbers, levels));
}

std::vector<std::span<const std::uint32_t>> cells_of(const std::vector<Cycle>& cycles) {
  std::vector<std::span<const std::uint32_t>> cells;
  for (const Cycle& cycle : cycles) cells.emplace_back(std::get<Void>(cycle.chain).cell);
  return cells;
}

}  // namespace

PolyData loop_data(const FlowComplex& complex, const std::vector<Cycle>& cycles) {
  const geometry::IeeeDoubles ieee;
  PolyData data;
  std::vector<std::int64_t> numbers, samples;
  std::map<PointId, std::int64_t> place_of;
  const auto point = [&](PointId sample) {
    const auto [known, is_new] = place_of.try_emplace(sample, static_cast<std::int64_t>(samples.size()));
    if (is_new) {
      samples.push_back(static_cast<std::int64_t>(sample));
      data.points.push_back(complex.points().at_row(sample));
    }
    return known->second;
  };
  auto& [connectivity, offsets] = data.lines;
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    for (const LoopPolygon& polygon : std::get<LoopCycle>(cycles[k].chain).polygons) {
      for (const PointId sample : polygon) connectivity.push_back(point(sample));
      connectivity.push_back(point(polygon.front()));
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      numbers.push_back(static_cast<std::int64_t>(k));
    }
  }
  data.point_data.push_back({"sample", std::move(samples)});
  append_pairs(data.cell_data, numbers, complex, cycles);
  return data;
}

PolyData loop_surface_data(const FlowComplex& complex, const std::vector<Cycle>& cycles) {
  const geometry::IeeeDoubles ieee;
  PolyData data;
  std::vector<std::int64_t> numbers, saddles, samples;
  std::vector<double> squared_distances;
  auto& [connectivity, offsets] = data.polygons;
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const LoopCycle& loop = std::get<LoopCycle>(cycles[k].chain);
    SurfaceMesh mesh = loop_surface_mesh(complex, loop.surface);
    const auto first = static_cast<std::int64_t>(data.points.size());
    data.points.insert(data.points.end(), mesh.vertices.begin(), mesh.vertices.end());
    std::ranges::transform(mesh.samples, std::back_inserter(samples), [](const std::optional<PointId>& sample) {
      return sample ? static_cast<std::int64_t>(*sample) : -1;
    });
    for (const std::optional<double>& value : mesh.squared_distances) {
      if (!value) throw BeyondDoubles();
      squared_distances.push_back(*value);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t corner : mesh.triangles[t]) connectivity.push_back(first + corner);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      saddles.push_back(static_cast<std::int64_t>(complex.stable().record(mesh.set_of_triangle[t])));
      numbers.push_back(static_cast<std::int64_t>(k));
    }
  }
  data.point_data.push_back({"SquaredDistance", std::move(squared_distances)});
  data.point_data.push_back({"sample", std::move(samples)});
  append_pairs(data.cell_data, numbers, complex, cycles);
  data.cell_data.push_back({"saddle", std::move(saddles)});
  return data;
}

UnstructuredGrid void_data(const FlowComplex& complex, const std::vector<Cycle>& cycles) {
  const geometry::IeeeDoubles ieee;
  CellGrid made = cell_grid(complex, cells_of(cycles));
  std::vector<double> volumes;
  for (const Cycle& cycle : cycles) {
    volumes.push_back(finite(complex.volumes().nearest_sum(std::get<Void>(cycle.chain).cell)));
  }
  append_pairs(made.grid.cell_data, made.numbers, complex, cycles);
  made.grid.cell_data.push_back(array_by_number("volume", made.numbers, volumes));
  return std::move(made.grid);
}

std::vector<CellSurface> void_surfaces(const FlowComplex& complex, const std::vector<Cycle>& cycles) {
  return cell_surfaces(complex, cells_of(cycles));
}

}  // namespace flowcert
