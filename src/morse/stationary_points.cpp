// All stationary points, read off the signs of the merged Voronoi complex (spec section 6).
//
// Guarantees: exact. Each stationary point is found once: index 1 from its Delaunay edge, index 2 and kind 1-2 from
// its polygon, index 3, 2-3 and 1-3 from its Voronoi vertex.
#include "flowcert/stationary_points.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "geometry/portions.h"
#include "morse/layer.h"
#include "morse/ordered_records.h"
#include "morse/record_finder.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr StationaryIndex kIndex1{1, 1}, kIndex2{2, 2}, kIndex3{3, 3};
constexpr StationaryIndex kKind12{1, 2}, kKind13{1, 3}, kKind23{2, 3};

// The cells that a thread looks at: first to last - 1, all finite.
struct CellRange {
  CellIndex first, last;
};

// The facets of a cell beyond which a later cell lies: bit i. Infinite cells come last.
unsigned later_facets(const CompactDelaunay& delaunay, CellIndex cell) {
  unsigned later = 0;
  for (unsigned i = 0; i < 4; ++i) later |= static_cast<unsigned>(delaunay.neighbors(cell)[i] > cell) << i;
  return later;
}

// Index 1 (FC-SIGN-02). A walk goes around each edge whose angles in its first cell are acute. It gives up at the
// first angle that is not acute, or at an earlier cell, because that cell has the walk around the edge. The walks of
// a block of cells go in step, each one cell a round, so that they wait for memory together and not one after the
// other. Which of them go on cannot be guessed, so that a round has no branch for it.
class GabrielSearch {
 public:
  explicit GabrielSearch(const VoronoiComplex& complex)
      : complex_(complex), delaunay_(complex.delaunay()), acute_(delaunay_.cells.size(), kAllEdges) {}

  // To be called for all cells before the search begins.
  void look_at_angles(CellRange cells) {
    for (CellIndex cell = cells.first; cell < cells.last; ++cell) acute_[cell] = acute_edges(complex_.signs(cell));
  }

  // All edges whose first cell is among these.
  void find(CellRange cells, OrderedRecords& records) const {
    constexpr CellIndex kBlock = 64;
    std::array<Walk, 6 * kBlock + 1> walks, done;  // one more, because the last one may be written and not counted
    for (CellIndex first = cells.first; first < cells.last; first += kBlock) {
      std::size_t count = 0, done_count = 0;
      for (CellIndex cell = first; cell < std::min(first + kBlock, cells.last); ++cell) {
        for (unsigned edges = acute_[cell] & edges_between(later_facets(delaunay_, cell)); edges != 0;
             edges &= edges - 1) {
          const auto [i, j] = kFacetsAt[std::countr_zero(edges)];
          walks[count++] = behind(cell, cell, i, j);
        }
      }
      while (count > 0) {
        std::size_t left = 0;
        for (std::size_t k = 0; k < count; ++k) {
          const Walk walk = walks[k];
          done[done_count] = walk;
          done_count += walk.cell == walk.start ? 1 : 0;
          walks[left] = behind(walk.start, walk.cell, walk.exit, walk.entry);
          left += static_cast<unsigned>(walk.cell > walk.start) &
                  (acute_[walk.cell] >> kEdgeBetween[walk.entry][walk.exit]) & 1u;
        }
        count = left;
      }
      for (std::size_t k = 0; k < done_count; ++k) {
        const auto& vertices = delaunay_.vertices(done[k].start);
        const auto [v, w] = other_two(done[k].entry, done[k].exit);
        records.add(kIndex1, std::array{vertices[v], vertices[w]}, face_number(done[k].start));
      }
    }
  }

 private:
  // The next cell, the facet through which it is entered, and the other one that has the edge.
  struct Walk {
    CellIndex start;
    CellIndex cell;
    std::uint8_t entry, exit;
  };

