// All stationary points of the distance function of a finite point set, from the definitions alone.
//
// stationary_points() tries every subset of at most four points and scans all points for each. It needs no
// triangulation and no Voronoi diagram, so nothing can go wrong in a degenerate case. It takes time n^5 and is meant
// for small sets. certify() judges one claimed stationary point of a set of any size, by one scan over all points.
// Both are exact. spec/flow_complex.md has the clauses (FC-...).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "oracle/point_set.h"

namespace oracle {

// The point is critical iff face_dimension == hull_dimension, and that is its index (FC-CRIT-02). Otherwise it is
// regular stationary, and (face_dimension, hull_dimension) is its kind (FC-CRIT-03).
struct StationaryPoint {
  Point center;
  Rational squared_distance;
  std::vector<std::size_t> contact;  // class names, ascending
  int face_dimension = 0;
  int hull_dimension = 0;

  bool is_critical() const { return face_dimension == hull_dimension; }
  friend bool operator==(const StationaryPoint&, const StationaryPoint&) = default;
};

struct Answer {
  std::size_t points = 0;  // before merging
  std::size_t merged_duplicates = 0;
  std::vector<StationaryPoint> stationary;  // in the order of FC-OUT-02

  std::size_t count(int face_dimension, int hull_dimension) const;
  std::array<std::size_t, 4> critical_counts() const;
  std::array<std::size_t, 3> regular_counts() const;  // of kinds 1-2, 1-3, 2-3
};

Answer stationary_points(const PointSet& set);
Answer stationary_points(const std::vector<std::array<double, 3>>& rows);

// The stationary point x. `contact` is C(x).
StationaryPoint stationary_point(const PointSet& set, const Point& x, const Places& contact);

// What is wrong with a claim: the violated clause, and what is claimed and true instead.
struct Fault {
  std::string clause;
  std::string explanation;
};

// The first thing that is wrong with a claimed stationary point, or nothing if all of it is right.
std::optional<Fault> certify(const PointSet& set, const StationaryPoint& claim);

}  // namespace oracle
