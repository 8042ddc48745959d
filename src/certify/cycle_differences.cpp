#include "certify/cycle_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "certify/claimed_chains.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/layer.h"
#include "certify/matching.h"
#include "geometry/floating_point.h"
#include "morse/dependent_sums.h"
#include "morse/record_finder.h"

namespace flowcert {

using namespace certify;

namespace {

constexpr char kWrongPair[] = "wrong-pair";

// A cycle, judged as one of some pair.
struct JudgedCycle {
  std::size_t pair = 0;  // which one
  JudgedChain chain;
};

class CycleJudge {
 public:
  CycleJudge(const FlowComplex& complex, const CycleClaim& claim, double tolerance)
      : complex_(complex),
        claim_(claim),
        tolerance_(tolerance),
        values_(complex.persistence().squared_distances()),
        judge_(chain_judge(complex, claim.dimension)) {
    for (const PersistencePair& pair : complex.persistence().pairs()) {
      if (pair.dimension == claim.dimension && pair.death) pairs_.push_back(pair);
    }
    std::ranges::sort(pairs_, {}, [this](const PersistencePair& pair) { return values_of(pair); });
  }

  [[nodiscard]] std::vector<PairDifference> differences() {
    if (claim_.pairs && *claim_.pairs != pairs_.size()) {
      add("wrong-counts", fmt::format("{} pairs", *claim_.pairs), fmt::format("there are {}", pairs_.size()), 0);
    }
    for (const ClaimedCycle& cycle : claim_.cycles) judge(cycle);
    match();
    find_dependent();
    for (std::size_t k = 0; k < claim_.cycles.size(); ++k) {
      const JudgedChain& chain = chosen_[k].chain;
      if (!chain.is_right()) add(chain.reason, claimed_text(k), chain.truth, claim_.cycles[k].line);
    }
    for (std::size_t p = 0; claim_.is_whole && p < pairs_.size(); ++p) {
      if (is_taken_[p]) continue;
      found_.push_back({"no such cycle", pair_text(pairs_[p]), "missing", claim_.dimension, false, true, 0});
    }
    return std::move(found_);
  }

 private:
  // Pairs of the same values stand side by side.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> values_of(const PersistencePair& pair) const {
    return {values_.rank(*pair.death), values_.rank(pair.birth)};
  }

  void add(const std::string& reason, std::string claimed, std::string truth, std::size_t line) {
    found_.push_back({std::move(claimed), std::move(truth), reason, claim_.dimension, true, true, line});
  }

  [[nodiscard]] std::string pair_text(const PersistencePair& pair) const {
    return fmt::format("dimension {}, birth {}, death {}", pair.dimension, number_text(values_.exact(pair.birth)),
                       number_text(values_.exact(*pair.death)));
  }
  [[nodiscard]] static std::string end_text(const ClaimedPairEnd& end) {
    return end.contact.empty() ? number_text(*end.squared_distance) : names_text(end.contact);
  }
  [[nodiscard]] std::string claimed_text(std::size_t k) const {
    const ClaimedCycle& cycle = claim_.cycles[k];
    const std::string level = cycle.squared_level ? ", level " + number_text(*cycle.squared_level) : "";
    return fmt::format("cycle {} of dimension {}, birth {}, death {}{}", k, claim_.dimension, end_text(cycle.birth),
                       end_text(cycle.death), level);
  }

  // ---- Which pair is meant ----

  // Whether an end of a pair can be what is claimed.
  [[nodiscard]] bool is_meant(const ClaimedPairEnd& end, const std::optional<std::uint32_t>& named,
                              std::uint32_t record) const {
    if (!end.contact.empty() && (!named || values_.rank(*named) != values_.rank(record))) return false;
    return !end.squared_distance || is_right_value(*end.squared_distance, values_.exact(record), tolerance_);
  }
  [[nodiscard]] std::optional<std::uint32_t> named(const ClaimedPairEnd& end, int index) const {
    if (end.contact.empty()) return std::nullopt;
    const auto dimension = static_cast<std::uint8_t>(index);
    const auto names = class_names(complex_.points(), end.contact);
    const auto record = RecordFinder(complex_.stationary()).find({dimension, dimension}, names);
    return record ? std::optional(static_cast<std::uint32_t>(*record)) : std::nullopt;
  }
  // How far in doubles a claimed number is from a value.
  [[nodiscard]] double distance(const ClaimedPairEnd& end, std::uint32_t record) const {
    if (!end.squared_distance) return 0;
    return std::fabs(as_double(end.squared_distance->value) - values_.approximation(record).value);
  }

