// The Delaunay triangulation of a point set.
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

// CGAL's Delaunay_triangulation_3, spatially sorted, with the signs of delaunay_signs.h. It is behind a wall because
// CGAL's headers are slow to compile. Where points are cospherical, the triangulation is one of several; no result of
// this library depends on which (spec clause FC-VOR-04).
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

}  // namespace flowcert
