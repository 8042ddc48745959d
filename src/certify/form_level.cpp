// Level 1: whether a claim means something, and is about this input (FC-CLAIM-01).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>

#include "certify/check_run.h"
#include "certify/claimed_rows.h"
#include "certify/finding_words.h"
#include "certify/piece_comparison.h"
#include "flowcert/reproducibility.h"
#include "io/number_text.h"

namespace flowcert::certify {

namespace {

constexpr char kClaimClause[] = "FC-CLAIM-01";

void check_input_of_claim(CheckRun& run) {
  const PointSet& points = run.points;
  const auto number = [&](const std::optional<std::size_t>& claimed, std::size_t truth, const char* what) {
    if (!claimed || *claimed == truth) return;
    run.find_whole(1, FindingReason::kWrongCounts, "FC-IN-03", std::to_string(*claimed) + " " + what,
                   std::to_string(truth));
  };
  number(run.claim.point_count, points.row_count(), "points");
  number(run.claim.merged_duplicates, points.merged_duplicates(), "merged duplicates");
  if (run.claim.classes && *run.claim.classes != points.repeated_classes()) {
    run.find_whole(1, FindingReason::kMalformed, "FC-IN-03", "other classes of repeated points",
                   std::to_string(points.repeated_classes().size()) + " classes of more than one row");
  }
  const auto& digest = run.claim.input_sha256;
  if (digest && *digest != coordinates_sha256(run.points)) {
    run.find_whole(1, FindingReason::kMalformed, kClaimClause, "a claim about the input with SHA-256 " + *digest,
                   "the input's is " + coordinates_sha256(run.points));
  }
}

// The header's counts must be those of the claim's own list, whether that list is right or wrong.
void check_counts_of_claim(CheckRun& run) {
  std::array<std::size_t, 3> regular{};
  for (const ClaimedPoint& point : run.claim.points) {
    if (point.hull_dimension) {
      constexpr std::array<std::pair<int, int>, 3> kKinds = {{{1, 2}, {1, 3}, {2, 3}}};
      const auto* kind = std::find(kKinds.begin(), kKinds.end(), std::pair(point.index, *point.hull_dimension));
      if (kind != kKinds.end()) ++regular.at(static_cast<std::size_t>(kind - kKinds.begin()));
    } else if (point.index >= 0 && point.index <= 3) {
      ++run.report.claimed_counts.at(static_cast<std::size_t>(point.index));
    }
  }
  const auto compare = [&run](auto claimed, const auto& listed, const char* what) {
    for (std::size_t k = 0; claimed && listed.size() == 4 && k < 4; ++k) {
      if (!run.report.indices.at(k)) claimed->at(k) = listed.at(k);
    }
    if (!claimed || *claimed == listed) return;
    run.find_whole(1, FindingReason::kWrongCounts, kClaimClause, fmt::format("{} {}", fmt::join(*claimed, " "), what),
                   fmt::format("the claim itself lists {}", fmt::join(listed, " ")));
  };
  compare(run.claim.critical_counts, run.report.claimed_counts, "critical points");
  compare(run.claim.regular_counts, regular, "regular stationary points of kinds 1-2, 1-3, 2-3");
}

// What is wrong with ids, in words; empty if nothing is.
std::string complaint_about_ids(const PointSet& points, const std::vector<PointId>& ids) {
  for (const PointId id : ids) {
    if (id >= points.row_count()) {
      return "there is no point " + std::to_string(id) + "; the ids are 0 to " +
             std::to_string(static_cast<long long>(points.row_count()) - 1);
    }
  }
  std::vector<PointId> sorted = ids;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  return twice == sorted.end() ? "" : "point " + std::to_string(*twice) + " is named twice";
}

// What is wrong with the ids of contact sets, none of which may be empty. `whose` is what has them.
std::string complaint_about_contacts(const PointSet& points, const std::vector<std::vector<PointId>>& contacts,
                                     const std::string& whose) {
  for (const std::vector<PointId>& ids : contacts) {
    const std::string complaint = ids.empty() ? "a contact set without points" : complaint_about_ids(points, ids);
    if (!complaint.empty()) return "of " + whose + ": " + complaint;
  }
  return "";
}

std::string complaint_about_targets(const PointSet& points, const std::vector<ClaimedTarget>& targets,
                                    const std::string& what) {
  for (const ClaimedTarget& target : targets) {
    if (!target.is_infinity && target.contact.empty()) return "a " + what + " without a contact set";
    const std::string complaint = complaint_about_ids(points, target.contact);
    if (!complaint.empty()) return "of a " + what + ": " + complaint;
  }
  return "";
}

std::string complaint_about_index(const ClaimedPoint& point) {
  if (!point.hull_dimension) {
    return point.index < 0 || point.index > 3 ? "an index is 0, 1, 2 or 3" : "";
  }
  const bool exists = 1 <= point.index && point.index < *point.hull_dimension && *point.hull_dimension <= 3;
  return exists ? "" : "only the kinds 1-2, 1-3 and 2-3 exist";
}

std::string complaint_about_successors(const PointSet& points, const ClaimedPoint& point) {
  if (point.successors) {
    const std::string complaint = complaint_about_targets(points, *point.successors, "successor");
    if (!complaint.empty()) return complaint;
    if (point.successors_by_side && point.successors->size() != 2) return "there are two sides";
  }
  if (point.samples) {
    const std::string complaint = complaint_about_ids(points, *point.samples);
    if (!complaint.empty()) return "of the samples: " + complaint;
  }
  if (point.u2 && point.u2->size() != 2) return "an unstable manifold U2 has two orbits";
  return "";
}

std::string complaint_about_directions(const PointSet& points, const ClaimedPoint& point) {
  std::vector<ClaimedTarget> limits;
  if (point.lambda) {
    limits = point.lambda->arcs;
    for (const ClaimedDirection& direction : point.lambda->directions) limits.push_back(direction.limit);
  }
  if (point.connections) {
    for (const ClaimedConnection& connection : *point.connections) limits.push_back(connection.to);
  }
  const std::string of_limits = complaint_about_targets(points, limits, "limit");
  if (!of_limits.empty()) return of_limits;
  std::vector<PointId> samples;
  if (point.shares) {
    for (const ClaimedShare& share : *point.shares) samples.push_back(share.sample);
  }
  const std::string complaint = complaint_about_ids(points, samples);
  return complaint.empty() ? "" : "of the shares: " + complaint;
}

// Calls of this collect lists of rows.
auto adding_to(std::vector<std::vector<PointId>>& lists) {
  return [&lists](std::span<const PointId> rows) { lists.emplace_back(rows.begin(), rows.end()); };
}

// What is wrong with the ids of a stable set. The ids of a walk may repeat.
std::string complaint_about_stable(const PointSet& points, const ClaimedPoint& point) {
  std::vector<std::vector<PointId>> lists;
  if (point.stable && point.stable->boundary) lists = *point.stable->boundary;
  if (point.stable && point.stable->walk) {
    for (const PointId id : *point.stable->walk) lists.push_back({id});
  }
  if (point.skeleton) for_each_rows(*point.skeleton, adding_to(lists));
  if (point.skeleton && point.orbits) {
    for (const auto& chain : *point.orbits) {
      const bool exist =
          std::ranges::all_of(chain, [&](std::size_t place) { return place < point.skeleton->segments.size(); });
      if (!exist) return "of a stable set: an orbit along a segment that is not there";
    }
  }
  return complaint_about_contacts(points, lists, "a stable set");
}

bool is_zero_corner(const Corner<ClaimedPosition>& corner) {
  return corner.at_infinity && std::ranges::all_of(corner.position, [](const auto& x) { return x.value == 0; });
}

// What is wrong with the ids and vectors of an unstable set.
std::string complaint_about_unstable(const PointSet& points, const ClaimedPoint& point) {
  if (!point.u1) return "";
  std::vector<std::vector<PointId>> lists;
  for_each_rows(*point.u1, adding_to(lists));
  const std::string complaint = complaint_about_contacts(points, lists, "an unstable set");
  if (!complaint.empty()) return complaint;
  bool has_zero = false;
  for_each_corner(*point.u1, [&](const auto& corner) { has_zero = has_zero || is_zero_corner(corner); });
  return has_zero ? "of an unstable set: a vector that is zero" : "";
}

std::string complaint_about(const PointSet& points, const ClaimedPoint& point) {
  if (point.contact.empty() && !point.center) return "neither a contact set nor a position";
  std::string complaint = complaint_about_index(point);
  if (complaint.empty()) complaint = complaint_about_ids(points, point.contact);
  if (complaint.empty()) complaint = complaint_about_successors(points, point);
  if (complaint.empty()) complaint = complaint_about_stable(points, point);
  if (complaint.empty()) complaint = complaint_about_directions(points, point);
  if (complaint.empty()) complaint = complaint_about_unstable(points, point);
  return complaint;
}

void check_form_of_pockets(CheckRun& run) {
  const ClaimedPockets& pockets = *run.claim.pockets;
  for_each_rows(pockets, [&](const std::vector<PointId>& contact) {
    const std::string complaint = complaint_about_ids(run.points, contact);
    if (complaint.empty()) return;
    run.report.findings.push_back({.level = 1,
                                   .reason = FindingReason::kMalformed,
                                   .clause = kClaimClause,
                                   .line = pockets.line,
                                   .contact = contact,
                                   .claimed = "a contact set in a pocket",
                                   .truth = complaint});
  });
}

// A point of an index that is not judged. The claim's own header excludes it, or only who judges does.
void check_unjudged_index(CheckRun& run, std::size_t k) {
  const auto index = static_cast<std::size_t>(run.claim.points[k].index);
  if (run.claim.indices && !run.claim.indices->at(index)) {
    run.find(1, FindingReason::kMalformed, "FC-CLAIM-12", k, "the claim's header says that it is of other indices");
  } else {
    run.leave_unjudged("the claimed critical points of index " + std::to_string(index));
  }
}

}  // namespace

void check_form(CheckRun& run) {
  constexpr std::size_t kLongKey = 100;
  for (const std::string& key : run.claim.unknown_keys) {
    const std::string quoted = key.size() > kLongKey ? in_quotes(key) : "'" + key + "'";
    run.leave_unjudged("what the unknown key " + quoted + " says");
  }
  if (run.claim.has_more_unknown_keys) run.leave_unjudged("what further unknown keys say");
  if (run.claim.pockets) check_form_of_pockets(run);
  for (std::size_t index = 0; index < 4; ++index) {
    if (run.report.indices.at(index) || run.claim.pockets) continue;
    run.leave_unjudged("which critical points of index " + std::to_string(index) +
                       " there are, and what rests on them (FC-CLAIM-12)");
  }
  check_input_of_claim(run);
  check_counts_of_claim(run);
  for (std::size_t k = 0; k < run.claim.points.size(); ++k) {
    run.show_progress(1, k, run.claim.points.size());
    const ClaimedPoint& point = run.claim.points[k];
    if (!point.hull_dimension && !run.judges(point.index)) {
      check_unjudged_index(run, k);
      continue;
    }
    const std::string complaint = complaint_about(run.points, point);
    if (!complaint.empty()) {
      const bool is_kind = point.hull_dimension && !complaint_about_index(point).empty();
      run.find(1, FindingReason::kMalformed, is_kind ? "FC-CRIT-03" : kClaimClause, k, complaint);
      continue;
    }
    run.placed[k].is_well_formed = true;
    run.placed[k].names = class_names(run.points, point.contact);
  }
}

}  // namespace flowcert::certify
