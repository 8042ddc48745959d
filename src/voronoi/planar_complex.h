// The merged Voronoi complex of a coplanar point set: Delaunay triangles gathered into cocircular polygons,
// each dual to a line of centres, and the signs of their angles.
//
// Guarantees: exact; in any plane of R^3, tilted ones too (spec clauses FC-VOR-02 and 03, coplanar case).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flowcert/filter_tally.h"
#include "geometry/sign.h"
#include "voronoi/compact_delaunay.h"

namespace flowcert::voronoi {

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

}  // namespace flowcert::voronoi
