// The exact places of the points of a division.
//
// Guarantees: exact. A chain of crossings is followed in a loop, so that no length of it exhausts the stack. What was
// computed is kept until drop().
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "flowcert/rational.h"
#include "geometry/rational_point.h"
#include "morse/division_parameter.h"
#include "morse/limit_partition.h"
#include "morse/polygon_turn.h"

namespace flowcert::morse {

class ExactDivisions {
 public:
  // Both must outlive it.
  ExactDivisions(const VoronoiDiagram& diagram, const LimitPartition& partition)
      : diagram_(diagram), partition_(partition) {}

  // The parameter of a crossing or a centre for its own polygon (division_parameter.h): of a crossing for p0, p1 of
  // its facet and its apex.
  [[nodiscard]] const Rational& parameter(PointOfDivision number);
  // The position, or the vector that points to an end at infinity.
  [[nodiscard]] RationalPoint position(PointOfDivision number);
  // The position of a point that is no crossing. It need not be one of the partition.
  [[nodiscard]] RationalPoint position_of_face(const DivisionPoint& point) const;
  void drop() { parameters_.clear(); }
  [[nodiscard]] std::size_t kept() const { return parameters_.size(); }

 private:
  [[nodiscard]] Vector3<Rational> at(VertexIndex v) const;
  [[nodiscard]] Rational crossing(const DivisionPoint& point);

  const VoronoiDiagram& diagram_;
  const LimitPartition& partition_;
  std::unordered_map<PointOfDivision, Rational> parameters_;
  std::vector<PointOfDivision> pending_;
};

// By what a parameter for the samples `from` is multiplied to be that for `to`, samples of the same polygon.
template <class Number>
[[nodiscard]] Number parameter_ratio(const auto& at, const std::array<VertexIndex, 3>& from,
                                     const std::array<VertexIndex, 3>& to) {
  if (const int turn = turn_of_same(from, to); turn != 0) return Number(turn);
  const auto normal = [&](const std::array<VertexIndex, 3>& v) {
    const Vector3<Number> origin = at(v[0]);
    return cross(at(v[1]) - origin, at(v[2]) - origin);
  };
  const Vector3<Number> n = normal(from);
  return Number(dot(n, normal(to))) / Number(dot(n, n));
}

}  // namespace flowcert::morse
