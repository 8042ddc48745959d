// Level 5 for what leaves stationary points: λ-lists (FC-CLAIM-13), connections, and whether the input is Morse-Smale
// (FC-CLAIM-14). No perturbation excuses a difference.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

// What names no stationary point rightly is not known.
NamedTarget rightly_named(CheckRun& run, const ClaimedTarget& target) {
  NamedTarget named = named_target(run, target);
  named.is_known = named.is_known && named.fit != Fit::kOther;
  return named;
}

bool is_part(const NamedTarget& named) { return named.is_known && named.fit == Fit::kPart; }

// The labels of a list: directions, and arcs between them.
template <typename Label>
struct Labels {
  std::vector<Label> directions, arcs;
};

// The labels that label_of(limit) gives a claimed list, or a true one.
template <typename List, typename LabelOf>
auto labels_of(const List& list, const LabelOf& label_of) {
  Labels<decltype(label_of(list.arcs.front()))> labels;
  for (const auto& direction : list.directions) labels.directions.push_back(label_of(direction.limit));
  for (const auto& arc : list.arcs) labels.arcs.push_back(label_of(arc));
  return labels;
}

constexpr std::size_t kMostLimitsShown = 12;

class LambdaLists {
 public:
  explicit LambdaLists(CheckRun& run) : run_(run) {}

  void check_list(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    const ClaimedLambdaList& claimed = *run_.claim.points[k].lambda;
    LambdaList truth = run_.truth.lambda_list(record);
    // The sides of an index-2 point may be named by another part of its contact set.
    if (truth.directions.size() == 2 && truth.arcs.empty() && run_.true_side(k, 0) == 1) {
      std::swap(truth.directions[0], truth.directions[1]);
    }
    const auto labels = labels_of(claimed, [this](const ClaimedTarget& limit) { return rightly_named(run_, limit); });
    const std::vector<std::size_t> turns = right_turns(labels, truth, is_cycle(record));
    if (turns.empty()) {
      find(k, FindingReason::kWrongLambdaList, "FC-UNST-02", text_of_claimed(claimed), text_of_true(truth));
      return;
    }
    check_exits(k, claimed, truth, turns);
    if (std::ranges::any_of(labels.directions, is_part) || std::ranges::any_of(labels.arcs, is_part)) {
      run_.vary(5, FindingReason::kSpanningPart, "FC-CLAIM-02", k, text_of_true(truth));
    }
  }

  void check_connections(std::size_t k) {
    std::map<Limit, Connection> missing;
    for (const Connection& one : run_.truth.connections(run_.placed[k].place->record)) {
      missing.emplace(one.to == Connection::kInfinity ? Limit() : Limit(one.to), one);
    }
    bool has_part = false;
    for (const ClaimedConnection& claimed : *run_.claim.points[k].connections) {
      const NamedTarget to = rightly_named(run_, claimed.to);
      const auto truth = to.is_known ? missing.find(to.limit) : missing.end();
      if (truth == missing.end()) {
        find_connection(k, "a connection to " + target_text(claimed.to), "there is none, or it is claimed already");
        continue;
      }
      check_numbers(k, claimed, truth->second);
      missing.erase(truth);
      has_part = has_part || is_part(to);
    }
    for (const auto& [to, connection] : missing) {
      find_connection(k, "no connection to " + text_of(to), numbers_text(connection.orbits, connection.families));
    }
    if (has_part) run_.vary(5, FindingReason::kSpanningPart, "FC-CLAIM-02", k, "parts of contact sets are named");
  }

  // Whether a perturbation makes other points of the point, or of one to which its directions lead.
  [[nodiscard]] bool is_perturbed(std::size_t k) {
    const std::size_t record = run_.placed[k].place->record;
    if (run_.perturbed.empty()) return false;
    return run_.perturbed.contains(record) ||
           std::ranges::any_of(run_.truth.lambda_entries(record), [this](const FlowLimits::Entry& entry) {
             return entry.limit != FlowLimits::Entry::kInfinity && run_.perturbed.contains(entry.limit);
           });
  }

