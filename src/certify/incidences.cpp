// Level 4: incidences (FC-CLAIM-06). If a perturbation would let an orbit leave the point where it ends, they may
// vary (FC-CLAIM-07).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/boundaries.h"
#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"

namespace flowcert::certify {

namespace {

constexpr FindingReason kPerturbation = FindingReason::kSymbolicPerturbation;

// Where a perturbation can make an orbit end.
struct Continuations {
  std::set<Limit> limits;
  // A squared distance, if some of these orbits end at regular stationary points: the least of such a point. Then
  // any stationary point that is farther from the samples is possible too.
  std::optional<Rational> beyond;
};

class Incidences {
 public:
  explicit Incidences(CheckRun& run) : run_(run), boundaries_(run) {}

  // For an index-2 critical point: the index-1 points that bound its stable manifold.
  void check_boundary(std::size_t k) { boundaries_.check(k, *run_.claim.points[k].stable->boundary, 4, false); }
  void conclude_boundaries() { boundaries_.conclude(); }

  // For an index-1 critical point: the index-2 points from which a connecting orbit comes down to it. If a tie leaves
  // open where the connecting orbits of an index-2 point end, that point may be named or not. If there is no such
  // saddle, infinity may be named where its λ-list leads there.
  void check_saddles_above(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    std::set<std::size_t> missing = saddles_above(record), seen;
    const bool is_without_saddle = missing.empty();
    std::vector<std::string> wrong;
    bool infinity_is_named = false;
    std::optional<FindingReason> varies;  // the last of its reasons in the order of the list
    const auto vary = [&varies](FindingReason reason) { varies = varies ? std::max(*varies, reason) : reason; };
    for (const ClaimedTarget& target : *run_.claim.points[k].successors) {
      if (target.is_infinity && is_without_saddle) {
        infinity_is_named = true;
        continue;
      }
      const NamedTarget there = named(target);
      if (there.limit && !seen.insert(*there.limit).second) continue;
      if (there.limit && there.fit != Fit::kOther && missing.erase(*there.limit) > 0) {
        if (there.fit != Fit::kWhole) vary(there.fit == Fit::kPart ? FindingReason::kSpanningPart : kPerturbation);
      } else if (const auto why = there.limit ? why_it_may_come_down(*there.limit, record) : std::nullopt) {
        vary(*why);
      } else {
        wrong.push_back(target_text(target));
      }
    }
    std::erase_if(missing, [&](std::size_t saddle) {
      const bool is_perturbed = run_.perturbed.contains(saddle);
      if (!is_perturbed && !has_tie(run_.truth, saddle)) return false;
      vary(is_perturbed ? kPerturbation : FindingReason::kTieBreak);
      return true;
    });
    if (!wrong.empty() || !missing.empty()) {
      run_.find(4, FindingReason::kWrongIncidence, "FC-CHAIN-01", k,
                words("an orbit comes to it also from ", missing, "no orbit comes to it from ", wrong));
    } else if (varies) {
      vary_saddles(k, *varies);
    }
    if (infinity_is_named) check_infinity_above(k, record);
  }

  // For an index-2 critical point: where its two orbits end.
  void check_limits(std::size_t k) {
    const ClaimedPoint& point = run_.claim.points[k];
    const std::array<Limit, 2> truth = limits_as_claimed(k);
    std::vector<NamedTarget> targets;
    for (const ClaimedTarget& target : *point.successors) targets.push_back(named(target));
    const bool are_known = std::ranges::all_of(targets, &NamedTarget::is_known);
    if (are_known && is_exactly(targets, truth, point.successors_by_side)) {
      vary_parts(k, targets);
    } else if (are_known && is_permitted(targets, truth, point.successors_by_side)) {
      run_.vary(4, kPerturbation, "FC-CLAIM-07", k, limits_text(truth), targets_text(point));
    } else {
      run_.find(4, FindingReason::kWrongIncidence, "FC-FLOW-07", k, limits_text(truth), targets_text(point));
    }
  }

