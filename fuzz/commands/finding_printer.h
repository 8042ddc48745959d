// A campaign whose findings are printed as they come, on standard output: each as soon as it is small.
//
// Guarantees: all that is absorbed reaches the campaign. Each finding is printed once, and known ones are not printed.
// The first of those that are equal but for their case is printed. Where the campaign is to stop at its first finding
// (`--first`), those that are not small yet are held back until the end. Once the first one is there the others are
// dropped, and their batches are not done.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/fuzz_progress.h"
#include "fuzz/commands/fuzz_report.h"
#include "fuzz/commands/known_findings.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

class FindingPrinter : public fuzz::BatchSource {
 public:
  struct Way {
    bool prints = true;
    bool stops_at_first = false;
  };

  // All must outlive this. The progress is hidden before anything is printed.
  FindingPrinter(fuzz::Campaign& campaign, const KnownFindings& known, FuzzProgress& progress, Way way)
      : campaign_(campaign), known_(known), progress_(progress), way_(way) {}

  [[nodiscard]] const fuzz::CampaignPlan& plan() const override { return campaign_.plan(); }
  [[nodiscard]] std::optional<fuzz::BatchOrder> next_batch() override { return campaign_.next_batch(); }
  void give_back(std::size_t batch) override { campaign_.give_back(batch); }
  [[nodiscard]] std::optional<fuzz::Counterexample> next_crash() override { return campaign_.next_crash(); }
  void absorb(const std::string& message) override;

  // With stops_at_first: whether the first finding is there, and small.
  [[nodiscard]] bool has_first() const { return has_first_; }
  // With stops_at_first: whether there is a finding that is being made small.
  [[nodiscard]] bool makes_first_small() const { return way_.stops_at_first && !under_way_.empty(); }
  // Gives the campaign what was held back, unless the first finding is there.
  void end();

  [[nodiscard]] const FindingKeys& printed() const { return printed_; }

 private:
  void absorb_other(const std::string& message);
  void take_small(const fuzz::Counterexample& finding);
  void print(const fuzz::Counterexample& finding);

  fuzz::Campaign& campaign_;
  const KnownFindings& known_;
  FuzzProgress& progress_;
  Way way_;
  FindingKeys printed_, under_way_;
  std::set<ShownFinding> shown_;
  std::set<std::string> kinds_printed_;
  std::map<FindingKey, fuzz::Counterexample> held_back_;
  std::set<std::size_t> dropped_;  // batches with findings that were
  bool has_first_ = false;
};

}  // namespace flowcert::commands
