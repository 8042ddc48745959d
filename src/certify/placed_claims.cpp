// Levels 2 and 3 for claims at stationary points. A critical point needs exactly one claim (FC-CLAIM-03). At a
// regular stationary point, three things are right: no claim, the point itself, or what a perturbation makes of it
// (FC-CLAIM-04).
#include <algorithm>
#include <array>
#include <iterator>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"

namespace flowcert::certify {

namespace {

using Claims = std::vector<std::size_t>;

void find_incomplete(CheckRun& run, std::size_t k, std::size_t record) {
  run.find(2, FindingReason::kContactIncomplete, "FC-CRIT-05 (c)", k,
           "the centre is that of a " + stationary_text(run.truth, record) +
               "; what is claimed is neither all of that nor a simplex that spans it");
}

void find_twice(CheckRun& run, std::size_t k, std::size_t first) {
  run.find(3, FindingReason::kClaimedTwice, "FC-CRIT-06", k,
           "claimed already in line " + std::to_string(run.claim.points[first].line));
}

void vary_contact(CheckRun& run, std::size_t k, std::size_t record) {
  if (run.placed[k].place->fit != Fit::kPart) return;
  run.vary(2, FindingReason::kSpanningPart, "FC-CLAIM-02", k, "the whole is a " + stationary_text(run.truth, record));
}

// Whether a claimed contact set is a face of the true one with the centre in it, or a simplex that spans such a face.
bool is_part_of_face(const CheckRun& run, std::size_t k, std::size_t record, int dimension) {
  const PlacedPoint& placed = run.placed[k];
  if (placed.place->fit == Fit::kPosition) return true;
  const std::vector<PointId>& names = placed.names;
  if (affine_dimension(run.points, names) != dimension) return false;
  const bool is_simplex = static_cast<int>(names.size()) == dimension + 1;
  const auto contact = run.truth.contact(record);
  // At most one edge goes through the centre, and it is a face, because the centre lies on the hull's boundary.
  if (dimension == 1) return is_simplex;
  if (dimension == run.index(record).hull_dimension) return is_simplex || names.size() == contact.size();
  const std::vector<PointId> face = supported_face(run.points, names, contact);
  return !face.empty() && (is_simplex || face == names);
}

// Whether two index-2 claims at a point of kind 1-3 mean the same polygon. Such a point lies in two polygons.
bool in_one_plane(const CheckRun& run, std::size_t a, std::size_t b) {
  std::vector<PointId> both;
  std::ranges::set_union(run.placed[a].names, run.placed[b].names, std::back_inserter(both));
  return affine_dimension(run.points, both) == 2;
}

// All claims of critical points at one regular stationary point.
class PerturbedPoint {
 public:
  PerturbedPoint(CheckRun& run, std::size_t record) : run_(run), record_(record), kind_(run.index(record)) {}

  void add(std::size_t k) {
    const int index = run_.claim.points[k].index;
    if (index < kind_.face_dimension || index > kind_.hull_dimension || !is_part_of_face(run_, k, record_, index)) {
      find_collision(k, "no face of it with that centre is claimed");
      return;
    }
    Claims& same = accepted_.at(static_cast<std::size_t>(index));
    const auto again = std::ranges::find_if(same, [&](std::size_t other) { return is_same(k, other); });
    if (again != same.end()) {
      find_twice(run_, k, *again);
    } else {
      same.push_back(k);
    }
  }

  void judge(bool is_listed_as_regular) {
    const bool is_right = !is_listed_as_regular && is_what_a_perturbation_gives();
    for (const Claims& claims : accepted_) {
      for (const std::size_t k : claims) {
        run_.placed[k].is_right = is_right;
        if (is_right) {
          run_.vary(2, FindingReason::kSymbolicPerturbation, "FC-CLAIM-04", k, text());
        } else {
          find_collision(k, is_listed_as_regular ? "and it is claimed as that as well"
                                                 : "a perturbation would make pairs of it, or nothing");
        }
      }
    }
  }

 private:
  [[nodiscard]] std::string text() const { return "a " + stationary_text(run_.truth, record_); }

  void find_collision(std::size_t k, const std::string& words) {
    run_.find(2, FindingReason::kCollisionAsCritical, "FC-CRIT-03", k, text() + "; " + words);
  }

