// In a plane, a walk over triangles gathers the polygons. In space, union-find gathers clusters and the polygons on
// the hull, and sorting gathers the other polygons.
#include "voronoi/voronoi_complex.h"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

#include "geometry/contract.h"
#include "geometry/disjoint_sets.h"
#include "geometry/integer_grid.h"
#include "geometry/portions.h"
#include "geometry/predicates.h"

namespace flowcert::voronoi {

// ---- Coplanar points ----

PlanarComplex::PlanarComplex(CompactDelaunay delaunay, FilterTally& tally) : delaunay_(std::move(delaunay)) {
  const CellIndex count = delaunay_.finite_count;
  const auto point = [this](CellIndex cell, std::uint32_t i) -> const Point& {
    return delaunay_.points[delaunay_.vertices(cell)[i]];
  };
  angles_.resize(count);
  for (CellIndex cell = 0; cell < count; ++cell) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      angles_[cell][i] = exact_sign(Angle{point(cell, (i + 1) % 3), point(cell, i), point(cell, (i + 2) % 3)}, tally);
    }
  }

  // Joins triangles across cocircular edges, by a walk from each triangle that has no polygon yet.
  constexpr std::uint32_t kNone = 0xffffffffu;
  polygon_of_.assign(count, kNone);
  for (CellIndex first = 0; first < count; ++first) {
    if (polygon_of_[first] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(polygons_.size());
    polygon_of_[first] = id;
    std::vector<CellIndex> members{first};
    for (std::size_t k = 0; k < members.size(); ++k) {
      const CellIndex cell = members[k];
      for (std::uint32_t i = 0; i < 3; ++i) {
        const FacetRef across = delaunay_.mirror({cell, i});
        if (!delaunay_.is_finite(across.cell) || polygon_of_[across.cell] != kNone) continue;
        const OutsideCircle query{point(cell, (i + 1) % 3), point(cell, (i + 2) % 3), point(cell, i),
                                  point(across.cell, across.index)};
        if (exact_sign(query, tally) != Sign::kZero) continue;
        polygon_of_[across.cell] = id;
        members.push_back(across.cell);
      }
    }
    polygons_.push_back(std::move(members));
  }
}

bool PlanarComplex::is_diagonal(FacetRef edge) const {
  const CellIndex other = delaunay_.neighbors(edge.cell)[edge.index];
  return delaunay_.is_finite(other) && polygon_of_[other] == polygon_of_[edge.cell];
}

// ---- Points that span R^3 ----

VoronoiComplex::VoronoiComplex(CompactDelaunay delaunay, FilterTally& tally, unsigned threads, const Progress& progress)
    : delaunay_(std::move(delaunay)) {
  FLOWCERT_REQUIRES(delaunay_.dimension == 3);
  compute_signs(tally, threads, progress);
}

TetrahedronPoints VoronoiComplex::points_of(CellIndex cell) const {
  const auto& v = delaunay_.vertices(cell);
  const Point* p = delaunay_.points.data();
  return {p + v[0], p + v[1], p + v[2], p + v[3]};
}

// The pass below looks up the neighbours' vertices a few cells later, and would otherwise wait for them. (It is inlined
// for the reason of VoronoiFaces::prefetch_link().)
[[gnu::always_inline]] inline void VoronoiComplex::prefetch_neighbors(CellIndex cell) const {
  if (cell >= delaunay_.finite_count) return;
  for (const CellIndex neighbor : delaunay_.neighbors(cell)) __builtin_prefetch(&delaunay_.cells[neighbor]);
  for (const VertexIndex vertex : delaunay_.vertices(cell)) __builtin_prefetch(&delaunay_.points[vertex]);
}

// The earlier one of a facet's two cells compares its sphere with the other cell's vertex. Which cell that is cannot be
// guessed, so that there is no branch.
VoronoiComplex::Beyond VoronoiComplex::look_across(CellIndex cell) {
  turns_.look(delaunay_, cell);
  const auto& [vertices, neighbors] = delaunay_.cells[cell];
  Beyond beyond{};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const int is_later = static_cast<int>(neighbors[i] > cell) & static_cast<int>(delaunay_.is_finite(neighbors[i]));
    beyond.later |= static_cast<unsigned>(is_later) << i;
    const VertexIndex sample = delaunay_.vertices(neighbors[i])[turns_.mirror({cell, i})];
    beyond.samples[i] = is_later != 0 ? sample : vertices[0];
    __builtin_prefetch(&delaunay_.points[beyond.samples[i]]);
  }
  return beyond;
}

