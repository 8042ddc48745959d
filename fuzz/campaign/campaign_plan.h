// The plan of a fuzzing campaign. Its cases, and what they are held to, depend on nothing else.
//
// Guarantees: two campaigns of the same plan have the same cases and the same counterexamples, on any machine, with
// any number of jobs, shards and interruptions. A plan that was written and read again is equal to what it was.
//
// A campaign is cut into batches. A batch is a function of the plan and its number: it has a corpus of its
// own, which begins with the plan's and grows with the batch's own cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/input.h"
#include "fuzz/properties/property.h"

namespace flowcert::fuzz {

inline constexpr std::size_t kMostRowsOfTrial = 12;
inline constexpr std::size_t kMostCasesOfCampaign = 1'000'000'000'000;

struct WeightedFamily {
  std::string name;
  std::uint64_t weight = 1;

  friend bool operator==(const WeightedFamily&, const WeightedFamily&) = default;
};

// The part of the campaign's batches that this run does: those with number % count == index.
struct Shard {
  std::size_t index = 0;
  std::size_t count = 1;

  friend bool operator==(const Shard&, const Shard&) = default;
};

struct CampaignPlan {
  std::uint64_t seed = 1;
  std::vector<WeightedFamily> families;  // empty: all of them alike, but for the large one
  std::size_t fewest_rows = 0;
  std::size_t most_rows = kMostRowsOfTrial;
  std::size_t searched_percent = 30;    // so many cases of 100 are mutants
  std::vector<std::string> properties;  // empty: all of them, each on its share of the cases
  // Another implementation's command, and the limits under which it runs; empty: ours alone.
  std::string against;
  bool is_dialogue = false;          // the command is asked case after case, in one process
  bool judges_pairs = false;         // the command writes persistence pairs, not a claim
  std::vector<std::string> ignored;  // what is wrong with its answers for these reasons is not looked at
  double time_limit_seconds = 10;
  std::size_t memory_limit_mebibytes = 4096;
  std::size_t batch_cases = 1000;
  std::vector<Input> corpus;
  // Every failing case is made small, not only the first of a property and kind in each batch.
  bool shrinks_all = false;
  Shard shard;

  friend bool operator==(const CampaignPlan&, const CampaignPlan&) = default;
};

// One line of JSON.
[[nodiscard]] std::string to_text(const CampaignPlan& plan);
// Throws std::invalid_argument, one line, if the text is no plan, or names a family or a property that does not
// exist.
[[nodiscard]] CampaignPlan plan_of(const std::string& text);

// "box:3,shell" as weighted families. Throws std::invalid_argument, one line.
[[nodiscard]] std::vector<WeightedFamily> families_of(const std::string& list);

// The number of cases of a batch, in a campaign of `total` cases or of any number.
[[nodiscard]] std::size_t cases_of_batch(const CampaignPlan& plan, std::optional<std::size_t> total, std::size_t batch);
// All cases of the plan's shard.
[[nodiscard]] std::size_t cases_of_shard(const CampaignPlan& plan, std::size_t total);
// The first batch of the shard that is not before `batch`. Returns nothing beyond the campaign's end.
[[nodiscard]] std::optional<std::size_t> batch_from(const CampaignPlan& plan, std::optional<std::size_t> total,
                                                    std::size_t batch);

// ---- Trial mix ----
// Draws fresh cases. Each is an input of one of the plan's families, of a size from the plan's mix, with the start of
// an orbit in it.
//
// Guarantees: a case is a function of plan and seed. The number of rows lies between the plan's bounds if the family
// allows it. An input that is too large loses rows. An input that is too small is drawn again a few times, and then
// the largest one is taken. The large family has its own sizes, and is drawn only if the plan names it.
struct FreshTrial {
  property::Trial trial;
  std::string family;
};

class TrialMix {
 public:
  explicit TrialMix(const CampaignPlan& plan);

  [[nodiscard]] FreshTrial draw(std::uint64_t seed) const;
  // Where an orbit starts.
  [[nodiscard]] static property::StartChoice draw_start(std::uint64_t seed);

 private:
  struct Source {
    Family family;
    rc::Gen<Input> generator;
    std::uint64_t weights_before = 0;  // of all sources up to this one, itself included
  };

  [[nodiscard]] const Source& source(std::uint64_t dice) const;
  [[nodiscard]] std::size_t row_target(std::uint64_t dice) const;

  std::size_t fewest_rows_;
  std::size_t most_rows_;
  std::vector<Source> sources_;
};

}  // namespace flowcert::fuzz
