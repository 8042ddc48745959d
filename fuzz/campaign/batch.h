// One batch of a campaign: its cases, one after the other, each held to the properties, and what came of
// them.
//
// Guarantees: cases, counterexamples and signatures are a function of plan, number of cases and batch, and of the
// cases that are left out; only times are not. A case is fresh (campaign_plan.h), or a mutant (mutation.h) of an
// input that showed a new signature earlier in the batch, or that the plan's corpus has. A disagreement is
// told of as it is, and then shrunk, when the batch meets its kind for the first time, or always if the plan
// wants it; the others of its kind are listed by the numbers of their cases, which a batch of one case makes
// again.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign_plan.h"
#include "fuzz/campaign/counterexample.h"
#include "fuzz/campaign/degeneracy_signature.h"

namespace flowcert::fuzz {

struct RowsTally {
  std::size_t cases = 0;
  double seconds = 0;  // of one job
};

struct Tally {
  std::size_t cases = 0;
  std::size_t left_out = 0;                      // cases that were not tried again: they had ended a process
  std::map<std::string, std::size_t> by_source;  // names of families, and "mutant"
  std::map<std::string, std::size_t> by_mutation;
  std::map<std::size_t, RowsTally> by_rows;
  std::map<std::string, std::size_t> by_property;         // cases held to it
  std::map<std::string, std::set<std::size_t>> failures;  // numbers of cases by "PROPERTY KIND"
  // How often each value of each component of signatures came.
  std::vector<std::map<std::uint8_t, std::size_t>> reached =
      std::vector<std::map<std::uint8_t, std::size_t>>(kSignatureSize);

  void add(const Tally& other);
  // Of all kinds together: a case may fail in several.
  [[nodiscard]] std::size_t failing_cases() const;
};
[[nodiscard]] nlohmann::json json_of(const Tally& tally);
// Throws nlohmann::json::exception.
[[nodiscard]] Tally tally_of(const nlohmann::json& object);

// An input that showed a signature first, in its batch.
struct Discovery {
  DegeneracySignature signature;
  std::size_t number = 0;
  Input input;
};
[[nodiscard]] nlohmann::json json_of(const Discovery& discovery);
[[nodiscard]] Discovery discovery_of(const nlohmann::json& object);

// Who is told, as it happens, and may stop the batch.
class BatchObserver {
 public:
  virtual ~BatchObserver() = default;

  // Before a property is tried: if the process ends here, this is why.
  virtual void tries(std::size_t number, const std::string& source, const std::string& property,
                     const property::Trial& trial) = 0;
  virtual void has_done(std::size_t number, const std::string& source) = 0;
  virtual void found(const Counterexample& counterexample) = 0;
  virtual void discovered(const Discovery& discovery) = 0;
  [[nodiscard]] virtual bool is_stopped() = 0;
};

struct BatchOrder {
  std::size_t batch = 0;
  std::size_t cases = 0;
  std::set<std::size_t> left_out;        // numbers of cases that ended a process before
  std::optional<std::size_t> only = {};  // hold no other case to anything; the batch is not complete then
};

struct BatchResult {
  Tally tally;
  bool is_complete = false;
};

// Properties: those of the plan, or what stands for them.
[[nodiscard]] BatchResult run_batch(const CampaignPlan& plan,
                                    const std::vector<property::Property>& properties,
                                    const BatchOrder& order, BatchObserver& observer);

// The properties that a plan of no other implementation's means: those that it names, each on all cases, or
// all of them, each on its share.
[[nodiscard]] std::vector<property::Property> own_properties(const CampaignPlan& plan);

// Where batches come from, and where what came of them goes: a campaign, or a line to one on another machine.
//
// Guarantees: whoever works on batches needs nothing else of their campaign.
class BatchSource {
 public:
  virtual ~BatchSource() = default;

  [[nodiscard]] virtual const CampaignPlan& plan() const = 0;
  // Nothing: there is no more to do.
  [[nodiscard]] virtual std::optional<BatchOrder> next_batch() = 0;
  // A batch that was not done, to be handed out again.
  virtual void give_back(std::size_t batch) = 0;
  // A case that ended its process and has not been made small, each once; nothing: there is no other.
  [[nodiscard]] virtual std::optional<Counterexample> next_crash() { return std::nullopt; }
  // One line from whoever does a batch (Messages, below).
  virtual void absorb(const std::string& message) = 0;
};

// ---- Messages ----
// What whoever does batches tells the campaign, and is told: lines of text, through a pipe or between ranks.
//
// Guarantees: a line each, without line breaks inside; what is read is equal to what was written.
[[nodiscard]] std::string message_of(const Counterexample& counterexample);
[[nodiscard]] std::string message_of(const Discovery& discovery);
[[nodiscard]] std::string message_of(std::size_t batch, const BatchResult& result);

// Instead of one: the batch cannot be done on this machine, and why.
[[nodiscard]] std::string failure_message(const std::string& why);
[[nodiscard]] std::optional<std::string> failure_in(const std::string& message);

// Whether it is the last one of a batch, and then whether all of the batch was done.
[[nodiscard]] bool ends_batch(const std::string& message);
[[nodiscard]] bool ends_whole_batch(const std::string& message);

[[nodiscard]] std::string to_text(const BatchOrder& order);
// Throws std::invalid_argument.
[[nodiscard]] BatchOrder order_of(const std::string& text);

}  // namespace flowcert::fuzz