// The cells from `first` to `last` - 1, at most as many as there are lanes. Each is written by its own thread alone.
void VoronoiComplex::compute_signs_of(CellIndex first, CellIndex last, TetrahedronLanes& lanes, Found& found) {
  const std::size_t count = last - first;
  std::array<Beyond, TetrahedronLanes::kLanes> beyond;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const CellIndex cell = first + static_cast<CellIndex>(lane);
    prefetch_neighbors(cell + TetrahedronLanes::kLanes);
    lanes.set(lane, points_of(cell));
    beyond[lane] = look_across(cell);
  }
  lanes.compute();
  for (std::size_t lane = 0; lane < count; ++lane) {
    for (std::size_t i = 0; i < 4; ++i) lanes.set_sample(lane, i, delaunay_.points[beyond[lane].samples[i]]);
  }
  lanes.compare();
  FilterTally& tally = found.tally;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const CellIndex cell = first + static_cast<CellIndex>(lane);
    if (lanes.is_known(lane)) {
      tally[Predicate::kAngle] += {12, lanes.angle_failures(lane)};
      tally[Predicate::kSideOfPlane] += {4, lanes.side_failures(lane)};
      signs_[cell] = lanes.signs(lane);
    } else {
      CellSphere unused;
      signs_[cell] = tetrahedron_signs(points_of(cell), unused, tally);
    }
    const unsigned later = beyond[lane].later, off = later & lanes.off_sphere(lane);
    const unsigned on = later & ~off & lanes.exactly_on_sphere(lane);
    const unsigned told = on | (later & ~off & lanes.exactly_off_sphere(lane));
    const auto count = [](unsigned mask) { return static_cast<std::uint64_t>(std::popcount(mask)); };
    tally[Predicate::kCospherical] += {count(off | told), count(told)};
    for (unsigned left = on; left != 0; left &= left - 1) {
      found.cospherical.push_back({cell, static_cast<std::uint32_t>(std::countr_zero(left))});
    }
    for (unsigned close = later & ~off & ~told; close != 0; close &= close - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(close));
      const Point& q = delaunay_.points[beyond[lane].samples[i]];
      if (on_sphere(points_of(cell), lanes.sphere(lane), q, tally)) found.cospherical.push_back({cell, i});
    }
  }
}

// One pass over the cells: their signs, and which neighbours share their sphere.
void VoronoiComplex::compute_signs(FilterTally& tally, unsigned threads, const Progress& progress) {
  const CellIndex count = delaunay_.finite_count;
  signs_.resize(count);
  turns_.resize(delaunay_.cells.size());
  // Cells of scans are too large on the grid of their coordinates.
  const geometry::IntegerGrid grid(std::span<const Point>(delaunay_.points));
  const double exact_reach = grid.fits_small() ? grid.exact_reach() : 0;
  constexpr auto kPart = static_cast<CellIndex>(geometry::portion_size(1u << 14));
  std::vector<Found> found((count + kPart - 1) / kPart);
  geometry::in_portions(threads, found.size(), 1, progress, [&](std::size_t, std::size_t k) {
    TetrahedronLanes lanes(exact_reach);
    const CellIndex end = std::min(static_cast<CellIndex>(k + 1) * kPart, count);
    for (CellIndex first = static_cast<CellIndex>(k) * kPart; first < end; first += TetrahedronLanes::kLanes) {
      compute_signs_of(first, std::min<CellIndex>(first + TetrahedronLanes::kLanes, end), lanes, found[k]);
    }
  });
  for (CellIndex cell = count; cell < delaunay_.cells.size(); ++cell) turns_.look(delaunay_, cell);
  std::vector<FacetRef> cospherical;
  for (const Found& part : found) {
    cospherical.insert(cospherical.end(), part.cospherical.begin(), part.cospherical.end());
    tally += part.tally;
  }
  if (cospherical.empty()) return;
  gather_clusters(cospherical);
  // Two facets of one polygon lie in one plane, so their cells differ on both sides. So only facets of large clusters
  // can be pieces: facets between two of these, or on the hull.
  gather_inner_polygons();
  gather_hull_polygons(tally);
}

