// The edges of a proved triangulation, each with what is at it.
#pragma once

#include "certificate.h"

struct Spoke {         // of an edge
  Id link;             // a link vertex: a vertex of a cell at the edge
  Facet triangle;      // its triangle with the edge; in dimension 2, 4 * cell + 3
  std::uint32_t cell;  // dimension 3: the cell between this spoke and the next, or kNone on the hull
};
struct EdgeStar {
  Simplex edge;               // its ends ascend
  std::vector<Spoke> spokes;  // dimension 3: in order around the edge; the first one comes again after the last one
};

// Calls visit(star) once for each edge.
template <class Visit>
void for_each_edge(const Triangulation& t, const Visit& visit) {
  EdgeStar star;
  std::vector<std::uint16_t> seen(t.cells.size());  // by cell, one bit for the two places that an edge does not have
  const auto bit = [](Facet i, Facet j) { return static_cast<std::uint16_t>(1U << (1U << i | 1U << j)); };

  // Goes around the edge, from the cell towards its vertex at the place `ahead`. Returns whether it comes back, rather
  // than to the hull. Pairing is one to one, so that it ends. The cell and the places are then the last ones.
  const auto go_around = [&](std::uint32_t& cell, Facet& ahead, Facet& behind) {
    star.spokes.clear();
    const std::uint32_t first = cell;
    do {
      seen[cell] |= bit(ahead, behind);
      star.spokes.push_back({t.cells[cell][behind], 4 * cell + ahead, cell});
      const Id pivot = t.cells[cell][ahead];
      const Facet mate = t.mates[cell][behind];
      if (mate == kHull) star.spokes.push_back({pivot, 4 * cell + behind, kNone});
      if (mate == kHull) return false;
      cell = mate / 4;
      ahead = mate % 4;
      for (behind = 0; t.cells[cell][behind] != pivot;) ++behind;
    } while (cell != first);
    return true;
  };
  constexpr std::array<std::pair<Facet, Facet>, 6> kPlaces{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  for (std::uint32_t cell = 0; cell < t.cells.size(); ++cell) {
    for (std::size_t k = 0; k < 6; ++k) {
      const auto [i, j] = kPlaces[k];
      if (j >= t.places()) continue;
      const auto [p, q] = std::minmax(t.cells[cell][i], t.cells[cell][j]);
      star.edge = {p, q, kNone, kNone};
      star.spokes.clear();
      if (t.dimension == 2) {
        const Facet facet = 4 * cell + (3 - i - j), mate = t.mate(facet);
        if (mate < facet) continue;
        star.spokes.push_back({t.opposite(facet), 4 * cell + 3, kNone});
        if (mate != kHull) star.spokes.push_back({t.opposite(mate), mate / 4 * 4 + 3, kNone});
      } else if (t.dimension == 3) {
        auto [ahead, behind] = kPlaces[5 - k];  // the other two
        if ((seen[cell] & bit(ahead, behind)) != 0) continue;
        std::uint32_t last = cell;
        if (!go_around(last, ahead, behind)) go_around(last, behind, ahead);
      }
      visit(star);
    }
  }
}
