#include "fuzz/campaign/batch.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "fuzz/campaign/mutation.h"
#include "fuzz/campaign/shrinking.h"
#include "fuzz/inputs/input.h"
#include "fuzz/inputs/large_family.h"
#include "geometry/mixed_bits.h"

namespace flowcert::fuzz {

namespace {

using nlohmann::json;
using property::Disagreement;
using property::Property;

constexpr std::uint64_t kMostMoves = 3;
constexpr const char* kMutant = "mutant";
// A case mixes its seed with each of these, to get its numbers for different purposes.
enum Salt : std::uint64_t { kSourceSalt = 1, kParentSalt, kMovesSalt, kStartSalt, kShareSalt = 100 };

class Batch {
 public:
  Batch(const CampaignPlan& plan, const std::vector<Property>& properties, const BatchOrder& order,
        BatchObserver& observer)
      : plan_(plan), properties_(properties), order_(order), observer_(observer), mix_(plan), corpus_(plan.corpus) {}

  BatchResult result() {
    const std::size_t first = order_.batch * plan_.batch_cases;
    for (std::size_t number = first; number < first + order_.cases; ++number) {
      if (observer_.is_stopped()) return std::move(result_);
      if (order_.left_out.contains(number) && number != order_.only) {
        ++result_.tally.left_out;
        continue;
      }
      if (order_.only && number > *order_.only) break;
      if (order_.only && number < *order_.only) {
        (void)drawn_case(number);  // it may add a parent for the mutants after it
        result_.tally = {};
      } else {
        run_case(number);
      }
    }
    result_.is_complete = !order_.only && !is_cut_off_;
    return std::move(result_);
  }

 private:
  void run_case(std::size_t number) {
    const auto start = std::chrono::steady_clock::now();
    const std::uint64_t seed = seed_of(number);
    const FreshTrial drawn = drawn_case(number);
    for (std::size_t k = 0; k < properties_.size(); ++k) {
      const bool is_its_share = geometry::mixed_bits(seed ^ (kShareSalt + k)) % properties_[k].one_in == 0;
      if (is_its_share) hold(number, drawn, properties_[k]);
      if (is_cut_off_) return;
    }
    Tally& tally = result_.tally;
    ++tally.cases;
    ++tally.by_source[drawn.family];
    RowsTally& rows = tally.by_rows[drawn.trial.input.rows.size()];
    ++rows.cases;
    rows.seconds += seconds_since(start);
    observer_.has_done(number, drawn.family);
  }

  [[nodiscard]] std::uint64_t seed_of(std::size_t number) const {
    return geometry::mixed_bits(geometry::mixed_bits(plan_.seed) ^ number);
  }

  FreshTrial drawn_case(std::size_t number) {
    FreshTrial drawn = drawn_trial(seed_of(number));
    look_at_signature(number, drawn);
    return drawn;
  }

  FreshTrial drawn_trial(std::uint64_t seed) {
    const bool is_mutant = geometry::mixed_bits(seed ^ kSourceSalt) % 100 < plan_.searched_percent;
    if (!is_mutant || corpus_.empty()) return mix_.draw(seed);
    const Input& parent = corpus_[geometry::mixed_bits(seed ^ kParentSalt) % corpus_.size()];
    Mutant mutant{parent, {}};
    std::uint64_t dice = geometry::mixed_bits(seed ^ kMovesSalt);
    for (std::uint64_t moves = 1 + dice % kMostMoves; moves > 0; --moves) {
      dice = geometry::mixed_bits(dice);
      Mutant next = mutated(mutant.input, dice);
      if (next.input.rows.size() < plan_.fewest_rows || next.input.rows.size() > plan_.most_rows) break;
      mutant = std::move(next);
      ++result_.tally.by_mutation[mutant.by];
    }
    return {{std::move(mutant.input), TrialMix::draw_start(geometry::mixed_bits(seed ^ kStartSalt))}, kMutant};
  }

