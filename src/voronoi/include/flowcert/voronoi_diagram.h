// The Delaunay triangulation of a point set, and its Voronoi diagram.
//
// Guarantees: exact, for every finite set of doubles.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>

#include "flowcert/filter_tally.h"
#include "flowcert/point_set.h"
#include "flowcert/progress.h"

namespace flowcert {

// CGAL's Delaunay_triangulation_3 with exact predicates, spatially sorted. It is behind a wall because CGAL's headers
// are slow to compile. Where points are cospherical, the triangulation is one of several; no result of this library
// depends on which (spec clause FC-VOR-04).
class Delaunay {
 public:
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  // Expected O(n log n) for surface samples, O(n^2) at worst. The point set must outlive the triangulation. Throws
  // InvalidInput as soon as there are more than `most_cells` Delaunay cells.
  explicit Delaunay(const PointSet& points, const Progress& progress = {}, std::size_t most_cells = kAnyNumber);
  explicit Delaunay(PointSet&&, const Progress& = {}, std::size_t = kAnyNumber) = delete;
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  [[nodiscard]] const PointSet& points() const;
  // The dimension of the affine hull of the points: 0 to 3, -1 for no point.
  [[nodiscard]] int dimension() const;

  // What lies behind the wall; defined in src/voronoi/.
  struct Triangulation;
  [[nodiscard]] const Triangulation& triangulation() const { return *triangulation_; }

 private:
  std::unique_ptr<Triangulation> triangulation_;
};

namespace voronoi {
class Diagram;
}  // namespace voronoi

// The Voronoi diagram of a point set, in which cospherical cells are one Voronoi vertex. Everything after the
// triangulation is computed from it. Its faces are those of spec clauses FC-VOR-01 to 04, whatever way the
// triangulation cuts cospherical sets. It does not change once it is made, so threads may share it. It does not refer
// to the triangulation.
class VoronoiDiagram {
 public:
  // O(cells), and sorting what is cospherical. The point set must outlive the diagram; the triangulation need not.
  // The counts are added to the tally, if one is given. Two threads must not use one triangulation here at once,
  // because this numbers the triangulation's cells. The diagram is the same for any number of threads that make it.
  // The progress is not told of the end.
  explicit VoronoiDiagram(const Delaunay& delaunay, FilterTally* tally = nullptr, unsigned threads = 1,
                          const Progress& progress = {});
  ~VoronoiDiagram();
  VoronoiDiagram(VoronoiDiagram&&) noexcept;
  VoronoiDiagram& operator=(VoronoiDiagram&&) noexcept;

  [[nodiscard]] const PointSet& points() const { return *points_; }
  // The dimension of the affine hull of the points: 0 to 3, -1 for no point.
  [[nodiscard]] int dimension() const;
  // The triangulation has so many cells, infinite ones as well.
  [[nodiscard]] std::size_t delaunay_cells() const;

  // What lies behind the wall; defined in src/voronoi/.
  [[nodiscard]] const voronoi::Diagram& faces() const { return *faces_; }

 private:
  const PointSet* points_;
  std::unique_ptr<const voronoi::Diagram> faces_;
};

}  // namespace flowcert
