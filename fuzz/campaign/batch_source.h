// Where batches come from, and where what came of them goes: a campaign, or a line to one on another machine.
//
// Guarantees: whoever works on batches needs nothing else of their campaign.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "fuzz/campaign/batch.h"

namespace flowcert::fuzz {

class BatchSource {
 public:
  virtual ~BatchSource() = default;

  [[nodiscard]] virtual const CampaignPlan& plan() const = 0;
  // Nothing: there is no more to do.
  [[nodiscard]] virtual std::optional<BatchOrder> next_batch() = 0;
  // A batch that was not done, to be handed out again.
  virtual void give_back(std::size_t batch) = 0;
  // A case that ended its process and has not been made small, each once; nothing: there is no other.
  [[nodiscard]] virtual std::optional<Finding> next_crash() { return std::nullopt; }
  // One line from whoever does a batch (message.h).
  virtual void absorb(const std::string& message) = 0;
};

}  // namespace flowcert::fuzz
