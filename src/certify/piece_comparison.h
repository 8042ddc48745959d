// Which claimed pieces of a set are true ones, and which true pieces are claimed.
//
// Guarantees: the pairs are a maximum matching (FC-CLAIM-24), so no right claim of pieces is strange. Claims in the
// order of the truth take linear time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "certify/claimed_geometry.h"
#include "certify/matching.h"

namespace flowcert::certify {

struct Comparison {
  std::vector<bool> is_claimed;                     // by true piece
  std::vector<std::optional<std::size_t>> partner;  // the true piece, by claimed piece
  std::vector<std::size_t> strange;                 // claimed pieces that are not true, ascending
  bool is_rounding = true;                          // each strange piece is near a true one, and right of none
  bool is_beyond = true;                            // each strange piece may lie beyond a regular back
};

// Pieces by their names. Only pieces of the same names can be partners; pieces without names have one empty list each.
struct PieceNames {
  std::vector<std::vector<PointId>> claimed;
  std::vector<std::vector<PointId>> truth;

  // Pieces that only their positions tell apart.
  static PieceNames none(std::size_t claimed_count, std::size_t true_count) {
    return {std::vector<std::vector<PointId>>(claimed_count), std::vector<std::vector<PointId>>(true_count)};
  }
};

class PieceMatcher {
 public:
  // How well a claimed piece matches a true one of the same names, both by their places.
  using Match = std::function<ValueMatch(std::size_t claimed, std::size_t truth)>;

  PieceMatcher(const PieceNames& names, Match match) : match_(std::move(match)), true_count_(names.truth.size()) {
    for (std::size_t i = 0; i < names.truth.size(); ++i) groups_[names.truth[i]].places.push_back(i);
    for (const std::vector<PointId>& own : names.claimed) {
      const auto group = groups_.find(own);
      of_claimed_.push_back(group == groups_.end() ? nullptr : &group->second);
    }
  }
  PieceMatcher(const PieceMatcher&) = delete;
  PieceMatcher& operator=(const PieceMatcher&) = delete;

  // is_owed(i): whether true piece i must be claimed. is_beyond(k): whether claimed piece k may be added to the set.
  [[nodiscard]] Comparison compare(const std::function<bool(std::size_t)>& is_owed,
                                   const std::function<bool(std::size_t)>& is_beyond) {
    const IsRightOf is_right = [this](std::size_t k, std::size_t i) { return !is_wrong(match_(k, i)); };
    Matching matching = maximum_matching(of_claimed_, true_count_, is_right);
    prefer_owed(matching, of_claimed_, is_right, is_owed);
    Comparison result;
    for (const auto& claimed : matching.of_truth) result.is_claimed.push_back(claimed.has_value());
    for (std::size_t k = 0; k < of_claimed_.size(); ++k) {
      if (matching.of_claimed[k]) continue;
      result.strange.push_back(k);
      result.is_rounding = result.is_rounding && best(k) == ValueMatch::kRounding;
      result.is_beyond = result.is_beyond && is_beyond(k) && is_wrong(best(k));
    }
    result.partner = std::move(matching.of_claimed);
    return result;
  }
  // All true pieces must be claimed, and nothing may be added.
  [[nodiscard]] Comparison compare() {
    return compare([](std::size_t) { return true; }, [](std::size_t) { return false; });
  }

  // Whether a claimed piece is right of several true ones, so that its partner may be another than it means.
  [[nodiscard]] bool is_ambiguous(std::size_t k) const {
    return of_claimed_[k] != nullptr &&
           std::ranges::count_if(of_claimed_[k]->places, [&](std::size_t i) { return !is_wrong(match_(k, i)); }) > 1;
  }

 private:
  [[nodiscard]] ValueMatch best(std::size_t k) const {
    ValueMatch found = ValueMatch::kOff;
    if (of_claimed_[k] == nullptr) return found;
    for (const std::size_t i : of_claimed_[k]->places) {
      found = std::min(found, match_(k, i));
      if (!is_wrong(found)) break;
    }
    return found;
  }

  Match match_;
  std::size_t true_count_;
  std::map<std::vector<PointId>, Candidates> groups_;
  std::vector<Candidates*> of_claimed_;
};

// A claimed ring may begin at any corner and go either way around. matches(corner, other): how well a claimed corner
// matches a true one.
template <typename Claimed, typename True, typename Matches>
[[nodiscard]] ValueMatch match_ring(const Claimed& claimed, const True& truth, const Matches& matches) {
  const std::size_t n = truth.size();
  if (claimed.size() != n) return ValueMatch::kOff;
  ValueMatch best = ValueMatch::kOff;
  for (std::size_t turn = 0; turn < 2 * n && is_wrong(best); ++turn) {
    ValueMatch worst = ValueMatch::kEqual;
    for (std::size_t i = 0; i < n && worst != ValueMatch::kOff; ++i) {
      const std::size_t at = turn < n ? (i + turn) % n : (2 * n + turn - i) % n;
      worst = std::max(worst, matches(claimed[i], truth[at]));
    }
    best = std::min(best, worst);
  }
  return best;
}

}  // namespace flowcert::certify
