// The flow of the distance function: one segment from any point, and whole orbits.
//
// Guarantees: exact, on every input and for every start, whatever the dimension of the points and however degenerate
// the flow. All kernels and both ways to search a facet give the same answer. Source: spec section 8 (clauses
// FC-FLOW); paper, Definition 3, Table 1, section 4.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_statistics.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"
#include "flowcert/stationary_index.h"
#include "flowcert/voronoi_diagram.h"

namespace flowcert {

// How constructed points are represented.
enum class ConstructionKernel : std::uint8_t {
  kCascade,  // directions with a bound on their angle; a longer precision, then integers, where that does not decide
  kLazy,     // CGAL's Epeck: intervals with their history, exact rationals where they do not decide
  kExact,    // rationals throughout; slow on long orbits, for comparison
};

// How to find the Voronoi edge at which an orbit leaves a facet of n edges.
enum class FacetSearch : std::uint8_t {
  kBinary,  // O(log n) signs (paper, Proposition 1)
  kLinear,  // O(n) signs
};

inline constexpr std::size_t kAnyNumberOfCells = std::numeric_limits<std::size_t>::max();

// How a flow complex is made, and its parts. A part has use for some of these, Flow for the first two. But for the
// choices where ties are broken, all results are the same whatever they say.
struct FlowOptions {
  ConstructionKernel kernel = ConstructionKernel::kCascade;
  FacetSearch search = FacetSearch::kBinary;
  // Without sharing each orbit of U2 is computed alone, from its own Voronoi vertices on, as the paper did. Only the
  // arrays of facets are common.
  bool share = true;
  // The seed of all choices where ties are broken (FC-CHAIN-02); 0 always takes the first way.
  std::uint64_t seed = 0;
  // How many threads make a part. Only the cascade kernel, and U2 only with sharing, uses several for the manifolds.
  // With 1, no thread is started. Each takes memory of its own: 24 bytes a Delaunay cell, and what it meets of facets.
  // 0 is refused: std::invalid_argument.
  unsigned threads = 1;
  // Where there are more Delaunay cells, making the triangulation throws InvalidInput: points on two skew lines have
  // as many as pairs of points. usual_most_cells() is a limit that no scan and no molecule meets.
  std::size_t most_cells = kAnyNumberOfCells;
};

// A step of an orbit (FC-FLOW-02). Contact sets are ascending names.
struct FlowSegment {
  // The Voronoi faces that it starts in, crosses and reaches, each 'V', 'E', 'F' or 'C'; the last one is 0 at
  // infinity.
  std::array<char, 3> type{};
  RationalPoint start;
  RationalPoint driver;
  std::vector<PointId> start_contact;
  std::vector<PointId> crossed_contact;
  std::optional<RationalPoint> end;  // none: infinity
  std::vector<PointId> end_contact;  // empty at infinity

  // The only step of a stationary point goes from x to x.
  [[nodiscard]] bool stays() const { return end && *end == start; }
};

// "E-F-V", "V-E-inf".
[[nodiscard]] std::string type_text(const std::array<char, 3>& type);

// A stationary point at which orbits end.
struct StationaryLimit {
  RationalPoint position;
  StationaryIndex index;
  std::vector<PointId> contact;
};

struct Orbit {
  RationalPoint start;
  std::vector<FlowSegment> segments;     // none from a stationary point
  std::optional<StationaryLimit> limit;  // none: infinity
};

// Not to be used from two threads at once: it remembers the Voronoi facets that it has crossed.
class Flow {
 public:
  // The diagram must outlive the flow. O(1); its facets are put together when first met.
  explicit Flow(const VoronoiDiagram& diagram, FlowOptions options = {});
  explicit Flow(VoronoiDiagram&&, FlowOptions = {}) = delete;
  ~Flow();
  Flow(Flow&&) noexcept;
  Flow& operator=(Flow&&) noexcept;

  // The next segment from x. From a stationary point the segment stays there, and all three of its faces are the one
  // that x lies in (V-V-V at a Voronoi vertex, FC-FLOW-03). Throws InvalidInput for an empty point set.
  [[nodiscard]] FlowSegment step(const RationalPoint& x);

  // Throws InvalidInput for an empty point set.
  [[nodiscard]] Orbit orbit(const RationalPoint& start);

  // Where that orbit ends; nothing for infinity. What follows a Voronoi vertex is flowed once for all starts, and no
  // exact coordinates are computed, so many starts take little more time than few. Throws as orbit().
  [[nodiscard]] std::optional<StationaryLimit> limit(const RationalPoint& start);

  // What all steps so far have asked of the kernel.
  [[nodiscard]] const KernelTally& tally() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
