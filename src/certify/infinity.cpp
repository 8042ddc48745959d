// Level 5 for what flows to infinity: the pieces of its skeleton (FC-CLAIM-16). Each claimed piece must be a true one,
// and each true piece must be claimed once. No perturbation excuses a difference.
#include <algorithm>
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
      : run_(run), claimed_(*run.claim.infinity), truth_(run.truth.set_of_infinity()) {}

  void check() {
    judge(claimed_.bounded.segments, truth_.bounded.segments, "segment");
    judge(claimed_.bounded.intervals, truth_.bounded.intervals, "interval");
    judge(claimed_.bounded.sectors, truth_.bounded.sectors, "sector");
    judge(claimed_.segments, truth_.segments, "unbounded segment");
    judge(claimed_.intervals, truth_.intervals, "unbounded interval");
    judge(claimed_.sectors, truth_.sectors, "unbounded sector");
  }

 private:
  template <typename Claimed, typename True>
  void judge(const std::vector<Claimed>& claimed, const std::vector<True>& truth, const std::string& what) {
    PieceNames names;
    for (const Claimed& piece : claimed) names.claimed.push_back(class_names(run_.points, names_in(piece)));
    for (const True& piece : truth) names.truth.emplace_back(names_in(piece).begin(), names_in(piece).end());
    const Comparison found =
        PieceMatcher(names, [&](std::size_t c, std::size_t i) { return match(claimed[c], truth[i]); }).compare();
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

  static const auto& names_in(const auto& piece) {
    if constexpr (requires { piece.polygon; }) {
      return piece.polygon;
    } else {
      return piece.samples;
    }
  }
  [[nodiscard]] bool has_contact(const std::optional<std::vector<PointId>>& claimed,
                                 const std::vector<PointId>& truth) const {
    return !claimed || class_names(run_.points, *claimed) == truth;
  }

  // Pieces of the same names are compared. Near means near as a part of the distance from there to the samples.
  ValueMatch match(const ClaimedPosition& claimed, const RationalPoint& truth, PointId name) {
    const Rational far = squared_distance(truth, sample(run_.points, name));
    return run_.match(claimed, truth, ValueScale({truth, far}, run_.options.tolerance));
  }

  ValueMatch match(const ClaimedBackwardSegment& claimed, const BackwardSegment& truth) {
    if (!has_contact(claimed.front_contact, truth.front_contact) || !has_back(claimed, truth)) return ValueMatch::kOff;
    return std::max(match(claimed.front, truth.front, truth.samples[0]),
                    match(claimed.back, truth.back, truth.samples[0]));
  }
  ValueMatch match(const ClaimedUnboundedSegment& claimed, const UnboundedSegment& truth) {
    if (!has_back(claimed, truth)) return ValueMatch::kOff;
    return std::max(run_.match_direction(claimed.vector, truth.vector),
                    match(claimed.back, truth.back, truth.samples[0]));
  }
  template <typename Claimed, typename True>
  [[nodiscard]] bool has_back(const Claimed& claimed, const True& truth) const {
    return has_contact(claimed.back_contact, truth.back_contact) &&
           (claimed.back_kind.empty() || claimed.back_kind == back_kind_text(truth.back_kind));
  }

  ValueMatch match(const ClaimedInterval& claimed, const BackwardInterval& truth) {
    if (!has_end(claimed, truth)) return ValueMatch::kOff;
    return std::max(match(claimed.front, truth.front, truth.polygon[0]),
                    match(claimed.back, truth.back, truth.polygon[0]));
  }
  ValueMatch match(const ClaimedUnboundedInterval& claimed, const UnboundedInterval& truth) {
    if (!has_end(claimed, truth)) return ValueMatch::kOff;
    return std::max(run_.match_direction(claimed.vector, truth.vector),
                    match(claimed.back, truth.back, truth.polygon[0]));
  }
  template <typename Claimed, typename True>
  static bool has_end(const Claimed& claimed, const True& truth) {
    return claimed.back_is_stationary.value_or(truth.back_is_stationary) == truth.back_is_stationary;
  }

  ValueMatch match(const ClaimedSector& claimed, const BackwardSector& truth) {
    return match_ring(claimed.corners, truth.corners, [&](const ClaimedPosition& corner, const RationalPoint& other) {
      return match(corner, other, truth.samples[0]);
    });
  }
  ValueMatch match(const ClaimedUnboundedSector& claimed, const UnboundedSector& truth) {
    return match_ring(claimed.corners, truth.corners, [&](const ClaimedCorner& corner, const SectorCorner& other) {
      if (corner.at_infinity != other.is_vector) return ValueMatch::kOff;
      return corner.at_infinity ? run_.match_direction(corner.position, other.position)
                                : match(corner.position, other.position, truth.samples[0]);
    });
  }

  CheckRun& run_;
  const ClaimedInfinity& claimed_;
  const InfinitySet truth_;
};

}  // namespace

bool check_infinity(CheckRun& run) {
  if (!run.claim.infinity) return false;
  InfinityPieces(run).check();
  return true;
}

}  // namespace flowcert::certify