  // For a sample: the index-1 points that have it in their contact set.
  void check_edges(std::size_t k) {
    const PointId name =
        run_.placed[k].names.empty() ? run_.truth.contact(run_.placed[k].place->record)[0] : run_.placed[k].names[0];
    std::set<std::size_t> missing;
    for (const std::uint32_t record : run_.contacts.of(name)) {
      if (run_.index(record) == kIndex1) missing.insert(record);
    }
    std::vector<std::string> wrong;
    bool varies = false;
    std::set<std::size_t> seen;
    for (const ClaimedTarget& target : *run_.claim.points[k].successors) {
      const NamedTarget there = named(target);
      const bool is_again = there.limit && !seen.insert(*there.limit).second;
      if (is_again || (there.limit && missing.erase(*there.limit) > 0)) continue;
      if (there.limit && is_perturbed_edge(target, *there.limit, name)) {
        varies = true;
      } else {
        wrong.push_back(target_text(target));
      }
    }
    if (!wrong.empty() || !missing.empty()) {
      run_.find(4, FindingReason::kWrongIncidence, "FC-FLOW-07", k,
                words("it is an end also of ", missing, "it is no end of ", wrong));
    } else if (varies) {
      run_.vary(4, FindingReason::kSymbolicPerturbation, "FC-CLAIM-04", k, "a perturbation makes some of the edges");
    }
  }

  // For an index-1 point: the ends of S1.
  void check_samples(std::size_t k) {
    const std::vector<PointId> names = class_names(run_.points, *run_.claim.points[k].samples);
    const PlacedPoint& placed = run_.placed[k];
    const auto contact = run_.truth.contact(placed.place->record);
    // If a perturbation makes the point, the edge must be the claimed contact set, or have the point in its middle.
    const auto is_in_its_middle = [&] {
      const auto place = names.size() == 2 ? placement_of(run_, names) : std::nullopt;
      return place && place->record == placed.place->record;
    };
    const bool is_right = !run_.perturbed.contains(placed.place->record) ? std::ranges::equal(names, contact)
                          : placed.names.empty()                         ? is_in_its_middle()
                                                                         : names == placed.names;
    if (is_right) return;
    run_.find(4, FindingReason::kWrongIncidence, "FC-FLOW-07", k,
              "the stable manifold is the segment between the two points of the contact set",
              "samples " + names_text(names));
  }

  // For a maximum. Nothing flows from it.
  void check_nothing_above(std::size_t k) {
    for (const ClaimedTarget& target : *run_.claim.points[k].successors) {
      if (target.is_infinity) continue;
      run_.find(4, FindingReason::kWrongIncidence, "FC-FLOW-03", k, "nothing flows from a maximum",
                "up to " + target_text(target));
    }
  }

 private:
  // The true limits, in the order of the claimed sides.
  std::array<Limit, 2> limits_as_claimed(std::size_t k) {
    const std::array<Limit, 2> limits = run_.truth.limits(run_.placed[k].place->record);
    return {limits.at(run_.true_side(k, 0)), limits.at(run_.true_side(k, 1))};
  }

  NamedTarget named(const ClaimedTarget& target) {
    NamedTarget there = named_target(run_, target);
    const bool is_made = there.limit && there.fit != Fit::kWhole &&
                         run_.is_made(*there.limit, class_names(run_.points, target.contact), std::nullopt);
    if (is_made) there.fit = Fit::kMade;
    return there;
  }

  // For an index-1 critical point without a saddle above it: whether a direction or an arc of its λ-list leads to
  // infinity, or a perturbation can let one go on to there.
  void check_infinity_above(std::size_t k, std::size_t record) {
    std::set<Limit> limits;
    for (const FlowLimits::Entry& entry : run_.truth.lambda_entries(record)) {
      limits.insert(entry.limit == FlowLimits::Entry::kInfinity ? Limit() : Limit(entry.limit));
    }
    if (limits.contains(std::nullopt)) return;
    const std::string truth = "nothing that leaves it ends at infinity", part = "up to infinity";
    if (std::ranges::any_of(limits, [this](const Limit& limit) { return may_end(std::nullopt, limit); })) {
      run_.vary(4, kPerturbation, "FC-CLAIM-07", k, truth, part);
    } else {
      run_.find(4, FindingReason::kWrongIncidence, "FC-CLAIM-06", k, truth, part);
    }
  }

  // Found for all edges at the first call, from the saddles' stable sets.
  const std::set<std::size_t>& saddles_above(std::size_t edge) {
    if (saddles_above_.empty()) {
      for (std::size_t i = 0; i < run_.truth.size(); ++i) {
        if (run_.index(i) != kIndex2) continue;
        for (const BackwardSegment<>& segment : run_.truth.stable_set(i).segments) {
          if (segment.back_kind != BackKind::kCritical) continue;
          const auto foot = run_.contacts.find(segment.back_contact);
          if (foot) saddles_above_[*foot].insert(i);
        }
      }
    }
    return saddles_above_[edge];
  }