 private:
  void find(std::size_t k, FindingReason reason, const std::string& clause, const std::string& claimed,
            const std::string& truth) {
    run_.find(5, reason, clause, k, truth, claimed);
  }
  void find_connection(std::size_t k, const std::string& claimed, const std::string& truth) {
    find(k, FindingReason::kWrongConnections, "FC-CONN-01", claimed, truth);
  }

  [[nodiscard]] bool is_cycle(std::size_t record) const { return run_.index(record) == kIndex1; }

  // By how many places the claimed list may be turned so that its limits are the true ones.
  static std::vector<std::size_t> right_turns(const Labels<NamedTarget>& claimed, const LambdaList& truth,
                                              bool is_cycle) {
    const std::size_t n = truth.directions.size(), arcs = truth.arcs.size();
    if (claimed.directions.size() != n || claimed.arcs.size() != arcs) return {};
    const auto is = [](const NamedTarget& label, const Limit& limit) { return label.is_known && label.limit == limit; };
    std::vector<std::size_t> turns;
    for (std::size_t turn = 0; turn < (is_cycle ? std::max<std::size_t>(n, 1) : 1); ++turn) {
      bool is_right = true;
      for (std::size_t i = 0; i < n && is_right; ++i) {
        is_right = is(claimed.directions[(i + turn) % n], truth.directions[i].limit);
      }
      for (std::size_t i = 0; i < arcs && is_right; ++i) is_right = is(claimed.arcs[(i + turn) % arcs], truth.arcs[i]);
      if (is_right) turns.push_back(turn);
    }
    return turns;
  }

  // Turns the list so that as many exits as possible are right, and reports the first one that is wrong then.
  void check_exits(std::size_t k, const ClaimedLambdaList& claimed, const LambdaList& truth,
                   const std::vector<std::size_t>& turns) {
    const std::size_t n = truth.directions.size();
    const ValueScale scale(run_.truth.sphere(run_.placed[k].place->record), run_.options.tolerance);
    std::vector<std::size_t> fewest;  // wrong exits
    std::size_t best_turn = 0;
    bool by_rounding = false;
    for (std::size_t t = 0; t < turns.size() && (t == 0 || !fewest.empty()); ++t) {
      std::vector<std::size_t> wrong;
      bool rounding = true;
      for (std::size_t i = 0; i < n; ++i) {
        const ValueMatch match = matched(claimed.directions[(i + turns[t]) % n], truth.directions[i], scale);
        if (!is_wrong(match)) continue;
        wrong.push_back(i);
        rounding = rounding && match == ValueMatch::kRounding;
      }
      if (t > 0 && wrong.size() >= fewest.size()) continue;
      fewest = wrong;
      best_turn = turns[t];
      by_rounding = rounding;
    }
    if (fewest.empty()) return;
    const std::size_t first = fewest.front();
    find(k, rounding_or(FindingReason::kWrongLambdaList, by_rounding), "FC-UNST-02",
         text_of(claimed.directions[(first + best_turn) % n]),
         text_of(truth.directions[first]) + " (in all " + std::to_string(fewest.size()) + " such directions)");
  }

  ValueMatch matched(const ClaimedDirection& claimed, const LambdaList::Direction& truth, const ValueScale& scale) {
    if (!claimed.exit) return ValueMatch::kEqual;
    run_.note_exactness(is_exact(*claimed.exit));
    if (claimed.is_vector != truth.is_vector) return ValueMatch::kOff;
    const ValueMatch match = claimed.is_vector ? match_vector(*claimed.exit, truth.exit, run_.options.tolerance)
                                               : match_position(*claimed.exit, truth.exit, scale);
    return claimed.rounded_exit ? std::max(match, matched_doubles(claimed, truth, scale)) : match;
  }

