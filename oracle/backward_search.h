// The search against the flow that makes a skeleton: of a stationary point (stable_set.h), or of infinity
// (infinity_set.h).
//
// It begins with what its caller adds. Each function adds what its name says, and all that flows into it (FC-STAB-03
// to 05).
#pragma once

#include "oracle/infinity_set.h"

namespace oracle {

// A face K of a Delaunay polytope, by its places, with its centre c. K is an edge, or a polygon that contains c.
struct Lead {
  Places face;
  Point centre;
};

class BackwardSearch {
 public:
  explicit BackwardSearch(const PointSet& set) : set_(set) {}

  void add_point(const Point& y);

  // The open segment or interval that flows straight away from the centre of a face, to `front`. The face leads there.
  void add_way(const Corner& front, const Lead& lead);

  // What flows straight away from the midpoint of an edge to the side between the two corners, in the edge's facet.
  void add_sector(const Corner& front, const Corner& back, const Lead& edge);

  // All that was found; each list is sorted.
  InfinitySet sorted() &&;

 private:
  struct Interval {
    std::vector<std::size_t> polygon;
    Corner front, back;
    IntervalKind kind;
  };
  int dimension_at(const Point& x) const;
  void add_segment(const Corner& front, const Point& back, const Lead& lead);
  void add_interval_into(const Corner& front, const Point& back, const Lead& lead);
  void add_interval(const Interval& interval);
  void add_crossed_interval(const Corner& a, const Corner& b);

  const PointSet& set_;
  InfinitySet found_;
};

}  // namespace oracle
