// Closed parts of a Voronoi edge, put together where they meet.
//
// Guarantees: exact. Positions are compared by their nearest doubles, because rounding keeps the order of numbers or
// makes them equal; exact positions decide what is equal then. Each position is computed once.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "flow/flow_operator.h"
#include "morse/layer.h"

namespace flowcert::morse {

// An end of a Voronoi edge, at a Voronoi vertex or at infinity, or a point inside it.
struct TraceEnd {
  enum class Kind : std::uint8_t { kEnd0, kPoint, kEnd1 };
  Kind kind = Kind::kPoint;
  Location at;  // kPoint

  [[nodiscard]] static TraceEnd end(std::size_t k) { return {k == 0 ? Kind::kEnd0 : Kind::kEnd1, {}}; }
  [[nodiscard]] bool is_end(std::size_t k) const { return kind == (k == 0 ? Kind::kEnd0 : Kind::kEnd1); }
};

// `from` is not after `to`, in the sense from end 0 to end 1.
struct TracePart {
  TraceEnd from, to;
};

class TraceOrder {
 public:
  // Both must outlive it.
  TraceOrder(const VoronoiDiagram& diagram, FlowOperator& flow) : diagram_(diagram), flow_(flow) {}

  // Negative if a comes before b on the edge, 0 if they are equal.
  [[nodiscard]] int compare(PolygonRef polygon, const TraceEnd& a, const TraceEnd& b);
  void clear();

 private:
  struct Axis {
    std::size_t coordinate;
    int sign;  // 1 if the coordinate grows towards end 1
  };
  [[nodiscard]] Axis axis(PolygonRef polygon);
  [[nodiscard]] double rounded(const Location& at, std::size_t coordinate);
  [[nodiscard]] const RationalPoint& exact(const Location& at);

  const VoronoiDiagram& diagram_;
  FlowOperator& flow_;
  std::unordered_map<std::uint32_t, Axis> axes_;  // by packed polygon
  std::unordered_map<PointNumber, Point> rounded_;
  std::unordered_map<PointNumber, RationalPoint> exact_;
};

// Disjoint parts of one edge, in the sense from end 0 to end 1.
class TraceSet {
 public:
  [[nodiscard]] const std::vector<TracePart>& parts() const { return parts_; }
  // Adds a part. Returns parts that were not there, with their ends.
  std::vector<TracePart> add(PolygonRef polygon, const TracePart& part, TraceOrder& order);

 private:
  std::vector<TracePart> parts_;
};

}  // namespace flowcert::morse
