// All stationary points of the distance function of a point set, critical and regular.
//
// Guarantees: exact, on every input; each is listed once, by its contact set. Centres and radii are
// rationals, made on demand. Source: spec sections 3 and 6 (clauses FC-CRIT, FC-SIGN); paper, sections 2.1
// and 2.2.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "flowcert/delaunay.h"
#include "flowcert/filter_tally.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert {

// The dimensions (0 to 3) of the face of conv C(x) that has x in its relative interior, and of conv C(x)
// itself. Equal for a critical point, whose index they are; (1,2), (2,3) or (1,3) for a regular stationary
// one.
struct StationaryIndex {
  std::uint8_t face_dimension = 0;
  std::uint8_t hull_dimension = 0;

  [[nodiscard]] bool is_critical() const { return face_dimension == hull_dimension; }
  friend auto operator<=>(const StationaryIndex&, const StationaryIndex&) = default;
};

// How many regular stationary points of each kind there are.
struct RegularCounts {
  std::size_t kind12 = 0;
  std::size_t kind23 = 0;
  std::size_t kind13 = 0;

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

  // For building a list: the caller keeps the order; contact is ascending.
  void reserve(std::size_t records, std::size_t contacts);
  void append(StationaryIndex index, std::span<const PointId> contact);

 private:
  std::vector<StationaryIndex> index_;
  std::vector<std::size_t> first_{0};
  std::vector<PointId> contact_;
  std::array<std::size_t, 4> critical_{};
  RegularCounts regular_;
};

// Linear after the triangulation, but for sorting what is cospherical. The tally, if given, is added to. Not
// to be called for one triangulation from two threads at once: it numbers the triangulation's cells.
[[nodiscard]] StationaryPoints stationary_points(const Delaunay& delaunay, FilterTally* tally = nullptr);

// The centre and squared radius of the smallest sphere through a cospherical set (one point and more, by
// name).
struct ExactSphere {
  RationalPoint center;
  Rational squared_radius;
};
[[nodiscard]] ExactSphere exact_sphere(const PointSet& points, std::span<const PointId> contact);

}  // namespace flowcert
