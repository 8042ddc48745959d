// The one file that knows CGAL's regular triangulation of space.
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR
#include "voronoi/ball_slice.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/floating_point.h"
#include "voronoi/layer.h"

namespace flowcert {

namespace {

template <class Kernel>
void triangulate_with(std::span<const std::uint32_t> ids, const auto& site_of, BallSlice& made) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel,
                                                             CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
  using Cell =
      CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
  using Triangulation = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
  std::vector<std::pair<typename Triangulation::Weighted_point, std::uint32_t>> sites;
  sites.reserve(ids.size());
  for (const std::uint32_t id : ids) sites.emplace_back(site_of(id), id);
  const Triangulation regular(sites.begin(), sites.end());
  if (regular.dimension() < 3) return;
  std::uint32_t count = 0;
  for (const auto cell : regular.all_cell_handles()) cell->info() = BallSlice::kNone;
  for (const auto cell : regular.finite_cell_handles()) cell->info() = count++;
  made.tetrahedra.reserve(count);
  made.adjacent.reserve(count);
  for (const auto cell : regular.finite_cell_handles()) {
    BallSlice::Corners corners{}, behind{};
    for (int k = 0; k < 4; ++k) {
      corners[static_cast<std::size_t>(k)] = cell->vertex(k)->info();
      behind[static_cast<std::size_t>(k)] = cell->neighbor(k)->info();
    }
    made.tetrahedra.push_back(corners);
    made.adjacent.push_back(behind);
  }
}

}  // namespace

BallSlice::BallSlice(const BallSet& balls, std::span<const std::uint32_t> ids, const Rational& probe) {
  const geometry::IeeeDoubles ieee;
  const Rational grown = probe * balls.scale();
  // A sum and its square are doubles where they are exact: fma has no error to tell.
  const double reach = nearest_or_infinity(grown);
  const auto is_exact = [&](std::uint32_t id) {
    const double sum = balls.rounded(id)[3] + reach;
    return Rational(sum) == balls.scaled(id)[3] + grown && std::isfinite(sum * sum) &&
           std::fma(sum, sum, -(sum * sum)) == 0;
  };
  if (balls.are_doubles() && Rational(reach) == grown && std::ranges::all_of(ids, is_exact)) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    triangulate_with<Kernel>(
        ids,
        [&](std::uint32_t id) {
          const auto& [x, y, z, r] = balls.rounded(id);
          return Kernel::Weighted_point_3(Kernel::Point_3(x, y, z), (r + reach) * (r + reach));
        },
        *this);
    return;
  }
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  triangulate_with<Kernel>(
      ids,
      [&](std::uint32_t id) {
        const auto number = [](const Rational& value) { return Kernel::FT(Kernel::FT::ET(value.backend().data())); };
        const auto& [x, y, z, r] = balls.scaled(id);
        return Kernel::Weighted_point_3(Kernel::Point_3(number(x), number(y), number(z)),
                                        number(Rational((r + grown) * (r + grown))));
      },
      *this);
}

}  // namespace flowcert
