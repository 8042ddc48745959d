// The flow operator behind one interface, whatever its construction kernel: from a point in a known Voronoi
// face, the next flow segment.
//
// Guarantees: exact, the same faces and points from every kernel (spec clauses FC-FLOW-01 to 04). Constructed
// points stay with the machine, which hands out numbers for them. Not for two threads at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "flow/drivers.h"
#include "flowcert/orbit.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert {

// A point that the machine keeps, or a Voronoi vertex, which is its own name.
using PointNumber = std::uint32_t;
inline constexpr PointNumber kNoPoint = 0xffffffffu;

// Where a moving point is: the face, and the point in it (kNoPoint at a Voronoi vertex and at infinity).
struct Position {
  Place place;
  PointNumber point = kNoPoint;
};

struct FlowStep {
  Place crossed;
  Driver driver;
  // The start itself iff that is stationary; then `stationary` is what it is.
  Position end;
  std::optional<StationaryIndex> stationary;
};

class FlowMachine {
 public:
  virtual ~FlowMachine() = default;

  [[nodiscard]] virtual PointNumber add(const RationalPoint& x) = 0;
  [[nodiscard]] virtual FlowStep step(const Position& from) = 0;
  // Where the Voronoi edge of a polygon ends, on side 0 or 1.
  [[nodiscard]] virtual Position end_of_edge(PolygonRef polygon, std::size_t side) = 0;

  [[nodiscard]] virtual RationalPoint exact(const Position& position) = 0;
  // How many bytes the coordinates of a kept point take, where they have been computed exactly.
  [[nodiscard]] virtual std::optional<std::array<std::size_t, 3>> exact_bytes(PointNumber point) const = 0;
  [[nodiscard]] virtual std::size_t depth(PointNumber point) const = 0;

  // Kept points are numbered in order; the latest can be dropped.
  [[nodiscard]] virtual PointNumber kept() const = 0;
  virtual void drop_from(PointNumber point) = 0;
  // Drops all that was constructed: the kept points, and the Voronoi vertices, which are otherwise
  // constructed once and serve every orbit.
  virtual void drop_all() = 0;

  [[nodiscard]] virtual const KernelTally& tally() const = 0;
};

// The faces must outlive the machine.
[[nodiscard]] std::unique_ptr<FlowMachine> make_flow_machine(VoronoiFaces& faces, FlowOptions options);
[[nodiscard]] std::unique_ptr<FlowMachine> make_lazy_flow_machine(VoronoiFaces& faces, FacetSearch search);
[[nodiscard]] std::unique_ptr<FlowMachine> make_exact_flow_machine(VoronoiFaces& faces, FacetSearch search);

}  // namespace flowcert
