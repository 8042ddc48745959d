// Level 5 for unstable sets of dimension 2 (FC-CLAIM-17): each claimed part must be a true one, and each true part must
// be claimed once. No perturbation excuses a difference.
#include <algorithm>
#include <array>
#include <numeric>
#include <span>
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

std::string edge_part_text(const char* what, const auto& part) {
  return what + names_text(part.polygon) + ends_text(corner_text(part.front), corner_text(part.back));
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
         ends_text(corner_text(segment.back), corner_text(segment.front));
}

class UnstableSets {
 public:
  explicit UnstableSets(CheckRun& run) : run_(run) {}

  void check(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    const UnstableSurface<ClaimedPosition>& claimed = *run_.claim.points[k].u1;
    const UnstableSurface<> truth = run_.truth.unstable_surface(record);
    const ValueScale scale(run_.truth.sphere(record), run_.options.tolerance);
    note_exactness(claimed);
    check_vertices(k, claimed.vertices, truth.vertices, scale);
    judge(k, claimed.traces, truth.traces, scale, "traces",
          [](const auto& trace) { return edge_part_text("a trace of ", trace); });
    judge(k, claimed.runs, truth.runs, scale, "runs", [](const auto& run) { return edge_part_text("a run of ", run); });
    judge(k, claimed.sheets, truth.sheets, scale, "sheets", [](const auto& sheet) { return sheet_text(sheet); });
    judge(k, claimed.segments, truth.segments, scale, "segments",
          [](const auto& segment) { return segment_text(segment); });
  }

 private:
  // A report is exact if all positions and vectors are.
  void note_exactness(const UnstableSurface<ClaimedPosition>& claimed) {
    bool all = std::ranges::all_of(claimed.vertices, &is_exact);
    for_each_corner(claimed, [&](const auto& corner) { all = all && is_exact(corner.position); });
    run_.note_exactness(all);
  }

  // True vertices are in lexicographic order. Claimed ones are taken in theirs, so that each is near its partner.
  void check_vertices(std::size_t k, const std::vector<ClaimedPosition>& claimed,
                      const std::vector<RationalPoint>& truth, const ValueScale& scale) {
    std::vector<std::size_t> order(claimed.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values_of(claimed[i]); });
    Comparison found = PieceMatcher(PieceNames::none(claimed.size(), truth.size()), [&](std::size_t c, std::size_t i) {
                         return match_position(claimed[order[c]], truth[i], scale);
                       }).compare();
    for (std::size_t& strange : found.strange) strange = order[strange];
    std::ranges::sort(found.strange);
    report(k, found, "Voronoi vertices", claimed, truth, [](const auto& vertex) { return vertex_text(vertex); });
  }

  template <typename Claimed, typename True, typename Text>
  void judge(std::size_t k, const std::vector<Claimed>& claimed, const std::vector<True>& truth,
             const ValueScale& scale, const std::string& what, const Text& text) {
    const auto match = [&](const auto& x, const auto& y, const True&) { return run_.match(x, y, scale); };
    report(k, piece_matcher(run_.points, claimed, truth, match).compare(), what, claimed, truth, text);
  }

  template <typename Claimed, typename True, typename Text>
  void report(std::size_t k, const Comparison& found, const std::string& what, const std::vector<Claimed>& claimed,
              const std::vector<True>& truth, const Text& text) {
    if (!found.strange.empty()) {
      find(k, rounding_or(FindingReason::kWrongUnstableSet, found.is_rounding), text(claimed[found.strange.front()]),
           "there is none, or it is claimed already (in all " + std::to_string(found.strange.size()) + " such " + what +
               ")");
      return;
    }
    const auto first = std::ranges::find(found.is_claimed, false);
    if (first == found.is_claimed.end()) return;
    find(k, FindingReason::kWrongUnstableSet, "too few " + what,
         "there is " + text(truth[static_cast<std::size_t>(first - found.is_claimed.begin())]) + " (in all " +
             std::to_string(std::ranges::count(found.is_claimed, false)) + " such " + what + ")");
  }

  void find(std::size_t k, FindingReason reason, const std::string& claimed, const std::string& truth) {
    run_.find(5, reason, "FC-UNST-04", k, truth, claimed);
  }

  CheckRun& run_;
};

}  // namespace

bool check_unstable_sets(CheckRun& run) {
  UnstableSets sets(run);
  return run.judge_each(5, 4, kPartsOfLevel5, [&](std::size_t k) {
    if (!run.claim.points[k].u1 || !run.can_follow(k, "unstable sets")) return false;
    sets.check(k);
    return true;
  });
}

}  // namespace flowcert::certify
