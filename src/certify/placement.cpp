// Finds the true stationary point that each claimed point means, by its contact set or, if none is claimed, by its
// position.
//
// Guarantees: no stationary point within the tolerance is overlooked. Whether one is within is decided exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/layer.h"
#include "flowcert/check.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

// ---- Positions on a grid ----
// For claims without contact sets. A question takes expected constant time if positions are spread evenly.

namespace {

class PositionGrid {
 public:
  // O(truth.size()) exact centres.
  PositionGrid(Truth& truth, double tolerance);

  [[nodiscard]] const ExactSphere& sphere(std::size_t record) const { return spheres_[record]; }
  // All stationary points within the tolerance, and a few more; ascending.
  [[nodiscard]] std::vector<std::size_t> near(const ClaimedPosition& position) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const;
  };
  [[nodiscard]] Cell cell_of(const std::array<double, 3>& position) const;

  struct Reach {
    std::array<double, 3> center;  // rounded
    double length;                 // at least the tolerance, and what rounding may add to it
  };

  std::vector<ExactSphere> spheres_;
  std::vector<Reach> reaches_;
  double cell_size_ = 1;
  std::unordered_map<Cell, std::vector<std::size_t>, Hash> cells_;
};

constexpr double kLargest = std::numeric_limits<double>::max();

double clamped_double(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? *nearest : value > 0 ? kLargest : -kLargest;
}

std::array<double, 3> rounded(const RationalPoint& x) {
  return {clamped_double(x[0]), clamped_double(x[1]), clamped_double(x[2])};
}

std::size_t PositionGrid::Hash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t part : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

PositionGrid::PositionGrid(Truth& truth, double tolerance) {
  // The tolerance refers to at most the largest of radius and coordinates. Each compared position is rounded by less
  // than 2^-51 of that.
  const double part = 2 * std::max(tolerance, 2 * kRoundingPart);
  double low = kLargest, high = -kLargest, reach = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    spheres_.push_back(truth.sphere(i));
    reaches_.push_back({rounded(spheres_.back().center), part * rounding_length(spheres_.back())});
    for (const double x : reaches_.back().center) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
    reach = std::max(reach, reaches_.back().length);
  }
  if (spheres_.empty()) return;
  const double even = (high / 2 - low / 2) / std::cbrt(static_cast<double>(spheres_.size()));
  cell_size_ = std::min(std::max({even, reach, std::numeric_limits<double>::min()}), kLargest);
  for (std::size_t i = 0; i < reaches_.size(); ++i) cells_[cell_of(reaches_[i].center)].push_back(i);
}

PositionGrid::Cell PositionGrid::cell_of(const std::array<double, 3>& position) const {
  // Positions too far away for a cell number share the outermost cells.
  constexpr double kFar = 0x1p60;
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cell[axis] = static_cast<std::int64_t>(std::clamp(std::floor(position[axis] / cell_size_), -kFar, kFar));
  }
  return cell;
}

