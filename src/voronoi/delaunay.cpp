// The one file that knows CGAL's triangulation: builds it, and copies it out into plain arrays.
//
// Guarantees: which of several Delaunay triangulations it is depends on the points and their order alone, not on the
// system. What std::nth_element may leave in any order C++ libraries order differently; CGAL's own is the same
// everywhere.
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR
#include "voronoi/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <boost/property_map/function_property_map.hpp>
#include <numeric>
#include <vector>

#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "voronoi/compact_delaunay.h"
#include "voronoi/delaunay_kernel.h"
#include "voronoi/layer.h"

namespace flowcert {

using namespace voronoi;

namespace {

using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexIndex, DelaunayKernel>;
// The number is the cell's place in the compact copy, so that its neighbours can name it.
using CellBase = CGAL::Triangulation_cell_base_with_info_3<CellIndex, DelaunayKernel,
                                                           CGAL::Delaunay_triangulation_cell_base_3<DelaunayKernel>>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Cgal = CGAL::Delaunay_triangulation_3<DelaunayKernel, Structure>;

constexpr std::size_t kProgressStep = 4096;

// Two skew lines have as many cells as pairs of points.
[[noreturn]] void reject_many_cells(std::size_t cells, std::size_t inserted, std::size_t points) {
  throw InvalidInput(std::to_string(cells) + " Delaunay cells after " + std::to_string(inserted) + " of " +
                     std::to_string(points) +
                     " points: memory and output grow with the square of their number; --unlimited computes them");
}

}  // namespace

struct Delaunay::Triangulation {
  const PointSet* points;
  Cgal cgal;
  std::vector<std::size_t> order;  // ordinals in order of insertion, which is a vertex' number
};

namespace {

// Ordinals along CGAL's space-filling curve, which compares coordinates.
std::vector<std::size_t> spatial_order(const PointSet& points) {
  using Doubles = CGAL::Simple_cartesian<double>;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto position = boost::make_function_property_map<std::size_t>([&points](std::size_t ordinal) {
    const Point& p = points[ordinal];
    return Doubles::Point_3(p.x, p.y, p.z);
  });
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Doubles, decltype(position)>(position));
  return order;
}

}  // namespace

Delaunay::Delaunay(const PointSet& points, const Progress& progress, std::size_t most_cells) {
  const geometry::IeeeDoubles ieee;
  triangulation_.reset(new Triangulation{&points, Cgal(DelaunayKernel(DelaunaySigns(points))), spatial_order(points)});
  const std::vector<std::size_t>& order = triangulation_->order;

  // This does what CGAL's own range insertion does, and reports progress now and then.
  Cgal& cgal = triangulation_->cgal;
  Cgal::Cell_handle hint;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Cgal::Vertex_handle vertex = cgal.insert({points[order[i]]}, hint);
    vertex->info() = static_cast<VertexIndex>(i);
    hint = vertex->cell();
    if (cgal.tds().cells().size() > most_cells) reject_many_cells(cgal.tds().cells().size(), i + 1, order.size());
    if (progress && (i + 1) % kProgressStep == 0) progress(i + 1, order.size());
  }
  if (progress) progress(order.size(), order.size());
}

Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

const PointSet& Delaunay::points() const { return *triangulation_->points; }
int Delaunay::dimension() const { return triangulation_->cgal.dimension(); }