void VoronoiComplex::gather_clusters(std::span<const FacetRef> cospherical) {
  const CellIndex count = delaunay_.finite_count;
  DisjointSets partition(count);
  flags_.assign(count, kAlone);
  for (const FacetRef facet : cospherical) {
    const CellIndex neighbor = delaunay_.neighbors(facet.cell)[facet.index];
    partition.unite(facet.cell, neighbor);
    flags_[facet.cell] = static_cast<std::uint16_t>(flags_[facet.cell] & ~kAlone);
    flags_[neighbor] = static_cast<std::uint16_t>(flags_[neighbor] & ~kAlone);
  }
  // A counting sort by cluster: of each, its cells ascend.
  cluster_.resize(count);
  std::vector<std::uint32_t> sizes(count, 0);
  for (CellIndex cell = 0; cell < count; ++cell) {
    cluster_[cell] = partition.find(cell);
    if (!is_alone(cell)) ++sizes[cluster_[cell]];
  }
  std::vector<std::uint32_t>& next = sizes;
  std::uint32_t total = 0;
  for (std::uint32_t& size : sizes) {
    if (size == 0) continue;
    if (total > 0) cluster_first_.push_back(total);
    total += std::exchange(size, total);
  }
  cluster_first_.push_back(total);
  cluster_cells_.resize(total);
  for (CellIndex cell = 0; cell < count; ++cell) {
    if (!is_alone(cell)) cluster_cells_[next[cluster_[cell]]++] = cell;
  }

  // A facet between two cells of one cluster is interior. It is marked from both of its sides.
  for (const CellIndex cell : cluster_cells_) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellIndex neighbor = delaunay_.neighbors(cell)[i];
      if (delaunay_.is_finite(neighbor) && cluster_[neighbor] == cluster_[cell]) {
        flags_[cell] = static_cast<std::uint16_t>(flags_[cell] | (1u << i));
      }
    }
  }
}

// Large clusters are kept in the order of their names.
std::span<const CellIndex> VoronoiComplex::large_cluster_of(CellIndex cell) const {
  FLOWCERT_REQUIRES(!is_alone(cell));
  std::size_t low = 0, high = large_cluster_count();
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (cluster_[large_cluster(middle).front()] <= cluster_[cell] ? low : high) = middle;
  }
  return large_cluster(low);
}

// The facets of a cluster that lead to one later cluster are a polygon.
void VoronoiComplex::gather_inner_polygons() {
  std::vector<std::pair<std::uint32_t, FacetRef>> pieces;  // by the other cluster
  for (std::size_t cluster = 0; cluster < large_cluster_count(); ++cluster) {
    pieces.clear();
    for (const CellIndex cell : large_cluster(cluster)) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        const CellIndex neighbor = delaunay_.neighbors(cell)[i];
        if (!delaunay_.is_finite(neighbor) || is_alone(neighbor)) continue;
        if (cluster_[cell] < cluster_[neighbor]) pieces.push_back({cluster_[neighbor], {cell, i}});
      }
    }
    add_polygons(pieces);
  }
}

// The hull facets of one cluster in one plane are connected across the edges they share, so it is enough to look at
// neighbours on the hull.
void VoronoiComplex::gather_hull_polygons(FilterTally& tally) {
  std::vector<FacetRef> hull;
  std::unordered_map<CellIndex, std::uint32_t> place;  // by the infinite cell on the other side
  for (const CellIndex cell : cluster_cells_) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CellIndex neighbor = delaunay_.neighbors(cell)[i];
      if (delaunay_.is_finite(neighbor)) continue;
      place.emplace(neighbor, static_cast<std::uint32_t>(hull.size()));
      hull.push_back({cell, i});
    }
  }
  DisjointSets partition(hull.size());
  const auto point = [this](VertexIndex v) -> const Point& { return delaunay_.points[v]; };
  for (std::uint32_t k = 0; k < hull.size(); ++k) {
    const CellIndex outside = delaunay_.neighbors(hull[k].cell)[hull[k].index];
    const auto& around = delaunay_.neighbors(outside);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto next = place.find(around[i]);
      if (next == place.end() || next->second <= k) continue;
      const FacetRef other = hull[next->second];
      if (cluster_[other.cell] != cluster_[hull[k].cell]) continue;
      // The vertex of the next hull facet that is not on the shared edge.
      const VertexIndex tip = delaunay_.vertices(around[i])[delaunay_.mirror({outside, i}).index];
      const auto& v = delaunay_.vertices(hull[k].cell);
      const std::uint32_t f = hull[k].index;
      const Orientation plane{point(v[(f + 1) & 3]), point(v[(f + 2) & 3]), point(v[(f + 3) & 3]), point(tip)};
      if (exact_sign(plane, tally) == Sign::kZero) partition.unite(k, next->second);
    }
  }
  std::vector<std::pair<std::uint32_t, FacetRef>> pieces;
  for (std::uint32_t k = 0; k < hull.size(); ++k) pieces.emplace_back(partition.find(k), hull[k]);
  add_polygons(pieces);
}

