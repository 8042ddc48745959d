// The merged Voronoi complexes: of a point set that spans R^3, and of a coplanar one.
//
// Guarantees: exact; their faces are those of the Voronoi diagram, whatever way the triangulation cuts
// cospherical sets (spec clauses FC-VOR-01 to 04).
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "flowcert/filter_tally.h"
#include "geometry/tetrahedron_lanes.h"
#include "geometry/tetrahedron_signs.h"
#include "geometry/vector3.h"
#include "voronoi/compact_delaunay.h"

namespace flowcert::voronoi {

// ---- Coplanar points ----
// Delaunay triangles are gathered into cocircular polygons, each dual to a line of centres. The signs of the
// triangles' angles are kept, too. The plane may be any plane of R^3.

class PlanarComplex {
 public:
  // dimension 2. O(triangles log triangles).
  PlanarComplex(CompactDelaunay delaunay, FilterTally& tally);

  [[nodiscard]] const CompactDelaunay& delaunay() const { return delaunay_; }
  // The angle of a finite triangle at its vertex i, opposite its edge i (FC-SIGN-01).
  [[nodiscard]] Sign angle(CellIndex triangle, std::uint32_t i) const { return angles_[triangle][i]; }
  // Whether edge i of a finite triangle is a diagonal, with a triangle of the same polygon on its other side.
  [[nodiscard]] bool is_diagonal(FacetRef edge) const;
  // Which polygon a finite triangle belongs to.
  [[nodiscard]] std::uint32_t polygon_of(CellIndex triangle) const { return polygon_of_[triangle]; }
  // The triangles of each polygon.
  [[nodiscard]] const std::vector<std::vector<CellIndex>>& polygons() const { return polygons_; }

 private:
  CompactDelaunay delaunay_;
  std::vector<std::array<Sign, 3>> angles_;
  std::vector<std::uint32_t> polygon_of_;
  std::vector<std::vector<CellIndex>> polygons_;
};

// ---- Turns ----
// How the vertices of a cell lie in its neighbour across a facet. With that, a walk from cell to cell compares no
// vertices. A facet's three vertices and the vertex behind it, in the cell, are mapped to the places of the same three
// and of the vertex on the other side, in the neighbour. Both cells must be positively oriented. That leaves twelve
// possibilities: four facets of the neighbour, in three rotations.

// Where each place of a cell lies in its neighbour, two bits each.
class PlacesBeyond {
 public:
  constexpr PlacesBeyond() = default;
  constexpr void set(unsigned place, unsigned beyond) {
    packed_ = static_cast<std::uint8_t>(packed_ | beyond << (2 * place));
  }
  [[nodiscard]] constexpr unsigned operator[](unsigned place) const { return (packed_ >> (2 * place)) & 3u; }

 private:
  std::uint8_t packed_ = 0;
};

// A code is the neighbour's facet, and the place in its outward order of the first vertex in the cell's.
using TurnTable = std::array<std::array<unsigned, 4>, 4>;
using PlacesTable = std::array<std::array<PlacesBeyond, 16>, 4>;
constexpr TurnTable make_turns() {
  TurnTable turns{};
  for (unsigned mirror = 0; mirror < 4; ++mirror) {
    for (unsigned turn = 0; turn < 3; ++turn) turns[mirror][kOutward[mirror][turn]] = turn;
  }
  return turns;
}
// The outward orders of the two cells go around the facet in opposite directions.
constexpr PlacesTable make_places() {
  PlacesTable places{};
  for (unsigned facet = 0; facet < 4; ++facet) {
    for (unsigned code = 0; code < 12; ++code) {
      const unsigned mirror = code & 3u, turn = code >> 2;
      PlacesBeyond& beyond = places[facet][code];
      beyond.set(facet, mirror);
      for (unsigned k = 0; k < 3; ++k) beyond.set(kOutward[facet][k], kOutward[mirror][(turn + 3 - k) % 3]);
    }
  }
  return places;
}
inline constexpr TurnTable kTurn = make_turns();
inline constexpr PlacesTable kPlaces = make_places();

class FacetTurns {
 public:
  // Looks across all facets of a cell.
  void look(const CompactDelaunay& delaunay, CellIndex cell) {
    const auto& [vertices, neighbors] = delaunay.cells[cell];
    unsigned codes = 0;
    for (unsigned facet = 0; facet < 4; ++facet) {
      const auto& [vertices_beyond, neighbors_beyond] = delaunay.cells[neighbors[facet]];
      const unsigned mirror = place_among(neighbors_beyond, cell);
      const unsigned first = place_among(vertices_beyond, vertices[kOutward[facet][0]]);
      codes |= (mirror | kTurn[mirror][first] << 2) << (4 * facet);
    }
    codes_[cell] = static_cast<std::uint16_t>(codes);
  }
  void resize(std::size_t cells) { codes_.resize(cells); }