namespace {

// Visits every cell of the highest dimension, the infinite ones too. CGAL names its iterators by dimension.
void for_each_cell(const Cgal& cgal, const auto& visit) {
  switch (cgal.dimension()) {
    case 3:
      for (const Cgal::Cell_handle cell : cgal.all_cell_handles()) visit(cell);
      break;
    case 2:
      for (const Cgal::Facet& facet : cgal.all_facets()) visit(facet.first);
      break;
    case 1:
      for (const Cgal::Edge& edge : cgal.all_edges()) visit(edge.first);
      break;
    default:
      break;
  }
}

// Prefetches the cells that are copied soon, and then their neighbours. A cell of CGAL lies in two lines of the cache.
// It is inlined for the reason of VoronoiFaces::prefetch_link().
[[gnu::always_inline]] inline void prefetch(const std::vector<Cgal::Cell_handle>& cells, std::size_t number,
                                            int corners) {
  constexpr std::size_t kDistance = 8;
  if (number + 2 * kDistance >= cells.size()) return;
  __builtin_prefetch(&*cells[number + 2 * kDistance]);
  __builtin_prefetch(&cells[number + 2 * kDistance]->info());
  for (int i = 0; i < corners; ++i) __builtin_prefetch(&cells[number + kDistance]->neighbor(i)->info());
}

// The cells in the order of their numbers, which are written into them.
struct NumberedCells {
  std::vector<Cgal::Cell_handle> cells;
  CellIndex finite_count;
};

// Numbers the cells: finite ones by their last vertex (a counting sort), then the infinite ones.
NumberedCells number_cells(const Cgal& cgal, int corners, std::size_t vertex_count) {
  const std::size_t cell_count = cgal.tds().cells().size();
  if (cell_count >= kMostCells) throw InvalidInput("the Delaunay triangulation has 2^29 cells or more");
  const Cgal::Vertex_handle infinite = cgal.infinite_vertex();
  std::vector<Cgal::Cell_handle> infinite_cells;
  std::vector<CellIndex> next(vertex_count + 1, 0);
  for_each_cell(cgal, [&](Cgal::Cell_handle cell) {
    VertexIndex last = 0;
    for (int i = 0; i < corners; ++i) {
      if (cell->vertex(i) == infinite) {
        cell->info() = kInfiniteVertex;
        infinite_cells.push_back(cell);
        return;
      }
      last = std::max(last, cell->vertex(i)->info());
    }
    cell->info() = last;
    ++next[last + 1];
  });
  std::partial_sum(next.begin(), next.end(), next.begin());
  NumberedCells numbered{std::vector<Cgal::Cell_handle>(cell_count), next.back()};
  for_each_cell(cgal, [&](Cgal::Cell_handle cell) {
    if (cell->info() == kInfiniteVertex) return;
    cell->info() = next[cell->info()]++;
    numbered.cells[cell->info()] = cell;
  });
  CellIndex count = numbered.finite_count;
  for (const Cgal::Cell_handle cell : infinite_cells) {
    numbered.cells[count] = cell;
    cell->info() = count++;
  }
  return numbered;
}

// In the order of the numbers, neighbours are looked at one soon after the other.
void copy_cells(const NumberedCells& numbered, std::size_t first, std::size_t last, int corners,
                Cgal::Vertex_handle infinite, geometry::UnsetVector<DelaunayCell>& copies) {
  for (std::size_t number = first; number < last; ++number) {
    prefetch(numbered.cells, number, corners);
    DelaunayCell& copied = copies[number];
    copied.vertices.fill(kInfiniteVertex);
    copied.neighbors.fill(kNoCell);
    const Cgal::Cell_handle cell = numbered.cells[number];
    for (int i = 0; i < corners; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (cell->vertex(i) != infinite) copied.vertices[k] = cell->vertex(i)->info();
      copied.neighbors[k] = cell->neighbor(i)->info();
    }
  }
}

}  // namespace

CompactDelaunay voronoi::compact_copy(const Delaunay& delaunay, unsigned threads) {
  const Cgal& cgal = delaunay.triangulation().cgal;
  CompactDelaunay copy;
  copy.dimension = cgal.dimension();
  copy.points.reserve(delaunay.points().size());
  copy.ordinals.reserve(delaunay.points().size());
  for (const std::size_t ordinal : delaunay.triangulation().order) {
    copy.points.push_back(delaunay.points()[ordinal]);
    copy.ordinals.push_back(static_cast<std::uint32_t>(ordinal));
  }
  if (copy.dimension < 1) return copy;
  const int corners = copy.dimension + 1;
  const NumberedCells numbered = number_cells(cgal, corners, copy.points.size());
  copy.finite_count = numbered.finite_count;
  copy.cells.resize(numbered.cells.size());
  constexpr std::size_t kPart = geometry::portion_size(1u << 14);
  const std::size_t count = numbered.cells.size();
  geometry::parallel_for((count + kPart - 1) / kPart, threads, [&](std::size_t k) {
    copy_cells(numbered, k * kPart, std::min((k + 1) * kPart, count), corners, cgal.infinite_vertex(), copy.cells);
  });
  return copy;
}

}  // namespace flowcert
