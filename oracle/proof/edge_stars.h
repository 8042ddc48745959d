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

  // Goes around the edge, from the cell towards its vertex at the place `ahead`. Returns whether it comes back, and does
  // not end at the hull. The cell and the places are then the last ones.
  const auto go_around = [&](std::uint32_t& cell, Facet& ahead, Facet& behind) {
    star.spokes.clear();
    const std::uint32_t first = cell;
    do {
      const Simplex& v = t.cells[cell];
      const Id pivot = v[ahead];
      seen[cell] =
          static_cast<std::uint16_t>(seen[cell] | 1U << (4 * std::min(ahead, behind) + std::max(ahead, behind)));
      star.spokes.push_back({v[behind], 4 * cell + ahead, cell});
      const Facet mate = t.mates[cell][behind];
      if (mate == kHull) {
        star.spokes.push_back({pivot, 4 * cell + behind, kNone});
        return false;
      }
      cell = mate / 4;
      ahead = mate % 4;
      for (behind = 0; t.cells[cell][behind] != pivot;) ++behind;
    } while (cell != first);
    return true;
  };

  for (std::uint32_t cell = 0; cell < t.cells.size(); ++cell) {
    const Simplex& v = t.cells[cell];
    for (Facet i = 0; i < t.places(); ++i) {
      for (Facet j = i + 1; j < t.places(); ++j) {
        star.edge = {std::min(v[i], v[j]), std::max(v[i], v[j]), kNone, kNone};
        star.spokes.clear();
        if (t.dimension == 2) {
          const Facet facet = 4 * cell + 3 - i - j, mate = t.mate(facet);
          if (mate < facet) continue;
          star.spokes.push_back({t.opposite(facet), 4 * cell + 3, kNone});
          if (mate != kHull) star.spokes.push_back({t.opposite(mate), mate / 4 * 4 + 3, kNone});
        } else if (t.dimension == 3) {
          Facet other = i > 0 ? 0 : j > 1 ? 1 : 2, last = 6 - i - j - other;
          if ((seen[cell] >> (4 * other + last) & 1) != 0) continue;
          std::uint32_t at = cell;
          if (!go_around(at, other, last)) go_around(at, last, other);
        }
        visit(star);
      }
    }
  }
}
