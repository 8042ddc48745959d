#include "certify/list_report.h"

#include <algorithm>
#include <array>
#include <utility>

#include "flowcert/flow_complex.h"

namespace flowcert::certify {

PairReport report_of_pairs(const std::vector<ClaimedPair>& claimed, const std::vector<ListedPair>& truth,
                           double tolerance) {
  PairReport report;
  report.differences = pair_differences(claimed, truth, tolerance);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  report.profile.set(ProfilePart::kPersistence, Profile::State::kCovered);
  report.profile.set_exact(std::ranges::all_of(claimed, is_exact_pair));
  const auto counts = pair_counts(claimed), right = pair_counts(truth);
  report.claimed.assign(counts.begin(), counts.end());
  report.truth.assign(right.begin(), right.end());
  return report;
}

PairReport report_of_cycles(const CycleClaim& claim, const FlowComplex& complex, double tolerance) {
  PairReport report;
  report.thing = ListedThing::kCycles;
  report.claimed.resize(kPairDimensions), report.truth.resize(kPairDimensions);
  report.differences = cycle_differences(complex, claim, tolerance);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  if (claim.is_whole) report.profile.set(ProfilePart::kCycles, Profile::State::kCovered);
  report.profile.set_exact(is_exact_claim(claim));
  report.claimed.at(static_cast<std::size_t>(claim.dimension)) = claim.cycles.size();
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    report.truth.at(static_cast<std::size_t>(pair.dimension)) += pair.death ? 1 : 0;
  }
  return report;
}

PairReport report_of_pores(const PoreClaim& claim, const Pores& pores, double tolerance, const std::string& name) {
  PoreJudgement judgement = judge_pores(claim, pores, tolerance, name);
  PairReport report;
  report.thing = ListedThing::kPores;
  report.differences = std::move(judgement.differences);
  report.verdict = report.differences.empty() ? Verdict::kConforms : Verdict::kFails;
  if (claim.is_whole) report.profile.set(ProfilePart::kPores, Profile::State::kCovered);
  report.profile.set_exact(judgement.is_exact);
  report.claimed.assign(judgement.claimed.begin(), judgement.claimed.end());
  report.truth.assign(judgement.truth.begin(), judgement.truth.end());
  if (!claim.is_whole) report.left_out.assign(judgement.left_out.begin(), judgement.left_out.end());
  return report;
}

const ListWords& list_words(const PairReport& report) {
  static const std::vector<const char*> dimensions = {"components", "tunnels", "voids"};
  static const std::vector<Json> numbers = {0, 1, 2};
  static const std::array words = {
      ListWords{"FC-CLAIM-11", "pairs", "spurious", "dimension", "persistence pairs", dimensions, numbers},
      ListWords{"FC-CLAIM-25", "cycles", "wrong", "dimension", "cycles", dimensions, numbers},
      ListWords{"FC-CLAIM-26",
                "pores",
                "wrong",
                "kind",
                "pores",
                {"twice the peak", "", "twice the gate", "twice the exit"},
                {kPoreKinds.begin(), kPoreKinds.end()}}};
  return words.at(static_cast<std::size_t>(report.thing));
}

DifferenceCounts counts_of(const PairReport& report, std::size_t row) {
  DifferenceCounts counts;
  for (const PairDifference& difference : report.differences) {
    if (static_cast<std::size_t>(difference.dimension) != row) continue;
    counts.spurious += difference.is_claimed ? 1 : 0;
    // A wrong cycle or diameter comes with what is wrong with it.
    counts.missing += difference.is_true && !(report.thing != ListedThing::kPairs && difference.is_claimed) ? 1 : 0;
  }
  return counts;
}

}  // namespace flowcert::certify
