// What the levels of a check share: the claim, the truth, where each claimed point is among the true
// stationary points, and the report that they write.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "certify/claimed_geometry.h"
#include "certify/layer.h"
#include "certify/truth.h"

namespace flowcert::certify {

// ---- Contact sets ----
// Finds stationary points by samples of their contact sets, exactly. A question takes time in proportion to the
// number of stationary points of one sample. That is the sample with the fewest of them.

class ContactIndex {
 public:
  // Both must outlive this. O(all contact sets).
  ContactIndex(const PointSet& points, const Truth& truth);

  // names: ascending, not empty.
  [[nodiscard]] std::optional<std::size_t> find(std::span<const PointId> names) const;
  // The stationary points whose contact set has all of these names and more.
  [[nodiscard]] std::vector<std::size_t> larger(std::span<const PointId> names) const;
  // All stationary points of a sample, in the order of the list.
  [[nodiscard]] std::span<const std::uint32_t> of(PointId name) const {
    const std::size_t at = points_.ordinal_of_row(name);
    return std::span(records_).subspan(first_[at], first_[at + 1] - first_[at]);
  }

 private:
  [[nodiscard]] std::span<const std::uint32_t> fewest(std::span<const PointId> names) const;

  const PointSet& points_;
  const Truth& truth_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> records_;
};

// ---- The run ----

// How well a claimed contact set names the stationary point at its centre.
enum class Fit {
  kWhole,     // it is the point's contact set
  kPart,      // it is an affinely independent part of that set, with the same affine hull (FC-CLAIM-02)
  kOther,     // it is another part of that set, with the same centre
  kMade,      // a perturbation makes it of the point, and the claim lists it there (FC-CLAIM-04)
  kPosition,  // no contact set is claimed, only a position
};

struct Placement {
  std::size_t record = 0;  // in the truth
  Fit fit = Fit::kWhole;
};

struct PlacedPoint {
  bool is_well_formed = false;
  std::vector<PointId> names;  // the claimed contact set, by classes, ascending
  std::optional<Placement> place;
  // Its position and distance leave several points of its index. It is matched with one of them (FC-CLAIM-24).
  bool is_one_of_several = false;
  bool is_right = false;  // the claim is right, so its successors and polylines can be judged
};

[[nodiscard]] inline bool is_regular_claim(const ClaimedPoint& point) { return point.hull_dimension.has_value(); }

struct CheckRun {
  CheckRun(const PointSet& points_, const Claim& claim_, Truth& truth_, const CheckOptions& options_)
      : points(points_),
        claim(claim_),
        truth(truth_),
        options(options_),
        contacts(points_, truth_),
        placed(claim_.points.size()),
        speaks_of_regular_points(claim_.regular_counts || std::ranges::any_of(claim_.points, &is_regular_claim)) {
    for (std::size_t index = 0; index < 4; ++index) {
      report.indices.at(index) = options_.indices.at(index) && (!claim_.indices || claim_.indices->at(index));
    }
  }

  const PointSet& points;
  const Claim& claim;
  Truth& truth;
  const CheckOptions& options;
  ContactIndex contacts;
  std::vector<PlacedPoint> placed;  // by claimed point
  // The claimed points that a perturbation makes of a stationary point, by that point.
  std::map<std::size_t, std::vector<std::size_t>> perturbed;
  // The claim counts or lists regular stationary points. It then says of all others that they are none.
  bool speaks_of_regular_points;
  CheckReport report;

