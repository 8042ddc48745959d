// The Delaunay triangulation as plain arrays: what everything after CGAL works on.
//
// Guarantees: finite cells come first. In dimension 3 the vertices of a finite cell are positively oriented and not
// coplanar. In dimension 2 (1) cells are triangles (edges), and the last one (two) entries of their arrays are
// kInfiniteVertex and kNoCell. Vertices are numbered along a space-filling curve and cells by their last vertex, so
// that neighbours are near in memory. Without that, half the time of a walk around an edge was cache misses.
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "flowcert/point_set.h"
#include "geometry/keep_unique.h"
#include "geometry/unset_vector.h"
#include "voronoi/delaunay.h"
#include "voronoi/layer.h"

namespace flowcert::voronoi {

using VertexIndex = std::uint32_t;
using CellIndex = std::uint32_t;

inline constexpr VertexIndex kInfiniteVertex = 0xffffffffu;
inline constexpr CellIndex kNoCell = 0xffffffffu;
// A cell and one of its facets fit 32 bits, and so do the numbers of all pieces of rings, up to 8 a cell (FacetRings).
inline constexpr std::size_t kMostCells = std::size_t{1} << 29;

// Facet i of a cell: the one opposite its vertex i. In dimension 2, edge i of a triangle.
struct FacetRef {
  CellIndex cell;
  std::uint32_t index;

  // As one number, which fits (kMostCells).
  [[nodiscard]] std::uint32_t packed() const { return 4 * cell + index; }
  [[nodiscard]] static FacetRef unpacked(std::uint32_t packed) { return {packed / 4, packed % 4}; }

  friend auto operator<=>(const FacetRef&, const FacetRef&) = default;
};

// Which of the four entries of a cell is this one. It has no branches, because that cannot be guessed.
[[nodiscard]] inline std::uint32_t place_among(const std::array<std::uint32_t, 4>& entries, std::uint32_t entry) {
#if defined(__SSE2__)
  // Compares all four at once.
  const __m128i equal = _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(entries.data())),
                                        _mm_set1_epi32(static_cast<int>(entry)));
  const auto mask = static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(equal)));
  return static_cast<std::uint32_t>(std::countr_zero(mask | 8u));
#else
  return std::uint32_t{entries[1] == entry} + 2 * std::uint32_t{entries[2] == entry} +
         3 * std::uint32_t{entries[3] == entry};
#endif
}

// The six edges of a cell are numbered by the two places that they join.
inline constexpr std::uint8_t kEdgeBetween[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};

// The vertices of facet i of a positively oriented cell, counterclockwise seen from outside.
inline constexpr unsigned kOutward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// The places 0 to 3 of a cell other than i and j, ascending.
[[nodiscard]] constexpr std::array<std::uint32_t, 2> other_two(std::uint32_t i, std::uint32_t j) {
  const std::uint32_t k = i != 0 && j != 0 ? 0 : (i != 1 && j != 1 ? 1 : 2);
  return {k, 6 - i - j - k};
}

// Aligned, so that no cell lies in two lines of the cache.
struct alignas(32) DelaunayCell {
  std::array<VertexIndex, 4> vertices;
  std::array<CellIndex, 4> neighbors;  // [i]: across the facet opposite vertex i
};

struct CompactDelaunay {
  int dimension = -1;
  CellIndex finite_count = 0;
  geometry::UnsetVector<DelaunayCell> cells;
  std::vector<Point> points;            // by VertexIndex
  std::vector<std::uint32_t> ordinals;  // of the vertices in the point set

  [[nodiscard]] bool is_finite(CellIndex cell) const { return cell < finite_count; }
  [[nodiscard]] const std::array<VertexIndex, 4>& vertices(CellIndex cell) const { return cells[cell].vertices; }
  [[nodiscard]] const std::array<CellIndex, 4>& neighbors(CellIndex cell) const { return cells[cell].neighbors; }

  // The same facet (edge, in dimension 2), seen from the other cell.
  [[nodiscard]] FacetRef mirror(FacetRef facet) const {
    const CellIndex other = neighbors(facet.cell)[facet.index];
    return {other, place_among(neighbors(other), facet.cell)};
  }
};

// O(cells), one copy, and 8 bytes a cell meanwhile. The same for any number of threads.
[[nodiscard]] CompactDelaunay compact_copy(const Delaunay& delaunay, unsigned threads = 1);

}  // namespace flowcert::voronoi
