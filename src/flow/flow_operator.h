// The flow operator behind one interface for all construction kernels. From a point in a known Voronoi face it makes
// the next flow segment.
//
// Guarantees: exact; every kernel gives the same faces and points (spec clauses FC-FLOW-01 to 04). The operator keeps
// the constructed points, and hands out numbers for them. It is not for two threads at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>

#include "flow/drivers.h"
#include "flow/kernels/steering.h"
#include "flowcert/flow_statistics.h"
#include "flowcert/orbit.h"
#include "flowcert/sphere.h"
#include "voronoi/voronoi_faces.h"

namespace flowcert::flow {

// Where a moving point is: the face, and the point in it (kNoPoint at a Voronoi vertex and at infinity).
struct Location {
  Place place;
  PointNumber point = kNoPoint;
};

struct FlowStep {
  Place crossed;
  Driver driver;
  // It is the start iff the start is stationary; then `stationary` says what the start is.
  Location end;
  std::optional<StationaryIndex> stationary;
};

// A backward segment of spec clause FC-STAB-04. It runs against the flow, from a front that the facet leads to.
struct BackwardStep {
  // Where the facet ends on the way to its midpoint. It is the facet itself if the midpoint lies inside.
  Place back;
  // The back is the midpoint, which is stationary.
  bool is_midpoint = false;
  // If the back lies inside a Voronoi edge and is not the midpoint: a sample of that edge's polygon, other than the
  // facet's two.
  VertexIndex apex = kInfiniteVertex;
};

// The letters of Table 1.
using SegmentType = std::array<char, 3>;
[[nodiscard]] constexpr char letter(Place::Kind kind) {
  constexpr std::array<char, 5> kLetters = {0, 'V', 'E', 'F', 'C'};
  return kLetters[static_cast<std::size_t>(kind)];
}
[[nodiscard]] inline SegmentType segment_type(const Place& start, const FlowStep& step) {
  return {letter(start.kind), letter(step.crossed.kind), letter(step.end.place.kind)};
}

// The flow from a Voronoi vertex to the next one, or to the orbit's end. Between the first and the last segment there
// are E-F-E alone, because only these and V-F-E end inside a Voronoi edge.
struct Course {
  std::uint32_t count = 0;      // segments
  SegmentType first{}, last{};  // of them, if there are any
  Place end;
  std::optional<StationaryIndex> stationary;  // set if the orbit ends there

  void add(const SegmentType& type) {
    last = type;
    if (count++ == 0) first = type;
  }
};

// The Voronoi vertices to flow from, and what takes the courses.
class CourseSource {
 public:
  virtual ~CourseSource() = default;
  // A Voronoi vertex to start from; kNoCell if there is none, unless courses on their way make one known.
  [[nodiscard]] virtual CellIndex next() = 0;
  virtual void take(CellIndex start, const Course& course) = 0;
};

class FlowOperator {
 public:
  virtual ~FlowOperator() = default;

  [[nodiscard]] virtual PointNumber add(const RationalPoint& x) = 0;
  [[nodiscard]] virtual FlowStep step(const Location& from) = 0;
  // All steps from a Voronoi vertex on. The points that it constructs are kept.
  [[nodiscard]] virtual Course follow(CellIndex cluster) = 0;
  // Follows from many Voronoi vertices. The answers come in no particular order.
  virtual void follow_all(CourseSource& source) = 0;
  // Where the Voronoi edge of a polygon ends, on side 0 or 1.
  [[nodiscard]] virtual Location end_of_edge(PolygonRef polygon, std::size_t side) = 0;

  // Against the flow. The back of a facet that has one for all fronts, so that no front's point is needed. A facet with
  // its midpoint inside has one back, and so have most others. The face is that of a front.
  [[nodiscard]] virtual std::optional<BackwardStep> one_back(const Place& front, FacetName facet, CellIndex hint) = 0;
  // The back of a facet that has several; which one it is depends on the front.
  [[nodiscard]] virtual BackwardStep step_back(const Location& front, FacetName facet, CellIndex hint) = 0;
  // Constructs the back inside a Voronoi edge.
  [[nodiscard]] virtual PointNumber cross_back(const Location& front, FacetName facet, VertexIndex apex) = 0;
  // Constructs the centre of the circle through three samples.
  [[nodiscard]] virtual PointNumber add_center(const std::array<VertexIndex, 3>& samples) = 0;

  [[nodiscard]] virtual RationalPoint exact(const Location& at) = 0;
  // The position, and the squared distance from there to the nearest samples, as the nearest doubles.
  [[nodiscard]] virtual RoundedSphere rounded(const Location& at) = 0;
  // Adds, for each kept point, how many bytes its coordinates take where they have been computed exactly. Raises
  // `depth` to the longest chain of constructions behind a point.
  virtual void count_sizes(Distribution& exact_bytes, std::size_t& depth) const = 0;

  // Kept points are numbered in order; the latest can be dropped.
  [[nodiscard]] virtual PointNumber kept() const = 0;
  virtual void drop_from(PointNumber point) = 0;
  // Drops all that was constructed: the kept points, and the Voronoi vertices, which are otherwise
  // constructed once and serve every orbit.
  virtual void drop_all() = 0;

  [[nodiscard]] virtual const KernelTally& tally() const = 0;
};

// The faces must outlive the operator, and serve no other one: it keeps notes in their rings. The cascade kernel's is
// made in a file of its own, because it includes no CGAL.
[[nodiscard]] std::unique_ptr<FlowOperator> make_cascade_operator(VoronoiFaces& faces, FacetSearch search);
[[nodiscard]] std::unique_ptr<FlowOperator> make_flow_operator(VoronoiFaces& faces, FlowOptions options);

// How many of so many threads flow, each with an operator of its own. The lazy and the exact kernel count constructions
// of Voronoi vertices that a thread keeps, and one thread counts the same each time. Throws std::invalid_argument where
// there is no thread.
[[nodiscard]] inline unsigned team_size(const FlowOptions& options, unsigned threads) {
  if (threads == 0) throw std::invalid_argument("the flow takes at least one thread");
  return options.kernel == ConstructionKernel::kCascade ? threads : 1;
}

}  // namespace flowcert::flow