  void look_at_signature(std::size_t number, const FreshTrial& drawn) {
    const property::Trial& trial = drawn.trial;
    if (is_large(drawn.family)) return;  // mutants are small
    observer_.tries(number, drawn.family, "signature", trial);
    const DegeneracySignature signature = signature_of(trial.input);
    for (std::size_t k = 0; k < kSignatureSize; ++k) ++result_.tally.reached[k][signature.values[k]];
    if (!seen_.insert(signature).second) return;
    corpus_.push_back(trial.input);
    observer_.discovered({signature, number, trial.input});
  }

  void hold(std::size_t number, const FreshTrial& drawn, const Property& property) {
    if (is_large(drawn.family) && drawn.trial.input.rows.size() > property.most_rows) return;
    ++result_.tally.by_property[property.name];
    const auto judge = [&](const property::Trial& trial) {
      observer_.tries(number, drawn.family, property.name, trial);
      return disagreement(property, trial);
    };
    const std::optional<Disagreement> found = judge(drawn.trial);
    if (!found) return;
    Counterexample counterexample{plan_.seed,    number,      drawn.family, drawn.trial.input.rows.size(),
                                  property.name, drawn.trial, *found};
    std::set<std::size_t>& failing = result_.tally.failures[kind_of(counterexample)];
    failing.insert(number);
    if (failing.size() > 1 && !plan_.shrinks_all) return;
    observer_.found(counterexample);
    const auto judge_unless_stopped = [&](const property::Trial& trial) {
      return observer_.is_stopped() ? std::nullopt : judge(trial);
    };
    const bool is_slow = found->kind == property.slow_kind;
    const std::size_t budget = is_slow ? property.slow_shrinking_budget : property.shrinking_budget;
    Shrunk small = shrunk(drawn.trial, *found, judge_unless_stopped, budget);
    // A half-shrunk case depends on the time of the stop, so it is not the last word. The batch is done again.
    is_cut_off_ = observer_.is_stopped();
    counterexample.trial = std::move(small.trial);
    counterexample.disagreement = std::move(small.disagreement);
    counterexample.is_small = !is_cut_off_;
    if (counterexample.is_small && small.is_budget_up) counterexample.most_tried = budget;
    observer_.found(counterexample);
  }