  [[nodiscard]] unsigned mirror(FacetRef facet) const { return code(facet) & 3u; }
  [[nodiscard]] PlacesBeyond places_beyond(FacetRef facet) const { return kPlaces[facet.index][code(facet)]; }

 private:
  [[nodiscard]] unsigned code(FacetRef facet) const { return (codes_[facet.cell] >> (4 * facet.index)) & 15u; }

  geometry::UnsetVector<std::uint16_t> codes_;  // four bits a facet
};

// ---- Points that span R^3 ----
// Delaunay cells are gathered into Voronoi vertices, and their facets into the polygons dual to Voronoi edges and
// rays, with the signs that decide what is critical. Where nothing is cospherical, this adds a few bytes a cell to
// the triangulation and no list at all: a cell alone in its cluster, and a facet alone in its polygon, are named by
// themselves.
class VoronoiComplex {
 public:
  // dimension 3. O(cells), plus sorting what is cospherical. The same for any number of threads. The progress is how
  // many cells are begun, and of how many.
  VoronoiComplex(CompactDelaunay delaunay, FilterTally& tally, unsigned threads = 1, const Progress& progress = {});

  [[nodiscard]] const CompactDelaunay& delaunay() const { return delaunay_; }
  // The signs of a finite cell.
  [[nodiscard]] const TetrahedronSigns& signs(CellIndex cell) const { return signs_[cell]; }
  // The facet of a cell, seen from the other cell. It is cheaper than CompactDelaunay::mirror(), which has to look at
  // the other cell.
  [[nodiscard]] FacetRef mirror(FacetRef facet) const {
    return {delaunay_.neighbors(facet.cell)[facet.index], turns_.mirror(facet)};
  }
  // How the places of a cell lie in its neighbour. Either may be infinite.
  [[nodiscard]] PlacesBeyond places_beyond(FacetRef facet) const { return turns_.places_beyond(facet); }
  // s(o, f) of the facet seen from its cell (FC-SIGN-03), resolved where it is still open.
  [[nodiscard]] Sign side(FacetRef facet) const;

  // Voronoi vertices: a cluster is named by one of its cells; cells that are alone are their own cluster.
  [[nodiscard]] CellIndex cluster(CellIndex cell) const { return cluster_.empty() ? cell : cluster_[cell]; }
  [[nodiscard]] bool is_alone(CellIndex cell) const { return flags_.empty() || (flags_[cell] & kAlone) != 0; }
  // Nothing is cospherical: all cells are alone, and all facets are polygons.
  [[nodiscard]] bool is_plain() const { return flags_.empty(); }
  // The clusters of two cells and more.
  [[nodiscard]] std::size_t large_cluster_count() const { return cluster_first_.size() - 1; }
  [[nodiscard]] std::span<const CellIndex> large_cluster(std::size_t k) const {
    return std::span(cluster_cells_).subspan(cluster_first_[k], cluster_first_[k + 1] - cluster_first_[k]);
  }
  // The cluster of a cell that is not alone. O(log of the number of such clusters).
  [[nodiscard]] std::span<const CellIndex> large_cluster_of(CellIndex cell) const;

