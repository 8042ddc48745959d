// The flow complex of a point set: what a user of the library holds.
//
// Guarantees: exact, on every input. It owns the points and everything that is computed of them. Each part is made
// once, when it is first asked for. A reference to a part stays valid as long as the complex exists, even if the
// complex is moved, unless the part is forgotten; only what refers to the complex itself must not outlive a move. A
// complex that was moved from can be assigned to or destroyed. Const access is safe from several threads. Source:
// spec/flow_complex.md.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/flow_limits.h"
#include "flowcert/merge_trees.h"
#include "flowcert/persistence.h"
#include "flowcert/sphere.h"
#include "flowcert/stable_volumes.h"
#include "flowcert/unstable_surfaces.h"

namespace flowcert {

// A hundred cells a point, or two million (a gigabyte).
[[nodiscard]] std::size_t usual_most_cells(std::size_t points);

// What takes time, in the order in which it is made.
enum class FlowComplexPart : std::uint8_t {
  kTriangulation,
  kDiagram,
  kStationary,
  kUnstable,
  kStable,
  kChains,
  kLinks,
  kPersistence,
  kLimits,
  kVolumes,
  kUnstableSurfaces,
  kMergeTrees,
};
inline constexpr std::size_t kFlowComplexParts = 12;

// Where a position flows to.
struct FlowPlace {
  // Where the orbit ends: a place in the list of stationary points. Nothing if it goes to infinity.
  std::optional<std::size_t> limit;
  std::vector<PointId> nearest;  // the names of all nearest samples, ascending

  friend bool operator==(const FlowPlace&, const FlowPlace&) = default;
};

class FlowComplex {
 public:
  // Called when a part is done. For chains, links, persistence, unstable surfaces and merge trees it is also called
  // when they begin, for all other parts now and then, from any of the threads that make them, one at a time. Two
  // threads call it at once if they make different parts. It may throw to stop; the part is then made when it is asked
  // for again. It must not ask the complex for anything.
  using Progress = std::function<void(FlowComplexPart part, std::size_t done, std::size_t total)>;

  // Computes nothing yet. The second one throws InvalidInput as PointSet does. Whatever rounding mode, flushing of
  // subnormals or traps the calling thread has set, everything is computed with doubles as IEEE 754 says, and the
  // thread has its modes again afterwards. Where that cannot be had, std::runtime_error is thrown.
  explicit FlowComplex(PointSet points, FlowOptions options = {}, Progress progress = {});
  explicit FlowComplex(std::span<const Point> rows, FlowOptions options = {}, Progress progress = {});
  ~FlowComplex();
  FlowComplex(FlowComplex&&) noexcept;
  FlowComplex& operator=(FlowComplex&&) noexcept;

  // Makes a part and those that it needs, where they are not there yet.
  void make(FlowComplexPart part) const;
  // Gives back the memory of the diagram and of what refers to it, which is most of it. Points, stationary points,
  // chains, links and persistence stay. What is forgotten is made again when it is asked for, and references to it end.
  void forget_diagram();

  [[nodiscard]] const PointSet& points() const;
  // The options say this number. What is written of a complex is made by as many threads.
  [[nodiscard]] unsigned threads() const;
  // The dimension of the affine hull of the points: 0 to 3, -1 for no point.
  [[nodiscard]] int dimension() const;
  // The triangulation has so many cells, infinite ones as well.
  [[nodiscard]] std::size_t delaunay_cells() const;
  [[nodiscard]] const VoronoiDiagram& diagram() const;
  // How often the diagram took each predicate.
  [[nodiscard]] const FilterTally& filter_tally() const;
  [[nodiscard]] const StationaryPoints& stationary() const;
  [[nodiscard]] const UnstableManifolds& unstable() const;
  [[nodiscard]] const StableManifolds& stable() const;
  [[nodiscard]] const ChainComplex& chains() const;
  // What persistence is made of. It does not need U2.
  [[nodiscard]] const SaddleLinks& links() const;
  [[nodiscard]] const Persistence& persistence() const;
  [[nodiscard]] const FlowLimits& limits() const;
  [[nodiscard]] const StableVolumes& volumes() const;
  // Made at once, because each of the sets is made when it is asked for.
  [[nodiscard]] const UnstableSurfaces& unstable_surfaces() const;
  // What Pockets are made of.
  [[nodiscard]] const MergeTrees& merge_trees() const;

  // Centre and squared radius of a stationary point, by its place in the list.
  [[nodiscard]] ExactSphere sphere(std::size_t record) const;
  // The two samples whose midpoint it is, where its face has dimension 1 (FC-UNST-01). Names, ascending. The time grows
  // with the square of its contact set.
  [[nodiscard]] std::array<PointId, 2> samples_of(std::size_t record) const;
  // The nearest doubles. A number that would overflow is an infinity.
  [[nodiscard]] RoundedSphere rounded_sphere(std::size_t record) const;
  // The doubles nearest to the centres of all stationary points, in the order of the list. A coordinate that would
  // overflow is an infinity.
  [[nodiscard]] std::vector<std::array<double, 3>> centers() const;

  // Where the flow takes any position (Flow::orbit). Each thread flows with arrays of its own.
  [[nodiscard]] Orbit orbit(const RationalPoint& start) const;
  // The end of that orbit alone, which takes less time (Flow::limit).
  [[nodiscard]] std::optional<StationaryLimit> limit(const RationalPoint& start) const;
  // The same end, as a place in the list, and the nearest samples. The first call makes the limits, which takes longer
  // than a few calls of limit(); every further call takes microseconds. Throws InvalidInput for an empty point set, and
  // for coordinates that are not finite.
  [[nodiscard]] FlowPlace locate(const RationalPoint& x) const;
  [[nodiscard]] FlowPlace locate(const Point& x) const;
  // The first segment of that orbit (Flow::step).
  [[nodiscard]] FlowSegment step(const RationalPoint& start) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
