// See planar_complex.h.
#include "voronoi/planar_complex.h"

#include <utility>

#include "geometry/predicates.h"

namespace flowcert::voronoi {

PlanarComplex::PlanarComplex(CompactDelaunay delaunay, FilterTally& tally) : delaunay_(std::move(delaunay)) {
  const CellIndex count = delaunay_.finite_count;
  const auto point = [this](CellIndex cell, std::uint32_t i) -> const Point& {
    return delaunay_.points[delaunay_.vertices(cell)[i]];
  };
  angles_.resize(count);
  for (CellIndex cell = 0; cell < count; ++cell) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      angles_[cell][i] =
          exact_sign(Angle{point(cell, (i + 1) % 3), point(cell, i), point(cell, (i + 2) % 3)}, tally);
    }
  }

  // Triangles joined across cocircular edges, gathered by walking from each triangle that has no polygon yet.
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

}  // namespace flowcert::voronoi
