// The Voronoi diagram of a point set, in which what is cospherical is one Voronoi vertex: everything that is
// computed after the triangulation is computed from it.
//
// Guarantees: exact; its faces are those of spec clauses FC-VOR-01 to 04, whatever way the triangulation cuts
// cospherical sets. It does not change once it is made, so threads may share it. It does not refer to the
// triangulation.
#pragma once

#include <memory>

#include "flowcert/delaunay.h"
#include "flowcert/filter_tally.h"

namespace flowcert {

namespace voronoi {
class Diagram;
}  // namespace voronoi

class VoronoiDiagram {
 public:
  // O(cells), and sorting what is cospherical. The point set must outlive the diagram; the triangulation need
  // not. The tally, if given, is added to. Not for one triangulation from two threads at once: it numbers the
  // triangulation's cells.
  explicit VoronoiDiagram(const Delaunay& delaunay, FilterTally* tally = nullptr);
  ~VoronoiDiagram();
  VoronoiDiagram(VoronoiDiagram&&) noexcept;
  VoronoiDiagram& operator=(VoronoiDiagram&&) noexcept;

  [[nodiscard]] const PointSet& points() const { return *points_; }
  // The dimension of the affine hull of the points: 0 to 3, -1 for no point.
  [[nodiscard]] int dimension() const;

  // What lies behind the wall; defined in src/voronoi/.
  [[nodiscard]] const voronoi::Diagram& faces() const { return *faces_; }

 private:
  const PointSet* points_;
  std::unique_ptr<const voronoi::Diagram> faces_;
};

}  // namespace flowcert
