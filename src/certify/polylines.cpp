// Level 5: unstable manifolds U2 as polylines, segment by segment (FC-CLAIM-08). Where the orbit ends at a stationary
// point that is no maximum, a polyline may go on as a perturbation would let it. What goes on is judged, too.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/leaving_segment.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

constexpr char kPolylineClause[] = "FC-CLAIM-08";

// What is wrong with a polyline, and in which segment.
struct Difference {
  bool is_wrong = false;
  bool by_rounding = false;
  std::string claimed;
  std::string truth;
};

Difference wrong(const std::string& claimed, const std::string& truth) { return {true, false, claimed, truth}; }

// For claimed and for true positions.
template <typename Position>
std::string place_text(const std::optional<Position>& end) {
  return end ? position_text(*end) : "infinity";
}

class Polylines {
 public:
  explicit Polylines(CheckRun& run) : run_(run) {}

  // For an index-2 critical point.
  void check(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    const ClaimedPoint& point = run_.claim.points[k];
    scale_.emplace(run_.truth.sphere(record), run_.options.tolerance);
    for (std::size_t side = 0; side < 2; ++side) {
      rest_ = (*point.u2)[side];
      done_ = 0;
      variation_.clear();
      is_end_known_ = true;
      const std::size_t true_side = run_.true_side(k, side);
      Difference found = follow({run_.truth.polyline(record, true_side), run_.truth.limits(record).at(true_side)});
      if (!found.is_wrong) found = difference_of_limits(point, side);
      report(k, side, found);
    }
  }

 private:
  void report(std::size_t k, std::size_t side, const Difference& found) {
    const std::string where = "side " + std::to_string(side) + ", ";
    if (found.is_wrong) {
      run_.find(5, rounding_or(FindingReason::kWrongPolyline, found.by_rounding), kPolylineClause, k, found.truth,
                where + found.claimed);
    } else if (!variation_.empty()) {
      run_.vary(5, FindingReason::kSymbolicPerturbation, "FC-CLAIM-07", k, variation_,
                where + std::to_string((*run_.claim.points[k].u2)[side].size()) + " segments");
    }
  }

  // Takes the segments of this path from the claim, and then what it may go on with.
  Difference follow(TruePath truth) {
    while (true) {
      Difference found = difference(truth);
      end_ = truth.limit;
      if (found.is_wrong || rest_.empty()) return found;
      if (!truth.limit || run_.index(*truth.limit) == kMaximum) {
        return wrong(std::to_string(done_ + rest_.size()) + " segments",
                     std::to_string(done_) + " segments, to " + end_text(truth.limit));
      }
      const std::size_t y = *truth.limit;
      if (variation_.empty()) {
        variation_ = std::to_string(done_) + " segments, to a " + stationary_text(run_.truth, y);
      }
      if (run_.index(y) == kIndex2) {
        truth = orbit_beyond(y);
        continue;
      }
      if (!rest_.front().end || !is_exact(*rest_.front().end)) return stop_judging(y);
      found = leave(y, truth);
      if (found.is_wrong) return found;
    }
  }

  // Whether the claim goes on beyond the end of a path, for which it takes so many segments.
  [[nodiscard]] bool goes_on(const TruePath& truth, std::size_t taken) const {
    return rest_.size() > taken && truth.limit && run_.index(*truth.limit) != kMaximum;
  }

  // The one of the two orbits of an index-2 point whose first end is as the claim goes on, or is nearer to that.
  TruePath orbit_beyond(std::size_t y) {
    const auto way = [&](std::size_t side) {
      return TruePath{run_.truth.polyline(y, side), run_.truth.limits(y).at(side)};
    };
    TruePath first = way(0), second = way(1);
    const std::optional<ClaimedPosition>& end = rest_.front().end;
    const auto has_such_end = [&](const TruePath& path) {
      return path.segments.front().end.has_value() == end.has_value();
    };
    if (!has_such_end(first)) return second;
    if (!end || !has_such_end(second)) return first;
    const RationalPoint at = values_of(*end);
    const auto off = [&](const TruePath& path) { return squared_distance(at, *path.segments.front().end); };
    return off(second) < off(first) ? second : first;
  }

  // Takes the first claimed segment beyond a regular stationary point. The path is what follows then.
  Difference leave(std::size_t y, TruePath& path) {
    const RationalPoint from = run_.truth.sphere(y).center, to = values_of(*rest_.front().end);
    const LeavingSegment segment(run_.points, run_.truth.contact(y), from, to);
    if (!segment.is_flow()) {
      return wrong(segment_text() + "end " + place_text(rest_.front().end),
                   "no perturbation lets the orbit go there from the " + stationary_text(run_.truth, y));
    }
    path = run_.truth.orbit(to);
    const bool is_arrival = path.segments.empty() && goes_on(path, 1);
    Difference found = difference(rest_.front(), {segment.type(), from, to}, segment_text(), is_arrival);
    if (!found.is_wrong) take(1);
    return found;
  }

