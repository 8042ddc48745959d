// The volumes of stable sets (spec clauses FC-VOL-01, 02).
//
// Guarantees: each double is the nearest one to the exact volume, ties to even. Doubled doubles with proven bounds
// decide most of them, exact numbers the others. Exact volumes are made on demand.
//
// A stable set meets each Voronoi edge in arcs. An arc from a to b on the edge of a polygon f stands for all that is
// between it and f: the signed volumes area(f) |b-a| / 3 of these joins add up to that of the stable set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "flowcert/flow_limits.h"
#include "flowcert/progress.h"
#include "flowcert/rational.h"

namespace flowcert {

// Const access is safe from several threads.
class StableVolumes {
 public:
  // The first three must outlive this. O(cells and points of division), and what exact numbers take where doubles do
  // not suffice. So many threads round, at least 1; one at a time computes exactly.
  StableVolumes(const VoronoiDiagram& diagram, const StationaryPoints& stationary, const FlowLimits& limits,
                unsigned threads = 1, const Progress& progress = {});
  StableVolumes(const VoronoiDiagram&, StationaryPoints&&, const FlowLimits&, unsigned = 1,
                const Progress& = {}) = delete;
  ~StableVolumes();
  StableVolumes(StableVolumes&&) noexcept;
  StableVolumes& operator=(StableVolumes&&) noexcept;

  // By place in the list of stationary points. An infinity where it would overflow. 0 where the set has no part of
  // dimension 3.
  [[nodiscard]] double nearest(std::size_t record) const;
  // The time grows with the number of arcs and with the digits of their ends, which many crossings make long.
  [[nodiscard]] Rational exact(std::size_t record) const;
  // Of several stable sets together: the double nearest to the sum, and the sum.
  [[nodiscard]] double nearest_sum(std::span<const std::uint32_t> records) const;
  [[nodiscard]] Rational exact_sum(std::span<const std::uint32_t> records) const;
  // What lies in the Voronoi cells of which samples: names, ascending, with the parts of the volume that are not 0.
  [[nodiscard]] std::vector<std::pair<PointId, Rational>> shares(std::size_t record) const;
  // The same samples, with the double nearest to each part. Proven bounds spare most of the exact numbers. An infinity
  // where it would overflow; 0 where it is below the doubles.
  [[nodiscard]] std::vector<std::pair<PointId, double>> rounded_shares(std::size_t record) const;

  // The volume of the convex hull of all points, exactly. All of it that no stable set has flows to infinity.
  [[nodiscard]] const Rational& hull() const;

  // How many volumes took exact numbers.
  [[nodiscard]] std::size_t decided_exactly() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flowcert
