// The order of the levels, and the verdict.
#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "certify/check_run.h"
#include "certify/claim_profile.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/layer.h"
#include "certify/truth.h"
#include "flowcert/flow_complex.h"
#include "geometry/contract.h"
#include "geometry/floating_point.h"

namespace flowcert {

using namespace certify;

// ---- Contact sets ----
// The stationary points of each sample are listed side by side.

ContactIndex::ContactIndex(const PointSet& points, const Truth& truth)
    : points_(points), truth_(truth), first_(points.size() + 1, 0) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (const PointId name : truth.contact(i)) ++first_[points.ordinal_of_row(name) + 1];
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  records_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (const PointId name : truth.contact(i)) {
      records_[next[points.ordinal_of_row(name)]++] = static_cast<std::uint32_t>(i);
    }
  }
}

std::span<const std::uint32_t> ContactIndex::fewest(std::span<const PointId> names) const {
  FLOWCERT_REQUIRES(!names.empty() && std::ranges::is_sorted(names));
  std::span<const std::uint32_t> best = of(names.front());
  for (const PointId name : names.subspan(1)) {
    if (of(name).size() < best.size()) best = of(name);
  }
  return best;
}

std::optional<std::size_t> ContactIndex::find(std::span<const PointId> names) const {
  for (const std::uint32_t i : fewest(names)) {
    if (std::ranges::equal(truth_.contact(i), names)) return i;
  }
  return std::nullopt;
}

std::vector<std::size_t> ContactIndex::larger(std::span<const PointId> names) const {
  std::vector<std::size_t> result;
  for (const std::uint32_t i : fewest(names)) {
    const auto contact = truth_.contact(i);
    if (contact.size() > names.size() && std::ranges::includes(contact, names)) result.push_back(i);
  }
  return result;
}

// ---- The run ----

namespace {

// Pairs of a stationary point and a claimed point that is placed there, sorted by stationary point.
std::vector<std::pair<std::size_t, std::size_t>> claims_by_record(const CheckRun& run) {
  std::vector<std::pair<std::size_t, std::size_t>> claims;
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
    if (run.placed[k].place) claims.emplace_back(run.placed[k].place->record, k);
  }
  std::sort(claims.begin(), claims.end());
  return claims;
}

// Levels 2 and 3.
void check_points(CheckRun& run) {
  place_points(run);
  for (std::size_t k = 0; k < run.placed.size(); ++k) {
    if (run.placed[k].is_well_formed && !run.placed[k].place) check_stray_claim(run, k);
  }
  const auto claims = claims_by_record(run);
  auto next = claims.begin();
  std::vector<std::size_t> here;
  for (std::size_t record = 0; record < run.truth.size(); ++record) {
    run.show_progress(3, record, run.truth.size());
    here.clear();
    for (; next != claims.end() && next->first == record; ++next) here.push_back(next->second);
    if (run.index(record).is_critical()) {
      ++run.report.true_counts.at(run.index(record).face_dimension);
      check_claims_at_critical(run, record, here);
    } else {
      check_claims_at_regular(run, record, here);
    }
  }
  check_euler_sum(run);
}

void add_once(std::vector<std::string>& list, const std::string& what) {
  if (std::ranges::find(list, what) == list.end()) list.push_back(what);
}

void sort_findings(std::vector<Finding>& findings) {
  const auto key = [](const Finding& finding) {
    return std::tuple(finding.level, finding.line.value_or(std::numeric_limits<std::size_t>::max()),
                      std::tie(finding.contact));
  };
  std::stable_sort(findings.begin(), findings.end(),
                   [&key](const Finding& a, const Finding& b) { return key(a) < key(b); });
}

void conclude(CheckReport& report, int highest_level) {
  std::erase_if(report.findings, [&](const Finding& finding) { return finding.level > highest_level; });
  sort_findings(report.findings);
  for (const Finding& finding : report.findings) {
    report.verdict = std::max(report.verdict, verdict_on(finding));
    if (!finding.is_variation) report.conforms.at(static_cast<std::size_t>(finding.level - 1)) = false;
  }
}

}  // namespace