  // Bit kEdgeBetween[i][j] is the edge that facets i and j of the cell share.
  // An infinite cell has no angle that could object.
  static constexpr std::uint8_t kAllEdges = 0x3f;

  // The edges of a cell whose two angles in the cell are both acute. They take a byte a cell, so that the walks find
  // most of what they ask in the cache.
  static std::uint8_t acute_edges(const TetrahedronSigns& signs) {
    const unsigned acute = ~(unsigned{signs.angle_negative} | unsigned{signs.angle_zero});
    unsigned edges = 0;
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = i + 1; j < 4; ++j) {
        const unsigned both =
            (acute >> TetrahedronSigns::angle_bit(i, j)) & (acute >> TetrahedronSigns::angle_bit(j, i));
        edges |= (both & 1u) << kEdgeBetween[i][j];
      }
    }
    return static_cast<std::uint8_t>(edges);
  }

  static constexpr std::uint8_t kFacetsAt[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

  // The edges that two of these facets share.
  static unsigned edges_between(unsigned facets) {
    unsigned edges = 0;
    for (unsigned e = 0; e < 6; ++e) edges |= (facets >> kFacetsAt[e][0] & facets >> kFacetsAt[e][1] & 1u) << e;
    return edges;
  }

  // The walk around the edge of facets `exit` and `entry`, when it has left the cell.
  [[nodiscard]] Walk behind(CellIndex start, CellIndex cell, unsigned exit, unsigned entry) const {
    const CellIndex next = delaunay_.neighbors(cell)[exit];
    __builtin_prefetch(&delaunay_.cells[next]);
    const PlacesBeyond places = complex_.places_beyond({cell, exit});
    return {start, next, static_cast<std::uint8_t>(places[exit]), static_cast<std::uint8_t>(places[entry])};
  }

  const VoronoiComplex& complex_;
  const CompactDelaunay& delaunay_;
  std::vector<std::uint8_t> acute_;
};

// Whether the polygon's centre lies in the relative interior of its Voronoi edge: s > 0 at each end that
// exists.
bool is_between_ends(const VoronoiComplex& complex, FacetRef facet) {
  if (complex.side(facet) != Sign::kPositive) return false;
  const FacetRef mirror = complex.mirror(facet);
  return !complex.delaunay().is_finite(mirror.cell) || complex.side(mirror) == Sign::kPositive;
}

// Adds index 2 and kind 1-2 from polygons of one facet. Where a facet is not obtuse, its sides are known without more
// work, because nothing is left open there.
void add_whole_facets(const VoronoiComplex& complex, CellRange cells, OrderedRecords& records) {
  const CompactDelaunay& delaunay = complex.delaunay();
  for (CellIndex cell = cells.first; cell < cells.last; ++cell) {
    const TetrahedronSigns& signs = complex.signs(cell);
    for (unsigned facets = signs.inner_facets() & later_facets(delaunay, cell); facets != 0; facets &= facets - 1) {
      const FacetRef facet{cell, static_cast<std::uint32_t>(std::countr_zero(facets))};
      const FacetRef mirror = complex.mirror(facet);
      if (delaunay.is_finite(mirror.cell) && !complex.signs(mirror.cell).has_positive_side(mirror.index)) continue;
      if (complex.role(facet) != VoronoiComplex::FacetRole::kWhole) continue;
      const auto& v = delaunay.vertices(cell);
      const std::uint32_t i = facet.index;
      const std::array<VertexIndex, 3> contact{v[(i + 1) & 3], v[(i + 2) & 3], v[(i + 3) & 3]};
      records.add(signs.is_right(i) ? kKind12 : kIndex2, contact, face_number(facet));
    }
  }
}

// The polygon's shape, from its sides. It is negative if the polygon does not contain its centre, zero if the
// centre is the middle of a side.
Sign least_angle(const PolygonSides& sides) {
  Sign least = Sign::kPositive;
  for (const PolygonSide& side : sides) least = std::min(least, side.angle);
  return least;
}