  // Where the flow goes on is not known from a position in decimals, and infinity gives no direction.
  Difference stop_judging(std::size_t y) {
    const ClaimedSegment& segment = rest_.front();
    const RationalPoint position = run_.truth.sphere(y).center;
    if (segment.driver && is_wrong(matched(*segment.driver, position))) {
      return wrong(segment_text() + "driver " + position_text(*segment.driver), "driver " + position_text(position));
    }
    const std::string first(1, face_letter(run_.points, run_.truth.contact(y)));
    if (!segment.type.empty() && !is_segment_type(segment.type)) {
      return wrong(segment_text() + "type " + segment.type, "there is no such type (FC-FLOW-02)");
    }
    if (!segment.type.empty() && (!segment.type.starts_with(first) || segment.type.ends_with("inf") != !segment.end)) {
      return wrong(segment_text() + "type " + segment.type,
                   "it begins with " + first + (segment.end ? " and does not go to infinity" : " and ends with inf"));
    }
    run_.leave_unjudged(
        "what of a polyline lies beyond a regular stationary point, if it is claimed in decimals or goes to infinity "
        "at once (FC-CLAIM-08)");
    is_end_known_ = false;
    if (!rest_.front().end && rest_.size() > 1) return wrong(segment_text() + "end infinity", "nothing comes after it");
    return {};
  }

  // A claimed limit has to be where the polyline ends.
  Difference difference_of_limits(const ClaimedPoint& point, std::size_t side) {
    if (!is_end_known_ || !point.successors || !point.successors_by_side) return {};
    const ClaimedTarget& target = point.successors->at(side);
    const NamedTarget claimed = named_target(run_, target);
    if (!claimed.is_known) return {};  // wrong on level 4
    if (claimed.limit == end_) return {};
    return wrong("the limit " + target_text(target),
                 "the polyline goes to " + (end_ ? "a " + stationary_text(run_.truth, *end_) : "infinity"));
  }

  [[nodiscard]] std::string end_text(const std::optional<std::size_t>& limit) {
    return limit ? position_text(run_.truth.sphere(*limit).center) : "infinity";
  }
  [[nodiscard]] std::string segment_text() const { return "segment " + std::to_string(done_ + 1) + ": "; }
  void take(std::size_t count) {
    rest_ = rest_.subspan(count);
    done_ += count;
  }

  // Takes the segments of the path.
  Difference difference(const TruePath& truth) {
    const std::size_t all = done_ + rest_.size(), true_all = done_ + truth.segments.size();
    for (const TrueSegment& segment : truth.segments) {
      const bool is_arrival = &segment == &truth.segments.back() && goes_on(truth, 1);
      if (rest_.empty()) {
        return wrong(std::to_string(all) + " segments",
                     std::to_string(true_all) + " segments, to " + end_text(truth.limit));
      }
      Difference found = difference(rest_.front(), segment, segment_text(), is_arrival);
      if (found.is_wrong) return found;
      take(1);
    }
    return {};
  }

  // is_arrival: it comes to a stationary point beyond which the claim goes on.
  Difference difference(const ClaimedSegment& claimed, const TrueSegment& truth, const std::string& where,
                        bool is_arrival) {
    const bool has_other_type = !claimed.type.empty() && claimed.type != truth.type;
    if (has_other_type && !(is_arrival && can_arrive_as(claimed.type, truth.type))) {
      return wrong(where + "type " + claimed.type, "type " + truth.type);
    }
    if (claimed.driver) {
      const ValueMatch match = matched(*claimed.driver, truth.driver);
      if (is_wrong(match)) {
        return {true, match == ValueMatch::kRounding, where + "driver " + position_text(*claimed.driver),
                "driver " + position_text(truth.driver)};
      }
    }
    ValueMatch match = ValueMatch::kEqual;
    if (claimed.end.has_value() != truth.end.has_value()) match = ValueMatch::kOff;
    if (claimed.end && truth.end) match = matched(*claimed.end, *truth.end);
    if (!is_wrong(match)) return {};
    return {true, match == ValueMatch::kRounding, where + "end " + place_text(claimed.end),
            "end " + place_text(truth.end)};
  }

  ValueMatch matched(const ClaimedPosition& claimed, const RationalPoint& truth) {
    return run_.match(claimed, truth, *scale_);
  }

  CheckRun& run_;
  std::optional<ValueScale> scale_;
  std::span<const ClaimedSegment> rest_;  // the claimed segments that are not judged yet
  std::size_t done_ = 0;                  // how many are
  std::string variation_;                 // where the true orbit ends, if the claimed one goes on
  std::optional<std::size_t> end_;        // where the polyline ends, if is_end_known_; none: infinity
  bool is_end_known_ = true;
};

}  // namespace

bool check_polylines(CheckRun& run) {
  Polylines polylines(run);
  return run.judge_each(5, 0, kPartsOfLevel5, [&](std::size_t k) {
    if (!run.claim.points[k].u2 || !run.can_follow(k, "polylines")) return false;
    polylines.check(k);
    return true;
  });
}

}  // namespace flowcert::certify
