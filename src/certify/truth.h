// The true flow complex, as far as a check asks for it.
//
// Guarantees: what a truth says is exact. A stationary point is named by its place in the list, which has the order
// of FC-OUT-02. A check asks only for what a claim needs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/check.h"
#include "flowcert/connections.h"
#include "flowcert/flow_limits.h"
#include "flowcert/pockets.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/stationary_points.h"

namespace flowcert {

struct TrueSegment {
  std::string type;  // "E-F-V"
  RationalPoint driver;
  std::optional<RationalPoint> end;  // none: infinity
};

// An orbit, or what is left of it.
struct TruePath {
  std::vector<TrueSegment> segments;
  std::optional<std::size_t> limit;  // a stationary point; none: infinity
};

// What StableManifolds counts of one stable set.
struct StableSummary {
  std::size_t segments = 0;
  bool has_vertex = false;
  bool has_interval = false;
};

// All pockets at one persistence (FC-POCK-02 to 08). Points are places in the truth's list.
struct TruePockets {
  std::vector<Pocket> pockets;
  std::vector<std::uint32_t> outside;        // maxima, ascending
  std::vector<std::uint32_t> largest_balls;  // empty iff there is no pocket
  std::optional<WidestPath> widest;
  // The numbers of the pockets above each mouth, ascending. The outside has the number of pockets.
  std::map<std::uint32_t, std::vector<std::uint32_t>> above_mouths;
};

// As the fast implementation or the oracle finds it: all stationary points, and what flows from and to them.
class Truth {
 public:
  virtual ~Truth() = default;
  Truth(const Truth&) = delete;
  Truth& operator=(const Truth&) = delete;

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] StationaryIndex index(std::size_t i) const { return points_[i].index; }
  [[nodiscard]] std::span<const PointId> contact(std::size_t i) const { return points_[i].contact; }
  [[nodiscard]] virtual ExactSphere sphere(std::size_t i) = 0;

  // For an index-2 critical point: where its two orbits end (FC-FLOW-07), by side; none: infinity.
  [[nodiscard]] virtual std::array<std::optional<std::size_t>, 2> limits(std::size_t i) = 0;
  [[nodiscard]] virtual std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) = 0;
  // The orbit of any position. It has no segments if the position is stationary.
  [[nodiscard]] virtual TruePath orbit(const RationalPoint& start) = 0;

  // For an index-2 critical point: records of index 1, mod 2, ascending. If a tie leaves the boundary open, this is
  // one choice that FC-CHAIN-02 allows. A truth that breaks no ties then gives none.
  [[nodiscard]] virtual std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) = 0;
  // Both are for an index-2 critical point or a regular stationary point; the second one without it for infinity.
  [[nodiscard]] virtual StableSummary stable_summary(std::size_t i) = 0;
  [[nodiscard]] virtual StableSet<> stable_set(std::optional<std::size_t> i) = 0;

  // Both are for a stationary point whose face has dimension 1 or 2. Arcs and directions of the second one are in the
  // order of some λ-list.
  [[nodiscard]] virtual LambdaList lambda_list(std::size_t i) = 0;
  [[nodiscard]] virtual std::vector<FlowLimits::Entry> lambda_entries(std::size_t i) = 0;

  // Of the stable sets of stationary points (FC-VOL-01, 02): the volume of one, exactly; the double nearest to the sum
  // of some, or an infinity where it would overflow; the shares of one that are not 0, by names of samples, ascending.
  [[nodiscard]] virtual Rational volume(std::size_t i) = 0;
  [[nodiscard]] virtual double nearest_sum(std::span<const std::uint32_t> records) = 0;
  [[nodiscard]] virtual std::vector<std::pair<PointId, Rational>> shares(std::size_t i) = 0;
  // The same samples, with the nearest doubles.
  [[nodiscard]] virtual std::vector<std::pair<PointId, double>> nearest_shares(std::size_t i) = 0;
  // Of the convex hull of all points.
  [[nodiscard]] virtual Rational hull_volume() = 0;

  // For a stationary point whose face has dimension 1 (FC-UNST-04). All lists are sorted, as in UnstableSurface.
  [[nodiscard]] virtual UnstableSurface<> unstable_surface(std::size_t i) = 0;

  // The square of a persistence, which is a difference of distances.
  [[nodiscard]] virtual TruePockets pockets(const Rational& squared_persistence) = 0;
  // The area is that of the S2 of an index-2 critical point, as FC-POCK-11 permits.
  [[nodiscard]] virtual double area(std::size_t i) = 0;

  // These follow from lambda_entries(). The connections of a stationary point whose face has dimension 1 or 2
  // (FC-CONN-01), sorted by `to`; infinity comes last.
  [[nodiscard]] std::vector<Connection> connections(std::size_t i);
  // By the second sentence of FC-CONN-03.
  [[nodiscard]] bool is_morse_smale();
  [[nodiscard]] double nearest_volume(std::size_t i) {
    const auto record = static_cast<std::uint32_t>(i);
    return nearest_sum({&record, 1});
  }

 protected:
  Truth() = default;
  // The next stationary point. Its contact set has to last as long as this.
  void add(StationaryIndex index, std::span<const PointId> contact) { points_.push_back({index, contact}); }

 private:
  struct ListedPoint {
    StationaryIndex index;
    std::span<const PointId> contact;
  };
  std::vector<ListedPoint> points_;
};

// The truth by the fast implementation, of points or of a complex that must outlive it. This takes as long as computing
// the critical points. U2 is computed when it is first asked for.
[[nodiscard]] std::unique_ptr<Truth> fast_truth(const PointSet& points, unsigned threads = 1);
[[nodiscard]] std::unique_ptr<Truth> fast_truth(const FlowComplex& complex);
std::unique_ptr<Truth> fast_truth(FlowComplex&&) = delete;

// Judges by this truth, which is of these points; otherwise as in flowcert/check.h.
[[nodiscard]] CheckReport check(const PointSet& points, const Claim& claim, Truth& truth,
                                const CheckOptions& options = {});

}  // namespace flowcert