  // Why an orbit may come down from a point: a tie leaves open where its connecting orbits end, or a perturbation can
  // make it a saddle. There is no value if none may.
  std::optional<FindingReason> why_it_may_come_down(std::size_t saddle, std::size_t edge) {
    const StationaryIndex index = run_.index(saddle);
    if (run_.truth.sphere(saddle).squared_radius <= run_.truth.sphere(edge).squared_radius) return std::nullopt;
    if (!index.is_critical() || run_.perturbed.contains(saddle)) return kPerturbation;
    if (index == kIndex2 && has_tie(run_.truth, saddle)) return FindingReason::kTieBreak;
    return std::nullopt;
  }

  // Which points are missing, and which ones are wrong.
  [[nodiscard]] std::string words(const std::string& also, const std::set<std::size_t>& missing, const std::string& no,
                                  const std::vector<std::string>& wrong) const {
    std::vector<std::string> parts, names;
    for (const std::size_t record : missing) names.push_back(names_text(run_.truth.contact(record)));
    if (!names.empty()) parts.push_back(fmt::format("{}{}", also, fmt::join(names, ", ")));
    if (!wrong.empty()) parts.push_back(fmt::format("{}{}", no, fmt::join(wrong, ", ")));
    return fmt::format("{}", fmt::join(parts, "; "));
  }

  void vary_saddles(std::size_t k, FindingReason reason) {
    if (reason == FindingReason::kSpanningPart) {
      run_.vary(4, reason, "FC-CLAIM-02", k, "parts of contact sets are named");
    } else if (reason == FindingReason::kTieBreak) {
      run_.vary(4, reason, "FC-CLAIM-09", k, "there are ties in the stable manifolds above it");
    } else {
      run_.vary(4, reason, "FC-CLAIM-09", k, "a perturbation makes some of the points above it");
    }
  }

  // Whether the target is an edge of this sample, and a perturbation makes an index-1 point in the edge's middle.
  bool is_perturbed_edge(const ClaimedTarget& target, std::size_t record, PointId name) const {
    const std::vector<PointId> names = class_names(run_.points, target.contact);
    const bool is_edge = names.size() == 2 && std::ranges::find(names, name) != names.end();
    return is_edge && run_.is_made(record, names, 1);
  }

  static std::set<Limit> as_set(const std::vector<NamedTarget>& targets) {
    std::set<Limit> limits;
    for (const NamedTarget& target : targets) limits.insert(target.limit);
    return limits;
  }

  static bool is_exactly(const std::vector<NamedTarget>& targets, const std::array<Limit, 2>& truth, bool by_side) {
    const auto is_other = [](const NamedTarget& t) { return t.fit == Fit::kOther || t.fit == Fit::kMade; };
    if (std::ranges::any_of(targets, is_other)) return false;
    if (by_side) return targets[0].limit == truth[0] && targets[1].limit == truth[1];
    return as_set(targets) == std::set<Limit>{truth[0], truth[1]};
  }

  bool is_permitted(const std::vector<NamedTarget>& targets, const std::array<Limit, 2>& truth, bool by_side) {
    if (std::ranges::any_of(targets, [](const NamedTarget& t) { return t.fit == Fit::kOther; })) return false;
    if (by_side) return may_end(targets[0].limit, truth[0]) && may_end(targets[1].limit, truth[1]);
    const std::set<Limit> limits = as_set(targets);
    if (limits.empty() || limits.size() > 2) return false;
    const Limit &one = *limits.begin(), &other = *limits.rbegin();
    return (may_end(one, truth[0]) && may_end(other, truth[1])) || (may_end(one, truth[1]) && may_end(other, truth[0]));
  }

  // Whether a perturbation can make the orbit that ends at `truth` end at the target.
  bool may_end(const Limit& target, const Limit& truth) {
    if (target == truth) return true;
    const Continuations& permitted = continuations(truth);
    if (permitted.limits.contains(target)) return true;
    if (!permitted.beyond) return false;
    if (!target) return true;
    return run_.index(*target).hull_dimension >= 2 && run_.truth.sphere(*target).squared_radius > *permitted.beyond;
  }

