// Level 5: unstable manifolds U2 as polylines, segment by segment (FC-CLAIM-08).
#include <array>
#include <string>

#include "certify/check_run.h"
#include "certify/finding_words.h"

namespace flowcert::certify {

namespace {

constexpr char kPolylineClause[] = "FC-CLAIM-08";

// What is wrong with a polyline, and in which segment.
struct Difference {
  bool is_wrong = false;
  bool by_rounding = false;
  bool goes_on = false;  // it only goes on beyond the end of the true orbit
  std::string claimed;
  std::string truth;
};

// For claimed and for true positions.
template <typename Position>
std::string end_text(const std::optional<Position>& end) {
  return end ? position_text(*end) : "infinity";
}

class Polylines {
 public:
  explicit Polylines(CheckRun& run) : run_(run) {}

  // For an index-2 critical point.
  void check(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    const auto& claimed = *run_.claim.points[k].u2;
    const ValueScale scale(run_.truth.sphere(record), run_.options.tolerance);
    for (std::size_t side = 0; side < 2; ++side) {
      const Difference found = difference(claimed[side], run_.truth.polyline(record, side), scale);
      if (found.is_wrong) report(k, side, found);
    }
  }

 private:
  void report(std::size_t k, std::size_t side, const Difference& found) {
    if (found.goes_on && ends_below(run_.placed[k].place->record, side)) {
      run_.vary(5, FindingReason::kSymbolicPerturbation, "FC-CLAIM-07", k, found.truth);
    } else {
      run_.find(5, found.by_rounding ? FindingReason::kRounding : FindingReason::kWrongPolyline, kPolylineClause, k,
                found.truth);
    }
    run_.report.findings.back().claimed += ", side " + std::to_string(side) + ", " + found.claimed;
  }

  // Whether the true orbit ends at a stationary point that is no maximum.
  bool ends_below(std::size_t record, std::size_t side) {
    const auto limit = run_.truth.limits(record).at(side);
    return limit && run_.index(*limit) != StationaryIndex{3, 3};
  }

  // The true orbit has at least one segment, because it leaves its index-2 critical point.
  Difference difference(const ClaimedPolyline& claimed, const std::vector<TrueSegment>& truth,
                        const ValueScale& scale) {
    for (std::size_t i = 0; i < claimed.size() && i < truth.size(); ++i) {
      Difference found = difference(claimed[i], truth[i], "segment " + std::to_string(i + 1) + ": ", scale);
      if (found.is_wrong) return found;
    }
    if (claimed.size() == truth.size()) return {};
    return {true, false, claimed.size() > truth.size(), std::to_string(claimed.size()) + " segments",
            std::to_string(truth.size()) + " segments, to " + end_text(truth.back().end)};
  }

  Difference difference(const ClaimedSegment& claimed, const TrueSegment& truth, const std::string& where,
                        const ValueScale& scale) {
    if (!claimed.type.empty() && claimed.type != truth.type) {
      return {true, false, false, where + "type " + claimed.type, "type " + truth.type};
    }
    if (claimed.driver) {
      const ValueMatch match = matched(*claimed.driver, truth.driver, scale);
      if (is_wrong(match)) {
        return {true, match == ValueMatch::kRounding, false, where + "driver " + position_text(*claimed.driver),
                "driver " + position_text(truth.driver)};
      }
    }
    ValueMatch match = ValueMatch::kEqual;
    if (claimed.end.has_value() != truth.end.has_value()) match = ValueMatch::kOff;
    if (claimed.end && truth.end) match = matched(*claimed.end, *truth.end, scale);
    if (!is_wrong(match)) return {};
    return {true, match == ValueMatch::kRounding, false, where + "end " + end_text(claimed.end),
            "end " + end_text(truth.end)};
  }

  ValueMatch matched(const ClaimedPosition& claimed, const RationalPoint& truth, const ValueScale& scale) {
    run_.report.is_exact = run_.report.is_exact && is_exact(claimed);
    return match_position(claimed, truth, scale);
  }

  CheckRun& run_;
};

}  // namespace

bool check_polylines(CheckRun& run) {
  Polylines polylines(run);
  bool judged = false;
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
    const ClaimedPoint& point = run.claim.points[k];
    if (!point.u2 || !run.placed[k].is_right) continue;
    if (run.index(run.placed[k].place->record) != StationaryIndex{2, 2}) {
      run.leave_unjudged("polylines of the points that a perturbation makes of regular stationary points");
      continue;
    }
    polylines.check(k);
    judged = true;
  }
  return judged;
}

}  // namespace flowcert::certify