  // The doubles beside exact coordinates. There is none exactly where no double is near.
  ValueMatch matched_doubles(const ClaimedDirection& claimed, const LambdaList::Direction& truth,
                             const ValueScale& scale) {
    const auto& doubles = *claimed.rounded_exit;
    if (claimed.is_vector) {
      if (!doubles[0] || !doubles[1] || !doubles[2]) return ValueMatch::kOff;
      return match_vector({*doubles[0], *doubles[1], *doubles[2]}, truth.exit, run_.options.tolerance);
    }
    ValueMatch worst = ValueMatch::kEqual;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      worst = std::max(worst, match_double(doubles[axis], truth.exit[axis], scale));
    }
    return worst;
  }

  void check_numbers(std::size_t k, const ClaimedConnection& claimed, const Connection& truth) {
    if (claimed.orbits == truth.orbits && claimed.families == truth.families) return;
    find_connection(k, "to " + target_text(claimed.to) + " " + numbers_text(claimed.orbits, claimed.families),
                    numbers_text(truth.orbits, truth.families));
  }

  static std::string numbers_text(std::size_t orbits, std::size_t families) {
    return "orbits: " + std::to_string(orbits) + ", families: " + std::to_string(families);
  }

  [[nodiscard]] std::string text_of(const Limit& limit) const {
    return limit ? names_text(run_.truth.contact(*limit)) : "infinity";
  }
  static std::string text_of(const ClaimedDirection& direction) {
    const std::string text = "a direction to " + target_text(direction.limit);
    if (!direction.exit) return text;
    return text + (direction.is_vector ? ", along " : ", leaving at ") + position_text(*direction.exit);
  }
  [[nodiscard]] std::string text_of(const LambdaList::Direction& direction) const {
    return (direction.is_vector ? "it leads along " : "it leaves at ") + position_text(direction.exit);
  }

  // Directions and arcs in turn; arcs are in parentheses.
  static std::string list_text(const Labels<std::string>& labels) {
    std::string text;
    const std::size_t count = std::max(labels.directions.size(), labels.arcs.size());
    const auto add = [&text](const std::string& one) { text.append(text.empty() ? "" : ", ").append(one); };
    for (std::size_t i = 0; i < std::min(count, kMostLimitsShown); ++i) {
      if (i < labels.directions.size()) add(labels.directions[i]);
      if (i < labels.arcs.size()) add("(" + labels.arcs[i] + ")");
    }
    if (count > kMostLimitsShown) text += ", ...";
    return std::to_string(labels.directions.size()) + " directions and " + std::to_string(labels.arcs.size()) +
           " arcs: " + (text.empty() ? "none" : text);
  }
  static std::string text_of_claimed(const ClaimedLambdaList& list) { return list_text(labels_of(list, target_text)); }
  [[nodiscard]] std::string text_of_true(const LambdaList& list) const {
    return list_text(labels_of(list, [this](const Limit& limit) { return text_of(limit); }));
  }

  CheckRun& run_;
};

void check_morse_smale(CheckRun& run) {
  const bool truth = run.truth.is_morse_smale();
  if (*run.claim.morse_smale == truth) return;
  run.find_whole(5, FindingReason::kWrongConnections, "FC-CONN-03",
                 *run.claim.morse_smale ? "a Morse-Smale input" : "an input that is not Morse-Smale",
                 truth ? "it is Morse-Smale" : "it is not");
}

}  // namespace

bool check_lambda_lists(CheckRun& run) {
  LambdaLists lists(run);
  const bool has_morse_smale = run.claim.morse_smale.has_value();
  if (has_morse_smale) check_morse_smale(run);
  const bool has_points = run.judge_each(5, 2, kPartsOfLevel5, [&](std::size_t k) {
    const ClaimedPoint& point = run.claim.points[k];
    if ((!point.lambda && !point.connections) || !run.can_follow(k)) return false;
    if (!run.judges(2) || !run.judges(3)) {
      run.leave_unjudged("lambda-lists and connections, which lead to points of other indices (FC-CLAIM-12)");
      return false;
    }
    if (lists.is_perturbed(k)) {
      run.leave_unjudged(
          "lambda-lists and connections of, or to, the points that a perturbation makes of stationary points");
      return false;
    }
    if (point.lambda) lists.check_list(k);
    if (point.connections) lists.check_connections(k);
    return true;
  });
  return has_morse_smale || has_points;
}

}  // namespace flowcert::certify