Verdict verdict_on(const Finding& finding) {
  if (!finding.is_variation) return Verdict::kFails;
  return finding.reason == FindingReason::kSymbolicPerturbation ? Verdict::kPerturbed
                                                                : Verdict::kConformsWhereDetermined;
}

void CheckRun::find(int level, FindingReason reason, const std::string& clause, std::size_t claimed_point,
                    const std::string& truth_text, const std::string& part) {
  report.findings.push_back(
      of_point(claimed_point, part, {.level = level, .reason = reason, .clause = clause, .truth = truth_text}));
}

void CheckRun::vary(int level, FindingReason reason, const std::string& clause, std::size_t claimed_point,
                    const std::string& truth_text, const std::string& part, bool is_decided) {
  report.findings.push_back(of_point(claimed_point, part,
                                     {.level = level,
                                      .reason = reason,
                                      .is_variation = true,
                                      .clause = clause,
                                      .truth = truth_text,
                                      .is_decided = is_decided}));
}

Finding CheckRun::of_point(std::size_t claimed_point, const std::string& part, Finding finding) const {
  const ClaimedPoint& point = claim.points[claimed_point];
  finding.line = point.line;
  finding.contact = point.contact;
  finding.claimed = claim_text(point) + (part.empty() ? "" : ", " + part);
  if (const auto& place = placed[claimed_point].place) finding.record = place->record;
  return finding;
}

void CheckRun::find_unclaimed(std::size_t record, Finding finding) {
  const auto contact = truth.contact(record);
  finding.contact.assign(contact.begin(), contact.end());
  finding.record = record;
  report.findings.push_back(std::move(finding));
}

void CheckRun::find_whole(int level, FindingReason reason, const std::string& clause, const std::string& claimed,
                          const std::string& truth_text) {
  report.findings.push_back(
      {.level = level, .reason = reason, .clause = clause, .claimed = claimed, .truth = truth_text});
}

std::size_t CheckRun::true_side(std::size_t k, std::size_t claimed_side) const {
  const Placement& place = placed[k].place.value();
  const bool is_turned = place.fit == Fit::kPart && !turn_alike(points, placed[k].names, truth.contact(place.record));
  return is_turned ? 1 - claimed_side : claimed_side;
}

const std::array<double, 3>& CheckRun::center_in_doubles(std::size_t record) {
  for (std::size_t k = centers_in_doubles_.size(); k < truth.size(); ++k) {
    centers_in_doubles_.push_back(as_doubles(truth.sphere(k).center));
  }
  return centers_in_doubles_[record];
}

void CheckRun::show_progress(int level, std::size_t done, std::size_t total) const {
  if (options.progress) options.progress(level, done, total);
}

bool CheckRun::judge_each(int level, std::size_t part, std::size_t parts,
                          const std::function<bool(std::size_t)>& judge) {
  bool has_judged = false;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    show_progress(level, part * placed.size() + k, parts * placed.size());
    if (judge(k)) has_judged = true;
  }
  return has_judged;
}

ValueMatch CheckRun::match(const ClaimedPosition& claimed, const RationalPoint& truth_position,
                           const ValueScale& scale) {
  note_exactness(is_exact(claimed));
  return match_position(claimed, truth_position, scale);
}

ValueMatch CheckRun::match(const Corner<ClaimedPosition>& claimed, const Corner<>& truth_corner,
                           const ValueScale& scale) {
  if (claimed.at_infinity != truth_corner.at_infinity) return ValueMatch::kOff;
  return claimed.at_infinity ? match_direction(claimed.position, truth_corner.position)
                             : match(claimed.position, truth_corner.position, scale);
}

ValueMatch CheckRun::match_direction(const ClaimedPosition& claimed, const RationalPoint& truth_vector) {
  note_exactness(is_exact(claimed));
  return match_vector(claimed, truth_vector, options.tolerance);
}

bool CheckRun::can_follow(std::size_t k) {
  if (placed[k].is_right && placed[k].is_one_of_several) {
    leave_unjudged(
        "incidences, and all of level 5, of points at whose position several of their index are (FC-CLAIM-24)");
    return false;
  }
  return placed[k].is_right;
}