// Adds index 2 and kind 1-2 from polygons of several facets.
void add_large_polygons(const VoronoiComplex& complex, OrderedRecords& records) {
  std::vector<VertexIndex> contact;
  for (std::size_t k = 0; k < complex.large_polygon_count(); ++k) {
    const auto polygon = complex.large_polygon(k);
    const PolygonSides sides = sides_of(complex, polygon);
    const Sign shape = least_angle(sides);
    if (shape == Sign::kNegative || !is_between_ends(complex, polygon.front())) continue;
    contact.clear();
    for (const PolygonSide& side : sides) contact.push_back(side.v0), contact.push_back(side.v1);
    keep_unique(contact);
    records.add(shape == Sign::kZero ? kKind12 : kIndex2, contact, face_number(polygon.front()));
  }
}

void add_vertex(std::size_t zero_sides, std::span<const VertexIndex> contact, CellIndex cluster,
                OrderedRecords& records) {
  records.add(zero_sides == 0 ? kIndex3 : zero_sides == 1 ? kKind23 : kKind13, contact, face_number(cluster));
}

// Adds index 3 and kinds 2-3 and 1-3 from Voronoi vertices of one cell (FC-SIGN-03, 04).
void add_lone_vertices(const VoronoiComplex& complex, CellRange cells, OrderedRecords& records) {
  const CompactDelaunay& delaunay = complex.delaunay();
  for (CellIndex cell = cells.first; cell < cells.last; ++cell) {
    if (complex.signs(cell).side_negative != 0 || !complex.is_alone(cell)) continue;
    std::size_t zeros = 0;
    bool is_inside = true;
    for (std::uint32_t i = 0; i < 4 && is_inside; ++i) {
      const Sign side = complex.side({cell, i});
      is_inside = side != Sign::kNegative;
      zeros += side == Sign::kZero ? 1 : 0;
    }
    if (is_inside) add_vertex(zeros, delaunay.vertices(cell), cell, records);
  }
}

// The number of polygons of a cluster with s = 0, or nothing where some s is negative.
std::optional<std::size_t> zero_sides(const VoronoiComplex& complex, std::span<const CellIndex> cluster) {
  std::size_t whole = 0;
  std::vector<std::size_t> large;
  for (const CellIndex cell : cluster) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto role = complex.role({cell, i});
      if (role == VoronoiComplex::FacetRole::kInterior) continue;
      const Sign side = complex.side({cell, i});
      if (side == Sign::kNegative) return std::nullopt;
      if (side == Sign::kPositive) continue;
      if (role == VoronoiComplex::FacetRole::kWhole) {
        ++whole;
      } else {
        large.push_back(complex.large_polygon_of({cell, i}));
      }
    }
  }
  std::sort(large.begin(), large.end());
  return whole + static_cast<std::size_t>(std::unique(large.begin(), large.end()) - large.begin());
}

// Adds index 3 and kinds 2-3 and 1-3 from Voronoi vertices of several cells.
void add_clusters(const VoronoiComplex& complex, OrderedRecords& records) {
  std::vector<VertexIndex> contact;
  for (std::size_t k = 0; k < complex.large_cluster_count(); ++k) {
    const auto cluster = complex.large_cluster(k);
    const auto zeros = zero_sides(complex, cluster);
    if (!zeros) continue;
    contact.clear();
    for (const CellIndex cell : cluster) {
      const auto& v = complex.delaunay().vertices(cell);
      contact.insert(contact.end(), v.begin(), v.end());
    }
    keep_unique(contact);
    add_vertex(*zeros, contact, complex.cluster(cluster.front()), records);
  }
}

