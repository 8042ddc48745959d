// Doubles are written as strings of hexadecimal floats, since JSON has no exact ones.
#include "fuzz/campaign/campaign_plan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "fuzz/campaign/counterexample.h"
#include "fuzz/inputs/large_family.h"
#include "fuzz/properties/drawn_start.h"

namespace flowcert::fuzz {

namespace {

using nlohmann::json;

constexpr int kVersion = 3;
// The version of a plan that judges persistence pairs or ignores reasons. A program of version 3 would not know it.
constexpr int kLaterVersion = 4;
// The version of a plan whose command is asked case after case.
constexpr int kDialogueVersion = 5;
constexpr std::uint64_t kMostWeight = 1'000'000;

void require_family(const std::string& name) {
  static const std::vector<Family> all = named_families();
  if (std::none_of(all.begin(), all.end(), [&](const Family& one) { return one.name == name; })) {
    throw std::invalid_argument("no family is called '" + name + "'");
  }
}

std::uint64_t weight_of(std::string_view word) {
  std::uint64_t weight = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), weight);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size() || weight == 0 || weight > kMostWeight) {
    throw std::invalid_argument("'" + std::string(word) + "' is no weight, a number from 1 to 1000000");
  }
  return weight;
}

void require_sound(const CampaignPlan& plan) {
  for (const WeightedFamily& family : plan.families) {
    require_family(family.name);
    if (family.weight == 0 || family.weight > kMostWeight) throw std::invalid_argument("a weight out of its range");
  }
  for (const Input& input : plan.corpus) {
    if (input.rows.size() > kMostRowsOfTrial) throw std::invalid_argument("a corpus of too many points");
  }
  for (const std::string& name : plan.properties) {
    if (property::property_named(name) == nullptr) {
      throw std::invalid_argument("no property is called '" + name + "'");
    }
  }
  if (plan.fewest_rows > plan.most_rows || plan.most_rows > kMostRowsOfTrial || plan.searched_percent > 100 ||
      plan.batch_cases == 0 || plan.shard.count == 0 || plan.shard.index >= plan.shard.count) {
    throw std::invalid_argument("a number of the plan is out of its range");
  }
}

}  // namespace

std::string to_text(const CampaignPlan& plan) {
  json families = json::array();
  for (const WeightedFamily& family : plan.families) families.push_back({family.name, family.weight});
  json corpus = json::array();
  for (const Input& input : plan.corpus) corpus.push_back(json_of(input));
  const bool is_later = plan.is_dialogue || plan.judges_pairs || !plan.ignored.empty();
  json object{{"format", "flowcert-fuzz"},
              {"version", plan.is_dialogue ? kDialogueVersion
                          : is_later       ? kLaterVersion
                                           : kVersion},
              {"seed", plan.seed},
              {"families", families},
              {"fewest_rows", plan.fewest_rows},
              {"most_rows", plan.most_rows},
              {"searched_percent", plan.searched_percent},
              {"properties", plan.properties},
              {"against", plan.against},
              {"time_limit_seconds", plan.time_limit_seconds},
              {"memory_limit_mebibytes", plan.memory_limit_mebibytes},
              {"batch_cases", plan.batch_cases},
              {"corpus", corpus},
              {"shrinks_all", plan.shrinks_all},
              {"shard", {plan.shard.index, plan.shard.count}}};
  if (is_later) object.update({{"judges_pairs", plan.judges_pairs}, {"ignored", plan.ignored}});
  if (plan.is_dialogue) object["through"] = true;
  return object.dump();
}

CampaignPlan plan_of(const std::string& text) {
  CampaignPlan plan;
  try {
    const json object = json::parse(text);
    plan.is_dialogue = object.at("version") == kDialogueVersion;
    const bool is_later = plan.is_dialogue || object.at("version") == kLaterVersion;
    if (object.at("format") != "flowcert-fuzz" || (!is_later && object.at("version") != kVersion)) {
      throw std::invalid_argument("the plan of another version");
    }
    object.at("seed").get_to(plan.seed);
    for (const json& pair : object.at("families")) {
      plan.families.push_back({pair.at(0).get<std::string>(), pair.at(1).get<std::uint64_t>()});
    }
    object.at("fewest_rows").get_to(plan.fewest_rows);
    object.at("most_rows").get_to(plan.most_rows);
    object.at("searched_percent").get_to(plan.searched_percent);
    object.at("properties").get_to(plan.properties);
    object.at("against").get_to(plan.against);
    object.at("time_limit_seconds").get_to(plan.time_limit_seconds);
    object.at("memory_limit_mebibytes").get_to(plan.memory_limit_mebibytes);
    object.at("batch_cases").get_to(plan.batch_cases);
    for (const json& rows : object.at("corpus")) plan.corpus.push_back(input_of(rows));
    object.at("shrinks_all").get_to(plan.shrinks_all);
    if (is_later) {
      object.at("judges_pairs").get_to(plan.judges_pairs);
      object.at("ignored").get_to(plan.ignored);
    }
    plan.shard = {object.at("shard").at(0).get<std::size_t>(), object.at("shard").at(1).get<std::size_t>()};
  } catch (const json::exception&) {
    throw std::invalid_argument("no plan of a campaign");
  }
  require_sound(plan);
  return plan;
}

