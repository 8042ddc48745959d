// Claims of pores, in JSON or in lines: refused in one line, or read and judged.
#include <algorithm>

#include "certify/pore_claims.h"
#include "fuzz/targets/reading.h"
#include "fuzz/targets/target.h"

namespace flowcert::fuzz {

namespace {

// Four balls around a chamber, one of them smaller, and a fifth one far away.
const Pores& judged_pores() {
  static const BallSet balls(
      {{{2, 2, 2}, 1}, {{2, -2, -2}, 1}, {{-2, 2, -2}, 1}, {{-2, -2, 2}, Rational(1) / 2}, {{40, 0, 0}, 3}});
  static const Pores pores(balls, Rational(1) / 10);
  return pores;
}

std::string senseless_part(const ClaimedPore& pore) {
  if (pore.line == 0) return "a diameter of no line";
  if (pore.diameter.empty() && pore.kind < PoreKind::kGate) return "a cavity or a window without a diameter";
  const auto is_negative = [](const ClaimedRoot& form) { return form.value.sign() < 0; };
  if (std::ranges::any_of(pore.diameter, is_negative)) return "a negative diameter";
  for (const ClaimedPorePlace& place : pore.places) {
    if (std::ranges::adjacent_find(place.balls, std::greater_equal()) != place.balls.end()) return "balls out of order";
  }
  return {};
}

}  // namespace

std::string complaint_of(Bytes bytes) {
  const std::string_view text = text_of(bytes);
  try {
    (void)is_pore_claim(text, "a");
    const PoreClaim claim = claimed_pores_of(text, "a");
    for (const ClaimedPore& pore : claim.pores) {
      const std::string senseless = senseless_part(pore);
      if (!senseless.empty()) return "read " + senseless;
    }
    const PoreJudgement judgement = judge_pores(claim, judged_pores(), kPoreTolerance, "a");
    const auto wrong = std::ranges::count_if(judgement.differences, &PairDifference::is_claimed);
    if (static_cast<std::size_t>(wrong) > claim.pores.size()) return "more is wrong than is claimed";
    for (const PairDifference& difference : judgement.differences) {
      if (difference.truth.empty() || difference.sentence.empty()) return "wrong for no reason";
    }
  } catch (const InvalidInput& error) {
    return complaint_about_refusal(error);
  }
  return {};
}

}  // namespace flowcert::fuzz
