// The positions of the points of a division, exactly or in the nearest doubles.
//
// Guarantees: a double is the nearest one to the exact coordinate. Bounds decide most of them, exact numbers the
// others. Exact numbers are kept until there are many. It is not for two threads at once.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "morse/bounded_divisions.h"
#include "morse/exact_divisions.h"

namespace flowcert::morse {

class DivisionPositions {
 public:
  // Both must outlive it.
  DivisionPositions(const VoronoiDiagram& diagram, const LimitPartition& partition)
      : diagram_(diagram), partition_(partition), exact_(diagram, partition) {}

  // The position, or the vector that points to an end at infinity.
  [[nodiscard]] RationalPoint exact(PointOfDivision point);
  // A vector is scaled so that its largest coordinate is 1 or -1. A coordinate that would overflow is an infinity.
  [[nodiscard]] Point rounded(PointOfDivision point);
  // The position of a point that is no crossing. It need not be one of the partition.
  [[nodiscard]] RationalPoint exact_face(const DivisionPoint& point) const { return exact_.position_of_face(point); }
  [[nodiscard]] Point rounded_face(const DivisionPoint& point);
  // The place of the point that comes first in lexicographic order. There must be points, and no ends at infinity.
  [[nodiscard]] std::size_t least(std::span<const PointOfDivision> points);

 private:
  [[nodiscard]] BoundedDivisions& bounded();

  const VoronoiDiagram& diagram_;
  const LimitPartition& partition_;
  ExactDivisions exact_;
  std::optional<BoundedDivisions> bounded_;  // made when it is asked for
};

}  // namespace flowcert::morse
