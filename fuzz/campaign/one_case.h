// One case of a campaign, once more or for the first time, and nothing else.
//
// Guarantees: the case is what it is in the campaign, as far as the cases are known that ended a process in
// its batch before it: the batch's later cases do not know of those. What is found has a point file with
// those of the campaign. The campaign has it as well if the batch is done, instead of what it had of the case
// before; otherwise the batch will find it by itself.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "fuzz/campaign/campaign.h"

namespace flowcert::fuzz {

class OneCase : public BatchSource {
 public:
  // Throws std::invalid_argument, one line, if the campaign has no such case.
  OneCase(Campaign& campaign, std::size_t number);

  [[nodiscard]] const CampaignPlan& plan() const override { return campaign_.plan(); }
  [[nodiscard]] std::optional<BatchOrder> next_batch() override;
  void give_back(std::size_t) override { is_handed_out_ = false; }
  void absorb(const std::string& message) override;

  [[nodiscard]] std::size_t number() const { return number_; }
  // False if it was stopped, or its process was killed.
  [[nodiscard]] bool is_done() const { return is_done_; }
  // By "PROPERTY KIND".
  [[nodiscard]] const std::map<std::string, Finding>& findings() const { return findings_; }

 private:
  void absorb(Finding finding);

  Campaign& campaign_;
  std::size_t number_;
  bool is_handed_out_ = false;
  bool is_done_ = false;
  std::map<std::string, Finding> findings_;
};

}  // namespace flowcert::fuzz
