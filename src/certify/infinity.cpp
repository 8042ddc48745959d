// Level 5 for what flows to infinity: the pieces of its skeleton (FC-CLAIM-16). Each claimed piece must be a true one,
// and each true piece must be claimed once. No perturbation excuses a difference.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/piece_comparison.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

class InfinityPieces {
 public:
  explicit InfinityPieces(CheckRun& run)
      : run_(run), claimed_(*run.claim.infinity), unbounded_(run.truth.stable_set(std::nullopt)) {
    move_bounded(unbounded_.segments, bounded_.segments);
    move_bounded(unbounded_.intervals, bounded_.intervals);
    move_bounded(unbounded_.sectors, bounded_.sectors);
  }

  void check() {
    judge_all(claimed_.bounded, bounded_, "");
    judge_all(claimed_.unbounded, unbounded_, "unbounded ");
  }

 private:
  // Nothing is copied: a piece has many exact numbers.
  template <typename Piece>
  static void move_bounded(std::vector<Piece>& pieces, std::vector<Piece>& bounded) {
    const auto first =
        std::stable_partition(pieces.begin(), pieces.end(), [](const Piece& piece) { return is_unbounded(piece); });
    std::move(first, pieces.end(), std::back_inserter(bounded));
    pieces.erase(first, pieces.end());
  }

  void judge_all(const StableSet<ClaimedPosition>& claimed, const StableSet<>& truth, const std::string& which) {
    judge(claimed.segments, truth.segments, which + "segment");
    judge(claimed.intervals, truth.intervals, which + "interval");
    judge(claimed.sectors, truth.sectors, which + "sector");
  }

  template <typename Claimed, typename True>
  void judge(const std::vector<Claimed>& claimed, const std::vector<True>& truth, const std::string& what) {
    const auto match = [this](const auto& x, const auto& y, const True& piece) {
      return match_corner(x, y, names_in(piece)[0]);
    };
    const Comparison found = piece_matcher(run_.points, claimed, truth, match).compare();
    if (!found.strange.empty()) {
      find(rounding_or(FindingReason::kWrongSurface, found.is_rounding),
           "infinity, an " + what + " of " + names_text(names_in(claimed[found.strange.front()])),
           "no such " + what + " flows there (in all " + std::to_string(found.strange.size()) + " such claims)");
      return;
    }
    const auto missing = std::ranges::count(found.is_claimed, false);
    if (missing == 0) return;
    find(FindingReason::kWrongSurface, "infinity, " + std::to_string(claimed.size()) + " " + what + "s",
         std::to_string(missing) + " more flow there");
  }

  void find(FindingReason reason, const std::string& claimed, const std::string& truth) {
    run_.report.findings.push_back({.level = 5,
                                    .reason = reason,
                                    .clause = "FC-CLAIM-16",
                                    .line = claimed_.line,
                                    .claimed = claimed,
                                    .truth = truth});
  }

  // Near means near as a part of the distance from there to the samples.
  ValueMatch match_corner(const Corner<ClaimedPosition>& claimed, const Corner<>& truth, PointId name) {
    const Rational far = squared_distance(truth.position, sample(run_.points, name));
    return run_.match(claimed, truth, ValueScale({truth.position, far}, run_.options.tolerance));
  }

  CheckRun& run_;
  const ClaimedInfinity& claimed_;
  StableSet<> unbounded_, bounded_;  // of the truth
};

}  // namespace

bool check_infinity(CheckRun& run) {
  if (!run.claim.infinity) return false;
  InfinityPieces(run).check();
  return true;
}

}  // namespace flowcert::certify