  [[nodiscard]] StationaryIndex index(std::size_t record) const { return truth.index(record); }
  // The centre of a stationary point, rounded. All of them are computed at the first call.
  [[nodiscard]] const std::array<double, 3>& center_in_doubles(std::size_t record);
  // Whether critical points of this index are judged (FC-CLAIM-12). An index that does not exist is judged, too.
  [[nodiscard]] bool judges(int index) const {
    return index < 0 || index > 3 || report.indices.at(static_cast<std::size_t>(index));
  }
  [[nodiscard]] bool judges_all() const { return report.indices == ClaimedIndices{true, true, true, true}; }
  // Reports what is wrong with a claimed point, or with a part of what is claimed of it ("volume 3").
  void find(int level, FindingReason reason, const std::string& clause, std::size_t claimed_point,
            const std::string& truth_text, const std::string& part = {});
  // Reports a permitted variation of a claimed point, or of such a part.
  void vary(int level, FindingReason reason, const std::string& clause, std::size_t claimed_point,
            const std::string& truth_text, const std::string& part = {}, bool is_decided = true);
  // Reports a finding about a stationary point that is not claimed. Its contact set and place are filled in.
  void find_unclaimed(std::size_t record, Finding finding);
  // The side, 0 or 1, of the index-2 point at which claimed point k is, for a side as claimed. They differ where a part
  // of the contact set is named that turns the other way (FC-CLAIM-02).
  [[nodiscard]] std::size_t true_side(std::size_t k, std::size_t claimed_side) const;
  // Reports something wrong with the claim as a whole.
  void find_whole(int level, FindingReason reason, const std::string& clause, const std::string& claimed,
                  const std::string& truth_text);
  // Reports the progress of the check, if the caller asked for it.
  void show_progress(int level, std::size_t done, std::size_t total) const;
  // Calls judge(claimed point) for all of them, in part number `part` of a level that has `parts`. True if one of the
  // calls found something to judge.
  bool judge_each(int level, std::size_t part, std::size_t parts, const std::function<bool(std::size_t)>& judge);
  // Whether what levels 4 and 5 ask of a claimed point can be judged: it is right, and it is known which point it is.
  // Reports that it is not judged if that alone is missing.
  [[nodiscard]] bool can_follow(std::size_t claimed_point);
  // Whether such things ("volumes") can be judged, which they are not of points that a perturbation makes.
  [[nodiscard]] bool can_follow(std::size_t claimed_point, const std::string& things);
  [[nodiscard]] bool is_perturbed(std::size_t claimed_point) const {
    return perturbed.contains(placed[claimed_point].place->record);
  }
  // The report is exact if all claimed values are.
  void note_exactness(bool is_exact) { report.is_exact = report.is_exact && is_exact; }
  // match_position() and match_vector(), which note the exactness.
  [[nodiscard]] ValueMatch match(const ClaimedPosition& claimed, const RationalPoint& truth_position,
                                 const ValueScale& scale);
  // Either of them, by what the corner is.
  [[nodiscard]] ValueMatch match(const Corner<ClaimedPosition>& claimed, const Corner<>& truth_corner,
                                 const ValueScale& scale);
  [[nodiscard]] ValueMatch match_direction(const ClaimedPosition& claimed, const RationalPoint& truth_vector);
  // Reports once that this is not judged, or not decided.
  void leave_unjudged(const std::string& what);
  void leave_undecided(const std::string& what);
  // Whether a perturbation makes of a stationary point a claimed point with these names, and with this index if one is
  // given.
  [[nodiscard]] bool is_made(std::size_t record, const std::vector<PointId>& names, std::optional<int> index) const;

 private:
  Finding of_point(std::size_t claimed_point, const std::string& part, Finding finding) const;

  std::vector<std::array<double, 3>> centers_in_doubles_;
};

inline constexpr StationaryIndex kIndex1{1, 1}, kIndex2{2, 2}, kMaximum{3, 3};

// The stationary point at the centre of the smallest sphere through these samples, if there is one.
[[nodiscard]] std::optional<Placement> placement_of(CheckRun& run, const std::vector<PointId>& names);

// Where something ends: a stationary point, or nothing for infinity.
using Limit = std::optional<std::size_t>;

struct NamedTarget {
  bool is_known = false;  // infinity, or a stationary point
  Limit limit;
  Fit fit = Fit::kWhole;
};
[[nodiscard]] NamedTarget named_target(CheckRun& run, const ClaimedTarget& target);

// Level 1. Sets is_well_formed and names.
void check_form(CheckRun& run);
// Finds where the well-formed points are. Reports what is ambiguous.
void place_points(CheckRun& run);
// Levels 2 and 3. The first two functions judge all claims at one stationary point. The third judges a claim that is
// at none.
void check_claims_at_critical(CheckRun& run, std::size_t record, const std::vector<std::size_t>& claimed);
void check_claims_at_regular(CheckRun& run, std::size_t record, const std::vector<std::size_t>& claimed);
void check_stray_claim(CheckRun& run, std::size_t claimed_point);
// Centre and distance of a claimed point that has a place.
void check_values(CheckRun& run, std::size_t claimed_point);
// Whether they would be right of a stationary point.
[[nodiscard]] bool has_right_values(CheckRun& run, std::size_t claimed_point, std::size_t record);
// Level 3: a critical point that nobody claims, and the Euler sum.
void check_missing(CheckRun& run, std::size_t record);
void check_euler_sum(CheckRun& run);
// Levels 4 and 5. True if there was something to judge. Of level 5, the first five functions are parts with a loop over
// all claimed points.
inline constexpr std::size_t kPartsOfLevel5 = 5;
bool check_incidences(CheckRun& run);
bool check_polylines(CheckRun& run);
bool check_surfaces(CheckRun& run);
bool check_lambda_lists(CheckRun& run);
bool check_volumes(CheckRun& run);
bool check_infinity(CheckRun& run);
bool check_unstable_sets(CheckRun& run);
bool check_pockets(CheckRun& run);
// Level 3 of a claim of pockets, which has no points.
bool check_counts_of_pockets(CheckRun& run);

}  // namespace flowcert::certify
