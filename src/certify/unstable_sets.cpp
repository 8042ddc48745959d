// Level 5 for unstable sets of dimension 2 (FC-CLAIM-17): each claimed part must be a true one, and each true part must
// be claimed once. No perturbation excuses a difference.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/piece_comparison.h"

namespace flowcert::certify {

namespace {

constexpr std::size_t kMostCornersShown = 4;

// ---- Parts in words ----
// Claimed parts and true ones have members of the same names.

std::string corner_text(const auto& corner) {
  return (corner.at_infinity ? "infinity along " : "") + position_text(corner.position);
}

std::string ends_text(const auto& from, const auto& to) { return " from " + from + " to " + to; }

std::string vertex_text(const auto& vertex) { return "the Voronoi vertex " + position_text(vertex); }

std::string trace_text(const auto& trace) {
  return "a trace of " + names_text(trace.polygon) + ends_text(corner_text(trace.from), corner_text(trace.to));
}

std::string run_text(const auto& run) {
  return "a run of " + names_text(run.polygon) + ends_text(corner_text(run.from), corner_text(run.to));
}

std::string sheet_text(const auto& sheet) {
  std::string text = "a sheet of " + names_text(sheet.samples);
  if (sheet.corners.empty()) return text + ", the whole facet";
  text += " with " + std::to_string(sheet.corners.size()) + " corners: ";
  for (std::size_t i = 0; i < std::min(sheet.corners.size(), kMostCornersShown); ++i) {
    text += (i == 0 ? "" : ", ") + corner_text(sheet.corners[i]);
  }
  return sheet.corners.size() > kMostCornersShown ? text + ", ..." : text;
}

std::string segment_text(const auto& segment) {
  return "a segment of " + names_text(segment.samples) +
         ends_text(position_text(segment.start), corner_text(segment.end));
}

// ---- Claimed parts and true ones ----

// Gives claimed parts true ones as partners, one to each. As many as possible get one, also where several true parts
// are within the tolerance of one claimed part.
class Partners {
 public:
  // Both are places in lists.
  using Match = std::function<ValueMatch(std::size_t claimed, std::size_t truth)>;
  // True parts among which the partner is looked for. Claimed parts are mostly in their order.
  struct Group {
    std::vector<std::size_t> parts;
    std::size_t next = 0;
  };

  Partners(std::size_t true_count, Match match) : match_(std::move(match)), claimed_(true_count) {}

  // Returns whether the claimed part has a partner now. All parts that may have a common partner must have one group.
  bool find(std::size_t claimed, Group& group) {
    for (std::size_t step = 0; step < group.parts.size(); ++step) {
      const std::size_t at = (group.next + step) % group.parts.size(), part = group.parts[at];
      if (claimed_[part] || is_wrong(match_(claimed, part))) continue;
      claimed_[part] = claimed;
      group.next = at + 1;
      return true;
    }
    std::vector<bool> is_tried(claimed_.size());
    return find_by_exchange(claimed, group, is_tried);
  }
  [[nodiscard]] bool is_claimed(std::size_t part) const { return claimed_[part].has_value(); }

 private:
  // Takes the partner of another one, if that can have a different one.
  bool find_by_exchange(std::size_t claimed, const Group& group, std::vector<bool>& is_tried) {
    for (const std::size_t part : group.parts) {
      if (is_tried[part] || is_wrong(match_(claimed, part))) continue;
      is_tried[part] = true;
      if (claimed_[part] && !find_by_exchange(*claimed_[part], group, is_tried)) continue;
      claimed_[part] = claimed;
      return true;
    }
    return false;
  }

  Match match_;
  std::vector<std::optional<std::size_t>> claimed_;  // by true part
};

std::vector<std::size_t> places_below(std::size_t count) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

class UnstableSets {
 public:
  explicit UnstableSets(CheckRun& run) : run_(run) {}

