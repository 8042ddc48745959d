// The one file that knows CGAL's regular triangulation of dimension 4.
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR
#include "voronoi/ball_diagram.h"

#include <CGAL/Epeck_d.h>
#include <CGAL/Epick_d.h>
#include <CGAL/Regular_triangulation.h>
#include <CGAL/Spatial_sort_traits_adapter_d.h>
#include <CGAL/TDS_full_cell_mirror_storage_policy.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/sized_double.h"
#include "voronoi/layer.h"

namespace flowcert {

namespace {

using Dimension = CGAL::Dimension_tag<4>;
using geometry::SizedDouble;

template <class Kernel>
using Regular = CGAL::Regular_triangulation<
    Kernel,
    CGAL::Triangulation_data_structure<
        Dimension, CGAL::Triangulation_vertex<CGAL::Regular_triangulation_traits_adapter<Kernel>, std::uint32_t>,
        CGAL::Triangulation_full_cell<
            CGAL::Regular_triangulation_traits_adapter<Kernel>, std::uint32_t,
            CGAL::Triangulation_ds_full_cell<void, CGAL::TDS_full_cell_mirror_storage_policy>>>>;

template <std::size_t kSize>
using Rows = std::array<std::array<SizedDouble, kSize>, kSize>;

// The sign of a determinant of integers, where doubles tell it. A term goes through 30 roundings at most, nothing
// underflows, and a size of 0 says that all terms are 0. Where something overflows, no sign is certain.
template <std::size_t kSize>
std::optional<CGAL::Sign> certain_sign(const Rows<kSize>& rows) {
  // Minors of the first columns: of two rows, of three, and of four.
  std::array<std::array<SizedDouble, kSize>, kSize> two;
  std::array<std::array<std::array<SizedDouble, kSize>, kSize>, kSize> three;
#pragma GCC unroll 5
  for (std::size_t j = 1; j < kSize; ++j) {
#pragma GCC unroll 5
    for (std::size_t i = 0; i < j; ++i) two[i][j] = rows[i][0] * rows[j][1] - rows[j][0] * rows[i][1];
  }
#pragma GCC unroll 5
  for (std::size_t k = 2; k < kSize; ++k) {
#pragma GCC unroll 5
    for (std::size_t j = 1; j < k; ++j) {
#pragma GCC unroll 5
      for (std::size_t i = 0; i < j; ++i) {
        three[i][j][k] = two[i][j] * rows[k][2] - two[i][k] * rows[j][2] + two[j][k] * rows[i][2];
      }
    }
  }
  const auto four = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return three[i][j][k] * rows[l][3] - three[i][j][l] * rows[k][3] + three[i][k][l] * rows[j][3] -
           three[j][k][l] * rows[i][3];
  };
  SizedDouble all;
  if constexpr (kSize == 4) {
    all = four(0, 1, 2, 3);
  } else {
    all = four(0, 1, 2, 3) * rows[4][4] - four(0, 1, 2, 4) * rows[3][4] + four(0, 1, 3, 4) * rows[2][4] -
          four(0, 2, 3, 4) * rows[1][4] + four(1, 2, 3, 4) * rows[0][4];
  }
  if (all.size() == 0) return CGAL::ZERO;
  const int sign = all.bounded().certain_sign();
  return sign == 0 ? std::nullopt : std::optional(static_cast<CGAL::Sign>(sign));
}

// CGAL's kernel for doubles, with doubles before its intervals. All numbers are integers. CGAL 6 takes iterators
// that are temporary, and no others.
struct FilteredKernel : CGAL::Epick_d<Dimension> {
  using Base = CGAL::Epick_d<Dimension>;

  struct Orientation_d {
    using result_type = CGAL::Orientation;
    const Base& base;
    template <class Iterator>
    CGAL::Orientation operator()(const Iterator& first, const Iterator& last) const {
      Rows<4> rows;
      Iterator next = first;
      const Base::Point_d origin = *next;
      for (auto& row : rows) {
        const Base::Point_d point = *++next;
        for (int k = 0; k < 4; ++k) row[static_cast<std::size_t>(k)] = point[k] - origin[k];
      }
      if (const auto sign = certain_sign(rows)) return *sign;
      return base.orientation_d_object()(Iterator(first), Iterator(last));
    }
  };
  struct Power_side_of_power_sphere_d {
    using result_type = CGAL::Oriented_side;
    const Base& base;
    template <class Iterator>
    CGAL::Oriented_side operator()(const Iterator& first, const Iterator& last,
                                   const Base::Weighted_point_d& from) const {
      Rows<5> rows;
      Iterator next = first;
      for (auto& row : rows) {
        const Base::Weighted_point_d& site = *next++;
        row[4] = from.weight() - site.weight();
        for (int k = 0; k < 4; ++k) {
          SizedDouble& way = row[static_cast<std::size_t>(k)];
          way = site.point()[k] - from.point()[k];
          row[4] = row[4] + way * way;
        }
      }
      if (const auto sign = certain_sign(rows)) return *sign;
      return base.power_side_of_power_sphere_d_object()(Iterator(first), Iterator(last), from);
    }
  };
  [[nodiscard]] Orientation_d orientation_d_object() const { return {*this}; }
  [[nodiscard]] Power_side_of_power_sphere_d power_side_of_power_sphere_d_object() const { return {*this}; }
};

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
    using Kernel = FilteredKernel;
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
  const auto corners_of = [&](std::uint32_t cell) { return std::span(cells_[cell]).first(corners); };
  star_.starts.assign(count + 1, 0);
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    for (const std::uint32_t id : corners_of(cell)) ++star_.starts[id + 1];
  }
  std::partial_sum(star_.starts.begin(), star_.starts.end(), star_.starts.begin());
  star_.items.resize(star_.starts.back());
  std::vector<std::uint32_t> next(star_.starts.begin(), star_.starts.end() - 1), seen(count, kNone);
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    for (const std::uint32_t id : corners_of(cell)) star_.items[next[id]++] = cell;
  }
  neighbours_.starts.push_back(0);
  for (std::uint32_t id = 0; id < count; ++id) {
    seen[id] = id;
    for (const std::uint32_t cell : star(id)) {
      for (const std::uint32_t other : corners_of(cell)) {
        if (std::exchange(seen[other], id) != id) neighbours_.items.push_back(other);
      }
    }
    std::sort(neighbours_.items.begin() + neighbours_.starts.back(), neighbours_.items.end());
    neighbours_.starts.push_back(static_cast<std::uint32_t>(neighbours_.items.size()));
  }
}

}  // namespace flowcert