std::vector<std::size_t> PositionGrid::near(const ClaimedPosition& position) const {
  const std::array<double, 3> at = rounded(values_of(position));
  const Cell middle = cell_of(at);
  std::vector<std::size_t> found;
  for (int k = 0; k < 27; ++k) {
    const auto cell = cells_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
    if (cell == cells_.end()) continue;
    for (const std::size_t record : cell->second) {
      const Reach& reach = reaches_[record];
      bool is_near = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        is_near = is_near && std::abs(at[axis] - reach.center[axis]) <= reach.length;
      }
      if (is_near) found.push_back(record);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// ---- Placing ----

Fit fit_of_part(const CheckRun& run, const std::vector<PointId>& names, std::size_t record) {
  const int dimension = run.index(record).hull_dimension;
  const bool is_simplex = static_cast<int>(names.size()) == dimension + 1;
  return is_simplex && affine_dimension(run.points, names) == dimension ? Fit::kPart : Fit::kOther;
}

// How well a claim fits a stationary point. 0: the point has the claimed index or kind. 1: the point is regular, and
// a perturbation may make the claimed critical point from it, with others. 2: otherwise.
int rank_of(const CheckRun& run, const ClaimedPoint& point, std::size_t record) {
  const StationaryIndex index = run.index(record);
  const int hull_dimension = point.hull_dimension.value_or(point.index);
  if (index.face_dimension == point.index && index.hull_dimension == hull_dimension) return 0;
  const bool is_between = index.face_dimension <= point.index && point.index <= index.hull_dimension;
  return !index.is_critical() && !point.hull_dimension && is_between ? 1 : 2;
}

// Places claims by position. A matching gives as many claims as possible a stationary point of their own within the
// tolerance. So no right claim is taken for a second claim of the same point.
class ByPosition {
 public:
  explicit ByPosition(CheckRun& run) : run_(run), grid_(run.truth, run.options.tolerance) {}

  void add(std::size_t k) {
    candidates_[k] = candidates(run_.claim.points[k]);
    if (candidates_[k].empty()) candidates_.erase(k);
  }

  void place() {
    for (const auto& [k, within] : candidates_) {
      tried_.clear();
      find_own(k);
    }
    std::map<std::size_t, std::size_t> own;
    for (const auto& [record, k] : owner_) own[k] = record;
    for (const auto& [k, within] : candidates_) {
      const auto found = own.find(k);
      place(k, within, found == own.end() ? within.front().record : found->second);
    }
  }

 private:
  struct Candidate {
    int rank;
    Rational squared_distance;
    std::size_t record;
    friend bool operator<(const Candidate& a, const Candidate& b) {
      return std::tie(a.rank, a.squared_distance, a.record) < std::tie(b.rank, b.squared_distance, b.record);
    }
  };

  // Ascending.
  std::vector<Candidate> candidates(const ClaimedPoint& point) const {
    const ClaimedPosition& at = point.center.value();
    const RationalPoint x = values_of(at);
    std::vector<Candidate> within, nearly;
    for (const std::size_t record : grid_.near(at)) {
      const ExactSphere& sphere = grid_.sphere(record);
      const ValueMatch match = match_position(at, sphere.center, ValueScale(sphere, run_.options.tolerance));
      if (match == ValueMatch::kOff) continue;
      std::vector<Candidate>& to = is_wrong(match) ? nearly : within;
      to.push_back({rank_of(run_, point, record), squared_distance(x, sphere.center), record});
      // A position that equals a centre exactly names that stationary point.
      if (match == ValueMatch::kEqual) return {within.back()};
    }
    // What an exact coordinate excludes is meant only if nothing else can be.
    if (within.empty()) within = std::move(nearly);
    std::sort(within.begin(), within.end());
    return within;
  }

  // Looks for an augmenting path (Kuhn's algorithm) among the candidates of rank 0. It does not recurse, because a path
  // can be as long as the claim.
  void find_own(std::size_t k) {
    struct Step {
      const std::vector<Candidate>* of;
      std::size_t k;
      std::size_t tried;  // so many of the candidates
    };
    std::vector<Step> path{{&candidates_.at(k), k, 0}};
    while (!path.empty()) {
      Step& last = path.back();
      if (last.tried == last.of->size() || (*last.of)[last.tried].rank > 0) {
        path.pop_back();
        continue;
      }
      const std::size_t record = (*last.of)[last.tried++].record;
      if (!tried_.insert(record).second) continue;
      if (const auto owner = owner_.find(record); owner != owner_.end()) {
        path.push_back({&candidates_.at(owner->second), owner->second, 0});
        continue;
      }
      for (const Step& step : path) owner_[(*step.of)[step.tried - 1].record] = step.k;
      return;
    }
  }

  void place(std::size_t k, const std::vector<Candidate>& within, std::size_t record) {
    PlacedPoint& placed = run_.placed[k];
    placed.place = Placement{record, Fit::kPosition};
    if (within.size() == 1) return;
    std::string others;
    for (const Candidate& candidate : within) {
      placed.alternatives.push_back(candidate.record);
      others += (others.empty() ? "" : "; ") + stationary_text(run_.truth, candidate.record);
    }
    run_.vary(2, FindingReason::kAmbiguous, "FC-CLAIM-05", k,
              std::to_string(within.size()) + " stationary points are within the tolerance: " + others);
  }

  CheckRun& run_;
  PositionGrid grid_;
  std::map<std::size_t, std::vector<Candidate>> candidates_;  // by claimed point
  std::map<std::size_t, std::size_t> owner_;                  // the claimed point, by stationary point
  std::set<std::size_t> tried_;
};

}  // namespace

std::optional<Placement> placement_of(CheckRun& run, const std::vector<PointId>& names) {
  if (const auto whole = run.contacts.find(names)) return Placement{*whole, Fit::kWhole};
  const std::vector<std::size_t> larger = run.contacts.larger(names);
  if (larger.empty()) return std::nullopt;
  const ExactSphere sphere = exact_sphere(run.points, names);
  for (const std::size_t record : larger) {
    if (run.truth.sphere(record).center == sphere.center) return Placement{record, fit_of_part(run, names, record)};
  }
  return std::nullopt;
}

void place_points(CheckRun& run) {
  std::optional<ByPosition> by_position;
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
    run.tell(2, k, run.placed.size());
    PlacedPoint& placed = run.placed[k];
    if (!placed.is_well_formed) continue;
    if (!placed.names.empty()) {
      placed.place = placement_of(run, placed.names);
      continue;
    }
    run.report.is_exact = run.report.is_exact && is_exact(*run.claim.points[k].center);
    if (!by_position) by_position.emplace(run);
    by_position->add(k);
  }
  if (by_position) by_position->place();
}

}  // namespace flowcert::certify