// Threads take parts of the cells, and each has records of its own.
void add_spatial(const VoronoiComplex& complex, unsigned threads, const Progress& progress, OrderedRecords& records) {
  const CellIndex count = complex.delaunay().finite_count;
  constexpr auto kPart = static_cast<CellIndex>(geometry::portion_size(1u << 14));
  const std::size_t parts = (count + kPart - 1) / kPart;
  const auto cells_of = [count](std::size_t k) {
    const auto first = static_cast<CellIndex>(k) * kPart;
    return CellRange{first, std::min(first + kPart, count)};
  };
  GabrielSearch gabriel(complex);
  geometry::parallel_for(parts, threads, [&](std::size_t k) { gabriel.look_at_angles(cells_of(k)); });
  threads = std::max(threads, 1U);
  std::vector<OrderedRecords> found;
  found.reserve(threads);
  for (unsigned thread = 0; thread < threads; ++thread) found.push_back(records.empty_part(threads));
  geometry::in_portions(threads, parts, 1, progress, [&](std::size_t thread, std::size_t k) {
    gabriel.find(cells_of(k), found[thread]);
    add_whole_facets(complex, cells_of(k), found[thread]);
    add_lone_vertices(complex, cells_of(k), found[thread]);
  });
  for (OrderedRecords& part : found) records.take(std::move(part));
  add_large_polygons(complex, records);
  add_clusters(complex, records);
}

// Coplanar input: an edge is Gabriel iff the one or two angles that see it are acute. A Voronoi edge has no end, so a
// polygon's centre is never beyond one.
void add_planar(const PlanarComplex& complex, OrderedRecords& records) {
  const CompactDelaunay& delaunay = complex.delaunay();
  for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const FacetRef across = delaunay.mirror({cell, i});
      if (across.cell < cell || complex.angle(cell, i) != Sign::kPositive) continue;
      if (delaunay.is_finite(across.cell) && complex.angle(across.cell, across.index) != Sign::kPositive) continue;
      const auto& v = delaunay.vertices(cell);
      const std::array<VertexIndex, 2> edge{v[(i + 1) % 3], v[(i + 2) % 3]};
      records.add(kIndex1, edge, face_number(cell));
    }
  }
  std::vector<VertexIndex> contact;
  for (const auto& polygon : complex.polygons()) {
    Sign shape = Sign::kPositive;
    contact.clear();
    for (const CellIndex cell : polygon) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        contact.push_back(delaunay.vertices(cell)[i]);
        if (!complex.is_diagonal({cell, i})) shape = std::min(shape, complex.angle(cell, i));
      }
    }
    if (shape == Sign::kNegative) continue;
    keep_unique(contact);
    records.add(shape == Sign::kZero ? kKind12 : kIndex2, contact, face_number(FacetRef{polygon.front(), 3}));
  }
}

// Collinear input: the edges between neighbours on the line are Gabriel.
void add_collinear(const CompactDelaunay& delaunay, OrderedRecords& records) {
  for (CellIndex cell = 0; cell < delaunay.finite_count; ++cell) {
    records.add(kIndex1, std::span(delaunay.vertices(cell)).first(2), face_number(cell));
  }
}

}  // namespace

long long StationaryPoints::euler_sum() const {
  const auto count = [this](std::size_t k) { return static_cast<long long>(critical_[k]); };
  return count(0) - count(1) + count(2) - count(3);
}

StationaryPoints stationary_points(const VoronoiDiagram& voronoi, unsigned threads, const Progress& progress) {
  const geometry::IeeeDoubles ieee;
  const VoronoiDiagram& diagram = voronoi;
  OrderedRecords records(diagram.delaunay().ordinals);
  if (diagram.spatial() != nullptr) {
    add_spatial(*diagram.spatial(), threads, progress, records);
  } else if (diagram.planar() != nullptr) {
    add_planar(*diagram.planar(), records);
  } else if (diagram.dimension() == 1) {
    add_collinear(diagram.delaunay(), records);
  }
  return records.list(voronoi.points(), threads);
}

}  // namespace flowcert
