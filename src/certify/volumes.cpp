// Level 5 for volumes: of stable sets, their shares in Voronoi cells, and of the convex hull (FC-CLAIM-15). What is
// claimed exactly is compared exactly.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"

namespace flowcert::certify {

namespace {

// Whether a decimal is right for every volume whose nearest double is this one. It is decided without the exact volume,
// which takes long to compute.
bool is_surely_right(const ClaimedNumber& claimed, double nearest, double tolerance) {
  if (claimed.is_exact) return false;
  if (nearest_double(claimed.value) == nearest) return true;
  if (!std::isfinite(nearest) || nearest < std::numeric_limits<double>::min()) return false;
  constexpr double kLastBit = std::numeric_limits<double>::epsilon();
  const Rational low = Rational(nearest) * (1 - Rational(kLastBit)),
                 high = Rational(nearest) * (1 + Rational(kLastBit));
  return claimed.value <= low * (1 + Rational(tolerance)) && claimed.value >= high * (1 - Rational(tolerance));
}

class ClaimedVolumes {
 public:
  explicit ClaimedVolumes(CheckRun& run) : run_(run) {}

  void check_volume(std::size_t k) {
    const ClaimedPoint& point = run_.claim.points[k];
    run_.note_exactness(point.volume->is_exact);
    judge(k, *point.volume, "volume ");
    if (!point.has_rounded_volume) return;
    if (point.rounded_volume) {
      judge(k, *point.rounded_volume, "volume_double ");
    } else if (std::isfinite(run_.truth.nearest_volume(run_.placed[k].place->record))) {
      find(k, ValueMatch::kOff, "FC-VOL-01", "volume_double no double", "a double is near the volume");
    }
  }

  void check_shares(std::size_t k) {
    if (has_surely_right_shares(k)) return;
    const auto truth = run_.truth.shares(run_.placed[k].place->record);
    std::map<PointId, Rational> missing(truth.begin(), truth.end());
    for (const ClaimedShare& share : *run_.claim.points[k].shares) {
      run_.note_exactness(share.volume && share.volume->is_exact);
      const PointId name = run_.points.name(run_.points.ordinal_of_row(share.sample));
      const auto true_share = missing.find(name);
      const Rational right = true_share == missing.end() ? Rational(0) : true_share->second;
      const ValueMatch match = match_share(share, right);
      if (true_share != missing.end()) missing.erase(true_share);
      if (!is_wrong(match)) continue;
      return find(k, match, "FC-VOL-02",
                  "a share of " + double_text(share.volume) + " in the cell of " + std::to_string(share.sample),
                  right == 0 ? "there is none, or it is claimed already" : "it is " + number_text(right));
    }
    if (missing.empty()) return;
    const auto& [name, share] = *missing.begin();
    find(k, ValueMatch::kOff, "FC-VOL-02", "no share in the cell of " + std::to_string(name),
         "it is " + number_text(share) + " (in all " + std::to_string(missing.size()) + " such shares)");
  }

  void check_hull() {
    const ClaimedNumber& claimed = *run_.claim.hull_volume;
    run_.note_exactness(claimed.is_exact);
    const Rational truth = run_.truth.hull_volume();
    const ValueMatch match = match_volume(claimed, truth, run_.options.tolerance);
    if (!is_wrong(match)) return;
    run_.find_whole(5, rounding_or(FindingReason::kWrongVolume, match), "FC-CLAIM-15",
                    "a convex hull of volume " + number_text(claimed), "its volume is " + number_text(truth));
  }

 private:
  // Whether all shares are decimals that are right for every share whose nearest double is the true one's.
  bool has_surely_right_shares(std::size_t k) {
    const auto nearest = run_.truth.nearest_shares(run_.placed[k].place->record);
    std::map<PointId, double> missing(nearest.begin(), nearest.end());
    for (const ClaimedShare& share : *run_.claim.points[k].shares) {
      const auto truth = missing.find(run_.points.name(run_.points.ordinal_of_row(share.sample)));
      if (!share.volume || truth == missing.end()) return false;
      if (!is_surely_right(*share.volume, truth->second, run_.options.tolerance)) return false;
      missing.erase(truth);
    }
    if (!missing.empty()) return false;
    run_.note_exactness(nearest.empty());
    return true;
  }

  [[nodiscard]] ValueMatch match_share(const ClaimedShare& share, const Rational& truth) const {
    if (share.volume) return match_volume(*share.volume, truth, run_.options.tolerance);
    return nearest_double(truth) ? ValueMatch::kOff : ValueMatch::kWithin;
  }

  void judge(std::size_t k, const ClaimedNumber& claimed, const std::string& what) {
    const std::size_t record = run_.placed[k].place->record;
    if (is_surely_right(claimed, run_.truth.nearest_volume(record), run_.options.tolerance)) return;
    const Rational truth = run_.truth.volume(record);
    const ValueMatch match = match_volume(claimed, truth, run_.options.tolerance);
    if (!is_wrong(match)) return;
    find(k, match, "FC-VOL-01", what + number_text(claimed), "the volume is " + number_text(truth));
  }

  void find(std::size_t k, ValueMatch match, const std::string& clause, const std::string& claimed,
            const std::string& truth) {
    run_.find(5, rounding_or(FindingReason::kWrongVolume, match), clause, k, truth, claimed);
  }

  CheckRun& run_;
};

}  // namespace

bool check_volumes(CheckRun& run) {
  ClaimedVolumes volumes(run);
  const bool has_hull = run.claim.hull_volume.has_value();
  if (has_hull) volumes.check_hull();
  const bool has_points = run.judge_each(5, 3, kPartsOfLevel5, [&](std::size_t k) {
    const ClaimedPoint& point = run.claim.points[k];
    if ((!point.volume && !point.shares) || !run.can_follow(k, "volumes")) return false;
    if (point.volume) volumes.check_volume(k);
    if (point.shares) volumes.check_shares(k);
    return true;
  });
  return has_hull || has_points;
}

}  // namespace flowcert::certify