  // It does not recurse, because orbits can go on from saddle to saddle. The distance grows on the way, so that this
  // comes to an end.
  const Continuations& continuations(const Limit& from) {
    std::vector<Limit> open(1, from);
    while (!open.empty()) {
      const Limit at = open.back();
      if (!continuations_.contains(at)) {
        const std::size_t before = open.size();
        if (goes_on(at)) {
          for (const Limit& next : run_.truth.limits(*at)) {
            if (!continuations_.contains(next)) open.push_back(next);
          }
        }
        if (open.size() > before) continue;
        continuations_.emplace(at, continuations_of(at));
      }
      open.pop_back();
    }
    return continuations_.at(from);
  }

  [[nodiscard]] bool goes_on(const Limit& at) const { return at && run_.index(*at) == kIndex2; }

  // The continuations of the limits beyond it must be there.
  Continuations continuations_of(const Limit& at) {
    Continuations result;
    result.limits.insert(at);
    if (goes_on(at)) {
      for (const Limit& next : run_.truth.limits(*at)) {
        const Continuations& further = continuations_.at(next);
        result.limits.insert(further.limits.begin(), further.limits.end());
        if (further.beyond && (!result.beyond || *further.beyond < *result.beyond)) result.beyond = further.beyond;
      }
    } else if (at && !run_.index(*at).is_critical()) {
      result.beyond = run_.truth.sphere(*at).squared_radius;
      run_.leave_unjudged("where, beyond a regular stationary point, a perturbation lets an orbit end (FC-CLAIM-07)");
    }
    return result;
  }

  void vary_parts(std::size_t k, const std::vector<NamedTarget>& targets) {
    if (std::ranges::none_of(targets, [](const NamedTarget& t) { return t.fit == Fit::kPart; })) return;
    run_.vary(4, FindingReason::kSpanningPart, "FC-CLAIM-02", k, limits_text(limits_as_claimed(k)),
              targets_text(run_.claim.points[k]));
  }

  static std::string targets_text(const ClaimedPoint& point) {
    std::vector<std::string> texts;
    for (const ClaimedTarget& target : *point.successors) texts.push_back(target_text(target));
    return texts.empty() ? "up to nothing" : fmt::format("up to {}", fmt::join(texts, ", "));
  }
  [[nodiscard]] std::string limit_text(const Limit& limit) const {
    return limit ? "a " + stationary_text(run_.truth, *limit) : "infinity";
  }
  [[nodiscard]] std::string limits_text(const std::array<Limit, 2>& limits) const {
    return "its orbits end at " + limit_text(limits[0]) + " (side 0) and at " + limit_text(limits[1]) + " (side 1)";
  }

  CheckRun& run_;
  Boundaries boundaries_;
  std::map<Limit, Continuations> continuations_;
  std::map<std::size_t, std::set<std::size_t>> saddles_above_;
};

// False if there is nothing to judge. Only points that are claimed rightly are judged.
bool check_point(CheckRun& run, Incidences& incidences, std::size_t k) {
  const ClaimedPoint& point = run.claim.points[k];
  if (point.hull_dimension) return false;
  const bool has_samples = point.samples.has_value() && point.index == 1 && run.judges(0);
  const bool has_boundary = point.stable && point.stable->boundary && run.judges(1);
  const bool has_successors = point.successors && run.judges(point.index + 1);
  if ((!has_samples && !has_boundary && !has_successors) || !run.can_follow(k)) return false;
  if (has_samples) incidences.check_samples(k);
  if ((has_successors || has_boundary) && run.is_perturbed(k)) {
    run.leave_unjudged("incidences of the points that a perturbation makes of stationary points");
    return has_samples;
  }
  if (has_boundary) incidences.check_boundary(k);
  if (!has_successors) return has_samples || has_boundary;
  if (point.index == 1) incidences.check_saddles_above(k);
  if (point.index == 0) incidences.check_edges(k);
  if (point.index == 2) incidences.check_limits(k);
  if (point.index == 3) incidences.check_nothing_above(k);
  return true;
}

}  // namespace

bool check_incidences(CheckRun& run) {
  Incidences incidences(run);
  const bool judged = run.judge_each(4, 0, 1, [&](std::size_t k) { return check_point(run, incidences, k); });
  incidences.conclude_boundaries();
  return judged;
}

}  // namespace flowcert::certify
