// The parameters of points of a division, in doubled doubles with bounds (division_parameter.h).
//
// Guarantees: a number differs from its value by no more than its bound. Where nothing is known, the bound is infinite.
// Lengths are in a unit that is a power of two, in which all differences of coordinates are at most 4. So nothing
// overflows, and what underflows is less than 2^-1000, which every bound includes.
//
// With δ the roundoff of doubled doubles, a sum of three products has an error of at most 2 δ times the product of
// the lengths of the two vectors, since each product has one of δ/2 and each sum less. The terms of ApexPair have at
// most two such factors more. So their errors are below 32 δ times the products of lengths that bound them; twice that
// is taken, for the lengths are rounded. Errors of given numbers pass through products and quotients as usual.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/bounded_sphere.h"
#include "morse/division_parameter.h"
#include "morse/limit_partition.h"

namespace flowcert::morse {

using geometry::BoundedNumber;
using geometry::DoubleDouble;

class BoundedDivisions {
 public:
  // Both must outlive it. All points are computed at once.
  BoundedDivisions(const VoronoiDiagram& diagram, const LimitPartition& partition);

  // All numbers are in units: lengths are divided by 2^unit().
  [[nodiscard]] int unit() const { return unit_; }
  // The parameter of a crossing or a centre for its own samples (ExactDivisions).
  [[nodiscard]] const BoundedNumber& parameter(PointOfDivision point) const { return parameters_[point]; }
  // The parameter of the circumcentre of a, b, c and w, for a, b and c.
  [[nodiscard]] BoundedNumber parameter_of_sphere(VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex w) const;
  // The doubles nearest to the position of a point that is not an end at infinity.
  // Nothing if the bounds leave one open.
  [[nodiscard]] std::optional<Point> rounded(PointOfDivision number) const;
  // The doubles nearest to a Voronoi vertex or to the centre of a polygon, or nothing.
  [[nodiscard]] std::optional<Point> rounded_face(const DivisionPoint& point) const;
  // What of a number over a triangle belongs to each of its corners (StableVolumes): (1 - w) / 2 times the number. Here
  // w is the corner's barycentric weight of the circle's centre.
  [[nodiscard]] std::array<BoundedNumber, 3> parts_of_corners(const BoundedNumber& number,
                                                              const std::array<VertexIndex, 3>& triangle) const;
  // Six times the volume of a tetrahedron, positive if its vertices have positive orientation.
  [[nodiscard]] BoundedNumber determinant(const std::array<VertexIndex, 4>& vertices) const;

 private:
  using Vector = Vector3<DoubleDouble>;
  [[nodiscard]] Vector between(VertexIndex from, VertexIndex to) const;
  [[nodiscard]] BoundedNumber crossing(const DivisionPoint& point) const;
  [[nodiscard]] std::optional<Point> rounded_crossing(const DivisionPoint& point, const BoundedNumber& r) const;
  // A number in units, where that is exact.
  [[nodiscard]] std::optional<double> in_input(const BoundedNumber& number) const;

  const VoronoiDiagram& diagram_;
  const LimitPartition& partition_;
  int unit_ = 0;
  double scale_ = 1;
  std::vector<BoundedNumber> parameters_;
};

}  // namespace flowcert::morse