std::vector<WeightedFamily> families_of(const std::string& list) {
  std::vector<WeightedFamily> families;
  std::string_view rest = list;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t colon = part.find(':');
    WeightedFamily family{std::string(part.substr(0, colon)), 1};
    require_family(family.name);
    if (colon != std::string_view::npos) family.weight = weight_of(part.substr(colon + 1));
    families.push_back(std::move(family));
  }
  return families;
}

std::size_t cases_of_batch(const CampaignPlan& plan, std::optional<std::size_t> total, std::size_t batch) {
  if (!total) return plan.batch_cases;
  if (batch > *total / plan.batch_cases) return 0;
  return std::min(plan.batch_cases, *total - batch * plan.batch_cases);
}

std::size_t cases_of_shard(const CampaignPlan& plan, std::size_t total) {
  const std::size_t batches = total / plan.batch_cases + (total % plan.batch_cases == 0 ? 0 : 1);
  if (plan.shard.index >= batches) return 0;
  const std::size_t own = (batches - 1 - plan.shard.index) / plan.shard.count + 1;
  const std::size_t last = plan.shard.index + (own - 1) * plan.shard.count;
  return (own - 1) * plan.batch_cases + cases_of_batch(plan, total, last);
}

std::optional<std::size_t> batch_from(const CampaignPlan& plan, std::optional<std::size_t> total, std::size_t batch) {
  const std::size_t ahead = (plan.shard.index + plan.shard.count - batch % plan.shard.count) % plan.shard.count;
  const std::size_t next = batch + ahead;
  return cases_of_batch(plan, total, next) == 0 ? std::nullopt : std::optional(next);
}

// ---- Trial mix ----

namespace {

// How many of a hundred cases have so many rows. Most have 4 to 8: such a case can be understood, and the oracle is
// fast.
constexpr std::array<std::uint64_t, kMostRowsOfTrial + 1> kShareOfRows = {1, 1, 1, 3, 16, 19, 19, 16, 12, 5, 3, 2, 2};
constexpr int kLargestSize = 100;
constexpr int kAttempts = 4;

}  // namespace

TrialMix::TrialMix(const CampaignPlan& plan) : fewest_rows_(plan.fewest_rows), most_rows_(plan.most_rows) {
  std::uint64_t sum = 0;
  for (const Family& family : named_families()) {
    const auto named = std::find_if(plan.families.begin(), plan.families.end(),
                                    [&](const WeightedFamily& one) { return one.name == family.name; });
    const bool is_named = named != plan.families.end();
    if (!is_named && (!plan.families.empty() || is_large(family.name))) continue;
    sum += is_named ? named->weight : 1;
    sources_.push_back({family, family.generate(), sum});
  }
}

const TrialMix::Source& TrialMix::source(std::uint64_t dice) const {
  const std::uint64_t place = dice % sources_.back().weights_before;
  return *std::find_if(sources_.begin(), sources_.end(), [&](const Source& one) { return place < one.weights_before; });
}

std::size_t TrialMix::row_target(std::uint64_t dice) const {
  if (fewest_rows_ >= most_rows_) return fewest_rows_;
  std::uint64_t sum = 0;
  for (std::size_t rows = fewest_rows_; rows <= most_rows_; ++rows) sum += kShareOfRows.at(rows);
  std::uint64_t place = dice % sum;
  std::size_t rows = fewest_rows_;
  while (place >= kShareOfRows.at(rows)) place -= kShareOfRows.at(rows++);
  return rows;
}

FreshTrial TrialMix::draw(std::uint64_t seed) const {
  rc::Random random(seed);
  const Source& from = source(random.next());
  if (is_large(from.family.name)) {
    Input input = from.generator(rc::Random(random.next()), kLargestSize).value();
    return {{std::move(input), draw_start(random.next())}, from.family.name};
  }
  const std::size_t target = row_target(random.next());
  Input input;
  for (int attempt = 0; attempt < kAttempts && (attempt == 0 || input.rows.size() < target); ++attempt) {
    // This size is mostly large enough for the target. A family has more rows at a larger size, but ever fewer more.
    const int size = std::min<int>(kLargestSize, static_cast<int>(random.next() % 40 + 8 * target));
    Input drawn = from.generator(rc::Random(random.next()), size).value();
    if (drawn.rows.size() > input.rows.size()) input = std::move(drawn);
  }
  while (input.rows.size() > target) {
    const auto lost = static_cast<std::ptrdiff_t>(random.next() % input.rows.size());
    input.rows.erase(input.rows.begin() + lost);
  }
  return {{std::move(input), draw_start(random.next())}, from.family.name};
}

property::StartChoice TrialMix::draw_start(std::uint64_t seed) {
  return property::start_choice()(rc::Random(seed), kLargestSize).value();
}

}  // namespace flowcert::fuzz
