// Where the points of a claim are among the true stationary points: by contact sets where they are claimed,
// otherwise by position.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "certify/check_run.h"
#include "certify/contact_geometry.h"
#include "certify/finding_words.h"
#include "certify/position_grid.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

Fit fit_of_part(const CheckRun& run, const std::vector<PointId>& names, std::size_t record) {
  const int dimension = run.index(record).hull_dimension;
  const bool is_simplex = static_cast<int>(names.size()) == dimension + 1;
  return is_simplex && affine_dimension(run.points, names) == dimension ? Fit::kPart : Fit::kOther;
}

// Where a claim belongs best: at a point of its index or kind, where it is the only one (0); at a regular
// stationary point, where a perturbation may make it with others (1); elsewhere (2).
int rank_of(const CheckRun& run, const ClaimedPoint& point, std::size_t record) {
  const StationaryIndex index = run.index(record);
  const int hull_dimension = point.hull_dimension.value_or(point.index);
  if (index.face_dimension == point.index && index.hull_dimension == hull_dimension) return 0;
  const bool is_between = index.face_dimension <= point.index && point.index <= index.hull_dimension;
  return !index.is_critical() && !point.hull_dimension && is_between ? 1 : 2;
}

// Claims by position. What is within the tolerance of several claims and they of it are matched so that as
// many as possible find a point of their own: then no right claim is taken for a second one of the same.
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
    std::vector<Candidate> within;
    for (const std::size_t record : grid_.near(at)) {
      const ExactSphere& sphere = grid_.sphere(record);
      const ValueMatch match = match_position(at, sphere.center, ValueScale(sphere, run_.options.tolerance));
      if (match == ValueMatch::kOff) continue;
      within.push_back({rank_of(run_, point, record), squared_distance(x, sphere.center), record});
      // An exact position that is one of them names that one.
      if (match == ValueMatch::kEqual) return {within.back()};
    }
    std::sort(within.begin(), within.end());
    return within;
  }

  // An augmenting path (Kuhn's algorithm), among the candidates of rank 0.
  bool find_own(std::size_t k) {
    for (const Candidate& candidate : candidates_.at(k)) {
      if (candidate.rank > 0) break;
      if (!tried_.insert(candidate.record).second) continue;
      const auto owner = owner_.find(candidate.record);
      if (owner == owner_.end() || find_own(owner->second)) {
        owner_[candidate.record] = k;
        return true;
      }
    }
    return false;
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
  std::map<std::size_t, std::size_t> owner_;                  // of a stationary point, the claimed point
  std::set<std::size_t> tried_;
};

}  // namespace

std::optional<Placement> placement_of(CheckRun& run, const std::vector<PointId>& names) {
  if (const auto whole = run.contacts.find(names)) return Placement{*whole, Fit::kWhole};
  const std::vector<std::size_t> larger = run.contacts.larger(names);
  if (larger.empty()) return std::nullopt;
  const ExactSphere sphere = exact_sphere(run.points, names);
  for (const std::size_t record : larger) {
    if (run.truth.sphere(record).center == sphere.center)
      return Placement{record, fit_of_part(run, names, record)};
  }
  return std::nullopt;
}

void place_points(CheckRun& run) {
  std::optional<ByPosition> by_position;
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
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
