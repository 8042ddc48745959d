// Which classes of dimension 1 loops of edges between samples have: whether they stand for a persistence pair.
//
// Guarantees: exact, on every input, for loops from any source. An edge that is no index-1 point is split at a sample
// in its closed diametral ball, and so are the parts, so that a loop is a sum of index-1 points of the same class. That
// is written as a sum of the reduced boundaries of index-2 points. Numbers of points are places in the list. Source:
// spec section 18 (FC-CYC-01 to 03) and FC-CLAIM-25.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/loops.h"

namespace flowcert {

// Two samples by any of their rows. What comes twice, either way around, is not there.
using SampleEdge = std::array<PointId, 2>;

// Their sum mod 2, by the names of both samples.
[[nodiscard]] std::set<SampleEdge> odd_edges(const PointSet& points, std::span<const SampleEdge> edges);

// What is wrong with a loop that is said to stand for a pair at a level. The first one that applies is meant.
enum class LoopFault : std::uint8_t {
  kNone,
  kNotACycle,
  kEdgeTooLong,  // the square of half its length is more than the level
  kDiesLater,    // it does not bound at the death
  kDiesEarlier,  // it bounds before the death
  kBornEarlier,  // at the birth as level: a sum of it and of what bounds earlier is born earlier
};
// "not-a-cycle"; empty for kNone.
[[nodiscard]] const char* reason_text(LoopFault fault);

struct LoopClass {
  LoopFault fault = LoopFault::kNone;
  // The edge or, of a loop that dies at another value, an index-2 point of that value.
  std::optional<SampleEdge> edge;
  std::optional<std::uint32_t> death;
  // The class, of a loop without fault: the death points of the pairs in it that die with the pair. Ascending. At the
  // birth as level, `born` has those that are born with it.
  std::vector<std::uint32_t> dying, born;
};

// Not to be used from two threads at once: reduced boundaries are kept.
class LoopClasses {
 public:
  // The complex must outlive this. Makes its persistence.
  explicit LoopClasses(const FlowComplex& complex);

  // The pair has dimension 1 and a death, and the level is at least its birth and less than its death. O(points) for
  // each edge that is no index-1 point, and an addition of columns for each pair in the sum. Throws
  // std::invalid_argument for a pair of another dimension.
  [[nodiscard]] LoopClass of(std::span<const SampleEdge> loop, const PersistencePair& pair, const SquaredLevel& level);
  // Whether the loops are a basis of what stands for the pairs with this birth and death, at the birth as level
  // (FC-CYC-02), or for all that have this death, at another level (FC-CYC-03).
  [[nodiscard]] bool represent(std::span<const std::vector<SampleEdge>> loops, const PersistencePair& pair,
                               const SquaredLevel& level);
  // Whether both are cycles in {d^2 <= level}, and their sum bounds there.
  [[nodiscard]] bool are_homologous(std::span<const SampleEdge> a, std::span<const SampleEdge> b,
                                    const SquaredLevel& level);

  // Index-1 points, ascending, whose sum is homologous to the edges where the longest of these is.
  [[nodiscard]] std::vector<std::uint32_t> as_index_1_points(std::span<const SampleEdge> edges) const;
  // The death points of the pairs whose reduced boundaries sum up to these index-1 points. Nothing iff they are no
  // cycle.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> deaths_of(std::span<const std::uint32_t> loop);

 private:
  [[nodiscard]] const std::vector<std::uint32_t>& reduced_boundary(std::uint32_t death);
  [[nodiscard]] std::optional<SampleEdge> longer_edge(const std::set<SampleEdge>& edges,
                                                      const SquaredLevel& level) const;

  const FlowComplex& complex_;
  const Persistence& persistence_;
  Loops loops_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> reduced_;  // by the death point
};

}  // namespace flowcert