  void check(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    const ClaimedUnstableSurface& claimed = *run_.claim.points[k].u1;
    const UnstableSurface truth = run_.truth.unstable_surface(record);
    const ValueScale scale(run_.truth.sphere(record), run_.options.tolerance);
    note_exactness(claimed);
    check_vertices(k, claimed.vertices, truth.vertices, scale);
    const auto polygon = [](const auto& part) { return std::span<const PointId>(part.polygon); };
    const auto samples = [](const auto& part) { return std::span<const PointId>(part.samples); };
    const auto interval = [&](const ClaimedUnstableInterval& a, const UnstableInterval& b) {
      return match_interval(a, b, scale);
    };
    judge(k, claimed.traces, truth.traces, polygon, interval, "traces", [](const auto& t) { return trace_text(t); });
    judge(k, claimed.runs, truth.runs, polygon, interval, "runs", [](const auto& r) { return run_text(r); });
    judge(
        k, claimed.sheets, truth.sheets, samples,
        [&](const ClaimedUnstableSheet& a, const UnstableSheet& b) { return match_sheet(a, b, scale); }, "sheets",
        [](const auto& sheet) { return sheet_text(sheet); });
    judge(
        k, claimed.segments, truth.segments, samples,
        [&](const ClaimedUnstableSegment& a, const UnstableSegment& b) {
          return std::max(match_position(a.start, b.start, scale), match_corner(a.end, b.end, scale));
        },
        "segments", [](const auto& segment) { return segment_text(segment); });
  }

 private:
  // A report is exact if all positions and vectors are.
  void note_exactness(const ClaimedUnstableSurface& claimed) {
    bool all = std::ranges::all_of(claimed.vertices, &is_exact);
    const auto note = [&all](const ClaimedCorner& corner) { all = all && is_exact(corner.position); };
    for (const auto* intervals : {&claimed.traces, &claimed.runs}) {
      for (const ClaimedUnstableInterval& interval : *intervals) note(interval.from), note(interval.to);
    }
    for (const ClaimedUnstableSheet& sheet : claimed.sheets) std::ranges::for_each(sheet.corners, note);
    for (const ClaimedUnstableSegment& segment : claimed.segments) {
      all = all && is_exact(segment.start);
      note(segment.end);
    }
    run_.report.is_exact = run_.report.is_exact && all;
  }

  ValueMatch match_corner(const ClaimedCorner& claimed, const SurfaceCorner& truth, const ValueScale& scale) const {
    if (claimed.at_infinity != truth.at_infinity) return ValueMatch::kOff;
    return truth.at_infinity ? match_vector(claimed.position, truth.position, run_.options.tolerance)
                             : match_position(claimed.position, truth.position, scale);
  }

  ValueMatch match_interval(const ClaimedUnstableInterval& claimed, const UnstableInterval& truth,
                            const ValueScale& scale) const {
    const auto match = [&](const ClaimedCorner& from, const ClaimedCorner& to) {
      const ValueMatch first = match_corner(from, truth.from, scale);
      return first == ValueMatch::kOff ? first : std::max(first, match_corner(to, truth.to, scale));
    };
    const ValueMatch forward = match(claimed.from, claimed.to);
    return is_wrong(forward) ? std::min(forward, match(claimed.to, claimed.from)) : forward;
  }

  ValueMatch match_sheet(const ClaimedUnstableSheet& claimed, const UnstableSheet& truth,
                         const ValueScale& scale) const {
    if (claimed.corners.empty() && truth.corners.empty()) return ValueMatch::kEqual;
    return match_ring(claimed.corners, truth.corners, [&](const ClaimedCorner& corner, const SurfaceCorner& other) {
      return match_corner(corner, other, scale);
    });
  }