  // What a finite cell's facet is: inside a cluster, a polygon by itself, or one of several that make up a
  // polygon.
  enum class FacetRole : std::uint8_t { kInterior, kWhole, kPiece };
  [[nodiscard]] FacetRole role(FacetRef facet) const;

  // The polygons of two facets and more. All facets of a polygon are given from the side of the same cluster.
  [[nodiscard]] std::size_t large_polygon_count() const { return polygon_first_.size() - 1; }
  [[nodiscard]] std::span<const FacetRef> large_polygon(std::size_t k) const {
    return std::span(polygon_facets_).subspan(polygon_first_[k], polygon_first_[k + 1] - polygon_first_[k]);
  }
  // The polygon that a piece belongs to; the piece may be given from either side.
  [[nodiscard]] std::size_t large_polygon_of(FacetRef facet) const { return polygon_of_[facet.packed()]; }

 private:
  // flags_[cell]: bit i, facet i is interior; bit 4 + i, facet i is a piece; kAlone.
  static constexpr std::uint16_t kAlone = 1u << 8;

  void compute_signs(FilterTally& tally, unsigned threads, const Progress& progress);
  struct Found {
    std::vector<FacetRef> cospherical;
    FilterTally tally;
  };
  void compute_signs_of(CellIndex first, CellIndex last, TetrahedronLanes& lanes, Found& found);
  // The finite cells beyond facets of a cell that come later (bit i), and their vertices behind these facets.
  struct Beyond {
    unsigned later;
    std::array<VertexIndex, 4> samples;
  };
  Beyond look_across(CellIndex cell);
  void prefetch_neighbors(CellIndex cell) const;
  void gather_clusters(std::span<const FacetRef> cospherical);
  void gather_inner_polygons();
  void gather_hull_polygons(FilterTally& tally);
  void add_polygons(std::span<std::pair<std::uint32_t, FacetRef>> pieces);
  void add_polygon(std::span<const FacetRef> facets);
  [[nodiscard]] TetrahedronPoints points_of(CellIndex cell) const;

  CompactDelaunay delaunay_;
  geometry::UnsetVector<TetrahedronSigns> signs_;
  FacetTurns turns_;
  std::vector<CellIndex> cluster_;    // empty: all cells are alone
  std::vector<std::uint16_t> flags_;  // empty: all cells are alone
  std::vector<std::size_t> cluster_first_{0};
  std::vector<CellIndex> cluster_cells_;
  std::vector<std::size_t> polygon_first_{0};
  std::vector<FacetRef> polygon_facets_;
  std::vector<std::uint32_t> polygon_of_;  // by packed facet; empty where no polygon is large
};

// Names a Voronoi facet by the ends of its Delaunay edge.
struct FacetName {
  VertexIndex v0, v1;  // v0 < v1

  friend auto operator<=>(const FacetName&, const FacetName&) = default;
};

[[nodiscard]] inline FacetName facet_name(VertexIndex v, VertexIndex w) {
  return v < w ? FacetName{v, w} : FacetName{w, v};
}

// A side of a large polygon: an edge of exactly one of its facets.
struct PolygonSide {
  VertexIndex v0, v1;  // v0 < v1
  Sign angle;          // h at the polygon's other vertices, all the same (FC-SIGN-01)

  [[nodiscard]] FacetName facet() const { return {v0, v1}; }
};
// Most polygons are triangles or quadrilaterals, and their sides take no memory of their own.
using PolygonSides = boost::container::small_vector<PolygonSide, 4>;
// In no particular order.
[[nodiscard]] PolygonSides sides_of(const VoronoiComplex& complex, std::span<const FacetRef> polygon);

}  // namespace flowcert::voronoi
