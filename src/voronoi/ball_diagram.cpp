// The one file that knows CGAL's regular triangulation of dimension 4.
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR
#include "voronoi/ball_diagram.h"

#include <CGAL/Epeck_d.h>
#include <CGAL/Epick_d.h>
#include <CGAL/Regular_triangulation.h>
#include <CGAL/Spatial_sort_traits_adapter_d.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/floating_point.h"
#include "voronoi/layer.h"

namespace flowcert {

namespace {

using Dimension = CGAL::Dimension_tag<4>;

template <class Kernel>
using Regular = CGAL::Regular_triangulation<
    Kernel,
    CGAL::Triangulation_data_structure<
        Dimension, CGAL::Triangulation_vertex<CGAL::Regular_triangulation_traits_adapter<Kernel>, std::uint32_t>,
        CGAL::Triangulation_full_cell<CGAL::Regular_triangulation_traits_adapter<Kernel>, std::uint32_t>>>;

// Points that follow each other in this order are near to each other, so that each is found from the one before.
std::vector<std::uint32_t> insertion_order(const BallSet& balls) {
  using Sorting = CGAL::Epick_d<Dimension>;
  std::vector<Sorting::Point_d> sites;
  std::vector<std::ptrdiff_t> order;
  for (const std::uint32_t id : balls.visible()) {
    const std::array<double, 4>& site = balls.rounded(id);
    order.push_back(static_cast<std::ptrdiff_t>(sites.size()));
    sites.emplace_back(4, site.begin(), site.end());
  }
  using Adapter = CGAL::Spatial_sort_traits_adapter_d<Sorting, Sorting::Point_d*>;
  CGAL::spatial_sort(order.begin(), order.end(), Adapter(sites.data()));
  std::vector<std::uint32_t> ids;
  for (const std::ptrdiff_t place : order) ids.push_back(balls.visible()[static_cast<std::size_t>(place)]);
  return ids;
}

// Returns the dimension. Cells come in the order in which CGAL has them, and so do their corners.
template <class Kernel>
int triangulate_with(const BallSet& balls, const auto& site_of, std::vector<BallDiagram::Corners>& cells,
                     std::vector<BallDiagram::Corners>& adjacent) {
  using Triangulation = Regular<Kernel>;
  Triangulation made(4);
  typename Triangulation::Vertex_handle last;
  for (const std::uint32_t id : insertion_order(balls)) {
    const typename Triangulation::Weighted_point site = site_of(id);
    last = last == typename Triangulation::Vertex_handle() ? made.insert(site) : made.insert(site, last);
    last->data() = id;
  }
  const int dimension = made.current_dimension();
  for (auto cell = made.full_cells_begin(); cell != made.full_cells_end(); ++cell) cell->data() = BallDiagram::kNone;
  std::uint32_t count = 0;
  for (auto cell = made.finite_full_cells_begin(); cell != made.finite_full_cells_end(); ++cell) cell->data() = count++;
  cells.reserve(count);
  adjacent.reserve(count);
  for (auto cell = made.finite_full_cells_begin(); cell != made.finite_full_cells_end(); ++cell) {
    BallDiagram::Corners corners, behind;
    corners.fill(BallDiagram::kNone);
    behind.fill(BallDiagram::kNone);
    for (int k = 0; k <= dimension; ++k) {
      corners[static_cast<std::size_t>(k)] = cell->vertex(k)->data();
      if (dimension > 0) behind[static_cast<std::size_t>(k)] = cell->neighbor(k)->data();
    }
    cells.push_back(corners);
    adjacent.push_back(behind);
  }
  return dimension;
}

// Whether twice the square of each radius is a double.
bool are_weights_doubles(const BallSet& balls) {
  return std::ranges::all_of(balls.visible(), [&](std::uint32_t id) {
    const double r = balls.rounded(id)[3];
    return std::isfinite(r * r) && std::fma(r, r, -(r * r)) == 0;
  });
}

}  // namespace

BallDiagram::BallDiagram(const BallSet& balls) : balls_(&balls) {
  const geometry::IeeeDoubles ieee;
  triangulate();
  sort_cells();
  make_lists();
}

// Corners ascend, and cells by their corners.
void BallDiagram::sort_cells() {
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    Corners& corners = cells_[cell];
    Corners& behind = adjacent_[cell];
    for (std::size_t k = 1; k < 5; ++k) {
      for (std::size_t i = k; i > 0 && corners[i] < corners[i - 1]; --i) {
        std::swap(corners[i], corners[i - 1]);
        std::swap(behind[i], behind[i - 1]);
      }
    }
  }
  std::vector<std::uint32_t> order(cells_.size()), place(cells_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t cell) { return cells_[cell]; });
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  std::vector<Corners> cells, adjacent;
  for (const std::uint32_t cell : order) {
    cells.push_back(cells_[cell]);
    adjacent.push_back(adjacent_[cell]);
    for (std::uint32_t& other : adjacent.back()) other = other == kNone ? kNone : place[other];
  }
  cells_ = std::move(cells);
  adjacent_ = std::move(adjacent);
}

void BallDiagram::triangulate() {
  if (balls_->are_doubles() && are_weights_doubles(*balls_)) {
    using Kernel = CGAL::Epick_d<Dimension>;
    dimension_ = triangulate_with<Kernel>(
        *balls_,
        [&](std::uint32_t id) {
          const std::array<double, 4>& site = balls_->rounded(id);
          return Regular<Kernel>::Weighted_point(Kernel::Point_d(4, site.begin(), site.end()), 2 * site[3] * site[3]);
        },
        cells_, adjacent_);
    return;
  }
  using Kernel = CGAL::Epeck_d<Dimension>;
  dimension_ = triangulate_with<Kernel>(
      *balls_,
      [&](std::uint32_t id) {
        std::array<Kernel::FT, 4> site;
        for (std::size_t k = 0; k < 4; ++k) {
          site[k] = Kernel::FT(Kernel::FT::ET(balls_->scaled(id)[k].backend().data()));
        }
        return Regular<Kernel>::Weighted_point(Kernel::Point_d(4, site.begin(), site.end()),
                                               Kernel::FT(2) * site[3] * site[3]);
      },
      cells_, adjacent_);
}

void BallDiagram::make_lists() {
  const std::size_t count = balls_->size(), corners = static_cast<std::size_t>(dimension_ + 1);
  std::vector<std::vector<std::uint32_t>> stars(count);
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    for (std::size_t k = 0; k < corners; ++k) stars[cells_[cell][k]].push_back(cell);
  }
  star_.starts.push_back(0);
  neighbours_.starts.push_back(0);
  std::vector<std::uint32_t> near;
  for (std::uint32_t id = 0; id < count; ++id) {
    near.clear();
    for (const std::uint32_t cell : stars[id])
      near.insert(near.end(), cells_[cell].begin(), cells_[cell].begin() + static_cast<std::ptrdiff_t>(corners));
    std::ranges::sort(near);
    near.erase(std::ranges::unique(near).begin(), near.end());
    std::erase(near, id);
    neighbours_.items.insert(neighbours_.items.end(), near.begin(), near.end());
    star_.items.insert(star_.items.end(), stars[id].begin(), stars[id].end());
    neighbours_.starts.push_back(static_cast<std::uint32_t>(neighbours_.items.size()));
    star_.starts.push_back(static_cast<std::uint32_t>(star_.items.size()));
  }
}

}  // namespace flowcert