bool CheckRun::can_follow(std::size_t k, const std::string& things) {
  if (!can_follow(k)) return false;
  if (is_perturbed(k)) leave_unjudged(things + " of the points that a perturbation makes of stationary points");
  return !is_perturbed(k);
}

void CheckRun::leave_unjudged(const std::string& what) { add_once(report.not_judged, what); }
void CheckRun::leave_undecided(const std::string& what) { add_once(report.not_decided, what); }

bool CheckRun::is_made(std::size_t record, const std::vector<PointId>& names, std::optional<int> index) const {
  const auto made = perturbed.find(record);
  return made != perturbed.end() && std::ranges::any_of(made->second, [&](std::size_t k) {
           return index.value_or(claim.points[k].index) == claim.points[k].index &&
                  (placed[k].names.empty() || placed[k].names == names);
         });
}

CheckReport check(const PointSet& points, const Claim& claim, Truth& truth, const CheckOptions& options) {
  const geometry::IeeeDoubles ieee;
  if (!(options.tolerance >= 0 && options.tolerance <= 1)) throw InvalidInput("the tolerance is not between 0 and 1");
  CheckRun run(points, claim, truth, options);
  check_form(run);
  run.report.conforms[0] = true;
  if (options.highest_level >= 2) {
    check_points(run);
    if (!claim.points.empty()) run.report.conforms[1] = true;
    const bool judges_points = !claim.pockets || check_counts_of_pockets(run);
    if (options.highest_level >= 3 && judges_points) run.report.conforms[2] = true;
  }
  if (options.highest_level >= 4 && check_incidences(run)) run.report.conforms[3] = true;
  if (options.highest_level >= 5) {
    const std::array has_judged = {check_polylines(run), check_surfaces(run),      check_lambda_lists(run),
                                   check_volumes(run),   check_unstable_sets(run), check_infinity(run),
                                   check_pockets(run)};
    if (std::ranges::count(has_judged, true) > 0) run.report.conforms[4] = true;
  }
  conclude(run.report, options.highest_level);
  for (Finding& finding : run.report.findings) finding.sentence = finding_sentence(finding, truth);
  run.report.profile =
      profile_of(claim, run.report.indices, points.row_count() > 0, run.report.is_exact, options.highest_level);
  return std::move(run.report);
}

CheckReport check(const PointSet& points, const Claim& claim, const CheckOptions& options) {
  const geometry::IeeeDoubles ieee;
  return check(points, claim, *fast_truth(points), options);
}
CheckReport check(const FlowComplex& complex, const Claim& claim, const CheckOptions& options) {
  const geometry::IeeeDoubles ieee;
  return check(complex.points(), claim, *fast_truth(complex), options);
}

const char* verdict_text(Verdict verdict) {
  constexpr std::array kTexts = {"conforms", "conforms where determined", "perturbed", "fails"};  // as they are listed
  return kTexts.at(static_cast<std::size_t>(verdict));
}

const char* reason_text(FindingReason reason) {
  // As they are listed.
  constexpr std::array kTexts = {"malformed",
                                 "not-cospherical",
                                 "ball-not-empty",
                                 "contact-incomplete",
                                 "outside-hull",
                                 "collision-as-critical",
                                 "wrong-index",
                                 "wrong-position",
                                 "rounding",
                                 "missing",
                                 "missed-by-cluster",
                                 "claimed-twice",
                                 "ambiguous",
                                 "wrong-counts",
                                 "wrong-incidence",
                                 "wrong-polyline",
                                 "wrong-surface",
                                 "wrong-lambda-list",
                                 "wrong-connections",
                                 "wrong-volume",
                                 "wrong-unstable-set",
                                 "wrong-pocket",
                                 "spanning-part",
                                 "tie-break",
                                 "symbolic-perturbation"};
  static_assert(kTexts.size() == static_cast<std::size_t>(FindingReason::kSymbolicPerturbation) + 1);
  return kTexts.at(static_cast<std::size_t>(reason));
}

}  // namespace flowcert