// Several facets of one number are a polygon.
void VoronoiComplex::add_polygons(std::span<std::pair<std::uint32_t, FacetRef>> pieces) {
  std::ranges::sort(pieces);
  std::vector<FacetRef> run;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    run.push_back(pieces[k].second);
    if (k + 1 < pieces.size() && pieces[k + 1].first == pieces[k].first) continue;
    if (run.size() > 1) add_polygon(run);
    run.clear();
  }
}

void VoronoiComplex::add_polygon(std::span<const FacetRef> facets) {
  const auto id = static_cast<std::uint32_t>(large_polygon_count());
  if (polygon_of_.empty()) polygon_of_.resize(4 * std::size_t{delaunay_.finite_count});
  const auto mark = [this, id](FacetRef facet) {
    flags_[facet.cell] = static_cast<std::uint16_t>(flags_[facet.cell] | (16u << facet.index));
    polygon_of_[facet.packed()] = id;
  };
  for (const FacetRef facet : facets) {
    mark(facet);
    const FacetRef mirror = delaunay_.mirror(facet);
    if (delaunay_.is_finite(mirror.cell)) mark(mirror);
    polygon_facets_.push_back(facet);
  }
  polygon_first_.push_back(polygon_facets_.size());
}

Sign VoronoiComplex::side(FacetRef facet) const {
  FLOWCERT_REQUIRES(delaunay_.is_finite(facet.cell));
  const TetrahedronSigns& signs = signs_[facet.cell];
  const unsigned bit = 1u << facet.index;
  if ((signs.side_negative & bit) != 0) return Sign::kNegative;
  if ((signs.side_zero & bit) != 0) return Sign::kZero;
  if ((signs.side_open & bit) != 0) return side_exactly(points_of(facet.cell), facet.index);
  return Sign::kPositive;
}

VoronoiComplex::FacetRole VoronoiComplex::role(FacetRef facet) const {
  FLOWCERT_REQUIRES(delaunay_.is_finite(facet.cell));
  if (flags_.empty()) return FacetRole::kWhole;
  const unsigned flags = flags_[facet.cell] >> facet.index;
  if ((flags & 1u) != 0) return FacetRole::kInterior;
  return (flags & 16u) != 0 ? FacetRole::kPiece : FacetRole::kWhole;
}

PolygonSides sides_of(const VoronoiComplex& complex, std::span<const FacetRef> polygon) {
  boost::container::small_vector<PolygonSide, 12> edges;  // of up to four facets
  for (const FacetRef facet : polygon) {
    const auto& vertices = complex.delaunay().vertices(facet.cell);
    const TetrahedronSigns& signs = complex.signs(facet.cell);
    for (std::uint32_t j = 0; j < 4; ++j) {
      if (j == facet.index) continue;
      const auto [k, l] = other_two(j, facet.index);
      edges.push_back(
          {std::min(vertices[k], vertices[l]), std::max(vertices[k], vertices[l]), signs.angle(facet.index, j)});
    }
  }
  // A diagonal is an edge of two facets.
  std::ranges::sort(edges, {}, &PolygonSide::facet);
  PolygonSides sides;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const bool twin_before = k > 0 && edges[k].facet() == edges[k - 1].facet();
    const bool twin_after = k + 1 < edges.size() && edges[k].facet() == edges[k + 1].facet();
    if (!twin_before && !twin_after) sides.push_back(edges[k]);
  }
  return sides;
}

}  // namespace flowcert::voronoi
