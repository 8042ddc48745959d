// Finds the true stationary point that each claimed point means, by its contact set or, if none is claimed, by its
// position.
//
// Guarantees: no stationary point within the tolerance is overlooked. Whether one is within is decided exactly.
#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/layer.h"
#include "certify/matching.h"
#include "certify/truth.h"
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
  [[nodiscard]] Cell cell_of(const std::array<double, 3>& position) const;

  struct Reach {
    std::array<double, 3> center;  // rounded
    double length;                 // at least the tolerance, and what rounding may add to it
  };

  std::vector<ExactSphere> spheres_;
  std::vector<Reach> reaches_;
  double cell_size_ = 1;
  std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> cells_;
};

constexpr double kLargest = std::numeric_limits<double>::max();

PositionGrid::PositionGrid(Truth& truth, double tolerance) {
  // The tolerance refers to at most the largest of radius and coordinates. Each compared position is rounded by less
  // than 2^-51 of that.
  const double part = 2 * std::max(tolerance, 2 * kRoundingPart);
  double low = kLargest, high = -kLargest, reach = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    spheres_.push_back(truth.sphere(i));
    reaches_.push_back({as_doubles(spheres_.back().center), part * rounding_length(spheres_.back())});
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
  const std::array<double, 3> at = as_doubles(values_of(position));
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

// Places claims by position. Those by contact set take part in the matching, so that no position is taken for a second
// claim of their points.
class ByPosition {
 public:
  explicit ByPosition(CheckRun& run) : run_(run), grid_(run.truth, run.options.tolerance) {}

  void place_all() {
    for (std::size_t k = 0; k < run_.placed.size(); ++k) {
      const std::optional<Placement>& place = run_.placed[k].place;
      if (!place || place->fit == Fit::kOther || rank_of(run_, run_.claim.points[k], place->record) != 0) continue;
      add({place->record});
    }
    for (std::size_t k = 0; k < run_.placed.size(); ++k) {
      if (!run_.placed[k].is_well_formed || !run_.placed[k].names.empty()) continue;
      found_.push_back({k, near(k)});
      std::vector<std::size_t> own;
      for (const Near& one : found_.back().near) {
        if (one.fit == NearFit::kRight) own.push_back(one.record);
      }
      add(std::move(own));
    }
    std::vector<Candidates*> candidates;
    for (Candidates& some : candidates_) candidates.push_back(&some);
    const Matching matching =
        maximum_matching(candidates, run_.truth.size(), [](std::size_t, std::size_t) { return true; });
    for (const auto& claimed : matching.of_truth) is_taken_.push_back(claimed.has_value());
    const std::size_t before = candidates_.size() - found_.size();
    for (std::size_t i = 0; i < found_.size(); ++i) place(found_[i], matching.of_claimed[before + i]);
  }

 private:
  // From good to bad.
  enum class NearFit {
    kRight,       // of the claimed index or kind, and with the claimed distance
    kMade,        // regular; a perturbation may make the claimed critical point from it, with others
    kWrongValue,  // as kRight, but for the distance
    kWrongMade,
    kWrongIndex,
  };
  // A stationary point within the tolerance of a claimed position.
  struct Near {
    NearFit fit;
    Rational squared_distance;
    std::size_t record;
    friend bool operator<(const Near& a, const Near& b) {
      return std::tie(a.fit, a.squared_distance, a.record) < std::tie(b.fit, b.squared_distance, b.record);
    }
  };
  struct Found {
    std::size_t k;
    std::vector<Near> near;  // ascending
  };

  void add(std::vector<std::size_t> records) { candidates_.push_back({std::move(records), 0}); }

  NearFit fit_of(std::size_t k, std::size_t record) const {
    const int rank = rank_of(run_, run_.claim.points[k], record);
    if (rank == 2) return NearFit::kWrongIndex;
    const bool is_right = has_right_values(run_, k, record);
    if (rank == 0) return is_right ? NearFit::kRight : NearFit::kWrongValue;
    return is_right ? NearFit::kMade : NearFit::kWrongMade;
  }

  std::vector<Near> near(std::size_t k) const {
    const ClaimedPosition& at = run_.claim.points[k].center.value();
    const RationalPoint x = values_of(at);
    std::vector<Near> within, nearly;
    for (const std::size_t record : grid_.near(at)) {
      const ExactSphere& sphere = grid_.sphere(record);
      const ValueMatch match = match_position(at, sphere.center, ValueScale(sphere, run_.options.tolerance));
      if (match == ValueMatch::kOff) continue;
      std::vector<Near>& to = is_wrong(match) ? nearly : within;
      to.push_back({fit_of(k, record), squared_distance(x, sphere.center), record});
      // A position that equals a centre exactly names that stationary point.
      if (match == ValueMatch::kEqual) return {within.back()};
    }
    // What an exact coordinate excludes is meant only if nothing else can be.
    if (within.empty()) within = std::move(nearly);
    std::sort(within.begin(), within.end());
    return within;
  }

  // Where a claim without a partner is placed: it is what a perturbation makes of a regular stationary point, or it has
  // a wrong distance, or it is a second claim.
  std::size_t second_best(const std::vector<Near>& near) {
    const auto made = std::ranges::find(near, NearFit::kMade, &Near::fit);
    if (made != near.end()) return made->record;
    const auto free = std::ranges::find_if(
        near, [this](const Near& one) { return one.fit == NearFit::kWrongValue && !is_taken_[one.record]; });
    const std::size_t record = free != near.end() ? free->record : near.front().record;
    is_taken_[record] = true;
    return record;
  }

  void place(const Found& found, const std::optional<std::size_t>& partner) {
    const auto& [k, near] = found;
    if (near.empty()) return;
    PlacedPoint& placed = run_.placed[k];
    placed.place = Placement{partner ? *partner : second_best(near), Fit::kPosition};
    placed.is_one_of_several = std::ranges::count(near, NearFit::kRight, &Near::fit) > 1;
    if (near.size() == 1) return;
    std::string others;
    for (const Near& one : near) others += (others.empty() ? "" : "; ") + stationary_text(run_.truth, one.record);
    run_.vary(2, FindingReason::kAmbiguous, "FC-CLAIM-05", k,
              std::to_string(near.size()) + " stationary points are within the tolerance: " + others);
  }

  CheckRun& run_;
  PositionGrid grid_;
  std::vector<bool> is_taken_;         // by stationary point
  std::vector<Found> found_;           // claims by position
  std::deque<Candidates> candidates_;  // of claims by contact set, and then of those by position
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

NamedTarget named_target(CheckRun& run, const ClaimedTarget& target) {
  if (target.is_infinity) return {true, std::nullopt, Fit::kWhole};
  const std::optional<Placement> place = placement_of(run, class_names(run.points, target.contact));
  if (!place) return {false, std::nullopt, Fit::kOther};
  return {true, place->record, place->fit};
}

void place_points(CheckRun& run) {
  bool has_positions = false;
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
    run.show_progress(2, k, run.placed.size());
    PlacedPoint& placed = run.placed[k];
    if (!placed.is_well_formed) continue;
    if (!placed.names.empty()) {
      placed.place = placement_of(run, placed.names);
      continue;
    }
    run.note_exactness(is_exact(*run.claim.points[k].center));
    has_positions = true;
  }
  if (has_positions) ByPosition(run).place_all();
}

}  // namespace flowcert::certify
