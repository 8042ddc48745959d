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
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/claimed_geometry.h"
#include "certify/claimed_rows.h"
#include "certify/matching.h"

namespace flowcert::certify {

struct Comparison {
  std::vector<bool> is_claimed;                     // by true piece
  std::vector<std::optional<std::size_t>> partner;  // the true piece, by claimed piece
  std::vector<std::size_t> strange;                 // claimed pieces that are not true, ascending
  bool is_rounding = true;                          // each strange piece is near a true one, and right of none
  bool is_beyond = true;                            // each strange piece may lie beyond a regular back
};

// Calls use(corner) for all corners of an unstable set.
template <typename X, typename Use>
void for_each_corner(const UnstableSurface<X>& surface, const Use& use) {
  for (const auto* parts : {&surface.traces, &surface.runs}) {
    for (const EdgePart<X>& part : *parts) use(part.front), use(part.back);
  }
  for (const Region<X>& sheet : surface.sheets) std::ranges::for_each(sheet.corners, use);
  for (const Crossing<X>& segment : surface.segments) use(segment.front), use(segment.back);
}

// Pieces by their names. Only pieces of the same names can be partners; pieces without names have one empty list each.
struct PieceNames {
  std::vector<std::vector<PointId>> claimed;
  std::vector<std::vector<PointId>> truth;

  // Pieces of the same shape.
  template <typename Claimed, typename True>
  static PieceNames of(const PointSet& points, const std::vector<Claimed>& claimed, const std::vector<True>& truth) {
    PieceNames names;
    for (const Claimed& piece : claimed) names.claimed.push_back(class_names(points, names_in(piece)));
    for (const True& piece : truth) names.truth.emplace_back(names_in(piece).begin(), names_in(piece).end());
    return names;
  }
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

// How well a claimed piece matches a true one of the same names. match_corner(claimed, truth): how well corners match.
// Corners of a part of an edge may come in either order, unless the flow goes along it.
template <typename Claimed, typename True, typename Match>
[[nodiscard]] ValueMatch match_piece(const PointSet& points, const Claimed& claimed, const True& truth,
                                     const Match& match_corner) {
  if constexpr (requires { truth.corners; }) {
    if (claimed.corners.empty() && truth.corners.empty()) return ValueMatch::kEqual;
    return match_ring(claimed.corners, truth.corners, match_corner);
  } else {
    if constexpr (requires { truth.back_contact; }) {
      const auto is = [&](const std::optional<std::vector<PointId>>& rows, const std::vector<PointId>& names) {
        return !rows || class_names(points, *rows) == names;
      };
      const bool is_same = is(claimed.front_contact, truth.front_contact) &&
                           is(claimed.back_contact, truth.back_contact) &&
                           claimed.back_kind.value_or(truth.back_kind) == truth.back_kind;
      if (!is_same) return ValueMatch::kOff;
    }
    if constexpr (requires { truth.back_is_stationary; }) {
      if (claimed.back_is_stationary.value_or(truth.back_is_stationary) != truth.back_is_stationary) {
        return ValueMatch::kOff;
      }
    }
    const auto match = [&](const auto& front, const auto& back) {
      return std::max(match_corner(front, truth.front), match_corner(back, truth.back));
    };
    const ValueMatch as_claimed = match(claimed.front, claimed.back);
    constexpr bool kInEitherOrder = std::is_same_v<True, EdgePart<>>;
    if (!kInEitherOrder || !is_wrong(as_claimed)) return as_claimed;
    return std::min(as_claimed, match(claimed.back, claimed.front));
  }
}

// match_corner(claimed, truth, true piece): how well corners of two pieces match. The lists must outlive the matcher.
template <typename Claimed, typename True, typename Match>
[[nodiscard]] PieceMatcher piece_matcher(const PointSet& points, const std::vector<Claimed>& claimed,
                                         const std::vector<True>& truth, const Match& match_corner) {
  return PieceMatcher(PieceNames::of(points, claimed, truth),
                      [&points, &claimed, &truth, match_corner](std::size_t c, std::size_t i) {
                        return match_piece(points, claimed[c], truth[i],
                                           [&](const auto& x, const auto& y) { return match_corner(x, y, truth[i]); });
                      });
}

}  // namespace flowcert::certify
