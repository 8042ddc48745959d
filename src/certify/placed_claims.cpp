// Levels 2 and 3 for claims at stationary points. A critical point needs exactly one claim (FC-CLAIM-03), and a regular
// stationary point at most one. Instead of it, a claim may have what a perturbation makes of the point (FC-CLAIM-04).
#include <algorithm>
#include <array>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/perturbed_point.h"

namespace flowcert::certify {

namespace {

using Claims = std::vector<std::size_t>;

std::string text_of(const CheckRun& run, std::size_t record) { return "a " + stationary_text(run.truth, record); }

void find_incomplete(CheckRun& run, std::size_t k, std::size_t record) {
  run.find(2, FindingReason::kContactIncomplete, "FC-CRIT-05 (c)", k,
           "the centre is that of " + text_of(run, record) +
               "; what is claimed is neither all of that nor a simplex that spans it");
}

void find_twice(CheckRun& run, std::size_t k, std::size_t first) {
  run.find(3, FindingReason::kClaimedTwice, "FC-CRIT-06", k,
           "claimed already in line " + std::to_string(run.claim.points[first].line));
}

void vary_contact(CheckRun& run, std::size_t k, std::size_t record) {
  if (run.placed[k].place->fit != Fit::kPart) return;
  run.vary(2, FindingReason::kSpanningPart, "FC-CLAIM-02", k, "the whole is " + text_of(run, record));
}

void find_collision(CheckRun& run, std::size_t k, std::size_t record, const std::string& words) {
  run.find(2, FindingReason::kCollisionAsCritical, "FC-CRIT-03", k, text_of(run, record) + "; " + words);
}

// Takes claimed critical points for what one perturbation makes of a stationary point.
void accept_perturbed(CheckRun& run, std::size_t record, const Claims& claimed, bool is_decided) {
  run.perturbed[record] = claimed;
  for (const std::size_t k : claimed) {
    run.placed[k].is_right = true;
    run.vary(2, FindingReason::kSymbolicPerturbation, "FC-CLAIM-04", k, text_of(run, record), "", is_decided);
  }
  if (!is_decided) {
    run.leave_undecided(
        "whether one perturbation makes all that is claimed at a stationary point whose contact set is no simplex "
        "(FC-CLAIM-04)");
  }
}

// Claims at one stationary point, each looked at alone.
struct SortedClaims {
  Claims possible;                                         // by index
  Claims impossible;                                       // no perturbation makes these
  std::vector<std::pair<std::size_t, std::size_t>> again;  // a claim, and the claim that it repeats
};

SortedClaims sorted_claims(const CheckRun& run, const PerturbedPoint& point, const Claims& claimed) {
  SortedClaims sorted;
  std::array<Claims, 4> accepted;  // by index
  for (const std::size_t k : claimed) {
    if (!point.can_make(k)) {
      sorted.impossible.push_back(k);
      continue;
    }
    Claims& same = accepted.at(static_cast<std::size_t>(run.claim.points[k].index));
    if (point.is_again(k, same)) {
      sorted.again.emplace_back(k, same.back());
    } else {
      same.push_back(k);
    }
  }
  for (const Claims& some : accepted) sorted.possible.insert(sorted.possible.end(), some.begin(), some.end());
  return sorted;
}

// Claims at a critical point that are not just that point. False if they are not what a perturbation makes of it.
bool judge_perturbed_critical(CheckRun& run, std::size_t record, const Claims& claimed) {
  const PerturbedPoint point(run, record);
  const SortedClaims sorted = sorted_claims(run, point, claimed);
  if (!sorted.impossible.empty() || !sorted.again.empty()) return false;
  const MadeByPerturbation made = point.makes(claimed);
  if (made == MadeByPerturbation::kNo) return false;
  accept_perturbed(run, record, claimed, made == MadeByPerturbation::kYes);
  for (const std::size_t k : claimed) check_values(run, k);
  return true;
}

// All claims of critical points at one regular stationary point.
void judge_perturbed_regular(CheckRun& run, std::size_t record, const Claims& claimed, bool is_listed_as_regular) {
  const PerturbedPoint point(run, record);
  const auto& [all, impossible, again] = sorted_claims(run, point, claimed);
  for (const std::size_t k : impossible) find_collision(run, k, record, "no perturbation makes this of it");
  for (const auto& [k, earlier] : again) find_twice(run, k, earlier);
  if (all.empty()) return;
  const MadeByPerturbation made = is_listed_as_regular ? MadeByPerturbation::kNo : point.makes(all);
  if (made != MadeByPerturbation::kNo) return accept_perturbed(run, record, all, made == MadeByPerturbation::kYes);
  for (const std::size_t k : all) {
    find_collision(run, k, record,
                   is_listed_as_regular ? "and it is claimed as that as well"
                                        : "no perturbation makes just what is claimed there");
  }
}

// Without a perturbation, the point is there. The clause permits to leave it out.
void vary_denied(CheckRun& run, std::size_t record) {
  run.find_unclaimed(record, {.level = 3,
                              .reason = FindingReason::kSymbolicPerturbation,
                              .is_variation = true,
                              .clause = "FC-CLAIM-04",
                              .claimed = "no regular stationary point",
                              .truth = text_of(run, record)});
}

// Whether a claim that says "regular" is right.
bool judge_regular_claim(CheckRun& run, std::size_t k, std::size_t record) {
  const ClaimedPoint& point = run.claim.points[k];
  const StationaryIndex kind = run.index(record);
  if (point.index != kind.face_dimension || *point.hull_dimension != kind.hull_dimension) {
    run.find(3, FindingReason::kWrongIndex, "FC-CRIT-03", k, text_of(run, record));
    return false;
  }
  if (run.placed[k].place->fit == Fit::kOther) {
    find_incomplete(run, k, record);
    return false;
  }
  return true;
}

}  // namespace

void check_claims_at_critical(CheckRun& run, std::size_t record, const Claims& claimed) {
  const StationaryIndex index = run.index(record);
  const auto has_own_index = [&](std::size_t k) {
    const ClaimedPoint& point = run.claim.points[k];
    return !point.hull_dimension && point.index == index.face_dimension;
  };
  const bool is_plain = claimed.empty() || (claimed.size() == 1 && has_own_index(claimed[0]) &&
                                            run.placed[claimed[0]].place->fit != Fit::kOther);
  if (!is_plain && judge_perturbed_critical(run, record, claimed)) return;
  std::optional<std::size_t> first;
  bool is_addressed = false;
  for (const std::size_t k : claimed) {
    if (run.placed[k].place->fit == Fit::kOther) {
      find_incomplete(run, k, record);
      is_addressed = is_addressed || has_own_index(k);
      continue;
    }
    is_addressed = true;
    if (!has_own_index(k)) {
      run.find(3, FindingReason::kWrongIndex, "FC-CRIT-02", k, text_of(run, record));
    } else if (first) {
      find_twice(run, k, *first);
    } else {
      first = k;
      run.placed[k].is_right = true;
      vary_contact(run, k, record);
    }
    check_values(run, k);
  }
  if (!is_addressed && run.judges(index.face_dimension)) check_missing(run, record);
}

void check_claims_at_regular(CheckRun& run, std::size_t record, const Claims& claimed) {
  Claims critical;
  std::optional<std::size_t> regular;
  bool is_said_regular = false;
  for (const std::size_t k : claimed) {
    if (!run.claim.points[k].hull_dimension) {
      critical.push_back(k);
    } else {
      is_said_regular = true;
      if (judge_regular_claim(run, k, record)) {
        if (regular) find_twice(run, k, *regular);
        if (!regular) {
          run.placed[k].is_right = true;
          vary_contact(run, k, record);
        }
        regular = k;
      }
    }
    check_values(run, k);
  }
  if (!critical.empty()) judge_perturbed_regular(run, record, critical, regular.has_value());
  if (critical.empty() && !is_said_regular && run.speaks_of_regular_points) vary_denied(run, record);
}

void check_missing(CheckRun& run, std::size_t record) {
  const bool by_cluster = run.truth.contact(record).size() > run.index(record).hull_dimension + std::size_t{1};
  run.find_unclaimed(record, {.level = 3,
                              .reason = by_cluster ? FindingReason::kMissedByCluster : FindingReason::kMissing,
                              .clause = "FC-CLAIM-03",
                              .claimed = "nothing",
                              .truth = text_of(run, record)});
}

void check_euler_sum(CheckRun& run) {
  if (run.claim.pockets) return;
  if (!run.judges_all()) return run.leave_unjudged("the Euler sum");
  const auto& counts = run.report.claimed_counts;
  long long sum = 0;
  for (std::size_t index = 0; index < 4; ++index) {
    sum += (index % 2 == 0 ? 1 : -1) * static_cast<long long>(counts.at(index));
  }
  const long long truth = run.points.empty() ? 0 : 1;
  if (sum == truth) return;
  run.find_whole(3, FindingReason::kWrongCounts, kEulerClause, "an Euler sum of " + std::to_string(sum),
                 "it is " + std::to_string(truth));
}

}  // namespace flowcert::certify
