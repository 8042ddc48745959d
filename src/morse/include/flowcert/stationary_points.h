// All stationary points of the distance function of a point set, critical and regular.
//
// Guarantees: exact, on every input; each is listed once, by its contact set. Centres and radii are
// rationals, made on demand. Source: spec sections 3 and 6 (clauses FC-CRIT, FC-SIGN); paper, sections 2.1
// and 2.2.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/progress.h"
#include "flowcert/sphere.h"
#include "flowcert/stationary_index.h"
#include "flowcert/voronoi_diagram.h"

namespace flowcert {

namespace morse {
class OrderedRecords;
}  // namespace morse

// How many regular stationary points of each kind there are.
struct RegularCounts {
  std::size_t kind12 = 0;
  std::size_t kind13 = 0;
  std::size_t kind23 = 0;

  friend bool operator==(const RegularCounts&, const RegularCounts&) = default;
};

// The list, in the order of spec clause FC-OUT-02: critical points by index, then regular ones by kind, each
// by contact set.
class StationaryPoints {
 public:
  [[nodiscard]] std::size_t size() const { return index_.size(); }
  [[nodiscard]] StationaryIndex index(std::size_t i) const { return index_[i]; }
  // All points at distance d(x), by name (PointSet::name), ascending.
  [[nodiscard]] std::span<const PointId> contact(std::size_t i) const {
    return std::span(contact_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

  [[nodiscard]] const std::array<std::size_t, 4>& critical_counts() const { return critical_; }
  [[nodiscard]] const RegularCounts& regular_counts() const { return regular_; }
  // c_0 - c_1 + c_2 - c_3: 1, or 0 for the empty set.
  [[nodiscard]] long long euler_sum() const;

  // Where the point lies in the diagram that the list was made of (src/morse/record_finder.h).
  [[nodiscard]] std::uint32_t face(std::size_t i) const { return face_[i]; }

  // Prefetches a point's data, for those who go through the list in another order.
  [[gnu::always_inline]] void prefetch(std::size_t i) const {
    __builtin_prefetch(&index_[i]);
    __builtin_prefetch(&first_[i]);
    __builtin_prefetch(&face_[i]);
  }

 private:
  friend class morse::OrderedRecords;
  std::vector<StationaryIndex> index_;
  std::vector<std::size_t> first_{0};
  std::vector<PointId> contact_;
  std::vector<std::uint32_t> face_;
  std::array<std::size_t, 4> critical_{};
  RegularCounts regular_;
};

// O(cells), and sorting what is cospherical. The list is the same for any number of threads, which is at least 1.
[[nodiscard]] StationaryPoints stationary_points(const VoronoiDiagram& diagram, unsigned threads = 1,
                                                 const Progress& progress = {});

}  // namespace flowcert
