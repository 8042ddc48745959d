// Lists of lists are stored as offsets and what they have, as everywhere in a page.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "flowcert/surface.h"
#include "geometry/difference_of_roots.h"
#include "io/cell_surfaces.h"
#include "io/viewer_parts.h"

namespace flowcert::io {

namespace {

using Numbers = std::vector<std::uint32_t>;

// The lists of the pockets, one after the other.
struct Lists {
  Numbers offsets = {0}, all;

  void add(const Numbers& list) {
    all.insert(all.end(), list.begin(), list.end());
    offsets.push_back(static_cast<std::uint32_t>(all.size()));
  }
};

// The numbers of the deepest pockets, ascending. Depths are compared as doubles, because this only decides what is
// drawn.
Numbers deepest(const Pockets& pockets, std::size_t most) {
  Numbers numbers(pockets.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  if (numbers.size() <= most) return numbers;
  std::vector<double> depths;
  for (const std::uint32_t number : numbers) depths.push_back(pockets.depth(pockets[number]));
  std::ranges::stable_sort(numbers, std::ranges::greater{}, [&](std::uint32_t number) { return depths[number]; });
  numbers.resize(most);
  std::ranges::sort(numbers);
  return numbers;
}

Json surfaces_field(const FlowComplex& complex, const ViewerFrame& frame, const Pockets& pockets,
                    const Numbers& chosen) {
  const std::vector<CellSurface> surfaces = cell_surfaces(complex, pockets.cells());
  Numbers offsets = {0}, triangles;
  std::vector<float> vertices;
  for (const std::uint32_t number : chosen) {
    const auto first = static_cast<std::uint32_t>(vertices.size() / 3);
    for (const Point& vertex : surfaces[number].vertices) frame.append(vertices, vertex);
    for (const auto& triangle : surfaces[number].triangles) {
      for (const std::uint32_t vertex : triangle) triangles.push_back(first + vertex);
    }
    offsets.push_back(static_cast<std::uint32_t>(triangles.size() / 3));
  }
  return {{"triangle_offsets", viewer_blob(offsets)},
          {"triangles", viewer_blob(triangles)},
          {"vertices", viewer_blob(vertices)}};
}

// The S2 of all mouths of these pockets, each once.
Json mouths_field(const FlowComplex& complex, const ViewerFrame& frame, const Pockets& pockets, const Numbers& chosen) {
  const auto& counts = complex.stationary().critical_counts();
  const std::size_t first_saddle = counts[0] + counts[1];
  std::map<std::size_t, Numbers> of_set;  // triangles, as vertices, by number in StableManifolds
  std::vector<std::size_t> sets;
  for (const std::uint32_t number : chosen) {
    for (const std::uint32_t mouth : pockets[number].mouths) of_set[mouth - first_saddle];
  }
  sets.reserve(of_set.size());
  for (const auto& [set, triangles] : of_set) sets.push_back(set);
  const SurfaceMesh mesh = surface_mesh(complex, sets);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    Numbers& triangles = of_set.at(mesh.set_of_triangle[k]);
    triangles.insert(triangles.end(), mesh.triangles[k].begin(), mesh.triangles[k].end());
  }
  Numbers points, offsets = {0}, triangles;
  std::vector<float> vertices;
  for (const auto& [set, corners] : of_set) {
    points.push_back(static_cast<std::uint32_t>(first_saddle + set));
    triangles.insert(triangles.end(), corners.begin(), corners.end());
    offsets.push_back(static_cast<std::uint32_t>(triangles.size() / 3));
  }
  for (const Point& vertex : mesh.vertices) frame.append(vertices, vertex);
  return {{"points", viewer_blob(points)},
          {"triangle_offsets", viewer_blob(offsets)},
          {"triangles", viewer_blob(triangles)},
          {"vertices", viewer_blob(vertices)}};
}

}  // namespace

Json viewer_pockets_field(const FlowComplex& complex, const ViewerFrame& frame, const Pockets& pockets,
                          std::size_t most) {
  const Numbers chosen = deepest(pockets, most);
  Lists peaks, maxima, cells, mouths, neighbours;
  Numbers gates;
  std::vector<double> depths, volumes, widest;
  for (const std::uint32_t number : chosen) {
    const Pocket& pocket = pockets[number];
    peaks.add(pocket.peaks);
    maxima.add(pocket.maxima);
    cells.add(pocket.cell);
    mouths.add(pocket.mouths);
    Numbers beside = pocket.neighbours;
    std::ranges::replace(beside, static_cast<std::uint32_t>(pockets.size()), ViewerSelection::kNone);
    neighbours.add(beside);
    depths.push_back(pockets.depth(pocket));
    volumes.push_back(complex.volumes().nearest_sum(pocket.cell));
    gates.push_back(pocket.to_infinity.gates.front());
    widest.push_back(geometry::nearest_difference_of_roots(pockets.squared_distances().exact(gates.back()), 0));
  }
  Json json = {{"squared_persistence", to_text(pockets.squared_persistence())}, {"of", pockets.size()}};
  json["numbers"] = viewer_blob(chosen);
  const auto put = [&json](const std::string& name, const Lists& lists) {
    json[name + "_offsets"] = viewer_blob(lists.offsets);
    json[name] = viewer_blob(lists.all);
  };
  put("peaks", peaks);
  put("maxima", maxima);
  put("cell", cells);
  put("mouths", mouths);
  put("neighbours", neighbours);
  json["depth"] = viewer_blob(depths);
  json["volume"] = viewer_blob(volumes);
  json["gate"] = viewer_blob(gates);
  json["widest"] = viewer_blob(widest);
  json["surfaces"] = surfaces_field(complex, frame, pockets, chosen);
  json["mouth_surfaces"] = mouths_field(complex, frame, pockets, chosen);
  return json;
}

}  // namespace flowcert::io
