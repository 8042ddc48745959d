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
  if (finding.number != number_) return campaign_.absorb(finding);  // ended a process before it was its turn
  finding.is_asked = true;
  const std::string kind = kind_of(finding);
  findings_.insert_or_assign(kind, finding);
  is_done_ = is_done_ || ends_process(finding);
  if (!campaign_.is_done(number_ / plan().batch_cases)) return campaign_.write_asked(finding);
  // Something small gives way to nothing but something small.
  if (finding.is_small || !campaign_.findings().contains({number_, kind})) campaign_.absorb(finding);
}

}  // namespace flowcert::fuzz
