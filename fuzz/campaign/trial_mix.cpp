// See trial_mix.h.
#include "fuzz/campaign/trial_mix.h"

#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/inputs/mixed.h"
#include "fuzz/inputs/stable_families.h"

namespace flowcert::fuzz {
namespace {

// How many of a hundred cases have so many rows: most of them 4 to 8, where a case is small enough to be
// understood and the oracle is fast.
constexpr std::array<std::uint64_t, kMostRowsOfTrial + 1> kShareOfRows = {1,  1,  1, 3, 16, 19, 19,
                                                                          16, 12, 5, 3, 2,  2};
constexpr int kLargestSize = 100;
constexpr int kAttempts = 4;

}  // namespace

TrialMix::TrialMix(const CampaignPlan& plan) : fewest_rows_(plan.fewest_rows), most_rows_(plan.most_rows) {
  std::uint64_t sum = 0;
  for (const Family& family : families_and_stable_ones()) {
    const auto named = std::find_if(plan.families.begin(), plan.families.end(),
                                    [&](const WeightedFamily& one) { return one.name == family.name; });
    if (named == plan.families.end() && !plan.families.empty()) continue;
    sum += plan.families.empty() ? 1 : named->weight;
    sources_.push_back({family, family.generate(), sum});
  }
}

const TrialMix::Source& TrialMix::source(std::uint64_t dice) const {
  const std::uint64_t place = dice % sources_.back().weights_before;
  return *std::find_if(sources_.begin(), sources_.end(),
                       [&](const Source& one) { return place < one.weights_before; });
}

std::size_t TrialMix::row_target(std::uint64_t dice) const {
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
  const std::size_t target = row_target(random.next());
  Input input;
  for (int attempt = 0; attempt < kAttempts && (attempt == 0 || input.rows.size() < target); ++attempt) {
    // Large enough for the target, mostly: a family's rows grow with the size, the more slowly the more.
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