  // One pair of each values that can be meant, by its place; the nearest first.
  [[nodiscard]] std::vector<std::size_t> candidates_of(const ClaimedCycle& cycle) const {
    const auto birth = named(cycle.birth, claim_.dimension), death = named(cycle.death, claim_.dimension + 1);
    auto [first, last] = near(cycle.death, death);
    std::vector<std::pair<double, std::size_t>> meant;
    for (std::size_t p = first; p < last; ++p) {
      if (p > first && values_of(pairs_[p]) == values_of(pairs_[p - 1])) continue;
      if (!is_meant(cycle.death, death, *pairs_[p].death) || !is_meant(cycle.birth, birth, pairs_[p].birth)) continue;
      meant.emplace_back(distance(cycle.birth, pairs_[p].birth) + distance(cycle.death, *pairs_[p].death), p);
    }
    std::ranges::sort(meant);
    std::vector<std::size_t> places;
    for (const auto& [off, place] : meant) places.push_back(place);
    return places;
  }
  // A part of the pairs that has all whose death can be meant: from the first place up to the last one.
  [[nodiscard]] std::pair<std::size_t, std::size_t> near(const ClaimedPairEnd& end,
                                                         const std::optional<std::uint32_t>& named) const {
    double low = -HUGE_VAL, high = HUGE_VAL;
    if (named) {
      low = high = values_.approximation(*named).value;
    } else if (end.squared_distance && tolerance_ < Rational(1, 2)) {
      low = high = as_double(end.squared_distance->value);
      // The true value differs by less than this part of the claimed one. The constant is for what is rounded here.
      constexpr double kRoundedPart = 0x1p-40;
      const double part = 2 * as_double(tolerance_) + kRoundedPart;
      low -= part * std::fabs(low);
      high += part * std::fabs(high);
    }
    const auto value = [this](const PersistencePair& pair) { return values_.approximation(*pair.death); };
    const auto begin = std::ranges::partition_point(
        pairs_, [&](const PersistencePair& pair) { return value(pair).value + value(pair).error < low; });
    const auto stop = std::ranges::partition_point(
        pairs_, [&](const PersistencePair& pair) { return value(pair).value - value(pair).error <= high; });
    return {begin - pairs_.begin(), std::max(stop, begin) - pairs_.begin()};
  }

  // ---- One cycle ----

  void judge(const ClaimedCycle& cycle) {
    right_.emplace_back();
    JudgedCycle first{0, {kWrongPair, "there is no such pair", {}, {}}};
    for (const std::size_t p : candidates_of(cycle)) {
      JudgedCycle judged{p, judged_as(cycle, pairs_[p])};
      if (judged.chain.is_right()) {
        right_.back().push_back(std::move(judged));
      } else if (first.chain.reason == kWrongPair) {
        first = std::move(judged);
      }
    }
    chosen_.push_back(std::move(first));
  }
  [[nodiscard]] JudgedChain judged_as(const ClaimedCycle& cycle, const PersistencePair& pair) const {
    SquaredLevel level(values_, pair.birth, pair.birth, 0);
    const auto& claimed = cycle.squared_level;
    if (claim_.dimension > 0 && claimed && !is_right_value(*claimed, values_.exact(pair.birth), tolerance_)) {
      level = claimed->value;
      if (values_.compare(pair.birth, level) > 0 || values_.compare(*pair.death, level) <= 0) {
        return {kWrongPair, "the pair is not there at this level", {}, {}};
      }
    }
    return judge_->of(cycle, pair, level);
  }

  // ---- All of them ----

