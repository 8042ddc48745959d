// What one claimed cycle is: whether it stands for a pair, and which class it has (FC-CLAIM-25).
//
// Guarantees: exact. All rows exist.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "certify/cycle_claim.h"
#include "certify/layer.h"

namespace flowcert::certify {

// What is wrong with a claimed cycle, if anything, and its class among those that die with the pair.
struct JudgedChain {
  std::string reason, truth;               // empty of one that is right
  std::vector<std::uint32_t> dying, born;  // as in LoopClass; of other dimensions, what may stand for a class

  [[nodiscard]] bool is_right() const { return reason.empty(); }
};

// Judges cycles of one dimension. Not to be used from two threads at once.
class ChainJudge {
 public:
  virtual ~ChainJudge() = default;
  // The level is at least the birth and less than the death.
  [[nodiscard]] virtual JudgedChain of(const ClaimedCycle& cycle, const PersistencePair& pair,
                                       const SquaredLevel& level) = 0;
};
// The complex must outlive it. dimension: 0 to 2.
[[nodiscard]] std::unique_ptr<ChainJudge> chain_judge(const FlowComplex& complex, int dimension);

}  // namespace flowcert::certify
