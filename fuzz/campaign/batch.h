// One batch of a campaign. Its cases are tried one after the other, and each is held to the properties.
//
// Guarantees: cases, counterexamples and signatures are a function of the plan, the number of cases, the batch and
// the cases that are left out; only times are not. A case is fresh (campaign_plan.h) or a mutant (mutation.h). The
// parent of a mutant is an input that showed a new signature earlier in the batch, or an input of the plan's corpus.
// The first disagreement of a kind in the batch is reported as it is, and then shrunk; so are all others if the plan
// wants it. Otherwise the others are listed by their case numbers only, and BatchOrder::only makes such a case again.
// What is not small when the batch is stopped is reported as small as it is by then. A case of the large family has no
// signature, so it is no parent, and is held only to properties that take so many rows.
#pragma once

#include <chrono>
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

[[nodiscard]] inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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

// An observer is called with what happens in a batch, as it happens. It may stop the batch.
class BatchObserver {
 public:
  virtual ~BatchObserver() = default;

  // Called before a property is tried. If the process ends then, this trial is the reason.
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
  std::optional<std::size_t> only = {};  // hold this case alone to properties; then the batch is not complete
};

struct BatchResult {
  Tally tally;
  bool is_complete = false;
};

// `properties` are those of the plan, or stand for them.
[[nodiscard]] BatchResult run_batch(const CampaignPlan& plan, const std::vector<property::Property>& properties,
                                    const BatchOrder& order, BatchObserver& observer);

// The properties of a plan that has no foreign command. Properties that the plan names are checked on all cases. If
// it names none, all properties are checked, each on its share of the cases.
[[nodiscard]] std::vector<property::Property> own_properties(const CampaignPlan& plan);

// A source hands out batches and takes their results. It is a campaign, or a line to one on another machine.
//
// Guarantees: whoever works on batches needs nothing else of the campaign.
class BatchSource {
 public:
  virtual ~BatchSource() = default;

  [[nodiscard]] virtual const CampaignPlan& plan() const = 0;
  // Returns nothing if there is no more to do.
  [[nodiscard]] virtual std::optional<BatchOrder> next_batch() = 0;
  // The batch was not done and will be handed out again.
  virtual void give_back(std::size_t batch) = 0;
  // Returns each case that ended its process and is not yet small, once. Returns nothing if there is no other.
  [[nodiscard]] virtual std::optional<Counterexample> next_crash() { return std::nullopt; }
  // One line from whoever does a batch (Messages, below).
  virtual void absorb(const std::string& message) = 0;
};

// ---- Messages ----
// Whoever does batches and the campaign send each other lines of text, through a pipe or between ranks.
//
// Guarantees: a message is one line, without line breaks inside. What is read is equal to what was written.
[[nodiscard]] std::string message_of(const Counterexample& counterexample);
[[nodiscard]] std::string message_of(const Discovery& discovery);
[[nodiscard]] std::string message_of(std::size_t batch, const BatchResult& result);

[[nodiscard]] std::optional<Counterexample> finding_in(const std::string& message);

// This message comes instead of a result. It says why the batch cannot be done on this machine.
[[nodiscard]] std::string failure_message(const std::string& why);
[[nodiscard]] std::optional<std::string> failure_in(const std::string& message);

// Whether a message is the last one of a batch, and whether all of the batch was done then.
[[nodiscard]] bool ends_batch(const std::string& message);
[[nodiscard]] bool ends_whole_batch(const std::string& message);

[[nodiscard]] std::string to_text(const BatchOrder& order);
// Throws std::invalid_argument.
[[nodiscard]] BatchOrder order_of(const std::string& text);

}  // namespace flowcert::fuzz