  // Each pair has one cycle at most.
  void match() {
    std::map<std::vector<std::size_t>, Candidates> shared;  // by the pairs for which a cycle is right
    std::vector<Candidates*> candidates;
    for (const std::vector<JudgedCycle>& right : right_) {
      std::vector<std::size_t> firsts;
      for (const JudgedCycle& judged : right) firsts.push_back(judged.pair);
      const auto [known, is_new] = shared.try_emplace(firsts);
      candidates.push_back(&known->second);
      for (const std::size_t first : is_new ? firsts : std::vector<std::size_t>()) {
        const auto has_values = [&](const PersistencePair& pair) {
          return values_of(pair) == values_of(pairs_[first]);
        };
        for (std::size_t p = first; p < pairs_.size() && has_values(pairs_[p]); ++p) known->second.places.push_back(p);
      }
    }
    const Matching matching =
        maximum_matching(candidates, pairs_.size(), [](std::size_t, std::size_t) { return true; });
    for (const auto& claimed : matching.of_truth) is_taken_.push_back(claimed.has_value());
    for (std::size_t k = 0; k < right_.size(); ++k) {
      if (right_[k].empty()) continue;
      const auto& partner = matching.of_claimed[k];
      const auto is_partner = [&](const JudgedCycle& judged) {
        return partner && values_of(pairs_[judged.pair]) == values_of(pairs_[*partner]);
      };
      const auto found = std::ranges::find_if(right_[k], is_partner);
      chosen_[k] = found != right_[k].end()
                       ? std::move(*found)
                       : JudgedCycle{0, {kWrongPair, "all pairs of these values have other cycles", {}, {}}};
    }
  }

  // Cycles of one death have to be independent, and those at birth also for each birth and death.
  void find_dependent() {
    std::map<std::uint32_t, std::vector<std::size_t>> by_death;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> by_values;
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      if (!chosen_[k].chain.is_right()) continue;
      const auto values = values_of(pairs_[chosen_[k].pair]);
      by_death[values.first].push_back(k);
      if (!chosen_[k].chain.born.empty()) by_values[values].push_back(k);
    }
    for (const auto& [death, cycles] : by_death) require_independent(cycles, &JudgedChain::dying);
    for (const auto& [values, cycles] : by_values) require_independent(cycles, &JudgedChain::born);
  }
  void require_independent(const std::vector<std::size_t>& cycles, std::vector<std::uint32_t> JudgedChain::* sum) {
    std::vector<std::vector<std::uint32_t>> sums;
    for (const std::size_t k : cycles) sums.push_back(chosen_[k].chain.*sum);
    const std::vector<bool> are_dependent = dependent_sums(sums);
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      JudgedChain& chain = chosen_[cycles[i]].chain;
      if (are_dependent[i] && chain.is_right()) {
        chain.reason = "dependent";
        chain.truth = "it is a sum of other cycles of the claim, and of what bounds before";
      }
    }
  }

  const FlowComplex& complex_;
  const CycleClaim& claim_;
  Rational tolerance_;
  const SquaredDistances& values_;
  std::unique_ptr<ChainJudge> judge_;
  std::vector<PersistencePair> pairs_;           // by death, then birth
  std::vector<std::vector<JudgedCycle>> right_;  // by cycle: for which pairs it is right
  std::vector<JudgedCycle> chosen_;              // by cycle: a right one, or what is wrong
  std::vector<bool> is_taken_;                   // by pair
  std::vector<PairDifference> found_;
};

}  // namespace

bool is_exact_claim(const CycleClaim& claim) {
  const auto is_exact = [](const std::optional<ClaimedNumber>& number) { return !number || number->is_exact; };
  return std::ranges::all_of(claim.cycles, [&](const ClaimedCycle& cycle) {
    return is_exact(cycle.birth.squared_distance) && is_exact(cycle.death.squared_distance) &&
           is_exact(cycle.squared_level);
  });
}

std::vector<PairDifference> cycle_differences(const FlowComplex& complex, const CycleClaim& claim, double tolerance) {
  const geometry::IeeeDoubles ieee;
  return CycleJudge(complex, claim, tolerance).differences();
}

}  // namespace flowcert
