// See one_case.h.
#include "fuzz/campaign/one_case.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace flowcert::fuzz {

OneCase::OneCase(Campaign& campaign, std::size_t number) : campaign_(campaign), number_(number) {
  const Shard& shard = plan().shard;
  const std::size_t total = campaign.total_cases().value_or(kMostCasesOfCampaign);
  if (number >= total || number / plan().batch_cases % shard.count != shard.index) {
    throw std::invalid_argument("the campaign has no case " + std::to_string(number));
  }
}

std::optional<BatchOrder> OneCase::next_batch() {
  if (is_done_ || is_handed_out_) return std::nullopt;
  is_handed_out_ = true;
  BatchOrder order = campaign_.order_of(number_ / plan().batch_cases);
  order.only = number_;
  return order;
}

void OneCase::absorb(const std::string& message) {
  const auto object = nlohmann::json::parse(message);
  if (object.contains("finding")) return absorb(finding_of(object.at("finding")));
  if (object.contains("batch")) is_done_ = is_done_ || tally_of(object.at("tally")).cases > 0;
}

void OneCase::absorb(Finding finding) {
  const bool is_asked = finding.number == number_;
  finding.is_asked = is_asked && finding.is_small;
  if (is_asked) {
    findings_.insert_or_assign(finding.property + ' ' + finding.disagreement.kind, finding);
    is_done_ = is_done_ || ends_process(finding);
  }
  if (!is_asked || finding.is_small) campaign_.absorb(finding);
}

}  // namespace flowcert::fuzz