  [[nodiscard]] bool is_same(std::size_t a, std::size_t b) const {
    if (kind_ != StationaryIndex{1, 3} || run_.claim.points[a].index != 2) return true;
    const bool by_position = run_.placed[a].place->fit == Fit::kPosition || run_.placed[b].place->fit == Fit::kPosition;
    if (by_position) return accepted_[2].size() > 1;
    return in_one_plane(run_, a, b);
  }

  [[nodiscard]] bool is_what_a_perturbation_gives() const {
    const std::array<std::size_t, 3> counts = {accepted_[1].size(), accepted_[2].size(), accepted_[3].size()};
    using Counts = std::array<std::size_t, 3>;
    const bool is_low_pair = counts == Counts{1, 1, 0}, is_high_pair = counts == Counts{0, 1, 1};
    if (kind_ == StationaryIndex{1, 2}) return is_low_pair;
    if (kind_ == StationaryIndex{2, 3}) return is_high_pair;
    return is_low_pair || is_high_pair || counts == Counts{1, 2, 1};
  }

  CheckRun& run_;
  std::size_t record_;
  StationaryIndex kind_;
  std::array<Claims, 4> accepted_;  // by index
};

// Whether a claim that says "regular" is right.
bool judge_regular_claim(CheckRun& run, std::size_t k, std::size_t record) {
  const ClaimedPoint& point = run.claim.points[k];
  const StationaryIndex kind = run.index(record);
  if (point.index != kind.face_dimension || *point.hull_dimension != kind.hull_dimension) {
    run.find(3, FindingReason::kWrongIndex, "FC-CRIT-03", k, "a " + stationary_text(run.truth, record));
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
  std::optional<std::size_t> first;
  bool is_addressed = false;
  for (const std::size_t k : claimed) {
    const ClaimedPoint& point = run.claim.points[k];
    const bool has_index = !point.hull_dimension && point.index == index.face_dimension;
    if (run.placed[k].place->fit == Fit::kOther) {
      find_incomplete(run, k, record);
      is_addressed = is_addressed || has_index;
      continue;
    }
    is_addressed = true;
    if (!has_index) {
      run.find(3, FindingReason::kWrongIndex, "FC-CRIT-02", k, "a " + stationary_text(run.truth, record));
    } else if (first) {
      find_twice(run, k, *first);
    } else {
      first = k;
      run.placed[k].is_right = true;
      vary_contact(run, k, record);
    }
    check_values(run, k);
  }
  if (!is_addressed) check_missing(run, record);
}

void check_claims_at_regular(CheckRun& run, std::size_t record, const Claims& claimed) {
  PerturbedPoint perturbed(run, record);
  std::optional<std::size_t> regular;
  for (const std::size_t k : claimed) {
    if (!run.claim.points[k].hull_dimension) {
      perturbed.add(k);
    } else if (judge_regular_claim(run, k, record)) {
      if (regular) find_twice(run, k, *regular);
      if (!regular) {
        run.placed[k].is_right = true;
        vary_contact(run, k, record);
      }
      regular = k;
    }
    check_values(run, k);
  }
  perturbed.judge(regular.has_value());
}

void check_missing(CheckRun& run, std::size_t record) {
  const auto contact = run.truth.contact(record);
  const auto is_cluster = [&run](std::size_t other) {
    return run.truth.contact(other).size() > run.index(other).hull_dimension + std::size_t{1};
  };
  const bool by_cluster = is_cluster(record) || std::ranges::any_of(run.contacts.larger(contact), is_cluster);
  run.report.findings.push_back({3,
                                 by_cluster ? FindingReason::kMissedByCluster : FindingReason::kMissing,
                                 false,
                                 "FC-CLAIM-03",
                                 std::nullopt,
                                 {contact.begin(), contact.end()},
                                 "nothing",
                                 "a " + stationary_text(run.truth, record)});
}

void check_euler_sum(CheckRun& run) {
  const auto& counts = run.report.claimed_counts;
  long long sum = 0;
  for (std::size_t index = 0; index < 4; ++index) {
    sum += (index % 2 == 0 ? 1 : -1) * static_cast<long long>(counts.at(index));
  }
  const long long truth = run.points.empty() ? 0 : 1;
  if (sum == truth) return;
  run.report.findings.push_back({3,
                                 FindingReason::kWrongCounts,
                                 false,
                                 "FC-INV-01",
                                 std::nullopt,
                                 {},
                                 "an Euler sum of " + std::to_string(sum),
                                 "it is " + std::to_string(truth)});
}

}  // namespace flowcert::certify
