// From a Voronoi vertex, d^2 ascends along the Voronoi edge of each polygon that does not have the vertex on its inner
// side (spec clause FC-SIGN-03). The edge starts at the vertex and leads away from the polygon's centre.
#include "flowcert/saddle_links.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "geometry/prefetch.h"
#include "geometry/relaxed_atomics.h"
#include "morse/layer.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::size_t kPortion = geometry::portion_size(4096);
constexpr std::uint32_t kUnknown = SaddleLinks::kInfinity - 1;

// A Voronoi vertex with a greater d^2, or kNoCell for infinity. The cluster is no maximum.
CellIndex next_above(const VoronoiDiagram& diagram, CellIndex cluster) {
  const VoronoiComplex& complex = diagram.complex();
  const CompactDelaunay& delaunay = diagram.delaunay();
  for (const CellIndex cell : complex.is_alone(cluster) ? std::span(&cluster, 1) : complex.large_cluster_of(cluster)) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (complex.role({cell, i}) == VoronoiComplex::FacetRole::kInterior) continue;
      if (complex.side({cell, i}) == Sign::kPositive) continue;
      const CellIndex beyond = delaunay.neighbors(cell)[i];
      return delaunay.is_finite(beyond) ? complex.cluster(beyond) : kNoCell;
    }
  }
  throw std::logic_error("a Voronoi vertex without a way up that is no maximum");
}

// By cluster: a maximum above it, or infinity.
class Summits {
 public:
  Summits(const VoronoiDiagram& diagram, const StationaryPoints& stationary, unsigned threads)
      : diagram_(diagram), above_(diagram.delaunay().finite_count, kUnknown), ways_(std::max(threads, 1U)) {
    const auto [first, last] = RecordFinder(stationary).range({3, 3});
    for (std::size_t record = first; record < last; ++record) {
      above_[cell_of_record(stationary, record)] = static_cast<std::uint32_t>(record);
    }
    geometry::in_portions(threads, above_.size(), kPortion, {}, [this](std::size_t thread, std::size_t cell) {
      const auto vertex = static_cast<CellIndex>(cell);
      if (diagram_.complex().cluster(vertex) == vertex) climb(vertex, ways_[thread]);
    });
  }

  [[nodiscard]] std::uint32_t operator[](CellIndex cluster) const { return above_[cluster]; }
  void prefetch(CellIndex cluster) const { __builtin_prefetch(&above_[cluster]); }

 private:
  // Two threads may climb the same way. They write the same.
  void climb(CellIndex from, std::vector<CellIndex>& way) {
    std::uint32_t summit = SaddleLinks::kInfinity;
    for (CellIndex at = from; at != kNoCell; at = next_above(diagram_, at)) {
      summit = geometry::relaxed_load(above_[at]);
      if (summit != kUnknown) break;
      way.push_back(at);
      summit = SaddleLinks::kInfinity;
    }
    for (; !way.empty(); way.pop_back()) geometry::relaxed_store(above_[way.back()], summit);
  }

  const VoronoiDiagram& diagram_;
  std::vector<std::uint32_t> above_;
  std::vector<std::vector<CellIndex>> ways_;  // by thread: the vertices whose maximum is not known yet
};

}  // namespace

void SaddleLinks::copy_boundaries(const auto& boundary_of, unsigned threads) {
  const auto for_each = [&](const auto& use) {
    geometry::in_portions(threads, size(), kPortion, {}, [&](std::size_t, std::size_t i) {
      geometry::prefetch_ahead(i, size(), [&](std::size_t later) { __builtin_prefetch(boundary_of(later).data()); });
      use(i, boundary_of(i));
    });
  };
  first_.assign(size() + 1, 0);
  for_each([this](std::size_t i, std::span<const std::uint32_t> cells) { first_[i + 1] = cells.size(); });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cells_.resize(first_.back());
  for_each([&](std::size_t i, std::span<const std::uint32_t> cells) {
    std::ranges::copy(cells, cells_.begin() + static_cast<std::ptrdiff_t>(first_[i]));
  });
}

SaddleLinks::SaddleLinks(const VoronoiDiagram& diagram, const StationaryPoints& stationary,
                         const StableManifolds& stable, unsigned threads) {
  const geometry::IeeeDoubles ieee;
  const auto [first, last] = RecordFinder(stationary).range({2, 2});
  upper_.assign(last - first, {kInfinity, kInfinity});
  copy_boundaries([&stable](std::size_t i) { return stable.boundary(i); }, threads);
  if (diagram.dimension() < 3) return;
  const Summits summits(diagram, stationary, threads);
  geometry::in_portions(threads, size(), kPortion, {}, [&, first = first](std::size_t, std::size_t i) {
    geometry::prefetch_ahead(i, size(), [&](std::size_t later) {
      const PolygonRef polygon = edge_of_record(stationary, first + later);
      summits.prefetch(polygon.cell);
      __builtin_prefetch(&diagram.delaunay().cells[polygon.cell]);
    });
    const PolygonRef polygon = edge_of_record(stationary, first + i);
    for (const std::size_t side : {0U, 1U}) {
      const CellIndex end = diagram.end(polygon, side);
      if (end != kNoCell) upper_[i][side] = summits[end];
    }
  });
}

SaddleLinks::SaddleLinks(const StationaryPoints& stationary, const ChainComplex& complex) : upper_(complex.limits()) {
  const std::size_t first = RecordFinder(stationary).range({2, 2}).first;
  copy_boundaries([&](std::size_t i) { return complex.boundary(first + i); }, 1);
}

}  // namespace flowcert
