// Which claimed pieces of a set are true ones, and which true pieces are claimed.
//
// Guarantees: each true piece is claimed by at most one piece. Every claimed piece that matches a true one that is not
// claimed yet takes the first such, from the one after the latest on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "certify/claimed_geometry.h"

namespace flowcert::certify {

struct Comparison {
  std::vector<bool> is_claimed;                     // by true piece
  std::vector<std::optional<std::size_t>> partner;  // the true piece, by claimed piece
  std::vector<std::string> strange;                 // claimed pieces that are not true
  bool is_rounding = true;                          // each strange piece is near a true one
  bool is_beyond = true;                            // each strange piece may lie beyond a regular back
};

// matches(claimed, i): how well a claimed piece matches true piece i.
template <typename Claimed, typename Matches, typename Beyond, typename Text>
[[nodiscard]] Comparison compare_pieces(const std::vector<Claimed>& claimed, std::size_t true_count,
                                        const Matches& matches, const Beyond& is_beyond, const Text& text) {
  Comparison result{std::vector<bool>(true_count, false), {}, {}};
  std::size_t guess = 0;  // claims are mostly in the order of the truth
  for (const Claimed& piece : claimed) {
    ValueMatch best = ValueMatch::kOff;
    result.partner.emplace_back();
    for (std::size_t step = 0; step < true_count; ++step) {
      const std::size_t i = (guess + step) % true_count;
      if (result.is_claimed[i]) continue;
      const ValueMatch match = matches(piece, i);
      best = std::min(best, match);
      if (is_wrong(match)) continue;
      result.is_claimed[i] = true;
      result.partner.back() = i;
      guess = i + 1;
      break;
    }
    if (!is_wrong(best)) continue;
    result.strange.push_back(text(piece));
    result.is_rounding = result.is_rounding && best == ValueMatch::kRounding;
    bool is_again = false;
    for (std::size_t i = 0; i < true_count; ++i) {
      is_again = is_again || (result.is_claimed[i] && !is_wrong(matches(piece, i)));
    }
    result.is_beyond = result.is_beyond && !is_again && is_beyond(piece);
  }
  return result;
}

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
