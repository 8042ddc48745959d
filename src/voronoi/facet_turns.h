// How the vertices of a cell lie in its neighbour across a facet. With that, a walk from cell to cell compares no
// vertices.
//
// Guarantees: a facet's three vertices and the vertex behind it, in the cell, are mapped to the places of the same
// three and of the vertex on the other side, in the neighbour. Both cells must be positively oriented. That leaves
// twelve possibilities: four facets of the neighbour, in three rotations.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "voronoi/compact_delaunay.h"

namespace flowcert::voronoi {

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

  std::vector<std::uint16_t> codes_;  // four bits a facet
};

}  // namespace flowcert::voronoi