  // True vertices are in lexicographic order. Claimed ones are taken in theirs, so that each is near its partner.
  void check_vertices(std::size_t k, const std::vector<ClaimedPosition>& claimed,
                      const std::vector<RationalPoint>& truth, const ValueScale& scale) {
    std::vector<std::size_t> order = places_below(claimed.size());
    std::ranges::sort(order, {}, [&](std::size_t i) { return values_of(claimed[i]); });
    const Partners::Match match = [&](std::size_t i, std::size_t j) {
      return match_position(claimed[i], truth[j], scale);
    };
    Partners partners(truth.size(), match);
    Partners::Group all{places_below(truth.size()), 0};
    std::vector<std::size_t> strange;
    for (const std::size_t i : order) {
      if (!partners.find(i, all)) strange.push_back(i);
    }
    std::ranges::sort(strange);
    const bool is_rounding =
        std::ranges::all_of(strange, [&](std::size_t i) { return best_match(i, all, match) == ValueMatch::kRounding; });
    report(k, strange, is_rounding, partners, "Voronoi vertices", claimed, truth,
           [](const auto& vertex) { return vertex_text(vertex); });
  }

  static ValueMatch best_match(std::size_t claimed, const Partners::Group& group, const Partners::Match& match) {
    ValueMatch best = ValueMatch::kOff;
    for (const std::size_t part : group.parts) best = std::min(best, match(claimed, part));
    return best;
  }

  // Only true parts of the same names can be partners.
  template <typename Claimed, typename True, typename Names, typename Match, typename Text>
  void judge(std::size_t k, const std::vector<Claimed>& claimed, const std::vector<True>& truth, const Names& names,
             const Match& match_parts, const std::string& what, const Text& text) {
    std::map<std::vector<PointId>, Partners::Group> groups;
    for (std::size_t j = 0; j < truth.size(); ++j) {
      groups[class_names(run_.points, names(truth[j]))].parts.push_back(j);
    }
    const Partners::Match match = [&](std::size_t i, std::size_t j) { return match_parts(claimed[i], truth[j]); };
    Partners partners(truth.size(), match);
    std::vector<std::size_t> strange;
    bool is_rounding = true;
    for (std::size_t i = 0; i < claimed.size(); ++i) {
      const auto group = groups.find(class_names(run_.points, names(claimed[i])));
      if (group != groups.end() && partners.find(i, group->second)) continue;
      strange.push_back(i);
      is_rounding =
          is_rounding && group != groups.end() && best_match(i, group->second, match) == ValueMatch::kRounding;
    }
    report(k, strange, is_rounding, partners, what, claimed, truth, text);
  }

  template <typename Claimed, typename True, typename Text>
  void report(std::size_t k, const std::vector<std::size_t>& strange, bool is_rounding, const Partners& partners,
              const std::string& what, const std::vector<Claimed>& claimed, const std::vector<True>& truth,
              const Text& text) {
    if (!strange.empty()) {
      find(k, is_rounding ? FindingReason::kRounding : FindingReason::kWrongUnstableSet, text(claimed[strange.front()]),
           "there is none, or it is claimed already (in all " + std::to_string(strange.size()) + " such " + what + ")");
      return;
    }
    std::optional<std::size_t> first;
    std::size_t missing = 0;
    for (std::size_t j = 0; j < truth.size(); ++j) {
      if (partners.is_claimed(j)) continue;
      if (!first) first = j;
      ++missing;
    }
    if (!first) return;
    find(k, FindingReason::kWrongUnstableSet, "too few " + what,
         "there is " + text(truth[*first]) + " (in all " + std::to_string(missing) + " such " + what + ")");
  }

  void find(std::size_t k, FindingReason reason, const std::string& claimed, const std::string& truth) {
    run_.find(5, reason, "FC-UNST-04", k, truth);
    run_.report.findings.back().claimed += ", " + claimed;
  }

  CheckRun& run_;
};

}  // namespace

bool check_unstable_sets(CheckRun& run) {
  UnstableSets sets(run);
  bool judged = false;
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
    run.tell(5, 4 * run.placed.size() + k, kPartsOfLevel5 * run.placed.size());
    if (!run.claim.points[k].u1 || !run.placed[k].is_right) continue;
    if (run.perturbed.contains(run.placed[k].place->record)) {
      run.leave_unjudged("unstable sets of the points that a perturbation makes of stationary points");
      continue;
    }
    sets.check(k);
    judged = true;
  }
  return judged;
}

}  // namespace flowcert::certify
