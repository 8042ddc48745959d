// The Delaunay triangulation of a point set, which everything fast is computed from: CGAL's
// Delaunay_triangulation_3 with exact predicates, spatially sorted, kept behind a wall because CGAL's headers
// are slow to compile.
//
// Guarantees: exact combinatorics for every finite set of doubles. Where points are cospherical the
// triangulation is one of several; no result of this library depends on which (spec clause FC-VOR-04).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "flowcert/point_set.h"

namespace flowcert {

class Delaunay {
 public:
  // Told now and then how much of the work is done; may throw to stop it.
  using Progress = std::function<void(std::size_t done, std::size_t total)>;

  // Expected O(n log n) for surface samples, O(n^2) at worst. The point set must outlive the triangulation.
  explicit Delaunay(const PointSet& points, const Progress& progress = {});
  explicit Delaunay(PointSet&&, const Progress& = {}) = delete;
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  [[nodiscard]] const PointSet& points() const;
  // Of the affine hull of the points: 0 to 3, -1 for no point.
  [[nodiscard]] int dimension() const;

  // What lies behind the wall; defined in src/voronoi/.
  struct Triangulation;
  [[nodiscard]] const Triangulation& triangulation() const { return *triangulation_; }

 private:
  std::unique_ptr<Triangulation> triangulation_;
};

}  // namespace flowcert
