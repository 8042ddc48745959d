#include "fuzz/commands/finding_printer.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace flowcert::commands {

void FindingPrinter::absorb(const std::string& message) {
  const auto finding = fuzz::finding_in(message);
  if (!finding) return absorb_other(message);
  if (has_first_) {
    dropped_.insert(finding->number / plan().batch_cases);
    return;
  }
  const FindingKey key = key_of(*finding);
  if (finding->is_small) return take_small(*finding);
  under_way_.insert(key);
  // The campaign has to know at once which case ends its process.
  if (way_.stops_at_first && !ends_process(*finding)) {
    held_back_.insert_or_assign(key, *finding);
  } else {
    campaign_.absorb(*finding);
  }
}

// A batch of which a finding was dropped is not done.
void FindingPrinter::absorb_other(const std::string& message) {
  if (!dropped_.empty() && fuzz::ends_whole_batch(message)) {
    const auto batch = nlohmann::json::parse(message).at("batch").get<std::size_t>();
    if (dropped_.contains(batch)) return campaign_.give_back(batch);
  }
  campaign_.absorb(message);
}

void FindingPrinter::take_small(const fuzz::Counterexample& finding) {
  const FindingKey key = key_of(finding);
  under_way_.erase(key);
  held_back_.erase(key);
  const auto before = campaign_.counterexamples().find(key);
  const bool is_new = before == campaign_.counterexamples().end() || !before->second.is_small;
  campaign_.absorb(finding);
  if (!is_new || known_.explain(finding)) return;
  has_first_ = way_.stops_at_first;
  if (way_.prints) print(finding);
}

// As many as the report has room for, and one of each kind.
void FindingPrinter::print(const fuzz::Counterexample& finding) {
  if (shown_.contains(shown_of(finding))) return;
  const bool is_new_kind = kinds_printed_.insert(kind_of(finding)).second;
  if (printed_.size() >= kMostFindingsPrinted && !is_new_kind) return;
  progress_.hide();
  if (printed_.empty()) fmt::print("Findings:\n");
  print_finding(campaign_, finding, "");
  std::fflush(stdout);
  printed_.insert(key_of(finding));
  shown_.insert(shown_of(finding));
}

void FindingPrinter::end() {
  if (!has_first_) {
    for (const auto& [key, finding] : held_back_) campaign_.absorb(finding);
  }
  held_back_.clear();
}

}  // namespace flowcert::commands