  const CampaignPlan& plan_;
  const std::vector<Property>& properties_;
  const BatchOrder& order_;
  BatchObserver& observer_;
  TrialMix mix_;
  std::vector<Input> corpus_;
  std::set<DegeneracySignature> seen_;
  BatchResult result_;
  bool is_cut_off_ = false;
};

template <typename Map>
void add_counts(Map& sum, const Map& part) {
  for (const auto& [key, count] : part) sum[key] += count;
}

template <typename Map>
json pairs_of(const Map& counts) {
  json pairs = json::array();
  for (const auto& [key, count] : counts) pairs.push_back({key, count});
  return pairs;
}

template <typename Map>
void read_pairs(const json& pairs, Map& counts) {
  for (const json& pair : pairs) counts[pair.at(0).get<typename Map::key_type>()] = pair.at(1).get<std::size_t>();
}

}  // namespace

void Tally::add(const Tally& other) {
  cases += other.cases;
  left_out += other.left_out;
  add_counts(by_source, other.by_source);
  add_counts(by_mutation, other.by_mutation);
  for (const auto& [rows, tally] : other.by_rows) {
    by_rows[rows].cases += tally.cases;
    by_rows[rows].seconds += tally.seconds;
  }
  add_counts(by_property, other.by_property);
  for (const auto& [kind, numbers] : other.failures) failures[kind].insert(numbers.begin(), numbers.end());
  for (std::size_t k = 0; k < kSignatureSize; ++k) add_counts(reached[k], other.reached[k]);
}

json json_of(const Tally& tally) {
  json rows = json::array();
  for (const auto& [count, of] : tally.by_rows) rows.push_back({count, of.cases, of.seconds});
  return {{"cases", tally.cases},
          {"left_out", tally.left_out},
          {"by_source", pairs_of(tally.by_source)},
          {"by_mutation", pairs_of(tally.by_mutation)},
          {"by_rows", rows},
          {"by_property", pairs_of(tally.by_property)},
          {"failures", tally.failures},
          {"reached", tally.reached}};
}

Tally tally_of(const json& object) {
  Tally tally;
  object.at("cases").get_to(tally.cases);
  object.at("left_out").get_to(tally.left_out);
  read_pairs(object.at("by_source"), tally.by_source);
  read_pairs(object.at("by_mutation"), tally.by_mutation);
  for (const json& row : object.at("by_rows")) {
    tally.by_rows[row.at(0).get<std::size_t>()] = {row.at(1).get<std::size_t>(), row.at(2).get<double>()};
  }
  read_pairs(object.at("by_property"), tally.by_property);
  object.at("failures").get_to(tally.failures);
  for (std::size_t k = 0; k < kSignatureSize; ++k) read_pairs(object.at("reached").at(k), tally.reached[k]);
  return tally;
}

json json_of(const Discovery& discovery) {
  return {{"signature", discovery.signature.values}, {"number", discovery.number}, {"rows", json_of(discovery.input)}};
}

Discovery discovery_of(const json& object) {
  return {{object.at("signature").get<std::array<std::uint8_t, kSignatureSize>>()},
          object.at("number").get<std::size_t>(),
          input_of(object.at("rows"))};
}

BatchResult run_batch(const CampaignPlan& plan, const std::vector<Property>& properties, const BatchOrder& order,
                      BatchObserver& observer) {
  return Batch(plan, properties, order, observer).result();
}

std::vector<Property> own_properties(const CampaignPlan& plan) {
  std::vector<Property> named;
  if (plan.properties.empty()) {
    std::ranges::copy_if(property::properties(), std::back_inserter(named),
                         [](const Property& p) { return p.one_in > 0; });
    return named;
  }
  for (const std::string& name : plan.properties) {
    named.push_back(*property::property_named(name));
    named.back().one_in = 1;
  }
  return named;
}

// ---- Messages ----
// What Campaign::absorb reads has one of the keys "finding", "discovery" and "batch".
using nlohmann::json;

// The message of an exception need not be UTF-8.
std::string message_of(const Counterexample& counterexample) {
  return json{{"finding", json_of(counterexample)}}.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string message_of(const Discovery& discovery) { return json{{"discovery", json_of(discovery)}}.dump(); }

std::string message_of(std::size_t batch, const BatchResult& result) {
  return json{{"batch", batch}, {"complete", result.is_complete}, {"tally", json_of(result.tally)}}.dump();
}

std::string failure_message(const std::string& why) {
  return json{{"failure", why}}.dump(-1, ' ', true, json::error_handler_t::replace);
}
std::optional<Counterexample> finding_in(const std::string& message) {
  if (!message.starts_with(R"({"finding":)")) return std::nullopt;
  return counterexample_of(json::parse(message).at("finding"));
}
std::optional<std::string> failure_in(const std::string& message) {
  if (!message.starts_with(R"({"failure":)")) return std::nullopt;
  return json::parse(message).at("failure").get<std::string>();
}

// Keys are written in alphabetical order, so "batch" comes first.
bool ends_batch(const std::string& message) { return message.starts_with(R"({"batch":)"); }
bool ends_whole_batch(const std::string& message) {
  return ends_batch(message) && message.find(R"("complete":true)") != std::string::npos;
}

std::string to_text(const BatchOrder& order) {
  std::string text = std::to_string(order.batch) + ' ' + std::to_string(order.cases) + ' ' +
                     (order.only ? std::to_string(*order.only) : "all");
  for (const std::size_t number : order.left_out) text += ' ' + std::to_string(number);
  return text;
}

BatchOrder order_of(const std::string& text) {
  std::istringstream words(text);
  BatchOrder order;
  std::string only;
  if (!(words >> order.batch >> order.cases >> only)) throw std::invalid_argument("no order for a batch");
  if (only != "all") order.only = std::stoull(only);
  for (std::size_t number = 0; words >> number;) order.left_out.insert(number);
  return order;
}

}  // namespace flowcert::fuzz
